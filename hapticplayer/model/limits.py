"""Limits that more than one room checks."""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message

GAP_STEPS = 3.0
"""A step of more than this many median steps of a log is a gap."""

MAX_SAMPLES = 100_000_000
"""Rows of one sensor: 34 h of an 800 Hz sensor."""

MAX_FORCE_N = 1000.0
"""Beyond any haptic device of this kind, the Falcon has 9 N: it is in another unit."""


def refuse_large_force(
    force_n: NDArray[np.floating], where: str, remedy: Message | None = None
) -> None:
    """Raise InputError for forces beyond any device."""
    largest_n = float(np.abs(force_n).max(initial=0.0))
    if not largest_n <= MAX_FORCE_N:
        raise InputError(
            "holds a force of {largest_n:.3g} N, beyond any device",
            where=where,
            remedy=remedy or Message("give the forces in newton"),
            largest_n=largest_n,
        )
