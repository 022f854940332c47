"""The report of a study with either kind of trials, and its files."""

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hapticplayer import storage
from hapticplayer.errors import Message, Progress
from hapticplayer.study.analysis import (
    consistency_figures,
    consistency_report,
    contents,
    figures,
)
from hapticplayer.study.analysis.analysis import (
    STATISTICS,
    Analysis,
    AnalysisOptions,
    analyse,
    summary,
)
from hapticplayer.study.analysis.blocks import ReportBlock
from hapticplayer.study.analysis.consistency import (
    ConsistencyAnalysis,
    analyse_consistency,
)
from hapticplayer.study.analysis.describing import Summary
from hapticplayer.study.analysis.pdf import write_pdf
from hapticplayer.study.analysis.statistic import rounded
from hapticplayer.study.analysis.typesetting import page
from hapticplayer.study.answers import Answers, simulated_mark

if TYPE_CHECKING:
    from matplotlib.figure import Figure

StudyAnalysis = Analysis | ConsistencyAnalysis


@dataclass(frozen=True, slots=True)
class Parts:
    """The parts of a report.

    Attributes:
        mark: on each page and figure where participants are simulated; else empty.
        numbers: as JSON, with 12 significant digits.
        blocks: of the text.
        draw: returns the figures by name.
        tables: rows by name of the CSV file.
    """

    mark: str
    numbers: dict[str, Any]
    blocks: tuple[ReportBlock, ...]
    draw: Callable[[], dict[str, "Figure"]]
    tables: Mapping[str, Iterable[list[Any]]]


def analyse_study(
    answers: Answers,
    options: AnalysisOptions | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> StudyAnalysis:
    run = analyse_consistency if answers.judgements else analyse
    return run(answers, options, progress)


def parts_of(found: StudyAnalysis) -> Parts:
    """Return the parts of a report."""
    mark = simulated_mark(found.answers.participants)
    if isinstance(found, ConsistencyAnalysis):
        return Parts(
            mark,
            rounded(consistency_report.summary(found)),
            tuple(consistency_report.contents(found)),
            lambda: figures.marked(consistency_figures.figures(found), mark),
            consistency_report.tables(found),
        )
    return Parts(
        mark,
        rounded(summary(found)),
        tuple(contents.contents(found)),
        lambda: figures.marked(figures.figures(found), mark),
        {
            "conditions.csv": _condition_rows(found),
            "tests.csv": _test_rows(found),
            "scores.csv": _score_rows(found),
        },
    )


def write_report(
    analysis: StudyAnalysis,
    target: Path,
    title: str,
    progress: Progress = lambda _fraction, _step: None,
) -> None:
    """Write the report into a new folder, atomically.

    `report.html`, `report.pdf`, `numbers.json`, the figures as SVG, PDF and PNG, and of
    ratings `conditions.csv` (means and spreads), `tests.csv` and `scores.csv` (each
    participant's), of judgements `levels.csv` and `curves.csv`.
    """
    parts = parts_of(analysis)
    title = title.encode(errors="replace").decode()  # of a folder, in whatever bytes
    with storage.folder_written_aside(target, storage.PRIVATE_FOLDER) as aside:
        for place, (name, figure) in enumerate(parts.draw().items()):
            progress(0.2 + 0.2 * place, Message("drawing {name}", name=name))
            for suffix in figures.FORMATS:
                content = figures.image(figure, suffix)
                (aside / f"{name}{suffix}").write_bytes(content)
        svgs, pngs = (
            {path.stem: path.read_bytes() for path in sorted(aside.glob(pattern))}
            for pattern in ("*.svg", "*.png")
        )
        progress(0.6, Message("writing {file}", file="report.html"))
        _write_text(aside / "report.html", page(title, parts.mark, parts.blocks, svgs))
        progress(0.7, Message("writing {file}", file="report.pdf"))
        write_pdf(aside / "report.pdf", title, parts.mark, parts.blocks, pngs)
        progress(0.9, Message("writing the numbers"))
        storage.write_json(aside / "numbers.json", parts.numbers)
        for name, rows in parts.tables.items():
            out = io.StringIO()
            csv.writer(out, lineterminator="\n").writerows(map(rounded, rows))
            _write_text(aside / name, out.getvalue())
        for path in aside.iterdir():  # contains the answers of participants
            path.chmod(storage.PRIVATE_FILE)


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", errors="replace")


def _condition_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["measure", "sequence", "feedback", *Summary.__dataclass_fields__]
    for measure, one in analysis.measures.items():
        for sequence, part in [("all", one.feedbacks), *one.conditions.items()]:
            for feedback, described in part.items():
                yield [measure, sequence, feedback, *asdict(described).values()]


def _test_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["test", "measure", "of", "statistic", "value"]
    for test, statistic in STATISTICS.items():
        for measure, found in analysis.found[test].items():
            for name, part in statistic.rows(found).items():
                for key, value in _flat(part):
                    yield [test, measure, name, key, value]


def _flat(part: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in part.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{name}", one) for name, one in value.items())
        elif isinstance(value, list):
            yield from ((f"{key}.{place}", one) for place, one in enumerate(value))
        else:
            yield key, value


def _score_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["participant", "measure", "feedback", "mean_over_sequences"]
    for measure, one in analysis.measures.items():
        sample = one.sample
        for code, row in zip(sample.participants, sample.values, strict=True):
            for feedback, value in zip(sample.feedbacks, row.tolist(), strict=True):
                yield [code, measure, feedback, value]
