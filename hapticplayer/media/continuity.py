"""Notices pictures that a damaged file has lost without a word from the decoder."""

from typing import Any

from av.packet import Packet
from av.stream import Stream
from av.video.frame import VideoFrame

# Of these every packet becomes one picture with its time; VP8 and VP9 have hidden ones.
_ONE_TO_ONE = frozenset({"h264", "hevc"})
_EVEN_STEPS = 8  # so many equal steps at the beginning, and the rate is constant
_EVEN = 0.1
_LOST_AT_END = 1.6  # pictures


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
        self._is_one_to_one = stream.codec_context.name in _ONE_TO_ONE
        self._end = 0
        if stream.frames > 0 and stream.duration is not None:
            self._end = (stream.start_time or 0) + stream.duration
        self._step = 0
        self._even_steps = 0
        self._is_even = True
        self.restart()

    def restart(self) -> None:
        """Go on after a seek."""
        self._sent: set[int] = set()
        self._last: int | None = None

    def send(self, packet: "Packet[Any]") -> None:
        """Note a packet that was given to the decoder."""
        if self._is_one_to_one and packet.pts is not None and not packet.is_discard:
            self._sent.add(packet.pts)

    def receive(self, frame: VideoFrame) -> None:
        """Note a picture."""
        pts, last = frame.pts, self._last
        if pts is None:
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
        if self._last is not None and self._step > 0:
            left = self._end - self._last
            self.missing += left > (1.0 + _LOST_AT_END) * self._step
        self._last = None

    def _is_longer(self, step: int) -> bool:
        """Whether this step is longer than all before, which were even."""
        if not self._step or abs(step - self._step) <= max(1.0, _EVEN * self._step):
            self._step = self._step or step
            self._even_steps += self._even_steps < _EVEN_STEPS
            return False
        self._is_even = self._is_even and self._even_steps == _EVEN_STEPS
        return self._is_even and step > self._step
