import dataclasses
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from hapticplayer.errors import Cancelled, MediaError, UsageError
from hapticplayer.extras.rides import recording
from hapticplayer.extras.rides.catalogue import SCENES
from hapticplayer.extras.rides.film import film
from hapticplayer.extras.rides.film.frame import PictureMaker
from hapticplayer.extras.rides.film.view import CameraPose
from hapticplayer.extras.rides.recording import (
    SimulatedRecording,
    simulate,
    write_simulated_clip,
)
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import STANDARD_GRAVITY_MPS2

SEED = 2012


@pytest.fixture(scope="module")
def ride() -> SimulatedRecording:
    return simulate("demo", SEED)


@pytest.fixture(scope="module")
def studio(ride: SimulatedRecording) -> tuple[PictureMaker, list[CameraPose]]:
    return ride.film.studio()


def rotations(ride: SimulatedRecording, time_s: NDArray[np.float64]) -> Rotation:
    """Orientation by scipy, which has no code in common with the simulator."""
    quaternion = ride.scene.trajectory.at(time_s).quaternion_wxyz
    return Rotation.from_quat(quaternion, scalar_first=True)


def small(ride: SimulatedRecording) -> SimulatedRecording:
    """Fifty small pictures of it."""
    return dataclasses.replace(ride, width=160, height=90, frame_rate_hz=5)


def tiny(ride: SimulatedRecording) -> SimulatedRecording:
    return dataclasses.replace(ride, width=64, height=36, frame_rate_hz=1)


def write(ride: SimulatedRecording, path: Path, painters: int) -> Path:
    """Write its clip; progress only grows, to 1."""
    progress: list[float] = []
    with pytest.MonkeyPatch.context() as patch:
        if painters == 2:
            patch.setattr(recording, "WORTH_PX", 0)
        write_simulated_clip(ride, path, progress.append)
    assert progress[-1] == 1.0
    assert np.diff(progress).min() >= 0.0
    return path


@pytest.fixture(scope="module")
def drawn() -> list[NDArray[np.int64]]:
    """The pictures of `clip`, once it is written."""
    return []


@pytest.fixture(scope="module")
def clip(
    ride: SimulatedRecording,
    drawn: list[NDArray[np.int64]],
    tmp_path_factory: pytest.TempPathFactory,
) -> Path:
    frames = film.Film.frames

    def kept(self: film.Film, first: int, end: int) -> Iterator[NDArray[np.uint8]]:
        for picture in frames(self, first, end):
            drawn.append(picture[:, :, :3].astype(int))
            yield picture

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(film.Film, "frames", kept)
        return write(small(ride), tmp_path_factory.mktemp("one") / "clip.mp4", 1)


@pytest.fixture(scope="module")
def clip_of_two(
    ride: SimulatedRecording, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    """The same by two painters."""
    return write(small(ride), tmp_path_factory.mktemp("two") / "clip.mp4", 2)


TIMES_S = np.arange(0.05, 9.95, 0.00371)


def test_specific_force_is_the_second_derivative_of_the_path(
    ride: SimulatedRecording,
) -> None:
    """f = R^T (a + g z), with a from central differences of the position.

    The differences of step h err by h^2/12 times the fourth derivative (below
    8e4 m/s4 here) and by 4 eps |p| / h^2: 2e-3 m/s2 with h = 0.5 ms.
    """
    step_s, path = 5e-4, ride.scene.trajectory
    before, here, after = (
        path.at(TIMES_S + shift).position_m for shift in (-step_s, 0.0, step_s)
    )
    acc_earth = (before - 2.0 * here + after) / step_s**2
    gravity = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])
    to_sensor = rotations(ride, TIMES_S).inv()
    truth = path.at(TIMES_S)
    np.testing.assert_allclose(
        truth.specific_force_mps2, to_sensor.apply(acc_earth + gravity), atol=5e-3
    )
    np.testing.assert_allclose(
        truth.acceleration_mps2, to_sensor.apply(acc_earth), atol=5e-3
    )


def test_velocity_is_the_derivative_of_the_path(ride: SimulatedRecording) -> None:
    step_s, path = 1e-4, ride.scene.trajectory
    moved = path.at(TIMES_S + step_s).position_m - path.at(TIMES_S - step_s).position_m
    np.testing.assert_allclose(
        path.at(TIMES_S).velocity_mps, moved / (2.0 * step_s), atol=1e-5
    )


def test_angular_rate_turns_the_orientation(ride: SimulatedRecording) -> None:
    """w = log(R(t-h)^T R(t+h)) / 2h; the error is h^2/6 of its second derivative."""
    step_s = 2e-4
    before = rotations(ride, TIMES_S - step_s)
    after = rotations(ride, TIMES_S + step_s)
    numerical = (before.inv() * after).as_rotvec() / (2.0 * step_s)
    exact = ride.scene.trajectory.at(TIMES_S).angular_rate_radps
    np.testing.assert_allclose(exact, numerical, atol=1e-5)


def test_integrated_gyro_ends_where_the_truth_ends(ride: SimulatedRecording) -> None:
    """The noise-free gyro is the mean over each interval, so no angle is lost."""
    truth = ride.truth
    mean = ride.scene.trajectory.mean_rate_radps(truth.time_s, 1.0 / 200.0)
    turned = Rotation.from_quat(truth.quaternion_wxyz[0], scalar_first=True)
    for rate in mean[1:]:
        turned = turned * Rotation.from_rotvec(rate / 200.0)
    end = Rotation.from_quat(truth.quaternion_wxyz[-1], scalar_first=True)
    assert (end.inv() * turned).magnitude() < 1e-9


def test_log_is_the_truth_with_small_noise_and_bias(ride: SimulatedRecording) -> None:
    assert ride.imu.rate_hz == pytest.approx(200.0)
    assert len(ride.imu) == len(ride.truth.time_s) == 2001
    error = ride.imu.specific_force_mps2 - ride.truth.specific_force_mps2
    np.testing.assert_allclose(error.std(axis=0), 0.035, rtol=0.1)
    assert np.abs(error.mean(axis=0)).max() < 4 * 0.04
    still = ride.truth.time_s < 1.4
    gyro = ride.imu.angular_rate_radps[still]
    np.testing.assert_allclose(gyro.std(axis=0), 0.003, rtol=0.2)
    assert 0.0 < np.abs(gyro.mean(axis=0)).max() < 4 * 0.004


def test_ride_is_a_ride(ride: SimulatedRecording) -> None:
    """Away from rest, forward, around a left bend, over a kerb, to a stop."""
    truth = ride.truth
    still = truth.time_s < 1.45
    assert np.abs(truth.acceleration_mps2[still]).max() < 1e-3
    speed = np.linalg.norm(truth.velocity_mps[:, :2], axis=1)
    assert 4.5 < speed.max() < 6.5
    assert speed[-1] < 0.05

    def mean(start_s: float, end_s: float) -> NDArray[np.float64]:
        chosen = (truth.time_s >= start_s) & (truth.time_s < end_s)
        return truth.acceleration_mps2[chosen].mean(axis=0)

    assert mean(2.5, 3.5)[1] > 2.0  # front
    assert mean(4.5, 5.5)[0] < -2.0  # centripetal, to the left
    assert mean(8.2, 8.8)[1] < -4.0  # braking
    peaks = np.abs(truth.acceleration_mps2[:, 2])
    for bump in ride.scene.bumps:
        hit = (truth.time_s > bump.time_s) & (truth.time_s < bump.time_s + 0.15)
        assert 8.0 < peaks[hit].max() < 30.0
    rolling = (truth.time_s > 4.0) & (truth.time_s < 6.6)
    assert 0.4 < truth.acceleration_mps2[rolling, 2].std() < 2.0


def test_same_seed_gives_the_same_recording(ride: SimulatedRecording) -> None:
    again, other = simulate("demo", SEED), simulate("demo", SEED + 1)
    np.testing.assert_array_equal(
        ride.imu.specific_force_mps2, again.imu.specific_force_mps2
    )
    np.testing.assert_array_equal(ride.audio, again.audio)
    assert not np.array_equal(ride.audio, other.audio)
    assert not np.array_equal(
        ride.truth.acceleration_mps2, other.truth.acceleration_mps2
    )


def test_unknown_scene_lists_the_known_ones() -> None:
    with pytest.raises(UsageError, match="scene 'moon' not found; choose one of bike"):
        simulate("moon", 1)
    assert "demo" in SCENES


def test_thumps_begin_when_the_wheels_hit(ride: SimulatedRecording) -> None:
    assert ride.audio.dtype == np.float32
    assert ride.audio.shape == (480_000, 2)
    assert np.abs(ride.audio).max() <= 1.0
    for hit_s, strength in ride.scene.wheel_hits:
        at = round(hit_s * 48_000)
        before = np.abs(ride.audio[at - 480 : at]).max()
        # 1 ms: the attack of the thump; its first half wave is 3.5 ms long
        after = np.abs(ride.audio[at : at + 144]).max()
        if strength == 1.0:
            assert after > before + 0.25
    front_hits = [bump.time_s for bump in ride.scene.bumps]
    assert set(front_hits) <= {hit_s for hit_s, _ in ride.scene.wheel_hits}


def test_sound_grows_with_speed(ride: SimulatedRecording) -> None:
    def loudness(start_s: float, end_s: float) -> float:
        part = ride.audio[round(start_s * 48_000) : round(end_s * 48_000)]
        return float(np.sqrt(np.mean(part.astype(np.float64) ** 2)))

    assert loudness(0.0, 1.4) < 0.01
    assert loudness(5.0, 6.5) > 8.0 * loudness(0.0, 1.4)
    assert loudness(2.0, 3.0) < loudness(5.0, 6.5)


def test_recording_and_truth_are_handed_on(ride: SimulatedRecording) -> None:
    recording = ride.recording()
    assert recording.imu is ride.imu
    assert recording.clock_map.confidence == 1.0
    assert recording.provenance["seed"] == SEED
    arrays = ride.truth.arrays()
    assert {"time_s", "acceleration_mps2", "quaternion_wxyz"} <= set(arrays)
    assert all(len(array) == 2001 for array in arrays.values())


def turned(pose: CameraPose, axis: int, angle_rad: float) -> CameraPose:
    rotvec = np.zeros(3)
    rotvec[axis] = angle_rad
    rotation = pose.rotation @ Rotation.from_rotvec(rotvec).as_matrix()
    return pose._replace(rotation=rotation)


def moved_px(before: NDArray[np.uint8], after: NDArray[np.uint8]) -> NDArray[np.int64]:
    """How far the middle of the picture moved right and down (phase correlation)."""
    part = (slice(120, 376), slice(352, 608))  # above the handlebar
    window = np.outer(np.hanning(256), np.hanning(256))
    a, b = (np.fft.rfft2(window * (p[part][:, :, 1] - 128.0)) for p in (before, after))
    cross = np.conj(a) * b
    surface = np.fft.irfft2(cross / (np.abs(cross) + 1e-9), s=(256, 256))
    down, right = np.unravel_index(surface.argmax(), surface.shape)
    return (np.array([right, down]) + 128) % 256 - 128


@pytest.mark.parametrize(
    ("axis", "direction"),
    [(2, (1, 0)), (0, (0, 1))],
    ids=["turning left moves it right", "lifting the nose moves it down"],
)
def test_picture_turns_with_the_camera(
    studio: tuple[PictureMaker, list[CameraPose]], axis: int, direction: tuple[int, int]
) -> None:
    """A turn by 1.5 degrees moves the middle by f tan(angle) = 14 px."""
    maker, poses = studio
    angle_rad = np.radians(1.5)
    focal_px = 480.0 / np.tan(np.radians(42.0))
    before = maker.draw(poses[100])
    after = maker.draw(turned(poses[100], axis, angle_rad))
    expected = focal_px * np.tan(angle_rad) * np.array(direction)
    assert np.abs(moved_px(before, after) - expected).max() <= 2.0


def test_horizon_tilts_against_the_lean(
    studio: tuple[PictureMaker, list[CameraPose]],
) -> None:
    """Leaning to the left (roll < 0) turns the world clockwise: left side up."""
    maker, poses = studio
    upright = maker.draw(poses[0]).astype(int)
    leaning = maker.draw(turned(poses[0], 1, np.radians(-10.0))).astype(int)

    def horizon(picture: NDArray[np.int64], column: int) -> int:
        # grass is much greener than blue; hills, haze and sky are not
        is_grass = picture[:, column, 1] - picture[:, column, 2] > 25
        return int(np.argmax(np.convolve(is_grass, np.ones(12), "valid") > 10))

    # two columns without trees, 220 px apart: 39 px at 10 degrees
    assert abs(horizon(upright, 480) - horizon(upright, 700)) < 8
    assert 25 < horizon(leaning, 700) - horizon(leaning, 480) < 55


def test_pictures_are_rgb_of_the_promised_size(
    studio: tuple[PictureMaker, list[CameraPose]], ride: SimulatedRecording
) -> None:
    maker, poses = studio
    picture = maker.draw(poses[150])
    assert picture.shape == (540, 960, 4)
    assert picture.dtype == np.uint8
    assert picture.flags.c_contiguous
    assert len(poses) == ride.film.frame_count == 300
    sky, ground = picture[40, 480].astype(int), picture[340, 700].astype(int)
    assert sky[2] > sky[0]
    assert ground[1] > ground[2]


def test_drawing_does_not_depend_on_what_was_drawn_before(
    studio: tuple[PictureMaker, list[CameraPose]],
) -> None:
    maker, poses = studio
    first = maker.draw(poses[205])
    maker.draw(poses[140])
    np.testing.assert_array_equal(maker.draw(poses[205]), first)


def test_clip_is_written_with_pictures_and_sound(
    clip: Path, ride: SimulatedRecording
) -> None:
    info = probe(clip)
    assert (info.width, info.height, info.frame_count) == (160, 90, 50)
    assert info.duration_s == pytest.approx(10.0, abs=0.01)
    with VideoDecoder(clip) as video:
        assert sum(1 for _ in video.frames()) == 50
    hit_s = ride.scene.bumps[0].time_s
    with AudioDecoder(clip) as sound:
        sound.seek(hit_s - 0.02)
        blocks = [sound.next_block() for _ in range(3)]
        heard = np.concatenate([block.samples for block in blocks if block])
        start_s = blocks[0].media_s if blocks[0] else 0.0
    loud = np.flatnonzero(np.abs(heard[:, 0]) > 0.35)[0] / 48_000 + start_s
    assert loud == pytest.approx(hit_s, abs=0.004)


def test_cancelled_clip_leaves_nothing(
    tmp_path: Path, ride: SimulatedRecording
) -> None:
    def stop(_fraction: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        write_simulated_clip(tiny(ride), tmp_path / "demo.mp4", stop)
    assert list(tmp_path.iterdir()) == []


def decoded(path: Path) -> NDArray[np.int64]:
    converter = FrameConverter()
    with VideoDecoder(path) as video:
        images = [converter.convert(frame, 160, 90) for frame in video.frames()]
    return np.array([image.as_rgb().astype(int) for image in images])


def test_two_painters_make_the_clip_that_one_makes(
    clip: Path, clip_of_two: Path, drawn: list[NDArray[np.int64]]
) -> None:
    one, two = probe(clip), probe(clip_of_two)
    assert (two.frame_count, two.duration_s) == (one.frame_count, one.duration_s)
    pictures = decoded(clip), decoded(clip_of_two)
    assert len(drawn) == 50
    lost = [np.abs(coded - drawn).mean(axis=(1, 2, 3)) for coded in pictures]
    np.testing.assert_allclose(lost[1], lost[0], rtol=0.5)  # of equal quality
    assert lost[1].mean() == pytest.approx(lost[0].mean(), rel=0.05)
    moves = np.abs(np.diff(drawn, axis=0)).mean(axis=(1, 2, 3)) > 12.0
    assert moves.sum() > 10
    for k in 1 + np.flatnonzero(
        moves[:-1] & moves[1:]
    ):  # and drawn alike: no picture is lost or comes twice
        near = np.abs(drawn[k] - pictures[1][k - 1 : k + 2]).mean(axis=(1, 2, 3))
        assert np.argmin(near) == 1
    with VideoDecoder(clip_of_two) as video:
        times_s = [frame.pts_s for frame in video.frames()]
    np.testing.assert_allclose(np.diff(times_s), 0.2, atol=1e-6)
    sounds = []
    for path in (clip, clip_of_two):
        with AudioDecoder(path) as sound:
            blocks = iter(sound.next_block, None)
            sounds.append(np.concatenate([block.samples for block in blocks]))
    np.testing.assert_array_equal(*sounds)


def test_the_same_seed_gives_the_same_clip_byte_for_byte(
    tmp_path: Path, clip_of_two: Path, ride: SimulatedRecording
) -> None:
    again = write(small(ride), tmp_path / "again.mp4", 2)
    assert again.read_bytes() == clip_of_two.read_bytes()


def test_a_painter_that_dies_is_told_and_leaves_nothing(
    tmp_path: Path, ride: SimulatedRecording, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recording, "WORTH_PX", 0)
    broken = (sys.executable, "-c", "raise SystemExit('no memory')")
    monkeypatch.setattr(film, "COMMAND", broken)
    with pytest.raises(MediaError, match="no memory"):
        write_simulated_clip(tiny(ride), tmp_path / "demo.mp4")
    assert list(tmp_path.iterdir()) == []
