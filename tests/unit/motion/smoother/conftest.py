"""Motions with closed-form attitude, and samples of ideal sensors that made them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack, Sampling
from hapticplayer.motion import remove_gravity
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother import state, stationary
from hapticplayer.motion.smoother.samples import InertialSamples
from hapticplayer.motion.smoother.strapdown import Windows

Floats = NDArray[np.float64]
UP_1_G = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(6)


def window_means(function: Callable[[Floats], Floats], middle_s: Floats, width_s):
    """Return the means of a function of time over windows, by Gauss quadrature."""
    points = [
        0.5 * weight * function(middle_s + 0.5 * width_s * node)
        for node, weight in zip(_NODES, _WEIGHTS, strict=True)
    ]
    return np.sum(points, axis=0)


@dataclass(frozen=True)
class Motion:
    """An attitude (sensor to earth) and an acceleration in the earth frame, of time."""

    attitude: Callable[[Floats], Rotation]
    acceleration: Callable[[Floats], Floats] = lambda t: np.zeros((len(t), 3))

    def rate(self, time_s: Floats, h: float = 2e-4) -> Floats:
        """Return the angular rate in the sensor frame, to 1e-10 of its size."""

        def mean(step: float) -> Floats:
            begin, end = self.attitude(time_s - step), self.attitude(time_s + step)
            return (begin.inv() * end).as_rotvec() / (2.0 * step)

        # Richardson: the errors of second and fourth order cancel
        coarse, middle, fine = mean(2.0 * h), mean(h), mean(0.5 * h)
        return ((64.0 * fine - 20.0 * middle) + coarse) / 45.0

    def force(self, time_s: Floats) -> Floats:
        """Return the specific force in the sensor frame."""
        earth = self.acceleration(time_s) + UP_1_G
        return self.attitude(time_s).inv().apply(earth)

    def up(self, time_s: Floats) -> Floats:
        """Return the vertical in the sensor frame."""
        return self.attitude(time_s).inv().apply([0.0, 0.0, 1.0])

    def instant(self, time_s: Floats, **more) -> ImuLog:
        """Return a gyro that integrates since the sample before, and force at a time.

        That is what INSTANT means for an ideal sensor: the mean rate over the
        interval that ends at the time.
        """
        step = np.diff(time_s, prepend=time_s[0] - (time_s[1] - time_s[0]))
        begin, end = self.attitude(time_s - step), self.attitude(time_s)
        rate = (begin.inv() * end).as_rotvec() / step[:, None]
        return ImuLog(time_s, self.force(time_s), rate, **more)

    def averaged(self, count: int, width_s: float, **more) -> ImuLog:
        """Return window means of both sensors, times in the middle."""
        middle = width_s * (np.arange(count) + 0.5)
        return ImuLog(
            middle,
            window_means(self.force, middle, width_s),
            window_means(self.rate, middle, width_s),
            sampling=Sampling.AVERAGED,
            **more,
        )


def wobble(t: Floats) -> Rotation:
    """Return a hand's attitude: some rad about all axes, up to 5 rad/s."""
    angles = [
        0.8 * np.sin(3.0 * t) + 0.5 * t,
        0.5 * np.sin(4.0 * t + 1.0),
        0.6 * np.sin(5.0 * t),
    ]
    return Rotation.from_euler("ZYX", np.stack(angles, axis=-1))


def shake(t: Floats) -> Floats:
    """Return accelerations whose velocity stays bounded, mean zero, m/s^2."""
    waves = [1.5 * np.sin(5.0 * t), 2.0 * np.cos(7.0 * t), np.sin(11.0 * t)]
    return np.stack(waves, axis=-1)


WOBBLE = Motion(wobble, shake)


def scipy_of(pair: rot.Pair) -> Rotation:
    """Return pairs (n,) as scipy's rotations."""
    return Rotation.from_quat(rot.to_wxyz(pair), scalar_first=True)


def inside_of(windows: Windows, k: int) -> Rotation:
    """Return the orientation of sample k relative to its window's start."""
    per_window = windows.inside[0].shape[0]
    at = k % per_window, slice(k // per_window, k // per_window + 1)
    return scipy_of((windows.inside[0][at], windows.inside[1][at]))[0]


def apart(one: Rotation, other: Rotation) -> float:
    """Return the largest angle between rotations."""
    return float(np.max((one.inv() * other).magnitude()))


def samples_of(step_s, force, rate, averaged, **more) -> InertialSamples:
    """Return samples without gaps."""
    lost_s, doubt_s = np.zeros((2, len(step_s)))
    interval_s = float(np.median(step_s))
    return InertialSamples(
        step_s, force, rate, averaged, lost_s, doubt_s, interval_s, **more
    )


def rms(vectors: Floats) -> float:
    """Return the RMS of the norms of (N, 3)."""
    return float(np.sqrt(np.mean(np.sum(np.square(vectors), axis=-1))))


TIME_S = np.arange(1, 6001) / 100.0


def assert_sound(track: MotionTrack) -> None:
    """All numbers are finite, uncertainties positive and quaternions unit."""
    for name in ("acceleration_mps2", "gravity_mps2", "gravity_sigma_mps2"):
        assert np.isfinite(getattr(track, name)).all()
    assert (track.gravity_sigma_mps2 > 0.0).all()
    norm = np.linalg.norm(track.quaternion_wxyz, axis=1)
    assert np.abs(norm - 1.0).max() < 1e-9


def miss(log: ImuLog, up, method="smoother", parameters=None) -> Floats:
    """Return the gravity error in m/s^2, (N, 3)."""
    track = remove_gravity(log, method, parameters=parameters)
    if method == "smoother":
        assert_sound(track)
    return track.gravity_mps2 - STANDARD_GRAVITY_MPS2 * up


@contextmanager
def nothing_skipped() -> Iterator[None]:
    """Leave out no work: neither samples, nor nodes, nor the matrix of the gyro."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stationary, "decimation_of", lambda *_: 1)
        patch.setattr(state, "MIN_MATRIX_RATE_RADPS", 0.0)
        yield
