"""Logs that are read wrongly, and clips whose frames show it."""

import functools
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture.choices import LogQuestion
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import InputError, UsageError, no_progress
from hapticplayer.extras.frames import reading
from hapticplayer.extras.frames.reading import compared
from hapticplayer.extras.frames.synchronizing import synchronize_frames
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.sequence.synchronizing import SyncChoices, find_sync
from tests.unit.extras.frames.test_synchronizing import Ride

X, Y, Z = np.eye(3)
SWAPPED = np.array([Y, X, Z])
CLOCK = ClockMap(3.1, confidence=0.9)
TAPS = Synchronisation(CLOCK, "pats")
CLIP = ClipInfo(Path("clip.mp4"), 30.0, 640, 360, 30.0, 900, False, 0, False)


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


def asked(
    recording: Recording,
    found: Synchronisation | None = None,
    shown: FrameRotation | None = None,
) -> Synchronisation:
    shown = shown or frames()
    found = found or synchronize_frames(recording.imu, shown)
    return compared(CLIP, recording, found, no_progress, frames=shown)


def answered(recording: Recording, **answers: str) -> Recording:
    by_key = {key.replace("_", "-"): text for key, text in answers.items()}
    return replace(recording, provenance={"rate_unit": "rad/s", "answers": by_key})


@pytest.mark.parametrize(
    "rate", [np.eye(3), np.array([-Y, X, Z]), np.diag([-1.0, -1.0, 1.0])]
)
def test_a_right_log_is_not_asked_about_however_mounted(rate) -> None:
    assert "turns as the gyroscope does" in asked(log(rate=rate)).seen


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


def test_a_calm_camera_leaves_the_taps_alone() -> None:
    calm = replace(frames(), rotation_rad=0.02 * frames().rotation_rad)

    assert "hardly turns" in asked(log(seed=7), TAPS, calm).seen


def test_frames_that_show_nothing_leave_the_taps_alone() -> None:
    blank = replace(frames(), quality=np.zeros(len(frames())))

    asked(log(rate=-np.eye(3)), TAPS, blank)


def stabilised() -> FrameRotation:
    """The same clip, of which only a slow turn is left that the camera never made."""
    slow = np.sin(5.0 * frames().begin_s)[:, None] * np.array([0.001, 0.0, 0.004])
    return replace(frames(), rotation_rad=0.02 * frames().rotation_rad + slow)


OWN = Synchronisation(CLOCK, "embedded")
GIVEN = Synchronisation(CLOCK, "offset", middle_s=15.0)


@pytest.fixture
def followed(monkeypatch):
    """What is shown where parts of the clip are followed, and the parts."""
    parts = []

    def rotation(_path, *, spans_s, progress):
        parts.extend(spans_s)
        progress(1.0, "")
        inside = [
            (frames().begin_s >= begin) & (frames().end_s <= end)
            for begin, end in spans_s
        ]
        return frames().select(np.any(inside, axis=0))

    monkeypatch.setattr(reading, "rotation", rotation)
    return parts


def checked(recording: Recording, found: Synchronisation = GIVEN) -> Synchronisation:
    return compared(CLIP, recording, found, no_progress)


@pytest.mark.parametrize("found", [OWN, TAPS])
def test_a_given_clock_is_compared_in_few_frames(followed, found) -> None:
    result = checked(log(), found)

    assert "turns as the gyroscope does" in result.seen
    assert not result.is_seen_otherwise
    assert sum(end - begin for begin, end in followed) <= 15.1
    with pytest.raises(LogQuestion, match=r"rate-axes=x,y,-z if"):
        checked(log(rate=np.diag([1.0, 1.0, -1.0])), found)
    with pytest.raises(LogQuestion, match="accel-axes=-x,y,z rate-axes=-x,y,z"):
        checked(log(*(np.diag([-1.0, 1.0, 1.0]),) * 2), found)


def test_parts_are_followed_in_which_the_gyro_turns(followed) -> None:
    still = log()
    media_s = still.imu.time_s + CLOCK.offset_s
    rate = np.where(media_s[:, None] > 15.0, still.imu.angular_rate_radps, 0.0)
    calm = replace(still, imu=replace(still.imu, angular_rate_radps=rate))

    checked(calm)

    assert [begin for begin, _ in followed] == [15.0, 20.0, 25.0]


@pytest.mark.usefixtures("followed")
def test_taps_on_the_log_of_another_ride_are_doubted() -> None:
    other = log(seed=7)
    with pytest.raises(UsageError, match="any axes: is it the log of this clip") as why:
        asked(other, TAPS)

    # the offset that is named is taken, with a note
    offset_s = float(re.findall(r"--offset ([\d.]+)", str(why.value))[0])
    assert offset_s == CLOCK.offset_s
    result = checked(other, Synchronisation(ClockMap(offset_s), "offset"))
    assert result.is_seen_otherwise
    assert "does not turn as the gyroscope does" in result.seen


@pytest.mark.usefixtures("followed")
@pytest.mark.parametrize("off_s", [0.2, 3.0])
def test_a_wrong_offset_is_noted_with_the_right_one(off_s) -> None:
    wrong = Synchronisation(ClockMap(CLOCK.offset_s + off_s), "offset", middle_s=15.0)

    result = checked(log(), wrong)

    assert result.is_seen_otherwise
    shown_s = float(re.findall(r"--offset ([\d.]+)", result.seen)[0])
    assert shown_s == pytest.approx(CLOCK.offset_s, abs=0.02)


@pytest.mark.usefixtures("followed")
def test_a_unit_that_a_log_states_is_noted_beside_an_offset() -> None:
    result = checked(log(rate=np.eye(3) * np.pi / 180))

    assert "57.3 times its rate" in result.seen
    assert result.is_seen_otherwise


def test_a_stabilised_clip_is_no_fault_of_its_own_gyro() -> None:
    result = asked(log(), OWN, stabilised())

    assert "does not turn as the gyroscope does" in result.seen
    assert not result.is_seen_otherwise


@pytest.mark.usefixtures("followed")
def test_an_import_with_an_offset_compares_the_axes(tmp_path) -> None:
    path = tmp_path / "clip.mp4"
    write_clip(path, [np.full((48, 64, 3), 90, np.uint8)] * 60, frame_rate_hz=2.0)
    clip, choices = replace(CLIP, path=path), SyncChoices(offset_s=CLOCK.offset_s)

    assert "turns as the gyroscope does" in find_sync(clip, log(), choices).seen
    with pytest.raises(LogQuestion, match="rate-axes=-x,-y,-z"):
        find_sync(clip, log(rate=-np.eye(3)), choices)
    slow = replace(choices, slowed=4.0)
    assert "another speed" in find_sync(clip, log(rate=-np.eye(3)), slow).seen
