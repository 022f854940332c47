"""Ratings while a clip plays: by mouse, wheel, keys and axes, never over the clip."""

from itertools import pairwise
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from sitting import Person

from app.experimenter.spoken_number import SpokenNumber
from app.participant.rating_axes import RatingAxes
from app.participant.rating_strip import RatingStrip
from app.participant.visual_scale import LabelRoom
from app.widgets.layout import column_of
from hapticplayer.structures import convert
from hapticplayer.study.definition import LiveRating
from hapticplayer.study.live_ratings import read_ratings
from hapticplayer.study.pages import PageKind
from hapticplayer.study.watching import Watching
from tests.unit.study.test_watching import ALL, FMS, SLIDER, VECTION

WIDE, HIGH = 1280, 720


class Window(QWidget):
    """A clip's place with a strip below it, as the participant's window has."""

    def __init__(self, watching):
        super().__init__()
        self.strip, self.clip = RatingStrip(), QWidget()
        column_of((self.clip, 1), self.strip, of=self)
        self.resize(WIDE, HIGH)
        self.show()
        self.strip.begin(watching, "en")
        self.strip.timer.stop()  # the test beats

    def keyPressEvent(self, event):
        self.strip.take_key(event, is_pressed=True)

    def keyReleaseEvent(self, event):
        self.strip.take_key(event, is_pressed=False)


@pytest.fixture
def rated(application, tmp_path, manual_clock):
    """Return what makes a window with ratings, of a clip that plays since 0."""
    made = []

    def make(*ratings):
        declared = [convert(one, LiveRating, "") for one in ratings]
        begun_s = manual_clock.now_s()
        watching = Watching(
            *(declared, tmp_path, (1, 1), manual_clock, lambda now_s: now_s - begun_s)
        )
        made.append((watching, Window(watching)))
        return made[-1]

    yield make
    for watching, window in made:
        window.strip.end()
        window.deleteLater()
        watching.finish()


def test_a_slider_follows_all_movers_within_its_range(rated):
    watching, window = rated({**SLIDER, "by": ["mouse", "wheel", "keys", "grip-x"]})
    strip = window.strip
    strip.beat()
    assert watching.values["match"] == 0.0
    QCursor.setPos(window.mapToGlobal(QPoint(WIDE * 3 // 4, 10)))
    strip.beat()
    assert watching.values["match"] == pytest.approx(25.0, abs=2.0)
    QCursor.setPos(window.mapToGlobal(QPoint(0, 10)))
    strip.beat()
    assert watching.values["match"] == -50.0
    strip.turn(2)
    QTest.keyClick(window, Qt.Key.Key_Right)
    assert watching.values["match"] == -35.0
    strip.axis = {"grip-x": 1.0}.get
    strip.beat()
    assert watching.values["match"] == 50.0


def test_the_grip_is_an_axis_of_three_centimetres_each_way():
    tick = {"position_m": (0.015, float("nan"), -0.03)}
    snapshot = SimpleNamespace(leading=SimpleNamespace(tick=tick))
    axes = RatingAxes(SimpleNamespace(snapshot=lambda: snapshot), {"grip-x"})
    shares = [axes.share(f"grip-{axis}") for axis in "xyz"]
    assert shares == [pytest.approx(0.75), None, pytest.approx(0.0)]


def test_a_key_counts_as_held_until_it_is_let_go(rated):
    watching, window = rated(VECTION)
    QTest.keyPress(window, Qt.Key.Key_V)
    assert watching.values["vection"] == 1.0
    QTest.keyRelease(window, Qt.Key.Key_V)
    assert watching.values["vection"] == 0.0


@pytest.mark.parametrize(
    ("typed", "given"), [("7", 7), ("1\r", 1), ("12", 12), ("0", 0), ("2\b\r3", 3)]
)
def test_a_number_is_typed_with_as_few_keys_as_it_needs(
    rated, manual_clock, qtbot, typed, given
):
    watching, window = rated({**FMS, "stop_at": None, "rest": None})
    manual_clock.advance(60.5)
    with qtbot.waitSignal(window.strip.asked):
        window.strip.beat()
    kept = []
    watching.give = lambda key, value: kept.append((key, value))
    keys = {"\r": Qt.Key.Key_Return, "\b": Qt.Key.Key_Backspace}
    for one in typed:
        QTest.keyClick(window, keys.get(one, one))
    assert kept == [("fms", given)]


def test_a_spoken_number_is_entered_by_the_operator(rated, manual_clock):
    watching, window = rated({**FMS, "spoken": True})
    plan = SimpleNamespace(language="en")
    runner, field = SimpleNamespace(watching=watching, plan=plan), SpokenNumber()
    field.follow(runner)
    assert field.isHidden()
    manual_clock.advance(61.0)
    window.strip.beat()
    QTest.keyClick(window, "9")
    assert watching.asking is not None  # the participant's keys are no answer
    field.follow(runner)
    assert not field.isHidden()
    field.box.setValue(16)
    field.enter.click()
    assert field.isHidden()
    assert (watching.asking, watching.limit.key) == (None, "fms")
    field.deleteLater()


def test_a_session_keeps_ratings_and_the_clip_stays_uncovered(
    make_study, sit, wait_for
):
    session = sit(make_study(while_watching=ALL))
    person = Person(session, wait_for).begin_trial()
    window = session.participant
    wait_for(window.strip.isVisible)
    clip, strip = window.surface.geometry(), window.strip.geometry()
    assert not clip.intersects(strip)
    assert clip.height() > 0.8 * window.height()
    wait_for(lambda: session.player.snapshot().media_s > 0.3)
    QTest.keyPress(window, Qt.Key.Key_V)
    wait_for(lambda: session.player.snapshot().media_s > 0.6)
    QTest.keyRelease(window, Qt.Key.Key_V)
    session.player.set_end(0.8)
    person.wait_page(PageKind.QUESTIONS)
    assert window.strip.isHidden()
    found = read_ratings(session.study.session(person.runner.plan.code), [])
    by_key = {one.rating.key: one for one in found}
    held = by_key["vection"]
    assert 0.3 <= held.media_s[held.value > 0.0][0] < held.media_s[-1]
    assert not held.value[-1]
    assert len(by_key["match"].value) > 10


def test_escape_and_space_stop_the_force_of_a_rated_clip(make_study, sit, wait_for):
    session = sit(make_study(while_watching=ALL))
    person = Person(session, wait_for).begin_trial()
    wait_for(lambda: session.player.snapshot().media_s > 0.1)
    QTest.keyClick(session.participant, Qt.Key.Key_Space)
    person.wait_page(PageKind.PAUSED)
    assert session.player.latch.is_set
    assert session.participant.strip.isHidden()


def test_the_next_clip_waits_for_the_gap(make_study, sit, wait_for):
    session = sit(make_study(gap_s=2.0))
    person = Person(session, wait_for)
    person.to_trials()
    person.trial()
    person.wait_page(PageKind.READY, "trial-02")
    start = person.page.buttons["start"]
    wait_for(lambda: not start.isEnabled())
    assert start.text().endswith(("(1)", "(2)"))
    person.runner.proceed()
    assert person.runner.page.kind is PageKind.READY
    wait_for(start.isEnabled)
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.PLAYING)


def test_long_texts_of_a_rating_are_whole(rated):
    words = {"en": "how badly what you feel fits what you see, and all of it " * 4}
    labels = [{"at": at, "text": words} for at in (-50, 0, 50)]
    watching, window = rated({**SLIDER, "text": words, "labels": labels}, VECTION)
    strip, (slider, _) = window.strip, watching.ratings
    metrics = strip.fontMetrics()
    rooms = strip.label_rooms(slider)
    assert all(one.right_px < other.left_px for one, other in pairwise(rooms))
    labels_px = max(room.high_px(metrics) for room in rooms)
    edges = rooms[0].left_px, rooms[-1].right_px
    text_px = LabelRoom(words["en"], *edges).high_px(metrics)
    assert min(labels_px, text_px) > 2 * metrics.height()
    assert strip.height() > labels_px + text_px
    assert window.clip.height() + strip.height() <= window.height()
