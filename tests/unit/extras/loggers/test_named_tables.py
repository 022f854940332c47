"""Tables of programs: what they must not be mistaken for, and what is refused."""

import re

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import parse_choices
from hapticplayer.errors import InputError, UsageError
from tests.faults.import_formats import FORMATS, phyphox, phyphox_plain, put, zipped
from tests.faults.import_signal import GRAVITY_MPS2, sample, true_force


def written(key: str, pattern: bytes = b"", by: bytes = b"") -> dict[str, bytes]:
    one = FORMATS[key]
    files = one.write(sample(apart=one.apart))
    return {
        name: re.sub(pattern, by, content) if pattern else content
        for name, content in files.items()
    }


@pytest.mark.parametrize("separator", [b";", b"\t"])
def test_separator_of_a_table_is_found(tmp_path, separator):
    path = put(written("Xsens DOT", b",", separator), tmp_path / "in")
    assert len(read_recording(path).imu) == 1200


@pytest.mark.parametrize("key", ["Xsens DOT", "Xsens MTw"])
def test_free_acceleration_is_told_as_such(tmp_path, key):
    path = put(written(key, rb"\bAcc_", b"FreeAcc_"), tmp_path / "in")
    recording = read_recording(path)
    assert recording.is_gravity_free
    assert any("already removed" in note for note in recording.notes)


def test_linear_acceleration_beside_the_accelerometer_is_left(tmp_path):
    """AndroSensor logs both; only the one with gravity can become motion."""
    both = put(written("AndroSensor"), tmp_path / "both")
    assert not read_recording(both).is_gravity_free
    alone = put(written("AndroSensor", b"ACCELEROMETER", b"GRAVITY"), tmp_path / "one")
    assert read_recording(alone).is_gravity_free


@pytest.mark.parametrize("write", [phyphox(","), phyphox_plain])
def test_linear_acceleration_alone_or_beside_the_other(tmp_path, write):
    files = write(sample(apart=True))
    linear = phyphox_plain(sample(apart=True))["Linear Acceleration.csv"]
    path = tmp_path / "export.zip"
    path.write_bytes(zipped({"Linear Acceleration.csv": linear}))
    assert read_recording(path).is_gravity_free
    path.write_bytes(zipped({**files, "Linear Acceleration.csv": linear}))
    recording = read_recording(path)
    assert not recording.is_gravity_free
    norm_mps2 = recording.provenance["norm_at_rest_mps2"]
    assert norm_mps2 == pytest.approx(GRAVITY_MPS2, abs=0.01)


@pytest.mark.parametrize(
    ("key", "pattern", "program"),
    [
        ("RaceChrono", rb"[xyz]_acc", "RaceChrono"),
        ("RaceChrono 2", rb"[XYZ] acceleration", "RaceChrono"),
        ("Xsens DOT", rb"\bAcc_[XYZ]", "Xsens DOT"),
        ("Xsens MTw", rb"\bAcc_[XYZ]", "Xsens MT Manager"),
    ],
)
def test_table_without_acceleration_names_its_program(tmp_path, key, pattern, program):
    path = put(written(key, pattern, b"lateral_acc"), tmp_path / "in")
    with pytest.raises(InputError, match=f"is a table of {program} without") as caught:
        read_recording(path)
    assert "export the accelerometer" in str(caught.value)


def test_units_below_the_header_are_used(tmp_path):
    """RaceChrono can show accelerations in m/s² and rates in rad/s as well."""
    clean = sample(apart=True)
    files = FORMATS["RaceChrono"].write(clean)
    content = files["session.csv"].replace(
        b"m/s,G,G,G,deg/s", b"m/s,m/s2,m/s2,m/s2,deg/s"
    )
    path = put({"session.csv": content}, tmp_path / "in")
    with pytest.raises(UsageError, match="accel-unit=g"):
        read_recording(path)


def test_headers_of_many_channels_are_read(tmp_path):
    """RaceChrono adds a column for each channel of a car: 6 kB until the first row."""
    (name, content) = next(iter(written("RaceChrono").items()))
    text, is_table = "", False
    more = {
        "timestamp": ",a_channel_of_the_car",
        "unix time": ",deg/s",
        "": ",200: canbus",
    }
    for line in content.decode().splitlines(keepends=True):
        first = line.partition(",")[0]
        is_table = is_table or first == "timestamp"
        text += (
            line.rstrip("\n") + (150 * more.get(first, ",1") if is_table else "") + "\n"
        )
    assert text.index("1767150797") > 6000
    imu = read_recording(put({name: text.encode()}, tmp_path / "in")).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_rate_that_a_table_does_not_declare_is_asked_for(tmp_path):
    path = put(written("Xsens MTw", rb"// Update Rate.*\n", b""), tmp_path / "in")
    with pytest.raises(UsageError, match="rate-hz=100"):
        read_recording(path)
    imu = read_recording(path, parse_choices(["rate-hz=100"])).imu
    assert imu.rate_hz == pytest.approx(100.0)


def test_several_sensors_of_a_suit_are_asked_about(tmp_path):
    ((name, content),) = written("Xsens MTw").items()
    path = put({name: content, "MT_2.txt": content}, tmp_path / "in")
    with pytest.raises(UsageError, match="holds 2 logs"):
        read_recording(path)


@pytest.mark.parametrize(
    ("time", "program"),
    [(b"Time since start (ms)", "AndroSensor"), (b"timestamp (ms)", "AndroSensor"),
     (b"time (ms)", "AndroSensor"), (b"clock", "")],
)  # fmt: skip
def test_time_of_sensor_apps_is_known_by_its_unit(tmp_path, time, program):
    path = put(
        written("AndroSensor", b"Time since start in ms ", time), tmp_path / "in"
    )
    if program:
        assert read_recording(path).camera == program
        return
    with pytest.raises((InputError, UsageError)) as caught:
        read_recording(path)
    assert "AndroSensor" not in str(caught.value)


def test_header_in_latin_1_is_text(tmp_path):
    """The superscript two of m/s² is one byte there, which is no UTF-8."""
    ((name, content),) = written("AndroSensor").items()
    text = content.decode().replace("μ", "µ").encode("latin-1")
    imu = read_recording(put({name: text}, tmp_path / "in")).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_rows_that_end_with_a_semicolon_are_read(tmp_path):
    """The data set SisFall: nine counts a row at 200 Hz, without times or header."""
    clean = sample(rate_hz=200.0)
    accel = np.rint(clean.force / GRAVITY_MPS2 * 256.0)
    rate = np.rint(np.degrees(clean.rate) * 14.375)
    rows = np.concatenate([accel, rate, accel], axis=1).astype(int)
    path = tmp_path / "D01_SA01_R01.txt"
    path.write_text("".join(" " + ",".join(map(str, row)) + ";\n" for row in rows))
    with pytest.raises(UsageError, match="table of 9 columns"):
        read_recording(path)
    words = ["columns=ax,ay,az,gx,gy,gz,-,-,-", "rate-hz=200",
             "accel-unit=0.0383072", "rate-unit=0.00121414"]  # fmt: skip
    recording = read_recording(path, parse_choices(words))
    assert not any("damaged" in note for note in recording.notes)
    error = recording.imu.specific_force_mps2 - true_force(recording.imu.time_s)
    assert np.abs(error).max() < 0.08
