"""What an analysis hands to report, window and command line, for each kind of trials."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from hapticplayer.errors import Progress
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.blocks import ReportBlock
from hapticplayer.study.answers import Answers

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class ReportParts:
    """The parts of a report.

    Attributes:
        answers: that were analysed.
        mark: on each page and figure where participants are simulated; else empty.
        numbers: as JSON, with 12 significant digits.
        lines: the results in words, for a terminal.
        blocks: of the text.
        draw: returns the figures by name.
        tables: rows by name of the CSV file.
        is_empty: whether no answer can be used: there is nothing to publish.
    """

    answers: Answers
    mark: str
    numbers: dict[str, Any]
    lines: tuple[str, ...]
    blocks: tuple[ReportBlock, ...]
    draw: Callable[[], dict[str, "Figure"]]
    tables: Mapping[str, Iterable[list[Any]]]
    is_empty: bool = False


Analyse = Callable[[Answers, AnalysisOptions | None, Progress], ReportParts]


class AnalysisKind(NamedTuple):
    """The analysis of a kind of trials.

    Attributes:
        name: a `TrialKind`.
        home: of its `Analyse`, as "module:function".
    """

    name: str
    home: str
