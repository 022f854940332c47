"""Sound at another speed with the pitch it had (FFmpeg's `atempo`)."""

from typing import Any, cast

import numpy as np
from av.audio.frame import AudioFrame
from av.error import FFmpegError
from av.filter import Graph
from numpy.typing import NDArray

from hapticplayer.media.audio import AudioBlock

_LAYOUTS = {1: "mono", 2: "stereo"}
_GAP_S = 0.005
"""A block farther than this from the end of the last one begins a new run."""


class AudioStretcher:
    """Takes blocks of sound, returns blocks that last 1/speed as long.

    The time of a returned block is the media time of its first sample; the next
    sample lies `speed / rate_hz` later.

    Args:
        speed: 0.5 to 4; what is left of one second of media is 1/speed seconds.
        rate_hz: of the blocks.
        channels: 1 or 2.
    """

    def __init__(self, speed: float, rate_hz: int, channels: int) -> None:
        self.is_over = False
        self._speed = speed
        self._rate_hz = rate_hz
        self._channels = channels
        self._graph: Graph | None = None
        self._next_s = 0.0  # media time that follows what was taken
        self._out_s = 0.0  # media time of the next sample that is returned

    def push(self, block: AudioBlock | None) -> list[AudioBlock]:
        """Return what has become ready; None says that the sound has ended."""
        if block is None:
            self.is_over = True
            return self._flush()
        made: list[AudioBlock] = []
        if self._graph is None or abs(block.media_s - self._next_s) > _GAP_S:
            made = self._flush()
            self._begin(block.media_s)
        self._next_s = block.media_s + len(block.samples) / self._rate_hz
        frame = AudioFrame.from_ndarray(
            np.ascontiguousarray(block.samples.reshape(1, -1)),
            format="flt",
            layout=_LAYOUTS[self._channels],
        )
        frame.sample_rate = self._rate_hz
        assert self._graph is not None
        self._graph.push(frame)
        return made + self._pull()

    def _begin(self, media_s: float) -> None:
        layout = _LAYOUTS[self._channels]
        graph = Graph()
        source = graph.add_abuffer(
            sample_rate=self._rate_hz, format="flt", layout=layout
        )
        tempo = graph.add("atempo", f"{self._speed:.6f}")
        source.link_to(tempo)
        tempo.link_to(graph.add("abuffersink"))
        graph.configure()
        self._graph, self._out_s = graph, media_s

    def _flush(self) -> list[AudioBlock]:
        if self._graph is None:
            return []
        self._graph.push(None)
        made = self._pull()
        self._graph = None
        return made

    def _pull(self) -> list[AudioBlock]:
        assert self._graph is not None
        made: list[AudioBlock] = []
        while True:
            try:
                frame = cast("AudioFrame", self._graph.pull())
            except (BlockingIOError, EOFError, FFmpegError):
                return made
            samples = self._samples(frame)
            made.append(AudioBlock(self._out_s, samples))
            self._out_s += len(samples) / self._rate_hz * self._speed

    def _samples(self, frame: AudioFrame) -> NDArray[np.float32]:
        plane = cast("Any", frame.planes[0])
        count = frame.samples * self._channels
        flat = np.frombuffer(plane, np.float32, count)
        return flat.reshape(frame.samples, self._channels).copy()
