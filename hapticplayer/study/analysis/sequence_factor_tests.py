"""Factors in which sequences differ, such as the viewpoint, and their feedbacks.

Three statistics answer whether the levels differ, and whether the feedbacks differ more at
one of them: the analysis of aligned ranks and the signed-rank test of means over the
sequences of a level, and the cumulative-link mixed model of all answers.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.aligned_ranks import ALIGNED_RANKS, structure
from hapticplayer.study.analysis.cumulative_link import (
    Estimates,
    FittedModel,
    LinkFunction,
    OrderedAnswers,
    estimate,
    fit,
)
from hapticplayer.study.analysis.ordinal_mixed import (
    ESTIMATE_COLUMNS,
    ORDINAL_LOGIT,
    TEST_COLUMNS,
    WITHOUT_ESTIMATE,
    apart,
    contrast,
    groups_of,
    ordered_answers,
    ratio,
)
from hapticplayer.study.analysis.random_intercepts import Indices
from hapticplayer.study.analysis.rank_tests import WILCOXON, signed_rank
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.statistic import Found, Statistic, listed

LEAST_CLIPS = 5
"""Sequences of a level below which its effect hardly holds for other sequences."""


def interaction_of(factor: str) -> str:
    return f"{factor} x feedback"


def levels_figure(factor: str) -> str:
    return f"ratings-by-{factor}"


def effects_figure(factor: str) -> str:
    return f"effects-by-{factor}"


def _each(sample: Sample, compute: Callable[[Sample, str], Found]) -> Found | None:
    """The results of each factor, by part; None without any."""
    found: Found = {}
    for factor in sample.sequence_factors:
        found |= compute(sample, factor)
    return found or None


# --- ranks ------------------------------------------------------------------------


def aligned(sample: Sample, factor: str) -> Found:
    """The effects of the factor and its interaction, of means over the sequences."""
    values = np.stack(list(sample.by_level(factor).values()), axis=1)
    found = structure(values, sample.all_participants)
    if found is None:
        return {}
    effects = found["effects"]
    return {
        factor: effects["sequence"],
        interaction_of(factor): effects["interaction"],
    }


def signed_ranks(sample: Sample, factor: str) -> Found:
    """What `level_contrasts` compares, of participants with means at all levels."""
    levels = sample.by_level(factor)
    values = np.concatenate(list(levels.values()), axis=1)  # (P, L * F)
    values = values[~np.isnan(values).any(axis=1)]
    if len(values) < 2:
        return {}
    none = np.zeros(len(values))
    contrasts = level_contrasts(sample.feedbacks, tuple(levels))
    return {
        name: signed_rank(none, values @ weights) for name, weights in contrasts.items()
    }


def level_contrasts(
    feedbacks: tuple[str, ...], levels: tuple[str, ...]
) -> dict[str, Floats]:
    """Weights (L * F,) of what is compared, by name.

    Two levels over all feedbacks, and each difference of two feedbacks at two levels.
    """
    shape, found = (len(levels), len(feedbacks)), {}
    for i, j in combinations(range(len(levels)), 2):
        of_levels, name = apart(i, j, len(levels)), f"{levels[i]}-{levels[j]}"
        means = np.broadcast_to(of_levels[:, None] / len(feedbacks), shape)
        found[name] = means.ravel()
        for k, m in combinations(range(len(feedbacks)), 2):
            weights = np.outer(of_levels, apart(k, m, len(feedbacks))).ravel()
            found[f"{feedbacks[k]}-{feedbacks[m]}, {name}"] = weights
    return found


# --- the mixed model --------------------------------------------------------------


class _FactorModels(NamedTuple):
    """The answers to a measure, to be fitted with a factor.

    Attributes:
        answers: with the feedback alone.
        people, feedbacks, levels: (n,) of each answer.
        groups: what has a random intercept anyhow.
        columns: of the feedback, the level, and both.
    """

    answers: OrderedAnswers
    people: Indices
    feedbacks: Indices
    levels: Indices
    groups: tuple[Indices, ...]
    columns: tuple[Floats, Floats, Floats]

    @classmethod
    def of(cls, sample: Sample, codes: Indices) -> "_FactorModels | None":
        """From the level of each sequence; None where no model fits."""
        values, sites = sample.by_condition, sample.sites
        answers = ordered_answers(values, is_item=sample.is_item, sites=sites)
        if answers is None:
            return None
        people, sequences, feedbacks = np.nonzero(~np.isnan(values))
        levels, of_feedback = codes[sequences], answers.design
        is_level = (levels[:, None] == np.arange(1, codes.max() + 1)).astype(np.float64)
        both = of_feedback[:, :, None] * is_level[:, None, :]
        columns = of_feedback, is_level, both.reshape(len(levels), -1)
        whole = np.concatenate([np.ones((len(levels), 1)), *columns], axis=1)
        if np.linalg.matrix_rank(whole) < whole.shape[1]:
            return None  # somewhere nobody has answered
        groups = groups_of(values, sites)
        if "participant" not in groups:
            return None
        of = people, feedbacks, levels, tuple(groups.values())
        return cls(answers, *of, columns)

    def of_design(self, within: Indices, *columns: Floats) -> OrderedAnswers:
        """With intercepts of people with each `within`, and of all three together.

        Those with one answer for each are left out.
        """
        first = self.people * (1 + within.max()) + within
        cells = self.people * (1 + self.feedbacks.max()) + self.feedbacks
        cells = cells * (1 + self.levels.max()) + self.levels
        chain = [np.unique(one, return_inverse=True)[1] for one in (cells, first)]
        chain = [one for one in chain if one.max() + 1 < len(one)]
        return replace(
            self.answers,
            design=np.concatenate(columns, axis=1),
            groups=(*chain, *self.groups),
            nested=len(chain) + 1,
        )


def mixed(sample: Sample, factor: str) -> Found:
    """Likelihood ratios of the factor and its interaction, and differences of feedbacks.

    People may prefer levels as they may prefer feedbacks: the factor is tested with
    intercepts of people with each level, all else with those of people with each feedback.
    """
    given = sample.sequence_factors[factor]
    names = tuple(dict.fromkeys(given))
    models = _FactorModels.of(sample, np.array([names.index(one) for one in given]))
    if models is None:
        return {}
    feedback, level, both = models.columns
    with_level = fit(models.of_design(models.levels, feedback, level))
    full = fit(models.of_design(models.feedbacks, feedback, level, both))
    without = models.of_design(models.levels, feedback)
    added = models.of_design(models.feedbacks, feedback, level)
    return {
        factor: _ratio(with_level, estimate(without, LinkFunction.LOGIT)),
        interaction_of(factor): _ratio(full, estimate(added, LinkFunction.LOGIT)),
        **_of_levels(with_level, names),
        **_of_feedbacks(full, sample.feedbacks, names),
    }


def _of_levels(model: FittedModel, names: tuple[str, ...]) -> Found:
    before = np.zeros(len(model.effects) - len(names) + 1)
    return {
        f"{names[i]}-{names[j]}": contrast(
            model, np.concatenate([before, apart(i, j, len(names))[1:]])
        )
        for i, j in combinations(range(len(names)), 2)
    }


def _of_feedbacks(
    model: FittedModel, feedbacks: tuple[str, ...], names: tuple[str, ...]
) -> Found:
    """Differences of two feedbacks at each level, and those between two levels."""
    found = {}
    for i, j in combinations(range(len(feedbacks)), 2):
        pair, weights = f"{feedbacks[i]}-{feedbacks[j]}", apart(i, j, len(feedbacks))
        at = [_at_level(weights[1:], level, len(names)) for level in range(len(names))]
        for name, here in zip(names, at, strict=True):
            found[f"{pair}, {name}"] = contrast(model, here)
        for k, m in combinations(range(len(names)), 2):
            found[f"{pair}, {names[k]}-{names[m]}"] = contrast(model, at[m] - at[k])
    return found


def _at_level(weights: Floats, level: int, levels: int) -> Floats:
    """A difference of feedbacks at a level: of feedbacks, levels and their products."""
    is_level = (np.arange(1, levels) == level).astype(np.float64)
    products = np.outer(weights, is_level).ravel()
    return np.concatenate([weights, np.zeros(levels - 1), products])


def _ratio(full: FittedModel, less: Estimates) -> Found:
    return {**ratio(full, less), "deviations": full.deviations.tolist()}


def effects_at_levels(
    found: Mapping[str, Mapping[str, Any]], levels: tuple[str, ...]
) -> dict[str, dict[str, Found]]:
    """The differences of feedbacks at each level with an estimate, by measure.

    Args:
        found: results of all statistics.
        levels: of a factor.
    """
    by_measure = {
        measure: {
            name: part
            for name, part in one.items()
            if part.get("estimate") is not None and name.rpartition(", ")[2] in levels
        }
        for measure, one in found[FACTOR_LOGIT.name].items()
        if one
    }
    return {measure: parts for measure, parts in by_measure.items() if parts}


# --- what the report says ---------------------------------------------------------


def _rows(found: Found | None) -> Found:
    return found or {}


def _names(found: Mapping[str, Any]) -> str:
    """The factors that were analysed, in words."""
    mark = interaction_of("")
    parts = (name for one in found.values() for name in one or ())
    ends = (name.removesuffix(mark) for name in parts if name.endswith(mark))
    return listed(list(dict.fromkeys(ends)))


def _ranks_methods(found: Mapping[str, Any]) -> str:
    return (
        f"The sequences' {_names(found)} and the feedback were analysed by the aligned rank transform (Wobbrock "
        "et al., 2011) of each participant's means over the sequences of a level, as "
        "sequences and feedbacks were."
    )


def _pairs_methods(_found: Mapping[str, Any]) -> str:
    return (
        "Levels of these factors were compared by the signed-rank test (Wilcoxon, 1945), over all "
        "feedbacks; and so was, at two levels, each difference between two feedbacks."
    )


def _mixed_methods(found: Mapping[str, Any]) -> str:
    return (
        "In a cumulative-link mixed model (logit link; Christensen, 2019) feedback, "
        f"{_names(found)} and their interaction were fixed effects. Random intercepts were of participants, "
        "of participants with each feedback, of participants with each feedback at each level, of "
        "sequences, and of sites if there are several; for the factor itself those of participants with each "
        "level took the place of those with each feedback. Factor and interaction "
        "were tested by likelihood ratios, differences by Wald's t, with the "
        "degrees of freedom of participants by what they have intercepts with, less those of the effects."
    )


def _mixed_warnings(found: dict[str, Any]) -> Iterator[str]:
    for measure, one in found.items():
        if one is None:
            yield f"{measure}: the mixed model with factors of the sequences cannot be fitted."
            continue
        unknown = [
            name for name, part in one.items() if part.get("estimate", 0.0) is None
        ]
        if unknown:
            yield (
                f"{measure}: the mixed model cannot estimate {'; '.join(unknown)}: "
                f"{WITHOUT_ESTIMATE}."
            )


FACTOR_RANKS = Statistic(
    "factor_ranks",
    "Factors of the sequences x feedback: analysis of variance of aligned ranks",
    lambda sample, _: _each(sample, aligned),
    of="effect",
    columns=ALIGNED_RANKS.columns,
    note="Of means over the sequences of each level. "
    "epsilon: of Greenhouse and Geisser; with two levels it is 1 for the factor.",
    rows=_rows,
    methods=_ranks_methods,
    references=ALIGNED_RANKS.references,
    of_factors=True,
)

FACTOR_PAIRS = Statistic(
    "factor_pairs",
    "Levels of the sequences' factors: Wilcoxon's signed-rank test",
    lambda sample, _: _each(sample, signed_ranks),
    of="levels",
    columns=WILCOXON.columns,
    note="first-second: means over all feedbacks, positive where the second level is rated "
    "higher. a-b, first-second: the difference b less a, positive where it is larger at the "
    f"second level. {WILCOXON.note}",
    rows=_rows,
    holm=WILCOXON.holm,
    methods=_pairs_methods,
    references=WILCOXON.references,
    of_factors=True,
)

FACTOR_LOGIT = Statistic(
    "factor_logit",
    "Factors of the sequences x feedback: cumulative-link mixed model (logit)",
    lambda sample, _: _each(sample, mixed),
    of="effect or difference",
    columns=(*ESTIMATE_COLUMNS, *TEST_COLUMNS),
    note="df of a difference: of t. Rows with chi²: likelihood ratio of the factor, and of its interaction with the "
    "feedback. Differences are on the latent scale, second less first: of two levels; of two feedbacks at "
    "a level; and by how much that one is larger at the second of two levels.",
    assumes="The tests of a factor are of these sequences. Its levels are seen on different "
    "sequences, so that what else these differ in belongs to the factor too, unless each level shows the same "
    f"rides; with fewer than {LEAST_CLIPS} sequences of a level the effect says little about others, and p is too small (with three, 0.09 of simulated studies without one had p < .05). That "
    "feedbacks differ more at one level is compared within sequences and people.",
    warn=_mixed_warnings,
    rows=_rows,
    holm=ORDINAL_LOGIT.holm,
    methods=_mixed_methods,
    references=ORDINAL_LOGIT.references,
    of_factors=True,
)
