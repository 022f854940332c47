"""Compares a camera's rotation, estimated from its frames, with a gyro's.

Both are rotations over the intervals between frames: the gyro's is the difference of its
integral at both ends, so that no sampling rate and no averaging needs to be undone. Both
are high-passed, because a bias, the horizon and a slow turn say little about time.
"""

import itertools
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft, next_fast_len, rfft
from scipy.interpolate import CubicSpline
from scipy.signal import butter, sosfiltfilt

from hapticplayer.capture.frames import FrameRotation
from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import are_gaps

HIGH_PASS_HZ = 0.4
LEAST_OVERLAP_S = 6.0
ANYWHERE = (-np.inf, np.inf)

_EDGE_S = 0.01  # of the integral; what turns faster, no frame shows
_COARSE_STEP_S = 0.017  # between shifts that are compared at first
_NEIGHBOUR_S = 0.15  # nearer shifts belong to the same peak
_MOST_CANDIDATES = 8
_REACHES_S = ((0.024, 0.004), (0.004, 0.001))
QUIET_RADPS = np.radians(0.05)  # a gyro and frames are never quieter
_PADDING = 20  # intervals, where a filter begins
_SCALE = 2.0  # of the robust loss, in RMS of the rotation
_FOCAL_GAINS = (0.35, 2.5)


class Gyro:
    """The integral of a log's angular rate, at any time of its own clock."""

    def __init__(self, imu: ImuLog) -> None:
        time_s, rate = imu.time_s, imu.angular_rate_radps
        steps_s = np.diff(time_s)
        if imu.sampling is Sampling.AVERAGED:
            inner_s = time_s[:-1] + 0.5 * steps_s
            first_s = [2.0 * time_s[0] - inner_s[0]]
            edges_s = np.concatenate([first_s, inner_s, [2 * time_s[-1] - inner_s[-1]]])
        else:
            edges_s = np.concatenate([[time_s[0] - float(np.median(steps_s))], time_s])
        parts = rate * np.diff(edges_s)[:, None]
        total = np.concatenate([np.zeros((1, 3)), np.cumsum(parts, axis=0)])
        # a log of hours would take gigabytes
        every = max(1, round(_EDGE_S / float(np.median(steps_s))))
        edges_s, total = edges_s[::every], total[::every]
        self.begin_s, self.end_s = float(edges_s[0]), float(edges_s[-1])
        self._integral = CubicSpline(edges_s, total)
        self._rate = self._integral.derivative()
        is_gap = are_gaps(steps_s)
        self._gaps_s = np.stack([time_s[:-1][is_gap], time_s[1:][is_gap]], axis=1)

    def rotation(self, begin_s: Floats, end_s: Floats) -> Floats:
        """Return the rotation (N, 3) over intervals, rad."""
        return np.asarray(self._integral(end_s) - self._integral(begin_s))

    def change(self, begin_s: Floats, end_s: Floats) -> Floats:
        """Return the derivative (N, 3) of `rotation` by a shift of both ends."""
        return np.asarray(self._rate(end_s) - self._rate(begin_s))

    def knows(self, begin_s: Floats, end_s: Floats) -> NDArray[np.bool_]:
        """Whether each interval is inside of the log and of none of its gaps."""
        known = (begin_s >= self.begin_s) & (end_s <= self.end_s)
        for gap_begin_s, gap_end_s in self._gaps_s:
            known &= (end_s <= gap_begin_s) | (begin_s >= gap_end_s)
        return np.asarray(known)


@dataclass(frozen=True, slots=True, eq=False)
class Watched:
    """Rotation from frames, ready to be compared: N intervals of one or more spans.

    Attributes:
        begin_s: (N,) media time.
        end_s: (N,) media time.
        rotation_rad: (N, 3) as estimated.
        weight: (N,) 0 to 1.
        row: (N, 3) as in `FrameRotation`.
        skew_rad: (N, 3) as in `FrameRotation`.
        step_s: usual length of an interval.
        spans: rows of each span without a break.
    """

    begin_s: Floats
    end_s: Floats
    rotation_rad: Floats
    weight: Floats
    row: Floats
    skew_rad: Floats
    step_s: float
    spans: tuple[slice, ...]

    @classmethod
    def of(cls, frames: FrameRotation) -> "Watched":
        """Prepare what `rotation.rotation` gives."""
        step_s = float(np.median(frames.end_s - frames.begin_s))
        breaks = np.flatnonzero(frames.begin_s[1:] > frames.end_s[:-1] + 1e-6) + 1
        edges = [0, *breaks.tolist(), len(frames)]
        spans = tuple(slice(a, b) for a, b in itertools.pairwise(edges))
        return cls(
            frames.begin_s,
            frames.end_s,
            frames.rotation_rad,
            frames.quality,
            frames.row,
            frames.skew_rad,
            step_s,
            spans,
        )

    def high_passed(self, values: Floats, used: NDArray[np.bool_]) -> Floats:
        """Return values (N, K) above 0.4 Hz; those that are not used count as zero."""
        result = np.zeros_like(values)
        kept = np.where(used[:, None], values, 0.0)
        for span in self.spans:
            result[span] = high_passed(kept[span], 1.0 / self.step_s)
        return np.where(used[:, None], result, 0.0)


def high_passed(values: Floats, rate_hz: float) -> Floats:
    """Return values (N, K) above 0.4 Hz, zero phase."""
    if len(values) <= _PADDING:
        return np.zeros_like(values)
    filter_ = butter(2, HIGH_PASS_HZ, "high", fs=rate_hz, output="sos")
    return np.asarray(sosfiltfilt(filter_, values, axis=0, padlen=_PADDING))


class RotationFit(NamedTuple):
    """Frames and gyro laid over each other.

    Attributes:
        shift_s: log time minus media time, at the middle of the frames.
        mounting: (3, 3) from the log's axes to the camera's.
        gains: (3,) of the frames, per axis of the camera; x and z are the same.
        unexplained: share of the frames' rotation that the gyro does not explain.
        error_rad: (N, 3) of each interval.
        used: (N,) which intervals were compared.
    """

    shift_s: float
    mounting: Floats
    gains: Floats
    unexplained: float
    error_rad: Floats
    used: NDArray[np.bool_]

    def in_frames(self, rotation_rad: Floats) -> Floats:
        """Return rotation (N, 3) in the log's axes as frames show it."""
        return np.asarray(rotation_rad @ self.mounting.T * self.gains)


def fit_at(
    watched: Watched,
    gyro: Gyro,
    shift_s: float | Floats,
    mounting: Floats | None = None,
) -> RotationFit:
    """Fit gains and mounting (unless it is given) at one shift, or at one each (N,)."""
    begin_s, end_s = watched.begin_s + shift_s, watched.end_s + shift_s
    used = gyro.knows(begin_s, end_s) & (watched.weight > 0.0)
    camera_rad = watched.high_passed(watched.rotation_rad, used)
    gyro_rad = watched.high_passed(gyro.rotation(begin_s, end_s), used)
    weight = watched.weight
    scale = _SCALE * _rms(camera_rad, weight * used)
    robust = weight * used
    gains, rotation = np.ones(3), np.eye(3) if mounting is None else mounting
    error = camera_rad
    for _ in range(5):
        if mounting is None:
            rotation = _procrustes(camera_rad / gains, gyro_rad, robust)
        turned = gyro_rad @ rotation.T
        gains = _gains(camera_rad, turned, robust)
        error = camera_rad - turned * gains
        square = (error**2).sum(axis=1)
        robust = weight * used / (1.0 + square / scale**2) ** 2
    size = (camera_rad**2).sum(axis=1)
    whole = float((weight * used) @ _loss(size, scale)) or 1.0
    left = float((weight * used) @ _loss((error**2).sum(axis=1), scale)) / whole
    shift_s = float(np.mean(shift_s))
    return RotationFit(
        shift_s, rotation, gains, left if used.any() else 1.0, error, used
    )


def _loss(square: Floats, scale: float) -> Floats:
    return np.asarray(square / (1.0 + square / scale**2))


def _rms(values: Floats, weight: Floats) -> float:
    total = float(weight.sum()) or 1.0
    return float(np.sqrt(weight @ (values**2).sum(axis=1) / total)) + 1e-9


def _procrustes(camera_rad: Floats, gyro_rad: Floats, weight: Floats) -> Floats:
    """Return the rotation (3, 3) that best takes the gyro's to the camera's."""
    u, _, vt = np.linalg.svd((camera_rad * weight[:, None]).T @ gyro_rad)
    if np.linalg.det(u @ vt) < 0.0:
        u[:, 2] = -u[:, 2]
    turned: Floats = u @ vt
    return turned


def _gains(camera_rad: Floats, turned: Floats, weight: Floats) -> Floats:
    """Return the gain of each axis, that of the focal length about x and z."""
    agree = weight @ (camera_rad * turned)
    size = weight @ turned**2 + 1e-12
    shared = float((agree.sum() / size.sum()).clip(*_FOCAL_GAINS))
    # an axis about which nothing turns takes the gain of the others
    prior = 0.02 * float(size.sum())
    roll = (agree[1] + prior * shared) / (size[1] + prior)
    focal = (agree[0] + agree[2] + prior * shared) / (size[0] + size[2] + prior)
    gains = np.array([focal, roll, focal], dtype=float)
    return np.asarray(np.clip(gains, *_FOCAL_GAINS))


def candidates(
    watched: Watched, gyro: Gyro, near_s: tuple[float, float] = ANYWHERE
) -> list[RotationFit]:
    """Return the shifts between two at which frames and gyro fit best, best first."""
    fits = [_refined(watched, gyro, one) for one in _coarse(watched, gyro, near_s)]
    fits.sort(key=lambda fit: fit.unexplained)
    kept: list[RotationFit] = []
    for fit in fits:
        if all(abs(fit.shift_s - one.shift_s) > _NEIGHBOUR_S for one in kept):
            kept.append(fit)
    return kept


def _refined(watched: Watched, gyro: Gyro, shift_s: float) -> RotationFit:
    best = fit_at(watched, gyro, shift_s)
    for reach_s, step_s in _REACHES_S:
        count = round(reach_s / step_s)
        steps_s = best.shift_s + step_s * np.arange(-count, count + 1)
        fits = [fit_at(watched, gyro, float(one)) for one in steps_s]
        best = min(fits, key=lambda fit: fit.unexplained)
    return best


def _coarse(watched: Watched, gyro: Gyro, near_s: tuple[float, float]) -> list[float]:
    """Return the peaks of the correlation between two shifts, whatever the axes."""
    step_s = watched.step_s
    begin_s = float(watched.begin_s[0])
    cell = np.round((watched.begin_s - begin_s) / step_s).astype(np.intp)
    used = watched.weight > 0.0
    camera = np.zeros((int(cell[-1]) + 1, 4))
    high = watched.high_passed(watched.rotation_rad, used)
    camera[cell[used], :3], camera[cell[used], 3] = high[used], 1.0
    parts = max(1, round(step_s / _COARSE_STEP_S))
    shifts_s, scores = [], []
    for part in range(parts):
        first_s = gyro.begin_s + part * step_s / parts
        lags, score = _correlation(camera, gyro, first_s, step_s)
        shifts_s.append(first_s + lags * step_s - begin_s)
        scores.append(score)
    at_s, score = np.concatenate(shifts_s), np.concatenate(scores)
    return _peaks(at_s, np.where((at_s >= near_s[0]) & (at_s <= near_s[1]), score, 0.0))


def _correlation(
    camera: Floats, gyro: Gyro, first_s: float, step_s: float
) -> tuple[NDArray[np.intp], Floats]:
    """Return lags in steps, and at each the best correlation over all mountings."""
    count = int((gyro.end_s - first_s) / step_s)
    grid_s = np.asarray(first_s + step_s * np.arange(count + 1), dtype=float)
    gyro_rad = high_passed(gyro.rotation(grid_s[:-1], grid_s[1:]), 1.0 / step_s)
    known = gyro.knows(grid_s[:-1], grid_s[1:])
    gyro_rad = np.where(known[:, None], gyro_rad, 0.0)
    length = next_fast_len(len(camera) + count)
    camera_f = np.conj(rfft(camera, length, axis=0))
    gyro_f = rfft(np.column_stack([gyro_rad, known]), length, axis=0)

    def correlated(one: Floats, other: Floats) -> Floats:
        return np.asarray(irfft(one * other, length, axis=0))

    cross = correlated(camera_f[:, :3, None], gyro_f[:, None, :3])
    sizes = np.sum(camera[:, :3] ** 2, axis=1), np.sum(gyro_rad**2, axis=1)
    size_f = np.conj(rfft(sizes[0], length)), rfft(sizes[1], length)
    camera_size = correlated(size_f[0], gyro_f[:, 3])
    gyro_size = correlated(camera_f[:, 3], size_f[1])
    common = correlated(camera_f[:, 3], gyro_f[:, 3])
    singular = np.linalg.svd(cross, compute_uv=False)
    sign = np.sign(np.linalg.det(cross))
    fit = singular[:, 0] + singular[:, 1] + sign * singular[:, 2]
    quiet = common * (QUIET_RADPS * step_s) ** 2
    score = fit / np.sqrt(
        (camera_size + quiet).clip(1e-18) * (gyro_size + quiet).clip(1e-18)
    )
    least = min(LEAST_OVERLAP_S / step_s, 0.5 * float(camera[:, 3].sum()))
    score = np.where(common >= max(least, 1.0), score, 0.0)
    lags = np.arange(length)
    return np.where(lags < count, lags, lags - length), score


def _peaks(shifts_s: Floats, scores: Floats) -> list[float]:
    found: list[float] = []
    scores = scores.copy()
    while len(found) < _MOST_CANDIDATES and len(scores) and scores.max() > 0.0:
        best = float(shifts_s[int(np.argmax(scores))])
        found.append(best)
        scores[np.abs(shifts_s - best) < _NEIGHBOUR_S] = 0.0
    return found
