"""Media keys and the desktop's player controls (MPRIS 2.2), through D-Bus; idle inhibition."""

import xml.etree.ElementTree as ET
from collections.abc import Callable
from typing import Any, NamedTuple

from jeepney import (
    DBusAddress,
    HeaderFields,
    Message,
    MessageFlag,
    MessageType,
    message_bus,
    new_error,
    new_method_return,
    new_signal,
)
from jeepney.io.blocking import DBusConnection
from PySide6.QtCore import QObject, QSocketNotifier
from PySide6.QtWidgets import QMainWindow

from app.bridge.idle import IdleInhibitor, connect
from hapticplayer.playback.player import FASTEST, SLOWEST, Player

NAME = "org.mpris.MediaPlayer2.hapticplayer"
PATH = "/org/mpris/MediaPlayer2"
ROOT, PLAYER = "org.mpris.MediaPlayer2", "org.mpris.MediaPlayer2.Player"
_DBUS = "org.freedesktop.DBus"
_PROPERTIES, _INTROSPECTION = f"{_DBUS}.Properties", f"{_DBUS}.Introspectable"
_CHANGING = ("PlaybackStatus", "Rate", "CanSeek", "CanPlay", "CanPause", "Metadata")
_DO_NOT_QUEUE = 4
_US = 1e6


class _Property(NamedTuple):
    """Signature, and how it is read."""

    signature: str
    get: Callable[[], Any]


class _Method(NamedTuple):
    """Signatures of arguments (of one letter each) and result, and what is called."""

    signature: str
    call: Callable[..., object]
    result: str = ""


class _UnknownPropertyError(LookupError):
    """Another program asks for a property that there is not."""


class Mpris:
    """Offers the player on the session's bus while it is switched on."""

    def __init__(
        self,
        player: Player,
        raise_window: Callable[[], object],
        close: Callable[[], object],
        address: str = "",
        called: Callable[[], object] = lambda: None,
    ) -> None:
        self._player, self._called = player, called
        self._address = address
        self._bus: DBusConnection | None = None
        self._sent: dict[str, Any] = {}
        self._methods = {
            ROOT: {"Raise": _Method("", raise_window), "Quit": _Method("", close)},
            PLAYER: {
                "Play": _Method("", player.play),
                "Pause": _Method("", player.pause),
                "PlayPause": _Method("", player.toggle),
                "Stop": _Method("", player.stop_force),
                "Next": _Method("", lambda: None),
                "Previous": _Method("", lambda: None),
                "Seek": _Method("x", self._seek_by),
                "SetPosition": _Method("ox", self._seek_to),
            },
            _PROPERTIES: {
                "Get": _Method("ss", self._variant, "v"),
                "GetAll": _Method("s", self._variants, "a{sv}"),
                "Set": _Method("ssv", self._set),
            },
            _INTROSPECTION: {"Introspect": _Method("", self._introspect, "s")},
        }
        self._properties = {ROOT: _root_properties(), PLAYER: self._player_properties()}

    @property
    def is_on(self) -> bool:
        """Whether others can see the player."""
        return self._bus is not None

    def switch(self, *, is_on: bool) -> None:
        """Appear on the bus, or vanish from it."""
        if is_on == self.is_on:
            return
        if is_on and (bus := connect(self._address)):
            self._bus, self._sent = bus, {}
            self._notifier = QSocketNotifier(
                bus.sock.fileno(), QSocketNotifier.Type.Read
            )
            self._notifier.activated.connect(self._read)
            self._send(message_bus.RequestName(NAME, _DO_NOT_QUEUE))
        elif self._bus:
            self._notifier.setEnabled(False)
            self._bus.close()
            self._bus = None

    def _send(self, message: Message) -> None:
        if self._bus:
            try:
                self._bus.send(message)
            except OSError:  # the bus has ended
                self.switch(is_on=False)

    def _read(self) -> None:
        try:
            while self._bus:
                message = self._bus.receive(timeout=0)
                if message.header.message_type is MessageType.method_call:
                    self._on_call(message)
        except TimeoutError:
            return  # nothing more
        except OSError:
            self.switch(is_on=False)

    def publish(self) -> None:
        """Tell the desktop what has changed since the last call."""
        if not self._bus:
            return
        now = {name: self._variant(PLAYER, name) for name in _CHANGING}
        changed = {n: v for n, v in now.items() if self._sent.get(n) != v}
        if changed:
            self._sent = now
            signal = new_signal(
                DBusAddress(PATH, interface=_PROPERTIES),
                "PropertiesChanged",
                "sa{sv}as",
                (PLAYER, changed, []),
            )
            self._send(signal)

    def _player_properties(self) -> dict[str, _Property]:
        now = self._player.snapshot
        has_clip = _Property("b", lambda: now().source is not None)
        return {
            "PlaybackStatus": _Property("s", self._status),
            "Metadata": _Property("a{sv}", self._metadata),
            "Position": _Property("x", lambda: round(_US * now().media_s)),
            "Rate": _Property("d", lambda: now().speed),
            "MinimumRate": _Property("d", lambda: SLOWEST),
            "MaximumRate": _Property("d", lambda: FASTEST),
            "CanGoNext": _Property("b", lambda: False),
            "CanGoPrevious": _Property("b", lambda: False),
            "CanControl": _Property("b", lambda: True),
            "CanPlay": has_clip,
            "CanPause": has_clip,
            "CanSeek": has_clip,
        }

    def _status(self) -> str:
        now = self._player.snapshot()
        if now.source is None:
            return "Stopped"
        return "Playing" if now.is_playing else "Paused"

    def _metadata(self) -> dict[str, Any]:
        source = self._player.snapshot().source
        if source is None:
            return {"mpris:trackid": ("o", f"{PATH}/TrackList/NoTrack")}
        return {
            "mpris:trackid": ("o", "/org/hapticplayer/clip"),
            "mpris:length": ("x", round(_US * source.clip.duration_s)),
            "xesam:title": ("s", source.title),
        }

    # --- what others call ------------------------------------------------------

    def _on_call(self, call: Message) -> None:
        self._called()
        fields = call.header.fields
        name = fields.get(HeaderFields.member)
        interface = fields.get(HeaderFields.interface)
        known = self._methods.get(interface, {})
        if not interface:
            known = {
                n: m for all_of in self._methods.values() for n, m in all_of.items()
            }
        method = known.get(name)
        if fields.get(HeaderFields.path) != PATH or method is None:
            answer = new_error(call, f"{_DBUS}.Error.UnknownMethod")
        elif fields.get(HeaderFields.signature, "") != method.signature:
            answer = new_error(call, f"{_DBUS}.Error.InvalidArgs")
        else:
            answer = self._answer(call, method)
        if not call.header.flags & MessageFlag.no_reply_expected:
            self._send(answer)

    def _answer(self, call: Message, method: _Method) -> Message:
        try:
            result = method.call(*call.body)
        except _UnknownPropertyError:
            return new_error(call, f"{_DBUS}.Error.UnknownProperty")
        if method.result:
            return new_method_return(call, method.result, (result,))
        return new_method_return(call)

    def _variant(self, interface: str, name: str) -> tuple[str, Any]:
        known = self._properties.get(interface, {})
        if name not in known:
            raise _UnknownPropertyError
        return known[name].signature, known[name].get()

    def _variants(self, interface: str) -> dict[str, tuple[str, Any]]:
        known = self._properties.get(interface, {})
        return {name: self._variant(interface, name) for name in known}

    def _set(self, interface: str, name: str, value: tuple[str, Any]) -> None:
        if (interface, name, value[0]) != (PLAYER, "Rate", "d"):
            raise _UnknownPropertyError
        self._player.set_speed(value[1])

    def _seek_by(self, by_us: int) -> None:
        self._player.seek(self._player.snapshot().media_s + by_us / _US)

    def _seek_to(self, _track: str, to_us: int) -> None:
        source = self._player.snapshot().source
        if source is not None and 0 <= to_us <= _US * source.clip.duration_s:
            self._player.seek(to_us / _US)

    def _introspect(self) -> str:
        root = ET.Element("node")
        for interface, methods in self._methods.items():
            node = ET.SubElement(root, "interface", name=interface)
            for name, method in methods.items():
                at = ET.SubElement(node, "method", name=name)
                for kind in method.signature:
                    ET.SubElement(at, "arg", type=kind, direction="in")
                if method.result:
                    ET.SubElement(at, "arg", type=method.result, direction="out")
            for name, one in self._properties.get(interface, {}).items():
                access = "readwrite" if name == "Rate" else "read"
                ET.SubElement(
                    node, "property", name=name, type=one.signature, access=access
                )
        return ET.tostring(root, encoding="unicode")


def _root_properties() -> dict[str, _Property]:
    return {
        "CanQuit": _Property("b", lambda: True),
        "CanRaise": _Property("b", lambda: True),
        "HasTrackList": _Property("b", lambda: False),
        "Identity": _Property("s", lambda: "hapticplayer"),
        "DesktopEntry": _Property("s", lambda: "hapticplayer"),
        "SupportedUriSchemes": _Property("as", list),
        "SupportedMimeTypes": _Property("as", list),
    }


class Desktop(QObject):
    """Follows the player; the window calls it when something has changed."""

    def __init__(
        self, player: Player, window: QMainWindow, called: Callable[[], object]
    ) -> None:
        super().__init__(window)
        self._player = player
        self.idle = IdleInhibitor()
        self.mpris = Mpris(player, window.raise_, window.close, called=called)

    def follow(self) -> None:
        """Inhibit idling while it plays, and publish the state."""
        is_playing = self._player.snapshot().is_playing
        self.idle.set_wanted(self.tr("playing a clip") if is_playing else "")
        self.mpris.publish()

    def begin(self) -> None:
        """Appear on the session's bus."""
        self.mpris.switch(is_on=True)

    def set_study_mode(self, *, is_on: bool) -> None:
        """Disable the media keys during a session of a study."""
        self.mpris.switch(is_on=not is_on)

    def close(self) -> None:
        """Let the screen sleep, and leave the bus."""
        self.idle.release()
        self.mpris.switch(is_on=False)
