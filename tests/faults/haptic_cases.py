"""Every single fault of the safety contract: how it comes, and when it must be seen.

`notice` is the number of periods from the fault to the first command that reacts.
docs/safety.md names each case; `test_haptic_faults` checks that none is missing.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.haptics.contract import Cause, Reaction
from hapticplayer.haptics.messages import MessageKind

TRIP, RAMP = Reaction.TRIP, Reaction.RAMP


@dataclass(frozen=True)
class Case:
    """One fault.

    Attributes:
        cause: what the loop must say.
        reaction: what it must do.
        notice: periods from the fault to the reaction.
        inject: makes the fault.
        mend: takes it away again; None where nothing can.
        gap_s: length of the first period after it.
        passes_s: time that passes within the period that reacts.
        is_live: whether the force has to be that of a live source.
    """

    cause: Cause
    reaction: Reaction
    notice: int
    inject: Callable
    mend: Callable | None = None
    gap_s: float = 0.001
    passes_s: float = 0.0
    is_live: bool = False


def put(name, value):
    return lambda rig: setattr(rig, name, value)


def device(name, value):
    return lambda rig: setattr(rig.device, name, value)


def say(word, text=""):
    return lambda rig: rig.player.send(word, text)


def nothing(rig):
    """There is nothing to do."""


def push_outward(rig):
    """The grip is found at the edge, on the side to which the force points."""
    force = rig.device.sent[-1]
    size = math.hypot(*force)
    where = tuple(0.0375 * f / size for f in force)
    # let go and caught again there: no leap that the plausibility check would drop
    rig.loop.state = rig.loop.state._replace(
        hand=rig.loop.state.hand._replace(position_m=where)
    )
    rig.loop.reading = rig.loop.reading._replace(position_m=where)
    rig.device.position_m = where


def seek(rig):
    rig.seek(50.0)


def to_the_end(rig):
    """The clip is where the force track ends, without a seek."""
    rig.media0_s, rig.media_from_s = 100.0, rig.clock.now_s()


CASES: dict[str, Case] = {
    "stop": Case(Cause.STOPPED, TRIP, 1, say(MessageKind.STOP), nothing),
    "grip-button": Case(
        Cause.GRIP_BUTTON, TRIP, 2, device("buttons", 4), device("buttons", 0)
    ),
    "player-killed": Case(Cause.PLAYER_GONE, TRIP, 1, lambda rig: rig.player.close()),
    "player-hangs": Case(
        Cause.HEARTBEAT_LATE, RAMP, 151, put("beats", False), put("beats", True)
    ),
    "player-frozen": Case(
        Cause.HEARTBEAT_LOST, TRIP, 1001, put("beats", False), put("beats", True)
    ),
    "clock-stale": Case(
        Cause.CLOCK_STALE,
        RAMP,
        151,
        put("refreshes", False),
        put("refreshes", True),
    ),
    "guard-silent": Case(
        Cause.GUARD_LOST, RAMP, 251, put("guards", False), put("guards", True)
    ),
    "unplugged": Case(Cause.UNPLUGGED, TRIP, 2, device("is_plugged", False)),
    "reply-late": Case(
        Cause.REPLY_LATE,
        RAMP,
        21,
        device("answers", False),
        device("answers", True),
    ),
    "reply-lost": Case(
        Cause.REPLY_LOST,
        TRIP,
        101,
        device("answers", False),
        device("answers", True),
    ),
    "malformed": Case(
        Cause.MALFORMED, TRIP, 21, device("malformed", 10**6), device("malformed", 0)
    ),
    "encoder-leaps": Case(
        Cause.MALFORMED,
        TRIP,
        21,
        device("position_m", (0.15, 0.0, 0.0)),
        device("position_m", (0.0, 0.0, 0.0)),
    ),
    "tick-late": Case(Cause.TICK_LATE, RAMP, 1, nothing, nothing, gap_s=0.021),
    "tick-lost": Case(Cause.TICK_LOST, TRIP, 1, nothing, nothing, gap_s=0.051),
    "suspended": Case(Cause.TICK_LOST, TRIP, 1, nothing, seek, gap_s=3600.0),
    "command-stale": Case(
        Cause.COMMAND_STALE,
        RAMP,
        1,
        lambda rig: setattr(rig, "delay_sending_s", 0.0205),
        nothing,
        passes_s=0.0205,
    ),
    "not-homed": Case(
        Cause.NOT_HOMED,
        RAMP,
        2,
        device("is_homed", False),
        device("is_homed", True),
    ),
    "position-not-finite": Case(
        Cause.NOT_FINITE,
        TRIP,
        2,
        device("position_m", (math.nan, 0.0, 0.0)),
        device("position_m", (0.0, 0.0, 0.0)),
    ),
    "let-go": Case(
        Cause.RUNAWAY,
        TRIP,
        3,
        device("velocity_mps", (1.2, 0.0, 0.0)),
        device("velocity_mps", (0.0, 0.0, 0.0)),
    ),
    "pushed-out": Case(
        Cause.OUTSIDE, TRIP, 1, push_outward, device("position_m", (0.0, 0.0, 0.0))
    ),
    "pause": Case(Cause.PAUSED, RAMP, 1, put("rate", 0.0), put("rate", 1.0)),
    "seek": Case(Cause.SEEK, RAMP, 1, seek, nothing),
    "track-taken-away": Case(
        Cause.NO_TRACK, RAMP, 1, put("track_id", 7), put("track_id", 1)
    ),
    "source-silent": Case(
        Cause.SOURCE_SILENT,
        RAMP,
        101,
        put("measures", False),
        put("measures", True),
        is_live=True,
    ),
    "end-of-track": Case(Cause.TRACK_ENDED, RAMP, 1, to_the_end, seek),
    "closing": Case(Cause.CLOSING, RAMP, 1, say(MessageKind.QUIT)),
}
