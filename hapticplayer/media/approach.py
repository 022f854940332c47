"""The way from a key frame to the picture that is wanted, without what nobody shows.

The packets of the way are read before any is decoded. Then it is known which of them
holds the wanted picture, and pictures before it that no other picture is made from are
not decoded. What is shown stays the same to the bit: H.264 marks such pictures
(`nal_ref_idc` is 0, ITU-T H.264 7.4.1).
"""

import itertools
from collections import deque
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from av.packet import Packet

from hapticplayer.media.limits import MAX_AHEAD_BYTES, MAX_AHEAD_PACKETS

ONE_TO_ONE = frozenset({"h264", "hevc"})
"""Of these every packet becomes one picture with its time; VP8 and VP9 have hidden ones."""

IS_MARKED = frozenset({"h264"})
"""In H.265 the marks hold within one temporal layer only."""

if TYPE_CHECKING:
    AnyPacket = Packet[Any]
else:  # it takes no parameter at run time
    AnyPacket = Packet


class Approach:
    """Packets that were read ahead.

    Args:
        is_marked: whether the codec marks what no other picture is made from.

    Attributes:
        wanted: time stamp of the picture that covers the position; None where the
            packets do not tell.
    """

    def __init__(self, *, is_marked: bool) -> None:
        self.wanted: int | None = None
        self._read: deque[AnyPacket] = deque()
        self._is_marked = is_marked
        self._needed_from: int | None = None

    def look(self, packets: Iterator[AnyPacket], until: int) -> None:
        """Read until nothing that follows can be shown at `until` or before.

        Whatever the reading raises passes through; `pop` has what was read.

        Args:
            packets: from a key frame on.
            until: in the stream's time base.
        """
        if not self._read_past(packets, until):
            return
        pts = {p.pts for p in self._read if not p.is_discard and p.pts is not None}
        covering = sorted(p for p in pts if p <= until)
        self.wanted = covering[-1] if covering else None
        if self._is_marked and len(covering) > 1:
            # one more: the two fields of a picture may come in packets of their own
            self._needed_from = covering[-2]

    def _read_past(self, packets: Iterator[AnyPacket], until: int) -> bool:
        """Read on; False where the times do not allow a conclusion."""
        last_dts, size_bytes = None, 0
        for packet in itertools.islice(packets, MAX_AHEAD_PACKETS):
            self._read.append(packet)
            pts, dts = packet.pts, packet.dts
            if packet.size == 0 and dts is None:
                return True  # the end of the file
            if pts is None or dts is None or pts < dts:
                return False
            if last_dts is not None and dts <= last_dts:
                return False
            if dts > until:
                return True
            last_dts, size_bytes = dts, size_bytes + packet.size
            if size_bytes > MAX_AHEAD_BYTES:
                break
        return False

    def pop(self) -> AnyPacket | None:
        """Return the next packet that was read ahead."""
        return self._read.popleft() if self._read else None

    def is_passed(self, pts: int | None) -> bool:
        """Whether a picture is shown before the wanted one, if it is shown at all."""
        needed = self._needed_from
        return needed is not None and pts is not None and pts < needed
