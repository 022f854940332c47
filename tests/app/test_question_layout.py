"""Where questions, their points and labels are: in three languages, at two sizes."""

import json
import re

import face_checks
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, QRect
from PySide6.QtGui import QFont, QFontMetrics
from PySide6.QtWidgets import QLabel

from app.participant.questions import PairRow
from app.participant.visual_scale import VisualScale, rooms_of
from hapticplayer.study.creation import change_definition
from hapticplayer.study.definition import When
from hapticplayer.study.pages import PageKind, PageMaker
from hapticplayer.study.scales import page_of_scale, scale_names

LANGUAGES = ("en", "fr", "de")
ROOMS = ((1280, 720), (960, 540))  # the second: 1920 x 1080 at 200 %
LONG = "Geschwindigkeitsbegrenzung"


def places(widgets):
    """Where widgets of one row are in it."""
    return [widget.geometry() for widget in widgets]


def inside(page, widget):
    """Where a widget is on what the page scrolls."""
    return QRect(widget.mapTo(page.body, QPoint()), widget.size())


@pytest.fixture
def lay_out(make_study, sit, qtbot):
    """Return a page of a study with these more, as it is laid out."""
    sessions = {}

    def make(pages, key, language="en", room=ROOMS[0]):
        if not sessions:
            study = make_study()
            content = json.loads(study.content)
            content["pages"] += pages
            sessions["one"] = sit(change_definition(study, content))
        runner, window = sessions["one"].runner, sessions["one"].participant
        maker = PageMaker(runner.definition, replace(runner.plan, language=language))
        window.resize(*room)
        window.show_page(maker.page(PageKind.QUESTIONS, key, 99))
        qtbot.wait(30)
        return window.content

    return make


def asked(kind, key="q", text="How was it?", labels=(), **more):
    made = {"key": key, "kind": kind, "text": dict.fromkeys(LANGUAGES, text), **more}
    made["labels"] = [
        {"at": at, "text": dict.fromkeys(LANGUAGES, words)} for at, words in labels
    ]
    return made


def page_with(*questions):
    return {"key": "more", "when": "before", "questions": list(questions)}


@pytest.mark.parametrize("room", ROOMS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_all_of_each_scale_is_on_its_page(lay_out, language, room):
    pages = [
        page_of_scale(name, name, When.BEFORE, LANGUAGES) for name in scale_names()
    ]
    worded = re.sub("[\u2039\u203a]", "", json.dumps(pages, ensure_ascii=False))
    for name in scale_names():
        page = lay_out(json.loads(worded), name, language, room)
        body = page.body.rect()
        assert list(face_checks.cut_off(page)) == []
        assert page.body.width() <= page.viewport().width()
        assert all(body.contains(inside(page, one)) for one in [*page.rows, page.next])


@pytest.mark.parametrize("language", LANGUAGES)
def test_lines_of_a_page_are_equally_long(lay_out, language):
    scale = page_of_scale("rtlx", "load", When.BEFORE, LANGUAGES)
    page = lay_out([scale], "load", language)
    lines = [inside(page, line) for line in page.body.findChildren(VisualScale)]
    assert len(lines) == 6
    assert len({(line.left(), line.right()) for line in lines}) == 1


def test_points_are_equally_wide_above_long_labels(lay_out):
    ends = (1, f"not at all {LONG}"), (7, f"extremely strong {LONG}")
    limits = {"least": 1, "most": 7}
    pair = asked("pair", "p", labels=ends, **limits)
    page = lay_out([page_with(asked("scale", labels=ends, **limits), pair)], "more")
    for row in page.rows:
        wide = [at.width() for at in places(row.group.buttons())]
        assert max(wide) - min(wide) <= 1
        high = [one for one in row.findChildren(QLabel) if LONG in one.text()]
        assert len({one.geometry().top() for one in high}) == 1


def test_the_last_label_ends_where_the_last_point_does(lay_out):
    ends = (0, "not at all"), (20, "extremely strong")
    page = lay_out([page_with(asked("scale", labels=ends, least=0, most=20))], "more")
    (row,) = page.rows
    label = next(one for one in row.findChildren(QLabel) if one.text() == ends[1][1])
    last = row.group.buttons()[-1].geometry()
    assert abs(label.geometry().right() - last.right()) <= 1


def test_answers_fill_their_rows_alike(lay_out):
    words = ("Weiblich", "Männlich", "Anders", "Keine Angabe")
    choices = [
        {"key": f"a{n}", "text": dict.fromkeys(LANGUAGES, text)}
        for n, text in enumerate(words)
    ]
    page = lay_out([page_with(asked("choice", choices=choices))], "more")
    tops = [at.top() for at in places(page.rows[0].group.buttons())]
    assert [tops.count(top) for top in sorted(set(tops))] == [2, 2]


@pytest.mark.parametrize(
    ("text", "required", "is_shown"),
    [
        ("dull \u2013 fine", True, False),
        ("dull \u2013 fine", False, True),
        ("How was the ride?", True, True),
    ],
)
def test_a_pair_shows_what_its_opposites_do_not_say(lay_out, text, required, is_shown):
    ends = (-3, "dull"), (3, "fine")
    pair = asked("pair", text=text, labels=ends, least=-3, most=3, required=required)
    page = lay_out([page_with(pair)], "more")
    (row,) = page.rows
    assert isinstance(row, PairRow)
    assert row.title.isVisible() == is_shown


def test_only_words_too_long_for_a_line_are_broken(application):
    metrics = QFontMetrics(QFont())
    wide_px = metrics.horizontalAdvance(LONG)
    labels = dict.fromkeys((0.0, 1.4 * wide_px, 2.8 * wide_px), f"so and so {LONG}")
    rooms = rooms_of(metrics, labels, (0.0, 2.8 * wide_px))
    wide = [room.right_px - room.left_px for room in rooms]
    assert min(wide) > 0.7 * wide_px  # half the way would be 0.7 at the ends
    for room, has in zip(rooms, wide, strict=True):
        words = room.breakable(metrics).split()
        assert words[:3] == ["so", "and", "so"]
        assert ("\u200b" in words[3]) == (has < wide_px)


def test_a_missing_answer_is_told_in_sight(lay_out, qtbot):
    page = lay_out(
        [page_of_scale("misc", "now", When.BEFORE, LANGUAGES)], "now", room=ROOMS[1]
    )
    (row,) = page.rows
    assert row.height() > page.viewport().height()
    page.show_problem(row.asked.name, "Please answer this question.")
    qtbot.wait(50)
    at = QRect(row.title.mapTo(page.viewport(), QPoint()), row.title.size())
    assert page.viewport().rect().contains(at)
