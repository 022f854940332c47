"""Keeps the screen awake, and notifications away, through the session's D-Bus.

A service drops an inhibition when its caller leaves the bus. So they are requested over
a connection of their own, which is closed when the clip stops: nothing is held for ever,
whatever becomes of this program.
"""

import contextlib
from typing import NamedTuple

from jeepney import DBusAddress, MessageFlag, new_method_call
from jeepney.io.blocking import DBusConnection, open_dbus_connection

from hapticplayer.facilities import session_bus

APPLICATION = "hapticplayer"


class _Service(NamedTuple):
    """One that may run; a desktop has one or both of the first two."""

    name: str
    path: str
    has_hints: bool = False


SERVICES = (
    _Service("org.freedesktop.ScreenSaver", "/org/freedesktop/ScreenSaver"),
    _Service(
        "org.freedesktop.PowerManagement.Inhibit",
        "/org/freedesktop/PowerManagement/Inhibit",
    ),
)
EVERYTHING = (
    *SERVICES,
    _Service(
        "org.freedesktop.Notifications",
        "/org/freedesktop/Notifications",
        has_hints=True,
    ),
)
"""Also what would cover the video; for a participant of a study."""


def connect(address: str = "") -> DBusConnection | None:
    """Return a connection to the session's bus; None without one, none is started."""
    if address := address or session_bus():
        # RuntimeError: an address of another kind
        with contextlib.suppress(OSError, RuntimeError, ValueError):
            return open_dbus_connection(address)
    return None


class IdleInhibitor:
    """Inhibits while it is wanted; without a bus it does nothing."""

    def __init__(
        self, address: str = "", services: tuple[_Service, ...] = SERVICES
    ) -> None:
        self._address, self._services = address, services
        self._bus: DBusConnection | None = None
        self._is_wanted = False

    def set_wanted(self, reason: str) -> None:
        """Hold the screen awake for a reason; "" lets it sleep again."""
        if not reason:
            self.release()
        elif not self._is_wanted:
            self._is_wanted = True
            self._bus = connect(self._address)
            if self._bus:
                with contextlib.suppress(OSError):  # the bus has ended
                    self._request(reason, self._bus)

    def release(self) -> None:
        """Let the screen sleep again."""
        self._is_wanted = False
        if self._bus:
            self._bus.close()
            self._bus = None

    def _request(self, reason: str, bus: DBusConnection) -> None:
        for name, path, has_hints in self._services:
            signature = "ssa{sv}" if has_hints else "ss"
            hints: list[dict[str, object]] = [{}] if has_hints else []
            call = new_method_call(
                DBusAddress(path, name, name),
                "Inhibit",
                signature,
                (APPLICATION, reason, *hints),
            )
            call.header.flags = MessageFlag.no_auto_start
            bus.send(call)
