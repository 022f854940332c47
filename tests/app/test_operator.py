"""The operator's screen: the participant's picture, the volume, notes with times."""

import re

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from sitting import Person

from hapticplayer.study.preflight import volume_in_checks
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
