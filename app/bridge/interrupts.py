"""Ctrl-C and other signals to end close the window in good order."""

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from types import FrameType

from hapticplayer.haptics.messages import ALARM_S, signal_alarm

NUMBERS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT)

_held: list[int] = []


def hold_signals() -> None:
    """Keep them waiting until `closing_on_signals` takes them.

    An interrupt in the middle of importing or building Qt's classes crashes the
    interpreter. Threads that start meanwhile never see these signals; those of numpy,
    which run already, may take one.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, NUMBERS)
    for number in NUMBERS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, lambda number, _frame: _held.append(number))


@contextlib.contextmanager
def closing_on_signals(close: Callable[[], None]) -> Iterator[None]:
    """Call `close` from the event loop after such a signal; it must only post work.

    Python runs its handlers between two steps of its own code: a byte on a socket wakes
    the event loop, so that there is such a step at once.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def handle(_number: int, _frame: FrameType | None) -> None:
        close()

    heeded = [n for n in NUMBERS if signal.getsignal(n) is not signal.SIG_IGN]  # nohup
    before = [signal.signal(number, handle) for number in heeded]
    with _awake():
        signal.pthread_sigmask(signal.SIG_UNBLOCK, NUMBERS)
        if _held:
            _held.clear()
            close()
        try:
            yield
        finally:
            for number, handler in zip(heeded, before, strict=True):
                signal.signal(number, handler)


@contextlib.contextmanager
def _awake() -> Iterator[None]:
    """Let every signal wake Qt's event loop, and the haptic loops stop by themselves."""
    from PySide6.QtCore import QSocketNotifier, QTimer  # only once signals are held

    alarm = signal_alarm()
    notifier = QSocketNotifier(alarm.read_end.fileno(), QSocketNotifier.Type.Read)
    later = QTimer(singleShot=True, interval=round(1000 * ALARM_S))

    def clear() -> None:
        alarm.clear()
        notifier.setEnabled(True)

    def wait() -> None:
        notifier.setEnabled(False)
        later.start()

    later.timeout.connect(clear)
    notifier.activated.connect(wait)
    before = signal.set_wakeup_fd(alarm.write_end.fileno(), warn_on_full_buffer=False)
    try:
        yield
    finally:
        signal.set_wakeup_fd(before)
        notifier.setEnabled(False)
        later.stop()
        alarm.clear()
