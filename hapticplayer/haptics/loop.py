"""The loop of the haptics process: absolute deadlines, skip, never burst."""

import gc
from dataclasses import dataclass, field

from hapticplayer.clock import Clock
from hapticplayer.devices import HapticDevice
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.haptics.messages import Line, Word, close_descriptor
from hapticplayer.haptics.shared import SharedBlock
from hapticplayer.haptics.step import Request, State, Supervision, step
from hapticplayer.haptics.track import LoadedTrack, map_track
from hapticplayer.model import PlaybackClock

ZERO_TICKS_BEFORE_CLOSING = 5


@dataclass
class Loop:
    """Owner of the device and of all that one tick hands to the next.

    `tick` is public so that tests drive it on a virtual clock.
    """

    clock: Clock
    block: SharedBlock
    line: Line
    device: HapticDevice
    limits: Limits = field(default_factory=Limits)

    def __post_init__(self) -> None:
        self.state = State()
        self.count = 0
        self._tracks: dict[int, LoadedTrack] = {}
        self._playback: PlaybackClock | None = None
        self._track: LoadedTrack | None = None
        self._slot = b""
        self._request = Request.NONE
        self._is_asked_to_quit = False

    @property
    def is_over(self) -> bool:
        """Whether nobody is left who could want a force."""
        return self._is_asked_to_quit or not self.line.is_open

    def run(self) -> None:
        """Tick until the player quits or is gone, then leave zero on the wire."""
        gc.collect()
        gc.freeze()
        gc.disable()  # the loop makes no cycles; a collection costs milliseconds
        deadline_s = self.clock.now_s() + PERIOD_S
        last_ticks = ZERO_TICKS_BEFORE_CLOSING
        while last_ticks:
            self.clock.sleep_until(deadline_s)
            now_s = self.clock.now_s()
            late_s = now_s - deadline_s
            missed = int(late_s / PERIOD_S)
            self.tick(now_s, late_s, missed)
            deadline_s += (missed + 1) * PERIOD_S
            if self.is_over and self.state.force_n == ZERO:
                last_ticks -= 1

    def tick(self, now_s: float, late_s: float = 0.0, missed: int = 0) -> None:
        """Do one period: listen, decide, exchange, record."""
        self._listen()
        self._look_at_the_clock()
        request = Request.CLOSE if self._is_asked_to_quit else self._request
        supervision = Supervision(self.block.heartbeat_s(), self.line.is_open, request)
        self._request = Request.NONE
        self.state = state = step(
            now_s, self._playback, self._track, self.state, supervision, self.limits
        )
        reading = self.device.exchange(state.force_n, now_s)
        self.block.write_tick(
            self.count,
            now_s,
            state.media_s,
            *state.planned_n,
            *state.force_n,
            *reading.position_m,
            late_s,
            missed,
            state.mode,
            state.cause,
            reading.buttons,
        )
        self.count += 1

    def _look_at_the_clock(self) -> None:
        slot = self.block.clock_bytes()
        if slot == self._slot and self._track is not None:
            return
        sample = self.block.read_clock()
        if sample is not None:  # else go on with the last good one until it expires
            self._playback, track_id = sample
            self._track = self._tracks.get(track_id)
            self._slot = slot

    def _listen(self) -> None:
        message = self.line.receive()
        if message is None:
            return
        if message.word is Word.TRACK:
            self._load(int(message.text), message.descriptor)
        elif message.word is Word.FORGET:
            self._tracks.pop(int(message.text), None)
        elif message.word is Word.STOP:
            self._request = Request.STOP
        elif message.word is Word.REARM:
            self._request = Request.REARM
        elif message.word is Word.QUIT:
            self._is_asked_to_quit = True

    def _load(self, track_id: int, descriptor: int) -> None:
        try:
            self._tracks[track_id] = map_track(descriptor)
        except (ValueError, OSError) as problem:
            self.line.send(Word.FAILED, f"force track refused: {problem}")
        finally:
            close_descriptor(descriptor)
