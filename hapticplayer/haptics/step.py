"""One tick of the loop as a pure function, and its state machine as one table.

The same `step` runs in the process, in the tests and in simulations.
"""

import enum
import math
from typing import NamedTuple

from hapticplayer.haptics.limiter import ZERO, Limits, is_finite, limit
from hapticplayer.haptics.track import LoadedTrack
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import Vector

HEARTBEAT_RAMP_S = 0.150
HEARTBEAT_TRIP_S = 1.0
# Longer than any single tick's share of the entry, shorter than can be felt.
CONVERGED_N = 0.05
CATCH_UP_TICKS = 10  # the allowance doubles in the first ten ticks, and so on


class Mode(enum.IntEnum):
    """What the loop does with the force."""

    IDLE = 0
    ENTERING = 1
    FOLLOWING = 2
    RAMPING = 3
    TRIPPED = 4


class Reaction(enum.IntEnum):
    """What the state of the world asks for."""

    GO = 0
    RAMP = 1
    TRIP = 2


class Cause(enum.IntEnum):
    """Why the loop does not follow the track."""

    NONE = 0
    PAUSED = 1
    SEEK = 2
    CLOCK_STALE = 3
    HEARTBEAT_LATE = 4
    NO_TRACK = 5
    HEARTBEAT_LOST = 6
    PLAYER_GONE = 7
    STOPPED = 8
    NOT_FINITE = 9
    CLOSING = 10
    TRACK_ENDED = 11


class Request(enum.IntEnum):
    """What a person asked for since the last tick."""

    NONE = 0
    STOP = 1
    REARM = 2
    CLOSE = 3


class Supervision(NamedTuple):
    """What is known about the player at this tick."""

    heartbeat_s: float
    is_player_alive: bool
    request: Request


class State(NamedTuple):
    """All that one tick hands to the next."""

    mode: Mode = Mode.IDLE
    cause: Cause = Cause.NONE
    force_n: Vector = ZERO
    ticks_in_mode: int = 0
    epoch: int = -1
    planned_n: Vector = ZERO
    media_s: float = 0.0


# Where a mode goes with each reaction. Leaving RAMPING and ENTERING needs a
# condition of its own on top, leaving TRIPPED needs a person: see `_next_mode`.
TRANSITIONS: dict[Mode, tuple[Mode, Mode, Mode]] = {
    # mode:        GO              RAMP          TRIP
    Mode.IDLE: (Mode.ENTERING, Mode.IDLE, Mode.TRIPPED),
    Mode.ENTERING: (Mode.ENTERING, Mode.RAMPING, Mode.TRIPPED),
    Mode.FOLLOWING: (Mode.FOLLOWING, Mode.RAMPING, Mode.TRIPPED),
    Mode.RAMPING: (Mode.RAMPING, Mode.RAMPING, Mode.TRIPPED),
    Mode.TRIPPED: (Mode.TRIPPED, Mode.TRIPPED, Mode.TRIPPED),
}


def step(
    now_s: float,
    clock: PlaybackClock | None,
    track: LoadedTrack | None,
    state: State,
    supervision: Supervision,
    limits: Limits,
) -> State:
    """Return the state after one tick; its `force_n` is the command.

    Args:
        now_s: monotonic time of this tick.
        clock: the newest playback clock, None before the first.
        track: the track that the clock names, None while it is not loaded.
        state: what the last tick returned.
        supervision: heartbeat, pipe and requests.
        limits: what no command may exceed.
    """
    reaction, cause = _assess(now_s, clock, track, state, supervision)
    planned, media_s = ZERO, state.media_s
    if clock is not None:
        media_s = clock.media_s(now_s)
        if reaction is Reaction.GO and track is not None:
            planned = track.force_at(media_s)
            if not is_finite(planned):
                reaction, cause, planned = Reaction.TRIP, Cause.NOT_FINITE, ZERO
    mode = _next_mode(state, reaction, planned, limits, supervision.request)
    ticks = state.ticks_in_mode + 1 if mode is state.mode else 0
    if mode is Mode.TRIPPED and state.mode is Mode.TRIPPED:
        cause = state.cause  # the first reason is the one to tell
    return State(
        mode,
        cause,
        _command(mode, ticks, planned, state.force_n, limits),
        ticks,
        clock.epoch if clock is not None and mode is Mode.ENTERING else state.epoch,
        planned,
        media_s,
    )


def _assess(
    now_s: float,
    clock: PlaybackClock | None,
    track: LoadedTrack | None,
    state: State,
    supervision: Supervision,
) -> tuple[Reaction, Cause]:
    """Return the strongest reaction that anything asks for, and why."""
    reaction, cause = _assess_player(now_s, supervision)
    if reaction is not Reaction.GO:
        return reaction, cause
    if clock is None or track is None:
        return Reaction.RAMP, Cause.NO_TRACK
    reaction, cause = _assess_clock(now_s, clock, track)
    following = state.mode is Mode.ENTERING or state.mode is Mode.FOLLOWING
    if reaction is Reaction.GO and following and clock.epoch != state.epoch:
        return Reaction.RAMP, Cause.SEEK
    return reaction, cause


def _assess_clock(
    now_s: float, clock: PlaybackClock, track: LoadedTrack
) -> tuple[Reaction, Cause]:
    """Return what the clock and the end of the track ask for."""
    if clock.rate == 0.0 or now_s < clock.monotonic0_s:
        return Reaction.RAMP, Cause.PAUSED
    if now_s > clock.valid_until_s:
        return Reaction.RAMP, Cause.CLOCK_STALE
    if clock.media_s(now_s) >= track.end_s:
        return Reaction.RAMP, Cause.TRACK_ENDED
    return Reaction.GO, Cause.NONE


def _assess_player(now_s: float, supervision: Supervision) -> tuple[Reaction, Cause]:
    """Return what the player's own health and its requests ask for."""
    if supervision.request is Request.STOP:
        return Reaction.TRIP, Cause.STOPPED
    if not supervision.is_player_alive:
        return Reaction.TRIP, Cause.PLAYER_GONE
    if supervision.request is Request.CLOSE:
        return Reaction.RAMP, Cause.CLOSING
    return _assess_heart(now_s - supervision.heartbeat_s)


def _assess_heart(silence_s: float) -> tuple[Reaction, Cause]:
    if silence_s > HEARTBEAT_TRIP_S:
        return Reaction.TRIP, Cause.HEARTBEAT_LOST
    if silence_s > HEARTBEAT_RAMP_S:
        return Reaction.RAMP, Cause.HEARTBEAT_LATE
    return Reaction.GO, Cause.NONE


def _next_mode(
    state: State,
    reaction: Reaction,
    planned_n: Vector,
    limits: Limits,
    request: Request,
) -> Mode:
    mode = TRANSITIONS[state.mode][reaction]
    if mode is Mode.TRIPPED:
        rearmed = request is Request.REARM and reaction is not Reaction.TRIP
        return Mode.IDLE if rearmed else mode
    if mode is Mode.RAMPING and state.force_n == ZERO:
        return Mode.IDLE
    is_entering = mode is Mode.ENTERING and state.mode is Mode.ENTERING
    if is_entering and state.ticks_in_mode >= limits.entry_ticks:
        near = math.dist(planned_n, state.force_n) <= CONVERGED_N
        is_over = _entry_slew(state.ticks_in_mode, limits) >= limits.content_slew_n
        return Mode.FOLLOWING if near or is_over else mode
    return mode


def _entry_slew(ticks: int, limits: Limits) -> float:
    """Return the change per tick that is allowed so long after the entry began.

    0.05 N for the first 200 ms; content that is faster than that is caught up with
    by widening the allowance evenly, so that nothing jumps when the entry ends.
    """
    late = max(0, ticks - limits.entry_ticks)
    return limits.entry_slew_n * (1.0 + late / CATCH_UP_TICKS)


def _command(
    mode: Mode, ticks: int, planned_n: Vector, previous_n: Vector, limits: Limits
) -> Vector:
    """Return the force to send in this mode."""
    if mode is Mode.IDLE or mode is Mode.TRIPPED:
        return ZERO
    cap = limits.force_cap_n
    if mode is Mode.FOLLOWING:
        if planned_n == ZERO and previous_n == ZERO:
            return ZERO
        return limit(planned_n, previous_n, limits.content_slew_n, cap)
    if mode is Mode.RAMPING:
        return limit(ZERO, previous_n, limits.stop_slew_n, cap)
    share = min(1.0, (ticks + 1) / limits.entry_ticks)
    x, y, z = planned_n
    wanted = (share * x, share * y, share * z)
    return limit(wanted, previous_n, _entry_slew(ticks, limits), cap)
