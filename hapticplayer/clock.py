"""The machine's clocks, and the only module that reads them.

Everything else takes a `Clock` as an argument, so that tests run on a virtual
one. All times are seconds of CLOCK_MONOTONIC as float64: after a year of
uptime its resolution is still 4 ns.
"""

import time
from typing import Protocol

_LOOKS = 5


class Clock(Protocol):
    """Monotonic time and waiting."""

    def now_s(self) -> float:
        """Return seconds of the monotonic clock."""
        ...

    def sleep_until(self, deadline_s: float) -> None:
        """Return at `deadline_s` or, if it has passed, at once."""
        ...


class Poll(Protocol):
    """As `select.poll` has it."""

    def poll(self, timeout_ms: float, /) -> object: ...


class WaitingClock(Clock, Protocol):
    """A clock whose waiting can be ended."""

    def wait(self, poll: Poll, deadline_s: float) -> None:
        """Return at `deadline_s`, or before, when something has come."""
        ...


class SystemClock:
    """CLOCK_MONOTONIC of this machine, shared by all its processes."""

    now_s = staticmethod(time.monotonic)

    @staticmethod
    def sleep_until(deadline_s: float) -> None:
        """Sleep with clock_nanosleep; coming back takes 14 to 28 us with FIFO, the median."""
        remaining_s = deadline_s - time.monotonic()
        if remaining_s > 0.0:
            time.sleep(remaining_s)

    @staticmethod
    def wait(poll: Poll, deadline_s: float) -> None:
        poll.poll(max(0.0, 1e3 * (deadline_s - time.monotonic())))


class ManualClock:
    """A clock that moves only when asked to; for tests and simulations."""

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

    def wait(self, _poll: Poll, deadline_s: float) -> None:
        self.sleep_until(deadline_s)


def utc_now_iso(timespec: str = "seconds") -> str:
    """Wall-clock time for provenance (ISO 8601, UTC); never for timing."""
    import datetime as dt  # the loop and its guard need none

    return dt.datetime.now(tz=dt.UTC).isoformat(timespec=timespec)


def is_time(utc: str) -> bool:
    """Whether a text is a time with its zone, as `utc_now_iso` writes it."""
    import datetime as dt

    try:
        return dt.datetime.fromisoformat(utc).tzinfo is not None
    except ValueError:
        return False


def realtime_minus_monotonic_s() -> float:
    """The offset of the kernel's stamps, such as SO_TIMESTAMPNS.

    The closest of some looks: another process may run between two of them for long.
    """
    looks = [(time.monotonic(), time.time(), time.monotonic()) for _ in range(_LOOKS)]
    before_s, wall_s, after_s = min(looks, key=lambda look: look[2] - look[0])
    return wall_s - 0.5 * (before_s + after_s)
