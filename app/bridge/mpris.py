"""Media keys and the desktop's player controls (MPRIS 2.2), through D-Bus.

Out of use in study mode: nobody but the experimenter may pause a trial.
"""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import ClassInfo, Property, QObject, Signal, Slot
from PySide6.QtDBus import (
    QDBusAbstractAdaptor,
    QDBusConnection,
    QDBusMessage,
    QDBusObjectPath,
)

from app.bridge.idle import has_session_bus
from app.bridge.int64 import int64
from hapticplayer.playback.player import FASTEST, SLOWEST, Player

NAME = "org.mpris.MediaPlayer2.hapticplayer"
PATH = "/org/mpris/MediaPlayer2"
ROOT, PLAYER = "org.mpris.MediaPlayer2", "org.mpris.MediaPlayer2.Player"
_PROPERTIES = "org.freedesktop.DBus.Properties"
_US = 1e6
# their stubs know neither names of C++ types nor the use as a decorator
_info: Any = ClassInfo
_property: Any = Property
_signal: Any = Signal
_NO_TRACK = "/org/mpris/MediaPlayer2/TrackList/NoTrack"
_TRACK = "/org/hapticplayer/clip"


class Mpris(QObject):
    """Offers the player on the session's bus while it is switched on.

    Args:
        player: what is controlled.
        raise_window: brings the window to the front.
        close: closes it.
        bus: of the session.
    """

    def __init__(
        self,
        player: Player,
        raise_window: Callable[[], object],
        close: Callable[[], object],
        bus: QDBusConnection | None = None,
    ) -> None:
        super().__init__()
        self.player = player
        self.raise_window, self.close_window = raise_window, close
        self._bus = bus
        self._adaptors = (_Root(self), _Player(self))
        self._told: dict[str, Any] = {}
        self.is_on = False

    def switch(self, *, is_on: bool) -> None:
        """Appear on the bus, or vanish from it."""
        if is_on == self.is_on or not self._is_there():
            return
        assert self._bus is not None
        if is_on:
            self.is_on = self._bus.registerObject(
                PATH, self, QDBusConnection.RegisterOption.ExportAdaptors
            ) and self._bus.registerService(NAME)
        else:
            self._bus.unregisterService(NAME)
            self._bus.unregisterObject(PATH)
            self.is_on = False

    def _is_there(self) -> bool:
        """Whether there is a bus; it is looked for when it is first needed."""
        if self._bus is None and has_session_bus():
            self._bus = QDBusConnection.sessionBus()
        return self._bus is not None and self._bus.isConnected()

    def tell(self) -> None:
        """Tell the desktop what has changed since the last call."""
        if not self.is_on or self._bus is None:
            return
        player = self.player.snapshot()
        has_clip = player.source is not None
        now = {
            "PlaybackStatus": self.status(),
            "Rate": player.speed,
            "CanSeek": has_clip,
            "CanPlay": has_clip,
            "CanPause": has_clip,
            "Metadata": self.metadata(),
        }
        key = {name: str(value) for name, value in now.items()}
        changed = {n: v for n, v in now.items() if self._told.get(n) != key[n]}
        if changed:
            self._told = key
            if "Metadata" in changed:
                changed["Metadata"] = sent(self.metadata())
            message = QDBusMessage.createSignal(PATH, _PROPERTIES, "PropertiesChanged")
            message.setArguments([PLAYER, changed, []])
            self._bus.send(message)

    def status(self) -> str:
        """Return the state in the words of the protocol."""
        now = self.player.snapshot()
        if now.source is None:
            return "Stopped"
        return "Playing" if now.is_playing else "Paused"

    def metadata(self) -> dict[str, Any]:
        """Return what the clip is."""
        source = self.player.snapshot().source
        if source is None:
            return {"mpris:trackid": QDBusObjectPath(_NO_TRACK)}
        return {
            "mpris:trackid": QDBusObjectPath(_TRACK),
            "mpris:length": round(_US * source.clip.duration_s),
            "xesam:title": source.title,
        }


def sent(metadata: dict[str, Any]) -> dict[str, Any]:
    """Return what a clip is, in the types of the protocol."""
    length = {n: int64(v) for n, v in metadata.items() if n == "mpris:length"}
    return {**metadata, **length}


@_info({"D-Bus Interface": ROOT})
class _Root(QDBusAbstractAdaptor):
    """What every media player says of itself."""

    def __init__(self, mpris: Mpris) -> None:
        super().__init__(mpris)
        self._mpris = mpris

    CanQuit = _property(bool, lambda _: True)
    CanRaise = _property(bool, lambda _: True)
    HasTrackList = _property(bool, lambda _: False)
    Identity = _property(str, lambda _: "hapticplayer")
    DesktopEntry = _property(str, lambda _: "hapticplayer")
    SupportedUriSchemes = _property("QStringList", lambda _: [])
    SupportedMimeTypes = _property("QStringList", lambda _: [])

    @Slot()
    def Raise(self) -> None:  # noqa: N802 - the protocol's name
        """Bring the window to the front."""
        self._mpris.raise_window()

    @Slot()
    def Quit(self) -> None:  # noqa: N802
        """Close the window."""
        self._mpris.close_window()


@_info({"D-Bus Interface": PLAYER})
class _Player(QDBusAbstractAdaptor):
    """Play, pause, seek; the stop of the protocol is the stop of the force."""

    Seeked = _signal("qlonglong")

    def __init__(self, mpris: Mpris) -> None:
        super().__init__(mpris)
        self._mpris, self._player = mpris, mpris.player

    def _has_clip(self) -> bool:
        return self._player.snapshot().source is not None

    def _position_us(self) -> int:
        return round(_US * self._player.snapshot().media_s)

    def _speed(self) -> float:
        return self._player.snapshot().speed

    PlaybackStatus = _property(str, lambda self: self._mpris.status())
    Metadata = _property("QVariantMap", lambda self: sent(self._mpris.metadata()))
    Position = _property("qlonglong", _position_us)
    Rate = _property(float, _speed, lambda self, speed: self._player.set_speed(speed))
    MinimumRate = _property(float, lambda _: SLOWEST)
    MaximumRate = _property(float, lambda _: FASTEST)
    CanGoNext = _property(bool, lambda _: False)
    CanGoPrevious = _property(bool, lambda _: False)
    CanControl = _property(bool, lambda _: True)
    CanPlay = _property(bool, _has_clip)
    CanPause = _property(bool, _has_clip)
    CanSeek = _property(bool, _has_clip)

    @Slot()
    def Play(self) -> None:  # noqa: N802
        """Play."""
        self._player.play()

    @Slot()
    def Pause(self) -> None:  # noqa: N802
        """Stand still."""
        self._player.pause()

    @Slot()
    def PlayPause(self) -> None:  # noqa: N802
        """Play or stand still."""
        self._player.toggle()

    @Slot()
    def Stop(self) -> None:  # noqa: N802
        """Take the force away, and stand still."""
        self._player.stop_force()

    @Slot()
    def Next(self) -> None:  # noqa: N802
        """There is no next clip."""

    @Slot()
    def Previous(self) -> None:  # noqa: N802
        """There is no clip before."""

    @Slot("qlonglong")
    def Seek(self, by_us: int) -> None:  # noqa: N802
        """Go some microseconds forwards or backwards."""
        self._player.seek(self._player.snapshot().media_s + by_us / _US)

    @Slot(QDBusObjectPath, "qlonglong")
    def SetPosition(self, _track: QDBusObjectPath, to_us: int) -> None:  # noqa: N802
        """Go to a position."""
        source = self._player.snapshot().source
        if source is not None and 0 <= to_us <= _US * source.clip.duration_s:
            self._player.seek(to_us / _US)
