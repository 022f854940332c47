"""Every page by keyboard, for screen readers, and with every text whole."""

import json
import os
import subprocess
import sys
from functools import partial
from pathlib import Path

import face_checks
import faces
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QPushButton,
    QRadioButton,
    QTableWidget,
    QVBoxLayout,
    QWidget,
)
from sitting import Person

from app.bridge import languages
from app.widgets import theme
from app.widgets.layout import TITLE_BAR_PX
from hapticplayer.study.creation import change_definition
from hapticplayer.study.pages import PageKind
from tests.every_kind import with_every_kind

ROOT = Path(__file__).resolve().parents[2]
LARGE_SCREEN = {
    "name": "large",
    "x": 0,
    "y": 0,
    "width": 3840,
    "height": 2160,
    "logicalDpi": 96,
    "logicalBaseDpi": 96,
    "dpr": 1,
}
SCALE = "QT_SCALE_FACTOR"
LEAST_TOUCH_PX = 44  # WCAG 2.2, 2.5.5


def check_keyboard(face, qtbot) -> None:
    """Every control is reached, shows it, and has a name."""
    face.window().activateWindow()
    qtbot.waitUntil(face.window().isActiveWindow)
    wanted = face_checks.controls(face)
    assert wanted
    reached = face_checks.reached_by_tab(face)
    # Tab goes to one of exclusive buttons, the arrows to the others
    left = [w for w in wanted if w not in reached and not _is_in_group(w, reached)]
    assert left == []
    unseen = {
        f"{type(w).__name__} {face_checks.spoken_name(w)!r}": shown
        for w in reached
        if (shown := face_checks.focus_shows(w)) < min(w.width(), w.height())
    }
    assert unseen == {}
    assert [w for w in (*wanted, *reached) if not face_checks.spoken_name(w)] == []


def _is_in_group(widget, reached) -> bool:
    group = getattr(widget, "group", lambda: None)()
    others = list(group.buttons()) if group is not None else []
    if isinstance(widget, QRadioButton):  # those of one parent are exclusive, too
        others += widget.parent().findChildren(QRadioButton)
    return any(one in reached for one in others)


@pytest.mark.parametrize("look", list(theme.THEMES))
def test_the_window_and_every_dialog_can_be_used_by_keyboard(
    dressed, make_window, source, look, tmp_path, qtbot
):
    dressed(look=look)
    window = make_window()
    window.session.show_source(source)
    window.transport.set_devices([])
    check_keyboard(window, qtbot)
    for make in faces.dialogs(window, tmp_path).values():
        face = make()
        face.show()
        check_keyboard(face, qtbot)
        faces.close(face)


def test_participant_pages_work_by_keyboard_and_by_finger(
    make_study, sit, wait_for, qtbot
):
    study = make_study()
    study = change_definition(study, with_every_kind(json.loads(study.content)))
    session = sit(study, size=(1024, 768))
    person = Person(session, wait_for)
    window, maker = session.participant, session.runner.maker
    for kind, step in (
        (PageKind.QUESTIONS, "more-before"),
        (PageKind.CONSENT, "consent"),
        (PageKind.QUESTIONS, "sheet"),
        (PageKind.QUESTIONS, "trial-01"),
        (PageKind.QUESTIONS, "post-test"),
        (PageKind.PAUSED, "trial-01"),
    ):
        window.show_page(maker.page(kind, step, 99))
        qtbot.wait(20)  # the letters take their size
        check_keyboard(person.page, qtbot)
        for control in face_checks.controls(person.page):
            assert control.height() >= LEAST_TOUCH_PX, face_checks.spoken_name(control)
            assert control.width() >= LEAST_TOUCH_PX, face_checks.spoken_name(control)


PARTICIPANTS_PAGES = (
    (PageKind.CONSENT, "consent"),
    (PageKind.QUESTIONS, "sheet"),
    (PageKind.DEMONSTRATION, "demonstration"),
    (PageKind.READY, "trial-01"),
    (PageKind.QUESTIONS, "trial-01"),
    (PageKind.QUESTIONS, "post-test"),
    (PageKind.QUESTIONS, "more-before"),
    (PageKind.PAUSED, "trial-01"),
    (PageKind.PROBLEM, "trial-01"),
    (PageKind.STOPPED, "end"),
    (PageKind.THANKS, "end"),
)
SCROLLED = ("post-test", "more-before")
TURNS, TURN_MS = 50, 10  # of the event loop, on a busy machine
# of screens: 1920 x 1080 at 100 and 200 %, 3840 x 2160 at 300 %, and old projectors
ROOMS = ((1920, 1080), (960, 540), (1280, 720), (1024, 768), (800, 480))


def at_rest(look, page, qtbot) -> list[str]:
    """Return what is wrong once the letters have had time to take their size."""
    for _ in range(TURNS):
        qtbot.wait(TURN_MS)
        if not (found := look(page)):
            break
    return found


def wrong_for_participants(content, room, step) -> list[str]:
    """Return the texts that have no room, or have to be scrolled to."""
    found = cut_off(content)
    wide_px, high_px = content.viewport().width(), content.viewport().height()
    if content.column.totalMinimumSize().width() > wide_px:
        found.append("wider than its window")
    if room[1] >= 768 and step not in SCROLLED and content.needed_px(wide_px) > high_px:
        found.append("higher than its window")
    if content.body.font().pixelSize() < room[1] / 36 - 1:
        found.append("small letters")
    return found


@pytest.mark.parametrize("language", list(languages.NAMES))
def test_every_text_of_a_participant_is_whole(make_study, sit, language, qtbot):
    study = make_study()
    study = change_definition(study, with_every_kind(json.loads(study.content)))
    session = sit(study, language=language)
    window, maker = session.participant, session.runner.maker
    found = []
    for room in ROOMS:
        window.resize(*room)
        for kind, step in PARTICIPANTS_PAGES:
            window.show_page(maker.page(kind, step, 99))
            look = partial(wrong_for_participants, room=room, step=step)
            texts = at_rest(look, window.content, qtbot)
            found += [f"{room} {step} {kind}: {text}" for text in texts]
    assert found == []


def test_an_age_is_answered_by_finger_alone(make_study, sit, wait_for, qtbot):
    session = sit(make_study(), size=(1024, 768))
    window, maker = session.participant, session.runner.maker
    window.show_page(maker.page(PageKind.QUESTIONS, "sheet", 99))
    age = window.content.rows[0]
    down, up = age.findChildren(QPushButton)
    for _ in range(3):
        qtbot.mouseClick(up, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(down, Qt.MouseButton.LeftButton)
    assert age.value() == age.asked.question.least + 1


def test_the_question_that_is_not_answered_comes_into_sight(make_study, sit, qtbot):
    session = sit(make_study(), size=(1024, 600))
    window, maker = session.participant, session.runner.maker
    window.show_page(maker.page(PageKind.QUESTIONS, "post-test", 99))
    qtbot.wait(20)
    page = window.content
    page.show_problem(page.rows[-1].asked.name, "Please answer this question.")
    qtbot.wait(20)
    said = page.rows[-1].title
    at = said.mapTo(page.viewport(), said.rect().bottomLeft())
    assert page.verticalScrollBar().maximum() > 0
    assert page.viewport().rect().contains(at)
    at = page.next.mapTo(page.viewport(), page.next.rect().bottomLeft())
    assert page.viewport().rect().contains(at)  # and what goes on from there
    framed = [row for row in page.rows if row.property("role") == "current"]
    assert framed == [page.rows[-1]]


def test_a_text_cut_off_in_a_choice_or_a_header_is_found(dressed, qtbot):
    dressed(language="de")
    face = QWidget()
    qtbot.addWidget(face)
    column = QVBoxLayout(face)
    combo, table = QComboBox(), QTableWidget(1, 2)
    combo.addItems(["kurz", "viel zu lang f\u00fcr so wenig Raum"])
    table.setHorizontalHeaderLabels(["Spur", "Auch dieser Titel ist zu lang"])
    for widget in (combo, table):
        column.addWidget(widget)
    face.resize(700, 300)
    combo.setFixedWidth(90)
    table.setColumnWidth(1, 60)
    face.show()
    found = list(face_checks.cut_off(face))
    assert [text.partition(":")[0] for text in found] == [
        "choice 'viel zu lang f\u00fcr so wenig Raum'",
        "header 'Auch dieser Titel ist zu lang'",
    ]
    combo.setFixedWidth(400)
    table.setColumnWidth(1, 400)
    assert list(face_checks.cut_off(face)) == []


SMALL_PX = (800, 500 - TITLE_BAR_PX)
"""A screen of 1600 x 1000 pixels at 200 %; one of 1280 x 720 has more room."""


def cut_off(face) -> list[str]:
    """Return the texts that have no room."""
    return list(face_checks.cut_off(face))


def wrong_with(face) -> list[str]:
    """Return what has no room, or has no name."""
    found = cut_off(face)
    least = face.minimumSizeHint()
    if least.width() > SMALL_PX[0] or least.height() > SMALL_PX[1]:
        found.append(f"needs {least.width()} x {least.height()} pixels")
    nameless = [w for w in face_checks.controls(face) if not face_checks.spoken_name(w)]
    return found + [f"{type(w).__name__} without a name" for w in nameless]


def test_every_list_of_choices_opens_whole(
    dressed, make_window, source, tmp_path, qtbot
):
    dressed(language="en")
    window = make_window()
    window.session.show_source(source)
    found = list(face_checks.short_lists(window))
    for name, make in faces.dialogs(window, tmp_path).items():
        face = make()
        face.show()
        qtbot.waitExposed(face)
        found += [f"{name}: {one}" for one in face_checks.short_lists(face)]
        faces.close(face)
    assert found == []


@pytest.mark.parametrize("language", list(languages.NAMES))
def test_every_text_is_whole(dressed, make_window, source, language, tmp_path, qtbot):
    """In the window and each dialog, which fit a small screen."""
    dressed(language=language)
    window = make_window()
    window.session.show_source(source)
    window.extras.statistics.setVisible(True)
    window.extras.statistics.refresh(window.player)
    qtbot.wait(20)
    assert wrong_with(window) == []
    assert all(action.text() for action in window.commands.by_name.values())
    wrong = {}
    for name, make in faces.dialogs(window, tmp_path).items():
        face = make()
        face.show()
        if found := at_rest(wrong_with, face, qtbot):
            wrong[name] = found
        faces.close(face)
    assert wrong == {}


def test_every_text_is_whole_where_everything_is_larger(tmp_path):
    """Qt takes the scale when it begins: in processes of their own, side by side."""
    if os.environ.get(SCALE):
        pytest.skip("this is one of them")
    here = f"{__file__}::test_every_text_is_whole"
    config = tmp_path / "screens.json"
    config.write_text(json.dumps({"screens": [LARGE_SCREEN]}))
    platform = {"HAPTICPLAYER_TEST_PLATFORM": f"offscreen:configfile={config}"}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    running = [
        subprocess.Popen(
            # each tidies its own folder only, not what the others are tidying
            [*command, f"--basetemp={tmp_path / language}", f"{here}[{language}]"],
            env={**os.environ, **platform, SCALE: scale},
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        for scale, language in (("1.5", "fr"), ("2", "de"))
    ]
    said = [one.communicate()[0] for one in running]
    assert [one.returncode for one in running] == [0, 0], "\n".join(said)[-6000:]
