"""Corrections for the number of tests."""

from collections.abc import Sequence

import numpy as np


def holm(p_values: Sequence[float | None]) -> list[float | None]:
    """Return p values corrected step by step (Holm 1979); None stay out of the family."""
    known = [i for i, p in enumerate(p_values) if p is not None]
    raw = np.array([p_values[i] for i in known], dtype=np.float64)
    order = np.argsort(raw, kind="stable")
    scaled = raw[order] * np.arange(len(raw), 0, -1)
    corrected: list[float | None] = [None] * len(p_values)
    for place, p in zip(
        order, np.minimum(np.maximum.accumulate(scaled), 1.0), strict=True
    ):
        corrected[known[place]] = float(p)
    return corrected
