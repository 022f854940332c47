"""Writes what a live source measures into `imu.csv`, row by row."""

import os
from collections import deque
from pathlib import Path

import numpy as np

from hapticplayer.capture.live.source import (
    LiveSource,
    OpenedSource,
    Samples,
)
from hapticplayer.capture.live.source_clock import SourceClock
from hapticplayer.capture.mounting import AS_RECORDED
from hapticplayer.capture.recorded import COLUMNS, COUNT, SOURCE, SourceClockLine
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.model.arrays import Floats

SHOWN_S = 10.0
"""That a window can show."""

_DIGITS = 9
_FORMAT = ",".join([f"%.{_DIGITS}f", *["%.9g"] * (len(COLUMNS) - 2), "%.6f"]) + "\n"
_MOST_SHOWN = 200  # batches
_BATCH_S = 0.1


class ImuFile:
    """A source, its log and its clock.

    Times in the file begin at the first stamp; the last column is the arrival in media
    time. Samples are turned into frame A by the axes that the source declares. Where the
    source's clock begins anew, times go on by the arrivals, with another line to media time.

    Args:
        path: of the new file.
        source: an open one.
        zero_s: monotonic time of media time 0.
    """

    def __init__(self, path: Path, source: LiveSource, zero_s: float) -> None:
        self._source, self._zero_s = source, zero_s
        self._axes = AS_RECORDED
        if isinstance(source, OpenedSource):
            self._axes = source.declares.axes
        self._stretches: list[tuple[float, SourceClock]] = []
        self._lost: HapticPlayerError | None = None
        self._file = path.open("xb")
        self._file.write((",".join(COLUMNS) + "\n").encode())
        self._origin_s: float | None = None
        self._last_s = self._last_arrival_s = 0.0
        self._shown: deque[Floats] = deque(maxlen=_MOST_SHOWN)

    def read(self, clock: Clock) -> tuple[Floats, Floats]:
        """Write what comes in a tenth of a second; media times (n,), as known now, and own.

        Each read stamps arrivals; the rest is done for many at once, which costs less. What
        came before a source was lost is written first.
        """
        if self._lost is not None:
            lost, self._lost = self._lost, None
            raise lost
        parts, until_s = [], clock.now_s() + _BATCH_S
        try:
            while (left_s := until_s - clock.now_s()) > 0.0:
                parts.append(self._source.read(left_s))
        except HapticPlayerError as problem:  # also of a pipe that ends
            self._lost = problem
        return self._take([part for part in parts if len(part.stamp_s)])

    @property
    def stamped_by(self) -> str:
        return SOURCE if getattr(self._source, "is_stamped", True) else COUNT

    @property
    def stretches(self) -> int:
        """How many clocks it has had so far."""
        return len(self._stretches)

    def begin_anew(self) -> None:
        """Take what comes next by another clock."""
        self._origin_s = None

    def _begin_s(self, arrival_s: float) -> float:
        """Where a stretch begins in the file, the first one at 0."""
        if not self._stretches:
            return 0.0
        return self._last_s + max(_BATCH_S, arrival_s - self._last_arrival_s)

    def _new_clock(self) -> SourceClock:
        source = self._source
        return source.new_clock() if isinstance(source, OpenedSource) else SourceClock()

    def _take(self, parts: list[Samples]) -> tuple[Floats, Floats]:
        if not parts:
            return np.empty(0), np.empty(0)
        joined = Samples(*map(np.concatenate, zip(*parts, strict=True)))
        samples = joined.in_frame_a(self._axes)
        arrival_s = samples.arrival_s - self._zero_s
        if is_new := self._origin_s is None:
            begin_s = self._begin_s(float(arrival_s[0]))
            self._origin_s = float(samples.stamp_s[0]) - begin_s
        # as written, for what compares rows with the beginning of a stretch
        time_s = np.round(samples.stamp_s - self._origin_s, _DIGITS)
        clock = self._new_clock() if is_new else self._stretches[-1][1]
        clock.add(time_s, arrival_s)
        if is_new:  # with its first pairs: others describe the stretches meanwhile
            self._stretches.append((float(time_s[0]), clock))
        self._last_s, self._last_arrival_s = float(time_s[-1]), float(arrival_s[-1])
        self._write(time_s, samples, arrival_s)
        media_s = np.asarray(clock.host_s(time_s))
        self._show(media_s, samples)
        return media_s, time_s

    def _write(self, time_s: Floats, samples: Samples, arrival_s: Floats) -> None:
        rows = np.column_stack(
            [time_s, samples.accel_mps2, samples.rate_radps, arrival_s]
        )
        text = "".join(_FORMAT % tuple(row) for row in rows.tolist())
        self._file.write(text.replace("nan", "").encode())
        self._file.flush()  # it outlives this process, whatever ends that

    def _show(self, media_s: Floats, samples: Samples) -> None:
        self._shown.append(
            np.column_stack([media_s, samples.accel_mps2, samples.rate_radps])
        )
        while self._shown[0][-1, 0] < media_s[-1] - SHOWN_S:
            self._shown.popleft()

    def shown(self) -> Floats:
        """Media time, acceleration and rate of the last seconds, (n, 7)."""
        parts = list(self._shown)
        return np.concatenate(parts) if parts else np.empty((0, 7))

    def lines(self) -> list[SourceClockLine]:
        """From times in the file to media time, as far as it is known, of each stretch."""
        return [SourceClockLine.of(clock, at_s) for at_s, clock in self._stretches]

    def sync(self) -> None:
        """Put it on disk."""
        os.fdatasync(self._file.fileno())

    def close(self) -> None:
        self._source.close()
        self._file.close()
