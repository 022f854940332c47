"""Notices pictures that a damaged file has lost without a word from the decoder."""

from statistics import median

from av.stream import Stream
from av.video.frame import VideoFrame

from hapticplayer.media.approach import ONE_TO_ONE, AnyPacket

_FIRST_STEPS = 8  # what they are like, the rate is taken to be
_EVEN = 0.1
_LONGER = 1.5
_LOST_AT_END = 2.6  # steps between the beginning of the last picture and the end
_LOST_EARLY = 8  # the same where too few pictures came to know the rate


class Continuity:
    """Counts what is missing, from the packets read and the pictures that came.

    Three signs: a packet was read and later ones have become pictures; pictures came at
    even steps and then one step is longer; the last comes long before the end that the
    index of the file (MP4, MOV) gives.

    Args:
        stream: of the pictures.

    Attributes:
        missing: pictures, or rows of them, so far.
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
        """Note a packet that was given to the decoder."""
        if self._is_one_to_one and packet.pts is not None and not packet.is_discard:
            self._sent.add(packet.pts)

    def receive(self, frame: VideoFrame) -> None:
        """Note a picture."""
        pts, last = frame.pts, self._last
        if pts is None or not self._is_ordered:
            return
        if last is not None and pts <= last:  # an AVI with B frames has no such times
            self._is_ordered = False
            self.missing = 0
            return
        self._last = pts
        if last is None:  # what comes before the first picture, nobody asked for
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
