"""A sound card's channels as a haptic device, at times of its DAC."""

import contextlib
import importlib
import math
import os
import threading
from collections.abc import Callable
from functools import partial
from typing import Any, Protocol

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import DeviceError, Message
from hapticplayer.extras.shakers.coils import give_coils_to_sound
from hapticplayer.extras.shakers.extension import SHAKER
from hapticplayer.extras.shakers.settings import ShakerSettings
from hapticplayer.extras.shakers.signal import SAMPLE_HZ, ShakerSignal
from hapticplayer.extras.shakers.silence import hand_over_sound, open_files
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import ChannelLevel, DeviceReading, Vector

BLOCK = 240
AHEAD_S = 0.030
"""What the card is asked to hold; 20 ms ran dry on a busy machine."""
ALIVE_S, SILENT_S = 0.2, 1.0
"""Cards ask in bursts; one that has asked for nothing for so long is late, or gone."""
STARTING_S = 5.0
RUNNING_FRAMES = 7200
"""A stream that has asked for so many runs: the first fill its buffer, and then a sound
server may take 0.3 s to start."""
AUDIO_NICE = -11
METER_PERIOD_S = 0.02
_MOST_AHEAD_S = 1.0
_MIDDLE: Vector = (0.0, 0.0, 0.0)
Fill = Callable[[Any, float, int], None]


class OutputStream(Protocol):
    """A stream that is begun by the loop's own thread.

    Attributes:
        problem: why it has not begun, "" for nothing.
    """

    problem: str

    def begin(self) -> None:
        """Start to ask for samples; never waits for it."""

    def drop(self) -> None:
        """Throw away what the card still holds, and go on; never waits for it."""

    def close(self) -> None:
        """End at once; may be called again."""


class CardStream:
    """A stream through PortAudio that asks for samples.

    It is opened by a thread of its own, whose scheduling the threads of PortAudio and of
    the sound server's client inherit.

    Args:
        settings: card and channels.
        fill: called in the stream's thread with the buffer (frames, width), the
            monotonic time at which it will sound, and the number of frames.
        clock: monotonic.
        line: to the guard, which is handed what leads to the card; -1 for none.

    Raises:
        DeviceError: when PortAudio is missing, or there is no such card.
    """

    def __init__(
        self, settings: ShakerSettings, fill: Fill, clock: Clock, line: int = -1
    ) -> None:
        self._line = line
        self._fill, self._clock, self._settings = fill, clock, settings
        self._held, self._is_closed = threading.Lock(), False
        self._stream: Any = None
        self.problem = ""
        try:
            self._sounddevice: Any = importlib.import_module("sounddevice")
            self._sounddevice.check_output_settings(
                device=settings.address or None,
                channels=settings.width,
                dtype="float32",
                samplerate=SAMPLE_HZ,
            )
        except (ImportError, OSError, ValueError, RuntimeError) as problem:
            raise self._refused(problem) from problem
        except Exception as problem:
            if type(problem).__name__ != "PortAudioError":
                raise
            raise self._refused(problem) from problem
        give_coils_to_sound(settings)

    def begin(self) -> None:
        self._run(self._start)

    def drop(self) -> None:
        """Stop without playing what is left, then start again."""
        self._run(self._restart)

    def close(self) -> None:
        """End without playing what is left."""
        with self._held, contextlib.suppress(self._sounddevice.PortAudioError):
            self._is_closed = True
            if self._stream is not None:
                self._stream.abort()
                self._stream.close()

    def _run(self, what: Callable[[], None]) -> None:
        threading.Thread(target=self._guarded, args=(what,), daemon=True).start()

    def _guarded(self, what: Callable[[], None]) -> None:
        _be_an_audio_thread()
        try:
            with self._held:
                if not self._is_closed:
                    what()
        except self._sounddevice.PortAudioError as problem:
            self.problem = str(problem)[:200]

    def _start(self) -> None:
        before = open_files()
        self._stream = self._sounddevice.OutputStream(
            device=self._settings.address or None,
            samplerate=SAMPLE_HZ,
            channels=self._settings.width,
            dtype="float32",
            blocksize=BLOCK,
            latency=AHEAD_S,
            callback=self._callback,
        )
        self._stream.start()
        hand_over_sound(self._line, before)

    def _restart(self) -> None:
        if self._stream is not None:
            self._stream.abort()
            self._stream.start()

    def _callback(self, out: Any, frames: int, time_info: Any, _status: Any) -> None:
        # only the difference: PortAudio's own clock may be moved by a time server
        ahead_s = time_info.outputBufferDacTime - time_info.currentTime
        ahead_s = min(max(ahead_s, 0.0), _MOST_AHEAD_S)
        self._fill(out, self._clock.now_s() + ahead_s, frames)

    def _refused(self, problem: BaseException) -> DeviceError:
        return DeviceError(
            "the sound card {card!r} cannot be opened with {count} channels: {reason}; "
            "choose another card or profile",
            card=self._settings.address or "default",
            count=self._settings.width,
            reason=str(problem)[:200],
        )


class ShakerDriver:
    """A `HapticDevice` without a place."""

    name = "shaker"
    capabilities = SHAKER

    def __init__(
        self,
        settings: ShakerSettings,
        clock: Clock | None = None,
        make_stream: Callable[[ShakerSettings, Fill, Clock], OutputStream] = CardStream,
    ) -> None:
        self.settings = settings
        self._clock, self._make_stream = clock or SystemClock(), make_stream
        self._stream: OutputStream | None = None
        self._signal = ShakerSignal(settings)
        self._opened_s, self._has_begun = 0.0, False
        self._asked_s, self._frames = 0.0, 0
        self._metered_s = -math.inf
        self._levels: tuple[ChannelLevel, ...] = ()

    def open(self) -> None:
        """Start the stream; raises DeviceError with what to do."""
        self.close()
        self._signal = ShakerSignal(self.settings)
        self._opened_s, self._has_begun = self._clock.now_s(), False
        self._frames = 0
        self._stream = self._make_stream(self.settings, self._fill, self._clock)

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Take a force; raises DeviceError when the card asks for nothing any more."""
        stream, signal = self._stream, self._signal
        if stream is None:
            raise DeviceError("the shaker is not open; choose the device again")
        if not self._has_begun:
            self._has_begun, self._opened_s = True, now_s
            stream.begin()
        if stream.problem:
            raise self._gone()
        signal.push(force_n, now_s)
        if now_s - self._metered_s >= METER_PERIOD_S:
            self._metered_s, self._levels = now_s, signal.meter.levels(now_s)
        asked_s = self._asked_s
        if self._frames < RUNNING_FRAMES:
            if now_s - self._opened_s > STARTING_S:
                raise self._gone()
            return DeviceReading(_MIDDLE, 0, False, now_s, 0, self._levels)
        if now_s - asked_s > SILENT_S:
            raise self._gone()
        is_alive = now_s - asked_s < ALIVE_S
        replied_s = now_s if is_alive else asked_s
        return DeviceReading(_MIDDLE, 0, True, replied_s, 0, self._levels)

    def forget(self) -> None:
        """Throw away what has not sounded yet, on the card as well."""
        self._signal.forget()
        if self._stream is not None and self._has_begun:
            self._opened_s, self._frames = self._clock.now_s(), 0
            self._stream.drop()

    def close(self) -> None:
        """End the stream at once; may be called again."""
        stream, self._stream = self._stream, None
        if stream is not None:
            stream.close()

    def _gone(self) -> DeviceError:
        reason = self._stream.problem if self._stream else ""
        self.close()
        return DeviceError(
            "the sound card {card!r} no longer accepts sound ({reason}); connect it and "
            "choose the device again",
            card=self.settings.address or "default",
            reason=reason or Message("it asks for none"),
        )

    def _fill(self, out: Any, at_s: float, frames: int) -> None:
        self._asked_s = self._clock.now_s()
        self._frames += frames
        samples: Floats = self._signal.samples(at_s, frames)
        out[:] = samples


def _be_an_audio_thread() -> None:
    """Leave the loop's real-time scheduling, and be nice less than others.

    A sound client that spins in real time would hold a processor for ever; one that
    waits behind everything else lets the card run dry.
    """
    with contextlib.suppress(OSError, AttributeError):  # other systems have none
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), AUDIO_NICE)


def make(line: int, settings: ShakerSettings) -> ShakerDriver:
    """The driver of a card; the line leads to the guard."""
    make_stream = partial(CardStream, line=line)
    return ShakerDriver(settings, make_stream=make_stream)
