"""No screen saver and no notifications while somebody watches, where D-Bus is there."""

from PySide6.QtDBus import QDBusConnection, QDBusInterface, QDBusMessage

_SERVICES: tuple[tuple[str, str, str, tuple[object, ...]], ...] = (
    # service, path, interface, arguments of Inhibit
    (
        "org.freedesktop.ScreenSaver",
        "/org/freedesktop/ScreenSaver",
        "org.freedesktop.ScreenSaver",
        ("hapticplayer", "an experiment is running"),
    ),
    (
        "org.freedesktop.Notifications",
        "/org/freedesktop/Notifications",
        "org.freedesktop.Notifications",
        ("hapticplayer", "an experiment is running", {}),
    ),
)
_TIMEOUT_MS = 500


class Undisturbed:
    """Asks the desktop to leave us alone until `release`, or until we are gone."""

    def __init__(self) -> None:
        self._held: list[tuple[QDBusInterface, int]] = []
        bus = QDBusConnection.sessionBus()
        if not bus.isConnected():
            return
        for service, path, name, arguments in _SERVICES:
            interface = QDBusInterface(service, path, name, bus)
            interface.setTimeout(_TIMEOUT_MS)
            if not interface.isValid():
                continue
            reply = interface.call("Inhibit", *arguments)
            if reply.type() is QDBusMessage.MessageType.ReplyMessage:
                self._held.append((interface, int(reply.arguments()[0])))

    @property
    def is_held(self) -> bool:
        """Whether the desktop has agreed to something."""
        return bool(self._held)

    def release(self) -> None:
        """Let the desktop go on as before."""
        for interface, cookie in self._held:
            interface.call("UnInhibit", cookie)
        self._held = []
