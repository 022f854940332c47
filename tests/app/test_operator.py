"""The operator's screen: the participant's picture, the volume, notes with times."""

import re

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton
from sitting import Person
from still_recorder import silent_source

from app.experimenter.start_panel import StartPanel
from app.participant.application import StudySession
from hapticplayer.capture.live import source as live
from hapticplayer.clock import SystemClock
from hapticplayer.study.felt_demonstration import FeltStage
from hapticplayer.study.preflight import run_checks, volume_in_checks
from hapticplayer.study.session_setup import load_study_sources
from tests.conftest import clip_of


def middle_of(widget):
    image = widget.grab().toImage()
    return image.pixelColor(image.width() // 2, image.height() // 4).lightness()


def test_the_operator_sees_the_picture_of_the_clip_but_no_page(
    make_study, sit, wait_for
):
    session = sit(make_study())
    mirror = session.control.mirror
    assert middle_of(mirror) == 0  # the words lie below
    Person(session, wait_for).begin_trial()
    session.player.seek(1.5)
    wait_for(lambda: session.player.snapshot().media_s > 1.5)
    wait_for(lambda: middle_of(mirror) > 100)
    theirs = middle_of(session.participant.surface)
    assert abs(middle_of(mirror) - theirs) < 20  # the clip grows brighter meanwhile
    session.participant.halt("operator")
    wait_for(lambda: not mirror.is_clip)


def test_the_mirror_draws_at_10_hz_and_not_behind_a_page(make_study, sit):
    mirror, updates = sit(make_study()).control.mirror, []
    mirror.update = lambda: updates.append(1)
    for k in range(300):
        mirror.follow(1e6 + k / 30.0, is_clip=True)
    assert 98 <= len(updates) <= 103
    mirror.follow(2e6, is_clip=False)
    updates.clear()
    for k in range(300):
        mirror.follow(3e6 + k / 30.0, is_clip=False)
    assert updates == []


def test_the_volume_is_kept_for_the_next_participant(make_study, sit, wait_for):
    study = make_study()
    first = sit(study)
    first.start_panel.volume.setValue(65)
    assert clip_of(first.player).sound.ring.gain == 0.65**3
    first.begin_session("", "en")
    assert "65 %" in first.control.volume.text()
    assert not first.start_panel.volume.isVisible()
    code = first.runner.plan.code
    first.close()
    kept = [
        r.content["checks"]
        for r in study.session(code).records.intact
        if r.kind == "checks"
    ]
    assert volume_in_checks(kept[-1]) == 65
    second = sit(study)
    assert second.start_panel.volume.value() == 65
    assert clip_of(second.player).sound.ring.gain == 0.65**3


def test_a_note_is_shown_with_its_time_and_kept_with_its_own(make_study, sit, wait_for):
    session = sit(make_study())
    session.control.note.setText("moved the chair")
    QTest.keyClick(session.control.note, Qt.Key.Key_Return)
    shown = session.control.notes.toPlainText()
    assert re.fullmatch(r"\d\d:\d\d:\d\d  moved the chair", shown)
    records = session.study.session(session.runner.plan.code).records.intact
    note = next(r for r in records if r.kind == "note")
    assert note.content["text"] == "moved the chair"
    assert re.match(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", note.utc)


def test_checks_that_tell_no_volume_are_no_reason_to_fail():
    assert volume_in_checks(None) is None
    assert volume_in_checks([{"check": "sound", "found": "heard"}, 3]) is None
    assert volume_in_checks([{"check": "volume", "found": "1e9 %"}]) is None
    assert volume_in_checks([{"check": "volume", "found": "900 %"}]) == 100


@pytest.fixture
def panel(application, qtbot):
    made = StartPanel(["en"], [])
    qtbot.addWidget(made)
    return made


def test_a_red_row_says_what_is_wrong_and_what_to_do(panel, make_study, sit):
    study = make_study()
    needs = replace(study.definition.checks, device=True, sound=True)
    player = sit(study, ["simulated"]).player
    screen = {"width_px": 800, "height_px": 600, "refresh_hz": 60.0, "screens": 1}
    checks = run_checks(
        player,
        needs,
        study.folder,
        screen,
        is_sound_heard=False,
        volume_percent=80,
    )
    panel.show_checks(checks)
    told = panel.checks.text()
    assert "choose a real one" in told
    assert "tick the box if you hear it" in told
    assert "turn the volume up" not in told  # that one is green
    assert all(check.remedy for check in checks)


def test_the_operator_chooses_the_devices(panel):
    chosen, outputs = [], panel.outputs
    outputs.chosen.connect(chosen.append)
    outputs.show_names(["none"])
    labels = [label.text() for label in outputs.findChildren(QLabel)]
    assert "No device: participants feel nothing" in labels
    outputs.form.fill("simulated")
    outputs.add_button.click()
    outputs.add_button.click()
    assert "already" in outputs.problem.text()
    assert chosen == [["simulated"]]
    remove = next(
        one
        for one in outputs.findChildren(QPushButton)
        if one.accessibleName().startswith("Remove") and one.isVisibleTo(outputs)
    )
    remove.click()
    assert chosen[-1] == []


def test_devices_chosen_on_the_panel_are_played_on(make_study, application, wait_for):
    study = make_study()
    session = StudySession(
        study, load_study_sources(study), (), SystemClock(), audio=None
    )
    try:
        session.show(windowed=True)
        session.start_panel.outputs.form.fill("simulated")
        session.start_panel.outputs.add_button.click()
        assert session.player.output_names == ["simulated"]
        session.begin_session("", "en")
        assert session.player.output_names == ["simulated"]
    finally:
        session.close()


def test_the_first_participant_has_no_balance_yet(panel, make_study):
    panel.show_balance(make_study().balance())
    assert panel.balance.text() == "this is the first participant"


def test_the_sensor_of_the_demonstration_is_opened_and_noted(
    make_study, application, monkeypatch
):
    opened = silent_source()
    opened.closed = []
    opened.close = lambda: opened.closed.append(True)
    monkeypatch.setattr(live, "open_source", lambda _name, _clock: opened)
    study = make_study()
    session = StudySession(
        study, load_study_sources(study), (), SystemClock(), audio=None
    )
    try:
        session.show(windowed=True)
        session.start_panel.sensor.setText("csv:-")
        session.begin_session("", "en")
        assert isinstance(session.runner.stage, FeltStage)
        records = study.session(session.runner.plan.code).records.intact
        note = next(one for one in records if one.kind == "note")
        assert note.content["text"] == "demonstration by the sensor csv:-"
    finally:
        session.close()
    assert opened.closed


def test_a_sensor_that_is_not_there_is_shown_and_starts_nothing(
    make_study, application
):
    study = make_study()
    session = StudySession(
        study, load_study_sources(study), (), SystemClock(), audio=None
    )
    try:
        session.show(windowed=True)
        session.start_panel.sensor.setText("wt901:/dev/nowhere")
        session.begin()
        assert "/dev/nowhere" in session.control.messages.text()
        assert session.runner is None
    finally:
        session.close()


@pytest.mark.parametrize(("window", "pages"), [("de", "de"), ("fr", "en")])
def test_pages_begin_in_the_window_s_language(
    application, qtbot, monkeypatch, window, pages
):
    monkeypatch.setattr("app.experimenter.start_panel.spoken", lambda: window)
    made = StartPanel(["en", "de"], [])
    qtbot.addWidget(made)
    assert made.language.currentData() == pages
