"""The state machine on a virtual clock, tick by tick."""

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
    PERIOD_S,
    ZERO,
    Limits,
    cap_when_warm,
    faded,
    limit,
    warmed,
)
from hapticplayer.haptics.step import step
from hapticplayer.model import ForceTrack, PlaybackClock
from hapticplayer.model.device import DeviceReading
from tests.rigs import loaded

LIMITS = Limits()
START_S = 1000.0


class World:
    """A player that does everything right until a test changes something."""

    def __init__(self, force=(0.0, 4.0, 0.0)):
        self.now_s = START_S
        self.state = State()
        self.track = loaded(ForceTrack([0.0, 100.0], [force, force]))
        self.clock = PlaybackClock(1, START_S, 1.0, 1.0, math.inf)
        self.heartbeat_s = math.inf
        self.is_player_alive = True
        self.request = Request.NONE
        self.position_m = ZERO
        self.missed_share = 0.0
        self.sent = []

    def tick(self, count=1):
        for _ in range(count):
            self.now_s += PERIOD_S
            heartbeat_s = min(self.heartbeat_s, self.now_s)
            reading = DeviceReading(
                self.position_m, 0, is_homed=True, replied_s=self.now_s
            )
            self.state = step(
                Situation(
                    self.now_s,
                    self.clock,
                    self.track,
                    self.state,
                    observe(self.state.hand, reading, LIMITS),
                    Supervision(
                        heartbeat_s,
                        self.is_player_alive,
                        self.request,
                        missed_share=self.missed_share,
                    ),
                    LIMITS,
                )
            )
            self.request = Request.NONE
            self.sent.append(self.state.force_n)
        return self.state

    def following(self):
        self.tick(400)
        assert self.state.mode is Mode.FOLLOWING
        assert math.hypot(*self.state.force_n) == pytest.approx(4.0)
        self.sent.clear()
        return self


def slews(sent):
    return [math.dist(a, b) for a, b in zip(sent[1:], sent, strict=False)]


def test_the_force_fades_in_and_then_follows():
    world = World()
    world.tick(400)
    assert max(slews([ZERO, *world.sent])) <= LIMITS.entry_slew_n + 1e-9
    ticks_to_full = next(i for i, f in enumerate(world.sent) if f[1] > 3.999)
    assert ticks_to_full >= LIMITS.entry_ticks - 1
    assert world.state.mode is Mode.FOLLOWING


@pytest.mark.parametrize("phase", range(0, 1000, 50))
def test_pause_ramps_to_zero_within_20_ticks(phase):
    world = World().following()
    world.tick(phase)
    world.clock = PlaybackClock(2, world.now_s, 2.0, 0.0, math.inf)
    world.sent.clear()
    world.tick(20)
    assert world.sent[-1] == ZERO
    assert world.state.mode in (Mode.RAMPING, Mode.IDLE)
    assert world.state.cause is Cause.PAUSED
    assert max(slews(world.sent)) <= LIMITS.stop_slew_n + 1e-9


def test_seek_ramps_and_comes_back_by_itself():
    world = World().following()
    world.clock = PlaybackClock(2, world.now_s, 50.0, 1.0, math.inf)
    world.tick(20)
    assert ZERO in world.sent
    world.tick(400)
    assert world.state.mode is Mode.FOLLOWING
    assert max(slews(world.sent)) <= LIMITS.stop_slew_n + 1e-9


def test_a_clock_that_is_not_refreshed_ramps():
    world = World().following()
    world.clock = PlaybackClock(1, START_S, 1.0, 1.0, world.now_s + 0.0105)
    world.tick(10)
    assert world.state.mode is Mode.FOLLOWING
    world.tick(20)
    assert (world.sent[-1], world.state.cause) == (ZERO, Cause.CLOCK_STALE)


def test_a_silent_heart_ramps_at_150_ms_and_trips_at_1_s():
    world = World().following()
    world.heartbeat_s = world.now_s
    world.tick(150)
    assert world.state.mode is Mode.FOLLOWING
    world.tick(20)
    assert (world.sent[-1], world.state.cause) == (ZERO, Cause.HEARTBEAT_LATE)
    world.tick(1000 - 170)
    assert world.state.mode is Mode.IDLE
    world.tick(1)
    assert (world.state.mode, world.state.cause) == (Mode.TRIPPED, Cause.HEARTBEAT_LOST)
    world.heartbeat_s = math.inf
    world.tick(100)
    assert world.state.mode is Mode.TRIPPED


@pytest.mark.parametrize("phase", range(20))
@pytest.mark.parametrize(
    ("change", "cause"),
    [
        ({"is_player_alive": False}, Cause.PLAYER_GONE),
        ({"request": Request.STOP}, Cause.STOPPED),
        ({"heartbeat_s": 0.0}, Cause.HEARTBEAT_LOST),
    ],
)
def test_a_trip_is_zero_at_the_next_tick_and_latched(phase, change, cause):
    world = World()
    world.tick(350 + phase)
    vars(world).update(change)
    world.tick()
    assert world.sent[-1] == ZERO
    assert (world.state.mode, world.state.cause) == (Mode.TRIPPED, cause)
    world.is_player_alive, world.heartbeat_s = True, math.inf
    world.tick(500)
    assert world.sent[-1] == ZERO
    assert world.state.cause is cause


def test_only_a_person_rearms_and_the_force_fades_in_again():
    world = World().following()
    world.request = Request.STOP
    world.tick()
    world.request = Request.REARM
    world.tick()
    assert world.state.mode is Mode.IDLE
    world.sent.clear()
    world.tick(400)
    assert world.state.mode is Mode.FOLLOWING
    assert max(slews(world.sent)) <= LIMITS.entry_slew_n + 1e-9


def test_rearming_while_the_player_is_gone_does_nothing():
    world = World().following()
    world.is_player_alive = False
    world.tick()
    world.request = Request.REARM
    world.tick()
    assert world.state.mode is Mode.TRIPPED


def test_without_a_track_or_a_clock_there_is_no_force():
    world = World()
    world.track = None
    assert world.tick(50).force_n == ZERO
    world.track, world.clock = World().track, None
    assert world.tick(50).force_n == ZERO
    assert world.state.cause is Cause.NO_TRACK


def test_a_start_that_lies_ahead_is_waited_for():
    world = World()
    world.clock = PlaybackClock(1, START_S + 0.1005, 1.0, 1.0, math.inf)
    world.tick(100)
    assert world.state.mode is Mode.IDLE
    assert world.tick().mode is Mode.ENTERING


def test_a_fast_track_is_followed_exactly_once_the_entry_is_over():
    world = World()
    times = [i / 100.0 for i in range(1000)]
    force = [(math.sin(0.9 * i), 0.0, math.cos(0.9 * i)) for i in range(1000)]
    world.track = loaded(ForceTrack(times, force))
    world.tick(2000)
    assert world.state.mode is Mode.FOLLOWING
    for _ in range(500):
        state = world.tick()
        assert state.force_n == pytest.approx(state.planned_n)


def test_a_force_that_jumps_is_capped_in_slew_and_size():
    world = World()
    times = [0.0, 1.5, 1.5001]
    world.track = loaded(ForceTrack(times, [[0, 0, 0], [0, 0, 0], [90, 0, 0]]))
    world.track = loaded(
        ForceTrack(
            [0.0, 1.5, 1.5001, 9.0], [[0, 0, 0], [0, 0, 0], [90, 0, 0], [90, 0, 0]]
        )
    )
    world.tick(700)
    assert max(slews(world.sent)) <= LIMITS.content_slew_n + 1e-9
    assert world.sent[-1] == pytest.approx((4.5, 0.0, 0.0))


def test_after_a_long_rest_the_force_still_fades_in():
    world = World()
    world.clock = PlaybackClock(1, START_S, 1.0, 0.0, math.inf)
    world.tick(5000)
    world.clock = PlaybackClock(2, world.now_s, 1.0, 1.0, math.inf)
    world.sent.clear()
    world.tick(199)
    assert world.state.mode is Mode.ENTERING
    assert max(slews([ZERO, *world.sent])) <= LIMITS.entry_slew_n + 1e-9


def test_where_the_track_ends_before_the_clip_the_force_ramps():
    world = World()
    world.track = loaded(ForceTrack([0.0, 2.0], [[0, 4.0, 0], [0, 4.0, 0]]))
    world.tick(1000 - 5)
    assert world.state.mode is Mode.FOLLOWING
    world.sent.clear()
    world.tick(30)
    assert (world.sent[-1], world.state.cause) == (ZERO, Cause.TRACK_ENDED)
    assert max(slews(world.sent)) <= LIMITS.stop_slew_n + 1e-9


def test_closing_ramps_and_is_no_trip():
    world = World().following()
    for _ in range(20):
        world.request = Request.CLOSE
        world.tick()
    assert world.sent[-1] == ZERO
    assert (world.state.mode, world.state.cause) == (Mode.IDLE, Cause.CLOSING)
    assert max(slews(world.sent)) <= LIMITS.stop_slew_n + 1e-9


def test_over_1_percent_of_missed_periods_caps_at_3_newtons():
    world = World().following()
    world.missed_share = 0.0101
    world.tick(50)
    assert math.hypot(*world.sent[-1]) == pytest.approx(3.0)
    world.missed_share = 0.0099
    world.tick(50)
    assert math.hypot(*world.sent[-1]) == pytest.approx(4.0)
    assert max(slews(world.sent)) <= LIMITS.content_slew_n + 1e-9


def test_an_hour_of_5_newtons_stays_at_the_continuous_force():
    limits = Limits(continuous_n=3.0)
    heat, hottest, force = 0.0, 0.0, ZERO
    for _ in range(360_000):  # ticks of 10 ms: the model is one of seconds
        cap = cap_when_warm(heat, limits)
        force = limit((5.0, 0.0, 0.0), force, limits.content_slew_n, cap)
        heat = warmed(heat, force, 0.01, limits)
        hottest = max(hottest, heat)
    assert math.sqrt(hottest) <= 3.0
    assert force[0] == pytest.approx(3.0, abs=1e-3)


def test_the_mean_force_follows_its_time_constant():
    limits, heat = Limits(), 0.0
    for _ in range(10_000):
        heat = warmed(heat, (0.0, 2.0, 0.0), PERIOD_S, limits)
    assert heat == pytest.approx(4.0 * (1.0 - math.exp(-1.0)), rel=1e-3)


def test_short_strong_forces_are_not_weakened_by_the_motor_model():
    assert cap_when_warm(0.0, Limits(continuous_n=3.0)) == 4.5


def test_outward_force_fades_and_the_rest_stays():
    limits = Limits()
    half_way = 0.75 * limits.workspace_m
    assert faded((2.0, 1.0, 0.0), (half_way, 0.0, 0.0), limits) == pytest.approx(
        (1.0, 1.0, 0.0)
    )
    assert faded((-2.0, 1.0, 0.0), (half_way, 0.0, 0.0), limits) == (-2.0, 1.0, 0.0)
    assert faded((2.0, 1.0, 0.0), (0.037, 0.0, 0.0), limits) == pytest.approx(
        (0.0, 1.0, 0.0)
    )
    assert faded((2.0, 1.0, 0.0), (0.02, 0.0, 0.0), limits) == (2.0, 1.0, 0.0)


def test_a_slow_window_while_nothing_plays_is_no_fault():
    world = World()
    world.clock = PlaybackClock(1, START_S, 0.0, 0.0, math.inf)
    world.heartbeat_s = START_S
    world.tick(3000)
    assert world.state.mode is Mode.IDLE
    world.heartbeat_s = math.inf
    world.clock = PlaybackClock(2, world.now_s, 0.0, 1.0, math.inf)
    world.tick(400)
    assert world.state.mode is Mode.FOLLOWING
