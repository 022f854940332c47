"""The recorder's page: what is chosen, what is shown live, and the take afterwards."""

import os
import struct
import threading
import tty
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox
from still_recorder import STATE, StillRecorder, overview, silent_source, take

from app.bridge.settings import RECORD
from app.experimenter import record_page
from app.experimenter.import_wizard import ImportWizard
from app.experimenter.record_choice import Found
from app.experimenter.record_feel import FeelSetup
from app.experimenter.record_page import CHOOSING, TAKE, Opened, RecordPage
from app.experimenter.sync_strip import OF_CLIP, OF_LOG
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.capture.live.source import Samples
from hapticplayer.clock import SystemClock
from hapticplayer.errors import Message, UsageError
from hapticplayer.haptics.contract import Mode
from hapticplayer.media.camera_modes import CameraMode
from hapticplayer.model import Mapping
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.player import Player

CAMERA = "lavfi:testsrc2=size=320x180:rate=30"
CHOSEN = {"camera": CAMERA, "microphone": "", "sensor": "wt901", "place": "/dev/ttyS9"}
HD = CameraMode(1280, 720, Fraction(30), "mjpeg")
FOUND = Found((("/dev/video7", "A webcam"),), (), {"/dev/video7": (HD,)})


LATCH = StopLatch()


def silent_player(clock, sink, device):
    return Player(clock, sink, outputs=[device], audio=None, latch=LATCH)


@pytest.fixture
def make_page(application, qtbot, settings, monkeypatch, tmp_path, clip):
    """Make a page whose recorder is `opens`, a function or what it gives."""
    made = []

    def make(opens=None, found=FOUND, kept=CHOSEN, *, has_camera=True, device="none"):
        settings.keep(RECORD, {**kept, "folder": str(tmp_path / "takes")})
        monkeypatch.setattr(record_page, "plugged_in", lambda _progress: found)
        monkeypatch.setattr(record_page, "started", opens)
        monkeypatch.setattr(
            record_page, "finished", lambda _folder: take(has_camera=has_camera)
        )
        monkeypatch.setattr(record_page, "CLIP", clip)  # `folder / CLIP` is this one
        monkeypatch.setattr(record_page, "in_child", lambda *_w, **_more: overview())
        setup = FeelSetup(SystemClock(), device, Mapping(), silent_player, LATCH)
        page = RecordPage(settings, setup)
        qtbot.addWidget(page)
        made.append(page)
        page.show()
        qtbot.waitUntil(lambda: not page.is_looking)
        return page

    yield make
    for page in made:
        page.close_jobs()


def gives(recorder, how=""):
    return lambda *_arguments: Opened(recorder, silent_source(how))


@pytest.fixture
def recording(make_page, wait_for):
    """A page that records, and its recorder."""
    recorder = StillRecorder()
    page = make_page(gives(recorder))
    page.start.click()
    wait_for(lambda: page.recorder is not None)
    return page, recorder


def test_picture_level_rates_losses_and_disk_are_shown_live(recording):
    page, _ = recording
    assert page.live.picture.has_frame
    assert page.live.level.levels[0].peak_db == pytest.approx(-18.0)
    assert page.live.accel.curve_groups[0][2].getData()[1][-1] == pytest.approx(9.8)
    figures = page.live.figures.text()
    for part in ("00:08.0", "30.0 fps, dropped 2", "100.2 Hz, lost 3", "12.3 GB"):
        assert part in figures
    assert "nothing for 0.5 s" in page.live.notices.text()
    assert page.form.isHidden()


def test_mark_and_stop_lead_to_the_take(recording, wait_for):
    page, recorder = recording
    page.mark.click()
    wait_for(lambda: "marks 2" in page.live.figures.text())
    page.stop.click()
    wait_for(lambda: page.stack.currentIndex() == TAKE)
    assert recorder.stops == 1
    wait_for(lambda: "Taps found: 3" in page.take.said.text())
    assert [lane.name for lane in page.take.strip.lanes] == [
        "sound",
        "acceleration without gravity, p",
    ]
    wait_for(page.bring_in.isEnabled)
    assert page.again.isVisible()


def test_a_recorder_that_ends_by_itself_shows_its_take(recording, wait_for):
    page, recorder = recording
    recorder.state = replace(STATE, is_over=True)
    wait_for(lambda: page.stack.currentIndex() == TAKE)
    assert recorder.stops == 1


def test_a_take_is_sought_by_key_and_played(recording, wait_for):
    page, _ = recording
    page.end_take()
    wait_for(lambda: page.stack.currentIndex() == TAKE)
    QTest.keyClick(page.take.strip, Qt.Key.Key_Right)
    wait_for(lambda: page.take.position.text().startswith("00:01"))
    page.take.play.click()
    wait_for(lambda: page.take.player.snapshot().is_playing)
    wait_for(page.again.isEnabled)
    page.again.click()
    assert page.take.player is None
    assert page.stack.currentIndex() == CHOOSING


def test_a_click_beside_a_mark_goes_to_the_mark(recording, wait_for):
    page, _ = recording
    page.end_take()
    wait_for(lambda: "marks: 2" in page.take.said.text())
    wait_for(page.again.isEnabled)
    strip, sought = page.take.strip, []
    strip.sought.connect(sought.append)
    marked, px = strip.grab().toImage(), strip.width() / strip.view_s[1]
    strip.show_marks(())
    assert marked != strip.grab().toImage()
    strip.show_marks([1.2, 0.4])
    for at_px in (1.2 * px + 5, 0.8 * px):
        QTest.mouseClick(strip, Qt.MouseButton.LeftButton, pos=QPoint(int(at_px), 40))
    assert sought[0] == 1.2
    assert sought[1] == pytest.approx(0.8, abs=1.0 / px)
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_Down):
        QTest.keyClick(strip, key)
    assert sought[2:] == [0.4, 1.2]


def test_a_take_without_video_cannot_be_imported(make_page, wait_for):
    page = make_page(gives(StillRecorder()), has_camera=False)
    page.record()
    wait_for(lambda: page.recorder is not None)
    page.end_take()
    wait_for(lambda: page.stack.currentIndex() == TAKE)
    wait_for(lambda: not page.jobs.is_busy)
    assert page.take.play.isHidden()
    assert not page.bring_in.isEnabled()


def test_missing_devices_are_named_with_what_to_do(make_page):
    page = make_page(found=Found((), ()), kept={})
    assert "No camera was found: plug one in" in page.form.missing.text()
    assert not page.start.isEnabled()
    page.form.show_found(FOUND)
    assert "No camera" not in page.form.missing.text()


def test_a_chosen_camera_stays_listed_while_it_is_away(recording, settings):
    page, _ = recording
    names = [page.form.camera.itemData(k) for k in range(page.form.camera.count())]
    assert names == ["", "/dev/video7", CAMERA]
    kept = settings.table(RECORD)
    assert (kept["camera"], kept["sensor"]) == (CAMERA, "wt901")
    assert page.form.chosen().sensor == "wt901:/dev/ttyS9"


def test_size_and_rate_are_those_that_the_camera_offers(make_page, settings):
    page = make_page(kept={**CHOSEN, "camera": "/dev/video7"})
    form = page.form
    assert form.chosen().camera == "/dev/video7"
    assert form.mode.currentText() == "As the camera offers"
    form.mode.setCurrentIndex(1)
    assert form.mode.currentText() == "1280 \u00d7 720, 30 fps"
    form.keep()
    form.show_found(FOUND)
    other = make_page(kept=settings.table(RECORD)).form.chosen().camera
    assert other == form.chosen().camera == f"/dev/video7{HD.options}"
    form.mode.setCurrentIndex(0)
    form.show_found(FOUND)
    assert form.chosen().camera == "/dev/video7"
    form.camera.setCurrentIndex(0)
    form.camera.activated.emit(0)
    assert not form.mode.isEnabled()


def test_closing_asks_and_keeps_what_is_recorded(recording, wait_for):
    page, recorder = recording
    page.reject()
    box = page.findChild(QMessageBox)
    assert page.isVisible()
    box.escapeButton().click()
    assert recorder.stops == 0
    page.reject()
    box = page.findChildren(QMessageBox)[-1]
    box.buttons()[0].click()
    wait_for(lambda: page.stack.currentIndex() == TAKE)
    assert recorder.stops == 1


def test_the_end_of_the_program_keeps_the_take(recording):
    page, recorder = recording
    page.close_jobs()
    assert recorder.stops == 1


def test_a_take_that_is_not_wanted_any_more_is_removed(make_page, tmp_path, wait_for):
    folder, may_open = tmp_path / "takes" / "late", threading.Event()
    recorder = StillRecorder(folder=folder)

    def open_late(*_arguments):
        may_open.wait(30.0)
        folder.mkdir(parents=True)
        return Opened(recorder, silent_source())

    page = make_page(open_late)
    page.record()
    page.reject()
    may_open.set()
    wait_for(lambda: not page.jobs.is_busy)
    assert recorder.stops == 1
    assert not folder.exists()


def test_an_answer_about_the_sensor_opens_it_again(make_page, wait_for):
    given = []

    def ask_for_the_unit(_chosen, _folder, _clock, choices, _ask):
        given.append(choices.given())
        if not given[-1]:
            raise LogQuestion(
                Message("has no unit"), ("accel-unit=g", "accel-unit=m/s2"), "csv:-"
            )
        return Opened(StillRecorder(), silent_source())

    page = make_page(ask_for_the_unit)
    page.record()
    wait_for(page.question.isVisible)
    page.question.answers.buttons()[0].click()
    page.question.take.click()
    wait_for(lambda: page.recorder is not None)
    assert given == [{}, {"accel-unit": "g"}]
    assert page.question.isHidden()


def test_the_network_is_listened_to_after_asking(make_page, wait_for):
    question, allowed = Message("May phones in your network send to it?"), []

    def listen(_chosen, _folder, _clock, _choices, ask):
        allowed.append(ask(question))
        if not allowed[-1]:
            raise UsageError("not allowed")
        return Opened(StillRecorder(), silent_source())

    page = make_page(listen)
    page.record()
    wait_for(lambda: page.findChild(QMessageBox) is not None)
    box = page.findChild(QMessageBox)
    assert box.text() == question
    box.buttons()[0].click()
    wait_for(lambda: page.recorder is not None)
    assert allowed == [False, True]
    page.end_take()
    wait_for(page.again.isEnabled)
    page.again.click()
    page.record()
    wait_for(lambda: page.recorder is not None)
    assert allowed == [False, True, True]


def test_a_silent_sensor_has_how_it_is_started(make_page, wait_for):
    page = make_page(
        gives(StillRecorder(replace(STATE, samples=0)), "send to http://here/")
    )
    page.record()
    wait_for(lambda: "send to http://here/" in page.live.notices.text())


def test_a_preview_leaves_nothing(make_page, tmp_path, wait_for):
    folders = []

    def open_there(_chosen, folder, *_others):
        folder.mkdir()
        folders.append(folder)
        return Opened(StillRecorder(folder=folder), silent_source())

    page = make_page(open_there)
    page.preview.click()
    wait_for(lambda: page.live.picture.has_frame)
    assert not page.form.isEnabled()
    page.preview.click()
    wait_for(lambda: not page.jobs.is_busy and not page.live.picture.has_frame)
    assert not folders[0].parent.exists()
    assert not (tmp_path / "takes").exists()


def test_a_camera_that_cannot_be_opened_is_reported(make_page, wait_for):
    def refuse(*_arguments):
        raise UsageError("the camera is busy; close the other program")

    page = make_page(refuse)
    page.record()
    wait_for(lambda: "camera is busy" in page.problem.text())
    assert page.start.isEnabled()


def test_the_sensor_is_felt_stopped_and_armed_again(make_page, wait_for, monkeypatch):
    page = make_page(gives(StillRecorder()), device="simulated")
    page.record()
    wait_for(lambda: page.recorder is not None)
    feeling, clock = page.feeling, SystemClock()
    feeling.button.click()
    source, player, count = feeling.source, feeling.player, 0

    def feed_at_rest():
        nonlocal count
        rows = [
            (clock.now_s(), 0.01 * (count + k), 0, 0, 9.8, 0, 0, 0) for k in range(5)
        ]
        source.listener(Samples.of(rows))
        count += 5
        return "grip follows" in page.live.felt.text()

    wait_for(feed_at_rest)
    assert feeling.button.text() == "STOP"
    drawn = []
    monkeypatch.setattr(page.live, "show_state", lambda *_state: drawn.append(1))
    for _ in range(20):
        page.poll()
    assert len(drawn) <= 3  # drawing would hold up the sensor's thread
    page.reject()  # as Escape does
    assert (feeling.feel, source.listener) == (None, None)
    assert player.snapshot().leading.mode is Mode.TRIPPED
    assert page.isVisible()
    feeling.button.click()
    assert feeling.button.text().replace("&", "") == "Feel it now"


@pytest.mark.realtime
def test_camera_and_serial_sensor_are_recorded_and_imported(
    make_window, settings, tmp_path, wait_for
):
    """FFmpeg's test picture and sound, and a pseudo-terminal that sends as a WT901 does."""
    window, folder = make_window(), tmp_path / "takes"
    with wt901_port() as port:
        chosen = {
            "camera": CAMERA,
            "microphone": "lavfi:sine=frequency=300",
            "sensor": "wt901",
            "place": f"{port},baud=115200",
            "folder": str(folder),
        }
        settings.keep(RECORD, chosen)
        window.commands.record.trigger()
        page = window.findChild(RecordPage)
        page.start.click()
        wait_for(lambda: page.recorder is not None)
        wait_for(lambda: page.recorder.snapshot().samples > 100)
        wait_for(lambda: page.recorder.snapshot().frames > 20)
        page.stop.click()
        wait_for(page.bring_in.isEnabled)
    assert {one.of for one in page.take.strip.lanes} == {OF_CLIP, OF_LOG}
    page.bring_in.click()
    wizard = window.findChild(ImportWizard)
    wait_for(lambda: wizard.preview is not None)
    assert wizard.preview.recorder == "recorded here"
    assert wizard.preview.found.is_confident
    assert wizard.mounting.title.text() == page.folder.name
    wizard.reject()


@contextmanager
def wt901_port():
    """A port on which a WT901 that lies still sends, a hundred times a second."""
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    is_over, noise = threading.Event(), np.random.default_rng(1)

    def send():
        while not is_over.wait(0.01):
            x, y, z, *rate = noise.integers(-3, 4, 6).tolist()
            os.write(ours, _frame(0x51, x, y, 2048 + z) + _frame(0x52, *rate))

    thread = threading.Thread(target=send, daemon=True)
    thread.start()
    yield os.ttyname(theirs)
    is_over.set()
    thread.join()
    os.close(ours)
    os.close(theirs)


def _frame(kind, x, y, z):
    content = struct.pack("<BB4h", 0x55, kind, x, y, z, 2500)
    return content + bytes([sum(content) & 0xFF])
