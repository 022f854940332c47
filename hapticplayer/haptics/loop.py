"""The loop of the haptics process: absolute deadlines, skip, never burst."""

import gc
import math
from dataclasses import dataclass, field

from hapticplayer.clock import Clock
from hapticplayer.devices import HapticDevice
from hapticplayer.errors import DeviceError, Message, message_of
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.contract import (
    Cause,
    Mode,
    Request,
    Situation,
    State,
    Supervision,
)
from hapticplayer.haptics.hand import observe
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.haptics.messages import Line, Received, Word, close_descriptor
from hapticplayer.haptics.scheduling import CpuLatencyRequest
from hapticplayer.haptics.step import step
from hapticplayer.haptics.track import LoadedTrack, map_track
from hapticplayer.model import PlaybackClock
from hapticplayer.model.device import DeviceReading, Vector

ZERO_TICKS_BEFORE_CLOSING = 5
REST_AFTER_S = 30.0
REST_PERIOD_S = 0.020  # buttons and unplugging are noticed within two
CHECKED_PER_TICK = 10_000  # numbers of a new track: 0.25 ms
MISSED_OVER_TICKS = 10_000
_NO_CLOCK = -1
_RESTING = (Mode.IDLE, Mode.TRIPPED)


class MissedPeriods:
    """How many periods were skipped in the last 10 s, kept up at each tick."""

    def __init__(self) -> None:
        self._ring = bytearray(MISSED_OVER_TICKS)
        self._at = 0
        self._sum = 0

    def add(self, missed: int) -> float:
        """Note what was skipped before one tick; return the share of periods."""
        if not missed and not self._sum:  # the whole ring is zero
            return 0.0
        kept = min(missed, 255)
        self._sum += kept - self._ring[self._at]
        self._ring[self._at] = kept
        self._at = (self._at + 1) % MISSED_OVER_TICKS
        return self._sum / MISSED_OVER_TICKS


@dataclass
class Loop:
    """Owner of the device, and of the state from tick to tick.

    `tick` is public so that tests drive it on a virtual clock.
    """

    clock: Clock
    block: LoopBlock
    line: Line
    device: HapticDevice
    limits: Limits = field(default_factory=Limits)
    centring: Centring = field(default_factory=Centring)
    cpu_latency: CpuLatencyRequest | None = None
    lifeline: Lifeline | None = None

    def __post_init__(self) -> None:
        self.state = State()
        self.count = 0
        self._tracks: dict[int, LoadedTrack] = {}
        self._unchecked: dict[int, LoadedTrack] = {}
        self._newer: dict[int, LoadedTrack] = {}  # than the unchecked ones
        self._playback: PlaybackClock | None = None
        self._track: LoadedTrack | None = None
        self._clock_count = 0
        self._request = Request.NONE
        self._is_asked_to_quit = False
        self.reading: DeviceReading | None = None
        self._is_device_gone = False
        self._is_stale = False
        self._missed = MissedPeriods()
        self._is_player_alive = True
        self._needed_s = self.clock.now_s()
        self._is_needed = self.is_resting = False

    @property
    def is_over(self) -> bool:
        """Whether the player has quit or is gone."""
        return self._is_asked_to_quit or not self._is_player_alive

    def run(self) -> None:
        """Tick until the player quits or is gone, then leave zero on the wire.

        At 1 kHz; at 50 Hz when there was no force for 30 s and nothing plays.
        """
        gc.collect()
        gc.freeze()
        gc.disable()  # the loop makes no cycles; a collection costs milliseconds
        clock = self.clock
        deadline_s = clock.now_s() + PERIOD_S
        last_ticks = ZERO_TICKS_BEFORE_CLOSING
        while last_ticks:
            clock.sleep_until(deadline_s)
            now_s = clock.now_s()
            late_s = now_s - deadline_s
            missed = 0 if self.is_resting else int(late_s / PERIOD_S)
            self.tick(now_s, late_s, missed)
            if self.is_resting:
                deadline_s = now_s + REST_PERIOD_S
            else:
                deadline_s += (missed + 1) * PERIOD_S
            if self.state.force_n == ZERO and self.is_over:
                last_ticks -= 1

    def tick(self, now_s: float, late_s: float = 0.0, missed: int = 0) -> None:
        """Do one period: receive, decide, exchange, record."""
        self._receive()
        if self._unchecked:
            self._check_track()
        clock_count, heartbeat_s, guard_s = self.block.signs()
        self._read_clock(clock_count)
        before = self.state
        self.state = state = step(
            Situation(
                now_s,
                self._playback,
                self._track,
                before,
                observe(before.hand, self.reading, self.limits),
                self._supervision(heartbeat_s, guard_s, missed),
                self.limits,
                self.centring,
            )
        )
        self._exchange(state.force_n, now_s)
        if state.mode is not before.mode and self.cpu_latency is not None:
            self.cpu_latency.set_active(is_active=state.mode not in _RESTING)
        self._record(late_s, missed)
        self.count += 1
        if self._is_needed or state.mode not in _RESTING or self.is_over:
            self._needed_s, self._is_needed = now_s, False
        self.is_resting = now_s - self._needed_s >= REST_AFTER_S
        if self.is_resting:
            self.block.beat_loop(0.0)  # the guard has no force to watch over

    def _supervision(
        self, heartbeat_s: float, guard_s: float, missed: int
    ) -> Supervision:
        request = Request.CLOSE if self._is_asked_to_quit else self._request
        self._request = Request.NONE
        is_cut = self.lifeline is not None and self.lifeline.is_cut()
        self._is_player_alive = is_alive = self.line.is_open and not is_cut
        return Supervision(
            heartbeat_s,
            is_alive,
            request,
            self._is_device_gone,
            self._is_stale,
            guard_s,
            self._missed.add(missed),
        )

    def _exchange(self, force_n: Vector, now_s: float) -> None:
        """Send the command, unless it has become too old meanwhile."""
        age_s = self.clock.now_s() - now_s
        self._is_stale = is_stale = age_s > self.limits.command_age_s
        if is_stale:
            # 20 ms have passed: a ramp that began with them would be over
            force_n = ZERO
            is_acting = self.state.mode not in _RESTING
            if is_acting:
                self.state = self.state._replace(
                    force_n=ZERO, mode=Mode.RAMPING, cause=Cause.COMMAND_STALE
                )
        if self._is_device_gone:
            return
        try:
            self.reading = self.device.exchange(force_n, now_s)
        except DeviceError as problem:
            self._is_device_gone = True
            self.line.send(Word.LOST, message_of(problem))

    def _record(self, late_s: float, missed: int) -> None:
        state = self.state
        hand = state.hand
        self.block.write_tick(
            self.count,
            state.now_s,
            state.media_s,
            *state.planned_n,
            *state.force_n,
            *hand.position_m,
            *hand.velocity_mps,
            *state.centring_n,
            late_s,
            state.now_s - hand.replied_s,
            math.sqrt(state.heat_n2),
            missed,
            state.mode,
            state.cause,
            hand.buttons,
        )

    def _read_clock(self, count: int) -> None:
        if count == self._clock_count and self._track is not None:
            return
        sample = self.block.read_clock()
        if sample is not None:  # else keep the last good one until it expires
            if self.is_resting and sample[0].rate != 0.0:
                self._is_needed = True  # it may bring force: to be taken at 1 kHz
                return
            self._playback, track_id = sample
            self._track = self._tracks.get(track_id)
            self._clock_count = count

    def _receive(self) -> None:
        message = self.line.receive()
        if message is not None:
            self._is_needed = True
            self._handle(message)
        if self.line.is_alarmed:
            self._request = Request.STOP

    def _handle(self, message: Received) -> None:
        if message.word is Word.TRACK:
            self._load_track(int(message.text), message.descriptor)
        elif message.word is Word.FORGET:
            self._tracks.pop(int(message.text), None)
            self._unchecked.pop(int(message.text), None)
            self._newer.pop(int(message.text), None)
        elif message.word is Word.STOP:
            self._request = Request.STOP
        elif message.word is Word.REARM:
            self._request = Request.REARM
        elif message.word is Word.QUIT:
            self._is_asked_to_quit = True
        elif message.word is Word.FAULT:
            self._inject(message.text)

    def _inject(self, _text: str) -> None:
        self.line.send(
            Word.FAILED, Message("this haptic loop does not accept injected faults")
        )

    def _load_track(self, track_id: int, descriptor: int) -> None:
        # what is being checked is checked to its end: else a track that is edited
        # without a pause would never play
        waiting = self._newer if track_id in self._unchecked else self._unchecked
        try:
            waiting[track_id] = map_track(descriptor)
        except (ValueError, OSError) as problem:
            self._reject(problem)
        finally:
            close_descriptor(descriptor)

    def _check_track(self) -> None:
        """Check a part of a new track, which plays once all of it is checked.

        One that has the id of another takes its place then.
        """
        track_id, track = next(iter(self._unchecked.items()))
        try:
            if not track.check(CHECKED_PER_TICK):
                return
            self._tracks[track_id] = track
            self._clock_count = _NO_CLOCK  # it may be the one that the clock names
        except ValueError as problem:
            self._reject(problem)
        del self._unchecked[track_id]
        if track_id in self._newer:
            self._unchecked[track_id] = self._newer.pop(track_id)

    def _reject(self, problem: Exception) -> None:
        self.line.send(
            Word.FAILED,
            Message("the force track was rejected: {reason}", reason=problem),
        )
