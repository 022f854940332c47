"""What every loop does beside its output: hear the player, keep its tracks and clock."""

from hapticplayer.clock import Clock
from hapticplayer.errors import Message
from hapticplayer.haptics.block import LoopBlock
from hapticplayer.haptics.contract import Request, Supervision
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.messages import (
    MessageKind,
    MessageSocket,
    ReceivedMessage,
    close_descriptor,
)
from hapticplayer.haptics.track import FORCE_COLUMNS, AnyTrack, map_track
from hapticplayer.model import PlaybackClock

CHECKED_PER_TICK = 10_000  # numbers of a new track: 0.25 ms
MISSED_OVER_TICKS = 10_000
_NO_CLOCK = -1


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


class TrackFollower:
    """The player's commands, tracks and clock as a loop has them from tick to tick."""

    clock: Clock
    block: LoopBlock
    line: MessageSocket
    lifeline: Lifeline | None
    columns = FORCE_COLUMNS
    """Of the tracks that this loop plays."""

    def listen(self) -> None:
        """Begin: no track, no clock, nothing asked for."""
        self._tracks: dict[int, AnyTrack] = {}
        self._unchecked: dict[int, AnyTrack] = {}
        self._newer: dict[int, AnyTrack] = {}  # than the unchecked ones
        self._playback: PlaybackClock | None = None
        self._track: AnyTrack | None = None
        self._clock_count = 0
        self._request = Request.NONE
        self._is_asked_to_quit = False
        self._is_device_gone = False
        self._is_stale = False
        self._missed = MissedPeriods()
        self._is_player_alive = True
        self._is_needed = self.is_resting = False

    @property
    def is_over(self) -> bool:
        return self._is_asked_to_quit or not self._is_player_alive

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

    def _handle(self, message: ReceivedMessage) -> None:
        if message.word is MessageKind.TRACK:
            self._load_track(int(message.text), message.descriptor)
        elif message.word is MessageKind.FORGET:
            self._tracks.pop(int(message.text), None)
            self._unchecked.pop(int(message.text), None)
            self._newer.pop(int(message.text), None)
        elif message.word is MessageKind.STOP:
            self._request = Request.STOP
        elif message.word is MessageKind.REARM:
            self._request = Request.REARM
        elif message.word is MessageKind.QUIT:
            self._is_asked_to_quit = True
        elif message.word is MessageKind.FAULT:
            self._inject(message.text)

    def _inject(self, _text: str) -> None:
        self.line.send(
            MessageKind.FAILED,
            Message("this haptic loop does not accept injected faults"),
        )

    def _load_track(self, track_id: int, descriptor: int) -> None:
        # what is being checked is checked to its end: else a track that is edited
        # without a pause would never play
        waiting = self._newer if track_id in self._unchecked else self._unchecked
        try:
            waiting[track_id] = map_track(descriptor, self.columns)
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
            MessageKind.FAILED,
            Message("the force track was rejected: {reason}", reason=problem),
        )
