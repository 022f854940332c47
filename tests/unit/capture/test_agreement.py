"""Two sensors that contradict each other are asked about, and the remedy is right."""

import functools
import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.capture import read_recording
from hapticplayer.capture.agreement import ask_about_agreement
from hapticplayer.capture.choices import LogQuestion, parse_choices
from hapticplayer.capture.log_checks import norm_at_rest
from hapticplayer.errors import InputError, UsageError
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.model import ImuLog
from tests.faults.import_formats import FORMATS, put
from tests.faults.import_signal import Sampled, sample
from tests.needed_extras import needs
from tests.unit.capture.conftest import case_file

pytestmark = needs("loggers")

X, Y, Z = np.eye(3)
MISTAKES = {  # what was done to accelerometer and gyro, and the answer that mends it
    "gyro reversed": (np.eye(3), -np.eye(3), "rate-axes=-x,-y,-z"),
    "gyro x mirrored": (np.eye(3), np.diag([-1, 1, 1]), "rate-axes=-x,y,z"),
    "gyro y mirrored": (np.eye(3), np.diag([1, -1, 1]), "rate-axes=x,-y,z"),
    "gyro z mirrored": (np.eye(3), np.diag([1, 1, -1]), "rate-axes=x,y,-z"),
    "gyro x and y swapped": (np.eye(3), np.array([Y, X, Z]), "rate-axes=y,x,z"),
    "gyro turned": (np.eye(3), np.array([Y, -X, Z]), "rate-axes=-y,x,z"),
    "accel x mirrored": (np.diag([-1, 1, 1]), np.eye(3), "accel-axes=-x,y,z"),
    "accel x and y swapped": (np.array([Y, X, Z]), np.eye(3), "accel-axes=y,x,z"),
    "accel y and z swapped": (np.array([X, Z, Y]), np.eye(3), "accel-axes=x,z,y"),
}
TRIED = ("own CSV", "gcsv", "EuRoC", "Sensor Logger Android", "GoPro, raw")


@functools.cache
def tumbling(*, apart: bool = False, amount: float = 0.35) -> Sampled:
    """Return a motion that turns about all axes, from rest, mostly upright."""
    made, rng = sample(16.0, apart=apart), np.random.default_rng(3)
    fine_s = np.arange(0.0, 17.0, 0.001)
    tau = np.maximum(fine_s - 3.0, 0.0)
    angles = amount * np.sin(np.outer(tau, [1.3, 1.9, 0.8])) * [1.0, 1.0, 2.5]
    turned = Rotation.from_euler("zyx", angles[:, ::-1])
    step = (turned[:-1].inv() * turned[1:]).as_rotvec() / 0.001
    earth = np.sin(np.outer(tau, [5.0, 7.0, 11.0])) * [1.5, 2.0, 1.0] + [0, 0, 9.80665]
    force = turned.inv().apply(earth)

    def at(time_s, known_s, values, noise):
        columns = [np.interp(time_s, known_s, column) for column in values.T]
        return np.stack(columns, axis=1) + rng.normal(0.0, noise, (len(time_s), 3))

    return replace(
        made,
        force=at(made.force_s, fine_s, force, 0.01),
        rate=at(made.rate_s, fine_s[1:], step, 0.001),
    )


def written(key, place, accel=None, rate=None):
    one = FORMATS[key]
    made = tumbling(apart=one.apart)
    accel, rate = (np.eye(3) if turn is None else turn for turn in (accel, rate))
    made = replace(made, force=made.force @ accel.T, rate=made.rate @ rate.T)
    return put(one.write(made), place)


def first_answer(asked) -> str:
    return re.match(r"\S+=\S+", str(asked.value.answers[0]))[0]


@pytest.mark.parametrize("mistake", MISTAKES)
@pytest.mark.parametrize("key", TRIED)
def test_the_answer_named_first_mends_the_log(tmp_path, key, mistake):
    accel, rate, remedy = MISTAKES[mistake]
    plain = FORMATS[key].choices
    right = read_recording(written(key, tmp_path / "right"), parse_choices(plain))
    path = written(key, tmp_path / "wrong", accel, rate)
    with pytest.raises(LogQuestion, match="does not match that of gravity") as asked:
        read_recording(path, parse_choices(plain))
    answer = first_answer(asked)
    if key in {"own CSV", "gcsv"}:  # others have stored axes of their own
        assert answer == remedy
    mended = read_recording(path, parse_choices([*plain, answer]))
    for name in ("specific_force_mps2", "angular_rate_radps"):
        np.testing.assert_allclose(
            getattr(mended.imu, name), getattr(right.imu, name), atol=2e-3
        )
    assert not any("does not turn" in note for note in mended.notes)


@pytest.mark.parametrize("key", FORMATS)
def test_sensors_that_agree_are_not_asked_about(tmp_path, key):
    found = read_recording(
        written(key, tmp_path / "log"), parse_choices(FORMATS[key].choices)
    )
    assert not any("does not turn" in note for note in found.notes)


def test_both_may_be_kept_as_they_are(tmp_path):
    path = written("own CSV", tmp_path / "log", rate=-np.eye(3))
    found = read_recording(path, parse_choices(["rate-axes=x,y,z"]))
    assert any("does not match that of gravity" in note for note in found.notes)


@pytest.mark.parametrize("axes", ["x,y", "x,x,z", "a,b,c", "x,y,z,x"])
def test_axes_of_a_sensor_are_three(tmp_path, axes):
    path = written("own CSV", tmp_path / "log")
    with pytest.raises(UsageError, match="are not three axes"):
        read_recording(path, parse_choices([f"accel-axes={axes}"]))


def told(key, place, change):
    """Write the tumbling motion, changed, and return its path and that of the right one."""
    one = FORMATS[key]
    made = tumbling(apart=one.apart, amount=0.6)
    right = put(one.write(made), place / "right")
    return right, put(one.write(change(made)), place / "wrong")


def assert_alike(mended, right, place_s=0.5):
    """Within the log, where a gyro of another clock reaches both."""
    at_s = right.imu.time_s[0] + np.arange(place_s, 15.0, 0.02)
    for name in ("specific_force_mps2", "angular_rate_radps"):
        got, want = (
            np.stack(
                [
                    np.interp(at_s, one.imu.time_s, axis)
                    for axis in getattr(one.imu, name).T
                ]
            )
            for one in (mended, right)
        )
        assert np.abs(got - want).mean() < 0.01


SCALES = {  # of the gyro, and the answer named first, in rad/s
    0.5: "rate-unit=2",
    0.25: "rate-unit=4",
    0.125: "rate-unit=8",
    2.0: "rate-unit=0.5",
    4.0: "rate-unit=0.25",
    np.pi / 180.0: "rate-unit=57.2957795",
}


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_a_gyro_of_another_scale_is_asked_about(tmp_path, key, scale):
    right, path = told(key, tmp_path, lambda m: replace(m, rate=scale * m.rate))
    with pytest.raises(LogQuestion, match="times too ") as asked:
        read_recording(path)
    assert first_answer(asked) == SCALES[scale]
    assert_alike(
        read_recording(path, parse_choices([SCALES[scale]])), read_recording(right)
    )
    kept = re.match(r"\S+", str(asked.value.answers[1]))[0]
    assert kept == "rate-unit=1"
    read_recording(path, parse_choices([kept]))


@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_an_axis_of_half_the_range_is_asked_about(tmp_path, key):
    half = np.array([0.45, 1.0, 1.0])
    made = replace(tumbling(amount=1.2), rate=tumbling(amount=1.2).rate * half)
    path = put(FORMATS[key].write(made), tmp_path / "wrong")
    with pytest.raises(LogQuestion, match="as its gyroscope does not show") as asked:
        read_recording(path)
    kept = read_recording(path, parse_choices([first_answer(asked)]))
    assert any("as its gyroscope does not show" in note for note in kept.notes)


def pendulum(change):
    """What turns about one axis, x, and its gyro, changed."""
    time_s = np.arange(0.0, 30.0, 0.01)
    angle = 0.9 * np.sin(1.1 * time_s)
    force = 9.80665 * np.stack([0 * angle, np.sin(angle), np.cos(angle)], axis=1)
    rate = np.stack([np.gradient(angle, time_s), 0 * angle, 0 * angle], axis=1)
    noise = np.random.default_rng(1).normal(0.0, 0.003, (2, len(time_s), 3))
    rate = (rate + noise[1]) @ change.T
    return ImuLog(time_s, force + noise[0], rate, source="x")


def test_mirror_images_that_fit_are_named_beside_rotations():
    with pytest.raises(LogQuestion) as asked:
        ask_about_agreement(pendulum(np.diag([-1.0, 1.0, 1.0])), parse_choices([]), "x")
    answers = [str(one) for one in asked.value.answers]
    assert any(one.startswith("rate-axes=-x,y,z if") for one in answers[:3])
    assert {"mirrored", "turned"} <= {one.split()[-1] for one in answers}
    assert answers[-1].startswith("rate-axes=x,y,z to keep")


def test_samples_that_were_filled_in_hide_nothing():
    imu = pendulum(-np.eye(3))
    filled = replace(imu, valid=np.arange(len(imu)) % 97 > 0)
    with pytest.raises(LogQuestion, match="does not match that of gravity"):
        ask_about_agreement(filled, parse_choices([]), "x")


def test_a_scale_is_told_in_the_unit_that_was_declared(tmp_path):
    _, path = told("own CSV", tmp_path, lambda made: made)
    with pytest.raises(LogQuestion, match="57 times too low") as asked:
        read_recording(path, parse_choices(["rate-unit=deg/s"]))
    assert first_answer(asked) == "rate-unit=rad/s"
    read_recording(path, parse_choices([first_answer(asked)]))


def test_another_scale_of_a_camera_is_noted_and_not_asked_about(tmp_path):
    """Its maker states it; what else is wrong is asked about as in any log."""
    imu = read_recording(told("own CSV", tmp_path, lambda made: made)[0]).imu
    fast = replace(imu, angular_rate_radps=4.0 * imu.angular_rate_radps)
    (note,) = ask_about_agreement(fast, parse_choices([]), "x", is_of_camera=True)
    assert "4 times too high" in str(note)
    mirrored = replace(imu, angular_rate_radps=-imu.angular_rate_radps)
    with pytest.raises(LogQuestion):
        ask_about_agreement(mirrored, parse_choices([]), "x", is_of_camera=True)


@pytest.mark.parametrize("late_s", [0.3, -0.3, -0.6, 1.2])
@pytest.mark.parametrize("key", ["own CSV", "EuRoC", "Sensor Logger Android"])
def test_clocks_that_differ_are_asked_about(tmp_path, key, late_s):
    def late(made):
        columns = [np.interp(made.rate_s - late_s, made.rate_s, v) for v in made.rate.T]
        return replace(made, rate=np.stack(columns, axis=1))

    plain = FORMATS[key].choices
    right, path = told(key, tmp_path, late)
    with pytest.raises(LogQuestion, match="their clocks differ") as asked:
        read_recording(path, parse_choices(plain))
    answer = first_answer(asked)
    assert float(answer.removeprefix("rate-delay=")) == pytest.approx(late_s, abs=0.03)
    mended = read_recording(path, parse_choices([*plain, answer]))
    assert not any("clocks differ" in note for note in mended.notes)
    assert_alike(mended, read_recording(right, parse_choices(plain)), 1.5)
    kept = read_recording(path, parse_choices([*plain, "rate-delay=0"]))
    assert any("clocks differ" in note for note in kept.notes)


@pytest.mark.parametrize("axes", [(0,), (1,), (0, 1, 2)])
@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_a_gyro_that_reads_0_while_gravity_turns_is_asked_about(tmp_path, key, axes):
    def dead(made):
        rate = made.rate.copy()
        rate[:, axes] = 0.0
        return replace(made, rate=rate)

    _, path = told(key, tmp_path, dead)
    with pytest.raises(LogQuestion, match="reads exactly 0 about") as asked:
        read_recording(path)
    assert ", ".join("xyz"[axis] for axis in axes) in asked.value.what
    kept = read_recording(path, parse_choices([first_answer(asked)]))
    assert any("reads exactly 0" in note for note in kept.notes)


@pytest.mark.parametrize("accel_mps2", [0.0, 1.0, 3.0])
def test_a_program_may_leave_axes_out_that_do_not_turn(tmp_path, accel_mps2):
    """A drive in a plane: only the yaw is there, and gravity stays where it is."""
    made, rng = sample(16.0), np.random.default_rng(5)
    phase = 0.8 * made.force_s
    force = np.stack([np.sin(phase), np.sign(np.sin(0.5 * phase)), 0.0 * phase], axis=1)
    force = accel_mps2 * force + [0.0, 0.0, 9.80665]
    rate = np.zeros_like(made.rate)
    rate[:, 2] = 0.4 * np.sin(0.8 * made.rate_s)
    noise = rng.normal(0.0, 0.01, force.shape)
    path = put(
        FORMATS["own CSV"].write(replace(made, force=force + noise, rate=rate)),
        tmp_path / "log",
    )
    assert not any("reads exactly" in note for note in read_recording(path).notes)


@pytest.mark.parametrize("turns", [True, False])
def test_axes_that_nothing_shows_are_not_called_checked(tmp_path, turns):
    made, rng = tumbling(), np.random.default_rng(6)
    if not turns:
        rest = rng.normal([0.0, 0.0, 9.80665], 0.02, made.force.shape)
        yaw = np.zeros_like(made.rate)
        yaw[:, 2] = 0.7 * np.sin(made.rate_s)
        noise = rng.normal(0.0, 0.002, yaw.shape)
        made = replace(made, force=rest, rate=yaw + noise)
    path = put(FORMATS["EuRoC"].write(made), tmp_path / "log")
    found = read_recording(path)
    assert found.provenance["is_rate_compared"] == turns
    assert ("not checked" in str(found.notes[0])) != turns


def swapped(made: Sampled) -> Sampled:
    return replace(made, force=made.rate, rate=made.force)


@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_swapped_columns_are_named_and_swapped_back(tmp_path, key):
    one = FORMATS[key]
    right = read_recording(written(key, tmp_path / "right"))
    path = put(one.write(swapped(tumbling())), tmp_path / "wrong")
    with pytest.raises(LogQuestion, match="these columns are swapped") as asked:
        read_recording(path)
    mended = read_recording(path, parse_choices([first_answer(asked)]))
    np.testing.assert_allclose(
        mended.imu.specific_force_mps2, right.imu.specific_force_mps2, atol=1e-6
    )


def test_a_compass_in_the_columns_of_the_accelerometer_is_named(tmp_path):
    made = tumbling()
    made = replace(made, force=made.field, field=made.force)
    path = put(FORMATS["own CSV"].write(made), tmp_path / "log")
    with pytest.raises(LogQuestion, match=r"its magnetometer would read 9\.8") as asked:
        read_recording(path)
    mended = read_recording(path, parse_choices([first_answer(asked)]))
    norm = np.linalg.norm(mended.imu.specific_force_mps2[:200], axis=1)
    assert norm.mean() == pytest.approx(9.81, abs=0.05)


def test_a_compass_alone_is_no_accelerometer(tmp_path):
    made = replace(tumbling(), force=tumbling().field)
    path = put(FORMATS["EuRoC"].write(made), tmp_path / "log")
    with pytest.raises(InputError, match="a magnetometer's readings"):
        read_recording(path)


@pytest.mark.parametrize(
    ("accel", "rate", "answer"),
    [
        (1.0, 180.0 / np.pi, "rate-unit=deg/s"),
        (1.0 / 9.80665, 1.0, "accel-unit=g"),
        (1000.0 / 9.80665, 1.0, "accel-unit=mg"),
        (100.0, 1.0, "accel-unit=cm/s2"),
        (100.0, 180.0 / np.pi, "accel-unit=cm/s2 and rate-unit=deg/s"),
        (1.0, np.pi / 180.0, "rate-unit=57.2957795"),
    ],
)
@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_another_unit_is_asked_about(tmp_path, key, accel, rate, answer):
    path = written(key, tmp_path / "log", accel * np.eye(3), rate * np.eye(3))
    with pytest.raises(LogQuestion) as asked:
        read_recording(path)
    assert answer in str(asked.value.answers[0])
    right = read_recording(written(key, tmp_path / "right"))
    mended = read_recording(path, parse_choices(answer.split(" and ")))
    for name in ("specific_force_mps2", "angular_rate_radps"):
        np.testing.assert_allclose(
            getattr(mended.imu, name), getattr(right.imu, name), atol=1e-4
        )


@pytest.mark.parametrize("scale", [0.5, 0.75, 1 / 0.3048])
@pytest.mark.parametrize("key", ["own CSV", "EuRoC"])
def test_a_scale_that_rest_contradicts_is_asked_about(tmp_path, key, scale):
    right = read_recording(written(key, tmp_path / "right"))
    path = written(key, tmp_path / "wrong", scale * np.eye(3))
    with pytest.raises(LogQuestion, match=r"but gravity is 9\.81") as asked:
        read_recording(path, parse_choices(["accel-unit=m/s2"]))
    kept, scaled = (str(one).split()[0] for one in asked.value.answers)
    for answer, factor in ((kept, scale), (scaled, 1.0)):
        found = read_recording(path, parse_choices([answer]))
        np.testing.assert_allclose(
            found.imu.specific_force_mps2,
            factor * right.imu.specific_force_mps2,
            rtol=0.01,
            atol=0.02,
        )


@needs("loggers")
def test_a_sign_that_was_given_is_not_offered_again(tmp_path):
    upright = -np.array([X, Z, -Y])
    path = written("EuRoC", tmp_path / "log", upright, -upright)
    with pytest.raises(LogQuestion, match="accel-sign=-") as asked:
        read_recording(path)
    assert any("axes=" in str(one) for one in asked.value.answers)
    for sign in "+-":
        with pytest.raises(LogQuestion) as again:
            read_recording(path, parse_choices([f"accel-sign={sign}"]))
        assert not any("accel-sign" in str(one) for one in again.value.answers)
        read_recording(
            path, parse_choices([f"accel-sign={sign}", first_answer(again).rstrip(",")])
        )


def test_a_logger_that_swapped_its_columns_is_mended():
    path = case_file("gcsv-swapped", "swapped.gcsv")
    with pytest.raises(LogQuestion, match="swapped=accel,rate"):
        read_recording(path)
    found = read_recording(path, parse_choices(["swapped=accel,rate"]))
    norm = np.linalg.norm(found.imu.specific_force_mps2[:250], axis=1)
    assert norm.mean() == pytest.approx(9.81, abs=0.05)


def test_a_car_that_brakes_evenly_is_not_at_rest():
    """It shows 1.2 g for as long as it stands still at a light."""
    imu = simulate_motion("car-hard", 6, sensor="paper-board").imu
    begin = int(np.searchsorted(imu.time_s, imu.time_s[0] + 20.0))
    piece = imu.part(slice(begin, begin + 600))
    assert norm_at_rest(piece) == pytest.approx(9.98, abs=0.05)
