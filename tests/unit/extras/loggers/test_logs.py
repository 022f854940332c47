"""Each format as its documentation describes it, against a motion in closed form."""

import dataclasses
import re
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import parse_choices
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import InputError, UsageError
from tests.faults.import_formats import (
    EPOCH_NS,
    FORMATS,
    Written,
    ios_standard,
    phyphox,
    phyphox_linear,
    put,
    sensor_logger_android,
    sensor_logger_ios,
)
from tests.faults.import_signal import (
    Sampled,
    sample,
    true_field,
    true_force,
    true_rate,
)

LOGS = [key for key in FORMATS if key not in {"GoPro, raw", "own CSV"}]
NOISE = 5.0


def read(one: Written, path: Path) -> Recording:
    return read_recording(path, parse_choices(one.choices))


def mean_true_rate(t: np.ndarray) -> np.ndarray:
    """Mean of the true rate over the interval that ends at each time (Simpson)."""
    h = np.diff(t, prepend=2 * t[0] - t[1])
    parts = [true_rate(t - h), 4.0 * true_rate(t - 0.5 * h), true_rate(t)]
    return np.asarray(sum(parts) / 6.0)


@pytest.mark.parametrize("key", LOGS)
@pytest.mark.parametrize("packing", ["folder", "zip"])
def test_format_gives_the_motion_back(tmp_path, key, packing):
    one = FORMATS[key]
    files = one.write(sample(apart=one.apart))
    recording = read(one, put(files, tmp_path / "in", as_zip=packing == "zip"))
    imu = recording.imu
    assert imu.rate_hz == pytest.approx(100.0, rel=1e-3)
    shift_s = imu.time_s[0] - (5.321 if key == "Razor M0" else 0.0)
    assert abs(shift_s) < 0.03
    t = imu.time_s - (5.321 if key == "Razor M0" else 0.0)
    force_error = np.abs(imu.specific_force_mps2 - true_force(t)).max()
    assert force_error < one.tolerance_mps2 + NOISE * 0.01
    expected = mean_true_rate(t) if one.apart else true_rate(t)
    rate_error = np.abs(imu.angular_rate_radps - expected).max()
    # a held sample stands for the interval before it: half of one at most
    held = 0.5 * 0.01 * 0.4 * 1.7**2 if one.apart else 0.0
    assert rate_error < one.tolerance_radps + NOISE * 0.001 + held
    assert (imu.magnetic_field_ut is not None) == (
        one.has_field and not key.startswith("Razor $")
    )
    shown, figures = recording.notes[0], recording.provenance
    assert shown.startswith("read as ")
    assert "specific force in" in shown
    assert "right, front, up" in shown
    assert f"{figures['norm_at_rest_mps2']:.2f} m/s2 at rest" in shown
    assert figures["norm_at_rest_mps2"] == pytest.approx(9.807, abs=0.06)
    largest = np.abs(true_rate(np.linspace(0, 12, 5000))).max()
    assert figures["largest_rate_radps"] == pytest.approx(largest, abs=0.02)


# the sensors of the others are distinguished by the names of their files
IN_ONE_FILE = [
    key
    for key in LOGS
    if not key.startswith(("Sensor Logger", "phyphox", "OpenCamera"))
]


@pytest.mark.parametrize("key", IN_ONE_FILE)
def test_name_of_the_file_does_not_matter(tmp_path, key):
    one = FORMATS[key]
    files = one.write(sample(apart=one.apart))
    content = files[next(iter(files))]
    recording = read(one, put({"anything.bin": content}, tmp_path / "in"))
    assert recording.camera.split()[0] in recording.notes[0]
    assert len(recording.imu) > 1000


def test_field_is_in_microtesla(tmp_path):
    for key in ("Ultimate IMU", "gcsv", "phyphox comma", "OpenCamera Sensors"):
        one = FORMATS[key]
        path = put(one.write(sample(apart=one.apart)), tmp_path / key)
        imu = read(one, path).imu
        assert imu.magnetic_field_ut is not None
        error = np.abs(imu.magnetic_field_ut - true_field(imu.time_s)).max()
        # linear between samples of 25 Hz: 47 uT turning at 0.68 rad/s bends little
        assert error < 0.6, key


def test_sensors_are_not_paired_by_their_place(tmp_path):
    """The gyro is 7 % faster: by index it would be 0.8 s off at the end."""
    one = FORMATS["Sensor Logger Android"]
    clean = sample(apart=True)
    imu = read(one, put(one.write(clean), tmp_path / "in")).imu
    by_index = clean.rate[: len(imu)]
    assert np.abs(by_index - true_rate(imu.time_s)).max() > 0.4
    assert np.abs(imu.angular_rate_radps - mean_true_rate(imu.time_s)).max() < 0.02


@pytest.mark.parametrize(
    ("key", "first_frame_s"),
    [("MARS", 0.75), ("EuRoC", 0.5), ("OpenCamera Sensors", 0.25)],
)
def test_times_of_the_frames_fix_the_clock(tmp_path, key, first_frame_s):
    one = FORMATS[key]
    path = put(one.write(sample(apart=one.apart)), tmp_path / "in", as_zip=True)
    clock = read(one, path).clock_map
    assert clock.offset_s == pytest.approx(-first_frame_s, abs=1e-9)
    assert clock.confidence == 1.0


@pytest.mark.parametrize("name", ["MARS", "OpenCamera Sensors"])
@pytest.mark.parametrize(("duration_s", "is_believed"), [(3.0, True), (2.4, False)])
def test_frames_are_believed_for_a_clip_of_their_length(
    tmp_path, name, duration_s, is_believed
):
    one = FORMATS[name]
    placing = read(
        one, put(one.write(sample(apart=one.apart)), tmp_path / "in")
    ).placing
    why = placing.contradiction(duration_s)
    assert (why is None) == is_believed
    assert is_believed or "lasts from 0.00 to 3.00 s, the clip from 0 to 2.40 s" in why


def test_a_log_alone_leaves_the_clock_open(tmp_path):
    one = FORMATS["Ultimate IMU"]
    assert (
        read(one, put(one.write(sample()), tmp_path / "in")).clock_map.confidence == 0.0
    )


def test_nanoseconds_since_1970_keep_every_digit(tmp_path):
    """float64 resolves 256 ns there; the steps of 10 ms must stay exact."""
    one = FORMATS["EuRoC"]
    imu = read(one, put(one.write(sample()), tmp_path / "in")).imu
    np.testing.assert_allclose(np.diff(imu.time_s), 0.01, rtol=0, atol=2e-12)
    assert EPOCH_NS % 256 != 0


def turned(clean: Sampled, axes: list[int], signs: list[float]) -> Sampled:
    """Return what a sensor shows that sits otherwise: stored k = sign * A[axis]."""

    def turn(values: np.ndarray) -> np.ndarray:
        return values[:, axes] * signs

    return Sampled(
        clean.force_s, turn(clean.force), clean.rate_s, turn(clean.rate),
        clean.field_s, turn(clean.field),
    )  # fmt: skip


def test_an_upright_phone_asks_for_its_axes_and_proposes_them(tmp_path):
    """Upright: stored x = right, y = up, z = back."""
    upright = turned(sample(apart=True), [0, 2, 1], [1.0, 1.0, -1.0])
    path = put(sensor_logger_android(upright), tmp_path / "in")
    with pytest.raises(UsageError, match="its axis y was up") as caught:
        read_recording(path)
    assert "axes=x,-z,y" in str(caught.value)
    imu = read_recording(path, parse_choices(["axes=x,-z,y"])).imu
    error = np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max()
    assert error < 0.06
    assert np.abs(imu.angular_rate_radps - mean_true_rate(imu.time_s)).max() < 0.02


@pytest.mark.parametrize(
    ("axes", "signs", "proposed"),
    [
        ([2, 0, 1], [1.0, -1.0, -1.0], "axes=-y,-z,x"),  # top to the left
        ([2, 0, 1], [-1.0, 1.0, -1.0], "axes=y,-z,-x"),  # top to the right
    ],
)
def test_a_phone_on_its_side_gets_the_view_to_the_front(
    tmp_path, axes, signs, proposed
):
    path = put(
        sensor_logger_android(turned(sample(apart=True), axes, signs)), tmp_path / "in"
    )
    with pytest.raises(UsageError) as caught:
        read_recording(path)
    assert proposed in str(caught.value)
    imu = read_recording(path, parse_choices([proposed])).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


@pytest.mark.parametrize(
    ("axes", "sentence"),
    [("x,y", "three axes"), ("x,y,w", "three axes"), ("x,x,z", "three axes"),
     ("x,y,-z", "mirror"), ("--x,y,z", "three axes"), ("1,2,3", "three axes")],
)  # fmt: skip
def test_axes_that_are_none_are_refused(tmp_path, axes, sentence):
    path = put(FORMATS["MARS"].write(sample()), tmp_path / "in")
    with pytest.raises(UsageError, match=sentence):
        read_recording(path, parse_choices([f"axes={axes}"]))


def test_chosen_axes_are_used_with_a_note(tmp_path):
    path = put(FORMATS["MARS"].write(sample()), tmp_path / "in")
    recording = read_recording(path, parse_choices(["axes=x,-y,-z"]))
    assert any("gravity shows that z was up" in note for note in recording.notes)
    assert recording.imu.specific_force_mps2[0, 2] < -9.0


def test_android_is_read_with_gravity_and_not_without(tmp_path):
    """Accelerometer.csv of Android has no gravity: with it the norm would be 0."""
    path = put(sensor_logger_android(sample(apart=True)), tmp_path / "in")
    recording = read_recording(path)
    assert recording.camera == "Sensor Logger (Android)"
    assert recording.provenance["norm_at_rest_mps2"] == pytest.approx(9.807, abs=0.01)


def test_ios_adds_gravity_and_negates(tmp_path):
    recording = read_recording(
        put(sensor_logger_ios(sample(apart=True)), tmp_path / "in")
    )
    assert recording.camera == "Sensor Logger (iOS)"
    assert recording.imu.specific_force_mps2[0, 2] == pytest.approx(9.8, abs=0.1)
    assert any("plus the phone's gravity estimate" in note for note in recording.notes)


def test_ios_with_standard_frames_keeps_the_signs(tmp_path):
    recording = read_recording(put(ios_standard(sample(apart=True)), tmp_path / "in"))
    error = recording.imu.specific_force_mps2 - true_force(recording.imu.time_s)
    assert np.abs(error).max() < 0.06


def test_a_phone_that_does_not_say_its_system_is_asked_about(tmp_path):
    files = sensor_logger_ios(sample(apart=True))
    del files["Metadata.csv"]
    path = put(files, tmp_path / "in")
    with pytest.raises(UsageError, match="format=sensor-logger-ios"):
        read_recording(path)
    choice = parse_choices(["format=sensor-logger-ios"])
    assert read_recording(path, choice).camera == "Sensor Logger (iOS)"


def test_one_file_of_a_phone_names_what_is_missing(tmp_path):
    files = sensor_logger_android(sample(apart=True))
    name = "TotalAcceleration.csv"
    path = put({name: files[name]}, tmp_path / "in")
    with pytest.raises(InputError, match="holds no gyroscope") as caught:
        read_recording(path)
    assert "whole folder or zip" in str(caught.value)


def test_linear_acceleration_is_flagged_as_free_of_gravity(tmp_path):
    clean = sample()
    recording = read_recording(put(phyphox_linear(clean), tmp_path / "in"))
    assert recording.is_gravity_free
    assert any("already removed" in note for note in recording.notes)
    free = true_force(recording.imu.time_s) - np.array([0.0, 0.0, 9.80665])
    assert np.abs(recording.imu.specific_force_mps2 - free).max() < 0.06


def test_with_and_without_gravity_the_one_with_it_counts(tmp_path):
    clean = sample(apart=True)
    files = phyphox(",")(clean)
    files["Linear Accelerometer.csv"] = phyphox_linear(clean)["Raw Data.csv"]
    recording = read_recording(put(files, tmp_path / "in"))
    assert not recording.is_gravity_free
    assert recording.provenance["norm_at_rest_mps2"] == pytest.approx(9.807, abs=0.01)


def test_acceleration_without_gyroscope_is_refused(tmp_path):
    files = phyphox(",")(sample(apart=True))
    path = put({"Raw Data.csv": files["Accelerometer.csv"]}, tmp_path / "in")
    with pytest.raises(InputError, match="no angular rate"):
        read_recording(path)


def test_scale_of_another_writer_of_gcsv_is_asked_about(tmp_path):
    """One writer's ascale gives m/s2 where g is meant."""
    files = FORMATS["gcsv"].write(sample())
    content = files["clip.gcsv"].replace(b"ascale,0.00012", b"ascale,0.001176798")
    path = put({"clip.gcsv": content}, tmp_path / "in")
    with pytest.raises(UsageError, match="accel-unit=m/s2") as caught:
        read_recording(path)
    assert "would fit another unit" in str(caught.value)
    imu = read_recording(path, parse_choices(["accel-unit=m/s2"])).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_range_that_is_half_as_wide_is_asked_about(tmp_path):
    """Counts of a range of 4 g read as 2 g: 4.9 m/s2 at rest is no other unit."""
    files = FORMATS["gcsv"].write(sample())
    content = files["clip.gcsv"].replace(b"ascale,0.00012", b"ascale,0.00006")
    path = put({"clip.gcsv": content}, tmp_path / "in")
    with pytest.raises(UsageError, match=r"4\.9 m/s2 at rest") as caught:
        read_recording(path)
    assert "accel-unit=19.61" in str(caught.value)
    imu = read_recording(path, parse_choices(["accel-unit=19.6133"])).imu
    assert np.abs(imu.specific_force_mps2 - true_force(imu.time_s)).max() < 0.06


def test_angular_rate_beyond_any_hand_is_asked_about(tmp_path):
    """0.44 rad/s written as rad/s but meant as deg/s 80 times over."""
    clean = sample()
    fast = Sampled(clean.force_s, clean.force, clean.rate_s, 90.0 * clean.rate,
                   clean.field_s, clean.field)  # fmt: skip
    path = put(FORMATS["MARS"].write(fast), tmp_path / "in")
    with pytest.raises(UsageError, match="rate-unit=deg/s"):
        read_recording(path)


def test_a_factor_of_the_rate_is_not_questioned(tmp_path):
    clean = sample()
    fast = dataclasses.replace(clean, rate=np.degrees(clean.rate))
    path = put(FORMATS["MARS"].write(fast), tmp_path / "in")
    with pytest.raises(UsageError, match="rate-unit=1 to keep it"):
        read_recording(path, parse_choices(["rate-unit=rad/s"]))
    for unit, factor in (("1", 1.0), ("deg/s", np.pi / 180.0)):
        found = read_recording(path, parse_choices([f"rate-unit={unit}"]))
        largest_radps = np.abs(found.imu.angular_rate_radps).max()
        assert largest_radps == pytest.approx(factor * fast.rate.max(), rel=0.1)


def test_angles_only_are_refused(tmp_path):
    contents = {
        "ypr": "#YPR=1.0,2.0,3.0\r\n" * 50,
        "ang": "!ANG:1.23,4.56,78.90\r\n" * 50,
        "acc": "!ANG:1.23,4.56,78.90,ACC:1,2,250\r\n" * 50,
        "euler": "".join(f"{11 * k:06d},1.20,3.40,5.60\n\r" for k in range(50)),
    }
    for name, text in contents.items():
        path = put({f"{name}.log": text.encode()}, tmp_path / name)
        with pytest.raises(InputError, match="angles"):
            read_recording(path)


def test_raw_counts_of_a_razor_ask_for_the_rate(tmp_path):
    path = put(FORMATS["Razor $"].write(sample()), tmp_path / "in")
    with pytest.raises(UsageError, match="rate-hz=50"):
        read_recording(path)


def test_razor_without_times_assumes_a_rate_with_a_note(tmp_path):
    path = put(FORMATS["Razor-AHRS"].write(sample(rate_hz=50.0)), tmp_path / "in")
    recording = read_recording(path)
    assert recording.imu.rate_hz == pytest.approx(50.0)
    assert any("50 frames per second are assumed" in note for note in recording.notes)


def test_values_that_the_board_scaled_twice_are_left_out(tmp_path):
    clean = sample()
    at = int(np.argmax(np.abs(clean.rate[:, 0])))
    clean.rate[at] = clean.rate[at - 1] / 14.375
    one = FORMATS["Ultimate IMU"]
    recording = read(one, put(one.write(clean), tmp_path / "in"))
    assert any("1 gyroscope values were scaled twice" in n for n in recording.notes)
    assert recording.imu.valid is not None
    assert np.flatnonzero(~recording.imu.valid).tolist() == [at]
    error = recording.imu.angular_rate_radps[at] - true_rate(clean.rate_s[at : at + 1])
    assert np.abs(error).max() < 0.01


def test_counts_of_a_razor_m0_ask_for_their_range(tmp_path):
    clean = sample()
    counts = Sampled(
        clean.force_s, clean.force / 9.80665 * 9.80665 * 16384, clean.rate_s,
        clean.rate * 16.4, clean.field_s, clean.field,
    )  # fmt: skip
    path = put(FORMATS["Razor M0"].write(counts), tmp_path / "in")
    with pytest.raises(UsageError, match="1 g = 16384"):
        read_recording(path)


@pytest.mark.parametrize("wrong", [1.0, 1e3, 1e6, 1e-6, 1e-9])
def test_a_wrong_time_scale_of_gcsv_is_named_and_mended(tmp_path, wrong):
    content = FORMATS["gcsv"].write(sample())["clip.gcsv"]

    def scaled(tscale):
        text = content.replace(b"tscale,0.001", f"tscale,{tscale:.12g}".encode())
        return put({"clip.gcsv": text}, tmp_path / f"{tscale}")

    with pytest.raises(InputError, match=r"clip\.gcsv: t runs at") as refused:
        read_recording(scaled(wrong))
    how, by = re.search(
        r"(multiply|divide) tscale by (\d+)", str(refused.value)
    ).groups()
    tscale = wrong * float(by) if how == "multiply" else wrong / float(by)
    assert read_recording(scaled(tscale)).imu.rate_hz == pytest.approx(100.0, rel=0.01)


def test_times_that_jump_back_have_the_name_of_their_column(tmp_path):
    files = FORMATS["gcsv"].write(sample())
    lines = files["clip.gcsv"].splitlines(keepends=True)
    content = b"".join([*lines[:500], *lines[300:]])
    path = put({"clip.gcsv": content}, tmp_path / "in")
    with pytest.raises(InputError, match=r"clip\.gcsv: t jumps back by"):
        read_recording(path)
