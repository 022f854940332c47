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
from hapticplayer.study.analysis.references import GREENHOUSE_1959, WOBBROCK_2011
from hapticplayer.study.analysis.statistic import (
    ALPHA,
    Found,
    ReportColumn,
    Statistic,
    degrees,
    listed,
    number,
    p_value,
)

EFFECTS = ("sequence", "feedback", "interaction")
_DECIMALS = 9  # so that aligned responses that differ by rounding are ties
_LEAST = 2
_NOTHING = 1e-18  # share of the sum of squares that is rounding alone


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
    """Return the effect of the analysis of variance of ranks (P, S, F).

    Each participant's responses are projected on the effect; its sum of squares is that
    of their mean, the error's that of the differences from it (Winer 1971, 7.2). All
    factors are within participants and no cell is empty, so that no model has to be
    fitted: the work grows with the number of responses.
    """
    parts = _projected(ranks, name)
    n, levels = len(ranks), np.array(ranks.shape[1:]) - 1
    degrees = {"sequence": levels[0], "feedback": levels[1]}
    df1 = int(degrees.get(name, levels.prod()))
    df2 = df1 * (n - 1)
    mean = parts.mean(axis=0)
    apart = parts - mean
    error, effect = float((apart**2).sum()), n * float((mean**2).sum())
    if error <= _NOTHING * float((ranks**2).sum()):
        return None
    covariance = apart.T @ apart
    epsilon = error**2 / (df1 * float((covariance**2).sum()))
    f = effect / error * (n - 1)
    return {
        "n": n,
        "f": f,
        "df": (float(df1), float(df2)),
        "p": float(scipy.stats.f.sf(f, df1, df2)),
        "epsilon": epsilon,
        "p_corrected": float(scipy.stats.f.sf(f, df1 * epsilon, df2 * epsilon)),
        "partial_eta_squared": effect / (effect + error),
    }


def _projected(ranks: Floats, name: str) -> Floats:
    """The share (P, levels) of one effect in ranks (P, S, F), without all others."""
    centred = ranks - ranks.mean(axis=(1, 2), keepdims=True)
    sequence, feedback = centred.mean(axis=2), centred.mean(axis=1)
    if name == "sequence":
        return np.asarray(sequence)
    if name == "feedback":
        return np.asarray(feedback)
    left = centred - sequence[:, :, None] - feedback[:, None, :]
    return np.asarray(left.reshape(len(ranks), -1))


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
    "Sequence x feedback: analysis of variance of aligned ranks, all answers",
    lambda sample, _: structure(sample.by_condition, sample.all_participants),
    of="effect",
    columns=(
        ReportColumn("n", "n", str),
        ReportColumn("F", "f"),
        ReportColumn("df", "df", degrees),
        ReportColumn("p", "p", p_value),
        ReportColumn("epsilon", "epsilon"),
        ReportColumn("p (epsilon)", "p_corrected", p_value),
        ReportColumn("partial eta²", "partial_eta_squared", number),
    ),
    note="epsilon: of Greenhouse and Geisser; p (epsilon) is of the degrees of freedom "
    "multiplied by it.",
    assumes="The analysis of variance of aligned ranks looks at sequences and feedbacks together, for participants who answered "
    "every trial. It assumes sphericity (equal variances of all differences); the "
    "corrected p does not. An interaction means that the feedbacks differ more for some "
    "sequences than for others.",
    warn=_warnings,
    rows=lambda found: found["effects"] if found else {},
    key="structure",
    methods=lambda _: (
        "Sequences and feedbacks together were analysed by the aligned rank "
        "transform (Wobbrock et al., 2011): ranks of the answers without all effects but one, "
        "mid-ranks for ties, in an analysis of variance with both factors within "
        "participants. Degrees of freedom were corrected for non-sphericity by the epsilon of "
        "Greenhouse and Geisser (1959)."
    ),
    references=(WOBBROCK_2011, GREENHOUSE_1959),
)
