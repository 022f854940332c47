"""The page that says how the sensor was mounted, and how it is rendered."""

import dataclasses

import pytest

from app.experimenter.import_mounting import Triad
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.capture.sync.result import FoundMounting, Synchronisation
from hapticplayer.model import ClockMap
from hapticplayer.sequence.import_preview import preview_import


def test_a_log_that_is_mounted_otherwise_gets_a_proposal(
    wizard, ride, wait_for, tmp_path
):
    from hapticplayer.capture.mounting import mounted

    folder, made = ride
    # the actor's right, front and up in the recorder's axes, and back again
    log = tmp_path / "upside-down.csv"
    write_imu_csv(log, mounted(made.imu, "-x,y,-z"))
    wizard.take([folder / "ride.mp4", log])
    wait_for(lambda: wizard.files.question.isVisibleTo(wizard))
    assert "gravity shows" in wizard.files.question.text.text()
    wizard.files.question.answered.emit(["accel-sign=+"])
    wait_for(wizard.next.isEnabled)
    assert "-z pointed up" in wizard.files.facts.text()
    page = wizard.mounting
    assert page.axes == "-x,y,-z"
    assert "Consistent" in page.gravity.text()
    page.mounting.setCurrentIndex(0)
    assert "another side" in page.gravity.text()
    assert page.triad.axes == "x,y,z"


@pytest.mark.parametrize(
    ("by_frames", "taken", "told"),
    [
        ("-y,x,z", "-y,x,z", "frames show this mounting (ratio 2.40"),
        ("x,-y,-z", "x,y,z", "Only you know"),  # a mirrored film
    ],
)
def test_frames_propose_a_mounting_that_gravity_allows(
    wizard, ride, by_frames, taken, told
):
    found = preview_import(ride[0] / "ride.mp4", ride[0] / "log.csv")
    seen = FoundMounting(by_frames, 2.4, "y,-x,z")
    sync = Synchronisation(ClockMap(4.0), "frames", mounting=seen)
    page = wizard.mounting
    page.show_found(dataclasses.replace(found, found=sync))
    assert page.axes == taken
    assert told in page.gravity.text()
    page.mounting.setCurrentIndex(page.mounting.findData("-x,-y,z"))
    assert "Only you know" in page.gravity.text()


def test_the_chosen_rendering_is_explained_and_taken(wizard):
    fields = wizard.mounting.rendering
    assert fields.chosen().preset == "balanced"
    assert not fields.chosen().fits_gain
    balanced = fields.preset_text.text()
    fields.preset.setCurrentIndex(fields.preset.findText("Equal"))
    assert "every participant" in fields.preset_text.text() != balanced
    assert fields.chosen().preset == "equal"


def test_the_triad_says_its_axes(application, qtbot):
    triad = Triad()
    qtbot.addWidget(triad)
    triad.show_axes("y,-x,z", (0.0, 0.0, 1.0))
    assert triad.accessibleName() == "Right is y, front is -x, up is z"
    assert not triad.grab().toImage().isNull()
