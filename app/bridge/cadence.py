"""How often something is drawn."""

EARLY = 0.3
"""Of a period. Who asks once for each picture of 30 a second, a little early or late,
is not to be sent away every other time."""


class Cadence:
    """Says when it is time again; a late start does not lead to a burst.

    Args:
        rate_hz: times in a second.
    """

    def __init__(self, rate_hz: float) -> None:
        self._period_s = 1.0 / rate_hz
        self._next_s = float("-inf")

    def is_due(self, now_s: float) -> bool:
        """Whether a period has passed; starts the next one if so."""
        if now_s < self._next_s - EARLY * self._period_s:
            return False
        on_time_s = self._next_s + self._period_s
        self._next_s = on_time_s if on_time_s > now_s else now_s + self._period_s
        return True

    def reset(self) -> None:
        """Be due at once."""
        self._next_s = float("-inf")
