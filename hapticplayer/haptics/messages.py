"""What the player says to the haptics process and back, over one socket pair.

A closed end is a message too.
"""

import enum
import json
import os
import select
import socket
from typing import NamedTuple

from hapticplayer.errors import from_json, to_json

_MAX_BYTES = 4096
RESTS = 3
"""How many calls of `receive` in a row believe the inbox that nothing has come."""


class Word(enum.Enum):
    """First byte of a message."""

    TRACK = b"T"  # + track id; the descriptor of the track comes along
    FORGET = b"F"  # + track id: nobody plays it any more
    STOP = b"S"
    REARM = b"A"
    QUIT = b"Q"
    FAULT = b"X"  # + its name; for simulated devices only
    READY = b"R"  # + scheduling class
    FAILED = b"E"  # + one sentence
    LOST = b"L"  # + one sentence: the device is gone


_SENTENCES = (Word.FAILED, Word.LOST)


class Received(NamedTuple):
    """One message."""

    word: Word
    text: str = ""
    descriptor: int = -1


class Line:
    """One end of the socket pair; never blocks.

    Args:
        end: it is the line's from now on.
        alarm: descriptor of an alarm to listen for too, see hapticplayer.haptics.alarm.
        outbox: number in shared memory of what was sent, the end too; kept up here.
        inbox: the other end's outbox. With it `receive` asks the kernel only where
            something was sent, and at every fourth call (see `RESTS`) for an alarm and
            for the end of a process that died: at 1 kHz the question is a twentieth of
            a tick.

    Attributes:
        is_open: whether the other end has not hung up, as far as is known.
        is_alarmed: whether the alarm sounded when the kernel was asked last.
    """

    def __init__(
        self,
        end: socket.socket,
        alarm: int = -1,
        *,
        outbox: memoryview | None = None,
        inbox: memoryview | None = None,
    ) -> None:
        end.setblocking(False)
        self._end, self._alarm = end, alarm
        self._outbox, self._inbox = outbox, inbox
        self._heard, self._rests = 0, 0
        self._poll = select.poll()
        self._poll.register(end, select.POLLIN)
        if alarm >= 0:
            self._poll.register(alarm, select.POLLIN)
        self.is_open = True
        self.is_alarmed = False

    def send(self, word: Word, text: str = "", descriptor: int = -1) -> bool:
        """Send one message; False when the other end is gone."""
        if word in _SENTENCES:
            text = json.dumps(to_json(text))
        descriptors = [descriptor] if descriptor >= 0 else []
        try:
            socket.send_fds(self._end, [word.value + text.encode()], descriptors)
        except OSError:
            self.is_open = False
        self._count()
        return self.is_open

    def receive(self, timeout_ms: int = 0) -> Received | None:
        """Return the next message, or None; clears `is_open` at the end."""
        if not self.is_open:
            return None
        sent = 0
        if self._inbox is not None:
            sent = self._inbox[0]
            if sent == self._heard and self._rests > 0:
                self._rests -= 1
                return None
            self._rests = RESTS
        ready = self._poll.poll(timeout_ms)
        if not ready:
            self.is_alarmed, self._heard = False, sent
            return None
        self.is_alarmed = self._sounds(ready)
        try:
            data, descriptors, _, _ = socket.recv_fds(self._end, _MAX_BYTES, 1)
        except BlockingIOError:
            return None
        except OSError:
            data, descriptors = b"", []
        if not data:
            self.is_open = False
            return None
        received = descriptors[0] if descriptors else -1
        word, text = Word(data[:1]), data[1:].decode(errors="replace")
        if word in _SENTENCES:
            text = from_json(json.loads(text))
        return Received(word, text, received)

    def _sounds(self, ready: list[tuple[int, int]]) -> bool:
        """Return whether it is the alarm; a hung-up one is none, and not looked at again."""
        events = dict(ready).get(self._alarm, 0)
        if events & (select.POLLHUP | select.POLLERR | select.POLLNVAL):
            self._poll.unregister(self._alarm)
            return False
        return bool(events)

    def _count(self) -> None:
        if self._outbox is not None:
            self._outbox[0] += 1

    def close(self) -> None:
        """Hang up; the other side reads it as the end."""
        self.is_open = False
        self._end.close()
        self._count()


def close_descriptor(descriptor: int) -> None:
    """Close a received descriptor, if there is one."""
    if descriptor >= 0:
        os.close(descriptor)
