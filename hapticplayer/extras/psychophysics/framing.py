"""The parts that reports of all kinds of these trials have."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from hapticplayer.errors import counted
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    numbered,
)
from hapticplayer.study.analysis.conduct_report import (
    feedback_conditions,
    identity,
    order_balance,
    people,
    playback,
)
from hapticplayer.study.analysis.contents import reproducibility
from hapticplayer.study.analysis.methods import references
from hapticplayer.study.analysis.question_report import question_summary
from hapticplayer.study.analysis.scale_report import scale_summary
from hapticplayer.study.analysis.trial_force_report import (
    trial_force_blocks,
    trial_force_summary,
)
from hapticplayer.study.answers import Answers

FEW = 6
"""Participants, below which an interval does not generalise."""


class Findings(NamedTuple):
    """What one kind of trials tells.

    Attributes:
        counted: which answers were used.
        warnings: one sentence each.
        methods: one paragraph each.
        results: of the analysis.
        assumptions: one paragraph each.
        works: that may be cited.
    """

    counted: str
    warnings: list[str]
    methods: tuple[str, ...]
    results: Iterable[ReportBlock]
    assumptions: tuple[str, ...]
    works: tuple[str, ...]


def contents(
    answers: Answers, options: AnalysisOptions, found: Findings
) -> Iterator[ReportBlock]:
    """Yield the parts of the report, with numbers of tables and figures."""
    yield from numbered(_contents(answers, options, found))


def _contents(
    answers: Answers, options: AnalysisOptions, found: Findings
) -> Iterator[ReportBlock]:
    yield from identity(answers)
    yield from people(answers)
    yield from feedback_conditions(answers)
    yield from order_balance(answers)
    yield Heading("Answers")
    yield Paragraph(found.counted)
    yield Heading("Warnings")
    for text in found.warnings or ["No warnings."]:
        yield Paragraph(text)
    methods: tuple[ReportBlock, ...] = (
        Heading("Methods"),
        *(Paragraph(text) for text in found.methods),
    )
    yield from methods
    yield from found.results
    yield from playback(answers, answers.feedbacks)
    yield from trial_force_blocks(answers, answers.feedbacks)
    yield Heading("Assumptions")
    for text in found.assumptions:
        yield Paragraph(text)
    yield from references(found.works, methods)
    yield from reproducibility(options)


def summary(
    answers: Answers, options: AnalysisOptions, found: Findings
) -> dict[str, Any]:
    """What all analyses have as JSON."""
    return {
        "scales": scale_summary(answers),
        "questions": question_summary(answers),
        "felt": trial_force_summary(answers),
        "warnings": found.warnings,
        "provenance": options.provenance(),
    }


def few_people(answers: Answers) -> Iterator[str]:
    """Warn of what could not be read, and of few participants."""
    yield from answers.notices
    count = len(answers.participants)
    if count < FEW:
        yield (
            f"With {counted(count, 'participant')} intervals are too narrow and do not "
            "generalise."
        )
    if len(answers.feedbacks) > 1:
        yield "Answers to all feedbacks are pooled."
