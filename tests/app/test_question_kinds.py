"""Every kind of question on a participant's page: by keys, by mouse, at every size."""

import json
import re
from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from sitting import Person

from app.participant.questions import ROWS
from app.participant.visual_scale import VisualScale
from hapticplayer.study.creation import add_scale, change_definition
from hapticplayer.study.definition import QuestionKind, When
from hapticplayer.study.pages import PageKind
from hapticplayer.study.scales import page_of_scale
from tests.every_kind import drawn, with_every_kind

LEAST_PX = 44  # of the line
ROOMS = ((1920, 1080), (1280, 720), (800, 500))


@pytest.fixture
def page(make_study, sit, qtbot):
    """The page that has a question of each kind."""
    study = make_study()
    study = change_definition(study, with_every_kind(json.loads(study.content)))
    session = sit(study)
    definition, maker = study.definition, session.runner.maker
    asking = next(one for one in definition.pages if one.key == "more-before")
    session.participant.show_page(
        maker.page(PageKind.QUESTIONS, "more-before", 99, asking)
    )
    qtbot.wait(50)
    return session.participant.content


def row_of(page, kind):
    (row,) = [one for one in page.rows if one.asked.kind is kind]
    row.focus()
    return row


def press(page, *keys):
    for key in keys:
        QTest.keyClick(page.focusWidget() or page, key)


def test_every_kind_of_question_has_a_row(page):
    assert set(ROWS) == set(QuestionKind)
    assert [type(row) for row in page.rows] == [ROWS[kind] for kind in QuestionKind]
    assert {row.value() or None for row in page.rows} == {None}  # nothing is preset


def test_a_mark_is_set_and_moved_by_keys(page):
    row = row_of(page, QuestionKind.VISUAL)
    assert row.value() is None
    press(page, Qt.Key.Key_Right)
    assert row.value() == 51
    press(page, Qt.Key.Key_PageUp, Qt.Key.Key_Left)
    assert row.value() == 60
    press(page, Qt.Key.Key_End)
    assert row.value() == 100
    press(page, Qt.Key.Key_Home)
    assert row.value() == 0


def test_a_mark_is_set_and_dragged_by_the_mouse(page):
    row = row_of(page, QuestionKind.VISUAL)
    scale = row.scale
    middle = scale.height() // 2
    QTest.mouseClick(
        scale, Qt.MouseButton.LeftButton, pos=QPoint(scale.width() // 2, middle)
    )
    assert row.value() == pytest.approx(50, abs=1)
    QTest.mousePress(scale, Qt.MouseButton.LeftButton, pos=QPoint(30, middle))
    assert row.value() < 10
    QTest.mouseMove(scale, QPoint(scale.width() - 1, middle))
    assert row.value() == 100
    QTest.mouseRelease(scale, Qt.MouseButton.LeftButton, pos=QPoint(1, middle))
    assert row.value() == 100


def test_up_and_down_lead_from_a_mark_to_its_neighbours(page):
    row = row_of(page, QuestionKind.VISUAL)
    press(page, Qt.Key.Key_Down)
    assert page.rows[2].property("role") == "current"
    assert row.value() is None


@pytest.mark.parametrize("kind", [QuestionKind.VISUAL, QuestionKind.NUMBER])
def test_the_wheel_answers_no_question(page, kind):
    row = row_of(page, kind)
    for given in (None, 3):
        row.set_value(given)
        turned = QWheelEvent(
            *(QPointF(5, 5), QPointF(5, 5), QPoint(), QPoint(0, 120)),
            *(Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier),
            *(Qt.ScrollPhase.NoScrollPhase, False),
        )
        QApplication.sendEvent(row_control(row), turned)
        assert row.value() == given


def test_a_key_that_is_held_answers_one_question(page, qtbot):
    row = row_of(page, QuestionKind.SCALE)
    QTest.keyPress(page.focusWidget(), Qt.Key.Key_2)
    with qtbot.assertNotEmitted(page.finished):
        for key in (Qt.Key.Key_2, Qt.Key.Key_Return):
            event = QKeyEvent(
                QEvent.Type.KeyPress, key, Qt.KeyboardModifier(), "", True
            )
            QApplication.sendEvent(page.focusWidget(), event)
    assert row.value() == -2
    assert {one.value() or None for one in page.rows if one is not row} == {None}


@pytest.mark.parametrize("wide_px", [1200, 500])
@pytest.mark.parametrize("places", [(0, 50, 100), (0, 10, 90), (40, 50, 60)])
def test_long_labels_of_a_mark_are_whole_and_apart(qtbot, wide_px, places):
    words = "as strong as anything that I have ever felt in my whole long life, or more"
    scale = VisualScale((0, 100), dict.fromkeys(places, words))
    qtbot.addWidget(scale)
    scale.resize(wide_px, scale.heightForWidth(wide_px))
    rooms, metrics = scale.label_rooms(wide_px), scale.fontMetrics()
    assert 0 <= rooms[0].left_px < rooms[-1].right_px <= wide_px
    assert all(one.right_px < other.left_px for one, other in pairwise(rooms))
    high_px = max(room.high_px(metrics) for room in rooms)
    assert scale.height() >= high_px + LEAST_PX >= 2 * metrics.height() + LEAST_PX
    scale.show()
    below = scale.grab().toImage().copy(0, scale.height() - 2, wide_px, 2)
    assert len({below.pixel(x, 1) for x in range(wide_px)}) == 1  # nothing is cut


@pytest.mark.parametrize("room", ROOMS[1:])
def test_long_labels_have_all_their_lines_on_a_page(make_study, sit, qtbot, room):
    study = make_study()
    content = with_every_kind(json.loads(study.content))
    words = dict.fromkeys(content["languages"], "as strong as anything ever felt " * 2)
    (asking,) = [one for one in content["pages"] if one["key"] == "more-before"]
    for kind, places in (("visual", (0, 40, 100)), ("pair", (-3, 3))):
        (asked,) = [one for one in asking["questions"] if one["kind"] == kind]
        asked["labels"] = [{"at": at, "text": words} for at in places]
    session = sit(change_definition(study, content))
    window, maker = session.participant, session.runner.maker
    window.resize(*room)
    window.show_page(maker.page(PageKind.QUESTIONS, "more-before", 99))
    qtbot.wait(50)
    pair = row_of(window.content, QuestionKind.PAIR)
    of_pair = [one for one in pair.findChildren(QLabel) if "strong" in one.text()]
    for one in (row_of(window.content, QuestionKind.VISUAL).scale, *of_pair[-2:]):
        line_px = one.fontMetrics().height()
        assert one.height() >= one.heightForWidth(one.width()) > 1.9 * line_px


def test_digits_turn_several_answers_on_and_off(page):
    row = row_of(page, QuestionKind.CHOICES)
    press(page, Qt.Key.Key_1, Qt.Key.Key_3)
    assert row.value() == ["sea", "land"]
    press(page, Qt.Key.Key_1)
    assert row.value() == ["land"]
    assert row.property("role") == "current"  # a digit does not go on from here


def test_digits_are_places_on_a_scale_with_negative_points(page):
    row = row_of(page, QuestionKind.SCALE)
    press(page, Qt.Key.Key_2)
    assert row.value() == -2
    assert page.rows[1].property("role") == "current"


@pytest.mark.parametrize(("least", "key", "value"), [(0, 0, 0), (0, 7, 7), (1, 5, 5)])
def test_digits_are_the_numbers_of_a_scale(make_study, sit, least, key, value):
    study = make_study()
    content = json.loads(study.content)
    asked = content["pages"][1]["questions"][0]
    asked |= {"least": least, "most": 10, "labels": []}
    session = sit(change_definition(study, content))
    maker = session.runner.maker
    session.participant.show_page(maker.page(PageKind.QUESTIONS, "trial-01", 99))
    page = session.participant.content
    page.focus()
    press(page, Qt.Key(Qt.Key.Key_0 + key))
    assert page.rows[0].value() == value


def test_answers_come_back_after_a_pause(page):
    given = {
        QuestionKind.SCALE: 3,
        QuestionKind.VISUAL: 12,
        QuestionKind.NUMBER: -5,
        QuestionKind.YES_NO: False,
        QuestionKind.CHOICE: "bike",
        QuestionKind.CHOICES: ["air"],
        QuestionKind.PAIR: -1,
        QuestionKind.TEXT: "so",
    }
    for row in page.rows:
        row.set_value(given[row.asked.kind])
    assert {row.asked.kind: row.value() for row in page.rows} == given


def test_every_kind_is_read_aloud_with_its_question(page):
    for row in page.rows:
        for control in row.findChildren(type(row_control(row))):
            assert row.asked.text in control.accessibleName()


def row_control(row):
    for name in ("box", "scale"):
        if hasattr(row, name):
            return getattr(row, name)
    return row.group.buttons()[0]


@pytest.mark.parametrize("room", ROOMS)
def test_every_kind_fits_the_width_of_a_screen(page, room, qtbot):
    page.window().resize(*room)
    qtbot.wait(100)
    page.settle()
    assert page.column.totalMinimumSize().width() <= page.viewport().width()
    for row in page.rows:
        assert row.height() >= row.heightForWidth(row.width())


def test_two_pages_follow_each_clip(make_study, sit, wait_for):
    study = make_study()
    content = json.loads(study.content)
    pages = with_every_kind(content)["pages"]
    content["pages"] = [page for page in pages if page["key"] != "more-before"]
    session = sit(change_definition(study, content))
    person = Person(session, wait_for)
    person.pass_demonstration()
    for key in ("more-before-clip", "rating", "more-after-clip"):
        if key == "rating":
            person.wait_page(PageKind.READY, "trial-01")
            person.key(Qt.Key.Key_Enter)
            person.wait_page(PageKind.PLAYING)
            session.player.set_end(0.2)
        wait_for(lambda key=key: session.runner.page.key == key)
        person.wait_page(PageKind.QUESTIONS, "trial-01")
        values = drawn(session.runner.page, np.random.default_rng(3))
        for row in person.page.rows:
            row.set_value(values[row.asked.name])
        person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.QUESTIONS, "trial-02")
    (code,) = session.study.codes()
    records = session.study.session(code).records.intact
    asked = [r.content["page"] for r in records if r.kind.startswith("answers")]
    assert asked == ["sheet", "more-before-clip", "rating", "more-after-clip"]


@pytest.fixture
def pairs(make_study, sit):
    """A page of eight pairs, one after the other."""
    study = make_study()
    content = json.loads(study.content)
    page = page_of_scale("ueq-s", "ueq", When.BEFORE, content["languages"])
    worded = re.sub("[\u2039\u203a]", "", json.dumps(page, ensure_ascii=False))
    content["pages"].insert(0, {**json.loads(worded), "one_by_one": True})
    session = sit(change_definition(study, content))
    maker = session.runner.maker
    session.participant.show_page(maker.page(PageKind.QUESTIONS, "ueq", 99))
    made = session.participant.content
    made.focus()
    return made


def shown(page):
    return [number for number, row in enumerate(page.rows) if row.isVisible()]


def test_questions_one_by_one_go_on_with_an_answer_and_back(pairs, qtbot):
    assert shown(pairs) == [0]
    press(pairs, Qt.Key.Key_Return)
    assert shown(pairs) == [0]  # not without an answer
    assert pairs.rows[0].title.isVisible()
    press(pairs, Qt.Key.Key_7)
    assert shown(pairs) == [1]
    assert pairs.place.text() == "2 / 8"
    pairs.back.click()
    assert shown(pairs) == [0]
    for _ in pairs.rows:
        press(pairs, Qt.Key.Key_1)
    assert shown(pairs) == [7]
    with qtbot.waitSignal(pairs.finished):
        press(pairs, Qt.Key.Key_Return)
    assert set(pairs.values().values()) == {-3}


@pytest.mark.parametrize("room", [*ROOMS, (640, 360)])
def test_the_opposites_of_a_pair_are_whole_at_its_ends(pairs, qtbot, room):
    pairs.window().resize(*room)
    qtbot.wait(50)
    row = pairs.rows[0]
    ends = [one for one in row.findChildren(QLabel) if one.isVisible()]
    assert [one.text() for one in ends] == ["obstructive", "supportive"]
    assert all(one.width() >= one.sizeHint().width() for one in ends)
    points = [button.geometry() for button in row.group.buttons()]
    assert not any(one.geometry().intersects(at) for one in ends for at in points)
    assert "obstructive" in row.group.button(0).accessibleName()


def test_digits_are_the_numbers_that_answers_begin_with(make_study, sit):
    study = add_scale(make_study(), "misc", "now", When.BEFORE)
    session = sit(study)
    maker = session.runner.maker
    session.participant.show_page(maker.page(PageKind.QUESTIONS, "now", 99))
    page = session.participant.content
    page.focus()
    press(page, Qt.Key.Key_3)
    assert page.rows[0].value() == "3"


@pytest.mark.parametrize("room", ROOMS)
def test_a_scale_of_many_points_fits(make_study, sit, qtbot, room):
    study = make_study()
    content = json.loads(study.content)
    asked = content["pages"][1]["questions"][0]
    asked |= {"least": 0, "most": 20}
    session = sit(change_definition(study, content))
    maker = session.runner.maker
    session.participant.resize(*room)
    session.participant.show_page(maker.page(PageKind.QUESTIONS, "trial-01", 99))
    page = session.participant.content
    qtbot.wait(50)
    buttons = [button.geometry() for button in page.rows[0].group.buttons()]
    assert not any(a.intersects(b) for a, b in pairwise(buttons))
    assert buttons[-1].right() <= page.viewport().width()
