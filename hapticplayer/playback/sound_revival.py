"""Opens the sound output again after it was lost, while picture and force go on.

PortAudio says nothing when its server dies; opening again can take seconds. So a thread
of its own lets go of the old output and tries until there is a new one.
"""

import threading
from collections.abc import Callable

from hapticplayer.playback.audio import AudioOut

LOST_AFTER_S = 1.0
"""Without a report for so long, an output is lost; a busy computer is back sooner."""
RETRY_S = 0.5


class SoundRevival:
    """Waits for a new output.

    Args:
        make: opens one; OSError means that there is none yet.
    """

    def __init__(self, make: Callable[[], AudioOut]) -> None:
        self._make = make
        self._lock = threading.Lock()
        self._found: AudioOut | None = None
        self._is_over = threading.Event()
        self._is_over.set()

    @property
    def is_trying(self) -> bool:
        """Whether a lost output is not replaced yet."""
        return not self._is_over.is_set()

    def begin(self, lost: AudioOut) -> None:
        """Let go of a lost output and look for another."""
        self.cancel()
        self._is_over = threading.Event()
        arguments = (lost, self._is_over)
        threading.Thread(
            target=self._run, args=arguments, name="sound-revival", daemon=True
        ).start()

    def take(self) -> AudioOut | None:
        """Return the new output once, None before."""
        with self._lock:
            found, self._found = self._found, None
            return found

    def cancel(self) -> None:
        """Look no further; never waits."""
        with self._lock:
            self._is_over.set()
            found, self._found = self._found, None
        if found is not None:
            found.close()

    def _run(self, lost: AudioOut, is_over: threading.Event) -> None:
        lost.close()
        while not is_over.wait(RETRY_S):
            try:
                found = self._make()
            except OSError:
                continue
            with self._lock:
                if not is_over.is_set():
                    is_over.set()
                    self._found = found
                    return
            found.close()
