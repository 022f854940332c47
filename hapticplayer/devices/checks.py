"""What a device needs on this computer, looked at without opening the device.

Each function answers within a second or so, holds nothing afterwards, and sends nothing
to a device. They run in a thread of the set-up page, again and again while it is open.
"""

import importlib.util
import ipaddress
import os
import platform
import socket
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from hapticplayer.devices.options import host_and_port
from hapticplayer.errors import HapticPlayerError, Message, message_of

ANSWER_S = 0.5
"""A service of this computer answers within milliseconds, one on the network in 0.1 s."""


class Check(NamedTuple):
    """One thing that a device needs.

    Attributes:
        what: the thing, as a noun.
        is_met: whether it is; None where nobody can tell from here.
        remedy: the one thing to do when it is not met.
    """

    what: Message
    is_met: bool | None
    remedy: Message | str = ""


def until_unmet(checks: Iterable[Check]) -> list[Check]:
    """Return checks up to the first that is not met: what follows depends on it."""
    found = []
    for check in checks:
        found.append(check)
        if check.is_met is False:
            break
    return found


def package(name: str, remedy: Message) -> Iterator[Check]:
    """Yield that a Python package is missing, if it is."""
    if importlib.util.find_spec(name) is None:
        what = Message("Python package {name}", name=name)
        yield Check(what, False, remedy)


def service(title: str, where: str) -> Check:
    """Return whether a service takes connections at HOST:PORT; it is not spoken to."""
    what = Message("{title} at {where}", title=title, where=where)
    try:
        with socket.create_connection(host_and_port(where), ANSWER_S):
            return Check(what, True)
    except HapticPlayerError as problem:
        return Check(what, False, message_of(problem))
    except OSError:
        return Check(what, False, Message("Start {title}.", title=title))


def receiver(where: str, remedy: Message) -> Check:
    """Return whether a program of this computer listens for UDP at HOST:PORT.

    Nothing is sent: a port that is taken cannot be bound. Whether another computer
    listens is not known.
    """
    what = Message("Program that listens at {where}", where=where)
    try:
        host, port = host_and_port(where)
        family, kind, _, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_DGRAM
        )[0]
        if not ipaddress.ip_address(str(address[0])).is_loopback:
            return Check(what, None)
        with socket.socket(family, kind) as end:
            end.bind(address)
    except HapticPlayerError as problem:
        return Check(what, False, message_of(problem))
    except socket.gaierror:
        unknown = Message("The network does not know this address: correct it.")
        return Check(what, False, unknown)
    except OSError:
        return Check(what, True)
    return Check(what, False, remedy)


def usable(path: str, remedy: Message) -> Check:
    """Return whether this user may read and write a device file."""
    what = Message("Permission for {path}", path=path)
    return Check(what, os.access(path, os.R_OK | os.W_OK), remedy)


def on_linux() -> Iterator[Check]:
    """Yield that this is not Linux, if it is not."""
    if platform.system() != "Linux":
        remedy = Message("Choose another device: only Linux has this interface.")
        yield Check(Message("Linux"), False, remedy)
