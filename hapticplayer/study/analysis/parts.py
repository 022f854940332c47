"""The analysis of a study of either type of trial, and the parts of its report."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hapticplayer.study.analysis import consistency_report, contents, figures, tables
from hapticplayer.study.analysis.analysis import Analysis, Choices, Progress, analyse
from hapticplayer.study.analysis.consistency import (
    ConsistencyAnalysis,
    analyse_consistency,
)
from hapticplayer.study.analysis.summary import summary
from hapticplayer.study.answers import Answers

if TYPE_CHECKING:
    from matplotlib.figure import Figure

StudyAnalysis = Analysis | ConsistencyAnalysis


@dataclass(frozen=True, slots=True)
class Parts:
    """What a report is made of.

    Attributes:
        numbers: as JSON.
        blocks: of the text.
        draw: gives the figures by name.
        tables: rows by name of the CSV file.
    """

    numbers: dict[str, Any]
    blocks: tuple[contents.Block, ...]
    draw: Callable[[], dict[str, "Figure"]]
    tables: Mapping[str, Iterable[list[Any]]]


def analyse_study(
    answers: Answers,
    choices: Choices | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> StudyAnalysis:
    """Analyse ratings, or judgements where these are what was asked for.

    Raises:
        InputError: when the answers do not fit their own design.
    """
    run = analyse_consistency if answers.judgements else analyse
    return run(answers, choices, progress)


def parts_of(found: StudyAnalysis) -> Parts:
    """Return the parts of a report."""
    if isinstance(found, ConsistencyAnalysis):
        return Parts(
            consistency_report.summary(found),
            tuple(consistency_report.contents(found)),
            lambda: consistency_report.figures(found),
            consistency_report.tables(found),
        )
    numbers = summary(found)
    blocks = tuple(contents.contents(found))
    made = tables.tables(found, numbers)
    return Parts(numbers, blocks, lambda: figures.figures(found), made)
