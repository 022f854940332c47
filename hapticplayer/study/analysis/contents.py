"""The contents of the report, independent of its format."""

from collections.abc import Iterator
from dataclasses import dataclass

from hapticplayer.study.analysis.analysis import (
    STATISTICS,
    Analysis,
    AnalysisOptions,
    missing,
    warnings_of,
)
from hapticplayer.study.analysis.describing import Summary
from hapticplayer.study.analysis.scores import QOE
from hapticplayer.study.analysis.statistic import (
    ReportColumn,
    Statistic,
    interval,
    number,
)

_MEANS = (
    "Means and standard deviations describe ratings as if the steps of the scale were equally wide. Medians and "
    "quartiles do not assume this. Intervals of means are percentile bootstrap intervals, "
    "which are somewhat too narrow for fewer than about 20 participants."
)


@dataclass(frozen=True, slots=True)
class Heading:
    """The title of a part."""

    text: str


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A paragraph."""

    text: str


@dataclass(frozen=True, slots=True)
class ReportTable:
    """A table of texts; the first column names the rows."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class ReportFigure:
    """A figure by its name."""

    name: str
    caption: str


ReportBlock = Heading | Paragraph | ReportTable | ReportFigure


def contents(analysis: Analysis) -> Iterator[ReportBlock]:
    """Yield the parts of the report."""
    yield from _people(analysis)
    yield Heading("Warnings")
    warned = warnings_of(analysis)
    for text in warned or ["No warnings."]:
        yield Paragraph(text)
    yield Heading("Figures")
    yield ReportFigure("qoe-by-sequence", "QoE by sequence and feedback")
    yield ReportFigure(
        "factors-by-feedback", "Factors by feedback, mean over the sequences"
    )
    yield Heading("Means and standard deviations")
    yield from _means(analysis)
    yield Heading("Tests")
    for name, statistic in STATISTICS.items():
        yield _table(statistic, analysis.found[name])
    yield Heading("Assumptions of the tests")
    yield Paragraph(_MEANS)
    for statistic in STATISTICS.values():
        if statistic.assumes:
            yield Paragraph(statistic.assumes)
    yield from made_with(analysis.options)


def made_with(options: AnalysisOptions) -> Iterator[ReportBlock]:
    """Yield versions and options, which reproduce the report."""
    yield Heading("Reproducibility")
    made = options.provenance()
    versions = ", ".join(f"{k} {v}" for k, v in made["versions"].items())
    yield Paragraph(
        f"{made['program']}; {versions}. Seed {made['seed']}, {made['resamples']} "
        "resamples, intervals of 95 %. The same answers, seed and versions give the "
        "same report to the bit."
    )


def _people(analysis: Analysis) -> Iterator[ReportBlock]:
    found, scores = missing(analysis), analysis.scores
    used = sum(scores.used_before.values())
    yield Heading("Participants and answers")
    yield Paragraph(
        f"{found['participants']} participants, {used} of them had used the device "
        f"before; {len(scores.sequences)} sequences x {len(scores.feedbacks)} feedbacks "
        f"x {len(scores.factors)} factors. {found['answers_missing']} of "
        f"{found['answers_planned']} answers are missing "
        f"({found['of_these_not_sound']} because the playback was not sound); "
        f"{found['replaced_by_repetition']} were replaced by a repetition. QoE of a "
        "condition is the sum of its factors; the tests take the mean over the "
        "sequences for each participant and feedback."
    )


def _means(analysis: Analysis) -> Iterator[ReportBlock]:
    head = ("n", "mean", "95 %", "SD", "median", "quartiles", "range")
    for name, one in analysis.measures.items():
        rows = (_summary_row(*item) for item in one.feedbacks.items())
        yield ReportTable(_label(name), ("feedback", *head), tuple(rows))
    for name, one in analysis.measures.items():
        rows = (
            _summary_row(f"{sequence}, {feedback}", summary)
            for sequence, by_feedback in one.conditions.items()
            for feedback, summary in by_feedback.items()
        )
        title = f"{_label(name)} by condition, all answers"
        yield ReportTable(title, ("condition", *head), tuple(rows))


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
    return ReportTable(statistic.title, (statistic.of, *heads), rows)
