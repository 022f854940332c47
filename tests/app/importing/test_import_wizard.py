"""The import wizard is driven as a person would, on rides that were simulated."""

import threading
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from app.bridge.jobs import in_child
from app.experimenter import import_wizard
from app.experimenter.import_wizard import FILES, MOUNTING, REPORT, SYNC, ImportWizard
from hapticplayer.capture import formats, read_recording
from hapticplayer.capture.sync import methods
from hapticplayer.errors import Message
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.playback.phases import Phase
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.calibration import StoredCalibration, write_calibration
from tests.app.importing.conftest import true_offset_s
from tests.needed_extras import needs


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
    kept = sequence.description.provenance["synchronisation"]
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
    wizard.mounting.motion.calibration.setText(str(kept))
    wizard.next.click()
    assert "there is no such file" in wizard.problem.text()
    known = SensorCalibration(gyro_bias_sigma_radps=(0.01,) * 3)
    write_calibration(kept, StoredCalibration(known, "other camera", "long.mp4", ""))
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    made = open_sequence(wizard.made)
    given = made.description.provenance["processing"]["calibration"]
    assert given["source"] == "long.mp4"
    assert "calibration is of other camera" in wizard.report.toPlainText()
    assert made.description.provenance["mounting"] == "-x,-y,z"
    assert made.description.provenance["synchronisation"]["method"] == "embedded"
    with np.load(wizard.made / "imu.npz") as kept:
        turned = kept["specific_force_mps2"]
    camera = read_recording(ride[0] / "gopro.mp4").imu.specific_force_mps2
    np.testing.assert_allclose(turned, camera * (-1.0, -1.0, 1.0), atol=1e-6)


def test_a_real_camera_is_recognised_and_imported(wizard, wait_for, shared_data):
    from hapticplayer.extras.frames.watching import is_available

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
    made_of = open_sequence(wizard.made).description.provenance
    assert made_of["mounting"] == "x,y,z"
    assert made_of["imu_samples"] == 2397


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
    assert wizard.preview is None or not wizard.isVisible()


def test_a_closed_wizard_starts_no_work_for_the_last_input(wizard, ride):
    folder, _ = ride
    wizard.reject()
    wizard.files.video.setText(str(folder / "gopro.mp4"))
    wizard.files.changed.emit()
    assert not wizard.jobs.is_busy


def test_files_that_are_dropped_on_the_window_are_imported(
    window, ride, wait_for, settings, tmp_path
):
    settings.keep("library", str(tmp_path / "lib"))
    content = QMimeData()
    names = ("ride.mp4", "log.csv")
    content.setUrls([QUrl.fromLocalFile(str(ride[0] / name)) for name in names])
    offered = (
        Qt.DropAction.CopyAction,
        content,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(window, QDragEnterEvent(QPoint(50, 50), *offered))
    QApplication.sendEvent(window, QDropEvent(QPointF(50, 50), *offered))
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


def test_lists_of_formats_and_methods_are_the_engines(wizard):
    shown = [
        wizard.files.format.itemData(k) for k in range(wizard.files.format.count())
    ]
    assert shown == ["", *(one.name for one in formats.recording_formats())]
    shown = [wizard.sync.method.itemData(k) for k in range(wizard.sync.method.count())]
    assert shown == [one.name for one in methods.sync_methods()]


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


@needs("loggers")
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
