"""The short way round the table of the contract: it never says more than the table."""

import math
import random

import pytest

from hapticplayer.haptics.contract import (
    FAST_SAMPLES_TRIP,
    GAP_RAMP_S,
    GAP_TRIP_S,
    GUARD_RAMP_S,
    HEARTBEAT_RAMP_S,
    HEARTBEAT_TRIP_S,
    MALFORMED_TRIP,
    REPLY_RAMP_S,
    REPLY_TRIP_S,
    RULES,
    Cause,
    Mode,
    Reaction,
    Request,
    State,
    Supervision,
    assess,
    is_calm,
    survey,
)
from hapticplayer.haptics.hand import Hand
from hapticplayer.haptics.limiter import Limits
from hapticplayer.model import PlaybackClock

LIMITS = Limits()
NOW_S = 1000.0
CASES = 100_000
EDGE_M = LIMITS.outside * LIMITS.workspace_m


class Track:
    def __init__(self, end_s):
        self.end_s = end_s


# What each rule looks at while all is well: the clip runs and is followed.
PLAYING = {
    "now_s": NOW_S,
    "mode": Mode.FOLLOWING,
    "epoch": 1,
    "planned_n": (4.0, 0.0, 0.0),
    "last_s": NOW_S - 0.001,
    "acted_s": NOW_S - 0.001,
    "position_m": (0.01, 0.0, 0.0),
    "replied_s": NOW_S - 0.001,
    "fast_samples": 0,
    "malformed": 0,
    "is_homed": True,
    "pressed": 0,
    "heartbeat_s": NOW_S - 0.01,
    "is_player_alive": True,
    "request": Request.NONE,
    "is_device_gone": False,
    "is_stale": False,
    "guard_s": NOW_S - 0.004,
    "clock": (1, NOW_S - 10.0, 0.0, 1.0, NOW_S + 0.1),
    "end_s": math.inf,
}


def around(value):
    return [math.nextafter(value, -math.inf), value, math.nextafter(value, math.inf)]


def ages(*limits_s):
    found = [math.nan, math.inf, -math.inf, NOW_S, NOW_S + 1.0]
    for limit_s in limits_s:
        found += around(NOW_S - limit_s)
    return found


SPECIALS = (math.nan, math.inf, -math.inf)
HOSTILE = {
    "now_s": [*SPECIALS, NOW_S - 20.0, NOW_S + 0.05],
    "mode": list(Mode),
    "epoch": [0, 1, 2],
    "planned_n": [(-4.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.05, 9.0, 0.0)],
    "last_s": ages(GAP_RAMP_S, GAP_TRIP_S),
    "acted_s": [-math.inf, NOW_S - 5.0, NOW_S],
    "position_m": [
        *((x, 0.0, 0.0) for x in (*around(EDGE_M), -EDGE_M, 0.039, 1e308, *SPECIALS)),
        (0.0, math.nan, math.inf),
        (0.03, 0.03, -0.03),
    ],
    "replied_s": ages(REPLY_RAMP_S, REPLY_TRIP_S),
    "fast_samples": [1, FAST_SAMPLES_TRIP, 9],
    "malformed": [1, MALFORMED_TRIP - 1, MALFORMED_TRIP],
    "is_homed": [False],
    "pressed": [1, 8],
    "heartbeat_s": ages(HEARTBEAT_RAMP_S, HEARTBEAT_TRIP_S),
    "is_player_alive": [False],
    "request": list(Request),
    "is_device_gone": [True],
    "is_stale": [True],
    "guard_s": ages(GUARD_RAMP_S),
    "clock": [
        None,
        (2, NOW_S - 10.0, 0.0, 1.0, NOW_S + 0.1),
        *((1, at, 0.0, 1.0, math.inf) for at in (*around(NOW_S), *SPECIALS)),
        *((1, NOW_S - 10.0, at, 1.0, math.inf) for at in SPECIALS),
        *((1, NOW_S - 10.0, 0.0, r, math.inf) for r in (0.0, -0.0, -1.0, *SPECIALS)),
        *((1, NOW_S - 10.0, 0.0, 1.0, at) for at in (*around(NOW_S), *SPECIALS)),
    ],
    "end_s": [None, *around(10.0), *SPECIALS],
}

# One change for each rule that makes it hold, and none before it.
MAKES_IT_HOLD = {
    Cause.STOPPED: {"request": Request.STOP},
    Cause.GRIP_BUTTON: {"pressed": 1},
    Cause.PLAYER_GONE: {"is_player_alive": False},
    Cause.HEARTBEAT_LOST: {"heartbeat_s": NOW_S - 1.01},
    Cause.UNPLUGGED: {"is_device_gone": True},
    Cause.TICK_LOST: {"last_s": NOW_S - 0.051},
    Cause.REPLY_LOST: {"replied_s": NOW_S - 0.101},
    Cause.MALFORMED: {"malformed": MALFORMED_TRIP},
    Cause.NOT_FINITE: {"position_m": (math.nan, 0.0, 0.0)},
    Cause.RUNAWAY: {"fast_samples": FAST_SAMPLES_TRIP},
    Cause.OUTSIDE: {"position_m": (0.037, 0.0, 0.0)},
    Cause.CLOSING: {"request": Request.CLOSE},
    Cause.HEARTBEAT_LATE: {"heartbeat_s": NOW_S - 0.151},
    Cause.GUARD_LOST: {"guard_s": NOW_S - 0.251},
    Cause.TICK_LATE: {"last_s": NOW_S - 0.021},
    Cause.COMMAND_STALE: {"is_stale": True},
    Cause.REPLY_LATE: {"replied_s": NOW_S - 0.021},
    Cause.NOT_HOMED: {"is_homed": False},
    Cause.NO_TRACK: {"end_s": None},
    Cause.PAUSED: {"clock": (1, NOW_S - 10.0, 0.0, 0.0, NOW_S + 0.1)},
    Cause.CLOCK_STALE: {"clock": (1, NOW_S - 10.0, 0.0, 1.0, NOW_S - 0.001)},
    Cause.TRACK_ENDED: {"end_s": 10.0},
    Cause.SEEK: {"epoch": 2},
}


def judged(**changes):
    """Return what the short way says of a situation, and what the table does."""
    v = {**PLAYING, **changes}
    hand = Hand(
        v["position_m"],
        replied_s=v["replied_s"],
        fast_samples=v["fast_samples"],
        malformed=v["malformed"],
        is_homed=v["is_homed"],
        pressed=v["pressed"],
    )
    state = State(
        v["mode"],
        epoch=v["epoch"],
        planned_n=v["planned_n"],
        now_s=v["last_s"],
        hand=hand,
        acted_s=v["acted_s"],
    )
    told = Supervision(
        v["heartbeat_s"],
        v["is_player_alive"],
        v["request"],
        None,
        v["is_device_gone"],
        v["is_stale"],
        v["guard_s"],
    )
    clock = None if v["clock"] is None else PlaybackClock(*v["clock"])
    track = None if v["end_s"] is None else Track(v["end_s"])
    now_s = v["now_s"]
    media_s = 0.0 if clock is None else clock.media_s(now_s)
    calm = is_calm(now_s, media_s, clock, track, state, hand, told, LIMITS)
    return calm, assess(survey(now_s, clock, track, state, hand, told, LIMITS))


def test_a_clip_that_is_followed_is_calm():
    assert judged() == (True, (Reaction.GO, Cause.NONE))


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.cause.name)
def test_where_a_rule_holds_it_is_not_calm(rule):
    calm, found = judged(**MAKES_IT_HOLD[rule.cause])
    assert found == (rule.reaction, rule.cause)
    assert not calm


@pytest.mark.parametrize("name", HOSTILE)
def test_one_hostile_value_and_the_table_is_never_contradicted(name):
    for value in HOSTILE[name]:
        for mode in Mode:
            calm, found = judged(**{"mode": mode, name: value})
            assert not calm or found == (Reaction.GO, Cause.NONE), value


def test_what_is_no_number_is_left_to_the_table():
    bare = ("now_s", "last_s", "replied_s", "heartbeat_s", "guard_s", "end_s")
    assert not any(judged(**{name: math.nan})[0] for name in bare)
    for place in range(1, 5):
        clock = list(PLAYING["clock"])
        clock[place] = math.nan
        assert not judged(clock=tuple(clock))[0]
    for place in range(3):
        position = [0.0, 0.0, 0.0]
        position[place] = math.nan
        assert not judged(position_m=tuple(position))[0]


def test_whatever_comes_together_the_table_is_never_contradicted():
    chance, names = random.Random(20120613), list(HOSTILE)
    calm_cases = 0
    for _ in range(CASES):
        chosen = chance.sample(names, chance.randint(1, 4))
        changes = {name: chance.choice(HOSTILE[name]) for name in chosen}
        calm, found = judged(**changes)
        if calm:
            calm_cases += 1
            assert found == (Reaction.GO, Cause.NONE), changes
    assert calm_cases > CASES // 100
