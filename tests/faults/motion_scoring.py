"""How far an estimate is from the truth of a case, and where it says so."""

from dataclasses import dataclass

import numpy as np
from motion_cases import SETTLE_S, Case


@dataclass(frozen=True)
class Score:
    """Inclination errors in degrees, over the rows that count as valid.

    Attributes:
        whole: RMS over the recording.
        during: RMS while the fault lasts; NaN where the case has no such time.
        after: RMS from 10 s after the fault on.
        worst_after: the largest error there.
        invalid_share: rows that are marked as not valid, of all.
        invalid_after: the same from 10 s after the fault on.
    """

    whole: float
    during: float
    after: float
    worst_after: float
    invalid_share: float
    invalid_after: float


def vertical(q) -> np.ndarray:
    """Return the earth's up direction in the sensor frame of wxyz (N, 4)."""
    w, x, y, z = np.asarray(q).T
    up = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
    return np.stack(up, axis=1)


def inclination_deg(up, true_up) -> np.ndarray:
    """Return the angle between two sets of unit vectors (N, 3)."""
    chord = np.linalg.norm(up - true_up, axis=1)
    return np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0)))


def true_up_at(case: Case, time_s) -> np.ndarray:
    """Return the true vertical at any times, between the rows that were taken."""
    true_s, first = np.unique(case.raw.true_s, return_index=True)
    up = case.raw.up[first]
    return np.stack([np.interp(time_s, true_s, axis) for axis in up.T], axis=1)


def score(case: Case, time_s, error_deg, valid) -> Score:
    """Return the figures of one run."""
    during = (time_s >= case.fault_begin_s) & (time_s < case.fault_end_s)
    after = time_s >= case.fault_end_s + SETTLE_S
    late = error_deg[after & valid]
    return Score(
        whole=_rms(error_deg[valid]),
        during=_rms(error_deg[during & valid]),
        after=_rms(late),
        worst_after=float(late.max()) if len(late) else float("nan"),
        invalid_share=_share(~valid),
        invalid_after=_share(~valid[after]),
    )


def _share(flags) -> float:
    return float(np.mean(flags)) if len(flags) else float("nan")


def _rms(values) -> float:
    return float(np.sqrt(np.mean(np.square(values)))) if len(values) else float("nan")
