"""Sound at another speed with the pitch it had, by FFmpeg's `atempo` (WSOLA)."""

import math
from fractions import Fraction

import numpy as np
from av.audio.frame import AudioFrame
from av.filter import Graph
from av.filter.context import FilterContext
from numpy.typing import NDArray

from hapticplayer.media.audio import LAYOUTS, AudioBlock

_GAP_S = 0.005
"""A block farther than this from the end of the last one begins a new run."""

_FASTEST_STAGE = 2.0
"""Above, `atempo` leaves samples out instead of blending them, so two are chained."""


class TempoFilter:
    """Takes blocks of sound, returns blocks that last 1/speed as long (0.5 to 4).

    The time of a returned block is the media time of its first sample; the next sample
    lies `speed / rate_hz` later. Onsets come within 3 ms of the time that this gives
    them at the median, single ones up to 25 ms before or after it.
    """

    def __init__(self, speed: float, rate_hz: int) -> None:
        self.is_over = False
        self._speed, self._rate_hz = speed, rate_hz
        self._run: _TempoGraph | None = None
        self._next_s = 0.0  # media time that follows what was taken
        self._out_s = 0.0  # media time of the next sample that is returned

    def push(self, block: AudioBlock | None) -> list[AudioBlock]:
        """The finished samples; None says that the sound has ended."""
        self.is_over = block is None
        made: list[AudioBlock] = []
        if block is None or abs(block.media_s - self._next_s) > _GAP_S:
            made = self._finish()
        if block is None:
            return made
        if self._run is None:
            self._run = _TempoGraph(self._speed, self._rate_hz, block.samples.shape[1])
            self._out_s = block.media_s + self._run.delay_s
        self._next_s = block.media_s + len(block.samples) / self._rate_hz
        return made + self._timed(self._run.filtered(block.samples))

    def _finish(self) -> list[AudioBlock]:
        run, self._run = self._run, None
        return self._timed(run.filtered(None)) if run else []

    def _timed(self, pieces: list[NDArray[np.float32]]) -> list[AudioBlock]:
        made = []
        for samples in pieces:
            made.append(AudioBlock(self._out_s, samples))
            self._out_s += len(samples) / self._rate_hz * self._speed
        return made


class _TempoGraph:
    """A filter graph for sound without a gap.

    `delay_s` is the media time of its first output after that of its first input: each
    stage begins with the middle of its first window (libavfilter/af_atempo.c).
    """

    def __init__(self, speed: float, rate_hz: int, channels: int) -> None:
        stages = 1 if speed <= _FASTEST_STAGE else 2
        tempo = speed ** (1.0 / stages)
        half_window = (1 << math.ceil(math.log2(rate_hz // 24))) // 2
        self.delay_s = half_window / rate_hz * sum(tempo**n for n in range(stages))
        self._rate_hz, self._channels = rate_hz, channels
        self._layout = LAYOUTS[channels]
        graph = Graph()
        source = graph.add_abuffer(
            sample_rate=rate_hz,
            format="flt",
            layout=self._layout,
            time_base=Fraction(1, rate_hz),
        )
        filters = [graph.add("atempo", f"{tempo:.9f}") for _ in range(stages)]
        sink = graph.add("abuffersink")
        graph.link_nodes(source, *filters, sink).configure()
        self._graph = graph  # PyAV's filters do not keep it
        self._source, self._sink = source, sink

    def filtered(
        self, samples: NDArray[np.float32] | None
    ) -> list[NDArray[np.float32]]:
        """The finished samples, (n, channels) each; None ends the sound."""
        self._source.push(None if samples is None else self._frame(samples))
        ready = []
        while (frame := _pulled(self._sink)) is not None:
            flat = frame.to_ndarray().astype(np.float32, copy=False)
            ready.append(flat.reshape(-1, self._channels))
        return ready

    def _frame(self, samples: NDArray[np.float32]) -> AudioFrame:
        flat = samples.reshape(1, -1)
        frame = AudioFrame.from_ndarray(flat, format="flt", layout=self._layout)
        frame.sample_rate = self._rate_hz
        return frame


def _pulled(sink: FilterContext) -> AudioFrame | None:
    try:
        frame = sink.pull()
    except (BlockingIOError, EOFError):
        return None
    assert isinstance(frame, AudioFrame)
    return frame
