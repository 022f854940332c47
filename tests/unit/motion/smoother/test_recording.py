"""Whole recordings: blocks, cuts, reversal, rotation, memory and work."""

import dataclasses
import functools
import tracemalloc

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion import SmootherParameters, analyse, remove_gravity
from hapticplayer.motion.smoother import nodes, state, strapdown
from tests.unit.motion.smoother.conftest import WOBBLE, rms

RATE_HZ = 100.0
SECONDS = 200.0
# several blocks in the length of these recordings; real ones are of ten minutes
SHORT = SmootherParameters(block_s=40.0, margin_s=20.0)


@functools.cache
def wobbling() -> ImuLog:
    """Return 200 s of a shaken hand, with noise and bias, so that blocks differ."""
    clean = WOBBLE.instant(np.arange(1.0, SECONDS * RATE_HZ) / RATE_HZ)
    rng = np.random.default_rng(3)
    shape = (len(clean), 3)
    return dataclasses.replace(
        clean,
        specific_force_mps2=clean.specific_force_mps2 + 0.05 * rng.normal(size=shape),
        angular_rate_radps=clean.angular_rate_radps
        + 0.005 * rng.normal(size=shape)
        + [0.01, -0.02, 0.01],
    )


@functools.cache
def alone():
    return remove_gravity(wobbling())


def cut(log: ImuLog, start: int, stop: int) -> ImuLog:
    part = slice(start, stop)
    return ImuLog(
        log.time_s[part],
        log.specific_force_mps2[part],
        log.angular_rate_radps[part],
        sampling=log.sampling,
    )


def moved(one, other) -> float:
    return rms(one.acceleration_mps2 - other.acceleration_mps2)


# ---- blocks ---------------------------------------------------------------------


def test_blocks_agree_with_one_block():
    done = analyse(wobbling(), parameters=SHORT)
    assert done.summary["blocks"] == 5
    assert moved(done.track, alone()) < 0.02
    truth = WOBBLE.up(wobbling().time_s)
    error = rms(done.track.gravity_mps2 - 9.80665 * truth)
    assert error < 1.3 * rms(alone().gravity_mps2 - 9.80665 * truth) + 0.005


@pytest.mark.parametrize(
    ("name", "bound_mps2"),
    # broad_07 turns fast: a minute of it calibrates the gyro less well than three
    [("broad_07", 0.03), ("broad_10", 0.02), ("tumvi_room1", 0.02)],
)
def test_blocks_of_a_real_recording_agree_with_one_block(recording, name, bound_mps2):
    log = recording(name)
    parameters = SmootherParameters(block_s=60.0, margin_s=20.0)
    one, many = remove_gravity(log), remove_gravity(log, parameters=parameters)
    assert moved(one, many) < bound_mps2


def test_gravity_does_not_jump_where_blocks_meet():
    many = remove_gravity(wobbling(), parameters=SHORT)
    # what blocks add changes slowly: the difference to one block moves by no more
    # from sample to sample than blending a disagreement over seconds does
    difference = many.gravity_mps2 - alone().gravity_mps2
    step = np.linalg.norm(np.diff(difference, axis=0), axis=1)
    assert step.max() < 0.005


def test_the_heading_goes_on_where_blocks_meet():
    many = remove_gravity(wobbling(), parameters=SHORT)
    turns = Rotation.from_quat(many.quaternion_wxyz, scalar_first=True)
    turned = (turns[:-1].inv() * turns[1:]).as_rotvec() * RATE_HZ
    # bias and noise of the gyro are 0.025 and 0.01 rad/s; turning a block's heading
    # at one sample would be off by a hundred times its jump
    truth = wobbling().angular_rate_radps[1:]
    assert np.linalg.norm(turned - truth, axis=1).max() < 0.1


@pytest.mark.parametrize(("coarse", "fine"), [(2, 2), (2, 3), (9, 16), (9, 17)])
def test_nodes_half_as_far_apart_lie_on_straight_lines(coarse, fine, rng):
    known = rng.standard_normal((3, coarse))
    shared = np.append(2 * np.arange(coarse - 1), fine - 1)
    for got, row in zip(nodes.refined(known, fine), known, strict=True):
        straight = np.interp(np.arange(fine), shared, row)
        assert np.allclose(got, straight, rtol=0.0, atol=1e-15)


def test_each_quaternion_has_the_same_sign_as_the_one_before():
    q = remove_gravity(wobbling(), parameters=SHORT).quaternion_wxyz
    assert np.sum(q[1:] * q[:-1], axis=1).min() > 0.9


@pytest.mark.parametrize("block_s", [25.0, 40.0, 67.0])
def test_quaternion_and_vertical_agree_in_every_sample(block_s):
    parameters = SmootherParameters(block_s=block_s, margin_s=10.0)
    track = remove_gravity(wobbling(), parameters=parameters)
    turns = Rotation.from_quat(track.quaternion_wxyz, scalar_first=True)
    up = turns.inv().apply([0.0, 0.0, 9.80665])
    assert np.linalg.norm(up - track.gravity_mps2, axis=1).max() < 1e-3
    norm = np.linalg.norm(track.gravity_mps2, axis=1)
    assert np.abs(norm / 9.80665 - 1.0).max() < 1e-5
    assert np.abs(np.linalg.norm(track.quaternion_wxyz, axis=1) - 1.0).max() < 1e-9


def test_blocks_may_be_shorter_than_their_margins():
    parameters = SmootherParameters(block_s=5.0, margin_s=20.0)
    assert moved(remove_gravity(wobbling(), parameters=parameters), alone()) < 0.05


def test_a_rate_change_between_blocks_blends_found_samples():
    # a logger that speeds up for a while: the border is at 100 s
    rates_hz = {90.0: 100.0, 10.0: 1000.0, 100.0: 100.0}
    steps = [np.full(round(s * hz), 1.0 / hz) for s, hz in rates_hz.items()]
    time_s = np.cumsum(np.concatenate(steps))
    up = np.tile([0.0, 0.0, 9.80665], (len(time_s), 1))
    up += 0.3 * np.random.default_rng(1).standard_normal(up.shape)
    log = ImuLog(time_s, up, np.zeros_like(up))
    parameters = SmootherParameters(block_s=100.0, margin_s=10.0)
    track = remove_gravity(log, parameters=parameters)
    lean = np.linalg.norm(track.gravity_mps2 - [0.0, 0.0, 9.80665], axis=1)
    assert lean.max() < 0.2
    assert track.gravity_sigma_mps2.min() > 0.0
    assert track.gravity_sigma_mps2.max() < 1.0


# ---- cuts, reversal, rotation ---------------------------------------------------


@pytest.mark.parametrize("name", ["broad_07", "tumvi_room1"])
def test_two_halves_are_like_the_whole(recording, name):
    log = recording(name)
    whole, half = remove_gravity(log), len(log) // 2
    parts = [cut(log, 0, half), cut(log, half, len(log))]
    resumed = np.concatenate([remove_gravity(p).acceleration_mps2 for p in parts])
    assert rms(resumed - whole.acceleration_mps2) < 0.03


def test_a_cut_is_forgotten_after_the_time_constant():
    log = wobbling()
    start = int(80.0 * RATE_HZ)
    rest = remove_gravity(cut(log, start, len(log)))
    difference = rest.acceleration_mps2 - alone().acceleration_mps2[start:]
    settled = int(40.0 * RATE_HZ)
    assert rms(difference) < 0.02
    assert rms(difference[settled:]) < 0.01


@pytest.mark.parametrize(
    "name", ["broad_07", "tumvi_room1", "tyrex_Guillaume_Nexus5_NoDist_Swinging"]
)
def test_half_the_samples_give_the_same_motion(recording, name):
    log = recording(name)
    count = len(log) // 2 * 2
    step = np.diff(log.time_s, prepend=2 * log.time_s[0] - log.time_s[1])[:count]
    turn = step[:, None] * log.angular_rate_radps[:count]
    # the gyro's samples are means: two of them make one of twice the length
    rate = (turn[::2] + turn[1::2]) / (step[::2] + step[1::2])[:, None]
    kept = slice(1, count, 2)
    halved = ImuLog(log.time_s[kept], log.specific_force_mps2[kept], rate)
    got, whole = remove_gravity(halved), remove_gravity(log)
    assert rms(got.acceleration_mps2 - whole.acceleration_mps2[kept]) < 0.03


def reversed_in_time(log: ImuLog) -> ImuLog:
    """Return what the same sensor would have seen of the motion run backwards."""
    rate = -log.angular_rate_radps[::-1]
    if log.sampling is Sampling.INSTANT:
        # the rate of the interval before a sample is that of the one after it now
        rate = np.concatenate([rate[:1], rate[:-1]])
    return ImuLog(
        log.time_s[-1] - log.time_s[::-1],
        log.specific_force_mps2[::-1],
        rate,
        sampling=log.sampling,
    )


@pytest.mark.parametrize("sampling", list(Sampling))
def test_a_recording_run_backwards_gives_the_same_motion(sampling):
    log = wobbling()
    if sampling is Sampling.AVERAGED:
        log = WOBBLE.averaged(int(SECONDS * RATE_HZ), 1.0 / RATE_HZ)
    there = remove_gravity(log)
    back = remove_gravity(reversed_in_time(log))
    difference = back.acceleration_mps2[::-1] - there.acceleration_mps2
    # nodes and windows begin at the other end, so nothing but the answer is the same
    assert rms(difference) < 0.01


@pytest.mark.parametrize("name", ["broad_10", "tumvi_room1"])
def test_a_real_recording_run_backwards_gives_the_same_motion(recording, name):
    log = recording(name)
    back = remove_gravity(reversed_in_time(log)).acceleration_mps2[::-1]
    assert rms(back - remove_gravity(log).acceleration_mps2) < 0.01


@pytest.mark.parametrize("sampling", list(Sampling))
def test_a_sensor_mounted_another_way_sees_the_same_motion(sampling):
    log = dataclasses.replace(wobbling(), sampling=sampling)
    mounting = Rotation.from_rotvec([1.0, -2.0, 0.5])
    turned = dataclasses.replace(
        log,
        specific_force_mps2=mounting.apply(log.specific_force_mps2.copy()),
        angular_rate_radps=mounting.apply(log.angular_rate_radps.copy()),
    )
    for parameters in (None, SHORT):
        plain = remove_gravity(log, parameters=parameters)
        got = remove_gravity(turned, parameters=parameters)
        for name in ("acceleration_mps2", "gravity_mps2"):
            expected = mounting.apply(getattr(plain, name).copy())
            assert np.abs(getattr(got, name) - expected).max() < 1e-6
        sigma = got.gravity_sigma_mps2 / plain.gravity_sigma_mps2
        assert np.abs(sigma - 1.0).max() < 1e-6


def test_when_a_recording_was_made_does_not_matter():
    log = wobbling()
    later = dataclasses.replace(log, time_s=log.time_s + 1.7e9)
    # epoch times in float64 are rounded to 0.24 us, which 5 rad/s turn into 1e-6 rad
    assert moved(remove_gravity(later), alone()) < 1e-3


# ---- what it costs --------------------------------------------------------------


def long_log(count: int) -> ImuLog:
    """Return a walk through the wobbling recording, over and over."""
    log = wobbling()
    rows = np.arange(count) % len(log)
    return ImuLog(
        np.arange(count) / RATE_HZ,
        log.specific_force_mps2[rows],
        log.angular_rate_radps[rows],
    )


def peak_bytes(log: ImuLog) -> int:
    tracemalloc.start()
    try:
        track = remove_gravity(log)
        peak = tracemalloc.get_traced_memory()[1]
        assert len(track) == len(log)
        return peak
    finally:
        tracemalloc.stop()


def test_memory_stays_below_400_bytes_a_sample():
    counts = 100_000, 300_000
    remove_gravity(long_log(1000))  # imports are not memory of a sample
    peaks = [peak_bytes(long_log(count)) for count in counts]
    for count, peak in zip(counts, peaks, strict=True):
        assert peak / count < 400.0
    assert (peaks[1] - peaks[0]) / (counts[1] - counts[0]) < 400.0


@pytest.mark.parametrize(("packet", "hole_s"), [(8, 0.073), (6, 0.3)])
def test_a_logger_that_stamps_packets_takes_no_more_memory(packet, hole_s, rng):
    # stamped as they arrive: a millisecond apart, then a wait for the next packet
    count = 12_000
    steps = np.tile(np.append(np.full(packet - 1, 0.001), hole_s), count // packet)
    force = np.array([0.0, 0.0, 9.8]) + 0.1 * rng.standard_normal((count, 3))
    log = ImuLog(np.cumsum(steps), force, 0.1 * rng.standard_normal((count, 3)))
    remove_gravity(log)
    # a short recording has some that do not grow with it
    assert peak_bytes(log) / count < 500.0


def test_work_grows_with_the_length_and_no_faster(monkeypatch):
    touched = {"samples": 0, "nodes": 0}
    opened, minimise = strapdown.integrate, state.minimise

    def counting_opened(samples, *more, **named):
        touched["samples"] += len(samples)
        return opened(samples, *more, **named)

    def counting_minimise(problem):
        touched["nodes"] += len(problem.duration_s)
        return minimise(problem)

    monkeypatch.setattr(strapdown, "integrate", counting_opened)
    monkeypatch.setattr(state, "minimise", counting_minimise)
    shares = []
    for seconds in (1000, 3000):
        touched.update(samples=0, nodes=0)
        count = int(seconds * RATE_HZ)
        remove_gravity(long_log(count))
        shares.append((touched["samples"] / count, touched["nodes"] / seconds))
    (samples, nodes), (of_more, nodes_of_more) = shares
    # blocks of ten minutes overlap by 80 s; how often each is solved depends on it
    assert of_more < 1.3 * samples
    assert nodes_of_more < 1.3 * nodes
    assert samples < 4.0
    assert nodes < 20.0
