"""A camera without timestamps, whose lag the frames measure or not."""

from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.clock_lag import unstamped
from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.recording import OtherPlace
from hapticplayer.capture.sync.result import COARSE_NOTE, Synchronisation, SyncInput
from hapticplayer.capture.sync.synchronize import by_own_clock
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.frames.own_clock import by_frames
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.sequence.synchronizing import SyncChoices, synchronized
from tests.unit.capture.conftest import recorded
from tests.unit.extras.frames.test_synchronizing import CLIP_S, NOISE_RAD, Ride


def refined(imu: ImuLog, frames: FrameRotation) -> Synchronisation:
    inputs = SyncInput(
        imu, lambda: None, own=ClockMap(), look=lambda: frames, lag=unstamped()
    )
    return by_own_clock(inputs)


def is_unchanged(found: Synchronisation) -> bool:
    assert found.lag is not None
    kept = found.clock_map == ClockMap() and not found.lag.is_measured
    return kept and "10 to 30 ms" in found.lag.text and found.offset_sigma_s == 0.02


@pytest.mark.parametrize("lag_s", [0.0, -0.0175, 0.03])
@pytest.mark.parametrize("rms_radps", [0.02, 0.2])
def test_lag_is_measured_and_taken_out(lag_s, rms_radps):
    ride = Ride(1, rms_radps)

    found = refined(ride.log(ClockMap(-lag_s)), ride.frames())

    assert found.method == "embedded"
    assert found.lag is not None
    assert found.lag.measured_by == "frames"
    assert found.lag.lag_s == pytest.approx(lag_s, abs=0.0015)
    assert abs(found.lag.lag_s - lag_s) < 3.0 * found.offset_sigma_s
    error_s = found.media_s(CLIP_S / 2 + lag_s) - CLIP_S / 2
    assert abs(error_s) < 0.0015
    assert found.described()["lag"]["measured_by"] == "frames"
    assert found.mounting is not None
    assert found.mounting.axes == "x,y,z"


@pytest.mark.parametrize(("offset_s", "is_lag"), [(0.02, True), (0.2, False)])
def test_frames_measure_the_lag_of_an_own_clock(offset_s, is_lag):
    ride = Ride(1)
    inputs = SyncInput(
        ride.log(ClockMap(offset_s)), lambda: None, look=ride.frames, lag=unstamped()
    )

    found = by_frames(inputs)

    assert found.method == "frames"
    assert (found.lag is not None) == is_lag
    if found.lag is not None:
        assert found.lag.lag_s == pytest.approx(-offset_s, abs=0.0015)
        assert found.lag.measured_by == "frames"


@pytest.mark.parametrize("offset_s", [0.0, -0.4])
def test_frames_decide_where_a_cut_clip_is_contradicted(offset_s):
    ride = Ride(1)

    def silent():
        raise InputError("it holds no sound")

    inputs = SyncInput(
        ride.log(ClockMap(offset_s)),
        silent,
        own=ClockMap(),
        look=ride.frames,
        contradiction=Message("the clip was cut"),
        others=(OtherPlace(Message("as the camera's stamps begin"), -0.4),),
    )

    found = by_own_clock(inputs)

    assert found.is_confident
    assert found.method == "frames"
    assert found.media_s(30.0) == pytest.approx(30.0 + offset_s, abs=0.01)
    assert found.described()["contradiction"] == "the clip was cut"


def test_stabilised_frames_change_nothing():
    """A tenth of the rotation is left, and what the stabiliser does of its own."""
    ride, others = Ride(1), Ride(7, 0.03)
    shown = 0.1 * ride.frames().rotation_rad + others.frames().rotation_rad

    found = refined(
        ride.log(ClockMap(0.02)), replace(ride.frames(), rotation_rad=shown)
    )

    assert is_unchanged(found)
    assert "stabilised" in found.lag.text or "not that of the gyro" in found.lag.text


def test_a_still_camera_changes_nothing():
    ride = Ride(1, 1e-5)
    noise = np.random.default_rng(2).normal(0.0, NOISE_RAD, (len(ride.frames()), 3))

    found = refined(
        ride.log(ClockMap(0.02)), replace(ride.frames(), rotation_rad=noise)
    )

    assert is_unchanged(found)


def test_a_slow_pan_changes_nothing():
    ride = Ride(1, 0.05)
    ride.hz = np.full_like(ride.hz, 0.1)
    ride.size[:, :2] = 0.0

    assert is_unchanged(refined(ride.log(ClockMap(0.02)), ride.frames()))


@pytest.mark.parametrize(("offset_s", "axes"), [(0.2, "x,y,z"), (0.02, "y,-x,z")])
def test_offsets_that_no_camera_has_change_nothing(offset_s, axes):
    """Cameras are not so far off, and their axes are known."""
    ride = Ride(1)

    assert is_unchanged(refined(ride.log(ClockMap(offset_s), axes), ride.frames()))


def test_without_frames_the_reason_is_given():
    def missing() -> FrameRotation:
        raise InputError(Message("OpenCV is not installed"))

    imu = Ride(1).log(ClockMap(0.02))
    found = by_own_clock(
        SyncInput(imu, lambda: None, own=ClockMap(), look=missing, lag=unstamped())
    )

    assert is_unchanged(found)
    assert "OpenCV is not installed" in found.lag.text
    # without a clip nothing is said of frames
    alone = by_own_clock(SyncInput(imu, lambda: None, own=ClockMap(), lag=unstamped()))
    assert is_unchanged(alone)
    assert "frames" not in alone.lag.text


def test_lag_of_a_real_hero5_is_measured():
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    clip = recorded("gopro/karma.mp4")
    recording = read_recording(clip)
    frames = rotation(clip)
    inputs = SyncInput(
        recording.imu,
        lambda: None,
        own=recording.clock_map,
        look=lambda: frames,
        lag=recording.lag,
    )

    found = by_own_clock(inputs)

    assert found.lag is not None
    assert 1e3 * found.lag.lag_s == pytest.approx(-17.5, abs=3.0)
    assert found.frames is not None
    assert found.frames.spread_s < 0.002
    # the second half alone says the same; the camera is calm in the first
    part = frames.select(frames.begin_s > 6.0)
    alone = by_own_clock(inputs._replace(look=lambda: part))
    assert 1e3 * alone.lag.lag_s == pytest.approx(-17.5, abs=3.5)

    # and the vectors of the camera's own encoder, without OpenCV, nearly so
    coarse = rotation(clip, kind=FeatureKind.VECTORS)
    alone = by_own_clock(inputs._replace(look=lambda: coarse))
    assert 1e3 * alone.lag.lag_s == pytest.approx(-17.5, abs=3.5)
    assert alone.lag.sigma_s > 1.7 * found.lag.sigma_s

    accepted = SyncChoices(accepted=found)
    made = synchronized(probe(clip), recording, accepted)
    assert made.clock_map == found.clock_map
    assert made.provenance["clock_lag"]["measured_by"] == "frames"
    assert not made.provenance["synchronisation"]["seen_by_person"]
    assert sum("does not timestamp" in note for note in made.notes) == 1
    assert any("this is corrected" in note for note in made.notes)
    assert COARSE_NOTE not in made.notes
    accepted = SyncChoices(accepted=alone)
    assert COARSE_NOTE in synchronized(probe(clip), recording, accepted).notes
