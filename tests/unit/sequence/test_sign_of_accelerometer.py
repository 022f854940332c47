"""An accelerometer with the other sign is never taken for a recorder upside down alone."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.cli import main
from hapticplayer.sequence import import_preview, mounting_by_frames, open_sequence
from tests.unit.capture.conftest import case_file


@pytest.fixture
def negative(tmp_path, swing):
    """A log of an accelerometer that reads -1 g upwards, and the right log."""
    log = swing[0]
    wrong = dataclasses.replace(log, specific_force_mps2=-log.specific_force_mps2)
    write_imu_csv(tmp_path / "log.csv", wrong)
    return tmp_path / "log.csv", log


def run(tiny_clip, log, target, *more):
    words = ["import", str(tiny_clip.path), "--imu", str(log), "-o", str(target)]
    return main([*words, "--offset", "0", *more])


def test_an_import_names_the_sign_and_following_it_is_right(
    tmp_path, tiny_clip, negative, capsys
):
    path, log = negative
    assert run(tiny_clip, path, tmp_path / "ride") == 2
    assert "accel-sign=- if its accelerometer" in capsys.readouterr().err
    sign = ("--read-as", "accel-sign=-")
    assert run(tiny_clip, path, tmp_path / "ride", *sign) == 0
    made = open_sequence(tmp_path / "ride")
    with np.load(made.folder / "imu.npz") as kept:
        count = len(kept["time_s"])
        np.testing.assert_allclose(
            kept["specific_force_mps2"], log.specific_force_mps2[:count], atol=1e-6
        )


def test_frames_that_tell_the_mounting_leave_the_sign_alone(
    tmp_path, tiny_clip, negative, monkeypatch, capsys
):
    shown = FoundMounting("x,y,z", 4.0, "-x,y,-z")
    asked = {"mounting": lambda *_given: shown}
    monkeypatch.setattr(mounting_by_frames, "frame_function", asked.get)
    assert run(tiny_clip, negative[0], tmp_path / "ride") == 2
    said = capsys.readouterr().err
    assert "accel-sign=-" in said
    assert "upside-down" not in said


def test_the_wizard_asks_for_the_sign(tiny_clip, negative):
    with pytest.raises(LogQuestion, match="accel-sign=-") as asked:
        import_preview.preview_import(tiny_clip.path, negative[0], method="offset")
    assert str(asked.value.answers[1]).startswith("accel-sign=+")
    kept = LogChoices(accel_sign="+")
    found = import_preview.preview_import(tiny_clip.path, negative[0], kept, "offset")
    assert found.up[2] < -0.9


def test_a_log_with_the_sign_of_apple_is_mended():
    path = case_file("accel-sign", "ios.csv")
    found = read_recording(path, LogChoices(accel_sign="-")).imu
    assert found.specific_force_mps2[:100, 2].mean() == pytest.approx(9.81, abs=0.02)
