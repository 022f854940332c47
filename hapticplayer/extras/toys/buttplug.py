"""Vibrating toys through Intiface, by the Buttplug protocol (versions 4 and 3).

Source: docs.buttplug.io. Every message is a list of objects with one key. The newest
strength counts; a device is commanded no faster than it accepts. The server stops all
devices when its client is gone, or does not ping in time: pings come from the loop, and
the guard shuts the connection down.
"""

import json
import os
import socket
from collections.abc import Callable
from typing import Any, NamedTuple

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.descriptor_passing import hand_over, take_over
from hapticplayer.devices.options import DeviceOptions, service_options
from hapticplayer.devices.paced import FULL_LEVEL, PacedDriver, Rumble
from hapticplayer.devices.websocket import OPENING_S, Connection
from hapticplayer.errors import DeviceError
from hapticplayer.extras.toys.extension import BUTTPLUG
from hapticplayer.model.device import Vector
from hapticplayer.model.ranges import finite_number

DEFAULT = "127.0.0.1:12345"
TITLE = "Intiface"
REFRESH_S = 1.0
OVERDUE_S = 0.3
"""An answer comes when a device has taken its strength, which Bluetooth delays."""
_VIBRATE = "Vibrate"
_ID = 1
_PINGS_PER_LIMIT = 3.0


class Motor(NamedTuple):
    """A motor that vibrates: of which device, which of its features, how many steps."""

    device: int
    feature: int
    steps: int


class ButtplugTranslator:
    """A force as messages for all motors (`paced.Translator`)."""

    def __init__(self, motors: list[Motor], version: int) -> None:
        self._motors, self._version = motors, version
        self._rumble = Rumble()
        stop = ("StopCmd", {"Inputs": True, "Outputs": True})
        self.off = _text([stop if version >= 4 else ("StopAllDevices", {})])

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the messages for a force."""
        level = self._rumble.levels(force_n, now_s)[0]
        if not level:
            return self.off
        share = level / FULL_LEVEL
        say = self._newer if self._version >= 4 else self._older
        return _text([say(motor, share) for motor in self._motors])

    def buttons(self, report: bytes) -> int | None:
        """Return that none is pressed; None for what is no list of messages."""
        return 0 if _messages(report) else None

    @staticmethod
    def _newer(motor: Motor, share: float) -> tuple[str, dict[str, Any]]:
        command = {_VIBRATE: {"Value": round(share * motor.steps)}}
        at = {"DeviceIndex": motor.device, "FeatureIndex": motor.feature}
        return "OutputCmd", {**at, "Command": command}

    @staticmethod
    def _older(motor: Motor, share: float) -> tuple[str, dict[str, Any]]:
        scalar = {"Index": motor.feature, "Scalar": share, "ActuatorType": _VIBRATE}
        return "ScalarCmd", {"DeviceIndex": motor.device, "Scalars": [scalar]}


class ButtplugPort:
    """Intiface with at least one motor (`paced.Port`).

    Args:
        where: HOST:PORT.
        line: along which the guard gets the connection.
        clock: for pings and answers.
        overdue_s: after so long an answer is missing.

    Raises:
        DeviceError: when it does not answer, or nothing that vibrates is connected.
    """

    def __init__(
        self, where: str, line: int, clock: Clock, overdue_s: float = OVERDUE_S
    ) -> None:
        self._where, self._clock, self._overdue_s = where, clock, overdue_s
        self._owed_since_s: float | None = None
        try:
            self._socket, self._version, self._ping_s = self._greeted(4)
        except _OlderServerError:
            self._socket, self._version, self._ping_s = self._greeted(3)
        try:
            listed = self._asked(self._socket, "RequestDeviceList", {}, "DeviceList")
            motors, self._gap_s = motors_of(listed, self._version)
        except DeviceError:
            self._socket.close()
            raise
        self.translator = ButtplugTranslator(motors, self._version)
        self._pinged_s = self._clock.now_s()
        hand_over(line, self._socket.fileno())

    @property
    def is_quiet(self) -> bool:
        """Whether no answer is overdue; each message gets one."""
        since_s = self._owed_since_s
        return since_s is None or self._clock.now_s() - since_s < self._overdue_s

    def write(self, command: bytes) -> None:
        """Send messages, and wait for the timing gap of the devices."""
        if self._owed_since_s is None:
            self._owed_since_s = self._clock.now_s()
        self._socket.send(command.decode())
        self._clock.sleep_until(self._clock.now_s() + self._gap_s)

    def read(self) -> bytes:
        """Return the next message; pings the server when it is time."""
        now_s = self._clock.now_s()
        if self._ping_s and now_s - self._pinged_s >= self._ping_s / _PINGS_PER_LIMIT:
            self._pinged_s = now_s
            self._socket.send(_text([("Ping", {})]).decode())
        received = self._socket.receive()
        if received:
            self._owed_since_s = None
        return received.encode() if isinstance(received, str) else received

    def close(self) -> None:
        """Let go; the server stops all devices."""
        self._socket.close()

    def _greeted(self, version: int) -> tuple[Connection, int, float]:
        """Return a connection, its version, and the longest time between pings, s."""
        opened = Connection(f"ws://{self._where}", TITLE)
        newer = {"ProtocolVersionMajor": 4, "ProtocolVersionMinor": 0}
        wanted = newer if version >= 4 else {"MessageVersion": 3}
        try:
            info = self._asked(
                opened,
                "RequestServerInfo",
                {"ClientName": "hapticplayer", **wanted},
                "ServerInfo",
            )
        except DeviceError as problem:
            opened.close()
            if version >= 4:
                raise _OlderServerError(str(problem)) from problem
            raise
        named = info.get("ProtocolVersionMajor", info.get("MessageVersion", 3))
        speaks, ping_ms = (
            finite_number(named),
            finite_number(info.get("MaxPingTime", 0)),
        )
        if speaks is None or ping_ms is None:
            opened.close()
            raise DeviceError(
                "Intiface at {where} gives no version or no ping time; update it",
                where=self._where,
            )
        return opened, min(version, int(speaks)), ping_ms / 1000.0

    def _asked(
        self, opened: Connection, name: str, more: dict[str, Any], answer: str
    ) -> dict[str, Any]:
        """Ask, and return the answer of that name."""
        opened.send(_text([(name, more)]).decode())
        until_s = self._clock.now_s() + OPENING_S
        while (left_s := until_s - self._clock.now_s()) > 0.0:
            for kind, content in _messages(opened.receive(left_s)):
                if kind == answer:
                    return content
                if kind == "Error":
                    raise DeviceError(
                        "Intiface at {where} refuses: {reason}; update it",
                        where=self._where,
                        reason=str(content.get("ErrorMessage", ""))[:200],
                    )
        raise DeviceError(
            "Intiface at {where} does not answer {name}; restart it",
            where=self._where,
            name=name,
        )


class _OlderServerError(DeviceError):
    """The server does not speak version 4."""


def motors_of(listed: dict[str, Any], version: int) -> tuple[list[Motor], float]:
    """Return the motors of a DeviceList, and the longest gap between messages, s."""
    motors, gap_s = [], 0.0
    try:
        devices = listed["Devices"]
        for device in devices.values() if isinstance(devices, dict) else devices:
            if found := (_newer if version >= 4 else _older)(device):
                motors += found
                gap_ms = float(device.get("DeviceMessageTimingGap") or 0.0)
                gap_s = max(gap_s, min(1.0, 1e-3 * gap_ms))
    except (
        AttributeError,
        KeyError,
        IndexError,
        OverflowError,
        TypeError,
        ValueError,
    ) as problem:
        raise DeviceError(
            "Intiface describes a device in a way that is not known: {reason}; update it",
            reason=str(problem)[:200],
        ) from problem
    if not motors:
        raise DeviceError(
            "Intiface has no device that vibrates; connect one in Intiface and choose "
            "the device again"
        )
    return motors, gap_s


def _newer(device: dict[str, Any]) -> list[Motor]:
    number = int(device["DeviceIndex"])
    features = device["DeviceFeatures"].items()
    return [
        Motor(number, int(key), int(feature["Output"][_VIBRATE]["Value"][1]))
        for key, feature in features
        if _VIBRATE in feature.get("Output", {})
    ]


def _older(device: dict[str, Any]) -> list[Motor]:
    number = int(device["DeviceIndex"])
    scalars = device["DeviceMessages"].get("ScalarCmd", [])
    return [
        Motor(number, index, int(scalar["StepCount"]))
        for index, scalar in enumerate(scalars)
        if scalar.get("ActuatorType") == _VIBRATE
    ]


def _text(messages: list[tuple[str, dict[str, Any]]]) -> bytes:
    found = [{name: {"Id": _ID, **content}} for name, content in messages]
    return json.dumps(found, separators=(",", ":")).encode()


def _messages(text: str | bytes) -> list[tuple[str, dict[str, Any]]]:
    """Return the messages in a text; none for nonsense."""
    try:
        found = json.loads(text)
        return [(name, dict(one[name])) for one in found for name in one]
    except (OverflowError, RecursionError, TypeError, ValueError):
        return []


def buttplug_options(text: str) -> DeviceOptions:
    """Intiface on this machine, or at HOST:PORT; raises DeviceError."""
    return service_options(text, DEFAULT, BUTTPLUG)


def make(line: int, options: DeviceOptions) -> PacedDriver:
    """The driver of what Intiface has."""
    return PacedDriver(
        "buttplug",
        BUTTPLUG,
        lambda: ButtplugPort(options.address, line, SystemClock()),
        REFRESH_S,
    )


def silence(line: int, _options: object = None) -> Callable[[], bool]:
    """The shutdown of the connection, for the guard: the server stops all."""
    held: list[int] = []  # as long as the guard lives

    def write_zero() -> bool:
        newest = take_over(line)
        if newest is not None:
            held[:] = [newest[0]]
        try:
            for number in held:
                with socket.socket(fileno=os.dup(number)) as connection:
                    connection.shutdown(socket.SHUT_RDWR)
        except OSError:
            return False  # it is closed
        return True

    return write_zero
