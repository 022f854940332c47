"""The one gateway through which a problem reaches the person at the window."""

import sys
import threading
import traceback
from collections import deque
from collections.abc import Callable
from types import TracebackType
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QTime

from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.extension import take_problems

IsOver = Callable[[], bool]
"""Whether the cause of a message is gone; it is hidden then."""
Show = Callable[[str, IsOver | None], None]
_MANY, _KEPT = 50, 200
"""Different places that may fail before the terminal stays quiet."""


class Noted(NamedTuple):
    """Something that was said, or a fault; `at` is the time of day."""

    at: str
    what: str | BaseException


class Attempts:
    """What ends a complaint that has no other end: the same is tried again."""

    def __init__(self) -> None:
        self._count = 0

    def begin(self) -> IsOver:
        """Begin one; returns whether another has begun since."""
        self._count += 1
        mine = self._count
        return lambda: self._count != mine


class ErrorGateway:
    """Tells a person what went wrong, after the force is at rest where it must be.

    What the engine refused (`HapticPlayerError`) is a sentence to show. Anything else
    is a fault of this program: the force stops and the playback pauses first (`halt`,
    which must not raise). `has_report` means that the menu Help saves what is noted.
    """

    def __init__(
        self, show: Show, halt: Callable[[], None], *, has_report: bool = False
    ) -> None:
        self._show = show
        self._halt = halt
        self._has_report = has_report
        self._known: set[str] = set()
        self.noted: deque[Noted] = deque(maxlen=_KEPT)
        self._from_threads: deque[BaseException] = deque(maxlen=16)
        self._hooks_before = (sys.excepthook, threading.excepthook)

    def install(self) -> None:
        """Receive what nobody caught, in slots and in threads."""
        self._hooks_before = (sys.excepthook, threading.excepthook)
        sys.excepthook = self._uncaught
        threading.excepthook = self._uncaught_in_thread

    def uninstall(self) -> None:
        sys.excepthook, threading.excepthook = self._hooks_before

    def report(self, problem: BaseException, is_over: IsOver | None = None) -> None:
        """Show a problem until it is over; on the window's thread."""
        if isinstance(problem, HapticPlayerError):
            self._keep(message_of(problem))
            self._show(message_of(problem), is_over)
        else:
            self._unexpected(problem)

    @staticmethod
    def note(problem: BaseException) -> None:
        """Write the details of a fault on the terminal."""
        sys.stderr.write("".join(traceback.format_exception(problem)))

    def poll(self) -> None:
        """Report what other threads left here, and broken extensions."""
        while self._from_threads:
            self.report(self._from_threads.popleft())
        for message in take_problems():
            self._keep(message)
            self._show(message, None)

    def _keep(self, what: str | BaseException) -> None:
        """Remember it for a report of a problem."""
        self.noted.append(Noted(QTime.currentTime().toString("HH:mm:ss"), what))

    def _unexpected(self, problem: BaseException) -> None:
        self._halt()
        where = "".join(traceback.format_tb(problem.__traceback__)[-1:])
        place = f"{type(problem).__name__} {where}"
        if place in self._known or len(self._known) >= _MANY:
            return  # a fault that returns with each frame is reported once
        self._known.add(place)
        self._keep(problem)
        self.note(problem)
        text = QCoreApplication.translate(
            "ErrorGateway",
            "Internal error ({kind}: {text}). The force was stopped and "
            "playback paused.",
        ).format(kind=type(problem).__name__, text=problem)
        if self._has_report:
            more = QCoreApplication.translate(
                "ErrorGateway", "Help > Report a problem saves the details."
            )
        else:
            more = QCoreApplication.translate(
                "ErrorGateway", "See the terminal for details."
            )
        self._show(f"{text} {more}", None)

    def _uncaught(
        self,
        kind: type[BaseException],
        problem: BaseException,
        trace: TracebackType | None,
    ) -> None:
        if issubclass(kind, Exception):
            self.report(problem.with_traceback(trace))
        else:
            self._hooks_before[0](kind, problem, trace)

    def _uncaught_in_thread(self, args: threading.ExceptHookArgs) -> None:
        if args.exc_value is not None:
            self._from_threads.append(args.exc_value)
