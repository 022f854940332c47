"""Sequence x feedback: analysis of variance of aligned ranks.

Averaging over the sequences hides whether a feedback works for some of them only. For
each effect the responses are aligned (all other effects subtracted), ranked, and put
into an analysis of variance with both factors within participants, of which only this
effect is used (Wobbrock et al. 2011); p is also corrected for non-sphericity (Greenhouse
and Geisser 1959).
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
import scipy

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.statistic import (
    ALPHA,
    Found,
    ReportColumn,
    Statistic,
    listed,
    number,
    p_value,
)

EFFECTS = ("sequence", "feedback", "interaction")
_DECIMALS = 9  # so that aligned responses that differ by rounding are ties
_LEAST = 2


def structure(values: Floats, participants: tuple[str, ...]) -> Found | None:
    """Analyse (P, S, F); None with fewer than two of something, or constant values.

    `p_corrected` uses the degrees of freedom times `epsilon` of Greenhouse and Geisser
    (1/df to 1). Participants with missing answers are dropped.
    """
    whole = ~np.isnan(values).any(axis=(1, 2))
    kept = values[whole]
    if min(kept.shape) < _LEAST or np.ptp(kept) == 0.0:
        return None
    effects = {}
    for name in EFFECTS:
        effect = _effect(aligned_ranks(kept, name), name)
        if effect is None:
            return None
        effects[name] = effect
    codes = np.array(participants, dtype=object)
    found = {"participants": codes[whole].tolist(), "dropped": codes[~whole].tolist()}
    return {**found, "effects": effects}


def aligned_ranks(values: Floats, effect: str) -> Floats:
    """Return the ranks of `values` (P, S, F) aligned for one effect."""
    aligned = align(values, effect)
    return np.asarray(scipy.stats.rankdata(aligned), np.float64).reshape(values.shape)


def align(values: Floats, effect: str) -> Floats:
    """Return `values` (P, S, F) without all effects but one."""
    cells = values.mean(axis=0)
    grand = cells.mean()
    sequence = cells.mean(axis=1, keepdims=True) - grand
    feedback = cells.mean(axis=0, keepdims=True) - grand
    estimates = {
        "sequence": sequence,
        "feedback": feedback,
        "interaction": cells - grand - sequence - feedback,
    }
    return np.asarray(np.round(values - cells + estimates[effect], _DECIMALS))


def _effect(ranks: Floats, name: str) -> Found | None:
    """Return the effect of the analysis of variance of ranks (P, S, F)."""
    from pandas import DataFrame
    from statsmodels.stats.anova import AnovaRM

    epsilon = _epsilon(ranks, name)
    if epsilon is None:
        return None
    person, sequence, feedback = (axis.ravel() for axis in np.indices(ranks.shape))
    columns = {"y": ranks.ravel(), "p": person, "sequence": sequence}
    table = DataFrame({**columns, "feedback": feedback})
    within = ["sequence", "feedback"]
    found = AnovaRM(table, "y", "p", within=within).fit().anova_table
    row = found.loc["sequence:feedback" if name == "interaction" else name]
    f, df1, df2 = (float(row[key]) for key in ("F Value", "Num DF", "Den DF"))
    return {
        "n": len(ranks),
        "f": f,
        "df": (df1, df2),
        "p": float(scipy.stats.f.sf(f, df1, df2)),
        "epsilon": epsilon,
        "p_corrected": float(scipy.stats.f.sf(f, df1 * epsilon, df2 * epsilon)),
        "partial_eta_squared": f * df1 / (f * df1 + df2),
    }


def _epsilon(ranks: Floats, name: str) -> float | None:
    """Return tr(C)^2 / (d tr(C^2)) of the d contrasts' covariance C; None if it is 0."""
    sequences, feedbacks = (_contrasts(size) for size in ranks.shape[1:])
    means = [np.full((size, 1), size**-0.5) for size in ranks.shape[1:]]
    if name == "sequence":
        contrasts = np.kron(sequences, means[1])
    elif name == "feedback":
        contrasts = np.kron(means[0], feedbacks)
    else:
        contrasts = np.kron(sequences, feedbacks)
    covariance = np.atleast_2d(
        np.cov(ranks.reshape(len(ranks), -1) @ contrasts, rowvar=False)
    )
    square = float((covariance**2).sum())
    if square < 1e-18:
        return None
    return float(np.trace(covariance) ** 2 / (len(covariance) * square))


def _contrasts(size: int) -> Floats:
    """Return orthonormal contrasts (size, size - 1)."""
    helmert = np.eye(size) - 1.0 / size
    columns, _ = np.linalg.qr(helmert[:, :-1])
    return np.asarray(columns, np.float64)


def _warnings(found: dict[str, Any]) -> Iterator[str]:
    for measure, one in found.items():
        if one is None:
            yield (
                f"{measure}: sequence and feedback cannot be analysed together (fewer "
                "than two of something, or constant ratings)."
            )
            continue
        if one["dropped"]:
            yield (
                f"{measure}: the analysis of aligned ranks excludes "
                f"{listed(one['dropped'])} (missing answers)."
            )
        uneven = [
            name
            for name, effect in one["effects"].items()
            if (effect["p"] < ALPHA) != (effect["p_corrected"] < ALPHA)
        ]
        if uneven:
            yield (
                f"{measure}: sphericity does not hold, which changes the result for "
                f"{listed(uneven)}: use the corrected p of the aligned ranks."
            )


ALIGNED_RANKS = Statistic(
    "aligned_ranks",
    "Sequence x feedback: analysis of variance of aligned ranks",
    lambda sample, _: structure(sample.by_condition, sample.all_participants),
    of="effect",
    columns=(
        ReportColumn("n", "n", str),
        ReportColumn("F", "f"),
        ReportColumn("df", "df", lambda df: f"{df[0]:.0f}, {df[1]:.0f}"),
        ReportColumn("p", "p", p_value),
        ReportColumn("epsilon", "epsilon"),
        ReportColumn("corrected p", "p_corrected", p_value),
        ReportColumn("partial eta²", "partial_eta_squared", number),
    ),
    assumes="The analysis of variance of aligned ranks looks at sequences and feedbacks together, for participants who answered "
    "every trial. It assumes sphericity (equal variances of all differences); the "
    "corrected p does not. An interaction means that the feedbacks differ more for some "
    "sequences than for others.",
    warn=_warnings,
    rows=lambda found: found["effects"] if found else {},
    key="structure",
)
