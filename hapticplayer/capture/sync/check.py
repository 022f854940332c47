"""Checks one stream for three usable pats, right after recording."""

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from hapticplayer.capture.sync.events import (
    Events,
    shock_events,
    shocks,
    sound_events,
    sound_onsets,
)
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.capture.sync.shifts import INTERVAL_S, unevenness
from hapticplayer.model import ImuLog

_RAREST = 24
_RARE_HZ = 0.25  # weaker pats are found by chance as easily
_MOST_CHANCE = 0.1
_GAPS_S = INTERVAL_S[1] - INTERVAL_S[0]


@dataclass(frozen=True, slots=True)
class StreamCheck:
    """The best three taps of one stream.

    Attributes:
        pats_s: their times on the stream's clock, or empty.
        rarity_hz: rate of events at least as strong as the weakest of them.
        chance: expected number of such triples without pats: events at random times (a
            Poisson process of that rate), each followed by two others in the intervals
            of pats. Of a log only; 0 for a sound, which has further cues.
    """

    pats_s: tuple[float, ...] = ()
    rarity_hz: float = 0.0
    chance: float = 0.0

    @property
    def is_usable(self) -> bool:
        """Whether they stand out from the other events."""
        is_rare = self.rarity_hz <= _RARE_HZ and self.chance <= _MOST_CHANCE
        return bool(self.pats_s) and is_rare

    def described(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {
            "pats_s": [round(at_s, 3) for at_s in self.pats_s],
            "rarity_hz": round(self.rarity_hz, 4),
            "chance": round(self.chance, 4),
            "is_usable": self.is_usable,
        }


def check_sound(sound: ClipSound) -> StreamCheck:
    """Find pats in a sound."""
    return _check(sound_events(sound_onsets(sound.samples, sound.rate_hz)))


def check_log(imu: ImuLog) -> StreamCheck:
    """Find pats in a log."""
    duration_s = float(imu.time_s[-1] - imu.time_s[0]) if len(imu.time_s) else 0.0
    return _check(shock_events(imu, shocks(imu)), duration_s)


def _check(events: Events, duration_s: float = 0.0) -> StreamCheck:
    rare = events.rarest(_RAREST)
    best, best_cost = StreamCheck(), np.inf
    for rows in combinations(range(len(rare)), 3):
        gaps_s = np.diff(rare.time_s[list(rows)])
        if not (INTERVAL_S[0] <= gaps_s.min() and gaps_s.max() <= INTERVAL_S[1]):
            continue
        rarity_hz = rare.rarity_hz[list(rows)]
        rhythm = float(unevenness(gaps_s))
        cost = 0.5 * rhythm**2 + 2.0 * float(np.log(rarity_hz).sum())
        if cost < best_cost:
            times = tuple(rare.time_s[list(rows)].tolist())
            rate_hz = float(rarity_hz.max())
            chance = duration_s * rate_hz * (rate_hz * _GAPS_S) ** 2
            best, best_cost = StreamCheck(times, rate_hz, chance), cost
    return best
