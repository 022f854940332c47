"""The import wizard is driven as a person would, on rides that were simulated."""

import dataclasses
import functools
import sys
import threading
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from scipy.signal import resample_poly

from app.bridge.jobs import in_child
from app.experimenter import import_suggestion, import_wizard
from app.experimenter.import_mounting import Triad
from app.experimenter.import_wizard import FILES, MOUNTING, REPORT, SYNC, ImportWizard
from app.experimenter.sync_strip import (
    OF_CLIP,
    OF_LOG,
    Lane,
    SyncStrip,
    columns,
    tick_step_s,
)
from hapticplayer.capture import formats, read_recording
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.capture.sync import methods
from hapticplayer.capture.sync.result import PictureEvidence, Synchronisation
from hapticplayer.capture.vision import estimate, is_available
from hapticplayer.errors import Message
from hapticplayer.media.encode import write_clip
from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry
from hapticplayer.model import ClockMap
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.playback.phases import Phase
from hapticplayer.sequence import open_sequence, recognising
from hapticplayer.sequence.calibration import StoredCalibration, write_calibration
from hapticplayer.sequence.recognising import recognise
from hapticplayer.sequence.synchronizing import stored_skews
from hapticplayer.simulation.rides.gpmf_writer import write_payloads
from hapticplayer.simulation.rides.sync_clips import simulate_pats
from tests.unit.capture.vision.made_up import stepping, steps, suggested, turning

SECONDS = 20


@pytest.fixture(scope="module")
def ride(tmp_path_factory):
    """A clip with pats, its log, a stranger's log, a GoPro's file, and the truth."""
    folder = tmp_path_factory.mktemp("pats")
    made = simulate_pats(41_001, hard=False, rate_hz=200, duration_s=SECONDS)
    other = simulate_pats(41_002, hard=False, rate_hz=200, duration_s=SECONDS)
    grey = (np.full((36, 64, 3), k % 250, np.uint8) for k in range(30 * SECONDS))
    sound = resample_poly(made.audio, 3, 1).astype(np.float32)[:, None]
    write_clip(folder / "ride.mp4", grey, frame_rate_hz=30, audio=sound)
    write_imu_csv(folder / "log.csv", made.imu)
    write_imu_csv(folder / "other.csv", other.imu)
    own = dataclasses.replace(made.imu, time_s=made.imu.time_s - made.imu.time_s[0])
    packets = [TelemetryPacket(t, 1.0, p) for t, p in write_payloads(own)]
    add_telemetry(folder / "ride.mp4", folder / "gopro.mp4", packets)
    return folder, made


@pytest.fixture(scope="module")
def reading_once():
    """Return `recognise` with a memory: most tests begin with the same files."""
    known = {}

    @functools.wraps(recognise)
    def read(*arguments, progress):
        if (key := repr(arguments)) not in known:
            known[key] = recognise(*arguments, progress=progress)
        return known[key]

    return read


@pytest.fixture
def wizard(application, qtbot, tmp_path, monkeypatch, reading_once):
    for module in (recognising, import_wizard):  # for a process, it is found by name
        monkeypatch.setattr(module, "recognise", reading_once)
    made = ImportWizard(str(tmp_path), tmp_path / "library")
    qtbot.addWidget(made)
    made.show()
    before = set(threading.enumerate())
    yield made
    made.close_jobs()
    assert not [t for t in threading.enumerate() if t not in before and t.is_alive()]


def true_offset_s(made) -> float:
    log_s = (made.pats_s[1] - made.clock_map.offset_s) / made.clock_map.rate
    return float(made.pats_s[1] - log_s)


def test_a_ride_goes_from_files_to_a_report_in_the_library(
    wizard, qtbot, ride, wait_for, tmp_path
):
    folder, made = ride
    assert not wizard.next.isEnabled()
    wizard.take([folder / "log.csv", folder / "ride.mp4"])  # in any order
    wait_for(wizard.next.isEnabled)
    assert "64 \u00d7 36" in wizard.files.facts.text()
    assert "200 Hz" in wizard.files.facts.text()
    wizard.next.click()
    assert wizard.stack.currentIndex() == SYNC
    assert "Tap marks found" in wizard.sync.verdict.text()
    assert wizard.sync.offset.value() == pytest.approx(true_offset_s(made), abs=0.005)
    assert wizard.sync.looked.isHidden()
    wait_for(lambda: wizard.sync.frame.shown_s is not None)
    assert wizard.sync.frame.shown_s == pytest.approx(made.pats_s[0], abs=0.04)
    wizard.next.click()
    wizard.mounting.title.setText("A ride: with / in its name")
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    assert wizard.made == tmp_path / "library" / "A ride_ with _ in its name"
    sequence = open_sequence(wizard.made)
    assert sequence.title == "A ride: with / in its name"
    kept = sequence.description["provenance"]["synchronisation"]
    assert kept["method"] == "pats"
    assert kept["seen_by_person"]
    assert kept["offset_s"] == pytest.approx(true_offset_s(made), abs=0.005)
    text = wizard.report.toPlainText()
    for name in (
        "Synchronisation",
        "Clock drift",
        "Residual gravity",
        "Workspace used",
    ):
        assert name in text
    with qtbot.waitSignal(wizard.play_wanted) as wanted:
        wizard.next.click()
    assert wanted.args == [wizard.made]


def test_a_camera_with_its_own_motion_needs_no_pats(wizard, ride, wait_for, tmp_path):
    wizard.take([ride[0] / "gopro.mp4"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    assert "the clip's clock" in wizard.sync.verdict.text()
    assert wizard.next.isEnabled()
    wizard.next.click()
    wizard.mounting.mounting.setCurrentIndex(
        wizard.mounting.mounting.findData("-x,-y,z")
    )
    kept = tmp_path / "camera.json"
    wizard.mounting.calibration.setText(str(kept))
    wizard.next.click()
    assert "there is no such file" in wizard.problem.text()
    known = SensorCalibration(gyro_bias_sigma_radps=(0.01,) * 3)
    write_calibration(kept, StoredCalibration(known, "other camera", "long.mp4", ""))
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    made = open_sequence(wizard.made)
    given = made.description["provenance"]["processing"]["calibration"]
    assert given["source"] == "long.mp4"
    assert "calibration is of other camera" in wizard.report.toPlainText()
    assert made.description["provenance"]["mounting"] == "-x,-y,z"
    assert made.description["provenance"]["synchronisation"]["method"] == "embedded"
    with np.load(wizard.made / "imu.npz") as kept:
        turned = kept["specific_force_mps2"]
    camera = read_recording(ride[0] / "gopro.mp4").imu.specific_force_mps2
    np.testing.assert_allclose(turned, camera * (-1.0, -1.0, 1.0), atol=1e-6)


def test_a_real_camera_is_recognised_and_imported(wizard, wait_for, shared_data):
    wizard.take([shared_data / "capture" / "gopro" / "karma.mp4"])
    wait_for(wizard.next.isEnabled)
    facts = wizard.files.facts.text()
    assert "854 \u00d7 480, 29.97 fps" in facts
    assert "198.7 Hz" in facts
    assert "z pointed up" in facts
    assert "does not timestamp" in wizard.files.notes.text()
    assert "does not timestamp" in wizard.sync.verdict.text()
    assert ("this is corrected" in wizard.sync.verdict.text()) == is_available()
    for _ in range(3):
        wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    made_of = open_sequence(wizard.made).description["provenance"]
    assert made_of["mounting"] == "x,y,z"
    assert made_of["imu_samples"] == 2397


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
    assert described["provenance"]["synchronisation"]["method"] == "offset"
    assert "doubtful" in wizard.report.toPlainText()


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


def test_stopping_in_the_middle_leaves_nothing(
    wizard, ride, wait_for, tmp_path, monkeypatch
):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    is_writing, may_go_on = threading.Event(), threading.Event()

    def held(*arguments, progress, **options):
        def report(fraction, step):
            if fraction > 0.0:
                is_writing.set()
                may_go_on.wait(60.0)
            progress(fraction, step)

        return in_child(*arguments, progress=report, **options)

    monkeypatch.setattr(import_wizard, "in_child", held)
    wizard.next.click()
    wizard.next.click()
    wizard.next.click()
    wait_for(is_writing.is_set)
    wizard.progress.stop.click()
    may_go_on.set()
    wait_for(lambda: not wizard.jobs.is_busy)
    assert wizard.stack.currentIndex() == MOUNTING
    assert not list(tmp_path.rglob("sequence.json"))
    assert not list(tmp_path.rglob("*.part"))
    assert wizard.next.isEnabled()  # and it can be tried again


def test_closing_while_it_looks_does_not_hold_the_window_up(wizard, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    assert wizard.jobs.is_busy
    wizard.reject()
    assert wizard.isHidden()
    wait_for(lambda: not wizard.jobs.is_busy)
    assert wizard.recognised is None or not wizard.isVisible()


def test_a_closed_wizard_starts_no_work_for_the_last_input(wizard, ride):
    folder, _ = ride
    wizard.reject()
    wizard.files.video.setText(str(folder / "gopro.mp4"))
    wizard.files.changed.emit()
    assert not wizard.jobs.is_busy


def test_a_doubtful_log_asks_and_takes_the_answer(wizard, ride, wait_for, tmp_path):
    folder, made = ride
    imu = made.imu
    g = np.column_stack(
        [imu.time_s, imu.specific_force_mps2 / 9.80665, imu.angular_rate_radps]
    )
    log = tmp_path / "other logger.csv"
    np.savetxt(log, g, delimiter=";", header="t;a;b;c;d;e;f", fmt="%.6f")
    wizard.take([folder / "ride.mp4", log])
    question = wizard.files.question
    wait_for(question.isVisible)
    assert not wizard.next.isEnabled()
    question.other.setText("columns=rubbish")
    question.take.click()
    wait_for(lambda: not wizard.jobs.is_busy and question.isVisible())
    question.other.setText(
        "columns=time,ax,ay,az,gx,gy,gz accel-unit=g rate-unit=rad/s"
    )
    question.take.click()
    wait_for(lambda: "units" in question.text.text())
    radio = next(b for b in question.answers.buttons() if b.text() == "time-unit=s")
    radio.click()
    assert question.other.text() == "time-unit=s"
    question.take.click()
    wait_for(wizard.next.isEnabled)
    assert "in g" in wizard.files.notes.text()
    assert wizard.files.keep.isVisible()


def test_a_log_in_two_files_is_read_as_one(wizard, ride, wait_for, tmp_path):
    folder, made = ride
    imu = made.imu
    logs = [tmp_path / "acc.csv", tmp_path / "gyr.csv"]
    for log, values in zip(
        logs, (imu.specific_force_mps2, imu.angular_rate_radps), strict=True
    ):
        np.savetxt(
            log, np.column_stack([imu.time_s, values]), fmt="%.6f", delimiter=","
        )
    wizard.take([folder / "ride.mp4", *logs])
    question = wizard.files.question
    wait_for(question.isVisible)
    assert "2 tables" in question.text.text()
    words = "columns=time,ax,ay,az/time,gx,gy,gz time-unit=s accel-unit=m/s2"
    question.other.setText(f"{words} rate-unit=rad/s")
    question.take.click()
    wait_for(wizard.next.isEnabled)
    assert "200 Hz" in wizard.files.facts.text()
    assert wizard.files.chosen() == (folder / "ride.mp4", tuple(logs))


def test_a_log_that_is_mounted_otherwise_gets_a_proposal(
    wizard, ride, wait_for, tmp_path
):
    from hapticplayer.capture.mounting import mounted

    folder, made = ride
    # the actor's right, front and up in the recorder's axes, and back again
    log = tmp_path / "upside-down.csv"
    write_imu_csv(log, mounted(made.imu, "-x,y,-z"))
    wizard.take([folder / "ride.mp4", log])
    wait_for(wizard.next.isEnabled)
    assert "-z pointed up" in wizard.files.facts.text()
    page = wizard.mounting
    assert page.axes == "-x,y,-z"
    assert "Consistent" in page.gravity.text()
    page.mounting.setCurrentIndex(0)
    assert "another side" in page.gravity.text()
    assert page.triad.axes == "x,y,z"


def test_the_chosen_rendering_is_explained_and_taken(wizard):
    fields = wizard.mounting.rendering
    assert fields.chosen().preset == "balanced"
    assert not fields.chosen().fits_gain
    balanced = fields.preset_text.text()
    fields.preset.setCurrentIndex(fields.preset.findText("Equal"))
    assert "every participant" in fields.preset_text.text() != balanced
    assert fields.chosen().preset == "equal"


def test_problems_are_told_on_the_page(wizard, ride, wait_for, tmp_path):
    wizard.take([ride[0] / "ride.mp4"])  # a clip without motion
    wait_for(wizard.files.suggestion.isVisible)
    assert "no motion" in wizard.files.suggestion.reason.text()
    assert not wizard.next.isEnabled()
    wizard.take([ride[0] / "ride.mp4", ride[0] / "gopro.mp4"])
    assert "two videos" in wizard.files.problem.text()
    wizard.files.log.setText(str(tmp_path / "missing.csv"))
    wizard.files.log.editingFinished.emit()
    wait_for(lambda: "missing.csv" in wizard.files.problem.text())


def test_a_skew_moves_the_offset_and_is_kept_for_its_camera(
    wizard, ride, wait_for, tmp_path, monkeypatch
):
    folder, _ = ride
    monkeypatch.setattr(
        "hapticplayer.sequence.recognising.camera_of", lambda _path: "Cam 5"
    )
    found = recognise(folder / "ride.mp4", folder / "log.csv")
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


def test_files_that_are_dropped_on_the_window_are_imported(
    window, ride, wait_for, settings, tmp_path
):
    settings.keep("library", str(tmp_path / "lib"))
    content = QMimeData()
    names = ("ride.mp4", "log.csv")
    content.setUrls([QUrl.fromLocalFile(str(ride[0] / name)) for name in names])
    event = QDropEvent(
        QPointF(50, 50),
        Qt.DropAction.CopyAction,
        content,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    window.dropEvent(event)
    wizard = window.findChild(ImportWizard)
    wait_for(wizard.next.isEnabled)
    for _ in range(3):
        wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    wizard.next.click()
    wait_for(lambda: window.player.snapshot().phase is Phase.PLAYING)
    assert window.player.snapshot().source.path == tmp_path / "lib" / "ride"


def test_the_window_may_close_while_an_import_looks(window, ride):
    window.dialogs.import_recording([Path(ride[0] / "gopro.mp4")])
    assert window.findChild(ImportWizard).stack.currentIndex() == FILES
    window.close()  # the fixture sees that no thread is left


def test_the_triad_says_its_axes(application, qtbot):
    triad = Triad()
    qtbot.addWidget(triad)
    triad.show_axes("y,-x,z", (0.0, 0.0, 1.0))
    assert triad.accessibleName() == "Right is y, front is -x, up is z"
    assert not triad.grab().toImage().isNull()


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


def test_frames_and_gyro_are_lanes_of_their_own(wizard, ride):
    found = recognise(ride[0] / "ride.mp4", ride[0] / "log.csv")
    times = np.arange(0.0, SECONDS, 1 / 30)
    turns = np.exp(-0.5 * ((times - 12.0) / 0.5) ** 2)
    seen = PictureEvidence(10.0, 0.94, 3.0, 0.9, 0.001, 0.01, 0.002)
    sync = Synchronisation(
        ClockMap(4.0, 1.00008, confidence=0.97),
        "pictures",
        offset_sigma_s=0.0034,
        pictures=seen,
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


def test_lists_of_formats_and_methods_are_the_engines(wizard):
    shown = [
        wizard.files.format.itemData(k) for k in range(wizard.files.format.count())
    ]
    assert shown == ["", *(one.name for one in formats.FORMATS)]
    shown = [wizard.sync.method.itemData(k) for k in range(wizard.sync.method.count())]
    assert shown == [one.name for one in methods.SYNC_METHODS]


def test_a_new_entry_is_in_the_lists(application, qtbot, monkeypatch, tmp_path):
    form = formats.RecordingFormat("dummy", Message("Dummy logger"), "nowhere:READER")
    method = methods.SyncMethod("dummy", Message("a dummy method"), "nowhere:by_guess")
    monkeypatch.setattr(formats, "FORMATS", (*formats.FORMATS, form))
    monkeypatch.setattr(methods, "SYNC_METHODS", (*methods.SYNC_METHODS, method))
    made = ImportWizard(str(tmp_path), tmp_path / "library")
    qtbot.addWidget(made)
    assert made.files.format.findText("Dummy logger") >= 0
    row = made.sync.method.findText("dummy")
    made.sync.method.setCurrentIndex(row)
    assert made.sync.method_text.text() == "a dummy method"
    made.close_jobs()


def test_another_method_and_format_can_be_chosen(wizard, ride, wait_for):
    folder, made = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.files.format.setCurrentIndex(wizard.files.format.findData("phyphox"))
    wizard.files.format.activated.emit(wizard.files.format.currentIndex())
    wait_for(lambda: not wizard.jobs.is_busy)
    assert "is not a log of phyphox" in wizard.files.problem.text()
    wizard.files.format.setCurrentIndex(0)
    wizard.files.format.activated.emit(0)
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    wizard.sync.method.setCurrentIndex(wizard.sync.method.findData("variance"))
    wizard.sync.method.activated.emit(wizard.sync.method.currentIndex())
    wait_for(lambda: "First sudden rise" in wizard.sync.verdict.text())
    assert wizard.sync.offset.value() == pytest.approx(true_offset_s(made), abs=0.05)


@pytest.fixture
def plain(ride, tmp_path):
    """A video that has neither telemetry nor a log."""
    path = tmp_path / "plain.mp4"
    path.write_bytes((ride[0] / "ride.mp4").read_bytes())
    return path


def test_a_plain_video_gets_an_estimate_if_a_person_wants_it(
    wizard, ride, plain, wait_for, monkeypatch
):
    def here(work, *arguments, progress, **options):
        return work(*arguments, progress=progress, **options)

    def seen(_clip, *, gain, progress):
        progress(0.5, "following")
        return suggested(steps(turn_radps=turning, sinking=stepping), gain=gain)

    monkeypatch.setattr(import_wizard, "in_child", here)
    monkeypatch.setattr(estimate, "suggest_motion", seen)
    box = wizard.files.suggestion
    wizard.take([plain])
    wait_for(box.isVisible)
    assert "plain.mp4: holds no motion telemetry" in box.reason.text()
    assert "Nothing measures this motion" in box.expect.text()
    assert not wizard.files.problem.isVisible()
    assert not wizard.next.isEnabled()

    box.choice.click()
    wizard.next.click()
    assert wizard.stack.currentIndex() == MOUNTING
    assert not wizard.mounting.mounting.isVisible()
    assert not wizard.mounting.triad.isVisible()
    assert not wizard.mounting.rendering.lever_arm.isVisible()
    wizard.back.click()
    assert wizard.stack.currentIndex() == FILES
    wizard.next.click()
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    assert "estimated" in open_sequence(wizard.made).tracks
    assert "estimated from the picture, nothing measured it" in (
        wizard.report.toPlainText()
    )

    wizard.another.click()
    wizard.take([ride[0] / "ride.mp4", ride[0] / "log.csv"])
    wait_for(wizard.next.isEnabled)
    assert not box.isVisible()
    wizard.next.click()
    wizard.next.click()
    assert wizard.mounting.mounting.isVisible()


def test_without_opencv_the_estimate_cannot_be_chosen(
    wizard, plain, wait_for, monkeypatch
):
    monkeypatch.setattr(import_suggestion, "is_available", lambda: False)
    wizard.take([plain])
    wait_for(wizard.files.suggestion.isVisible)
    assert not wizard.files.suggestion.choice.isEnabled()
    assert "hapticplayer[vision]" in wizard.files.suggestion.missing.text()
    assert wizard.files.suggestion.missing.isVisible()
