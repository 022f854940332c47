"""The machine's clocks, and the only module that reads them.

Everything else takes a `Clock` as an argument, so that tests run on a virtual
one. All times are seconds of CLOCK_MONOTONIC as float64: after a year of
uptime its resolution is still 4 ns.
"""

import datetime as dt
import time
from typing import Protocol


class Clock(Protocol):
    """Monotonic time and waiting."""

    def now_s(self) -> float:
        """Return seconds of the monotonic clock."""
        ...

    def sleep_until(self, deadline_s: float) -> None:
        """Return at `deadline_s` or, if it has passed, at once."""
        ...


# What coming back from a sleep is allowed for: 20 us is the least that kernel and
# interpreter were seen to take, each us more may cost 0.1 % of a core at 1 kHz.
LEAST_WAKE_UP_S, MOST_WAKE_UP_S = 20e-6, 50e-6
# One wake-up in a hundred may come too late: the quantile to which these steps lead.
_LATER_S, _SOONER_S = 1e-6, 1e-8


class SystemClock:
    """CLOCK_MONOTONIC of this machine, shared by all its processes."""

    now_s = staticmethod(time.monotonic)

    def __init__(self) -> None:
        self._wake_up_s = LEAST_WAKE_UP_S

    def sleep_until(self, deadline_s: float) -> None:
        """Sleep with clock_nanosleep until shortly before the deadline, then spin.

        How shortly follows what this machine's wake-ups take, between two bounds: a
        quiet one costs no more than it must.
        """
        remaining_s = deadline_s - time.monotonic()
        if remaining_s > self._wake_up_s:
            time.sleep(remaining_s - self._wake_up_s)
            if time.monotonic() > deadline_s:
                self._wake_up_s = min(self._wake_up_s + _LATER_S, MOST_WAKE_UP_S)
                return
            self._wake_up_s = max(self._wake_up_s - _SOONER_S, LEAST_WAKE_UP_S)
        while time.monotonic() < deadline_s:
            pass


class ManualClock:
    """A clock that only moves when it is told to; for tests and simulations."""

    def __init__(self, start_s: float = 1000.0) -> None:
        self._now_s = start_s

    def now_s(self) -> float:
        """Return the virtual time, s."""
        return self._now_s

    def advance(self, duration_s: float) -> None:
        """Move on by `duration_s` >= 0."""
        if duration_s < 0.0:
            raise ValueError("a monotonic clock does not run backwards")
        self._now_s += duration_s

    def sleep_until(self, deadline_s: float) -> None:
        """Leap to the deadline."""
        self._now_s = max(self._now_s, deadline_s)


def utc_now_iso(timespec: str = "seconds") -> str:
    """Wall-clock time for provenance (ISO 8601, UTC); never for timing."""
    return dt.datetime.now(tz=dt.UTC).isoformat(timespec=timespec)
