"""Sound output: a ring that a callback empties, timed by the DAC.

PortAudio's time of the DAC was measured to be exact within 0.1 ms, where counting
what was handed to the server is 16 ms off. The stream runs all the time and plays
silence while paused: starting it again costs up to 260 ms and the first sound.
"""

import threading
from collections import deque
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.model import PlaybackClock
from hapticplayer.playback.clock import AudioReport

RATE_HZ = 48_000
CHANNELS = 2
LATENCY_S = 0.120
MAX_AHEAD_S = 1.0
CAPACITY_S = 2.0
HISTORY_S = 0.5  # kept behind the reader, for a pause that was heard late


class AudioRing:
    """Samples by media time between one writer and the callback.

    The reader's position moves with the DAC whatever happens: samples that come
    too late are skipped, missing ones are silence. So the sound never stalls the
    clock. At another speed the samples are stretched before they come here, and an
    index counts samples of the stretched sound.
    """

    def __init__(self, rate_hz: int = RATE_HZ) -> None:
        self.rate_hz = rate_hz
        self.underrun_samples = 0
        self.gain = 1.0  # of the amplitude; a change is spread over one block
        self._gain_before = 1.0
        self._speed = 1.0
        self._epoch = 0  # of the clock, for the reports
        self._generation = 0  # of the samples: a pause keeps them
        self._capacity = int(CAPACITY_S * rate_hz)
        self._samples = np.zeros((self._capacity, CHANNELS), dtype=np.float32)
        self._read = 0
        self._written = 0
        self._begin = 0
        self._is_playing = False
        self._joins: PlaybackClock | None = None
        self._is_complete = False
        self._lock = threading.Lock()
        self._reports: deque[AudioReport] = deque(maxlen=256)

    def load(self, epoch: int, media_s: float, speed: float = 1.0) -> None:
        """Forget everything and stand still at a position of a new epoch."""
        with self._lock:
            self._epoch = self._generation = epoch
            self._speed = speed
            self._read = self._written = self._begin = self._index(media_s)
            self._is_playing = self._is_complete = False
            self._reports.clear()

    def resume_from(self, epoch: int, media_s: float) -> bool:
        """Stand at a position again without new samples, if they are still here."""
        index = self._index(media_s)
        with self._lock:
            oldest = max(self._begin, self._written - self._capacity)
            if not oldest <= index <= self._written:
                return False
            self._epoch, self._read, self._is_playing = epoch, index, False
            self._reports.clear()
            return True

    def follow(self, epoch: int) -> None:
        """Report for another epoch from now on; the sound goes on."""
        with self._lock:
            self._epoch = epoch
            self._reports.clear()

    def play(self) -> None:
        """Let the callback consume samples."""
        self._is_playing = True

    def join(self, clock: PlaybackClock) -> None:
        """Play on from where a running clock will be when the next sample sounds."""
        with self._lock:
            self._joins = clock
            self._is_playing = True

    def hold(self) -> None:
        """Silence; the position stays."""
        self._is_playing = False

    def write(
        self, generation: int, media_s: float, samples: NDArray[np.float32]
    ) -> int:
        """Append samples (n, 2) that start at a media time.

        Args:
            generation: the epoch of the `load` that they were decoded for.
            media_s: of the first one.
            samples: float32, stretched to the speed of the `load`.

        Returns:
            How many rows were taken (late ones count as taken); fewer than n when
            the ring is full. A stale generation takes all and keeps none.
        """
        with self._lock:
            if generation != self._generation:
                return len(samples)
            first = self._index(media_s)
            late = min(len(samples), max(0, self._written - first))
            start = first + late
            room = self._read + self._capacity - int(HISTORY_S * self.rate_hz) - start
            count = max(0, min(len(samples) - late, room))
            if count:
                self._fill(self._written, np.zeros((start - self._written, CHANNELS)))
                self._fill(start, samples[late : late + count])
                self._written = start + count
            return late + count

    def finish(self, generation: int) -> None:
        """Say that the sound ends here: what follows is no underrun."""
        if generation == self._generation:
            self._is_complete = True

    def buffered_s(self) -> float:
        """Return how much sound lies ahead of the reader."""
        return max(0, self._written - self._read) / self.rate_hz

    @property
    def is_complete(self) -> bool:
        """Whether the decoder has reached the end of the sound."""
        return self._is_complete

    def render(self, out: NDArray[np.float32], dac_s: float) -> None:
        """Fill `out` (n, 2) with what sounds from the monotonic time `dac_s`."""
        with self._lock:
            if not self._is_playing:
                out.fill(0.0)
                return
            if self._joins is not None:
                media_s = self._joins.media_s(dac_s)
                self._read = max(self._begin, round(media_s * self.rate_hz))
                self._joins = None
            count = len(out)
            ready = max(0, min(count, self._written - self._read))
            rows = np.arange(self._read, self._read + ready) % self._capacity
            out[:ready] = self._samples[rows]
            out[ready:] = 0.0
            if ready < count and not self._is_complete:
                self.underrun_samples += count - ready
            self._turn_up(out)
            media_s = self._read / self.rate_hz * self._speed
            self._reports.append(AudioReport(self._epoch, dac_s, media_s))
            self._read += count
            self._written = max(self._written, self._read)

    def reports(self) -> list[AudioReport]:
        """Return the reports since the last call, oldest first."""
        taken = []
        while self._reports:
            taken.append(self._reports.popleft())
        return taken

    def _index(self, media_s: float) -> int:
        return round(media_s / self._speed * self.rate_hz)

    def _turn_up(self, out: NDArray[np.float32]) -> None:
        """Apply the volume; a step would be heard as a click."""
        before, self._gain_before = self._gain_before, self.gain
        if before != 1.0 or self._gain_before != 1.0:
            ramp = np.linspace(before, self._gain_before, len(out), dtype=np.float32)
            out *= ramp[:, None]

    def _fill(self, index: int, samples: NDArray[Any]) -> None:
        samples = samples[-self._capacity :]
        rows = np.arange(index, index + len(samples)) % self._capacity
        self._samples[rows] = samples


class AudioOut(Protocol):
    """Something that empties a ring at its own pace."""

    name: str

    def close(self) -> None:
        """Stop and let go of the device."""
        ...


class SoundDeviceOut:
    """An output through PortAudio.

    Args:
        ring: emptied by it.
        clock: of the machine.
        device: its name; "" for the default one.

    Raises:
        OSError: when PortAudio is missing or there is no device; the caller goes
            on with the monotonic clock.
    """

    def __init__(self, ring: AudioRing, clock: Clock, device: str = "") -> None:
        import sounddevice

        self._ring = ring
        self._clock = clock
        self.callback_errors = 0
        try:
            self._stream = sounddevice.OutputStream(
                device=device or None,
                samplerate=ring.rate_hz,
                channels=CHANNELS,
                dtype="float32",
                latency=LATENCY_S,
                callback=self._callback,
            )
            self._stream.start()
        except (sounddevice.PortAudioError, ValueError) as problem:
            # PortAudio lists the devices once; the next try shall see new ones
            sounddevice._terminate()  # noqa: SLF001 - no other way
            sounddevice._initialize()  # noqa: SLF001
            raise OSError(str(problem)) from problem
        self.name = str(sounddevice.query_devices(self._stream.device)["name"])

    def _callback(
        self, out: NDArray[np.float32], _frames: int, time_info: Any, status: Any
    ) -> None:
        now_s = self._clock.now_s()
        # PortAudio's own clock is CLOCK_REALTIME on Linux, which a time server may
        # move: only the difference within one callback is used
        ahead_s = time_info.outputBufferDacTime - time_info.currentTime
        ahead_s = min(max(ahead_s, 0.0), MAX_AHEAD_S)  # some drivers say nonsense
        self._ring.render(out, now_s + ahead_s)
        self.callback_errors += bool(status)

    def close(self) -> None:
        """Stop at once; what is buffered is dropped."""
        self._stream.abort(ignore_errors=True)
        self._stream.close(ignore_errors=True)


def sound_outputs() -> list[str]:
    """Return the names of the outputs that there are, without the default's alias."""
    try:
        import sounddevice

        known = sounddevice.query_devices()
    except Exception:  # noqa: BLE001 - PortAudio is missing or broken: there are none
        return []
    names = [str(one["name"]) for one in known if one["max_output_channels"] > 0]
    return list(dict.fromkeys(names))


class SilentOut:
    """Consumes a ring without a device; `advance` is its DAC, for tests."""

    name = "silent"

    def __init__(
        self, ring: AudioRing, clock: Clock, *, latency_s: float = LATENCY_S
    ) -> None:
        self._ring = ring
        self._clock = clock
        self._latency_s = latency_s
        self.is_alive = True

    def advance(self, frames: int) -> NDArray[np.float32]:
        """Take the next `frames` samples as a DAC would, and return them."""
        out = np.zeros((frames, CHANNELS), dtype=np.float32)
        if self.is_alive:
            self._ring.render(out, self._clock.now_s() + self._latency_s)
        return out

    def close(self) -> None:
        """Nothing to let go of."""
