"""Messages between the player and the haptic loop, over one socket pair.

A closed end is a message too. Signals have an alarm of their own, which the loop polls
with the same call.
"""

import enum
import functools
import json
import os
import select
import socket
from typing import NamedTuple

from hapticplayer.errors import from_json, to_json

_MAX_BYTES = 4096
ALARM_S = 0.05
"""How long an alarm stays on for the loops, which poll it every millisecond."""


class MessageKind(enum.Enum):
    """First byte of a message."""

    TRACK = b"T"  # + track id, new or of the track to replace; its descriptor too
    FORGET = b"F"  # + id of a track that is not needed any more
    STOP = b"S"
    REARM = b"A"
    QUIT = b"Q"
    WAKE = b"W"  # a clip is about to play
    FAULT = b"X"  # + its name; for simulated devices only
    READY = b"R"  # + scheduling class
    FAILED = b"E"  # + one sentence
    LOST = b"L"  # + one sentence: the device is gone
    NOTICE = b"N"  # + one sentence: what the device has reported


_SENTENCES = (MessageKind.FAILED, MessageKind.LOST, MessageKind.NOTICE)
_MOST_SAID = 600
"""Characters of a sentence that always fit into a message."""


class ReceivedMessage(NamedTuple):
    """One message."""

    word: MessageKind
    text: str = ""
    descriptor: int = -1


class MessageSocket:
    """One end of the socket pair; never blocks.

    It owns `end` from now on. `alarm` is the descriptor of the reading end of
    an `Alarm`, -1 for none; `is_alarmed` is whether it was on at the last `receive`.
    """

    def __init__(self, end: socket.socket, alarm: int = -1) -> None:
        end.setblocking(False)
        self._end, self._alarm = end, alarm
        self.poll = select.poll()
        self.poll.register(end, select.POLLIN)
        if alarm >= 0:
            self.poll.register(alarm, select.POLLIN)
        self.is_open = True
        self.is_alarmed = False
        self._owed: MessageKind | None = None

    def insist(self, word: MessageKind) -> None:
        """Send a word, again at each `receive` while the line is full.

        Only the newest of these counts: a re-arm takes the place of a stop.
        """
        self._owed = None if self.send(word) else word

    def send(self, word: MessageKind, text: str = "", descriptor: int = -1) -> bool:
        """Send one message; False when the other end is gone.

        `is_open` stays for `receive` to clear: the last words of the other end, as why
        a device could not be opened, may still be waiting there.
        """
        if word in _SENTENCES:
            said = json.dumps(to_json(text))
            text = said if len(said) < _MAX_BYTES else json.dumps(text[:_MOST_SAID])
        descriptors = [descriptor] if descriptor >= 0 else []
        try:
            socket.send_fds(self._end, [word.value + text.encode()], descriptors)
        except OSError:
            return False
        return True

    def receive(self, timeout_ms: int = 0) -> ReceivedMessage | None:
        """Return the next message, or None; clears `is_open` at the end."""
        if not self.is_open:
            return None
        if self._owed is not None:
            self.insist(self._owed)
        ready = self.poll.poll(timeout_ms)
        self.is_alarmed = bool(ready) and self._has_alarm(ready)
        if not ready:
            return None
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
        word, text = MessageKind(data[:1]), data[1:].decode(errors="replace")
        if word in _SENTENCES:
            text = from_json(json.loads(text))
        return ReceivedMessage(word, text, received)

    def _has_alarm(self, ready: list[tuple[int, int]]) -> bool:
        events = dict(ready).get(self._alarm, 0)
        if events & (select.POLLHUP | select.POLLERR | select.POLLNVAL):
            self.poll.unregister(self._alarm)  # its process has ended
            return False
        return bool(events)

    def close(self) -> None:
        """Hang up; the other side reads it as the end."""
        self.is_open = False
        self._end.close()


def close_descriptor(descriptor: int) -> None:
    """Close a received descriptor, if there is one."""
    if descriptor >= 0:
        os.close(descriptor)


class Alarm(NamedTuple):
    """Reports signals, above all Ctrl-C, to the loops while the interpreter is busy.

    The interpreter's handler in C writes one byte for each signal, in whichever thread
    it comes (signal.set_wakeup_fd). Python's own handler follows when the main thread
    gets to it, which painting can delay by tens of milliseconds. The loops poll the
    reading end and read nothing from it. Neither end blocks.
    """

    write_end: socket.socket
    read_end: socket.socket

    def clear(self) -> None:
        """Turn the alarm off, once all loops have had the time to see it."""
        try:
            self.read_end.recv(4096)
        except BlockingIOError:
            return


@functools.cache
def signal_alarm() -> Alarm:
    """Return the alarm of this process, which is never closed."""
    write_end, read_end = socket.socketpair()
    write_end.setblocking(False)
    read_end.setblocking(False)
    return Alarm(write_end, read_end)
