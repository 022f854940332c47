"""The page that shows clip and log on one timeline: seen, heard, dragged, taken."""

import dataclasses
import sys
from types import SimpleNamespace

import av
import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from app.experimenter.import_wizard import REPORT, SYNC
from app.experimenter.quality_view import QualityView, value_of
from app.experimenter.sync_strip import (
    OF_CLIP,
    OF_LOG,
    Lane,
    SyncStrip,
    columns,
    tick_step_s,
)
from hapticplayer.capture.clock_lag import FRAMES, ClockLag
from hapticplayer.capture.sync.result import FrameEvidence, Synchronisation
from hapticplayer.model import ClockMap
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.import_preview import preview_import
from hapticplayer.sequence.report import Finding, Mark
from hapticplayer.sequence.synchronizing import stored_skews
from tests.app.importing.conftest import SECONDS


def test_doubt_cannot_be_passed_without_a_look(wizard, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "other.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    assert "are uncertain" in wizard.sync.verdict.text()
    assert not wizard.next.isEnabled()
    wizard.sync.offset.setValue(wizard.sync.offset.value() + 0.5)
    assert not wizard.next.isEnabled()  # set manually is no look either
    wizard.sync.looked.setChecked(True)
    assert wizard.next.isEnabled()
    wizard.next.click()
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    described = open_sequence(wizard.made).description
    assert described.provenance["synchronisation"]["method"] == "offset"
    assert "doubtful" in wizard.report.toPlainText()


@pytest.fixture
def slow_ride(ride, tmp_path):
    """The ride as a phone tells that it recorded it at 240 frames per second."""
    path = tmp_path / "slow.mp4"
    options = {"movflags": "use_metadata_tags"}
    with (
        av.open(str(ride[0] / "ride.mp4")) as clip,
        av.open(str(path), "w", container_options=options) as copy,
    ):
        copy.metadata["com.android.capture.fps"] = "240.0"
        kept = (*clip.streams.video, *clip.streams.audio)
        streams = {one.index: copy.add_stream_from_template(one) for one in kept}
        for packet in clip.demux(kept):
            if packet.size:
                packet.stream = streams[packet.stream_index]
                copy.mux(packet)
    return path


def test_slow_motion_is_asked_about_and_stretches_the_log(
    wizard, ride, slow_ride, wait_for
):
    wizard.take([slow_ride, ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    page = wizard.sync
    assert "240 frames per second and plays at 30" in page.verdict.text()
    assert page.slow.value() == page.strip.rate == 8.0
    assert not wizard.next.isEnabled()
    page.slow.setValue(4.0)
    wait_for(lambda: not wizard.jobs.is_busy)
    assert page.strip.rate == page.slow.value() == 4.0
    page.offset.setValue(0.5)
    page.looked.setChecked(True)
    wizard.next.click()
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    clock = open_sequence(wizard.made).description.clock_map
    assert (clock.rate, clock.offset_s) == pytest.approx((4.0, 0.5))


def test_a_clip_that_is_said_to_play_as_recorded_is_synchronised(
    wizard, ride, slow_ride, wait_for
):
    wizard.take([slow_ride, ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.sync.slow.setValue(1.0)
    wait_for(lambda: not wizard.jobs.is_busy)
    assert "Tap marks found" in wizard.sync.verdict.text()
    assert wizard.sync.slowed == 1.0
    wizard.take([ride[0] / "ride.mp4", ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    assert wizard.sync.slowed is None


def test_slow_motion_can_be_said_of_any_clip(wizard, ride, wait_for):
    wizard.take([ride[0] / "ride.mp4", ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.sync.slow.setValue(2.0)
    wait_for(lambda: not wizard.jobs.is_busy)
    assert wizard.sync.verdict.text().startswith("Enter the offset")
    assert wizard.sync.choice().clock_map.rate == 2.0


def test_keys_move_the_log_and_the_cursor(wizard, qtbot, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    page = wizard.sync
    first_s, cursor_s = page.offset.value(), page.strip.cursor_s
    qtbot.keyClick(page.strip, Qt.Key.Key_Right)
    qtbot.keyClick(page.strip, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert page.offset.value() == pytest.approx(first_s - 0.009, abs=1e-6)
    assert "set manually" in page.verdict.text()
    qtbot.keyClick(page.strip, Qt.Key.Key_Period)
    assert page.strip.cursor_s == pytest.approx(cursor_s + 1 / 30)
    wait_for(lambda: (page.frame.shown_s or 0.0) > cursor_s)


def test_the_pats_are_heard_left_and_ticked_right(wizard, ride, wait_for, monkeypatch):
    folder, made = ride
    played = []

    def play(data, samplerate):
        assert samplerate == 48_000
        played.append(data)

    output = SimpleNamespace(play=play, stop=lambda: played.append(None))
    monkeypatch.setitem(sys.modules, "sounddevice", output)
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    wizard.sync.hear.click()
    wait_for(lambda: bool(played))
    begin_s = wizard.sync.strip.view_s[0]
    left, right = (played[0][:, k] for k in (0, 1))
    for at_s in made.pats_s[:3]:
        at = round((at_s - begin_s) * 48_000)
        near = slice(at - 1500, at + 1500)
        assert np.abs(left[near]).max() > 0.2
        ticked = np.flatnonzero(np.abs(right[near]) > 0.1)
        assert abs(ticked[0] - 1500) / 48_000 < 0.02  # of the peak, not of its onset
    wizard.reject()
    assert played[-1] is None


def test_a_skew_moves_the_offset_and_is_kept_for_its_camera(
    wizard, ride, wait_for, tmp_path
):
    folder, _ = ride
    found = preview_import(folder / "ride.mp4", folder / "log.csv")
    found = dataclasses.replace(
        found, clip=dataclasses.replace(found.clip, camera="Cam 5")
    )
    wizard.on_found(found)
    wizard.go_to(SYNC)
    page = wizard.sync
    before_s = page.offset.value()
    page.skew.setValue(40)
    assert page.offset.value() == pytest.approx(before_s - 0.04, abs=1e-6)
    assert "Tap marks found" in page.verdict.text()  # the pats are as certain as before
    assert page.choice().sound_late_s == pytest.approx(0.04)
    page.keep_skew.setChecked(True)
    page.keep()
    assert stored_skews() == {"Cam 5": 0.04}


def test_dragging_moves_the_log_by_what_the_pointer_moves(application, qtbot):
    strip = SyncStrip()
    qtbot.addWidget(strip)
    strip.resize(1000, 200)
    times = np.arange(0.0, 10.0, 0.001)
    lanes = [
        Lane("sound", (times, times), OF_CLIP),
        Lane("log", (times, times), OF_LOG),
    ]
    strip.show_lanes(lanes, (1.0, 1.5, 2.0), ClockMap(0.25))
    assert strip.view_s == pytest.approx((0.0, 9.999))
    moved, pointed = [], []
    strip.shifted.connect(moved.append)
    strip.pointed.connect(pointed.append)
    _move(strip, 200, Qt.MouseButton.NoButton)
    assert pointed[-1] == pytest.approx(200 * 9.999 / 1000)
    qtbot.mousePress(strip, Qt.MouseButton.LeftButton, pos=QPointF(500, 150).toPoint())
    _move(strip, 530, Qt.MouseButton.LeftButton)
    assert moved[-1] == pytest.approx(0.25 + 30 * 9.999 / 1000, abs=0.001)
    strip.show_close_up()
    assert strip.view_s == pytest.approx((0.6, 2.6))


def test_close_up_is_what_the_synchronisation_went_by(application, qtbot):
    strip = SyncStrip()
    qtbot.addWidget(strip)
    times = np.arange(0.0, 60.0, 0.01)
    turns = np.exp(-0.5 * ((times - 40.0) / 0.5) ** 2)
    lanes = [Lane("turns", (times, turns), OF_CLIP)]
    pats_s = (1.0, 1.5, 2.0)
    strip.show_lanes(lanes, pats_s, ClockMap(0.0))
    strip.show_close_up()
    assert strip.view_s == pytest.approx((0.6, 2.6))
    strip.show_lanes(lanes, pats_s, ClockMap(0.0), is_by_turns=True)
    strip.show_close_up()
    assert np.mean(strip.view_s) == pytest.approx(40.0, abs=0.1)


def test_noise_does_not_fill_a_lane(application, qtbot):
    strip = SyncStrip()
    qtbot.addWidget(strip)
    strip.resize(400, 200)
    times = np.arange(0.0, 60.0, 0.01)
    turns = np.where(times > 30.0, 1.0, 0.01)
    strip.show_lanes([Lane("", (times, turns), OF_CLIP)], (), ClockMap(0.0))
    strip.show_span(1.0, 5.0)
    image = strip.grab().toImage()
    middle = image.pixelColor(200, 100)
    strip.show_span(40.0, 45.0)
    assert middle != strip.grab().toImage().pixelColor(200, 100)


def test_frames_and_gyro_are_lanes_of_their_own(wizard, ride):
    found = preview_import(ride[0] / "ride.mp4", ride[0] / "log.csv")
    times = np.arange(0.0, SECONDS, 1 / 30)
    turns = np.exp(-0.5 * ((times - 12.0) / 0.5) ** 2)
    seen = FrameEvidence(10.0, 0.94, 3.0, 0.9, 20.0, 0.001, 0.01, 0.002)
    sync = Synchronisation(
        ClockMap(4.0, 1.00008, confidence=0.97),
        "frames",
        offset_sigma_s=0.0034,
        frames=seen,
    )
    wizard.on_found(
        dataclasses.replace(
            found, found=sync, turned=(times, turns), gyro=(times - 4.0, turns)
        )
    )
    page = wizard.sync
    names = page.strip.accessibleDescription()
    assert names == "sound, acceleration, rotation in the frames, gyro"
    text = page.verdict.text()
    assert ("\u00b13.4 ms" in text, "94 %" in text, "0.97" in text) == (True,) * 3
    assert page.looked.isHidden()
    begin_s, end_s = page.strip.view_s
    assert 0.5 * (begin_s + end_s) == pytest.approx(12.0, abs=0.1)
    assert page.strip.cursor_s == pytest.approx(12.0, abs=0.1)
    assert page.choice().clock_map.rate == 1.00008


def test_the_lag_of_an_own_clock_is_shown_and_can_be_dragged(wizard, ride):
    found = preview_import(ride[0] / "ride.mp4", ride[0] / "log.csv")
    times = np.arange(0.0, SECONDS, 1 / 30)
    turns = np.exp(-0.5 * ((times - 12.0) / 0.5) ** 2)
    lag = ClockLag(FRAMES, -0.0198, 0.003)
    sync = Synchronisation(
        ClockMap(0.0198, confidence=1.0), "embedded", has_drift=True, lag=lag
    )
    nothing = (np.zeros(0), np.zeros(0))
    own = dataclasses.replace(found, found=sync, sound=nothing, turned=nothing)
    page = wizard.sync
    page.show_found(own)
    assert not page.strip.isVisibleTo(page)
    curve = (times, turns)
    page.show_found(dataclasses.replace(own, turned=curve, gyro=curve))
    assert page.strip.isVisibleTo(page)
    assert not page.skew.isVisibleTo(page)
    text = page.verdict.text()
    assert "this is corrected" in text
    assert "no synchronisation" not in text
    assert page.may_go_on()
    assert page.choice() == sync
    page.offset.setValue(0.015)
    assert "set manually" in page.verdict.text()
    assert page.choice().clock_map.offset_s == 0.015
    assert not page.may_go_on()
    page.looked.setChecked(True)
    assert page.may_go_on()
    assert page.hint.isHidden()  # there was nothing to drag


def test_a_disagreement_is_settled_by_a_button(wizard, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.go_to(SYNC)
    page = wizard.sync
    assert page.sides.isHidden()
    assert not page.hint.isHidden()
    taps = Synchronisation(ClockMap(4.028, confidence=0.9), "pats")
    torn = Synchronisation(ClockMap(4.0, confidence=0.0), "frames", second=taps)
    found = preview_import(folder / "ride.mp4", folder / "log.csv")
    wizard.on_found(dataclasses.replace(found, found=torn))
    assert "Check which is right" in page.verdict.text()
    assert page.hint.isHidden()  # on a small screen the buttons take its place
    assert not page.may_go_on()
    page.sides.taps.click()
    assert page.method.currentData() == "pats"
    wait_for(lambda: not wizard.jobs.is_busy)
    assert page.sides.isHidden()
    assert page.choice().method == "pats"


def test_a_confirmed_offset_is_not_called_unlikely(application):
    more = {"method": "frames", "confidence": 0.0, "is_confirmed": True}
    text = value_of(Finding("sync", Mark.GOOD, 0.0006, more))
    assert text.startswith("residual 0.6 ms, confirmed by a person (")
    text = value_of(Finding("sync", Mark.BAD, 0.0006, more | {"is_confirmed": False}))
    assert "confidence 0.00" in text


def test_advice_for_the_next_recording_says_so(application, qtbot):
    view = QualityView()
    qtbot.addWidget(view)
    found = [Finding(name, Mark.DOUBTFUL, 1.0, {}) for name in ("leak", "rate")]
    view.show_findings(found)
    assert "Next time: keep still" in view.toPlainText()
    assert "Next time: record at 100 Hz" in view.toPlainText()


def test_a_low_window_cuts_no_text_off(wizard, ride, application):
    found = preview_import(ride[0] / "ride.mp4", ride[0] / "log.csv")
    seen = FrameEvidence(10.0, 0.94, 3.0, 0.9, 20.0, 0.001, 0.01, 0.002, "vectors")
    sync = Synchronisation(ClockMap(4.0, confidence=0.3), "frames", frames=seen)
    wizard.on_found(dataclasses.replace(found, found=sync))
    wizard.go_to(SYNC)
    wizard.resize(940, 540)  # a screen of 1080 lines at 200 %
    application.processEvents()
    for text in (wizard.sync.verdict, wizard.sync.method_text):
        assert text.height() >= text.heightForWidth(text.width())
    assert wizard.height() == 540


def test_a_given_offset_is_left_to_the_person(wizard, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    page = wizard.sync
    page.method.setCurrentIndex(page.method.findData("offset"))
    page.method.activated.emit(page.method.currentIndex())
    wait_for(lambda: "Enter the offset" in page.verdict.text())
    assert "--offset" not in page.verdict.text()
    page.offset.setValue(1.5)
    page.looked.setChecked(True)
    assert page.choice().clock_map.offset_s == 1.5
    assert page.may_go_on()


def _move(strip, x: float, held: Qt.MouseButton) -> None:
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QMouseEvent

    at = QPointF(x, 150)
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        at,
        at,
        Qt.MouseButton.NoButton,
        held,
        Qt.KeyboardModifier.NoModifier,
    )
    strip.mouseMoveEvent(event)


def test_no_peak_is_lost_when_many_samples_share_a_column():
    times = np.arange(100_000) / 1000.0
    values = np.zeros(100_000)
    values[54_321] = 7.0
    x, y = columns((times, values), (0.0, 100.0), 500)
    assert len(x) <= 501
    assert y.max() == 7.0
    assert x[y.argmax()] == np.floor(54.321 / 100 * 500)


@pytest.mark.parametrize(
    ("least", "step"), [(0.3, 0.5), (1.0, 1.0), (1.2, 2.0), (7, 10)]
)
def test_ticks_are_round_numbers(least, step):
    assert tick_step_s(least) == pytest.approx(step)
