"""A motion in closed form, sampled on the times of several sensors, with faults.

Three seconds at rest, then a swing about a fixed axis while the sensor is shaken:
the truth of every reading is known without any code of the importers.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]

GRAVITY_MPS2 = 9.80665
REST_S = 3.0
_AXIS = np.array([0.6, 0.48, 0.64])
_FIELD_UT = np.array([3.0, 21.0, -42.0])


def true_force(t: Floats) -> Floats:
    """Specific force (N, 3) in frame A."""
    tau = np.maximum(t - REST_S, 0.0)
    earth = np.stack(
        [1.5 * np.sin(5 * tau), 2.0 * np.sin(7 * tau), 1.0 * np.sin(11 * tau)], axis=1
    )
    earth[:, 2] += GRAVITY_MPS2
    return _turned(t, earth)


def true_rate(t: Floats) -> Floats:
    """Angular rate (N, 3) in frame A."""
    tau = np.maximum(t - REST_S, 0.0)
    return np.outer(0.4 * 1.7 * np.sin(1.7 * tau), _AXIS)


def true_field(t: Floats) -> Floats:
    """Magnetic field (N, 3) in frame A, uT."""
    return _turned(t, np.tile(_FIELD_UT, (len(t), 1)))


def _turned(t: Floats, earth: Floats) -> Floats:
    tau = np.maximum(t - REST_S, 0.0)
    angle = 0.4 * (1.0 - np.cos(1.7 * tau))
    return Rotation.from_rotvec(np.outer(angle, _AXIS)).inv().apply(earth)


@dataclass(frozen=True)
class Sampled:
    """What each sensor delivers, in SI and frame A."""

    force_s: Floats
    force: Floats
    rate_s: Floats
    rate: Floats
    field_s: Floats
    field: Floats


def sample(
    seconds: float = 12.0, rate_hz: float = 100.0, *, apart: bool = False, seed: int = 1
) -> Sampled:
    """Sample the motion with a little noise.

    Args:
        seconds: length.
        rate_hz: of the accelerometer.
        apart: each sensor on times of its own (the gyro 7 % faster, the compass at
            a quarter), otherwise all at the same.
        seed: of the noise.
    """
    rng = np.random.default_rng(seed)
    t = np.arange(round(seconds * rate_hz)) / rate_hz
    rate_s, field_s = t, t
    if apart:
        rate_s = 0.003 + np.arange(round(seconds * rate_hz * 1.07)) / (1.07 * rate_hz)
        field_s = 0.011 + np.arange(round(seconds * rate_hz / 4)) / (rate_hz / 4)
    return Sampled(
        t,
        true_force(t) + 0.01 * rng.standard_normal((len(t), 3)),
        rate_s,
        true_rate(rate_s) + 0.001 * rng.standard_normal((len(rate_s), 3)),
        field_s,
        true_field(field_s),
    )


FAULTS = ("backwards", "duplicate", "gap", "nan", "zero rows", "wrong force unit",
          "wrong rate unit")  # fmt: skip


def with_fault(clean: Sampled, fault: str) -> Sampled:
    """Return the samples with one fault in every sensor."""
    if fault == "wrong force unit":
        return replace(clean, force=clean.force * GRAVITY_MPS2)
    if fault == "wrong rate unit":
        return replace(clean, rate=np.degrees(clean.rate))
    parts = []
    for t, values in (
        (clean.force_s, clean.force),
        (clean.rate_s, clean.rate),
        (clean.field_s, clean.field),
    ):
        parts += _damaged(t.copy(), values.copy(), fault)
    return Sampled(*parts)


def _damaged(t: Floats, values: Floats, fault: str) -> list[Floats]:
    if fault == "backwards":
        t[t > 6.0] -= 3.0
    elif fault == "duplicate":
        t[1::10] = t[0::10][: len(t[1::10])]
    elif fault == "gap":
        kept = (t < 5.0) | (t > 6.5)
        t, values = t[kept], values[kept]
    elif fault == "nan":
        values[40::50, 1] = np.nan
    elif fault == "zero rows":
        t, values = t[:0], values[:0]
    else:
        raise ValueError(fault)
    return [t, values]
