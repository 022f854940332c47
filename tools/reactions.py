"""Reactions of the haptic loop that no action of a person explains."""

from collections import Counter
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.playback.player import Player

# What a machine that is too busy can cause, however good the program is.
OF_LOAD = frozenset(
    {
        Cause.CLOCK_STALE,
        Cause.HEARTBEAT_LATE,
        Cause.HEARTBEAT_LOST,
        Cause.REPLY_LATE,
        Cause.REPLY_LOST,
        Cause.TICK_LATE,
        Cause.TICK_LOST,
        Cause.COMMAND_STALE,
        Cause.GUARD_LOST,
    }
)
AT_THE_END, END_S = frozenset({Cause.TRACK_ENDED, Cause.PAUSED}), 0.1
_ACTING = (Mode.ENTERING, Mode.FOLLOWING)


@dataclass(frozen=True, slots=True)
class Reaction:
    """One RAMP or TRIP.

    Attributes:
        monotonic_s: of its first tick.
        cause: that the loop gives.
        is_trip: whether a person has to re-arm.
        had_force: whether a force was on the hand, or about to be.
        by: the action that caused it, "" for none.
    """

    monotonic_s: float
    cause: Cause
    is_trip: bool
    had_force: bool
    by: str


@dataclass
class Watch:
    """Reads all ticks of all devices of a player, and finds the reactions in them.

    Call `read` at least every 10 s, and before a device is let go of.

    Attributes:
        grace_s: a reaction begins at most so long after the action that causes it.
        actions: time, name and allowed causes of what the person did.
        reactions: all so far.
        modes: ticks in each mode.
        lost: ticks that were not seen.
    """

    player: Player
    grace_s: float
    actions: list[tuple[float, str, frozenset[Cause]]] = field(default_factory=list)
    reactions: list[Reaction] = field(default_factory=list)
    modes: Counter[str] = field(default_factory=Counter)
    lost: int = 0

    def __post_init__(self) -> None:
        self._begin()

    def _begin(self) -> None:
        self._loop_pid = self.player.snapshot().leading.loop_pid
        self._seen_s = float("-inf")
        self._mode, self._cause = Mode.IDLE, Cause.NONE
        self._has_begun = False
        self._lost = 0

    def expect(self, at_s: float, name: str, *causes: Cause) -> None:
        """Note an action that the loop has to react to."""
        self.actions.append((at_s, name, frozenset(causes)))

    def read(self) -> None:
        """Judge the ticks since the last call."""
        if self.player.snapshot().leading.loop_pid != self._loop_pid:
            self._begin()
        lost = self.player.measurements().ticks_lost
        self.lost += lost - self._lost
        self._lost = lost
        ticks = self.player.ticks_since(self._seen_s)
        ticks = ticks[ticks["monotonic_s"] > self._seen_s]
        if not len(ticks):
            return
        self._seen_s = float(ticks["monotonic_s"][-1])
        for mode in Mode:
            self.modes[mode.name] += int(np.count_nonzero(ticks["mode"] == mode))
        self._judge(ticks)

    def _judge(self, ticks: Any) -> None:
        modes = np.concatenate([[self._mode], ticks["mode"]])
        causes = np.concatenate([[self._cause], ticks["cause"]])
        changes = (np.diff(modes.astype(int)) != 0) | (np.diff(causes.astype(int)) != 0)
        for row in np.flatnonzero(changes):
            before, after = Mode(int(modes[row])), Mode(int(modes[row + 1]))
            cause = Cause(int(causes[row + 1]))
            had_force = before in _ACTING
            is_trip = after is Mode.TRIPPED and before is not Mode.TRIPPED
            is_new = causes[row] != cause and cause in OF_LOAD and self._has_begun
            # a device that begins waits for its guard, its homing and its track
            self._has_begun |= cause in (Cause.NONE, Cause.PAUSED)
            if cause and (is_trip or had_force or is_new):
                at_s = float(ticks["monotonic_s"][row])
                by = self._explained(cause, at_s, float(ticks["media_s"][row]))
                self.reactions.append(Reaction(at_s, cause, is_trip, had_force, by))
        self._mode, self._cause = Mode(int(modes[-1])), Cause(int(causes[-1]))

    def _explained(self, cause: Cause, at_s: float, media_s: float) -> str:
        for since_s, name, causes in reversed(self.actions):
            if since_s <= at_s <= since_s + self.grace_s and cause in causes:
                return name
        source = self.player.snapshot().source
        end_s = source.clip.duration_s if source else float("inf")
        return "end" if cause in AT_THE_END and media_s > end_s - END_S else ""
