"""The last step of every importer: raw samples in SI become an honest ImuLog."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.model.arrays import Floats

Reals = NDArray[np.floating[Any]]

PLAUSIBLE_MPS2 = (4.0, 40.0)
STUCK = "all samples are the same: was the sensor stuck?"


def clean(
    time_s: Floats,
    force: Reals,
    rate: Reals,
    field: Reals | None = None,
    *,
    source: str = "",
) -> tuple[ImuLog, tuple[str, ...]]:
    """Return the log with every flaw repaired or marked, and what was done.

    A log without any noise (made by a program, or by a stuck sensor) is taken as it
    is, and doubted.

    Args:
        time_s: (N,).
        force: (N, 3) m/s2, frame A; NaN where missing.
        rate: (N, 3) rad/s, frame A; NaN where missing.
        field: (N, 3) uT, frame A, or None.
        source: for messages and provenance.

    Raises:
        InputError: for what cannot be repaired, see `motion.repair_samples`.
    """
    if _is_constant(time_s, force, rate):
        imu = ImuLog(
            time_s,
            np.asarray(force, dtype=np.float64),
            np.asarray(rate, dtype=np.float64),
            None,
            Sampling.INSTANT,
            source,
        )
        return imu, (STUCK,)
    from hapticplayer.motion import repair_samples  # brings scipy along

    done = repair_samples(
        time_s, force, rate, field, sampling=Sampling.INSTANT, source=source
    )
    return done.imu, tuple(repair.text for repair in done.repairs)


def _is_constant(time_s: Floats, force: Reals, rate: Reals) -> bool:
    """Whether times are in order and every sample is like the first, about 1 g."""
    low, high = PLAUSIBLE_MPS2
    return bool(
        len(time_s) > 1
        and (force[:2] == force[0]).all()  # nearly always settles it
        and low <= np.linalg.norm(force[0]) <= high
        and np.isfinite(time_s).all()
        and (np.diff(time_s) > 0.0).all()
        and np.isfinite(force[0]).all()
        and np.isfinite(rate[0]).all()
        and (force == force[0]).all()
        and (rate == rate[0]).all()
    )
