"""Ctrl-C reaches the haptic loops at once, and the window in good order."""

import os
import signal
import socket
import threading

import pytest
from PySide6.QtCore import QEventLoop, QTimer

from app.bridge.interrupts import NUMBERS, closing_on_signals, hold_signals
from hapticplayer.haptics.messages import signal_alarm


def heard():
    """Return the signals that a loop would hear now."""
    try:
        return signal_alarm().read_end.recv(100, socket.MSG_PEEK)
    except BlockingIOError:
        return b""


@pytest.mark.parametrize("number", NUMBERS)
def test_loops_hear_of_a_signal_before_the_window_closes(qapp, number):
    loop, seen = QEventLoop(), []

    def close():
        seen.append(heard())
        QTimer.singleShot(0, loop.quit)

    with closing_on_signals(close):
        threading.Timer(0.05, os.kill, (os.getpid(), number)).start()
        loop.exec()
        assert seen == [bytes([number])]
        assert heard() == bytes([number])
    assert heard() == b""


def test_a_signal_that_another_thread_takes_is_held(qapp):
    over, closed = threading.Event(), []
    threading.Thread(target=over.wait).start()
    handlers = [signal.getsignal(number) for number in NUMBERS]
    try:
        hold_signals()
        os.kill(os.getpid(), signal.SIGINT)  # not to this thread, which blocks it
        for _ in range(1000):
            os.sched_yield()
        with closing_on_signals(lambda: closed.append(True)):
            while not closed:
                os.sched_yield()
    finally:
        over.set()
        for number, handler in zip(NUMBERS, handlers, strict=True):
            signal.signal(number, handler)


def test_the_alarm_ends_and_sounds_again(qapp):
    loop, closed = QEventLoop(), []
    watch = QTimer(interval=5)
    watch.timeout.connect(lambda: heard() or loop.quit())
    with closing_on_signals(lambda: closed.append(heard())):
        for turn in (1, 2):
            os.kill(os.getpid(), signal.SIGINT)
            assert closed == [b"\x02"] * turn
            watch.start()
            loop.exec()
            watch.stop()
            assert heard() == b""
