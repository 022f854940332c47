"""The report of a study as files: HTML, PDF, figures, and the numbers."""

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from hapticplayer.sequence import files
from hapticplayer.study.analysis import figures
from hapticplayer.study.analysis.analysis import Analysis, Progress
from hapticplayer.study.analysis.contents import contents
from hapticplayer.study.analysis.html import page
from hapticplayer.study.analysis.pdf import write_pdf
from hapticplayer.study.analysis.summary import summary

_TESTS = ("friedman", "shapiro", "wilcoxon", "nemenyi", "conover", "mann_whitney")


def write_report(
    analysis: Analysis,
    target: Path,
    title: str,
    progress: Progress = lambda _fraction, _step: None,
) -> None:
    """Write a new folder with everything; whole or not at all.

    `report.html`, `report.pdf`, `numbers.json`, `conditions.csv` (means and spreads),
    `tests.csv`, `scores.csv` (each participant's), and the figures as SVG, PDF and PNG.

    Raises:
        SequenceError: when the folder exists or cannot be written.
        Cancelled: by `progress`; nothing is left behind.
    """
    numbers, blocks = summary(analysis), tuple(contents(analysis))
    with files.written_aside(target) as aside:
        for place, (name, figure) in enumerate(figures.figures(analysis).items()):
            progress(0.2 + 0.2 * place, f"drawing {name}")
            for suffix in figures.FORMATS:
                figures.save(figure, aside / f"{name}{suffix}")
        svgs, pngs = (
            {path.stem: path.read_bytes() for path in sorted(aside.glob(pattern))}
            for pattern in ("*.svg", "*.png")
        )
        progress(0.6, "writing report.html")
        _write_text(aside / "report.html", page(title, blocks, svgs))
        progress(0.7, "writing report.pdf")
        write_pdf(aside / "report.pdf", title, blocks, pngs)
        progress(0.9, "writing the numbers")
        files.write_json(aside / "numbers.json", numbers)
        _write_text(aside / "conditions.csv", _csv(_condition_rows(numbers)))
        _write_text(aside / "tests.csv", _csv(_test_rows(numbers)))
        _write_text(aside / "scores.csv", _csv(_score_rows(analysis)))


def _condition_rows(numbers: dict[str, Any]) -> Iterator[list[Any]]:
    names = list(next(iter(numbers["qoe"].values())))
    yield ["measure", "sequence", "feedback", *names]
    for measure, by_feedback in {"qoe": numbers["qoe"], **numbers["factors"]}.items():
        for feedback, one in by_feedback.items():
            yield [measure, "all", feedback, *one.values()]
        for sequence, conditions in numbers["conditions"][measure].items():
            for feedback, one in conditions.items():
                yield [measure, sequence, feedback, *one.values()]


def _test_rows(numbers: dict[str, Any]) -> Iterator[list[Any]]:
    yield ["test", "measure", "of", "statistic", "value"]
    for test in _TESTS:
        for measure, found in numbers[test].items():
            parts = {"": found} if test == "friedman" else found
            for name, one in parts.items():
                for statistic, value in _flat(one):
                    yield [test, measure, name, statistic, value]
    for measure, found in numbers["structure"].items():
        for name, one in (found or {"effects": {}})["effects"].items():
            for statistic, value in _flat(one):
                yield ["aligned_ranks", measure, name, statistic, value]


def _flat(one: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in one.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{name}", part) for name, part in value.items())
        elif isinstance(value, list):
            yield from ((f"{key}.{place}", part) for place, part in enumerate(value))
        else:
            yield key, value


def _score_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["participant", "measure", "feedback", "mean_over_sequences"]
    for measure, one in analysis.measures.items():
        for code, row in zip(one.scores.participants, one.scores.values, strict=True):
            for feedback, value in zip(one.scores.feedbacks, row.tolist(), strict=True):
                yield [code, measure, feedback, value]


def _csv(rows: Iterator[list[Any]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return out.getvalue()


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
