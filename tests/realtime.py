"""A real-time test that fails is judged by a witness of the machine.

Was the machine at fault, then the test runs again alone, at most twice, and the summary
names it; was it not, the test fails at once.
"""

import contextlib
import fcntl
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from _pytest.runner import pytest_runtest_teardown, runtestprotocol

from hapticplayer.haptics.contract import GAP_RAMP_S, HEARTBEAT_RAMP_S
from tools.witness import Seen, Witness, machine_witness

MOST_RERUNS = 2
SLEEP_S = 0.005
STALL_LIMIT_S = GAP_RAMP_S / 2
"""Of one core; the loop ramps when it is late by twice as much."""
WAIT_LIMIT_S = HEARTBEAT_RAMP_S / 2
"""Of one thread that is ready, within the time after which a silent window is a fault."""
RERUN = "rerun"
MISTAKES = ("NameError", "ImportError", "ModuleNotFoundError", "SyntaxError")
"""Which no machine is to blame for."""
LOCKS = (Path(__file__), Path(__file__).with_name("conftest.py"))
"""Files that all processes of a run have open, and nobody writes."""


def plain_witness() -> AbstractContextManager[Witness]:
    """A witness that costs 1 % of each core."""
    return machine_witness(SLEEP_S)


def fault_of(seen: Seen) -> str:
    """What the machine took that a real-time test needs, "" for nothing."""
    stall_s = max((late_s for core in seen.stalls for _, late_s in core), default=0.0)
    wait_s = max(
        (seen.waited_s(end_s - HEARTBEAT_RAMP_S, end_s) for _, end_s, _ in seen.waits),
        default=0.0,
    )
    if stall_s > STALL_LIMIT_S:
        return f"a core stalled for {1e3 * stall_s:.0f} ms"
    if wait_s > WAIT_LIMIT_S:
        return (
            f"a thread had no core for {1e3 * wait_s:.0f} of "
            f"{1e3 * HEARTBEAT_RAMP_S:.0f} ms"
        )
    return ""


class Room:
    """Where real-time tests of all processes are at once, or one of them alone."""

    def __init__(self, door: Path, inside: Path) -> None:
        self._door, self._inside = door.open(), inside.open()

    @contextlib.contextmanager
    def entered(self, *, alone: bool) -> Iterator[None]:
        """Who waits to be alone keeps the door closed until then."""
        fcntl.flock(self._door, fcntl.LOCK_EX)
        fcntl.flock(self._inside, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        fcntl.flock(self._door, fcntl.LOCK_UN)
        try:
            yield
        finally:
            fcntl.flock(self._inside, fcntl.LOCK_UN)

    def close(self) -> None:
        self._door.close()
        self._inside.close()


class RealTime:
    """The plugin that runs the tests marked `realtime`.

    Attributes:
        reruns: test and reason, of all processes.
    """

    def __init__(
        self,
        judge: Callable[[Seen], str] = fault_of,
        locks: tuple[Path, Path] = LOCKS,
        watch: Callable[[], AbstractContextManager[Any]] = plain_witness,
    ) -> None:
        self._judge, self._locks, self._watch = judge, locks, watch
        self._stack = contextlib.ExitStack()
        self._witness: Any = None
        self.reruns: list[tuple[str, str]] = []

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_protocol(self, item: Any, nextitem: Any) -> bool | None:
        """Run a real-time test; again, alone, where it failed with the machine."""
        if item.get_closest_marker("realtime") is None:
            return None
        item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
        reruns = []
        reports, seen = self._attempt(item, nextitem, alone=False)
        while (failed := failure(reports)) and (fault := self._judge(seen)):
            if reason(failed).startswith(MISTAKES) or len(reruns) == MOST_RERUNS:
                break
            reruns.append((RERUN, f"{fault}: {reason(failed)}"))
            # what the module and the session have made may be why, and is made anew
            pytest_runtest_teardown(item, None)
            reports, seen = self._attempt(item, nextitem, alone=True)
        if failed:
            failed.sections.append(("the machine", fault or "was not at fault"))
        reports[-1].user_properties += reruns
        for report in reports:
            item.ihook.pytest_runtest_logreport(report=report)
        item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
        return True

    def _attempt(self, item: Any, nextitem: Any, *, alone: bool) -> tuple[Any, Seen]:
        if self._witness is None:
            self._witness = self._stack.enter_context(self._watch())
            self._room = Room(*self._locks)
            self._stack.callback(self._room.close)
        with self._room.entered(alone=alone):
            self._witness.forget()
            reports = runtestprotocol(item, nextitem=nextitem, log=False)
            return reports, self._witness.seen()

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Collect the reruns, which come from other processes, too."""
        self.reruns += [
            (report.nodeid, text)
            for name, text in report.user_properties
            if name == RERUN and report.when == "teardown"
        ]

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        """Count and name the reruns."""
        if self.reruns:
            title = f"{len(self.reruns)} reruns because the machine was at fault"
            terminalreporter.section(title)
        for test, text in self.reruns:
            terminalreporter.line(f"{test}: {text}")

    def pytest_unconfigure(self) -> None:
        """End the witness."""
        self._stack.close()


def failure(reports: Any) -> Any:
    """The report of the first phase that failed, None without."""
    return next((one for one in reports if one.failed), None)


def reason(failed: Any) -> str:
    """The last line that explains a failure."""
    crash = getattr(failed.longrepr, "reprcrash", None)
    return str(crash.message if crash else failed.longrepr).partition("\n")[0]
