"""Says when force and picture, or force and sound, drift so far apart that it is felt.

People do not notice a touch that comes up to 50 ms after what they see, but notice
one that comes 15 ms before it (Di Luca & Mahnan 2019).
"""

import statistics
from collections import deque

EARLY_MS, LATE_MS = -15.0, 50.0
BACK_MS = 5.0  # so far inside the limits an alarm ends
LEAST_EVENTS = 12  # half a second of pictures or of notes of the sound
HOPE = "the computer may be too busy; close other programs"


class SyncAlarm:
    """Watches one difference.

    Args:
        against: what the force is compared with, for people.

    Attributes:
        is_on: whether the median of the last half second lies outside the limits.
        p50_ms: that median; 0 before there is one.
    """

    def __init__(self, against: str) -> None:
        self.is_on = False
        self.p50_ms = 0.0
        self._against = against
        self._last_ms: deque[float] = deque(maxlen=LEAST_EVENTS)

    def add(self, difference_ms: list[float]) -> bool:
        """Note how much later the force came; True when the alarm goes on or off."""
        self._last_ms.extend(difference_ms)
        if len(self._last_ms) < LEAST_EVENTS:
            return False
        self.p50_ms = statistics.median(self._last_ms)
        margin_ms = BACK_MS if self.is_on else 0.0
        was_on = self.is_on
        inside = EARLY_MS + margin_ms <= self.p50_ms <= LATE_MS - margin_ms
        self.is_on = not inside
        return self.is_on is not was_on

    def sentence(self) -> str:
        """Return the alarm in words."""
        when = "before" if self.p50_ms < 0.0 else "after"
        return f"the force comes {abs(self.p50_ms):.0f} ms {when} the {self._against}: {HOPE}"
