"""What the loop did against its will, and whether somebody had asked for it."""

import bisect
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.playback.player import Player

# What a machine that is too busy can bring about, however good the program is.
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
AT_THE_END = frozenset({Cause.TRACK_ENDED, Cause.PAUSED})
END_S = 0.1
_ACTING = (Mode.ENTERING, Mode.FOLLOWING)


@dataclass(frozen=True, slots=True)
class Reaction:
    """One RAMP or TRIP.

    Attributes:
        monotonic_s: of its first tick.
        cause: what the loop says.
        is_trip: whether a person has to re-arm.
        had_force: whether a force was on the hand, or about to be.
        by: what the script did to cause it, "" when it did nothing.
        during: what the script was doing at that time.
    """

    monotonic_s: float
    cause: Cause
    is_trip: bool
    had_force: bool
    by: str
    during: str


@dataclass
class Watch:
    """Reads all ticks of all devices of a player, and judges what they show.

    Call `look` at least every 10 s, and before a device is let go of.

    Attributes:
        grace_s: a reaction begins at most so long after the step that causes it.
        expected: what the script did: when, its name, what may come of it.
        doing: when the script began which thing.
        reactions: all so far.
        modes: ticks in each mode.
        lost: ticks that nobody has seen.
    """

    player: Player
    grace_s: float
    expected: list[tuple[float, str, frozenset[Cause]]] = field(default_factory=list)
    doing: list[tuple[float, str]] = field(default_factory=list)
    reactions: list[Reaction] = field(default_factory=list)
    modes: Counter[str] = field(default_factory=Counter)
    lost: int = 0

    def __post_init__(self) -> None:
        self._begin()

    def _begin(self) -> None:
        self._loop_pid = self.player.snapshot().loop_pid
        self._seen_s = float("-inf")
        self._mode, self._cause = Mode.IDLE, Cause.NONE
        self._has_begun = False
        self._lost = 0

    def expect(self, at_s: float, name: str, *causes: Cause) -> None:
        """Note that the script does something that the loop has to react to."""
        self.expected.append((at_s, name, frozenset(causes)))

    def look(self) -> None:
        """Judge what has come since the last call."""
        if self.player.snapshot().loop_pid != self._loop_pid:
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
        turns = (np.diff(modes.astype(int)) != 0) | (np.diff(causes.astype(int)) != 0)
        for row in np.flatnonzero(turns):
            before, after = Mode(int(modes[row])), Mode(int(modes[row + 1]))
            cause = Cause(int(causes[row + 1]))
            had_force = before in _ACTING
            is_trip = after is Mode.TRIPPED and before is not Mode.TRIPPED
            is_new = causes[row] != cause
            is_silent = is_new and cause in OF_LOAD and self._has_begun
            # a device that begins waits for its guard, its homing and its track
            self._has_begun |= cause in (Cause.NONE, Cause.PAUSED)
            if cause and (is_trip or had_force or is_silent):
                at_s, media_s = (
                    float(ticks[n][row]) for n in ("monotonic_s", "media_s")
                )
                by = self._explained(cause, at_s, media_s)
                during = self._done_at(at_s)
                self.reactions.append(
                    Reaction(at_s, cause, is_trip, had_force, by, during)
                )
        self._mode, self._cause = Mode(int(modes[-1])), Cause(int(causes[-1]))

    def _explained(self, cause: Cause, at_s: float, media_s: float) -> str:
        for since_s, name, causes in reversed(self.expected):
            if since_s <= at_s <= since_s + self.grace_s and cause in causes:
                return name
        source = self.player.snapshot().source
        end_s = source.clip.duration_s if source else float("inf")
        return "end" if cause in AT_THE_END and media_s > end_s - END_S else ""

    def _done_at(self, at_s: float) -> str:
        row = bisect.bisect(self.doing, (at_s, "")) - 1
        return self.doing[row][1] if row >= 0 else ""

    def nuisances(self) -> list[Reaction]:
        """Return what nobody has asked for."""
        return [reaction for reaction in self.reactions if not reaction.by]

    def counts(self, reactions: Iterable[Reaction]) -> dict[str, int]:
        """Return how often each cause came, and what the script had done."""
        return dict(
            Counter(
                f"{'TRIP' if r.is_trip else 'RAMP'} {r.cause.name}"
                + ("" if r.had_force else " (no force)")
                + (f" by {r.by}" if r.by else "")
                for r in reactions
            )
        )
