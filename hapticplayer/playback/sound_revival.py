"""Opens the sound output again after it was lost, while picture and force go on.

PortAudio says nothing when its server dies; opening again can take seconds. So a thread
of its own lets go of the old output and tries until there is a new one.
"""

import threading
from collections.abc import Callable

from hapticplayer.playback.audio import AudioOut, AudioRing
from hapticplayer.playback.clock import MediaClock, Source

LOST_AFTER_S = 1.0
"""Without a report for so long, an output is lost; a busy computer is back sooner."""
RETRY_S = 0.5
PREBUFFER_S = 0.25
SETTLED_S = 1.5
"""A new output plays silence for so long: its first times are wrong."""
ALIGN_S, ALIGN_AGAIN_S, ALIGN_FROM_S = 5.0, 0.3, 0.003
"""For so long after that, how often, and from where on, sound that turns out to be off
(by 20 to 60 ms after the restart of a server) leaps to the clock, not the clock to it."""


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


class SoundKeeper:
    """Replaces an output that is lost, and lets the sound join the running clock.

    Args:
        ring: that outputs empty.
        media: the clock; it never leaps for the sound's sake.
        make: opens an output.
    """

    def __init__(
        self, ring: AudioRing, media: MediaClock, make: Callable[[], AudioOut]
    ) -> None:
        self._ring, self._media = ring, media
        self._revival = SoundRevival(make)
        self._heard_s = 0.0
        self._is_joining = False
        self._align_s = self._align_until_s = 0.0

    @property
    def is_trying(self) -> bool:
        """Whether a lost output is not replaced yet."""
        return self._revival.is_trying

    def rest(self) -> None:
        """The sound begins anew, after a seek or a pause."""
        self._is_joining, self._align_until_s = False, 0.0

    def cancel(self) -> None:
        """Look for no output any more."""
        self.rest()
        self._revival.cancel()

    def look(
        self,
        now_s: float,
        output: AudioOut | None,
        request: Callable[[int, float], None] | None,
        *,
        is_playing: bool,
    ) -> tuple[AudioOut | None, str]:
        """Do what is due.

        Args:
            now_s: monotonic time.
            output: the present one.
            request: asks the decoder for sound of an epoch from a position, s.
            is_playing: whether something should be heard.

        Returns:
            The output from now on, and what has happened, "" for nothing.
        """
        is_silent = is_playing and self._media.source is Source.MONOTONIC
        if not is_silent:
            self._heard_s = now_s
        if (found := self._revival.take()) is not None:
            self._heard_s = now_s
            if is_silent and request is not None:
                media_s = self._media.media_s(now_s)
                self._ring.load(self._media.epoch, media_s, self._media.speed)
                request(self._media.epoch, media_s)
                self._is_joining = True
            return found, "sound_back"
        if self._is_joining:
            self._join_when_ready(now_s)
        elif not is_silent and self._align_s < now_s < self._align_until_s:
            self._align(now_s)
        elif output is not None and now_s > self._heard_s + LOST_AFTER_S:
            self._ring.hold()
            self._revival.begin(output)
            return None, "sound_lost"
        return output, ""

    def _join_when_ready(self, now_s: float) -> None:
        is_full = self._ring.buffered_s() >= PREBUFFER_S or self._ring.is_complete
        if is_full and now_s > self._heard_s + SETTLED_S:
            self._is_joining = False
            self._heard_s = now_s
            self._align_until_s = now_s + ALIGN_S
            self._join(now_s)

    def _align(self, now_s: float) -> None:
        if abs(self._media.error_s) > ALIGN_FROM_S:
            self._join(now_s)

    def _join(self, now_s: float) -> None:
        self._align_s = now_s + ALIGN_AGAIN_S
        self._ring.join(self._media.snapshot(now_s))
