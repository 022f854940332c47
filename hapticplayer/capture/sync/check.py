"""Says of one stream whether three pats stand out of it, right after recording."""

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
from hapticplayer.capture.sync.shifts import INTERVAL_S
from hapticplayer.capture.sync.synchronize import Sound
from hapticplayer.model import ImuLog

_RAREST = 24
_RARE_HZ = 0.25  # weaker pats are found by chance as easily
_RHYTHM = 0.16


@dataclass(frozen=True, slots=True)
class StreamCheck:
    """The best three knocks of one stream.

    Attributes:
        pats_s: their times on the stream's clock; empty without any.
        rarity_hz: how often events as strong as the weakest of them come.
    """

    pats_s: tuple[float, ...] = ()
    rarity_hz: float = 0.0

    @property
    def is_usable(self) -> bool:
        """Whether they stand out enough to be told from what else is there."""
        return bool(self.pats_s) and self.rarity_hz <= _RARE_HZ

    def described(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {
            "pats_s": [round(at_s, 3) for at_s in self.pats_s],
            "rarity_hz": round(self.rarity_hz, 4),
            "is_usable": self.is_usable,
        }


def check_sound(sound: Sound) -> StreamCheck:
    """Look for pats in a sound."""
    return _check(sound_events(sound_onsets(sound.samples, sound.rate_hz)))


def check_log(imu: ImuLog) -> StreamCheck:
    """Look for pats in a log."""
    return _check(shock_events(imu, shocks(imu)))


def _check(events: Events) -> StreamCheck:
    rare = events.rarest(_RAREST)
    best, best_cost = StreamCheck(), np.inf
    for rows in combinations(range(len(rare)), 3):
        gaps_s = np.diff(rare.time_s[list(rows)])
        if not (INTERVAL_S[0] <= gaps_s.min() and gaps_s.max() <= INTERVAL_S[1]):
            continue
        rhythm = float(np.log(gaps_s[1] / gaps_s[0])) / _RHYTHM
        rarity_hz = rare.rarity_hz[list(rows)]
        cost = 0.5 * rhythm**2 + 2.0 * float(np.log(rarity_hz).sum())
        if cost < best_cost:
            times = tuple(rare.time_s[list(rows)].tolist())
            best, best_cost = StreamCheck(times, float(rarity_hz.max())), cost
    return best
