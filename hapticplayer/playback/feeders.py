"""Decoder threads: frames and sound ahead of time, in bounded amounts."""

import abc
import logging
import threading
from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeVar

from hapticplayer.errors import MediaError
from hapticplayer.media.audio import AudioBlock, AudioDecoder
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.media.video import VideoDecoder
from hapticplayer.playback.sound_memory import CHANNELS
from hapticplayer.playback.sound_ring import AudioRing

if TYPE_CHECKING:
    from hapticplayer.media.tempo import TempoFilter

QUEUE_FRAMES = 5
ROOM_S = 0.2  # seconds of sound lie ahead: there is no hurry
SAME_TIME_S = 1e-6  # far below any time base

DecoderT = TypeVar("DecoderT", VideoDecoder, AudioDecoder)


class Feeder(threading.Thread, abc.ABC, Generic[DecoderT]):
    """A thread that decodes from wherever it is sent to.

    `problem` is why it has ended, None while it has not; `is_at_end` is whether nothing
    follows what it has decoded.
    """

    _decoder: DecoderT

    def __init__(self, name: str, path: Path | ClipBytes) -> None:
        super().__init__(name=name, daemon=True)
        self._path = path
        self.problem: MediaError | None = None
        self.is_at_end = False
        self._wake = threading.Condition()
        self._target: tuple[int, float] | None = None
        self._epoch = 0
        self._is_stopping = False

    def request(self, epoch: int, media_s: float) -> None:
        """Go to a position; what was decoded for older epochs is dropped."""
        with self._wake:
            self._target = (epoch, media_s)
            self.is_at_end = self.problem is not None  # the thread has ended
            self._forget()
            self._wake.notify_all()

    def leave(self) -> None:
        """End the thread as soon as what it decodes is done: a long seek, perhaps."""
        with self._wake:
            self._is_stopping = True
            self._wake.notify_all()

    def stop(self) -> None:
        """End the thread and wait for it."""
        self.leave()
        if self.ident is not None:
            self.join()

    def run(self) -> None:
        """Decode until stopped; a broken file ends the stream, not the player."""
        try:
            with self._open() as self._decoder:
                while not self._is_stopping:
                    self._one_round()
        except MediaError as problem:
            self.problem = problem
        except Exception as problem:  # a thread's top: it would be lost
            logging.getLogger(__name__).exception("%s failed", self.name)
            self.problem = MediaError(
                "cannot be decoded ({reason})",
                where=self._path.name,
                reason=repr(problem),
            )
        finally:
            self.is_at_end = True

    def _one_round(self) -> None:
        with self._wake:
            while not (self._is_stopping or self._target or self._has_work()):
                self._wake.wait()
            target, self._target = self._target, None
            if target:
                self._epoch = target[0]
        if self._is_stopping:
            return
        if target:
            self._seek(target[1])
        else:
            self._decode()

    def _end(self) -> None:
        """Note that nothing follows, unless a seek has come meanwhile."""
        with self._wake:
            self.is_at_end = self._target is None
            self._wake.notify_all()

    def _forget(self) -> None:
        """Drop what was decoded for an older position."""

    def _seek(self, media_s: float) -> None:
        self._decoder.seek(media_s)

    def _has_work(self) -> bool:
        """Whether there is room for more."""
        return not self.is_at_end

    @abc.abstractmethod
    def _open(self) -> DecoderT:
        """Open the decoder, in this thread."""

    @abc.abstractmethod
    def _decode(self) -> None:
        """Decode one piece."""


class VideoFeeder(Feeder[VideoDecoder]):
    """Decodes frames ahead of time; they are converted when they are shown."""

    def __init__(self, path: Path | ClipBytes) -> None:
        super().__init__("video-decoder", path)
        self._queue: deque[DecodedFrame] = deque()
        self._taken: DecodedFrame | None = None
        self.damaged = 0

    def request(self, epoch: int, media_s: float) -> None:
        """Go to a position; frames that are here already are not decoded again."""
        with self._wake:
            if self._target is None and self._keep_from(media_s):
                self._wake.notify_all()
                return
        super().request(epoch, media_s)

    def _keep_from(self, media_s: float) -> bool:
        """Drop what lies before a position, if its frame and the next one are here."""
        kept = [*([self._taken] if self._taken else []), *self._queue]
        covering = sum(f.pts_s <= media_s + SAME_TIME_S for f in kept) - 1
        if not 0 <= covering < len(kept) - 1:
            return False
        self._queue, self._taken = deque(kept[covering:]), None
        return True

    def peek(self, number: int = 0) -> DecodedFrame | None:
        """Return a queued frame without taking it; asked often, it takes no lock."""
        try:
            return self._queue[number]
        except IndexError:
            return None

    def pop(self) -> DecodedFrame | None:
        """Take the next frame."""
        with self._wake:
            if not self._queue:
                return None
            self._taken = self._queue.popleft()
            self._wake.notify_all()
            return self._taken

    def _has_work(self) -> bool:
        return super()._has_work() and len(self._queue) < QUEUE_FRAMES

    def _forget(self) -> None:
        self._queue.clear()
        self._taken = None

    def _open(self) -> VideoDecoder:
        return VideoDecoder(self._path)

    def _decode(self) -> None:
        frame = self._decoder.next_frame()
        self.damaged = self._decoder.damaged
        if frame is None:
            self._end()
            return
        with self._wake:
            if self._target is None:
                self._queue.append(frame)
                self._wake.notify_all()


class AudioFeeder(Feeder[AudioDecoder]):
    """Decodes sound into the ring of the output, at the speed that the ring has."""

    def __init__(self, clip: ClipInfo, ring: AudioRing) -> None:
        super().__init__("audio-decoder", clip.content)
        self._ring, self._track = ring, clip.audio_track
        self._speed = 1.0
        self._tempo: TempoFilter | None = None
        self._ready: deque[AudioBlock] = deque()

    def hurry(self) -> None:
        """Fill the ring now: the reader is elsewhere in it."""
        with self._wake:
            self._wake.notify_all()

    def _open(self) -> AudioDecoder:
        how = {"channels": CHANNELS, "track": self._track}
        return AudioDecoder(self._path, rate_hz=self._ring.rate_hz, **how)

    def _seek(self, media_s: float) -> None:
        super()._seek(media_s)
        self._ready.clear()
        self._speed = self._ring.speed
        self._tempo = None
        if self._speed != 1.0:
            from hapticplayer.media.tempo import TempoFilter  # few play so

            self._tempo = TempoFilter(self._speed, self._ring.rate_hz)

    def _next_block(self) -> AudioBlock | None:
        """Return the next block at the speed, None at the end."""
        if self._tempo is None:
            return self._decoder.next_block()
        while not self._ready and not self._tempo.is_over:
            self._ready.extend(self._tempo.push(self._decoder.next_block()))
        return self._ready.popleft() if self._ready else None

    def _decode(self) -> None:
        block = self._next_block()
        if block is None:
            self._ring.finish(self._epoch)
            self._end()
            return
        samples, media_s = block.samples, block.media_s
        while len(samples):
            taken = self._ring.write(self._epoch, media_s, samples)
            samples = samples[taken:]
            media_s += taken / self._ring.rate_hz * self._speed
            if len(samples) and not self._wait_for_room():
                return

    def _wait_for_room(self) -> bool:
        """Wait a little; False when there is something better to do."""
        with self._wake:
            if self._target is None and not self._is_stopping:
                self._wake.wait(ROOM_S)
            return self._target is None and not self._is_stopping
