"""Sway and bounce that frames suggest."""

import numpy as np
import pytest
from scipy import signal

from hapticplayer.errors import Cancelled, InputError
from hapticplayer.extras.frames.estimate import (
    HEIGHT_M,
    RATE_HZ,
    TOP_HZ,
    Suggestion,
    suggest_motion,
)
from tests.unit.extras.frames.conftest import film
from tests.unit.extras.frames.made_up import SPEED, stepping, steps, suggested, turning


def around(found: Suggestion, begin_s: float, end_s: float) -> np.ndarray:
    time_s = found.motion.time_s
    inside = (time_s > begin_s) & (time_s < end_s)
    return found.motion.acceleration_mps2[inside]


def test_a_bend_to_the_left_sways_to_the_left() -> None:
    found = suggested(steps(turn_radps=turning))

    middle = around(found, 9.5, 10.5)
    expected = -HEIGHT_M * SPEED * 0.4
    assert middle[:, 0] == pytest.approx(expected, rel=0.1)
    assert np.abs(around(found, 0.5, 4.0)).max() < 0.02
    assert not found.motion.acceleration_mps2[:, 1].any()


def test_steps_bounce_with_their_rate_and_height() -> None:
    found = suggested(steps(sinking=stepping))

    time_s = found.motion.time_s
    omega = 2.0 * np.pi * 2.0
    expected = -HEIGHT_M * 0.1 * omega * np.cos(omega * time_s)
    inside = (time_s > 3.0) & (time_s < 17.0)
    bounce = found.motion.acceleration_mps2[inside, 2]
    assert bounce == pytest.approx(expected[inside], abs=0.12 * HEIGHT_M * 0.1 * omega)


def test_the_gain_is_a_factor_on_both_parts() -> None:
    made = steps(turn_radps=turning, sinking=stepping)
    once, thrice = suggested(made), suggested(made, gain=3.0)

    assert thrice.motion.acceleration_mps2 == pytest.approx(
        3.0 * once.motion.acceleration_mps2
    )
    assert thrice.sigma_mps2 == pytest.approx(3.0 * once.sigma_mps2)


def test_suggested_motion_ends_at_5_hz() -> None:
    rng = np.random.default_rng(5)
    noise = iter(rng.standard_normal(10_000))
    made = steps(
        turn_radps=lambda _t: 0.3 + next(noise), sinking=lambda _t: 0.3 * next(noise)
    )

    found = suggested(made).motion.acceleration_mps2

    assert np.abs(found[:, [0, 2]]).max(axis=0).min() > 0.1
    hz, power = signal.welch(found[:, [0, 2]], RATE_HZ, nperseg=512, axis=0)
    above = power[hz > 1.1 * TOP_HZ].sum(axis=0) / power.sum(axis=0)
    assert above.max() < 1e-5


def test_halves_that_disagree_give_no_bounce_and_a_reason() -> None:
    found = suggested(steps(turn_radps=turning, sinking=stepping, apart=0.3))

    assert not found.motion.acceleration_mps2[:, 2].any()
    assert np.abs(found.motion.acceleration_mps2[:, 0]).max() > 0.5
    (note,) = found.notes
    assert str(note).startswith("no estimated bounce: two halves of the points")


def test_a_bounce_that_no_gait_has_is_left_out() -> None:
    found = suggested(steps(sinking=lambda t: 20.0 * stepping(t)))

    assert not found.motion.acceleration_mps2.any()


def test_around_what_is_not_seen_it_fades_to_zero() -> None:
    found = suggested(steps(turn_radps=turning, sinking=stepping, unseen_s=(9.0, 11.0)))

    assert np.abs(around(found, 9.2, 10.8)).max() < 0.01
    assert np.abs(around(found, 7.5, 8.0)[:, 2]).max() > 0.5
    step = np.abs(np.diff(found.motion.acceleration_mps2, axis=0)).max()
    assert step < 0.3  # of peaks of 1.9 m/s^2
    assert "s without estimate" in str(found.notes[0])


def test_a_camera_that_does_not_move_gives_nothing_and_says_so() -> None:
    found = suggested(steps(), speed=0.0)

    assert not found.motion.acceleration_mps2.any()
    assert "does not move" in str(found.notes[0])


def test_sigma_grows_with_what_the_halves_differ_by() -> None:
    near = suggested(steps(sinking=stepping, apart=0.001))
    far = suggested(steps(sinking=stepping, apart=0.02))

    assert np.median(far.sigma_mps2[:, 1]) > np.median(near.sigma_mps2[:, 1])
    assert far.trust[:, 1].mean() < near.trust[:, 1].mean()


def test_too_few_frames_per_second_are_refused() -> None:
    with pytest.raises(InputError, match="10 frames per second, too few"):
        suggested(steps(every_s=0.1))


def correlation(
    found: Suggestion, scene: str, begin_s: float, axis: int, sos: np.ndarray
) -> float:
    """Return that of a film's suggestion with its exact motion, both filtered."""
    time_s = found.motion.time_s
    truth = film(scene).scene.trajectory.at(begin_s + time_s).acceleration_mps2
    pair = np.stack([found.motion.acceleration_mps2[:, axis], truth[:, axis]])
    inside = slice(round(RATE_HZ), -round(RATE_HZ))
    return float(np.corrcoef(signal.sosfiltfilt(sos, pair, axis=1)[:, inside])[0, 1])


def test_bounce_of_a_simulated_horse_is_its_true_one(ride_film) -> None:
    shares: list[float] = []
    found = suggest_motion(
        ride_film("horse", 10.0, 12.0), progress=lambda share, _: shares.append(share)
    )

    gait = signal.butter(2, (0.5, 3.0), "band", fs=RATE_HZ, output="sos")
    assert correlation(found, "horse", 10.0, 2, gait) > 0.8
    assert shares[-1] > 0.95


def test_sway_of_a_simulated_bicycle_is_its_true_one(ride_film) -> None:
    found = suggest_motion(ride_film("bike", 14.5, 6.5))

    turns = signal.butter(2, 0.5, fs=RATE_HZ, output="sos")
    assert correlation(found, "bike", 14.5, 0, turns) > 0.9


def test_a_suggestion_can_be_cancelled(ride_film) -> None:
    def cancel(share: float, _step: str) -> None:
        if share > 0.1:
            raise Cancelled

    with pytest.raises(Cancelled):
        suggest_motion(ride_film("bike", 10.0, 6.0), progress=cancel)
