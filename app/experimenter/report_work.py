"""The analysis of a study, for a process of its own: figures hold the interpreter.

Nothing of Qt is imported here. Drawn in a thread of the window's process they kept the
window waiting for up to 0.2 s.
"""

from dataclasses import dataclass
from pathlib import Path

from app.bridge.jobs import Progress
from hapticplayer.study.analysis.figures import pngs
from hapticplayer.study.analysis.html import body
from hapticplayer.study.analysis.parts import StudyAnalysis, analyse_study, parts_of
from hapticplayer.study.analysis.report import write_report
from hapticplayer.study.answers import Answers

SCHEME = "figure:"
"""Of the addresses of the pictures in the text."""


@dataclass(frozen=True, slots=True)
class Report:
    """Text and pictures, ready to be shown."""

    analysis: StudyAnalysis
    html: str
    pictures: dict[str, bytes]


def made_report(answers: Answers, *, progress: Progress) -> Report:
    """Return the report of a study's answers."""
    found = analyse_study(
        answers, progress=lambda fraction, step: progress(0.7 * fraction, step)
    )
    progress(0.7, "drawing the figures")
    parts = parts_of(found)
    pictures = pngs(parts.draw())
    html = body(parts.blocks, lambda name: SCHEME + name)
    return Report(found, html, pictures)


def written_report(
    analysis: StudyAnalysis, target: Path, title: str, *, progress: Progress
) -> Path:
    """Write a report into a new folder, and return it."""
    write_report(analysis, target, title, progress)
    return target
