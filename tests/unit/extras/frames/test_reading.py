"""Logs that are read wrongly, and clips whose frames show it."""

import functools
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.capture.choices import LogQuestion
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import InputError, UsageError
from hapticplayer.extras.frames.reading import ask_about_reading
from hapticplayer.extras.frames.synchronizing import synchronize_frames
from hapticplayer.model import ClockMap, ImuLog
from tests.unit.extras.frames.test_synchronizing import Ride

X, Y, Z = np.eye(3)
SWAPPED = np.array([Y, X, Z])
CLOCK = ClockMap(3.1, confidence=0.9)
TAPS = Synchronisation(CLOCK, "pats")


@functools.cache
def frames() -> FrameRotation:
    return Ride(1).frames()


def log(accel=None, rate=None, seed: int = 1) -> Recording:
    """An upright log whose sensors were changed by (3, 3)."""
    accel, rate = (np.eye(3) if one is None else one for one in (accel, rate))
    imu = Ride(seed).log(CLOCK)
    up = np.tile([0.0, 0.0, 9.81], (len(imu.time_s), 1))
    changed = ImuLog(
        imu.time_s,
        up @ np.asarray(accel).T,
        imu.angular_rate_radps @ np.asarray(rate).T,
        sampling=imu.sampling,
        source="ride.csv",
    )
    return Recording(changed, ClockMap(confidence=0.0), "logger")


def asked(recording: Recording, found: Synchronisation | None = None) -> None:
    found = found or synchronize_frames(recording.imu, frames())
    ask_about_reading(recording, frames(), found)


def answered(recording: Recording, **answers: str) -> Recording:
    by_key = {key.replace("_", "-"): text for key, text in answers.items()}
    return replace(recording, provenance={"rate_unit": "rad/s", "answers": by_key})


@pytest.mark.parametrize(
    "rate", [np.eye(3), np.array([-Y, X, Z]), np.diag([-1.0, -1.0, 1.0])]
)
def test_a_right_log_is_not_asked_about_however_mounted(rate) -> None:
    asked(log(rate=rate))


@pytest.mark.parametrize(
    ("accel", "rate", "answer"),
    [
        (None, -np.eye(3), "rate-axes=-x,-y,-z"),
        (None, np.diag([1.0, 1.0, -1.0]), "rate-axes=x,y,-z"),
        (None, np.diag([1.0, -1.0, -1.0]), "rate-axes=x,-y,-z"),
        (SWAPPED, SWAPPED, "accel-axes=y,x,z rate-axes=y,x,z"),
        (np.diag([-1.0, 1.0, 1.0]),) * 2 + ("accel-axes=-x,y,z rate-axes=-x,y,z",),
    ],
)
def test_axes_that_the_frames_show_are_asked_for(accel, rate, answer) -> None:
    with pytest.raises(LogQuestion) as question:
        asked(log(accel, rate))

    texts = [str(one) for one in question.value.answers]
    assert any(text.startswith(answer) for text in texts)
    assert texts[-1].startswith("rate-axes=x,y,z to keep")


def test_taps_that_agree_do_not_silence_the_frames() -> None:
    with pytest.raises(LogQuestion, match="rate-axes=-x,-y,-z"):
        asked(log(rate=-np.eye(3)), TAPS)


def test_axes_that_a_person_keeps_are_kept() -> None:
    kept = answered(log(rate=-np.eye(3)), rate_axes="x,y,z")

    asked(kept, TAPS)


def test_a_wrong_answer_is_asked_about_again() -> None:
    wrong = answered(log(rate=np.diag([1.0, -1.0, -1.0])), rate_axes="x,-y,z")

    with pytest.raises(LogQuestion, match=r"rate-axes=x,y,-z if"):
        asked(wrong)


@pytest.mark.parametrize(
    ("unit", "scale", "answer"),
    [
        ("deg/s", np.pi / 180, "rate-unit=rad/s"),
        ("rad/s", 180 / np.pi, "rate-unit=deg/s"),
    ],
)
def test_unit_that_the_frames_show_is_asked_for(unit, scale, answer) -> None:
    recording = replace(log(rate=scale * np.eye(3)), provenance={"rate_unit": unit})

    with pytest.raises(LogQuestion, match=answer):
        asked(recording, TAPS)


def test_unit_that_a_person_keeps_is_kept() -> None:
    scaled = log(rate=np.eye(3) * np.pi / 180)

    asked(answered(scaled, rate_unit="1"), TAPS)


def test_unit_that_a_log_states_is_refused_with_its_factor() -> None:
    with pytest.raises(InputError, match=r"multiply it by 57\.29"):
        asked(log(rate=np.eye(3) * np.pi / 180), TAPS)


def test_taps_on_the_log_of_another_ride_are_doubted() -> None:
    with pytest.raises(UsageError, match="in any axes: is it the log of this clip"):
        asked(log(seed=7), TAPS)


def test_a_calm_camera_leaves_the_taps_alone() -> None:
    calm = replace(frames(), rotation_rad=0.02 * frames().rotation_rad)

    ask_about_reading(log(seed=7), calm, TAPS)


def test_frames_that_show_nothing_leave_the_taps_alone() -> None:
    blank = replace(frames(), quality=np.zeros(len(frames())))

    ask_about_reading(log(rate=-np.eye(3)), blank, TAPS)
