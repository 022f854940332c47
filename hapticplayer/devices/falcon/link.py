"""Frames to and from a running Falcon without anybody waiting for them.

The chip answers a read only after up to a millisecond, and a device that stalls may
hold a write for longer: so one thread writes, one reads, and the loop only leaves a
frame and takes the newest answer. Both threads spend their time in the USB library,
outside the interpreter's lock.
"""

import math
import queue
import threading
from collections import deque
from contextlib import suppress
from typing import NamedTuple, Protocol

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.ftdi import PAYLOAD_BYTES, Ftdi
from hapticplayer.devices.falcon.protocol import Reply, ReplyParser
from hapticplayer.errors import DeviceError

LATE_IN_PERIOD_S = 0.0007
"""An answer that comes so long after a frame was left comes near the loop's next tick."""
WRITE_S = 0.02
"""A frame that cannot be sent for so long is taken back: its command is too old."""
READ_S = 0.02
IDLE_S = 0.002
"""Without a frame for so long the chip is read all the same, as it may have answers."""
OLD_S = 0.005
"""An answer that comes so long after the packet before may have waited in the chip."""
_STOP_S = 0.5
_MOST_TO_WAIT = 2
_MOST_PACKETS = 64


class Answer(NamedTuple):
    """The newest well-formed reply, and how many malformed ones came after it."""

    reply: Reply | None
    at_s: float
    malformed: int


NO_ANSWER = Answer(None, 0.0, 0)


class StaleAnswerFilter:
    """Separates current answers from those that waited in the chip unread.

    What a stall of the bus leaves there would be taken for the place of the hand
    at the end of the stall, and the next answer for an impossible leap.
    """

    def __init__(self) -> None:
        self._answered_s = -math.inf

    def accepts(self, data: bytes, at_s: float) -> bool:
        """Whether this payload, read at `at_s`, is worth keeping."""
        gap_s = at_s - self._answered_s
        if data or gap_s < READ_S:  # else there may have been no packet at all
            self._answered_s = at_s
        return bool(data) and gap_s <= OLD_S


class Link(Protocol):
    """A running Falcon, frame by frame."""

    def post(self, frame: bytes) -> None:
        """Send a frame; raises DeviceError when the device is gone."""

    def newest(self) -> Answer:
        """Return the newest answer; raises DeviceError when the device is gone."""

    def stop(self) -> None:
        """End the exchange; the device stays open."""


class DirectLink:
    """Does both in the caller's thread, which may have to wait; for tools and tests."""

    def __init__(self, ftdi: Ftdi, clock: Clock) -> None:
        self._ftdi, self._clock = ftdi, clock
        self._parser = ReplyParser()
        self._answer = NO_ANSWER

    def post(self, frame: bytes) -> None:
        self._ftdi.write(frame, WRITE_S)

    def newest(self) -> Answer:
        """Read until nothing is left; return the newest answer."""
        for _ in range(_MOST_PACKETS):
            data = self._ftdi.read(0.001)
            if not data:
                break
            at_s = self._clock.now_s()
            self._answer = updated(self._answer, self._parser, data, at_s)
        return self._answer

    def stop(self) -> None:
        """There is nothing to poll."""


class ThreadedLink:
    """Never waits, neither in `post` nor in `newest`.

    Of frames that were posted while a write was stalled only the last one is sent. The
    threads inherit the scheduling of the one that makes the link. While one of them has
    the interpreter the loop cannot wake, so they do as little as possible (what was
    read is taken apart by whoever asks for it), and not when a tick is due: there is
    one read for each frame that was sent. The chip's latency timer runs from packet to
    packet, so answers that have drifted towards the next tick would stay there; one
    frame without a read sets the timer back to early in the period.
    """

    def __init__(self, ftdi: Ftdi, clock: Clock, idle_s: float = IDLE_S) -> None:
        self._ftdi, self._clock, self._idle_s = ftdi, clock, idle_s
        self._frames: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._sent: queue.SimpleQueue[None] = queue.SimpleQueue()
        self._posted_s = 0.0
        self._packets: deque[tuple[bytes, float]] = deque(maxlen=_MOST_PACKETS)
        self._parser, self._answer = ReplyParser(), NO_ANSWER
        self._problem: DeviceError | None = None
        self._is_stopping = False
        self._threads = [
            threading.Thread(target=work, name=f"falcon-{name}", daemon=True)
            for name, work in (("writer", self._write), ("reader", self._read))
        ]
        for thread in self._threads:
            thread.start()

    def post(self, frame: bytes) -> None:
        """Leave a frame for the writer."""
        if self._problem is not None:
            raise self._problem
        self._posted_s = self._clock.now_s()
        self._frames.put(frame)

    def newest(self) -> Answer:
        """Return the newest answer that the reader has."""
        if self._problem is not None:
            raise self._problem
        packets = self._packets
        while packets:
            data, at_s = packets.popleft()
            self._answer = updated(self._answer, self._parser, data, at_s)
        return self._answer

    def stop(self) -> None:
        """Let both threads end after what they are doing."""
        self._is_stopping = True
        self._frames.put(None)
        for _ in range(_MOST_TO_WAIT):
            self._sent.put(None)
        for thread in self._threads:
            thread.join(_STOP_S)

    def _write(self) -> None:
        while not self._is_stopping:
            frame = self._frames.get()
            while not self._frames.empty():
                frame = self._frames.get()
            if frame is None:
                return
            try:
                self._ftdi.write(frame, WRITE_S)
            except DeviceError as problem:
                self._problem = problem
                return
            self._sent.put(None)

    def _read(self) -> None:
        read, keep, now_s = self._ftdi.read, self._packets.append, self._clock.now_s
        is_fresh, data, frames_to_wait = StaleAnswerFilter().accepts, b"", 1
        while not self._is_stopping:
            if len(data) < PAYLOAD_BYTES:  # else there may be more
                self._wait_for_frames(frames_to_wait)
            try:
                data = read(READ_S)
            except DeviceError as problem:
                self._problem = problem
                return
            at_s = now_s()
            if is_fresh(data, at_s):
                keep((data, at_s))
            is_late = at_s - self._posted_s > LATE_IN_PERIOD_S
            frames_to_wait = _MOST_TO_WAIT if is_late else 1

    def _wait_for_frames(self, count: int) -> None:
        with suppress(queue.Empty):
            for _ in range(count):
                self._sent.get(timeout=self._idle_s)
        while not self._sent.empty():
            self._sent.get()


def updated(answer: Answer, parser: ReplyParser, data: bytes, at_s: float) -> Answer:
    """Return the newest answer after these bytes, which were read at `at_s`."""
    replies = parser.feed(data)
    if replies:
        return Answer(replies[-1], at_s, parser.malformed)
    return answer._replace(malformed=parser.malformed)
