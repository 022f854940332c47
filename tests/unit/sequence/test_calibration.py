"""A sensor's calibration in a file: kept, given, refused."""

import dataclasses
import json

import pytest

from hapticplayer.errors import InputError, UsageError
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.calibration import (
    StoredCalibration,
    read_calibration,
    write_calibration,
)
from hapticplayer.sequence.processing import Processing, process_motion

STORED = StoredCalibration(
    SensorCalibration(
        (0.05, -0.03, 0.06), (0.001, 0.002, 0.003), (0.1, 0.0, -0.1), (0.05,) * 3, 1.02
    ),
    "test camera",
    "ride.csv",
    "2026-11-25T00:00:00+00:00",
)


@pytest.fixture
def kept(tmp_path):
    write_calibration(tmp_path / "sensor.json", STORED)
    return tmp_path / "sensor.json"


def test_a_kept_calibration_is_read_again(kept):
    assert read_calibration(kept) == STORED


def test_only_a_calibration_is_overwritten(kept, tmp_path):
    write_calibration(kept, STORED, overwrite=True)
    with pytest.raises(InputError, match="already exists"):
        write_calibration(kept, STORED)
    (tmp_path / "other.json").write_text("{}")
    with pytest.raises(InputError, match="is not overwritten"):
        write_calibration(tmp_path / "other.json", STORED, overwrite=True)


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("schema", "hapticplayer.sequence", "is not a calibration of a sensor"),
        ("version", 2, "has version 2, this program reads 1"),
        ("gyro_bias_radps", [0.0, 0.0], "gyro_bias_radps: must have 3 entries"),
        (
            "gyro_bias_radps",
            [0.0, True, 0.0],
            r"gyro_bias_radps\[1\]: must be a number",
        ),
        ("gyro_bias_radps", [0.0, "0", 0.0], "must be a number, not a text"),
        ("gyro_bias_radps", [0.0, 1e300, 0.0], "must be at most 0.7"),
        ("accelerometer_bias_mps2", [0.0, 0.0, 5.0], "must be at most 2.5"),
        ("accelerometer_bias_mps2", [-5.0, 0.0, 0.0], "must be at least -2.5"),
        ("accelerometer_scale", 2.0, "must be at most 1.25"),
        ("gyro_bias_sigma_radps", [0.1, 0.0, 0.1], "must be at least 1e-09"),
        ("accelerometer_bias_mps2", {}, "must be a list"),
        ("accelerometer_scale", [1.0], "must be a number, not a list"),
        ("accelerometer_scale_sigma", None, "must be a number"),
        ("sensor", 7, "must be a text"),
        ("source", "x" * 301, "source: must have at most 300 characters"),
    ],
)
def test_anything_else_is_refused_with_a_sentence(kept, name, value, says):
    content = {**json.loads(kept.read_text()), name: value}
    kept.write_text(json.dumps(content))
    with pytest.raises(InputError, match=says):
        read_calibration(kept)


def test_errors_that_no_sensor_has_are_not_kept(tmp_path):
    values = dataclasses.replace(STORED.values, accelerometer_bias_mps2=(0.0, 0.0, 5.0))
    wild = dataclasses.replace(STORED, values=values)
    with pytest.raises(InputError, match="keep the calibration of another recording"):
        write_calibration(tmp_path / "sensor.json", wild)
    assert not (tmp_path / "sensor.json").exists()


@pytest.mark.parametrize(
    "text", ["", "[]", "null", "{", '{"a": NaN}', "\0", "[" * 9000]
)
def test_a_calibration_that_is_not_an_object_is_refused(kept, text):
    kept.write_text(text)
    with pytest.raises(InputError, match=r"calibration|JSON"):
        read_calibration(kept)


def test_a_mounting_turns_it_and_back():
    turned = STORED.mounted("-x,y,-z")
    assert turned.values.gyro_bias_radps == (-0.05, -0.03, -0.06)
    assert turned.dismounted("-x,y,-z") == STORED
    assert STORED.mounted("") is STORED


def test_other_methods_take_no_calibration():
    with pytest.raises(UsageError, match="calibration is for the method smoother"):
        Processing("vqf", calibration=STORED)


def test_the_provenance_holds_the_calibration(tmp_path, tiny_clip, recording):
    chosen = Processing(calibration=STORED)
    other = dataclasses.replace(recording, camera="other camera")
    for name, one, notes in (("a", recording, 0), ("b", other, 1)):
        folder = write_sequence(
            tiny_clip, one, tmp_path / name, choices=Choices(processing=chosen)
        )
        made_of = open_sequence(folder).description.provenance
        held = made_of["processing"]["calibration"]
        assert held["values"]["gyro_bias_radps"] == [0.05, -0.03, 0.06]
        assert held["source"] == "ride.csv"
        said = [note for note in made_of["notes"] if "calibration is of" in note]
        assert len(said) == notes


def test_an_import_mounts_the_calibration(tmp_path, tiny_clip, swing, recording):
    """It is in the recorder's axes, the samples are in frame A by then."""
    mounting = "-x,y,-z"
    given = dataclasses.replace(
        recording, imu=swing[0], provenance={"mounting": mounting}
    )
    made = {}
    for name, stored in (("right", STORED.mounted(mounting)), ("other", STORED)):
        chosen = Processing(calibration=stored)
        folder = write_sequence(
            tiny_clip, given, tmp_path / name, choices=Choices(processing=chosen)
        )
        made[name] = open_sequence(folder).motion.gravity_mps2
    expected = process_motion(swing[0], Processing(calibration=STORED)).track
    assert (made["right"] == expected.gravity_mps2).all()
    assert not (made["other"] == expected.gravity_mps2).all()
