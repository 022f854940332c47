"""The line between the clock of the frames and that of the gyro, and its sigmas."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import uniform_filter1d

from hapticplayer.extras.frames.rotation_match import (
    QUIET_RADPS,
    Gyro,
    RotationFit,
    Watched,
)
from hapticplayer.model import ClockMap
from hapticplayer.model.arrays import Floats

WINDOW_S = 4.0
DRIFT_PRIOR = 60e-6
_WINDOW_FLOOR_S = 0.0015  # what a window is wrong by beyond its noise
_LEAST_KNOWN_S = 0.02  # a window of a camera that does not turn holds noise only
_OUTLIER = 12.0  # squares of a sigma at which weights fall to a quarter
_CORRELATED = 1.5  # errors of neighbouring intervals are not independent
_FEWEST_WINDOWS = 3  # that show a drift
_ROUNDS = 6
_MOST_STEP_S = 0.02


class Line(NamedTuple):
    """Log time minus media time over the frames: shift + drift (t - middle).

    Attributes:
        shift_s: at the middle.
        drift: change of the shift per second.
        middle_s: media time of the middle.
        shift_sigma_s: SD of the shift.
        drift_sigma: SD of the drift.
        window_at_s: (W,) media time of the middle of each window.
        window_sigma_s: (W,) SD of the shift of each window.
        window_error_s: (W,) what each window leaves of the line.
        row: mean row of the frames that decides, -0.5 to 0.5.
        read_out_s: from the first row to the last one, as the frames tell.
        read_out_sigma_s: its SD.
        second_axis: correlation of frames and gyro about the axis with the second-most
            rotation.
    """

    shift_s: float
    drift: float
    middle_s: float
    shift_sigma_s: float
    drift_sigma: float
    window_at_s: Floats
    window_sigma_s: Floats
    window_error_s: Floats
    row: float
    read_out_s: float
    read_out_sigma_s: float
    second_axis: float

    def at(self, media_s: Floats) -> Floats:
        return np.asarray(self.shift_s + self.drift * (media_s - self.middle_s))

    def clock_map(self, shift_s: float, confidence: float) -> ClockMap:
        rate = 1.0 / (1.0 + self.drift)
        offset_s = -(shift_s - self.drift * self.middle_s) * rate
        return ClockMap(offset_s, rate, self.spread_s, confidence)

    @property
    def least_drift(self) -> float:
        """Return the size of the drift that the windows alone show, less 1.5 sigmas."""
        weight = 1.0 / (self.window_sigma_s**2 + _WINDOW_FLOOR_S**2)
        if len(weight) < _FEWEST_WINDOWS:
            return abs(self.drift)
        since_s = self.window_at_s - np.average(self.window_at_s, weights=weight)
        size = float(weight @ since_s**2)
        slope = float(weight @ (since_s * self.window_error_s)) / size
        return max(0.0, abs(self.drift + slope) - 1.5 / float(np.sqrt(size)))

    @property
    def spread_s(self) -> float:
        weight = 1.0 / (self.window_sigma_s**2 + _WINDOW_FLOOR_S**2)
        return float(np.sqrt(weight @ self.window_error_s**2 / weight.sum()))


def fit_line(watched: Watched, gyro: Gyro, start: RotationFit) -> Line:
    """Fit shift and drift to windows of 4 s.

    Args:
        watched: rotation from the frames.
        gyro: the log.
        start: the fit to begin from; its mounting and gains are kept.
    """
    times_s = 0.5 * (watched.begin_s + watched.end_s)
    middle_s = float(np.average(times_s, weights=watched.weight + 1e-9))
    line = np.array([start.shift_s, 0.0])
    steps = _Steps.of(watched, gyro, start, np.full(len(times_s), start.shift_s))
    for _ in range(_ROUNDS):
        windows = steps.windows(times_s)
        normal, right = windows.equations(middle_s, float(line[1]))
        step = np.linalg.solve(normal, right)
        line = line + np.clip(step, -_MOST_STEP_S, _MOST_STEP_S)
        steps = _Steps.of(
            watched, gyro, start, line[0] + line[1] * (times_s - middle_s)
        )
    windows = steps.windows(times_s)
    normal, _ = windows.equations(middle_s, float(line[1]))
    sigma = np.sqrt(np.diag(np.linalg.inv(normal)))
    return Line(
        float(line[0]),
        float(line[1]),
        middle_s,
        float(sigma[0]),
        float(sigma[1]),
        windows.at_s,
        windows.sigma_s,
        windows.shift_s,
        *steps.read_out(watched),
        steps.second_axis,
    )


def _explained(watched: Watched, camera_rad: Floats, error: Floats) -> Floats:
    """Return which share (N,) of the camera's rotation around each interval is explained."""
    count = max(1, round(WINDOW_S / watched.step_s))
    left, whole = (
        uniform_filter1d((one**2).sum(axis=1), count, mode="nearest")
        for one in (error, camera_rad)
    )
    return np.asarray(np.clip(1.0 - left / np.maximum(whole, 1e-18), 0.0, 1.0))


def _second_axis(camera_rad: Floats, gyro_rad: Floats, weight: Floats) -> float:
    """Return the correlation about the second principal axis of the gyro's rotation."""
    _, axes = np.linalg.eigh((gyro_rad * weight[:, None]).T @ gyro_rad)
    camera, gyro = camera_rad @ axes[:, 1], gyro_rad @ axes[:, 1]
    size = float((weight @ camera**2) * (weight @ gyro**2))
    return float(weight @ (camera * gyro)) / max(float(np.sqrt(size)), 1e-18)


class _Windows(NamedTuple):
    """Media time of the middle, shift and its sigma of windows (W,)."""

    at_s: Floats
    shift_s: Floats
    sigma_s: Floats

    def equations(self, middle_s: float, drift: float) -> tuple[Floats, Floats]:
        """Return the normal equations (2, 2), (2,) of a robust line, with its prior."""
        columns = np.column_stack([np.ones(len(self.at_s)), self.at_s - middle_s])
        variance = self.sigma_s**2 + _WINDOW_FLOOR_S**2 + self.shift_s**2 / _OUTLIER
        normal = (columns / variance[:, None]).T @ columns
        right = columns.T @ (self.shift_s / variance)
        normal[1, 1] += 1.0 / DRIFT_PRIOR**2
        right[1] -= drift / DRIFT_PRIOR**2
        return normal, right


class _Steps(NamedTuple):
    """By how much each interval asks to be shifted.

    Attributes:
        shift_s: (N,).
        power: (N, 3) weight of each axis in it, 1 / variance.
        slope: (N, 3) how the rotation changes with the shift, rad/s.
        second_axis: as in `Line`.
    """

    shift_s: Floats
    power: Floats
    slope: Floats
    second_axis: float

    @classmethod
    def of(
        cls, watched: Watched, gyro: Gyro, fit: RotationFit, shifts_s: Floats
    ) -> "_Steps":
        begin_s, end_s = watched.begin_s + shifts_s, watched.end_s + shifts_s
        used = gyro.knows(begin_s, end_s) & (watched.weight > 0.0)
        camera_rad = watched.high_passed(watched.rotation_rad, used)
        gyro_rad = watched.high_passed(
            fit.in_frames(gyro.rotation(begin_s, end_s)), used
        )
        slope = watched.high_passed(fit.in_frames(gyro.change(begin_s, end_s)), used)
        error = camera_rad - gyro_rad
        noise = np.full(3, QUIET_RADPS * watched.step_s)
        if used.any():
            noise = np.maximum(noise, 1.4826 * np.median(np.abs(error[used]), axis=0))
        robust = 1.0 / (1.0 + ((error / noise) ** 2).sum(axis=1) / _OUTLIER) ** 2
        trust = (watched.weight * used * robust)[:, None] / (_CORRELATED * noise) ** 2
        # where the camera does not turn, the slope is the gyro's own noise
        power = trust * slope**2 * _explained(watched, camera_rad, error)[:, None] ** 2
        total = np.maximum(power.sum(axis=1), 1e-12)
        shift_s = (trust * slope * error).sum(axis=1) / total
        second_axis = _second_axis(camera_rad, gyro_rad, watched.weight * used * robust)
        return cls(np.asarray(shift_s), np.asarray(power), slope, second_axis)

    def windows(self, times_s: Floats) -> _Windows:
        """Return windows of 4 s that are at least half full, and know the shift at all."""
        number = ((times_s - times_s[0]) / WINDOW_S).astype(np.intp)
        count = np.bincount(number)
        weight = self.power.sum(axis=1)
        power = np.bincount(number, weight) + 1e-12
        full = count >= 0.5 * count.max()
        knows = full & (power >= 1.0 / _LEAST_KNOWN_S**2)
        kept = knows if knows.any() else full
        shift_s = np.bincount(number, weight * self.shift_s)[kept] / power[kept]
        at_s = np.bincount(number, times_s)[kept] / count[kept]
        return _Windows(at_s, shift_s, 1.0 / np.sqrt(power[kept]))

    def read_out(self, watched: Watched) -> tuple[float, float, float]:
        """Return the deciding row, the read-out time and its sigma.

        The lower rows are exposed later: their rotation is larger by its slope.
        """
        power = self.power / (float(self.power.sum()) or 1.0)
        row = float((power * watched.row).sum())
        skew = watched.high_passed(watched.skew_rad, watched.weight > 0.0)
        read_out_s, whole = 0.0, 1.0
        error, trust = skew, watched.weight
        for _ in range(_ROUNDS):
            size = np.sqrt((error**2).sum(axis=1))
            scale = 2.0 * float(np.median(size[watched.weight > 0.0])) + 1e-9
            trust = watched.weight / (1.0 + (size / scale) ** 2) ** 2
            whole = float((trust[:, None] * self.slope**2).sum()) + 1e-12
            read_out_s = float((trust[:, None] * self.slope * skew).sum()) / whole
            error = skew - read_out_s * self.slope
        noise = float((trust[:, None] * error**2).sum() / (3.0 * trust.sum() + 1e-9))
        return row, read_out_s, _CORRELATED * float(np.sqrt(noise / whole))
