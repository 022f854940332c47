"""The thread in which force and clip of a stream are fetched, until it is closed."""

import abc
import threading

from hapticplayer.clock import Clock
from hapticplayer.streaming.client import StreamAddress, StreamClient


class FetchThread(abc.ABC):
    """Fetches in a thread of its own; a subclass starts it when it is ready.

    Args:
        address: of the stream.
        clock: of the machine.
        name: of the thread.
    """

    def __init__(self, address: StreamAddress, clock: Clock, name: str) -> None:
        self._client = StreamClient(address, clock)
        self._news = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def close(self) -> None:
        """Ask for nothing any more; who waits for something is woken."""
        with self._news:
            self._is_closed = True
            self._news.notify_all()
        self._client.close()
        self._thread.join()
        self._client.drop()

    @abc.abstractmethod
    def _run(self) -> None:
        """Fetch until it is closed."""

    def _wait(self, duration_s: float) -> None:
        """Wait, unless there is something else to fetch."""
        with self._news:
            if not self._is_closed:
                self._news.wait(duration_s)
