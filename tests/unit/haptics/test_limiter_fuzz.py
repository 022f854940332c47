"""A million hostile inputs to the last stage, and hostile worlds around one tick."""

import math

import pytest

from hapticplayer.haptics.contract import (
    Cause,
    Mode,
    Request,
    Situation,
    State,
    Supervision,
)
from hapticplayer.haptics.hand import observe
from hapticplayer.haptics.limiter import (
    ZERO,
    Limits,
    cap_when_warm,
    faded,
    limit,
    warmed,
)
from hapticplayer.haptics.step import step
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import DeviceReading

LIMITS = Limits(continuous_n=3.0)
EPS = 1e-9  # rounding of a few double operations on values below 10
SPECIALS = [
    0.0, -0.0, 1.0, -1.0, 4.5, -4.5, 1e308, -1e308, 1.7e308, 5e-324, -5e-324,
    2e-308, math.inf, -math.inf, math.nan,
]  # fmt: skip
LIMITER_INPUTS = 1_000_000


def hostile(rng, count, scale=300):
    """Vectors of specials, of wild magnitudes, and of flipping signs."""
    wild = rng.standard_normal((count, 3)) * 10.0 ** rng.uniform(
        -320, scale, (count, 1)
    )
    wild[rng.random(count) < 0.3] *= -1.0
    picks = rng.integers(0, len(SPECIALS), (count, 3))
    special = rng.random((count, 3)) < 0.4
    for row, (values, chosen, pick) in enumerate(
        zip(wild.tolist(), special.tolist(), picks.tolist(), strict=True)
    ):
        yield tuple(
            SPECIALS[p] if is_special or row % 3 == 0 else value
            for value, is_special, p in zip(values, chosen, pick, strict=True)
        )


def test_a_million_hostile_inputs_leave_finite_capped_and_slow(rng):
    previous, heat = ZERO, 0.0
    places = hostile(rng, LIMITER_INPUTS // 100, scale=0)
    place = ZERO
    for number, target in enumerate(hostile(rng, LIMITER_INPUTS)):
        if number % 100 == 0:
            place = next(places)
        kept = faded(target, place, LIMITS)
        cap = cap_when_warm(heat, LIMITS)
        sent = limit(kept, previous, LIMITS.content_slew_n, cap)
        x, y, z = sent
        size = math.hypot(x, y, z)
        assert size <= LIMITS.force_cap_n + EPS  # false for nan too
        assert math.dist(sent, previous) <= LIMITS.content_slew_n + EPS
        heat = warmed(heat, sent, 0.001, LIMITS)
        previous = sent
    assert 0.0 <= heat <= LIMITS.force_cap_n**2


class WildTrack:
    """A track that says anything."""

    end_s = math.inf

    def __init__(self, forces):
        self._forces = forces

    def force_at(self, media_s):
        return next(self._forces)

    def is_silent(self, now_s):
        return False


@pytest.mark.parametrize("kind", ["forces", "positions", "clocks", "all"])
def test_whatever_comes_a_tick_sends_nothing_that_is_forbidden(rng, kind):
    count = 10_000
    forces, places = hostile(rng, count + 1), hostile(rng, count + 1, scale=-1)
    clocks = hostile(rng, count + 1)
    choices = rng.random(count)
    track, state, now_s, replied_s = WildTrack(forces), State(), 1000.0, 1000.0
    for number in range(count):
        now_s += 0.001
        wild = choices[number] < 0.3
        place = next(places) if wild and kind in ("positions", "all") else ZERO
        clock = PlaybackClock(1, 1000.0, 0.0, 1.0, math.inf)
        if wild and kind in ("clocks", "all"):
            clock = PlaybackClock(number, *next(clocks), math.inf)
        replied_s = now_s if choices[number] > 0.01 else replied_s
        reading = DeviceReading(place, 0, is_homed=True, replied_s=replied_s)
        request = Request.REARM if number % 50 == 0 else Request.NONE
        supervision = Supervision(now_s, request=request)
        before, hand = state, observe(state.hand, reading, LIMITS)
        state = step(Situation(now_s, clock, track, state, hand, supervision, LIMITS))
        size = math.hypot(*state.force_n)
        assert size <= LIMITS.force_cap_n + EPS
        if state.mode is not Mode.TRIPPED:
            change = math.dist(state.force_n, before.force_n)
            assert change <= LIMITS.content_slew_n + EPS
        else:
            assert state.force_n == ZERO


def test_a_leap_of_the_encoder_is_dropped_and_gives_no_speed():
    hand = observe(State().hand, DeviceReading(ZERO, 0, True, 1.000), LIMITS)
    leap = observe(hand, DeviceReading((0.03, 0.0, 0.0), 0, True, 1.001), LIMITS)
    assert (leap.position_m, leap.malformed, leap.fast_samples) == (ZERO, 1, 0)
    after = observe(leap, DeviceReading((1e-4, 0.0, 0.0), 0, True, 1.002), LIMITS)
    assert after.position_m == (1e-4, 0.0, 0.0)
    assert (after.malformed, after.fast_samples) == (0, 0)


def test_the_first_not_finite_position_trips_for_good():
    reading = DeviceReading((math.nan, 0.0, 0.0), 0, True, 1.0)
    hand, supervision = observe(State().hand, reading, LIMITS), Supervision(1.0)
    state = step(Situation(1.0, None, None, State(), hand, supervision, LIMITS))
    assert (state.mode, state.cause) == (Mode.TRIPPED, Cause.NOT_FINITE)
