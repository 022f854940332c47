"""Descriptors that the loop hands to its guard, along the line between both."""

import contextlib
import os
import socket
from collections.abc import Iterator

_HELLO = b"fd"
_MOST_NOTE = 1024


def hand_over(line: int, descriptor: int, note: bytes = _HELLO) -> None:
    """Send a descriptor, and what goes with it, along one end of a SOCK_SEQPACKET pair; never waits.

    Nobody may be at the other end, or the line -1: then nothing is handed over.
    """
    with contextlib.suppress(OSError, ValueError), _borrowed(line) as end:
        socket.send_fds(end, [note], [descriptor])


def take_over(line: int) -> tuple[int, bytes] | None:
    """Return the newest descriptor that has come along the line, and its note."""
    newest = None
    with contextlib.suppress(OSError), _borrowed(line) as end:
        while True:
            data, found, _, _ = socket.recv_fds(end, _MOST_NOTE, 1)
            if not data:
                break
            for descriptor in found:
                if newest is not None:
                    os.close(newest[0])
                newest = (descriptor, data)
    return newest


@contextlib.contextmanager
def _borrowed(line: int) -> Iterator[socket.socket]:
    """Use a descriptor as a socket that never waits, and leave it open."""
    end = socket.socket(fileno=line)
    end.setblocking(False)
    try:
        yield end
    finally:
        end.detach()
