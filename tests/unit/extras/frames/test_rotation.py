import importlib.util
import weakref
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.signal import butter, sosfiltfilt
from scipy.spatial.transform import Rotation

from hapticplayer.capture.frames import FeatureKind, FrameRotation
from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.errors import Cancelled, InputError
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.synchronizing import synchronize_frames
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.model import ImuLog
from tests.unit.extras.frames.conftest import FRAME_RATE_HZ, film, turning

RIDE_S = 6
FOCAL_GAIN = np.tan(np.radians(40.0)) / np.tan(np.radians(42.0))
"""Of the assumed field of view, 80 degrees, and that of the simulator's camera, 84."""


@pytest.fixture(autouse=True)
def _needs_opencv() -> None:
    pytest.importorskip("cv2", reason="OpenCV is not installed")


def high_passed(values: np.ndarray) -> np.ndarray:
    return sosfiltfilt(
        butter(2, 0.4, "high", fs=FRAME_RATE_HZ, output="sos"), values, axis=0
    )


def write(path: Path, frames: list[np.ndarray]) -> Path:
    write_clip(path, frames, frame_rate_hz=FRAME_RATE_HZ)
    return path


@pytest.fixture(scope="module")
def ridden(ride_film):
    """Return what finds the rotation of a ride, and the shares on the way, once."""

    @cache
    def found(scene: str) -> tuple[FrameRotation, list[float]]:
        shares: list[float] = []
        clip = ride_film(scene, 10.0, RIDE_S)
        return rotation(
            clip, progress=lambda share, _step: shares.append(share)
        ), shares

    return found


@pytest.mark.parametrize(
    ("scene", "axes", "least", "most_error_degps"),
    [("horse", (0, 1), 0.99, 1.5), ("bike", (1,), 0.97, 1.5)],
)
def test_rotation_of_a_ride(ridden, scene, axes, least, most_error_degps) -> None:
    found, _ = ridden(scene)

    trajectory = film(scene).scene.trajectory
    step_s = 1.0 / FRAME_RATE_HZ
    truth = trajectory.mean_rate_radps(10.0 + found.end_s, step_s)
    found_rate = high_passed(found.rotation_rad) / step_s
    truth = high_passed(truth)
    assert len(found) == RIDE_S * FRAME_RATE_HZ - 1
    assert np.degrees(np.std(found_rate - truth, axis=0)).max() < most_error_degps
    for axis in axes:
        assert np.corrcoef(found_rate[:, axis], truth[:, axis])[0, 1] > least


def test_each_axis_has_its_sign_and_gain(tmp_path, standing_m) -> None:
    time_s = np.arange(60) / FRAME_RATE_HZ
    angles = 0.1 * np.sin(2 * np.pi * np.outer(time_s, (0.7, 1.1, 1.7)))
    turned = Rotation.from_rotvec(angles)
    truth = (turned[:-1].inv() * turned[1:]).as_rotvec()

    found = rotation(write(tmp_path / "turning.mp4", turning(turned, standing_m)))

    for axis, gain in enumerate((FOCAL_GAIN, 1.0, FOCAL_GAIN)):
        found_rate, true = found.rotation_rad[:, axis], truth[:, axis]
        assert found_rate @ true / (true @ true) == pytest.approx(gain, abs=0.04)
    assert found.quality.mean() > 0.6


def test_a_cut_or_a_blank_frame_has_no_rotation(tmp_path) -> None:
    bike, horse = film("bike"), film("horse")
    blank = [np.full((180, 320, 4), 90, np.uint8)] * 15
    frames = [*bike.frames(300, 315), *horse.frames(600, 615), *blank]
    found = rotation(write(tmp_path / "cuts.mp4", frames))

    assert found.quality[14] == 0.0
    assert (found.quality[29:] == 0.0).all()
    assert (found.rotation_rad[30:] == 0.0).all()
    assert np.delete(found.quality[:29], 14).min() > 0.3


def test_spans_are_looked_at_and_nothing_else(ride_film, ridden) -> None:
    whole, _ = ridden("bike")
    parts = rotation(ride_film("bike", 10.0, RIDE_S), spans_s=[(1.0, 2.0), (3.0, 4.0)])

    assert len(parts) == 2 * FRAME_RATE_HZ
    assert parts.begin_s[0] == pytest.approx(1.0)
    rows = np.searchsorted(whole.begin_s, parts.begin_s - 1e-6)
    assert whole.end_s[rows] == pytest.approx(parts.end_s)
    apart = np.abs(whole.rotation_rad[rows] - parts.rotation_rad)
    assert np.median(apart) < 1e-3


def test_progress_grows_to_the_end_and_cancels(ride_film, ridden) -> None:
    _, shares = ridden("bike")

    def cancel(share: float, _step: str) -> None:
        if share > 0.2:
            raise Cancelled

    assert shares == sorted(shares)
    assert shares[-1] > 0.95
    with pytest.raises(Cancelled):
        rotation(ride_film("bike", 10.0, RIDE_S), progress=cancel)


def test_frames_are_not_kept(ride_film, monkeypatch) -> None:
    convert = FrameConverter.convert_grey
    made: list[weakref.ref[np.ndarray]] = []
    most_alive = 0

    def counted(self, *arguments) -> np.ndarray:
        nonlocal most_alive
        grey = convert(self, *arguments)
        made.append(weakref.ref(grey))
        most_alive = max(most_alive, sum(one() is not None for one in made))
        return grey

    monkeypatch.setattr(FrameConverter, "convert_grey", counted)
    rotation(ride_film("bike", 10.0, RIDE_S), spans_s=[(0.0, 2.0)])

    assert len(made) >= 2 * FRAME_RATE_HZ
    assert most_alive <= 3


def test_log_of_a_ride_is_laid_over_its_film(ridden) -> None:
    begin_s, offset_s, step_s = 10.0, 7.3, 0.005
    ride_s = np.arange(0.0, 40.0, step_s)
    trajectory = film("horse").scene.trajectory
    rate = trajectory.mean_rate_radps(ride_s, step_s) @ axes_matrix("y,-x,z")
    imu = ImuLog(ride_s - begin_s - offset_s, np.zeros_like(rate), rate)

    found = synchronize_frames(imu, ridden("horse")[0])

    assert found.is_confident
    assert found.clock_map.offset_s == pytest.approx(offset_s, abs=0.0035)
    assert found.mounting is not None
    assert found.mounting.axes == "y,-x,z"


def test_without_opencv_it_says_what_installing_brings(monkeypatch) -> None:
    find = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "cv2" else find(name)
    )

    with pytest.raises(InputError, match=r"hapticplayer\[vision\].*without taps"):
        rotation("any.mp4", kind=FeatureKind.CORNERS)
