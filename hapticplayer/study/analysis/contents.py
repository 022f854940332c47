"""The contents of the report of ratings."""

from collections.abc import Iterator, Mapping
from typing import Any

from hapticplayer.errors import counted
from hapticplayer.study.analysis.analysis import (
    Analysis,
    AnalysisOptions,
    missing,
    nothing_valid,
    warnings_of,
)
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
    numbered,
)
from hapticplayer.study.analysis.conduct_report import (
    feedback_conditions,
    identity,
    order_balance,
    people,
    playback,
)
from hapticplayer.study.analysis.course_report import course_blocks
from hapticplayer.study.analysis.describing import Summary
from hapticplayer.study.analysis.methods import (
    computed_with,
    methods,
    references,
    works,
)
from hapticplayer.study.analysis.ordinal_mixed import EFFECTS_FIGURE, known_effects
from hapticplayer.study.analysis.scores import factors_figure
from hapticplayer.study.analysis.sequence_factor_tests import (
    effects_at_levels,
    effects_figure,
    levels_figure,
)
from hapticplayer.study.analysis.statistic import (
    ReportColumn,
    Statistic,
    interval,
    listed,
    number,
)
from hapticplayer.study.analysis.trial_force_report import trial_force_blocks
from hapticplayer.study.definition import QOE

_NO_INTERVAL = (
    "CI: confidence interval, by bootstrap; -: all values are equal, so that no resample "
    "differs."
)
_MEANS = (
    "Means and standard deviations describe ratings as if the steps of the scale were equally wide. Medians and "
    "quartiles do not assume this. Intervals of means are percentile bootstrap intervals, "
    "which are somewhat too narrow for fewer than about 20 participants."
)


def contents(analysis: Analysis) -> Iterator[ReportBlock]:
    """Yield the parts of the report, with numbers of tables and figures."""
    yield from numbered(_contents(analysis))


def _contents(analysis: Analysis) -> Iterator[ReportBlock]:
    is_empty = analysis.scores.is_empty
    if is_empty:
        yield Paragraph(nothing_valid(missing(analysis)))
    yield from identity(analysis.answers)
    yield from people(analysis.answers)
    yield from feedback_conditions(analysis.answers)
    yield from order_balance(analysis.answers)
    yield from _answers(analysis)
    yield Heading("Warnings")
    warned = warnings_of(analysis)
    for text in warned or ["No warnings."]:
        yield Paragraph(text)
    described = () if is_empty else tuple(methods(analysis))
    yield from described
    results = () if is_empty else tuple(_results(analysis))
    yield from results
    yield from playback(analysis.answers, analysis.scores.feedbacks)
    yield from trial_force_blocks(analysis.answers, analysis.scores.feedbacks)
    if not is_empty:
        yield from _assumptions(analysis)
        yield from references(works(analysis), (*described, *results))
    yield from reproducibility(analysis.options)


def _results(analysis: Analysis) -> Iterator[ReportBlock]:
    yield Heading("Means and standard deviations")
    yield from _figures(analysis)
    yield from _means(analysis)
    yield Heading("Tests")
    of_all = analysis.statistics.items()
    yield from (_table(one, analysis.found[name]) for name, one in of_all)
    yield from course_blocks(analysis.answers, analysis.first_order)


def _assumptions(analysis: Analysis) -> Iterator[ReportBlock]:
    yield Heading("Assumptions of the tests")
    yield Paragraph(_MEANS)
    for statistic in analysis.statistics.values():
        if statistic.assumes:
            yield Paragraph(statistic.assumes)


def reproducibility(options: AnalysisOptions) -> Iterator[ReportBlock]:
    """The provenance that reproduces the report."""
    yield Heading("Reproducibility")
    yield Paragraph(
        f"{computed_with(options)} The same answers, seed and versions give the same "
        "report to the bit; numbers.json has all results with 12 significant digits."
    )


def _answers(analysis: Analysis) -> Iterator[ReportBlock]:
    found, scores = missing(analysis), analysis.scores
    yield Heading("Answers")
    yield Paragraph(
        f"{counted(found['participants'], 'participant')} rated "
        f"{counted(len(scores.sequences), 'sequence')} x "
        f"{counted(len(scores.feedbacks), 'feedback')} x "
        f"{counted(len(scores.factors), 'factor')}. "
        f"{found['answers_missing']} of {found['answers_planned']} answers are missing "
        f"({found['of_these_invalid']} because the playback was not valid); "
        f"{found['replaced_by_repetition']} were replaced by a repetition."
    )
    if not found["answers_missing"] or scores.is_empty:
        return
    rows = (
        (
            _label(name),
            str(one["used"]),
            str(len(one["dropped"])),
            str(len(one["reduced"])),
        )
        for name, one in found["measures"].items()
    )
    head = ("measure", "in the tests", "left out", "with fewer sequences")
    yield ReportTable("Participants with missing answers", head, tuple(rows))


def _figures(analysis: Analysis) -> Iterator[ReportBlock]:
    measures = analysis.measures
    shown = "Bars are means, error bars standard deviations, lines participants."
    if qoe := measures.get(QOE):
        yield ReportFigure(
            "qoe-by-sequence",
            f"QoE by sequence and feedback. {shown}",
            _described({**qoe.conditions, "all sequences": qoe.feedbacks}),
        )
    for limits, factors in analysis.scores.by_range().items():
        yield ReportFigure(
            factors_figure(analysis.scores, limits),
            f"{listed(factors)} by feedback, means over the sequences. {shown}",
            _described({name: measures[name].feedbacks for name in factors}),
        )
    if effects := known_effects(analysis.found):
        yield ReportFigure(
            EFFECTS_FIGURE,
            "Differences between feedbacks in the mixed model of each measure (logit), second less "
            "first, with 95 % intervals.",
            _effects_described(effects),
        )
    for factor in analysis.scores.sequence_factors:
        levels = analysis.scores.levels_of(factor)
        name = analysis.scores.measures[0]
        yield ReportFigure(
            levels_figure(factor),
            f"{_label(name)} by {factor} and feedback, means over the sequences of each level. "
            f"{shown}",
            _described({level: measures[name].levels[level] for level in levels}),
        )
        if effects := effects_at_levels(analysis.found, levels):
            yield ReportFigure(
                effects_figure(factor),
                f"Differences between feedbacks at each level of {factor}, in the mixed model of "
                "each measure (logit), second less first, with 95 % intervals.",
                _effects_described(effects),
            )


def _effects_described(effects: Mapping[str, Mapping[str, Any]]) -> str:
    pairs = (
        f"{_label(measure)}, {pair}: {number(part['estimate'])} {interval(part['interval'])}"
        for measure, one in effects.items()
        for pair, part in one.items()
    )
    return f"Points with intervals. {'; '.join(pairs)}."


def _described(groups: Mapping[str, Mapping[str, Summary]]) -> str:
    """Return the bars of a figure in words."""
    bars = (
        f"{name}: "
        + ", ".join(
            f"{feedback} {number(one.mean)} (SD {number(one.sd)})"
            for feedback, one in group.items()
        )
        for name, group in groups.items()
    )
    return f"Bar chart of means. {'; '.join(bars)}."


def _means(analysis: Analysis) -> Iterator[ReportBlock]:
    measures, scores = analysis.measures, analysis.scores
    yield _summaries(
        "Means over the sequences by feedback",
        "measure: feedback",
        {_label(name): one.feedbacks for name, one in measures.items()},
        ": ",
    )
    for factor in scores.sequence_factors:
        groups = {
            f"{_label(name)}: {level}": one.levels[level]
            for name, one in measures.items()
            for level in scores.levels_of(factor)
        }
        title = f"Means over the sequences of each level of {factor}, by feedback"
        yield _summaries(title, f"measure: {factor}, feedback", groups)
    for name, one in measures.items():
        title = f"{_label(name)} by condition, all answers"
        yield _summaries(title, "condition", one.conditions)


def _summaries(
    title: str,
    first: str,
    groups: Mapping[str, Mapping[str, Summary]],
    mark: str = ", ",
) -> ReportTable:
    """A row for each group and feedback; none where nobody has answered."""
    head = (first, "n", "mean", "95 % CI", "SD", "median", "quartiles", "range")
    is_known = any(one.n for group in groups.values() for one in group.values())
    rows = (
        _summary_row(f"{name}{mark}{feedback}", one)
        for name, group in groups.items()
        for feedback, one in group.items()
    )
    return ReportTable(title, head, tuple(rows) if is_known else (), _NO_INTERVAL)


def _label(measure: str) -> str:
    return "QoE" if measure == QOE else measure


def _summary_row(name: str, one: Summary) -> tuple[str, ...]:
    def pair(low: float | None, high: float | None) -> str:
        return interval(None if low is None or high is None else (low, high))

    return (
        name,
        str(one.n),
        number(one.mean),
        pair(one.mean_low, one.mean_high),
        number(one.sd),
        number(one.median),
        pair(one.q1, one.q3),
        pair(one.low, one.high),
    )


def _table(statistic: Statistic, found: dict[str, object]) -> ReportTable:
    """Return the table of a statistic from its results by measure."""
    parts = {
        f"{_label(measure)}: {name}" if name else _label(measure): part
        for measure, one in found.items()
        for name, part in statistic.rows(one).items()
    }
    columns = statistic.columns
    if not columns and parts:
        columns = tuple(
            ReportColumn(key, key, str) for key in next(iter(parts.values()))
        )
    rows = tuple(
        (name, *(column.text(part.get(column.key)) for column in columns))
        for name, part in parts.items()
    )
    heads = (column.head for column in columns)
    family = statistic.holm_family(found)
    corrected = f"p (Holm) is corrected over {family}." if family else ""
    note = f"{statistic.note} {corrected}".strip()
    return ReportTable(statistic.title, (statistic.of, *heads), rows, note)
