"""Cuts a process that has died off from its sound, for the guard.

A sound server plays on until the connection of a client has closed, which is only once
the kernel has torn down the client's memory: 20 to 30 ms for a loop, whose memory is
locked. So the loop hands the connection (or the open card) to its guard, which is
woken before that (`haptics.lifeline`) and shuts it down.
"""

import fcntl
import os
import socket
import stat
from collections.abc import Callable
from pathlib import Path

from hapticplayer.devices.descriptor_passing import hand_over, take_over

CARD = "/dev/snd/pcm"
"""How the path of a sound card's stream begins."""

_OPEN = Path("/proc/self/fd")
_DROP = 0x4143
"""SNDRV_PCM_IOCTL_DROP, _IO('A', 0x43): stop, and forget what is held."""


def open_files() -> set[int]:
    """Return the descriptors of this process; none where there is no /proc."""
    try:
        found = [int(one.name) for one in _OPEN.iterdir()]
    except OSError:
        return set()
    return set(filter(_is_open, found))  # the folder's own one is closed now


def hand_over_sound(line: int, before: set[int]) -> None:
    """Hand what a stream has opened since `before` to the guard at the line's end.

    The connection to a sound server where there is one, else the card itself.
    """
    opened = sorted(open_files() - before)
    for leads_there in (_is_connected, _is_card):
        for descriptor in filter(leads_there, opened):
            hand_over(line, descriptor)
            return


def silence(line: int, _options: object = None) -> Callable[[], bool]:
    """A cut-off for the sound of a loop that has ended; False: there is none left.

    A loop that stands still needs none: the stream's own thread fades within 15 ms.
    """

    def cut() -> bool:
        taken = take_over(line) if line >= 0 else None
        return taken is not None and _cut(taken[0])

    return cut


def _cut(descriptor: int) -> bool:
    try:
        if stat.S_ISSOCK(os.fstat(descriptor).st_mode):
            with socket.socket(fileno=os.dup(descriptor)) as connection:
                connection.shutdown(socket.SHUT_RDWR)
        else:
            fcntl.ioctl(descriptor, _DROP)
    except OSError:
        return False  # closed already
    finally:
        os.close(descriptor)
    return True


def _is_open(descriptor: int) -> bool:
    try:
        os.fstat(descriptor)
    except OSError:
        return False
    return True


def _is_connected(descriptor: int) -> bool:
    """Whether it is a socket to somebody with an address: no pair of this process's."""
    try:
        if not stat.S_ISSOCK(os.fstat(descriptor).st_mode):
            return False
        with socket.socket(fileno=os.dup(descriptor)) as end:
            return bool(end.getpeername())
    except OSError:
        return False


def _is_card(descriptor: int) -> bool:
    try:
        return str((_OPEN / str(descriptor)).readlink()).startswith(CARD)
    except OSError:
        return False
