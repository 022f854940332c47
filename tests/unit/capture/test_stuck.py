"""A stuck sensor has no readings: a note, no force there, a question where it is long."""

from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices, LogQuestion, parse_choices
from hapticplayer.errors import InputError
from hapticplayer.sequence.processing import Processing, process_motion
from tests.faults.import_formats import FORMATS, put
from tests.faults.import_signal import sample
from tests.needed_extras import needs
from tests.unit.capture.conftest import case_file

pytestmark = needs("loggers")

ANSWER = "stuck=no-force"
COARSE = {"Ultimate IMU", "Razor M0", "Razor $"}  # a repeat may be rest to them
FINE = [key for key in FORMATS if key not in COARSE]


def held(time_s, values, span, axes=slice(None)):
    """Return the values (N, 3) as of a sensor that was stuck from one time to another."""
    values, rows = values.copy(), (time_s > span[0]) & (time_s <= span[1])
    values[rows, axes] = values[np.argmax(rows) - 1, axes]
    return values


def stuck(which, span, *, apart=False):
    made = sample(12.0, apart=apart)
    parts = {}
    for name in ("force", "rate", "field"):
        is_stuck = name in which
        values, time_s = getattr(made, name), getattr(made, f"{name}_s")
        if name == "field":  # the others have noise already
            values = values + np.random.default_rng(2).normal(0.0, 0.3, values.shape)
        parts[name] = held(time_s, values, span) if is_stuck else values
    return replace(made, **parts)


@pytest.mark.parametrize("which", [("force",), ("rate",), ("force", "rate")])
@pytest.mark.parametrize("key", FINE)
def test_stuck_readings_are_not_valid_in_any_format(tmp_path, key, which):
    one, span = FORMATS[key], (6.0, 8.0)
    path = put(one.write(stuck(which, span, apart=one.apart)), tmp_path / "log")
    with pytest.raises(LogQuestion, match=ANSWER) as asked:
        read_recording(path, parse_choices(one.choices))
    assert "as a stuck sensor does" in asked.value.what
    found = read_recording(path, parse_choices([*one.choices, ANSWER]))
    time_s, valid = found.imu.time_s - found.imu.time_s[0], found.imu.valid
    assert valid is not None
    inside = (time_s > span[0] + 0.05) & (time_s < span[1] - 0.05)
    assert not valid[inside].any()
    assert valid[(time_s < span[0] - 0.05) | (time_s > span[1] + 0.05)].all()
    assert found.provenance["stuck"]["share"] == pytest.approx(2.0 / 12.0, abs=0.01)
    assert sum("as a stuck sensor does" in note for note in found.notes) == len(which)


def test_a_short_span_is_noted_and_has_no_force(tmp_path):
    path = put(FORMATS["own CSV"].write(stuck(("rate",), (6.0, 6.9))), tmp_path / "log")
    found = read_recording(path)
    track = process_motion(found.imu, Processing()).track
    inside = (track.time_s > 6.05) & (track.time_s < 6.85)
    assert not track.valid[inside].any()
    assert any("6.01 to 6.90 s" in note for note in found.notes)


def flickering(which, span):
    """Own CSV whose sensors keep a reading in a span, but for a last bit of noise."""
    made, rng = sample(12.0), np.random.default_rng(4)
    parts = {}
    for name, step in (("force", 0.0024), ("rate", 0.0005)):
        time_s, values = getattr(made, f"{name}_s"), getattr(made, name)
        values = step * np.round(values / step)
        rows = (time_s > span[0]) & (time_s <= span[1])
        if name in which:
            kept = values[np.argmax(rows) - 1]
            values[rows] = kept + step * rng.integers(0, 2, (rows.sum(), 3))
        parts[name] = values
    return FORMATS["own CSV"].write(replace(made, **parts))


@pytest.mark.parametrize("which", [("force",), ("rate",), ("force", "rate")])
def test_a_last_bit_of_noise_does_not_make_readings(tmp_path, which):
    path = put(flickering(which, (6.0, 8.0)), tmp_path / "log")
    with pytest.raises(LogQuestion, match=ANSWER):
        read_recording(path)
    found = read_recording(path, parse_choices([ANSWER]))
    time_s, valid = found.imu.time_s, found.imu.valid
    assert not valid[(time_s > 6.05) & (time_s < 7.95)].any()
    assert valid[(time_s < 5.95) | (time_s > 8.05)].all()


@pytest.mark.parametrize("which", [("force",), ("rate",), ("force", "rate")])
def test_a_last_bit_of_noise_at_rest_is_no_fault(tmp_path, which):
    path = put(flickering(which, (0.5, 2.8)), tmp_path / "log")
    assert read_recording(path).imu.valid is None


def test_a_sensor_that_was_stuck_most_of_the_time_is_refused(tmp_path):
    path = put(
        FORMATS["own CSV"].write(stuck(("rate",), (4.0, 11.0))), tmp_path / "log"
    )
    with pytest.raises(InputError, match=r"gyroscope repeats .* give a recording"):
        read_recording(path, LogChoices(stuck="no-force"))


def test_an_answer_about_a_sensor_that_worked_is_refused(tmp_path):
    path = put(FORMATS["own CSV"].write(sample(12.0)), tmp_path / "log")
    with pytest.raises(Exception, match="no sensor of it was stuck"):
        read_recording(path, LogChoices(stuck="no-force"))


def test_a_stuck_compass_is_left_out_of_the_field_only(tmp_path):
    path = put(
        FORMATS["own CSV"].write(stuck(("field",), (6.0, 9.0))), tmp_path / "log"
    )
    found = read_recording(path)
    assert found.imu.valid is None
    assert any("the magnetometer repeats its readings" in note for note in found.notes)


@pytest.mark.parametrize("slow", [("force", "rate"), ("force",), ("rate",)])
def test_a_reading_that_is_held_counts_once(tmp_path, slow):
    made = sample(12.0)
    parts = {name: np.repeat(getattr(made, name)[::4], 4, axis=0) for name in slow}
    path = put(FORMATS["own CSV"].write(replace(made, **parts)), tmp_path / "log")
    found = read_recording(path)
    assert found.imu.rate_hz == pytest.approx(25.0 if "force" in slow else 100.0)
    assert sum("held for 4 rows" in note for note in found.notes) == len(slow)
    assert found.imu.valid is None


@pytest.mark.parametrize("name", ["both_frozen.csv", "gyro_frozen.csv"])
def test_a_logger_that_lost_its_sensors_is_asked_about(name):
    path = case_file("frozen-sensor", name)
    with pytest.raises(LogQuestion, match=r"33\.2%"):
        read_recording(path)
    found = read_recording(path, LogChoices(stuck="no-force"))
    time_s = found.imu.time_s
    np.testing.assert_array_equal(~found.imu.valid, (time_s > 12.01) & (time_s < 19.99))
