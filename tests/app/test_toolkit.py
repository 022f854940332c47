"""PySide6 6.12.0 loses references on Python < 3.12 until the process dies."""

import sys

from PySide6.QtCore import QObject, QTimer, Signal

CALLS = 5_000
SLACK = 500  # other code takes and gives back a few; the fault loses one a call


class Sender(QObject):
    sent = Signal(bool)


def test_emitting_keeps_the_references_to_true(qapp):
    sender = Sender()
    before = sys.getrefcount(True)
    for _ in range(CALLS):
        sender.sent.emit(True)
    assert abs(sys.getrefcount(True) - before) < SLACK


def test_void_calls_keep_the_references_to_none(qapp):
    timer = QTimer()
    before = sys.getrefcount(None)
    for _ in range(CALLS):
        timer.setInterval(10)
    assert abs(sys.getrefcount(None) - before) < SLACK
