"""A picture of every page of a study, the participant's and the operator's.

    python -m benchmarks.study_pictures -o FOLDER [--languages en de] [--scale 2]

The screen is 1920 x 1080 pixels whatever the scale, so that 2 leaves half the room.
"""

import argparse
import json
import os
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QWidget

WIDTH_PX, HEIGHT_PX = 1920, 1080
SETTLE_MS = 400
KEYS = ("bike", "horse", "car-turning", "car-braking")
PAGES = (
    ("consent", "consent"),
    ("sheet", "questions"),
    ("demonstration", "demonstration"),
    ("trial-03", "ready"),
    ("trial-03", "questions"),
    ("trial-03", "paused"),
    ("trial-03", "problem"),
    ("post-test", "questions"),
    ("end", "thanks"),
)
LONG = " And please take all the time that you need before you go on to the next one."


def main() -> int:
    """Make the pictures that are asked for, and print their names."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--languages", nargs="+", default=["en", "de", "fr"])
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--long", action="store_true", help="texts twice as long")
    options = parser.parse_args()
    os.environ["QT_SCALE_FACTOR"] = str(options.scale)
    options.output.mkdir(parents=True, exist_ok=True)
    for language in options.languages:
        for name, widget in _pages(language, options):
            path = options.output / f"{name}-{language}-{options.scale:g}.png"
            widget.grab().save(str(path))
            print(path)
    return 0


def _pages(language: str, options: argparse.Namespace) -> Iterator[tuple[str, QWidget]]:
    from app.bridge.settings import Settings
    from app.participant.application import StudySession
    from app.player.application import make_application
    from app.player.look_menus import LANGUAGE
    from app.player.remake import dress
    from hapticplayer.clock import SystemClock
    from hapticplayer.study.session_setup import load_material

    application, settings = make_application(), Settings(None)
    settings.keep(LANGUAGE, language)
    dress(application, settings)
    with tempfile.TemporaryDirectory() as folder:
        study = _study(Path(folder), language, is_long=options.long)
        material = load_material(study)
        session = StudySession(study, material, "simulated", SystemClock(), audio=None)
        try:
            session.show(windowed=True)
            room = [int(side / options.scale) for side in (WIDTH_PX, HEIGHT_PX)]
            yield from _of_operator(session, room)
            session.begin_session("", language)
            yield from _of_participant(session, language)
            yield "operator", session.control
        finally:
            session.close()


def _of_operator(session, room: list[int]) -> Iterator[tuple[str, QWidget]]:
    from app.experimenter.study_editor import StudyEditor

    session.participant.resize(*room)
    _shrink(session.control, room)
    session.start_panel.show_checks(session.look())
    _settle()
    yield "operator-start", session.control
    editor = StudyEditor(session.study)
    editor.show()
    _shrink(editor, room)
    _settle()
    yield "editor", editor
    editor.close()


def _of_participant(session, language: str) -> Iterator[tuple[str, QWidget]]:
    from hapticplayer.study.page_maker import PageMaker
    from hapticplayer.study.pages import PageKind

    runner = session.runner
    plan = replace(runner.plan, language=language)
    runner.maker = maker = PageMaker(runner.definition, plan)
    for step, kind in PAGES:
        page = maker.page(PageKind(kind), step, 99)
        session.participant._show_page(page)  # noqa: SLF001
        _settle()
        yield f"{step}-{kind}", session.participant


def _shrink(window: QWidget, room: list[int]) -> None:
    """Leave a window no more room than such a screen would."""
    window.resize(min(window.width(), room[0]), min(window.height(), room[1]))


def _study(folder: Path, language: str, *, is_long: bool):
    from hapticplayer.sequence.demo import demo_folder
    from hapticplayer.study.creation import change_definition, create_study

    demo = Path(demo_folder(progress=lambda _share, _step: None))
    study = create_study(folder / "study", folders=dict.fromkeys(KEYS, demo))
    content = json.loads(study.content)
    if is_long:
        for factor in content["factors"]:
            factor["text"][language] += LONG
    return change_definition(study, content)


def _settle() -> None:
    loop = QEventLoop()
    QTimer.singleShot(SETTLE_MS, loop.quit)
    loop.exec()


if __name__ == "__main__":
    sys.exit(main())
