"""Ctrl-C and SIGTERM close the window in good order."""

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType


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

    numbers = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, handle) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before, strict=True):
            signal.signal(number, handler)
