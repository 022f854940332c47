"""Measures by a cumulative-link mixed model: feedbacks fixed, people and clips random.

People may prefer different feedbacks: without an intercept of people with each feedback
0.21 of simulated studies without an effect had p < 0.05, with it 0.06. Pairs are tested
by t, with the degrees of freedom of people by feedbacks: 0.94 of the intervals of 15 such
people hold the truth, 0.92 by z.

Answers on a scale are ordered, not numbers: the model says how far each feedback moves a
latent opinion that the thresholds of the scale cut into answers (Liddell and Kruschke
2018). Sums, scores and other numbers are cut into classes, which leaves the differences
as they are: neighbouring steps may be joined (McCullagh 1980).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any

import numpy as np
import scipy

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.cumulative_link import (
    Estimates,
    FittedModel,
    LinkFunction,
    OrderedAnswers,
    estimate,
    fit,
    level_shares,
)
from hapticplayer.study.analysis.random_intercepts import Indices
from hapticplayer.study.analysis.references import (
    CHRISTENSEN_2019,
    LIDDELL_2018,
    MCCULLAGH_1980,
)
from hapticplayer.study.analysis.scores import Sample
from hapticplayer.study.analysis.statistic import (
    Found,
    Holm,
    ReportColumn,
    Statistic,
    interval,
    listed,
    number,
    p_value,
)

EFFECTS_FIGURE = "effects-by-measure"
MOST_CLASSES = 10
"""Of a number that is no item; ten lose some 1 % of what all its values tell."""
_MOST_CUTS = 4
"""At which a scale is cut in two, spread over its steps."""
_FAR = 7.0
"""Standard errors and deviations beyond this, in those of a latent answer, are no estimates:
errors are 14 or more where answers are apart, elsewhere 3.5 at most."""
WITHOUT_ESTIMATE = (
    "nearly all answers to a feedback are at an end of the scale or apart from those to "
    "another one, or each person's are alike"
)
_FAR_ODDS = math.log(100.0)
_LEAST_PEOPLE = 3
_CELLS = "participant x feedback"


def ordered_answers(
    values: Floats, *, is_item: bool = True, sites: Sequence[str] = ()
) -> OrderedAnswers | None:
    """The answers (P, S, F), NaN where missing; None if no model fits them.

    The levels are the steps that were used, or classes where it is no item; `sites` are
    those of the participants, if there are several.
    """
    people, sequences, feedbacks = np.nonzero(~np.isnan(values))
    given = values[people, sequences, feedbacks]
    steps, levels = np.unique(given, return_inverse=True)
    if not is_item and len(steps) > MOST_CLASSES:
        shares = (scipy.stats.rankdata(given) - 0.5) / len(given)
        steps, levels = np.unique(np.floor(MOST_CLASSES * shares), return_inverse=True)
    if len(steps) < 2:
        return None
    if len(set(people)) < _LEAST_PEOPLE or len(set(feedbacks)) < values.shape[2]:
        return None
    design = (feedbacks[:, None] == np.arange(1, values.shape[2])).astype(np.float64)
    groups = tuple(groups_of(values, sites).values())
    cells = np.unique(people * values.shape[2] + feedbacks, return_inverse=True)[1]
    if cells.max() + 1 < len(cells):  # somebody answered twice to a feedback
        return OrderedAnswers(levels, design, (cells, *groups), nested=2)
    return OrderedAnswers(levels, design, groups)


def groups_of(values: Floats, sites: Sequence[str] = ()) -> dict[str, Indices]:
    """What has a random intercept, by name, for each answer of (P, S, F)."""
    people, sequences, _ = np.nonzero(~np.isnan(values))
    by_name = {"participant": people, "sequence": sequences}
    if sites:
        by_name["site"] = np.unique(sites, return_inverse=True)[1][people]
    return {
        name: np.unique(group, return_inverse=True)[1]
        for name, group in by_name.items()
        if len(set(group)) > 1
    }


def compare(sample: Sample, link: LinkFunction) -> Found | None:
    """Effect of the feedbacks on a measure; None where no model fits.

    `pairs` are differences on the latent scale, second less first; `at_cuts` the same
    from the answers above and below single steps of the scale, with the logit link.
    """
    values, sites = sample.by_condition, sample.sites
    answers = ordered_answers(values, is_item=sample.is_item, sites=sites)
    if answers is None:
        return None
    full, together = likelihood_ratio(answers, link)
    names = [*[_CELLS] * (answers.nested - 1), *groups_of(values, sites)]
    shifts = (0.0, *full.effects)
    return {
        "n": len(answers.levels),
        "levels": int(answers.levels.max()) + 1,
        "log_likelihood": full.log_likelihood,
        **together,
        "deviations": dict(zip(names, full.deviations.tolist(), strict=True)),
        "thresholds": full.thresholds.tolist(),
        "shares": {
            name: level_shares(full, shift).tolist()
            for name, shift in zip(sample.feedbacks, shifts, strict=True)
        },
        "pairs": _pairs(sample, answers, full),
    }


def likelihood_ratio(
    answers: OrderedAnswers, link: LinkFunction
) -> tuple[FittedModel, Found]:
    """The model, and the test of all its effects together."""
    nothing = replace(answers, design=answers.design[:, :0])
    none = estimate(nothing, link)
    full = fit(answers, link, none.with_effects(answers.design))
    return full, ratio(full, none)


def ratio(full: Estimates, less: Estimates) -> Found:
    """The likelihood ratio test of the effects that `less` has not."""
    df = len(full.effects) - len(less.effects)
    chi2 = max(0.0, 2.0 * (full.log_likelihood - less.log_likelihood))
    p_all = float(scipy.stats.chi2.sf(chi2, df))
    return {"chi2": chi2, "df": df, "p": None, "p_all": p_all}


def _pairs(
    sample: Sample, answers: OrderedAnswers, full: FittedModel
) -> dict[str, Found]:
    at_cuts = list(_at_cuts(answers, full)) if full.link is LinkFunction.LOGIT else []
    found = {}
    for i, j in combinations(range(len(sample.feedbacks)), 2):
        known = [one[j] - one[i] for one in at_cuts if not np.isnan(one[[i, j]]).any()]
        found[f"{sample.feedbacks[i]}-{sample.feedbacks[j]}"] = {
            **difference(full, i, j),
            "at_cuts": [min(known), max(known)] if known else None,
        }
    return found


def _at_cuts(answers: OrderedAnswers, full: FittedModel) -> Iterator[Floats]:
    """Effects (F,) by the answers above and below single steps; NaN where all are alike.

    Answers to such a feedback say nothing of the others.
    """
    last, count = int(answers.levels.max()), 1 + len(full.effects)
    feedbacks = answers.design @ np.arange(1, count)
    for step in np.rint(np.linspace(1, last, min(last, _MOST_CUTS))).astype(int):
        above = answers.levels >= step
        shares = np.array([above[feedbacks == one].mean() for one in range(count)])
        known = np.flatnonzero((shares > 0.0) & (shares < 1.0))
        if len(known) < 2:
            continue
        kept = np.isin(feedbacks, known)
        groups = (np.unique(g[kept], return_inverse=True)[1] for g in answers.groups)
        design = (feedbacks[kept, None] == known[1:]).astype(np.float64)
        of = above[kept].astype(np.intp), design, tuple(groups), answers.nested
        start = full.at_cut(step - 1) if kept.all() else None
        found = estimate(OrderedAnswers(*of), full.link, start)
        effects = np.full(count, np.nan)
        if found.deviations.max() < _FAR * full.link.spread:
            effects[known] = np.append(0.0, found.effects)
        yield effects


def difference(model: FittedModel, i: int, j: int) -> Found:
    """Feedback j less i, as `contrast`."""
    return contrast(model, apart(i, j, len(model.effects) + 1)[1:])


def apart(i: int, j: int, count: int) -> Floats:
    """Weights (count,) of entry j less entry i."""
    weights = np.zeros(count)
    weights[i], weights[j] = -1.0, 1.0
    return weights


def contrast(model: FittedModel, of_effects: Floats) -> Found:
    """A sum of effects by Wald's interval and test; None where it is not determined."""
    used = np.flatnonzero(of_effects)  # others may not be determined
    weights, covariance = of_effects[used], model.covariance[np.ix_(used, used)]
    estimate = float(weights @ model.effects[used])
    error = math.sqrt(max(0.0, float(weights @ covariance @ weights)))
    far = _FAR * model.link.spread
    if not 0.0 < error <= far or model.deviations.max() > far:
        return dict.fromkeys(("estimate", "error", "interval", "t", "df", "p"))
    by_t = scipy.stats.t(model.degrees)
    reach = float(by_t.isf(0.025)) * error
    return {
        "estimate": estimate,
        "error": error,
        "interval": [estimate - reach, estimate + reach],
        "t": estimate / error,
        "df": model.degrees if math.isfinite(model.degrees) else None,
        "p": float(2.0 * by_t.sf(abs(estimate) / error)),
    }


def _rows(found: Found | None) -> dict[str, Found]:
    return {"": found, **found["pairs"]} if found else {}


def _warnings(found: dict[str, Any]) -> list[str]:
    unknown = {
        measure: [
            pair for pair, part in one["pairs"].items() if part["estimate"] is None
        ]
        for measure, one in found.items()
        if one
    }
    return [
        f"{measure}: the mixed model cannot estimate {listed(pairs)}: {WITHOUT_ESTIMATE}."
        for measure, pairs in unknown.items()
        if pairs
    ]


def _methods(_found: dict[str, Any]) -> str:
    return (
        "Each measure was analysed by a cumulative-link mixed model (logit link, and again with "
        "probit; McCullagh, 1980) with the feedback as fixed effect, flexible thresholds, and random "
        "intercepts of participants, of participants with each feedback, of sequences, and of "
        "sites if there are several, fitted by maximum likelihood with "
        "Laplace's approximation (as clmm of R's ordinal; Christensen, 2019). The effect of "
        "the feedback was tested by a likelihood ratio, pairs by Wald's t, with 95 % Wald "
        "intervals; its degrees of freedom are those of participants by feedbacks, (participants - "
        "1) x (feedbacks - 1) where no answer is missing. Answers to single items entered as ordered steps, not as numbers (Liddell "
        f"and Kruschke, 2018); sums, scores and other numbers in up to {MOST_CLASSES} "
        "ordered classes of about equal size, by which the differences keep their meaning."
    )


def _odds(value: float | None) -> str:
    """An odds ratio; one far from 1 is hardly known."""
    if value is None or abs(value) <= _FAR_ODDS:
        return number(None if value is None else math.exp(value))
    return "> 100" if value > 0.0 else "< 0.01"


def _count(value: int | None) -> str:
    return "-" if value is None else str(value)


ESTIMATE_COLUMNS = (
    ReportColumn("chi²", "chi2"),
    ReportColumn("df", "df", _count),
    ReportColumn("p (all)", "p_all", p_value),
    ReportColumn("difference", "estimate"),
    ReportColumn("95 % CI", "interval", interval),
)
TEST_COLUMNS = (
    ReportColumn("t", "t"),
    ReportColumn("p", "p", p_value),
    ReportColumn("p (Holm)", "p_holm", p_value),
)


def _statistic(link: LinkFunction) -> Statistic:
    is_logit = link is LinkFunction.LOGIT
    odds = ReportColumn("odds ratio", "estimate", _odds)
    at_cuts = ReportColumn("at single cuts", "at_cuts", interval)
    return Statistic(
        f"ordinal_{link.value}",
        f"Cumulative-link mixed model of ordered answers ({link.value})",
        lambda sample, _: compare(sample, link),
        of="measure: pair",
        columns=(
            ReportColumn("n", "n", _count),
            *ESTIMATE_COLUMNS,
            *((odds,) if is_logit else ()),
            *TEST_COLUMNS,
            *((at_cuts,) if is_logit else ()),
        ),
        note="Row of a measure: likelihood ratio of all feedbacks. Sums and scores entered in "
        "up to ten classes. df of a pair: of t. Difference: second feedback "
        "less first, on the latent scale."
        + (
            f" At single cuts: smallest and largest of the same from answers above or below a "
            f"step alone, at up to {_MOST_CUTS} steps."
            if is_logit
            else ""
        ),
        assumes="The cumulative-link mixed model assumes that a feedback moves all steps of the scale "
        "by the same latent amount (proportional odds), that people, people with each "
        "feedback, and sequences differ by normally distributed amounts, and that answers are otherwise independent. Where "
        "the differences at single cuts have different signs, the first does not hold. Missing answers "
        "may depend on feedback, person and sequence, but not on what would have been answered."
        if is_logit
        else "",
        warn=_warnings if is_logit else lambda _found: (),
        rows=_rows,
        holm=Holm("p", "each measure"),
        methods=_methods if is_logit else lambda _found: "",
        references=(CHRISTENSEN_2019, LIDDELL_2018, MCCULLAGH_1980),
    )


def known_effects(found: dict[str, dict[str, Any]]) -> dict[str, dict[str, Found]]:
    """The pairs with an estimate, by measure, from the results of all statistics."""
    by_measure = {
        measure: {
            pair: part
            for pair, part in one["pairs"].items()
            if part["estimate"] is not None
        }
        for measure, one in found[ORDINAL_LOGIT.name].items()
        if one
    }
    return {measure: pairs for measure, pairs in by_measure.items() if pairs}


ORDINAL_LOGIT = _statistic(LinkFunction.LOGIT)
ORDINAL_PROBIT = _statistic(LinkFunction.PROBIT)
