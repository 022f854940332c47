"""Collects garbage in small portions on the window's thread, never in the middle of work.

Python's own full collections took 50 to 150 ms here, at any moment and in any thread:
the window stood still, and objects of Qt were freed where they must not be.
"""

import gc

from PySide6.QtCore import QObject, QTimer

from hapticplayer.media.memory import give_back_freed_memory

PERIOD_MS = 500
FULL_EVERY = 60  # portions
COUNTED_EVERY = 10
"""Portions: to count what has outlived one takes 4 ms."""
GROWN, MOST = 10_000, 30_000
"""Objects: so many more than at the last full collection ask for another; of so many
that have outlived one, in 15 ms, nothing is expected any more."""

_YOUNG, _OLD = 1, 2


class Collector(QObject):
    """Takes Python's garbage collector over, from `begin` to `end`.

    What there is at the beginning (modules, mostly) is not looked at any more.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._portions = self._outlived = 0
        self._timer = QTimer(self, interval=PERIOD_MS)
        self._timer.timeout.connect(self.collect)

    def begin(self) -> None:
        """Take over."""
        gc.disable()
        gc.freeze()
        self._timer.start()

    def collect(self) -> None:
        """Collect what has died young; now and then everything, and give memory back."""
        gc.collect(_YOUNG)
        self._portions += 1
        is_due = self._portions % FULL_EVERY == 0
        is_counted = self._portions % COUNTED_EVERY == 0
        if is_due or (is_counted and _old() > self._outlived + GROWN):
            gc.collect(_OLD)
            self._outlived = _old()
            give_back_freed_memory()
        if self._outlived > MOST:
            gc.freeze()
            self._outlived = 0

    def end(self) -> None:
        """Leave it to Python again."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()


def _old() -> int:
    return len(gc.get_objects(_OLD))
