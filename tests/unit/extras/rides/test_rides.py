"""The paper's rides: their character, their pats, and a board's log of them."""

import dataclasses
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.capture import read_recording, synchronize
from hapticplayer.capture.choices import parse_choices
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.extras.rides.board import PAPER, LoggerBoard, record
from hapticplayer.extras.rides.catalogue import RIDES
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES
from hapticplayer.extras.rides.recording import (
    SimulatedRecording,
    simulate,
    write_gopro_clip,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.media.encode import write_clip
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling

SEED = 61
Floats = NDArray[np.float64]


@cache
def ride(name: str) -> SimulatedRecording:
    return simulate(name, SEED)


def moving(name: str) -> tuple[Floats, Floats]:
    """True time and p after the standstill with the pats."""
    truth = ride(name).truth
    after = truth.time_s > 6.0
    return truth.time_s[after], truth.acceleration_mps2[after]


def longest_s(is_so: NDArray[np.bool_], step_s: float = 0.001) -> float:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], is_so.astype(int), [0]])))
    return float((edges[1::2] - edges[::2]).max(initial=0)) * step_s


def smoothed(values: Floats, width_s: float = 0.5) -> Floats:
    width = round(width_s * 1000)
    return np.convolve(values, np.full(width, 1.0 / width), "same")


@pytest.mark.parametrize(
    ("name", "duration_s"),
    [("bike", 61), ("horse", 60), ("car-turning", 45), ("car-braking", 75)],
)
def test_rides_last_as_long_as_the_papers(name: str, duration_s: int) -> None:
    recorded = ride(name)
    assert recorded.scene.duration_s == duration_s
    assert recorded.film.frame_count == 30 * duration_s
    assert len(recorded.truth.time_s) == 1000 * duration_s + 1
    assert len(recorded.audio) == 48_000 * duration_s
    assert (recorded.width, recorded.height) == (1280, 720)


def test_the_bicycle_shakes_little_and_the_horse_much() -> None:
    bike, horse = (moving(name)[1][:, 2] for name in ("bike", "horse"))
    assert 0.4 < np.sqrt(np.mean(bike**2)) < 1.5
    assert np.sqrt(np.mean(horse**2)) > 4.0 * np.sqrt(np.mean(bike**2))
    spectrum = np.abs(np.fft.rfft(horse)) ** 2
    frequency_hz = np.fft.rfftfreq(len(horse), 0.001)
    gait = (frequency_hz > 1.0) & (frequency_hz < 8.0)
    assert spectrum[gait].sum() > 0.9 * spectrum.sum()
    assert horse.min() > -1.3 * STANDARD_GRAVITY_MPS2


def test_roundabout_pushes_aside_strongly_for_a_long_time() -> None:
    _, p = moving("car-turning")
    assert longest_s(smoothed(p[:, 0]) < -3.5) > 15.0


def test_braking_is_strong_for_seconds() -> None:
    _, p = moving("car-braking")
    forward = smoothed(p[:, 1], 0.2)
    assert forward.min() < -5.5
    assert 1.5 < longest_s(forward < -4.0) < 5.0


def test_tripod_stands_still_but_for_the_pats() -> None:
    _, p = moving("still")
    assert np.abs(p).max() < 1e-6


def test_falling_camera_weighs_nothing_and_comes_back() -> None:
    truth = ride("free-fall").truth
    weightless = np.linalg.norm(truth.specific_force_mps2, axis=1) < 1.0
    assert 0.35 < longest_s(weightless) < 0.6
    assert abs(truth.position_m[-1, 2] - truth.position_m[0, 2]) < 0.05
    assert truth.position_m[:, 2].min() > 0.3


def test_stairs_lead_up_a_riser_a_step() -> None:
    recorded = ride("stairs")
    heights = recorded.truth.position_m[:, 2]
    assert heights[-1] - heights[0] == pytest.approx(12 * 0.165, abs=0.05)


@pytest.mark.parametrize("name", RIDES)
def test_pats_are_felt_and_heard_at_the_same_time(name: str) -> None:
    recorded = ride(name)
    truth, audio = recorded.truth, recorded.audio.astype(np.float64)
    assert len(recorded.scene.pats) == 3
    for pat in recorded.scene.pats:
        since_s = truth.time_s - pat.time_s
        blow = np.abs(truth.acceleration_mps2[(since_s > 0.0) & (since_s < 0.04)]).max()
        before = truth.acceleration_mps2[(since_s > -0.1) & (since_s < -0.001)]
        assert 8.0 < blow < 40.0
        assert np.abs(before).max() < 0.35 * blow
        at = round(48_000 * pat.time_s)
        loud, quiet = audio[at : at + 480], audio[at - 2400 : at]
        assert np.abs(loud).max() > 0.3
        assert np.sqrt(np.mean(quiet**2)) < 0.1 * np.abs(loud).max()


@pytest.mark.parametrize("name", ["bike", "horse", "car-turning", "car-braking"])
def test_pats_lay_the_log_of_the_board_to_the_clip(name: str) -> None:
    """At 30 Hz, on the middle pat: within half a frame, and certain."""
    recorded = ride(name)
    assert recorded.board is not None
    found = synchronize(recorded.board.imu, recorded.audio, recorded.audio_rate_hz)
    assert found.is_confident
    truth, clock = recorded.board.clock_map, found.clock_map
    media_s = recorded.scene.pats[1].time_s
    log_s = (media_s - truth.offset_s) / truth.rate
    assert clock.rate * log_s + clock.offset_s == pytest.approx(media_s, abs=1.0 / 60.0)


def test_same_seed_gives_the_same_bits() -> None:
    first, again, other = (simulate("stairs", seed) for seed in (5, 5, 6))
    assert first.board is not None
    assert again.board is not None
    assert other.board is not None
    for name in ("time_s", "specific_force_mps2", "angular_rate_radps"):
        one, two = (getattr(r.board.imu, name) for r in (first, again))
        np.testing.assert_array_equal(one, two)
    np.testing.assert_array_equal(first.audio, again.audio)
    np.testing.assert_array_equal(
        first.truth.acceleration_mps2, again.truth.acceleration_mps2
    )
    pictures = (
        dataclasses.replace(one, width=160, height=90).frame(700)
        for one in (first, again)
    )
    np.testing.assert_array_equal(*pictures)
    assert first.board.clock_map != other.board.clock_map


def test_pictures_in_a_row_are_those_drawn_alone() -> None:
    small = dataclasses.replace(ride("car-turning"), width=160, height=90)
    drawn = dict(enumerate(small.film.frames(0, 25)))
    for at in (0, 24):
        np.testing.assert_array_equal(drawn[at][:, :, :3], small.frame(at))


@pytest.mark.parametrize("name", RIDES)
def test_every_part_of_a_picture_is_painted(name: str) -> None:
    small = dataclasses.replace(ride(name), width=320, height=180)
    maker, poses = small.film.studio()
    for at in (len(poses) // 2, len(poses) - 1):
        picture = maker.draw(poses[at])[:, :, :3]
        assert (picture.max(axis=2) == 0).mean() == 0.0


def test_steering_wheel_turns_with_the_road() -> None:
    recorded = ride("car-turning")
    maker, poses = dataclasses.replace(recorded, width=320, height=180).film.studio()
    around = poses[22 * 30]
    assert around.steering_rad > 0.1
    straight = maker.draw(around._replace(steering_rad=0.0)).astype(int)
    turned = maker.draw(around).astype(int)
    changed = np.abs(turned - straight)[:, :, :3].max(axis=2) > 20
    assert changed[:100].sum() == 0
    assert changed[110:].sum() > 150


def swaying() -> Trajectory:
    time_s = np.arange(-1.0, 41.0, 0.005)
    zeros = np.zeros((len(time_s), 3))
    position = zeros.copy()
    position[:, 1] = 0.3 * np.sin(2.0 * time_s)
    angles = zeros.copy()
    angles[:, 0] = 0.5 * np.sin(0.7 * time_s)
    return Trajectory(time_s, position, angles)


def along_mps2(t: Floats) -> Floats:
    """To and fro to the north, seen by a sensor that turns."""
    return -1.2 * np.sin(2.0 * t) * np.cos(0.5 * np.sin(0.7 * t))


def test_board_without_errors_writes_the_truth() -> None:
    log = record(swaying(), (0.0, 40.0), LoggerBoard(), np.random.default_rng(1))
    t = log.imu.time_s + log.clock_map.offset_s
    np.testing.assert_allclose(
        log.imu.specific_force_mps2[:, 1], along_mps2(t), atol=1e-6
    )
    field = np.array([21.0 * np.sin(0.5 * np.sin(0.7 * t)), np.full(len(t), -42.6)])
    # a reading in four is a new one: at most 15 ms old, at 0.35 rad/s
    np.testing.assert_allclose(
        log.imu.magnetic_field_ut[:, [0, 2]].T, field, atol=21.0 * 0.35 * 0.016
    )


def test_papers_board_keeps_a_clock_of_its_own() -> None:
    rng = np.random.default_rng(2)
    log = record(swaying(), (-0.5, 40.0), PAPER, rng)
    assert log.imu.sampling is Sampling.AVERAGED
    assert log.imu.rate_hz == pytest.approx(30.0, rel=0.02)
    assert 0.0 < abs(log.clock_map.rate - 1.0) < 2e-4
    milliseconds = 1e3 * log.imu.time_s
    np.testing.assert_allclose(milliseconds, np.round(milliseconds), atol=1e-6)
    media_s = log.clock_map.rate * log.imu.time_s + log.clock_map.offset_s
    assert -0.5 < media_s[0] < -0.4
    along = log.imu.specific_force_mps2[:, 1]
    model = np.stack([along_mps2(media_s), np.ones_like(media_s)], axis=1)
    (scale, _), residual = np.linalg.lstsq(model, along, rcond=None)[:2]
    # the scale error's SD is 1 %, the boxcar takes 0.02 %; noise of 0.075 / sqrt(6.7)
    assert scale == pytest.approx(1.0, rel=0.05)
    assert 0.015 < np.sqrt(residual[0] / len(along)) < 0.06


def test_readings_are_lost_while_the_card_is_busy() -> None:
    busy = dataclasses.replace(LoggerBoard(), stall_every_s=2.0, stall_s=(0.06, 0.08))
    sensor = dataclasses.replace(PAPER.sensor, averaged_to_hz=30.0)
    log = record(
        swaying(),
        (0.0, 40.0),
        dataclasses.replace(busy, sensor=sensor),
        np.random.default_rng(3),
    )
    assert len(log.stalls_s) > 8
    media_s = log.imu.time_s + log.clock_map.offset_s
    for begin_s, end_s in log.stalls_s:
        inside = (media_s > begin_s + 0.0025) & (media_s < end_s - 0.0025)
        assert not inside.any()
    assert np.diff(media_s).max() > 0.05


def test_log_and_gopro_clip_are_read_by_the_importers(tmp_path: Path) -> None:
    recorded = ride("car-turning")
    assert recorded.board is not None
    write_imu_csv(tmp_path / "imu.csv", recorded.board.imu)
    choices = parse_choices(["sampling=averaged"])
    log = read_recording(tmp_path / "imu.csv", choices).imu
    assert log.sampling is Sampling.AVERAGED
    np.testing.assert_allclose(
        log.specific_force_mps2, recorded.board.imu.specific_force_mps2, rtol=1e-8
    )
    grey = (np.full((36, 64, 3), 90, np.uint8) for _ in range(90))
    write_clip(tmp_path / "clip.mp4", grey, frame_rate_hz=2)
    write_gopro_clip(recorded, tmp_path / "clip.mp4", tmp_path / "gopro.mp4")
    camera = read_recording(tmp_path / "gopro.mp4")
    assert camera.camera == "HERO9 Black"
    assert camera.imu.rate_hz == pytest.approx(200.0, rel=1e-3)
    for axis in range(3):
        meant = np.interp(
            camera.imu.time_s,
            recorded.imu.time_s,
            recorded.imu.specific_force_mps2[:, axis],
        )
        # half a count of 1/417 m/s2; stamps and packets are exact to microseconds
        error = camera.imu.specific_force_mps2[:, axis] - meant
        assert np.median(np.abs(error)) < 0.002
        assert np.abs(error).max() < 0.05


def test_no_ride_takes_the_name_of_a_log_without_a_clip() -> None:
    assert not RIDES.keys() & MOTION_SCENES.keys()
