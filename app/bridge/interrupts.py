"""Ctrl-C and SIGTERM close the window in good order."""

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType

NUMBERS = (signal.SIGINT, signal.SIGTERM)


def hold_signals() -> None:
    """Keep SIGINT and SIGTERM waiting until `closing_on_signals` takes them.

    An interrupt in the middle of importing or building Qt's classes crashes the
    interpreter. Threads that start meanwhile never see these signals.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, NUMBERS)


@contextlib.contextmanager
def closing_on_signals(close: Callable[[], None]) -> Iterator[None]:
    """Call `close` from the event loop after SIGINT or SIGTERM.

    Python runs its handlers between two steps of its own code: the pump gives it
    the chance at least every 25 ms.

    Args:
        close: called inside whatever step was running; it must only post work.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def handle(_number: int, _frame: FrameType | None) -> None:
        close()

    before = [signal.signal(number, handle) for number in NUMBERS]
    signal.pthread_sigmask(signal.SIG_UNBLOCK, NUMBERS)
    try:
        yield
    finally:
        for number, handler in zip(NUMBERS, before, strict=True):
            signal.signal(number, handler)
