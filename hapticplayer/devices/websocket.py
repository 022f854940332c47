"""A service that is spoken to over a WebSocket."""

import contextlib
import json
import struct
from typing import Any

from hapticplayer.errors import DeviceError
from hapticplayer.installation import how_to_get

OPENING_S = 3.0
SHOWN = 80
"""So much of a name or text of a service is shown to people."""
_MOST_BYTES = 1 << 20
_CLOSING_S = 0.2
_WORDS = ("message", "error", "description", "reason", "name", "ErrorMessage")
_NO_ERROR = ("none", "None", "ok", "OK", "0")


def text_frame(text: str) -> bytes:
    """Return a text of at most 65535 bytes as a client's frame (RFC 6455, 5.2).

    It is masked with zeros, so that it can be read as it is.
    """
    data = text.encode()
    if len(data) < 126:
        return bytes((0x81, 0x80 | len(data), 0, 0, 0, 0)) + data
    return struct.pack(">BBHI", 0x81, 0x80 | 126, len(data), 0) + data


def reported(value: Any) -> str:
    """An error in the words of the service, whatever it holds; "" for none."""
    if isinstance(value, list) and len(value) == 1:
        return reported(value[0])
    if isinstance(value, dict):
        said = (value.get(key) for key in _WORDS)
        value = next((one for one in said if isinstance(one, str) and one), value)
    if not value or value in _NO_ERROR:
        return ""
    text = value if isinstance(value, str) else json.dumps(value, default=repr)
    shown = "".join(one if one.isprintable() else " " for one in text[:SHOWN])
    return " ".join(shown.split())


class Connection:
    """An open connection to a service, whose messages are texts.

    Args:
        url: ws://HOST:PORT/...
        title: of the service, for people.

    Raises:
        DeviceError: when nobody answers, also for all methods; and without the package
            websockets.
    """

    def __init__(self, url: str, title: str) -> None:
        self._title, self._held = title, contextlib.ExitStack()
        try:
            from websockets.exceptions import WebSocketException
            from websockets.sync.client import connect
        except ImportError as problem:
            raise DeviceError(
                "the Python package websockets is missing; install "
                "hapticplayer[websockets] ({how})",
                how=how_to_get("websockets"),
            ) from problem
        self._problems = (OSError, WebSocketException)
        try:
            connecting = connect(
                url,
                open_timeout=OPENING_S,
                close_timeout=_CLOSING_S,
                max_size=_MOST_BYTES,
                ping_interval=None,
                compression=None,
                proxy=None,
            )
            self._socket = self._held.enter_context(connecting)
        except self._problems as problem:
            raise DeviceError(
                "{title} does not answer at {url}; start it and choose the device again",
                title=title,
                url=url,
            ) from problem

    def fileno(self) -> int:
        return int(self._socket.socket.fileno())

    def send(self, text: str) -> None:
        """Send a message."""
        try:
            self._socket.send(text)
        except self._problems as problem:
            raise self._gone() from problem

    def receive(self, timeout_s: float = 0.0) -> str | bytes:
        """Return the text of the next message, "" when none has come in time."""
        try:
            received: str | bytes = self._socket.recv(timeout_s)
        except TimeoutError:
            return ""
        except self._problems as problem:
            raise self._gone() from problem
        return received

    def close(self) -> None:
        """Close the connection; may be called again."""
        with contextlib.suppress(*self._problems):
            self._held.close()

    def _gone(self) -> DeviceError:
        return DeviceError(
            "{title} has closed the connection; start it and choose the device again",
            title=self._title,
        )
