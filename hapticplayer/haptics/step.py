"""One tick of the loop as a pure function: what is asked for, and the force for it.

The same `step` runs in the process, in the tests and in simulations. What may go
wrong is the table in `contract`; what may leave is bounded by `limiter`.
"""

import math

from hapticplayer.haptics.centring import Centring, ahead_of, centring_force
from hapticplayer.haptics.contract import (
    TRANSITIONS,
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
from hapticplayer.haptics.hand import Hand, observe
from hapticplayer.haptics.limiter import (
    PERIOD_S,
    ZERO,
    Limits,
    cap_when_warm,
    faded,
    is_finite,
    is_near_middle,
    limit,
    warmed,
)
from hapticplayer.haptics.track import LoadedTrack
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import Vector

# Longer than any single tick's share of the entry, shorter than can be felt.
CONVERGED_N = 0.05
CATCH_UP_TICKS = 10  # the allowance doubles in the first ten ticks, and so on
# More skipped periods than this in 10 s: the loop is not real-time.
MISSED_SHARE = 0.01
# What the constructor of a named tuple, which is Python, calls.
_new = tuple.__new__
# A member of an enum costs ten times as much as a name of the module.
_GO, _TRIP, _NO_CAUSE = Reaction.GO, Reaction.TRIP, Cause.NONE
_IDLE, _TRIPPED, _RAMPING = Mode.IDLE, Mode.TRIPPED, Mode.RAMPING
_ENTERING, _FOLLOWING = Mode.ENTERING, Mode.FOLLOWING


def step(  # noqa: PLR0913 - a pure function has no other way in
    now_s: float,
    clock: PlaybackClock | None,
    track: LoadedTrack | None,
    state: State,
    told: Supervision,
    limits: Limits,
    centring: Centring = Centring(),  # noqa: B008 - a tuple; nothing can change it
) -> State:
    """Return the state after one tick; its `force_n` is the command.

    Args:
        now_s: monotonic time of this tick.
        clock: the newest playback clock, None before the first.
        track: the track that the clock names, None while it is not loaded.
        state: what the last tick returned.
        told: heartbeat, pipe, requests, and the device's answer.
        limits: what no command may exceed.
        centring: what keeps the grip inside.
    """
    hand = observe(state.hand, told.reading, limits)
    media_s = state.media_s if clock is None else clock.media_s(now_s)
    reaction, cause = _GO, _NO_CAUSE
    if not is_calm(now_s, media_s, clock, track, state, hand, told, limits):
        reaction, cause = assess(survey(now_s, clock, track, state, hand, told, limits))
    planned = pull = wanted = ZERO
    if reaction is _GO and clock is not None and track is not None:
        planned = x, y, z = track.force_at(media_s)
        is_sound = math.isfinite(x + y + z + media_s)  # though their sum may overflow
        if not is_sound and not (is_finite(planned) and math.isfinite(media_s)):
            reaction, cause, planned = _TRIP, Cause.NOT_FINITE, ZERO
    if reaction is _GO:
        wanted, ahead_m = planned, ahead_of(hand, centring)
        radius_m = math.hypot(*ahead_m)
        fade_from_m = limits.fade_from * limits.workspace_m
        if not (radius_m <= centring.from_m and radius_m <= fade_from_m):
            wanted = faded(planned, ahead_m, limits)
            pull = centring_force(ahead_m, centring)
            if pull is not ZERO:
                wanted = _sum(wanted, pull)
    mode = state.mode
    if mode is not _FOLLOWING or reaction is not _GO:  # else it goes on
        mode = _next_mode(state, reaction, wanted, told, hand, limits)
    if mode is _TRIPPED and state.mode is _TRIPPED:
        cause = state.cause  # the first reason is the one to tell
    ticks = state.ticks_in_mode + 1 if mode is state.mode else 0
    last_s = state.now_s
    gap_s = now_s - last_s if last_s > -math.inf else 0.0
    force = _command(mode, ticks, state, told, gap_s, wanted, limits)
    is_following = mode is _FOLLOWING or mode is _ENTERING
    return _new(
        State,
        (
            mode,
            cause,
            force,
            ticks,
            clock.epoch if clock is not None and mode is _ENTERING else state.epoch,
            planned,
            pull,
            media_s,
            now_s,
            hand,
            warmed(state.heat_n2, force, gap_s, limits),
            now_s if is_following else state.acted_s,
        ),
    )


def _next_mode(
    state: State,
    reaction: Reaction,
    wanted_n: Vector,
    told: Supervision,
    hand: Hand,
    limits: Limits,
) -> Mode:
    before = state.mode
    mode = TRANSITIONS[before][reaction]
    if mode is _FOLLOWING:
        return mode
    if mode is _TRIPPED:
        return _IDLE if _is_rearmed(told, reaction, hand, limits) else mode
    if mode is _RAMPING and state.force_n == ZERO:
        return _IDLE
    is_entering = mode is _ENTERING and before is _ENTERING
    if is_entering and state.ticks_in_mode >= limits.entry_ticks:
        near = math.dist(wanted_n, state.force_n) <= CONVERGED_N
        is_over = _entry_slew(state.ticks_in_mode, limits) >= limits.content_slew_n
        return _FOLLOWING if near or is_over else mode
    return mode


def _is_rearmed(
    told: Supervision, reaction: Reaction, hand: Hand, limits: Limits
) -> bool:
    """Whether a person lets the force come back, with the grip near the middle."""
    if told.request is not Request.REARM or reaction is _TRIP:
        return False
    return is_near_middle(hand.position_m, limits)


def _entry_slew(ticks: int, limits: Limits) -> float:
    """Return the change per tick that is allowed so long after the entry began.

    0.05 N for the first 200 ms; content that is faster than that is caught up with
    by widening the allowance evenly, so that nothing jumps when the entry ends.
    """
    late = max(0, ticks - limits.entry_ticks)
    return limits.entry_slew_n * (1.0 + late / CATCH_UP_TICKS)


def _command(  # noqa: PLR0913 - what `step` knows of the tick
    mode: Mode,
    ticks: int,
    state: State,
    told: Supervision,
    gap_s: float,
    wanted_n: Vector,
    limits: Limits,
) -> Vector:
    """Return the force to send in this mode."""
    if mode is _IDLE or mode is _TRIPPED:
        return ZERO
    previous_n = state.force_n
    if mode is _RAMPING:
        # of time, not of ticks: after a stall the ramp may be over already
        slew_n = limits.stop_slew_n * max(1.0, gap_s / PERIOD_S)
        return limit(ZERO, previous_n, slew_n, limits.force_cap_n)
    if mode is _ENTERING:
        share = min(1.0, (ticks + 1) / limits.entry_ticks)
        x, y, z = wanted_n
        wanted_n = (share * x, share * y, share * z)
        slew_n = min(_entry_slew(ticks, limits), limits.content_slew_n)
    elif wanted_n == ZERO and previous_n == ZERO:
        return ZERO
    else:
        slew_n = limits.content_slew_n
    cap_n = cap_when_warm(state.heat_n2, limits)
    if told.missed_share > MISSED_SHARE:
        cap_n = min(cap_n, limits.late_cap_n)
    return limit(wanted_n, previous_n, slew_n, cap_n)


def _sum(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
