"""The report of a study as files: HTML, PDF, figures, and the numbers."""

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from hapticplayer.sequence import files
from hapticplayer.study import private
from hapticplayer.study.analysis import figures
from hapticplayer.study.analysis.analysis import Progress
from hapticplayer.study.analysis.html import page
from hapticplayer.study.analysis.parts import StudyAnalysis, parts_of
from hapticplayer.study.analysis.pdf import write_pdf


def write_report(
    analysis: StudyAnalysis,
    target: Path,
    title: str,
    progress: Progress = lambda _fraction, _step: None,
) -> None:
    """Write a new folder with everything; whole or not at all.

    `report.html`, `report.pdf`, `numbers.json`, the figures as SVG, PDF and PNG, and of
    ratings `conditions.csv` (means and spreads), `tests.csv` and `scores.csv` (each
    participant's), of judgements `levels.csv` and `curves.csv`.

    Raises:
        SequenceError: when the folder exists or cannot be written.
        Cancelled: by `progress`; nothing is left behind.
    """
    parts = parts_of(analysis)
    with files.written_aside(target, private.FOLDER_MODE) as aside:
        for place, (name, figure) in enumerate(parts.draw().items()):
            progress(0.2 + 0.2 * place, f"drawing {name}")
            for suffix in figures.FORMATS:
                figures.save(figure, aside / f"{name}{suffix}")
        svgs, pngs = (
            {path.stem: path.read_bytes() for path in sorted(aside.glob(pattern))}
            for pattern in ("*.svg", "*.png")
        )
        progress(0.6, "writing report.html")
        _write_text(aside / "report.html", page(title, parts.blocks, svgs))
        progress(0.7, "writing report.pdf")
        write_pdf(aside / "report.pdf", title, parts.blocks, pngs)
        progress(0.9, "writing the numbers")
        files.write_json(aside / "numbers.json", parts.numbers)
        for name, rows in parts.tables.items():
            _write_text(aside / name, _csv(rows))
        for path in aside.iterdir():  # codes, and what each of them answered
            path.chmod(private.FILE_MODE)


def _csv(rows: Iterable[list[Any]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return out.getvalue()


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
