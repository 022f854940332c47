"""Real and simulated force through every format that keeps newtons."""

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.model import Mapping, MotionTrack
from hapticplayer.motion import remove_gravity
from hapticplayer.rendering import render_force
from hapticplayer.sequence.force_files import WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    read_force,
    read_formats,
    written_formats,
)

BOTH_WAYS = [
    name for name in written_formats() if name in read_formats() and name != "funscript"
]


def comes_back(track, folder, seconds):
    at_s = np.arange(round(1000 * seconds)) / 1000.0
    for name in BOTH_WAYS:
        path = folder / f"track{written_formats()[name].suffix}"
        export_track(
            track, path, written_formats()[name], WriteChoices(duration_s=seconds)
        )
        error_n = track.at(at_s) - read_force(path).track.at(at_s)
        assert np.linalg.norm(error_n, axis=1).max() <= 0.01002, name
    choices = WriteChoices(duration_s=seconds)
    report = export_track(
        track, folder / "track.ahap", written_formats()["ahap"], choices
    )
    assert report["error_max_n"] <= 0.01002


@pytest.mark.parametrize("scene", MOTION_SCENES)
def test_the_force_of_a_simulated_ride_comes_back(scene, tmp_path):
    ride = simulate_motion(scene, 1, duration_s=6.0)
    count = len(ride.imu.time_s)
    motion = MotionTrack(
        time_s=ride.imu.time_s - ride.imu.time_s[0],
        acceleration_mps2=ride.acceleration_mps2,
        gravity_mps2=np.tile([0.0, 0.0, 9.80665], (count, 1)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, dtype=bool),
    )
    comes_back(render_force(motion, Mapping()), tmp_path, 5.0)


def test_the_force_of_a_drone_comes_back(shared_data, tmp_path):
    recording = read_recording(shared_data / "capture" / "gopro" / "karma.mp4")
    comes_back(render_force(remove_gravity(recording.imu), Mapping()), tmp_path, 12.0)
