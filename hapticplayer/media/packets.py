"""What the packets of a stream say: which frame a seek wants, and which frames are lost."""

import itertools
import math
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

_STEPS = 8  # what came before a hole
_LONGER = 1.5
_OVERHEAD_BYTES = 32  # of a container, for each packet
_SHARE = 0.5  # of a packet's size, that lost ones have at least
_LOST_AT_END = (
    1.6  # of the longest step, between the end of the last frame and that of the track
)

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

    A packet was read and later ones have become frames; or the container tells: the last
    frame ends long before the end of the index (MP4, MOV), or in Matroska a long step
    leads over bytes that nobody read, as where a cluster is damaged. A frame rate that changes is no damage. `missing` counts frames,
    or rows of them, so far.
    """

    def __init__(self, stream: Stream) -> None:
        self.missing = 0
        self._is_one_to_one = stream.codec_context.name in ONE_TO_ONE
        self._is_ordered = True
        self._end = math.inf
        self._usual = _steps_of(stream)
        is_matroska = "matroska" in stream.container.format.name
        self._unread = _UnreadBytes() if is_matroska else None
        if stream.frames and stream.duration is not None:
            self._end = (stream.start_time or 0) + stream.duration
        self.restart()
        is_mp4 = "mp4" in stream.container.format.name and stream.frames > 0
        self._left = len(stream.index_entries) if is_mp4 else 0

    def restart(self) -> None:
        """Go on after a seek."""
        self._left = 0  # packets to come, of a clip that is read as a whole
        self._sent: set[int] = set()
        self._last: int | None = None
        self._last_end = 0
        self._steps: deque[int] = deque(maxlen=_STEPS)
        if self._unread:
            self._unread.restart()

    def send(self, packet: AnyPacket) -> None:
        self._left -= packet.size > 0
        if packet.pts is None or packet.is_discard:
            return
        if self._is_one_to_one:
            self._sent.add(packet.pts)
        if self._unread:
            self._unread.note(packet, packet.pts)

    def receive(self, frame: VideoFrame) -> None:
        pts, last = frame.pts, self._last
        if pts is None or not self._is_ordered:
            return
        if last is not None and pts <= last:  # an AVI with B frames has no such times
            self._is_ordered = False
            self.missing = 0
            return
        self._last, self._last_end = pts, pts + (frame.duration or 0)
        if last is None:  # before the first frame of a seek
            self._sent = {sent for sent in self._sent if sent > pts}
            return
        lost = {sent for sent in self._sent if sent < pts}
        self._sent -= lost | {pts}
        self.missing += len(lost) or self._is_hole(last, pts)
        self._steps.append(pts - last)

    def _is_hole(self, last: int, pts: int) -> bool:
        """Whether a long step leads over bytes that nobody read."""
        usual = median(self._steps or [self._usual])
        steps = (pts - last) / usual if usual else 0.0
        if self._unread is None or steps < _LONGER:
            return False
        around = _STEPS * usual
        return self._unread.are_too_many(last - around, pts + around, steps)

    def end(self) -> None:
        """Note that nothing more comes."""
        if self._last is not None and self._is_ordered:
            longest = max([self._usual, *self._steps])
            left = self._end - self._last_end
            is_early = math.inf > left > _LOST_AT_END * longest
            self.missing += max(self._left, is_early)
        self._last = None


def _steps_of(stream: Stream) -> float:
    """The mean step of a stream's frames as it declares it, in ticks; 0 if unknown."""
    if stream.frames and stream.duration is not None:
        return stream.duration / stream.frames
    rate = getattr(stream, "average_rate", None)
    return float(1 / (rate * stream.time_base)) if rate and stream.time_base else 0.0


class _UnreadBytes:
    """Bytes of a file between the packets of a stream: of other streams, or damaged."""

    def __init__(self) -> None:
        self._most = _OVERHEAD_BYTES
        self._sizes: deque[int] = deque(maxlen=_STEPS)
        self.restart()

    def restart(self) -> None:
        self._read_to: int | None = None
        self._before: deque[tuple[int, float]] = deque(maxlen=2 * _STEPS)

    def note(self, packet: AnyPacket, pts: int) -> None:
        """Note how many steps of other streams would explain what lies before."""
        if packet.pos is None or packet.pos < 0:
            return
        if self._read_to is not None:
            unread = packet.pos - self._read_to
            more = unread - _SHARE * median(self._sizes)
            self._before.append((pts, more / self._most))
            if more <= self._most:
                self._most = max(self._most, unread)
        self._sizes.append(packet.size)
        self._read_to = packet.pos + packet.size

    def are_too_many(self, begin: float, end: float, steps: float) -> bool:
        """Whether that many steps of other streams do not explain what lies there."""
        return any(
            begin <= pts <= end and explained > _LONGER * steps
            for pts, explained in self._before
        )
