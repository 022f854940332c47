"""The safety contract as one table: what may go wrong, and what the loop does then.

Two reactions only. RAMP brings the force to zero within 20 ms and lets it fade in
again when the reason is gone. TRIP makes it zero at the next tick and keeps it there
until a person re-arms. docs/safety.md maps each rule to its test.
"""

import enum
import math
from collections.abc import Callable
from typing import NamedTuple

from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.hand import HandState
from hapticplayer.haptics.limiter import ZERO, Limits, is_finite, outward_n
from hapticplayer.haptics.track import AnyTrack
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import Vector

HEARTBEAT_RAMP_S = 0.150
HEARTBEAT_TRIP_S = 1.0
GUARD_RAMP_S = 0.250
REPLY_RAMP_S = 0.020
REPLY_TRIP_S = 0.100
MALFORMED_TRIP = 20
GAP_RAMP_S = 0.020
GAP_TRIP_S = 0.050
FAST_SAMPLES_TRIP = 2
# Less than the grip's own friction: no push.
OUTWARD_N = 0.1


class Mode(enum.IntEnum):
    """What the loop does with the force."""

    IDLE = 0
    ENTERING = 1
    FOLLOWING = 2
    RAMPING = 3
    TRIPPED = 4


_MOVING = (Mode.ENTERING, Mode.FOLLOWING)
_ACTING = (Mode.FOLLOWING, Mode.ENTERING, Mode.RAMPING)


class Reaction(enum.IntEnum):
    """What the state of the world asks for."""

    GO = 0
    RAMP = 1
    TRIP = 2


class Cause(enum.IntEnum):
    """Why the loop does not follow the track; the numbers are kept in records."""

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
    GRIP_BUTTON = 12
    UNPLUGGED = 13
    REPLY_LATE = 14
    REPLY_LOST = 15
    MALFORMED = 16
    TICK_LATE = 17
    TICK_LOST = 18
    NOT_HOMED = 19
    RUNAWAY = 20
    OUTSIDE = 21
    COMMAND_STALE = 22
    GUARD_LOST = 23
    SOURCE_SILENT = 24


class Request(enum.IntEnum):
    """What a person asked for since the last tick."""

    NONE = 0
    STOP = 1
    REARM = 2
    CLOSE = 3


class Supervision(NamedTuple):
    """What the loop received or noticed since its last tick; times are monotonic."""

    heartbeat_s: float
    is_player_alive: bool = True  # whether its line is open and its main thread lives
    request: Request = Request.NONE  # of a person
    is_device_gone: bool = False  # whether it refused the last exchange for good
    is_stale: bool = False  # whether the last command was too old to be sent
    guard_s: float = math.inf
    missed_share: float = 0.0  # periods skipped in the last 10 s


class State(NamedTuple):
    """All that one tick hands to the next; `force_n` is the command."""

    mode: Mode = Mode.IDLE
    cause: Cause = Cause.NONE
    force_n: Vector = ZERO
    ticks_in_mode: int = 0
    epoch: int = -1
    planned_n: Vector = ZERO  # what the track says
    centring_n: Vector = ZERO  # what keeps the grip inside
    media_s: float = 0.0
    now_s: float = -math.inf  # time of this tick; -inf before the first
    hand: HandState = HandState()  # the grip as last seen
    heat_n2: float = 0.0  # mean square force of the last seconds
    acted_s: float = -math.inf  # last time at which a force was allowed
    track: AnyTrack | None = None  # that was followed
    switch_n: Vector = ZERO  # left of the difference to the track before


class Situation(NamedTuple):
    """All that one tick decides on."""

    now_s: float
    clock: PlaybackClock | None  # the newest playback clock, None before the first
    # the track that the clock names, None while it is not loaded
    track: AnyTrack | None
    state: State  # what the last tick returned
    hand: HandState  # the grip as `observe` has it after the last exchange
    supervision: Supervision
    limits: Limits
    centring: Centring = Centring()

    @property
    def is_acting(self) -> bool:
        """Whether a force may be on the hand."""
        return self.state.mode in _ACTING

    @property
    def gap_s(self) -> float:
        """Time since the last tick; 0 at the first."""
        last_s = self.state.now_s
        return self.now_s - last_s if last_s > -math.inf else 0.0

    @property
    def reply_age_s(self) -> float:
        """Age of the newest good answer; 0 before the first: nothing is homed then."""
        replied_s = self.hand.replied_s
        return self.now_s - replied_s if replied_s > -math.inf else 0.0

    @property
    def media_s(self) -> float:
        """Position in the media; the last one without a clock."""
        if self.clock is None:
            return self.state.media_s
        return self.clock.media_s(self.now_s)


class Rule(NamedTuple):
    """One row: when `holds`, `reaction`. The first row that holds is taken."""

    cause: Cause
    reaction: Reaction
    holds: Callable[[Situation], bool]


def _was_silent_under_force(s: Situation) -> bool:
    """Whether the player fell silent for so long while it played.

    A window that takes its time to open while nothing plays is not a fault.
    """
    heartbeat_s = s.supervision.heartbeat_s
    return s.now_s - heartbeat_s > HEARTBEAT_TRIP_S and s.state.acted_s > heartbeat_s


def _is_reply_lost(s: Situation) -> bool:
    """Under force only: a device that is slow to begin with is not a fault."""
    return s.reply_age_s > REPLY_TRIP_S and s.state.acted_s > s.hand.replied_s


def _is_reply_late(s: Situation) -> bool:
    """At rest the newest answer is one or two long periods old."""
    usual_s = 0.0 if s.is_acting else 2.0 * s.gap_s
    return s.reply_age_s > REPLY_RAMP_S + usual_s


def _is_runaway(s: Situation) -> bool:
    return s.hand.fast_samples >= FAST_SAMPLES_TRIP and s.is_acting


def is_pushed_outside(planned_n: Vector, position_m: Vector, limits: Limits) -> bool:
    """Whether the track pushes outward on a grip at the edge of the workspace.

    What is sent has faded to zero there; a hand that holds the grip, and the spring
    against it, would not have let it come so far.
    """
    if math.hypot(*position_m) <= limits.outside * limits.workspace_m:
        return False
    return outward_n(planned_n, position_m) > OUTWARD_N


def _is_outside(s: Situation) -> bool:
    planned_n, position_m = s.state.planned_n, s.hand.position_m
    return is_pushed_outside(planned_n, position_m, s.limits) and s.is_acting


def _is_paused(s: Situation) -> bool:
    return s.clock is not None and (
        s.clock.rate == 0.0 or s.now_s < s.clock.monotonic0_s
    )


def _is_clock_stale(s: Situation) -> bool:
    return s.clock is not None and s.now_s > s.clock.valid_until_s


def _is_source_silent(s: Situation) -> bool:
    assert s.track is not None  # the row NO_TRACK comes before
    return s.track.is_silent(s.now_s)


def _is_track_ended(s: Situation) -> bool:
    assert s.track is not None  # the row NO_TRACK comes before
    return s.media_s >= s.track.end_s


def _has_new_epoch(s: Situation) -> bool:
    is_other = s.clock is not None and s.clock.epoch != s.state.epoch
    return is_other and s.state.mode in _MOVING


_TRIP, _RAMP = Reaction.TRIP, Reaction.RAMP
RULES: tuple[Rule, ...] = (
    # a person stops: Esc, the stop button, closing the window
    Rule(Cause.STOPPED, _TRIP, lambda s: s.supervision.request is Request.STOP),
    # a person presses a button on the grip
    Rule(Cause.GRIP_BUTTON, _TRIP, lambda s: s.hand.pressed != 0),
    # the player has died: its main thread has ended, or its line is closed
    Rule(Cause.PLAYER_GONE, _TRIP, lambda s: not s.supervision.is_player_alive),
    # the player's main thread has been silent for 1 s, and a force was on
    Rule(Cause.HEARTBEAT_LOST, _TRIP, _was_silent_under_force),
    Rule(Cause.UNPLUGGED, _TRIP, lambda s: s.supervision.is_device_gone),
    # the loop stalled for more than 50 ms (suspend, debugger, overload)
    Rule(Cause.TICK_LOST, _TRIP, lambda s: s.gap_s > GAP_TRIP_S and s.is_acting),
    # the device has not answered for 100 ms
    Rule(Cause.REPLY_LOST, _TRIP, _is_reply_lost),
    # 20 invalid answers in a row
    Rule(
        Cause.MALFORMED,
        _TRIP,
        lambda s: s.hand.malformed >= MALFORMED_TRIP and s.is_acting,
    ),
    # a number in the position is not finite; `step` checks clock and force
    Rule(Cause.NOT_FINITE, _TRIP, lambda s: not is_finite(s.hand.position_m)),
    # the grip was faster than 1 m/s twice: the hand has let go
    Rule(Cause.RUNAWAY, _TRIP, _is_runaway),
    # the grip is in the outer tenth of the workspace and pushed outward
    Rule(Cause.OUTSIDE, _TRIP, _is_outside),
    # the player ends or releases the device
    Rule(Cause.CLOSING, _RAMP, lambda s: s.supervision.request is Request.CLOSE),
    # the player's main thread has been silent for 150 ms
    Rule(
        Cause.HEARTBEAT_LATE,
        _RAMP,
        lambda s: s.now_s - s.supervision.heartbeat_s > HEARTBEAT_RAMP_S,
    ),
    # the guard has been silent for 250 ms
    Rule(
        Cause.GUARD_LOST,
        _RAMP,
        lambda s: s.now_s - s.supervision.guard_s > GUARD_RAMP_S,
    ),
    # the loop stalled for more than 20 ms
    Rule(Cause.TICK_LATE, _RAMP, lambda s: s.gap_s > GAP_RAMP_S and s.is_acting),
    # a command was older than 20 ms before it was sent; zero was sent instead
    Rule(Cause.COMMAND_STALE, _RAMP, lambda s: s.supervision.is_stale),
    # the device has not answered for 20 ms
    Rule(Cause.REPLY_LATE, _RAMP, _is_reply_late),
    Rule(Cause.NOT_HOMED, _RAMP, lambda s: not s.hand.is_homed),
    Rule(Cause.NO_TRACK, _RAMP, lambda s: s.clock is None or s.track is None),
    # the clip is paused, or has not begun
    Rule(Cause.PAUSED, _RAMP, _is_paused),
    # the player has not published its clock for 150 ms
    Rule(Cause.CLOCK_STALE, _RAMP, _is_clock_stale),
    # the source of a live force has not measured for 100 ms
    Rule(Cause.SOURCE_SILENT, _RAMP, _is_source_silent),
    Rule(Cause.TRACK_ENDED, _RAMP, _is_track_ended),
    # the clip was sought or looped, or has another force track
    Rule(Cause.SEEK, _RAMP, _has_new_epoch),
)


# Where a mode goes with each reaction. Leaving RAMPING and ENTERING needs a
# condition of its own on top, leaving TRIPPED needs a person: see `step`.
TRANSITIONS: dict[Mode, tuple[Mode, Mode, Mode]] = {
    # mode:        GO              RAMP          TRIP
    Mode.IDLE: (Mode.ENTERING, Mode.IDLE, Mode.TRIPPED),
    Mode.ENTERING: (Mode.ENTERING, Mode.RAMPING, Mode.TRIPPED),
    Mode.FOLLOWING: (Mode.FOLLOWING, Mode.RAMPING, Mode.TRIPPED),
    Mode.RAMPING: (Mode.RAMPING, Mode.RAMPING, Mode.TRIPPED),
    Mode.TRIPPED: (Mode.TRIPPED, Mode.TRIPPED, Mode.TRIPPED),
}


def assess(
    situation: Situation, rules: tuple[Rule, ...] = RULES
) -> tuple[Reaction, Cause]:
    """The reaction of the first rule that holds."""
    for cause, reaction, holds in rules:
        if holds(situation):
            return reaction, cause
    return Reaction.GO, Cause.NONE
