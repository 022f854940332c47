"""Fetches the force of a clip a few seconds ahead of where the clip is."""

import numpy as np

from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.haptics.streamed_track import PACKET_SAMPLES, RATE_HZ
from hapticplayer.haptics.track_buffer import TrackBuffer
from hapticplayer.streaming.client import Aborted, StreamAddress, Unreachable
from hapticplayer.streaming.fetch_thread import FetchThread
from hapticplayer.streaming.manifest import Manifest
from hapticplayer.streaming.packets import PACKET_BYTES, decoded
from hapticplayer.untrusted import MAX_PACKETS_AT_ONCE

AHEAD_PACKETS = 2 * MAX_PACKETS_AT_ONCE
"""16 s: so often can what is lost be asked for again."""

FIRST_PACKETS = 8
"""1 s, asked for first where nothing is known: at the beginning and after a seek."""

_RETRY_S, _SLOWEST_RETRY_S = 0.05, 1.0


class ForceFetch(FetchThread):
    """Fills the tracks of a stream in a thread of its own, until it is closed.

    Attributes:
        tracks: by name, for the haptic loop.
        problem: why nothing comes any more, None while it does.
    """

    def __init__(
        self, address: StreamAddress, manifest: Manifest, clock: Clock
    ) -> None:
        super().__init__(address, clock, "force-fetch")
        self.tracks = {name: TrackBuffer(manifest.samples) for name in manifest.tracks}
        self.problem: HapticPlayerError | None = None
        self._numbers = {name: k for k, name in enumerate(manifest.tracks)}
        self._at = (manifest.feedback, 0)  # track, and packet at the playhead
        self._is_fetching = False
        self._thread.start()

    def follow(self, feedback: str, media_s: float) -> None:
        """Fetch what is felt from a position on; a leap gives up what is under way."""
        at = (feedback, int(max(0.0, media_s) * RATE_HZ) // PACKET_SAMPLES)
        with self._news:
            (before, packet), self._at = self._at, at
            if at == (before, packet):
                return
            self._news.notify_all()
            is_leap = feedback != before or not 0 <= at[1] - packet < AHEAD_PACKETS
            if is_leap and self._is_fetching and not self.has(feedback, media_s):
                self._client.abort()

    def has(self, feedback: str, media_s: float) -> bool:
        """Whether the force of a time has arrived."""
        return self.tracks[feedback].has(media_s)

    def _run(self) -> None:
        failures = 0
        while (wanted := self._next()) is not None:
            name, first, end = wanted
            try:
                is_progress = self._fetch(name, first, end)
            except Aborted:
                continue
            except Unreachable:
                is_progress = False
            except HapticPlayerError as problem:
                self.problem = problem
                return
            failures = 0 if is_progress else failures + 1
            if failures:
                self._wait(min(_RETRY_S * 2.0**failures, _SLOWEST_RETRY_S))

    def _fetch(self, name: str, first: int, end: int) -> bool:
        """Fill in what comes of some packets; return whether anything does."""
        number, track = self._numbers[name], self.tracks[name]
        content = self._client.get(
            f"force/{number}/{first}-{end - 1}", (end - first) * PACKET_BYTES
        )
        is_progress = False
        for packet in decoded(content, number, len(track.has_arrived)):
            if not track.has_arrived[packet.number]:
                track.fill(packet.number, packet.force_n)
                is_progress = True
        return is_progress

    def _next(self) -> tuple[str, int, int] | None:
        """Return a track with the first packets that it lacks, None at the end."""
        with self._news:
            while not self._is_closed:
                name, packet = self._at
                ahead = self.tracks[name].has_arrived[packet : packet + AHEAD_PACKETS]
                lacking = np.flatnonzero(ahead == 0)
                if len(lacking):
                    first = int(lacking[0])
                    most = FIRST_PACKETS if first == 0 else MAX_PACKETS_AT_ONCE
                    end = min(first + most, int(lacking[-1]) + 1)
                    self._is_fetching = True
                    return name, packet + first, packet + end
                self._is_fetching = False
                self._news.wait()
            return None
