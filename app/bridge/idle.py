"""Keeps the screen awake, and notifications away, through the session's D-Bus.

Every service lets go of an inhibition when its caller leaves the bus. So each one is
asked over a connection of its own, which is closed when the clip stands: nothing can
be held for ever, whatever becomes of this program.
"""

import itertools
import os
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QObject
from PySide6.QtDBus import QDBusConnection, QDBusMessage, QDBusPendingCallWatcher

APPLICATION = "hapticplayer"
_numbers = itertools.count(1)


class _Service(NamedTuple):
    """One that may be there; a desktop has one or both of them."""

    name: str
    path: str
    takes_hints: bool = False


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
        takes_hints=True,
    ),
)
"""Also what would be laid over the picture; for somebody who takes part in a study."""


def has_session_bus() -> bool:
    """Whether there is a bus to connect to.

    Without one libdbus would start a program that makes one, and wait for it, on the
    thread that beats the heart of the force.
    """
    if os.environ.get("DBUS_SESSION_BUS_ADDRESS"):
        return True
    folder = os.environ.get("XDG_RUNTIME_DIR")
    return folder is not None and (Path(folder) / "bus").is_socket()


class IdleInhibitor(QObject):
    """Inhibits while it is wanted; without a bus it does nothing.

    Args:
        address: of the bus; "" for the session's own.
        parent: Qt's owner.
        services: what is inhibited.
    """

    def __init__(
        self,
        address: str = "",
        parent: QObject | None = None,
        services: tuple[_Service, ...] = SERVICES,
    ) -> None:
        super().__init__(parent)
        self._address, self._services = address, services
        self._connection = ""
        self._answers: list[QDBusPendingCallWatcher] = []
        self.held_by: set[str] = set()

    def set_wanted(self, reason: str) -> None:
        """Hold the screen awake for a reason; "" lets it sleep again."""
        if reason and not self._connection and (self._address or has_session_bus()):
            self._ask(reason)
        elif not reason:
            self.release()

    def release(self) -> None:
        """Let the screen sleep again."""
        if self._connection:
            self._answers.clear()
            self.held_by.clear()
            QDBusConnection.disconnectFromBus(self._connection)
            self._connection = ""

    def _ask(self, reason: str) -> None:
        self._connection = f"{APPLICATION}-idle-{next(_numbers)}"
        bus = self._connect()
        if not bus.isConnected():
            return  # no desktop: nothing would fall asleep
        for service in self._services:
            name, path, takes_hints = service
            message = QDBusMessage.createMethodCall(name, path, name, "Inhibit")
            message.setArguments([APPLICATION, reason, *([{}] if takes_hints else [])])
            message.setAutoStartService(False)
            watcher = QDBusPendingCallWatcher(bus.asyncCall(message), self)
            watcher.finished.connect(lambda w, s=service: self._on_answer(s, w))
            self._answers.append(watcher)

    def _connect(self) -> QDBusConnection:
        if self._address:
            return QDBusConnection.connectToBus(self._address, self._connection)
        return QDBusConnection.connectToBus(
            QDBusConnection.BusType.SessionBus, self._connection
        )

    def _on_answer(self, service: _Service, watcher: QDBusPendingCallWatcher) -> None:
        if watcher in self._answers and not watcher.isError():
            self.held_by.add(service.name)
