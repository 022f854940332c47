"""What the packets of a stream say: which frame a seek wants, and which frames are lost."""

import itertools
from collections import deque
from collections.abc import Iterator
from statistics import median
from typing import TYPE_CHECKING, Any

from av.packet import Packet
from av.stream import Stream
from av.video.frame import VideoFrame

from hapticplayer.model.limits import MAX_AHEAD_BYTES, MAX_AHEAD_PACKETS

ONE_TO_ONE = frozenset({"h264", "hevc"})
"""Every packet becomes one frame with its time; VP8 and VP9 have hidden frames."""

MARKED = frozenset({"h264"})
"""Codecs that mark frames without references; in H.265 within one temporal layer only."""

_FIRST_STEPS = 8  # what they are like, the rate is taken to be
_EVEN = 0.1
_LONGER = 1.5
_LOST_AT_END = 2.6  # steps between the beginning of the last frame and the end
_LOST_EARLY = 8  # the same where too few frames came to know the rate

if TYPE_CHECKING:
    AnyPacket = Packet[Any]
else:  # it takes no parameter at run time
    AnyPacket = Packet


class Lookahead:
    """Packets read ahead of a seek, from a key frame to the wanted frame.

    It is known then which of them holds the wanted frame (`wanted` is its time stamp,
    None where the packets do not tell), and frames before it that no other frame refers
    to need not be decoded. What is shown stays the same to the bit: H.264 marks such
    frames (`nal_ref_idc` is 0, ITU-T H.264 7.4.1).
    """

    def __init__(self, *, is_marked: bool) -> None:
        self.wanted: int | None = None
        self._read: deque[AnyPacket] = deque()
        self._is_marked = is_marked
        self._needed_from: int | None = None

    def read(self, packets: Iterator[AnyPacket], until: int) -> None:
        """Read from a key frame until nothing that follows is shown by `until`.

        Whatever the reading raises passes through; `pop` has what was read.
        """
        if not self._read_past(packets, until):
            return
        pts = {p.pts for p in self._read if not p.is_discard and p.pts is not None}
        covering = sorted(p for p in pts if p <= until)
        self.wanted = covering[-1] if covering else None
        if self._is_marked and len(covering) > 1:
            # one more: the two fields of a frame may come in packets of their own
            self._needed_from = covering[-2]

    def _read_past(self, packets: Iterator[AnyPacket], until: int) -> bool:
        """Read on; False where the times do not allow a conclusion."""
        last_dts, size_bytes = None, 0
        for packet in itertools.islice(packets, MAX_AHEAD_PACKETS):
            self._read.append(packet)
            pts, dts = packet.pts, packet.dts
            size_bytes += packet.size
            if packet.size == 0 and dts is None:
                return True  # the end of the file
            if pts is None or size_bytes > MAX_AHEAD_BYTES:
                return False
            if dts is None and last_dts is None:
                continue  # FFmpeg knows it only from the third in Matroska
            if dts is None or pts < dts or (last_dts is not None and dts <= last_dts):
                return False
            if dts > until:
                return True
            last_dts = dts
        return False

    def pop(self) -> AnyPacket | None:
        return self._read.popleft() if self._read else None

    def is_skipped(self, pts: int | None) -> bool:
        """Whether a frame lies before the wanted one and nothing needs it."""
        needed = self._needed_from
        return needed is not None and pts is not None and pts < needed


class Continuity:
    """Counts what is missing, from the packets read and the frames that came.

    Three signs: a packet was read and later ones have become frames; frames came at
    even steps and then one step is longer; the last comes long before the end that the
    index of the file (MP4, MOV) gives. `missing` counts frames, or rows of them, so
    far.
    """

    def __init__(self, stream: Stream) -> None:
        self.missing = 0
        self._is_one_to_one = stream.codec_context.name in ONE_TO_ONE
        self._is_ordered = True
        self._end = 0
        self._promised, self._length = stream.frames, stream.duration or 0
        if stream.frames > 0 and stream.duration is not None:
            self._end = (stream.start_time or 0) + stream.duration
        self._step = 0.0  # 0 where steps are uneven, or not known yet
        self._first: list[int] = []
        self.restart()

    def restart(self) -> None:
        """Go on after a seek."""
        self._sent: set[int] = set()
        self._last: int | None = None

    def send(self, packet: AnyPacket) -> None:
        if self._is_one_to_one and packet.pts is not None and not packet.is_discard:
            self._sent.add(packet.pts)

    def receive(self, frame: VideoFrame) -> None:
        """Note a frame."""
        pts, last = frame.pts, self._last
        if pts is None or not self._is_ordered:
            return
        if last is not None and pts <= last:  # an AVI with B frames has no such times
            self._is_ordered = False
            self.missing = 0
            return
        self._last = pts
        if last is None:  # before the first frame of a seek
            self._sent = {sent for sent in self._sent if sent > pts}
            return
        lost = {sent for sent in self._sent if sent < pts}
        self._sent -= lost | {pts}
        self.missing += len(lost) or self._is_longer(pts - last)

    def end(self) -> None:
        """Note that nothing more comes."""
        if self._last is None or not self._is_ordered:
            return
        left = self._end - self._last
        if self._step:
            self.missing += left > _LOST_AT_END * self._step
        elif self._promised > 1 and len(self._first) < _FIRST_STEPS:
            usual = median(self._first or [self._length / self._promised])
            self.missing += left > _LOST_EARLY * usual
        self._last = None

    def _is_longer(self, step: int) -> bool:
        """Whether something is missing in this step, or in one of the first ones."""
        if len(self._first) == _FIRST_STEPS:
            return self._step > 0.0 and step > _LONGER * self._step
        self._first.append(step)
        if len(self._first) < _FIRST_STEPS:
            return False
        usual = median(self._first)
        odd = [s for s in self._first if abs(s - usual) > max(1.0, _EVEN * usual)]
        counts = [s / usual for s in odd]
        is_hole = [c > _LONGER and abs(c - round(c)) < _EVEN for c in counts]
        if len(odd) <= 1 and all(is_hole):
            self._step = usual
        return self._step > 0.0 and bool(odd)
