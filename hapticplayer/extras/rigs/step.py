"""One packet of a rig as a pure function: what is asked for, and the motion for it.

Rig software keeps its last pose when packets stop. So every end is the same: a ramp to
neutral of `RAMP_S`, then neutral packets for `NEUTRAL_S`, then silence; a pause, a seek,
a stop, a trip and the death of the loop differ only in what may follow. The time in the
packets grows until that silence, and begins at 0 with the motion after it. What asks for
an end is the table in `contract`.
"""

import math
from collections.abc import Iterable
from typing import NamedTuple

from hapticplayer.haptics.contract import (
    GAP_TRIP_S,
    RULES,
    TRANSITIONS,
    Cause,
    Mode,
    Reaction,
    Request,
    Situation,
    State,
    Supervision,
    assess,
)
from hapticplayer.haptics.hand import HandState
from hapticplayer.haptics.limiter import Limits
from hapticplayer.haptics.track import AnyTrack, LoadedTrack
from hapticplayer.model import PlaybackClock
from hapticplayer.model.rig import NEUTRAL, RigMotion

FADE_S = 0.5
RAMP_S = 0.5
NEUTRAL_S = 2.0
TAKE_OVER_S = GAP_TRIP_S
"""After such a silence of the loop its guard ramps; the loop continues from there."""

CAPS = RigMotion(
    *(20.0, 20.0, 20.0),  # m/s^2: two g
    *(0.5, 0.5, 1.0),  # rad
    *(5.0, 5.0, 5.0),  # rad/s
    *(50.0, 50.0, 50.0),  # rad/s^2
    *(20.0, 20.0, 20.0),  # m/s
)
"""No packet says more; a rig's own limits are narrower."""

RIG_RULES = tuple(rule for rule in RULES if rule.cause is not Cause.TICK_LATE)
"""A packet that comes 20 ms late is no fault: nothing pushes meanwhile."""

_MOVING = (Mode.ENTERING, Mode.FOLLOWING)
_LIMITS, _NO_HAND = Limits(), HandState(is_homed=True)


class RigSetup(NamedTuple):
    """What a person chose, as a step needs it.

    Attributes:
        signs: 1 or -1 for each number of a `RigMotion`.
        lead_s: how far ahead of the clock a packet says what it says. A receiver holds
            it until the next one, so half a period makes its mean delay zero.
    """

    signs: tuple[float, ...]
    lead_s: float = 0.0


class RigState(NamedTuple):
    """All that one packet hands to the next.

    Attributes:
        state: as the contract has it.
        motion: the last that was sent.
        is_sending: whether a packet belongs to this tick.
        begun_s: when the time in the packets was 0.
        changed_s: when the fade or the ramp began.
        left: where the ramp began.
    """

    state: State = State()
    motion: RigMotion = NEUTRAL
    is_sending: bool = False
    begun_s: float = 0.0
    changed_s: float = 0.0
    left: RigMotion = NEUTRAL

    @property
    def packet_s(self) -> float:
        return self.state.now_s - self.begun_s


def rig_step(
    now_s: float,
    clock: PlaybackClock | None,
    track: AnyTrack | None,
    rig: RigState,
    supervision: Supervision,
    setup: RigSetup,
) -> RigState:
    """Return the state after one tick."""
    before = rig.state
    situation = Situation(now_s, clock, track, before, _NO_HAND, supervision, _LIMITS)
    reaction, cause = assess(situation, RIG_RULES)
    planned = NEUTRAL
    if reaction is Reaction.GO and isinstance(track, LoadedTrack):
        rate = clock.rate if clock else 0.0
        values = track.values_at(situation.media_s + rate * setup.lead_s)
        planned = capped(f * v for f, v in zip(setup.signs, values, strict=True))
        if not (math.isfinite(sum(values)) and math.isfinite(situation.media_s)):
            reaction, cause, planned = Reaction.TRIP, Cause.NOT_FINITE, NEUTRAL
    mode = _next_mode(situation, reaction, rig)
    if mode is before.mode is Mode.TRIPPED:
        cause = before.cause  # the first reason is the one to report
    is_moving = mode in _MOVING
    state = State(
        mode,
        cause,
        epoch=clock.epoch if clock and mode is Mode.ENTERING else before.epoch,
        media_s=situation.media_s,
        now_s=now_s,
        acted_s=now_s if is_moving else before.acted_s,
    )
    rig = _changed(rig._replace(state=state), before, situation.gap_s)
    return _with_motion(rig, planned)


def _next_mode(situation: Situation, reaction: Reaction, rig: RigState) -> Mode:
    before, now_s = rig.state.mode, situation.now_s
    mode = TRANSITIONS[before][reaction]
    is_rearmed = situation.supervision.request is Request.REARM
    if before is Mode.TRIPPED and is_rearmed and reaction is not Reaction.TRIP:
        return Mode.RAMPING
    if before is Mode.RAMPING and mode is Mode.RAMPING and not rig.is_sending:
        return Mode.IDLE
    if before is mode is Mode.ENTERING and now_s - rig.changed_s >= FADE_S:
        return Mode.FOLLOWING
    return mode


def _changed(rig: RigState, before: State, gap_s: float) -> RigState:
    """Note what begins with this tick: a fade from neutral, or a ramp to it."""
    now_s, mode = rig.state.now_s, rig.state.mode
    if mode is Mode.ENTERING and before.mode is not mode:
        return rig._replace(begun_s=now_s, changed_s=now_s, is_sending=True)
    has_left = before.mode in _MOVING and mode not in _MOVING
    if has_left or (rig.is_sending and gap_s > TAKE_OVER_S):
        began_s = now_s - max(0.0, gap_s - TAKE_OVER_S)
        return rig._replace(left=rig.motion, changed_s=began_s)
    return rig


def _with_motion(rig: RigState, planned: RigMotion) -> RigState:
    age_s = rig.state.now_s - rig.changed_s
    if rig.state.mode is Mode.FOLLOWING:
        return rig._replace(motion=planned)
    if rig.state.mode is Mode.ENTERING:
        return rig._replace(motion=scaled(planned, _smooth(age_s / FADE_S)))
    is_sending = rig.is_sending and age_s < RAMP_S + NEUTRAL_S
    return rig._replace(motion=ramped(rig.left, age_s), is_sending=is_sending)


def ramped(left: RigMotion, age_s: float) -> RigMotion:
    """Return the motion so long after a ramp to neutral began."""
    return scaled(left, 1.0 - _smooth(age_s / RAMP_S))


def scaled(motion: RigMotion, share: float) -> RigMotion:
    return RigMotion(*(share * value for value in motion))


def capped(values: Iterable[float]) -> RigMotion:
    """Return a motion within `CAPS`."""
    pairs = zip(values, CAPS, strict=True)
    return RigMotion(*(min(max(value, -cap), cap) for value, cap in pairs))


def _smooth(share: float) -> float:
    """Return 0 to 1 along half a cosine."""
    return 0.5 - 0.5 * math.cos(math.pi * min(max(share, 0.0), 1.0))
