"""Rotation by the codec's motion vectors, without OpenCV, against the simulator."""

import importlib.util

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.synchronizing import synchronize_frames
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ImuLog
from tests.unit.extras.frames.conftest import FRAME_RATE_HZ, film, turning
from tests.unit.extras.frames.test_rotation import FOCAL_GAIN, RIDE_S


@pytest.fixture(autouse=True)
def _needs_opencv() -> None:
    """Nothing of this is needed here."""


def by_vectors(path) -> FrameRotation:
    return rotation(path, kind=FeatureKind.VECTORS)


def test_each_axis_has_its_sign_and_gain(tmp_path, standing_m) -> None:
    time_s = np.arange(60) / FRAME_RATE_HZ
    turned = Rotation.from_rotvec(
        0.1 * np.sin(2 * np.pi * np.outer(time_s, (0.7, 1.1, 1.7)))
    )
    path = tmp_path / "turning.mp4"
    write_clip(path, turning(turned, standing_m), frame_rate_hz=FRAME_RATE_HZ)

    found = by_vectors(path)

    begin, end = (
        np.rint(FRAME_RATE_HZ * at_s).astype(int)
        for at_s in (found.begin_s, found.end_s)
    )
    truth = (turned[begin].inv() * turned[end]).as_rotvec()
    known = found.quality > 0.0
    assert known.mean() > 0.8
    for axis, gain in enumerate((FOCAL_GAIN, 1.0, FOCAL_GAIN)):
        rate, true = found.rotation_rad[known, axis], truth[known, axis]
        assert rate @ true / (true @ true) == pytest.approx(gain, abs=0.08)
        assert np.corrcoef(rate, true)[0, 1] > 0.98


@pytest.mark.parametrize(
    ("scene", "axes", "least"),
    [("horse", (0, 1), 0.98), ("bike", (1,), 0.95), ("car-braking", (0,), 0.8)],
)
def test_rotation_of_a_ride(ride_film, scene, axes, least) -> None:
    found = by_vectors(ride_film(scene, 10.0, RIDE_S))

    trajectory = film(scene).scene.trajectory
    known = found.quality > 0.0
    spans = zip(
        10.0 + found.end_s[known], (found.end_s - found.begin_s)[known], strict=True
    )
    truth = np.array(
        [
            step_s * trajectory.mean_rate_radps(np.array([end]), step_s)[0]
            for end, step_s in spans
        ]
    )
    for axis in axes:
        rate = found.rotation_rad[known, axis]
        assert np.corrcoef(rate, truth[:, axis])[0, 1] > least


def test_vectors_are_used_without_opencv(ride_film, monkeypatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: None)

    found = rotation(ride_film("bike", 10.0, RIDE_S), spans_s=[(1.0, 3.0)])

    assert found.kind is FeatureKind.VECTORS
    assert found.quality.max() > 0.5
    assert 1.0 <= found.begin_s[0] <= found.end_s[-1] <= 3.0


def test_log_of_a_ride_is_synchronised_coarsely(ride_film) -> None:
    begin_s, offset_s, step_s = 10.0, 7.3, 0.005
    ride_s = np.arange(0.0, 40.0, step_s)
    trajectory = film("horse").scene.trajectory
    rate = trajectory.mean_rate_radps(ride_s, step_s) @ axes_matrix("y,-x,z")
    imu = ImuLog(ride_s - begin_s - offset_s, np.zeros_like(rate), rate)

    found = synchronize_frames(imu, by_vectors(ride_film("horse", begin_s, RIDE_S)))

    assert found.is_confident
    error_s = found.media_s(RIDE_S / 2 - offset_s) - RIDE_S / 2
    assert abs(error_s) < 0.008
    assert abs(error_s) < 2.0 * found.offset_sigma_s
    assert found.mounting is not None
    assert found.mounting.axes == "y,-x,z"
