"""One tick of the loop as a pure function: what is asked for, and the force for it.

The same `step` runs in the loop, in the tests and in simulations. What may go wrong is
the table in `contract`; what may leave is bounded by `limiter`.
"""

import math

from hapticplayer.haptics.centring import kept_inside
from hapticplayer.haptics.contract import (
    TRANSITIONS,
    Cause,
    Mode,
    Reaction,
    Request,
    Situation,
    State,
    assess,
)
from hapticplayer.haptics.limiter import (
    PERIOD_S,
    ZERO,
    Limits,
    cap_when_warm,
    is_finite,
    is_near_middle,
    limit,
    warmed,
)
from hapticplayer.model.device import Vector

# Longer than any single tick's share of the entry, shorter than can be felt.
CONVERGED_N = 0.05
CATCH_UP_TICKS = 10  # the allowance doubles in the first ten ticks, and so on
# More skipped periods than this in 10 s: the loop is not real-time.
MISSED_SHARE = 0.01


def step(situation: Situation) -> State:
    """Return the state after one tick; its `force_n` is the command."""
    now_s, clock, track, state, hand, _, limits, _ = situation
    media_s = situation.media_s
    reaction, cause = assess(situation)
    planned = pull = wanted = switch = ZERO
    if reaction is Reaction.GO and track is not None:
        planned = track.force_at(media_s)
        if track is not state.track or state.switch_n != ZERO:
            switch = _left_of_switch(planned, situation)
            (x, y, z), (dx, dy, dz) = planned, switch
            planned = (x + dx, y + dy, z + dz)
        if not (is_finite(planned) and math.isfinite(media_s)):
            reaction, cause, planned = Reaction.TRIP, Cause.NOT_FINITE, ZERO
    if reaction is Reaction.GO:
        wanted, pull = kept_inside(planned, hand, limits, situation.centring)
    mode = _next_mode(situation, reaction, wanted)
    if mode is state.mode is Mode.TRIPPED:
        cause = state.cause  # the first reason is the one to report
    ticks = state.ticks_in_mode + 1 if mode is state.mode else 0
    force = _command(mode, ticks, situation, wanted)
    is_entering = mode is Mode.ENTERING
    return State(
        mode,
        cause,
        force,
        ticks,
        clock.epoch if clock is not None and is_entering else state.epoch,
        planned,
        pull,
        media_s,
        now_s,
        hand,
        warmed(state.heat_n2, force, situation.gap_s, limits),
        now_s if is_entering or mode is Mode.FOLLOWING else state.acted_s,
        track if reaction is Reaction.GO else None,
        switch,
    )


def _left_of_switch(planned_n: Vector, situation: Situation) -> Vector:
    """Return the difference to the track before, which shrinks as slowly as an entry.

    A track takes the place of another while it is followed when it was edited.
    """
    state, limits = situation.state, situation.limits
    left_n = state.switch_n
    if situation.track is not state.track:
        if state.track is None:
            return ZERO
        (x, y, z), (bx, by, bz) = planned_n, state.planned_n
        left_n = (bx - x, by - y, bz - z)
    return limit(ZERO, left_n, limits.entry_slew_n, limits.force_cap_n)


def _next_mode(situation: Situation, reaction: Reaction, wanted_n: Vector) -> Mode:
    state, limits = situation.state, situation.limits
    before = state.mode
    mode = TRANSITIONS[before][reaction]
    if mode is Mode.TRIPPED:
        return Mode.IDLE if _is_rearmed(situation, reaction) else mode
    if mode is Mode.RAMPING and state.force_n == ZERO:
        return Mode.IDLE
    is_entering = mode is Mode.ENTERING and before is Mode.ENTERING
    if is_entering and state.ticks_in_mode >= limits.entry_ticks:
        near = math.dist(wanted_n, state.force_n) <= CONVERGED_N
        is_over = _entry_slew(state.ticks_in_mode, limits) >= limits.content_slew_n
        return Mode.FOLLOWING if near or is_over else mode
    return mode


def _is_rearmed(situation: Situation, reaction: Reaction) -> bool:
    """Whether a person lets the force come back, with the grip near the middle."""
    is_asked = situation.supervision.request is Request.REARM
    if not is_asked or reaction is Reaction.TRIP:
        return False
    return is_near_middle(situation.hand.position_m, situation.limits)


def _entry_slew(ticks: int, limits: Limits) -> float:
    """Return the change per tick that is allowed so long after the entry began.

    0.05 N for the first 200 ms; content that is faster than that is caught up with
    by widening the allowance evenly, so that nothing jumps when the entry ends.
    """
    late = max(0, ticks - limits.entry_ticks)
    return limits.entry_slew_n * (1.0 + late / CATCH_UP_TICKS)


def _command(mode: Mode, ticks: int, situation: Situation, wanted_n: Vector) -> Vector:
    """Return the force to send in this mode."""
    if mode is Mode.IDLE or mode is Mode.TRIPPED:
        return ZERO
    limits, state = situation.limits, situation.state
    previous_n = state.force_n
    if mode is Mode.RAMPING:
        # of time, not of ticks: after a stall the ramp may be over already
        slew_n = limits.stop_slew_n * max(1.0, situation.gap_s / PERIOD_S)
        return limit(ZERO, previous_n, slew_n, limits.force_cap_n)
    slew_n = limits.content_slew_n
    if mode is Mode.ENTERING:
        share = min(1.0, (ticks + 1) / limits.entry_ticks)
        x, y, z = wanted_n
        wanted_n = (share * x, share * y, share * z)
        slew_n = min(_entry_slew(ticks, limits), slew_n)
    elif wanted_n == ZERO and previous_n == ZERO:
        return ZERO
    cap_n = cap_when_warm(state.heat_n2, limits)
    if situation.supervision.missed_share > MISSED_SHARE:
        cap_n = min(cap_n, limits.late_cap_n)
    return limit(wanted_n, previous_n, slew_n, cap_n)
