"""The analysis of a study, for a process of its own: figures hold the interpreter.

Nothing of Qt is imported here, and what the analysis needs (scipy, matplotlib) only when
it is called: in the window's process it kept the window waiting for 0.2 to 1 s. For the
same reason nothing of the analysis itself goes back, only what is shown.
"""

from dataclasses import dataclass
from pathlib import Path

from app.bridge.jobs import Progress
from hapticplayer.study.answers import Answers

SCHEME = "figure:"
"""Of the addresses of the pictures in the text."""
_ANALYSED = 0.7  # of the work


@dataclass(frozen=True, slots=True)
class Report:
    """Text and pictures, ready to be shown.

    Attributes:
        answers: that were analysed.
        html: refers to the pictures as SCHEME and their names.
        pictures: PNG, by name.
        dpi: of the pictures.
    """

    answers: Answers
    html: str
    pictures: dict[str, bytes]
    dpi: float


def made_report(answers: Answers, *, progress: Progress) -> Report:
    """Return the report of a study's answers."""
    from hapticplayer.study.analysis.figures import DPI, image
    from hapticplayer.study.analysis.report import analyse_study, parts_of
    from hapticplayer.study.analysis.typesetting import body

    found = analyse_study(
        answers, progress=lambda fraction, step: progress(_ANALYSED * fraction, step)
    )
    progress(_ANALYSED, "drawing the figures")
    parts = parts_of(found)
    pictures = {name: image(figure) for name, figure in parts.draw().items()}
    html = body(parts.blocks, lambda name: SCHEME + name)
    return Report(answers, html, pictures, DPI)


def written_report(
    answers: Answers, target: Path, title: str, *, progress: Progress
) -> Path:
    """Write the report of these answers into a new folder, and return it."""
    from hapticplayer.study.analysis.report import analyse_study, write_report

    found = analyse_study(
        answers, progress=lambda fraction, step: progress(_ANALYSED * fraction, step)
    )
    write_report(
        found,
        target,
        title,
        lambda fraction, step: progress(_ANALYSED + (1.0 - _ANALYSED) * fraction, step),
    )
    return target
