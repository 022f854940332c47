"""Tells the loops of a signal, Ctrl-C above all, while the interpreter is busy.

The interpreter's handler in C writes one byte for each signal, in whichever thread it
comes (signal.set_wakeup_fd); Python's own handler follows when the main thread has got to
it, which painting can hold up for tens of milliseconds. A loop looks at the socket with
the call with which it looks for messages anyway, and reads nothing from it.
"""

import functools
import socket
from typing import NamedTuple

HEARD_S = 0.05
"""How long a byte stays for the loops, which look every millisecond."""


class Alarm(NamedTuple):
    """Two ends that never block.

    Attributes:
        bell: what is written to it, the loops hear.
        ear: for the loops to look at; `silence` empties it.
    """

    bell: socket.socket
    ear: socket.socket

    def silence(self) -> None:
        """Take what was written, once all loops have had the time to see it."""
        try:
            self.ear.recv(4096)
        except BlockingIOError:
            return


@functools.cache
def alarm() -> Alarm:
    """Return the alarm of this process; it belongs to this module and is never closed."""
    bell, ear = socket.socketpair()
    bell.setblocking(False)
    ear.setblocking(False)
    return Alarm(bell, ear)
