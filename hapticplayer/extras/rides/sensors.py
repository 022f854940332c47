"""What an inertial sensor writes about an exact motion."""

from dataclasses import dataclass, field

import numpy as np
from scipy.signal import lfilter

from hapticplayer.errors import UsageError
from hapticplayer.extras.rides.trajectory import Motion, Trajectory
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import vertical

_DEGREE = np.pi / 180.0


@dataclass(frozen=True, slots=True)
class SensorErrors:
    """What is wrong with one three-axis sensor, in its SI unit.

    The value x of an axis becomes clip(round(x (1 + scale) + bias + drift + noise)),
    x being C times the exact values with `cross`.

    Attributes:
        noise: SD of the white noise of each sample.
        bias: SD of the constant bias of each axis.
        offset: constant bias that every copy of this sensor has, by axis.
        drift: SD of the bias instability, a Gauss-Markov process.
        drift_time_s: its correlation time.
        scale: SD of the relative scale error of each axis.
        limit: full scale; larger values are clipped to it.
        step: quantisation; 0 for none.
        cross: SD of the share of each other axis in an axis: not at right angles, or
            mounted askew.
        per_kelvin: SD by axis of the change of bias with the temperature.
    """

    noise: float = 0.0
    bias: float = 0.0
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    drift: float = 0.0
    drift_time_s: float = 100.0
    scale: float = 0.0
    limit: float = np.inf
    step: float = 0.0
    cross: float = 0.0
    per_kelvin: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def applied(
        self,
        exact: Floats,
        rate_hz: float,
        rng: np.random.Generator,
        warmer_k: Floats | None = None,
    ) -> Floats:
        """The sensor's samples of exact values (N, 3) at a rate.

        `warmer_k` (N,) is how much warmer it is than when its bias was measured.
        """
        if self.cross > 0.0:
            askew = self.cross * rng.standard_normal((3, 3))
            np.fill_diagonal(askew, 1.0)
            exact = exact @ askew.T
        if warmer_k is not None:
            slopes = np.array(self.per_kelvin) * rng.standard_normal(3)
            exact = exact + np.outer(warmer_k, slopes)
        axes = exact.shape[1]
        scale = 1.0 + self.scale * rng.standard_normal(axes)
        bias = np.array(self.offset) + self.bias * rng.standard_normal(axes)
        noise = self.noise * rng.standard_normal(exact.shape)
        value = exact * scale + bias + noise + self._drifting(exact, rate_hz, rng)
        if self.step > 0.0:
            value = self.step * np.round(value / self.step)
        return np.asarray(np.clip(value, -self.limit, self.limit))

    def _drifting(
        self, exact: Floats, rate_hz: float, rng: np.random.Generator
    ) -> Floats:
        """x[k] = phi x[k-1] + sqrt(1 - phi^2) drift n[k], in its steady state."""
        drawn = rng.standard_normal(exact.shape)
        if self.drift == 0.0 or not len(exact):
            return np.zeros(exact.shape)
        phi = np.exp(-1.0 / (rate_hz * self.drift_time_s))
        drawn[1:] *= np.sqrt(1.0 - phi**2)
        return np.asarray(self.drift * lfilter([1.0], [1.0, -phi], drawn, axis=0))


@dataclass(frozen=True, slots=True)
class SensorModel:
    """An inertial sensor.

    Its gyro integrates: each of its samples is the mean rotation since the last one.
    Its accelerometer measures the specific force at the time of the sample. With
    `averaged_to_hz`, samples in the middles of intervals of 1 / rate_hz are averaged
    over windows (a boxcar; a part of an interval counts as its part), as the firmware
    of the paper's board does; None logs them as they are. The seed of the errors comes
    beside the ride's.

    Raises:
        UsageError: when a rate is not positive, or the log's above the sensor's.
    """

    name: str
    rate_hz: float = 200.0
    averaged_to_hz: float | None = None
    accelerometer: SensorErrors = field(default_factory=SensorErrors)
    gyro: SensorErrors = field(default_factory=SensorErrors)
    seed: int = 0

    def __post_init__(self) -> None:
        log_hz = self.rate_hz if self.averaged_to_hz is None else self.averaged_to_hz
        if not 0.0 < log_hz <= self.rate_hz < np.inf:
            raise UsageError(
                "a sensor of {rate_hz:g} Hz averaged to {log_hz:g} Hz; give rates "
                "above 0, the second not above the first",
                rate_hz=self.rate_hz,
                log_hz=log_hz,
            )


CAMERA = SensorModel(
    "camera",
    accelerometer=SensorErrors(noise=0.035, bias=0.04),
    gyro=SensorErrors(noise=0.003, bias=0.004),
)
"""A sensor in a camera after a factory calibration, as in the demo."""

PHONE = SensorModel(
    "phone",
    accelerometer=SensorErrors(
        noise=0.022,
        bias=0.06,
        scale=0.004,
        limit=2.0 * STANDARD_GRAVITY_MPS2,
        step=2.0 * STANDARD_GRAVITY_MPS2 / 32768.0,
    ),
    gyro=SensorErrors(
        noise=9e-4,
        bias=0.003,
        offset=(0.8 * _DEGREE, -0.2 * _DEGREE, 4.0 * _DEGREE),
        drift=2e-4,
        scale=0.003,
        limit=500.0 * _DEGREE,
        step=500.0 * _DEGREE / 32768.0,
    ),
)
"""A phone with an uncalibrated gyro: noise and bias as measured on a Nexus 5."""

PAPER_BOARD = SensorModel(
    "paper-board",
    averaged_to_hz=30.0,
    accelerometer=SensorErrors(
        noise=0.075,
        bias=0.2,
        drift=0.01,
        scale=0.01,
        limit=16.0 * STANDARD_GRAVITY_MPS2,
        step=STANDARD_GRAVITY_MPS2 / 256.0,
    ),
    gyro=SensorErrors(
        noise=0.045 * _DEGREE,
        bias=1.6 * _DEGREE,
        drift=0.01 * _DEGREE,
        scale=0.02,
        limit=2000.0 * _DEGREE,
        step=_DEGREE / 14.375,
    ),
)
"""ADXL345 and ITG-3200 as measured at 200 Hz, averaged to 30 Hz (Danieau 2012)."""

IDEAL = SensorModel("ideal")
"""No error at all."""

SENSORS = {model.name: model for model in (CAMERA, PHONE, PAPER_BOARD, IDEAL)}
"""Sensor models by name."""


@dataclass(frozen=True, slots=True, eq=False)
class LogWithTruth:
    """A log beside the truth of each of its samples.

    Attributes:
        truth: exact motion at the log's times, which for window means are the
            middles of the windows.
        vertical: (N, 3) true up in the sensor frame for what each sample stands
            for: at its time, or the mean over its window.
        acceleration_mps2: (N, 3) true gravity-free motion, likewise.
    """

    imu: ImuLog
    truth: Motion
    vertical: Floats
    acceleration_mps2: Floats


def measure(
    trajectory: Trajectory, duration_s: float, model: SensorModel, seed: int
) -> LogWithTruth:
    """Let a sensor record a trajectory from 0 to `duration_s`.

    The trajectory reaches from at least one sensor sample before 0 on.
    """
    rng = np.random.default_rng([seed, 1, model.seed])
    step_s = 1.0 / model.rate_hz
    count = int(duration_s * model.rate_hz + 1e-6)
    if model.averaged_to_hz is None:
        time_s = _regular(count + 1, 0.0, model.rate_hz)
        ends_s = time_s
    else:  # intervals begin at 0; the force is taken in their middles
        time_s = _regular(count, 0.5, model.rate_hz)
        ends_s = time_s + 0.5 * step_s
    truth = trajectory.at(time_s)
    force = model.accelerometer.applied(truth.specific_force_mps2, model.rate_hz, rng)
    mean_rate = trajectory.mean_rate_radps(ends_s, step_s)
    rate = model.gyro.applied(mean_rate, model.rate_hz, rng)
    up = vertical(truth.quaternion_wxyz)
    sampling = Sampling.INSTANT
    acceleration = truth.acceleration_mps2
    if model.averaged_to_hz is not None:
        sampling = Sampling.AVERAGED
        parts = (force, rate, up, acceleration)
        per_window = model.rate_hz / model.averaged_to_hz
        force, rate, up, acceleration = (window_means(v, per_window) for v in parts)
        truth = trajectory.at(_regular(len(force), 0.5, model.averaged_to_hz))
    log = ImuLog(truth.time_s, force, rate, sampling=sampling, source=model.name)
    return LogWithTruth(log, truth, up, acceleration)


def _regular(count: int, first: float, rate_hz: float) -> Floats:
    return np.asarray((np.arange(count) + first) / rate_hz, dtype=np.float64)


def window_means(values: Floats, per_window: float) -> Floats:
    """Return boxcar means (M, 3) of values (N, 3) over windows of so many samples.

    A window that ends within a sample takes that part of it.
    """
    count = int((len(values) + 1e-6) / per_window)
    total = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(values, axis=0)])
    edges = np.minimum(np.arange(count + 1) * per_window, len(values))
    whole = np.minimum(edges.astype(int), len(values) - 1)
    at_edges = total[whole] + (edges - whole)[:, None] * values[whole]
    return np.asarray(np.diff(at_edges, axis=0) / per_window)
