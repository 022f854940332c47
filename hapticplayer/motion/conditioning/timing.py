"""Steps, gaps and runs of samples, for all of conditioning."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import are_gaps

Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]


def median_step_s(time_s: Floats) -> float:
    """Return the median time between samples."""
    if len(time_s) < 2:
        raise InputError(
            "{count} samples have no rate",
            remedy="give a recording with at least two samples",
            count=len(time_s),
        )
    return float(np.median(np.diff(time_s)))


def gaps(time_s: Floats, step_s: float) -> Mask:
    """Return (N-1,) True where a step between two samples is a gap."""
    return are_gaps(np.diff(time_s), step_s)


def runs(mask: NDArray[Any]) -> tuple[Indices, Indices]:
    """Return first and one-past-last index of each run of True in (N,)."""
    padded = np.concatenate(([False], mask.astype(np.bool_), [False]))
    edges = np.flatnonzero(padded[1:] != padded[:-1])
    return edges[::2], edges[1::2]


def positive(value: float, name: str, remedy: str) -> float:
    """Return a finite positive number."""
    if not (np.isfinite(value) and value > 0.0):
        raise InputError(
            "{name} must be a positive number, got {value}",
            remedy=remedy,
            name=name,
            value=value,
        )
    return float(value)
