"""What the command line says of a recording has a place in the wizard, with one effect."""

import argparse
import dataclasses
import re

import numpy as np
import pytest

from app.experimenter.import_sync import SyncPage
from app.experimenter.import_wizard import MOUNTING, REPORT, SYNC
from hapticplayer.capture.mounting import BY_FRAMES, MOUNTINGS
from hapticplayer.capture.sync import methods
from hapticplayer.cli.recording_options import (
    OF_A_RECORDING,
    add_mounting,
    add_processing,
    add_reading,
    add_sync,
    chosen_processing,
)
from hapticplayer.errors import UsageError
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.motion import METHODS
from hapticplayer.sequence.calibration import StoredCalibration, write_calibration
from hapticplayer.sequence.import_preview import preview_import
from hapticplayer.sequence.synchronizing import store_skew
from tests.e2e.command import hapticplayer


def parser():
    made = argparse.ArgumentParser()
    for add in (add_reading, add_mounting, add_sync, add_processing):
        add(made)
    return made


def places(wizard):
    files, sync, mounting = wizard.files, wizard.sync, wizard.mounting
    return {
        "--read-as": files.how,
        "--save-template": files.keep,
        "--mounting": mounting.mounting,
        "--sync": sync.method,
        "--offset": sync.offset,
        "--drift": sync.drift,
        "--slow-motion": sync.slow,
        "--camera": sync.camera,
        "--skew": sync.skew,
        "--method": mounting.motion.method,
        "--time-constant": mounting.motion.time_constant,
        "--remove-spikes": mounting.motion.spikes,
        "--repair-clipping": mounting.motion.clipping,
        "--average": mounting.motion.average,
        "--lowpass": mounting.motion.lowpass,
        "--calibration": mounting.motion.calibration,
    }


def listed(combo):
    return [combo.itemData(row) for row in range(combo.count())]


def test_every_option_of_a_recording_has_a_place(wizard):
    options = re.findall(r"(?m)^ +(--[a-z-]+)", parser().format_help())
    found = places(wizard)
    assert set(found) == set(OF_A_RECORDING) == {*options} - {"--overwrite"}
    for name, widget in found.items():
        assert wizard.isAncestorOf(widget)
        assert widget.accessibleName() or widget.text(), name
    assert listed(found["--sync"]) == [one.name for one in methods.sync_methods()]
    assert listed(found["--method"]) == list(METHODS)
    shown = listed(found["--mounting"])
    assert {BY_FRAMES, *(one.axes for one in MOUNTINGS.values())} <= set(shown)


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["--method", "lowpass", "--remove-spikes", "--lowpass", "20"],
        ["--time-constant", "12.5", "--repair-clipping", "--average", "50"],
    ],
)
def test_processing_is_what_the_command_line_says(wizard, words, tmp_path):
    kept = tmp_path / "sensor.json"
    known = SensorCalibration(gyro_bias_sigma_radps=(0.01,) * 3)
    write_calibration(kept, StoredCalibration(known, "camera", "long.mp4", ""))
    if "--method" not in words:
        words = [*words, "--calibration", str(kept)]
    given = parser().parse_args(words)
    fields = wizard.mounting.motion
    for name, value in {
        fields.time_constant: given.time_constant,
        fields.average: given.average,
        fields.lowpass: given.lowpass,
        fields.calibration: given.calibration,
    }.items():
        name.setText("" if value is None else f"{value}")
    if given.method:
        fields.method.setCurrentIndex(fields.method.findData(given.method))
    fields.spikes.setChecked(given.remove_spikes)
    fields.clipping.setChecked(given.repair_clipping)
    assert fields.chosen() == chosen_processing(given)


def test_a_number_out_of_range_is_told_in_a_sentence(wizard):
    fields = wizard.mounting.motion
    fields.average.setText("fast")
    with pytest.raises(UsageError, match=r"Average to, Hz must be between .* not fast"):
        fields.chosen()


def test_a_clock_drift_is_that_of_the_command_line(wizard, ride, wait_for, tmp_path):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    wizard.next.click()
    assert wizard.stack.currentIndex() == SYNC
    page = wizard.sync
    before = page.choice()
    middle_s = 0.5 * wizard.preview.clip.duration_s
    page.drift.setValue(250.0)
    page.drift.valueChanged.emit(250.0)
    chosen = page.choice().clock_map
    assert chosen.rate == pytest.approx(1.00025)
    assert chosen.offset_at(middle_s) == pytest.approx(
        before.clock_map.offset_at(middle_s), abs=0.001
    )
    assert page.strip.rate == chosen.rate
    page.looked.setChecked(True)
    wizard.next.click()
    assert wizard.stack.currentIndex() == MOUNTING
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    target = tmp_path / "by-command"
    said = hapticplayer(
        *("import", folder / "ride.mp4", "--imu", folder / "log.csv", "-o", target),
        *(f"--offset={chosen.offset_at(middle_s)!r}", "--drift", "250"),
    )
    assert said.returncode == 0, said.stderr
    with (
        np.load(wizard.made / "motion.npz") as made,
        np.load(target / "motion.npz") as wanted,
    ):
        np.testing.assert_allclose(made["time_s"], wanted["time_s"], atol=1e-9)


def test_the_sound_delay_of_another_camera_can_be_taken(wizard, ride, wait_for):
    store_skew("Cam 5", 0.04)
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    page = wizard.sync
    before_s = page.offset.value()
    page.camera.setCurrentIndex(page.camera.findText("Cam 5"))
    page.camera.activated.emit(page.camera.currentIndex())
    assert page.skew.value() == 40.0
    assert page.offset.value() == pytest.approx(before_s - 0.04)
    assert page.choice().sound_late_s == pytest.approx(0.04)


def test_a_clock_that_counts_from_1970_keeps_its_offset(wizard, ride, application):
    folder, _ = ride
    found = preview_import(folder / "ride.mp4", folder / "log.csv", None, "offset")
    page = SyncPage()
    page.show_found(dataclasses.replace(found, begin_s=1.7e9))
    assert page.choice().clock_map.offset_s == -1.7e9
    page.close_jobs()


def test_frames_may_decide_the_mounting_later(wizard, ride, wait_for):
    folder, _ = ride
    wizard.take([folder / "ride.mp4", folder / "log.csv"])
    wait_for(wizard.next.isEnabled)
    page = wizard.mounting
    page.mounting.setCurrentIndex(page.mounting.findData(BY_FRAMES))
    assert page.axes == BY_FRAMES
    assert "from the frames" in page.gravity.text()
    assert page.triad.axes == "x,y,z"
