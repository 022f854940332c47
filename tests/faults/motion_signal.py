"""A minute of hand-held motion with exact truth, before anything goes wrong.

Orientation and acceleration are closed forms. Angular rates are the exact mean over
the interval that ends at each sample (scipy's logarithm of the rotation between two
samples), forces are what an ideal sensor shows at the sample's time.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.spatial.transform import Rotation

GRAVITY_MPS2 = 9.80665
RATE_HZ = 100.0
SECONDS = 60.0
UP_1_G = np.array([0.0, 0.0, GRAVITY_MPS2])
FORCE_NOISE_MPS2 = 0.02
RATE_NOISE_RADPS = 0.001
FIELD_NOISE_UT = 0.3
EARTH_FIELD_UT = np.array([0.0, 20.0, -45.0])


@dataclass
class Raw:
    """What a logger hands over, and the truth beside it.

    Attributes:
        time_s: (N,) stamps.
        force: (N, 3) specific force in m/s^2.
        rate: (N, 3) angular rate in rad/s.
        field: (N, 3) magnetic field in uT, or None.
        true_s: (N,) when each row was really taken.
        up: (N, 3) true vertical in the sensor frame of each row.
    """

    time_s: np.ndarray
    force: np.ndarray
    rate: np.ndarray
    field: np.ndarray | None
    true_s: np.ndarray
    up: np.ndarray

    def taken(self, rows) -> "Raw":
        """Return the given rows of everything."""
        return Raw(
            self.time_s[rows],
            self.force[rows],
            self.rate[rows],
            None if self.field is None else self.field[rows],
            self.true_s[rows],
            self.up[rows],
        )


@dataclass(frozen=True)
class Scene:
    """What the sensor goes through.

    Attributes:
        time_s: (N,) when the samples are taken.
        start: orientation before the motion, sensor to earth.
        extra_mps2: (N, 3) acceleration in the earth frame beside the usual.
        turning: factor on the angles of the motion.
        spin_radps: constant angular rate in the sensor frame instead of the motion.
        gyro_bias_radps: (3,).
    """

    time_s: np.ndarray = field(
        default_factory=lambda: np.arange(round(SECONDS * RATE_HZ)) / RATE_HZ
    )
    start: Rotation = field(default_factory=Rotation.identity)
    extra_mps2: np.ndarray | None = None
    turning: float = 1.0
    spin_radps: np.ndarray | None = None
    gyro_bias_radps: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def with_extra(self, begin_s, end_s, acceleration) -> "Scene":
        """Return the scene with an acceleration (3,) or (N, 3) between two times."""
        inside = (self.time_s >= begin_s) & (self.time_s < end_s)
        return replace(self, extra_mps2=inside[:, None] * np.asarray(acceleration))


def record(scene: Scene, seed: int = 1) -> Raw:
    """Return the samples of an ideal sensor with a little white noise."""
    rng = np.random.default_rng(seed)
    t = scene.time_s
    step_s = np.diff(t, prepend=t[0] - 1.0 / RATE_HZ)
    before, at = _orientation(scene, t - step_s), _orientation(scene, t)
    rate = (before.inv() * at).as_rotvec() / step_s[:, None]
    if scene.spin_radps is not None:
        # the logarithm knows turns below half a revolution only
        rate = np.tile(scene.spin_radps, (len(t), 1))
    acceleration = usual_acceleration(t)
    if scene.spin_radps is not None:
        acceleration = np.zeros_like(acceleration)
    if scene.extra_mps2 is not None:
        acceleration = acceleration + scene.extra_mps2
    force = at.inv().apply(acceleration + UP_1_G)
    shape = (len(t), 3)
    return Raw(
        time_s=t.copy(),
        force=force + FORCE_NOISE_MPS2 * rng.standard_normal(shape),
        rate=rate
        + RATE_NOISE_RADPS * rng.standard_normal(shape)
        + np.asarray(scene.gyro_bias_radps),
        field=at.inv().apply(EARTH_FIELD_UT)
        + FIELD_NOISE_UT * rng.standard_normal(shape),
        true_s=t.copy(),
        up=at.inv().apply([0.0, 0.0, 1.0]),
    )


def _ease(t):
    """Rise from 0 to 1 between 3 s and 5 s: the recording begins at rest."""
    part = np.clip((t - 3.0) / 2.0, 0.0, 1.0)
    return part * part * (3.0 - 2.0 * part)


def _orientation(scene: Scene, t) -> Rotation:
    if scene.spin_radps is not None:
        return scene.start * Rotation.from_rotvec(t[:, None] * scene.spin_radps)
    ease = scene.turning * _ease(t)
    angles = [
        ease * (0.8 * np.sin(0.5 * t) + 0.3 * np.sin(1.9 * t)),
        ease * 0.4 * np.sin(0.9 * t + 1.0),
        ease * 0.5 * np.sin(1.3 * t),
    ]
    return scene.start * Rotation.from_euler("ZYX", np.stack(angles, axis=1))


def usual_acceleration(t):
    """Return (N, 3) in the earth frame, zero on average."""
    waves = [1.5 * np.sin(5.0 * t), 2.0 * np.cos(7.0 * t), 1.0 * np.sin(11.0 * t)]
    return _ease(t)[:, None] * np.stack(waves, axis=1)
