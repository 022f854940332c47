"""What fetches of force and clip share: a thread that asks until it is closed."""

import abc
import threading

from hapticplayer.clock import Clock
from hapticplayer.streaming.asking import Asking, Place


class Fetching(abc.ABC):
    """Asks in a thread of its own, which who inherits starts when it is ready.

    Args:
        place: of the stream.
        clock: of the machine.
        name: of the thread.
    """

    def __init__(self, place: Place, clock: Clock, name: str) -> None:
        self._asking = Asking(place, clock)
        self._news = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def close(self) -> None:
        """Ask for nothing any more; who waits for something is woken."""
        with self._news:
            self._is_closed = True
            self._news.notify_all()
        self._asking.close()
        self._thread.join()
        self._asking.drop()

    @abc.abstractmethod
    def _run(self) -> None:
        """Fetch until it is closed."""

    def _wait(self, duration_s: float) -> None:
        """Wait, unless there is something else to fetch."""
        with self._news:
            if not self._is_closed:
                self._news.wait(duration_s)
