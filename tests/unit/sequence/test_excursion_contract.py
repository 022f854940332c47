"""The predicted hand gets the force and the trips of the haptic loop, step by step."""

import math
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.devices.dynamics import RELAXED
from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.contract import Cause, Mode, Situation, State, Supervision
from hapticplayer.haptics.hand import HandState, observe
from hapticplayer.haptics.limiter import ZERO, Limits
from hapticplayer.haptics.step import step
from hapticplayer.model import ForceTrack, PlaybackClock
from hapticplayer.model.device import DeviceReading
from hapticplayer.sequence.excursion import RATE_HZ, Grip
from tests.rigs import loaded

STEP_S, STEPS, START_S = 1.0 / RATE_HZ, 250, 100.0
CLOCK = PlaybackClock(1, START_S, 0.0, 1.0, math.inf)
HANDS = [replace(RELAXED, mass_kg=0.02, stiffness_n_per_m=k) for k in (10, 60, 500)]


class Loop:
    """The loop of one hand: it follows a track, and again after each trip."""

    def __init__(self, track, limits, centring):
        self.track, self.limits, self.centring = track, limits, centring
        self.hand, self.place_m = HandState(), np.zeros(3)
        self.state = self.following(ZERO, START_S - STEP_S)

    def following(self, planned_n, now_s):
        """Return a state in which nothing is left of an entry."""
        return State(
            Mode.FOLLOWING, planned_n=planned_n, epoch=1, now_s=now_s, track=self.track
        )

    def tick(self, number, place_m):
        """Return the state with the hand at a place; the next tick follows the track."""
        now_s, before_m, self.place_m = START_S + number * STEP_S, self.place_m, place_m
        for at_m, at_s in (
            ((before_m + place_m) / 2, now_s - STEP_S / 2),
            (place_m, now_s),
        ):  # the loop reads twice a step
            reading = DeviceReading(tuple(at_m), 0, is_homed=True, replied_s=at_s)
            self.hand = observe(self.hand, reading, self.limits)
        speed_mps = tuple((place_m - before_m) / STEP_S)
        hand = self.hand._replace(velocity_mps=speed_mps)  # without the smoothing
        people = Supervision(math.inf)
        state = step(
            Situation(now_s, CLOCK, self.track, self.state, hand, people, self.limits,
                      self.centring)
        )  # fmt: skip
        planned_n = self.track.force_at(number * STEP_S)
        self.state = self.following(planned_n, now_s)
        return state


def settings(rng):
    """Return limits and centring; a third of the numbers lie at an end of their range."""

    def between(low, high):
        share = min(1.0, max(0.0, rng.uniform(-0.25, 1.25)))
        return low + (high - low) * share

    reach_m, cap_n = between(0.015, 0.04), between(1.0, 4.5)
    fade_from, centring_from_m = between(0.0, 0.9), between(0.0, reach_m)
    limits = Limits(
        force_cap_n=cap_n,
        continuous_n=cap_n,  # the motors stay cold
        content_slew_n=math.inf,
        workspace_m=reach_m,
        fade_from=fade_from,
        fade_to=fade_from + between(0.001, 0.5),
        outside=between(0.3, 0.9),
        speed_mps=between(0.1, 1.0),
    )
    full_m = centring_from_m + between(1e-5, reach_m)
    ahead_s = between(0.0, 0.02)
    return limits, Centring(between(0.0, 3.0), centring_from_m, full_m, ahead_s)


def some_track(rng):
    time_s = np.arange(0.0, 2.0, 0.05)
    force_n = rng.uniform(0.5, 5.0) * rng.normal(size=(len(time_s), 3))
    force_n[rng.random(len(time_s)) < 0.2] = 0.0
    return loaded(ForceTrack(time_s, force_n))


def what_acts(state, cap_n):
    """Return what of the contract changed the planned force."""
    force_n, pull_n = np.array(state.force_n), np.array(state.centring_n)
    if state.cause:
        yield state.cause
    elif np.linalg.norm(force_n) > cap_n - 1e-9:
        yield "cap"
    elif not np.allclose(state.planned_n + pull_n, force_n):
        yield "fade"
    if pull_n.any():
        yield "centring"


def test_force_and_trips_are_those_of_the_loop():
    seen = Counter()
    for seed in range(10):
        rng = np.random.default_rng(seed)
        (limits, centring), tracks = settings(rng), [some_track(rng) for _ in range(2)]
        grip = Grip(HANDS, limits, centring)
        grip.rest(len(tracks))
        cells = list(np.ndindex(len(HANDS), len(tracks)))
        loops = [Loop(tracks[cell[1]], limits, centring) for cell in cells]
        for number in range(STEPS):
            place_m, is_fast = grip.place_m.copy(), grip.is_fast
            causes = np.where(grip.is_outside, Cause.OUTSIDE, Cause.NONE)
            causes[is_fast] = Cause.RUNAWAY
            grip.advance(np.transpose([t.force_at(number * STEP_S) for t in tracks]))
            for loop, cell in zip(loops, cells, strict=True):
                state = loop.tick(number, place_m[:, *cell])
                seen.update(what_acts(state, limits.force_cap_n))
                assert state.cause == causes[cell], (seed, number, cell)
                if not state.cause:
                    sent_n = pytest.approx(grip.sent_n[:, *cell], abs=1e-9)
                    assert state.force_n == sent_n, (seed, number, cell)
    required = ("fade", "centring", "cap", Cause.RUNAWAY, Cause.OUTSIDE)
    assert min(seen[name] for name in required) > 100, seen
