"""Vibrating toys through Intiface, by the Buttplug protocol (versions 4 and 3).

The newest strength counts; a device is commanded no faster than it accepts. The server
stops all devices when its client is gone, or does not ping in time: pings come from the
loop, and the guard shuts the connection down.
"""

import contextlib
import math
import os
import socket
from collections.abc import Callable
from typing import Any

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.descriptor_passing import hand_over, take_over
from hapticplayer.devices.options import DeviceOptions, service_options
from hapticplayer.devices.paced import FULL_LEVEL, PacedDriver, Rumble
from hapticplayer.devices.websocket import OPENING_S, Connection
from hapticplayer.errors import DeviceError, Message, message_of
from hapticplayer.extras.toys.extension import BUTTPLUG
from hapticplayer.extras.toys.messages import (
    ANSWERED,
    VIBRATE,
    Motor,
    Removed,
    ServerInfo,
    Toy,
    Toys,
    error_text,
    is_list,
    messages_in,
    text_of,
    toys_of,
)
from hapticplayer.model.device import Vector
from hapticplayer.structures import understood

DEFAULT = "127.0.0.1:12345"
TITLE = "Intiface"
REFRESH_S = 1.0
OVERDUE_S = 0.3
"""An answer comes when a device has taken its strength, which Bluetooth delays."""
LEAST_GAP_S = 0.02
STILL_S = 0.3
"""The stop at the end waits so long for its answer, which may be an error."""
MOST_ERRORS = 3
"""So many answers in a row that are errors: nothing is felt any more."""
_PINGS_PER_LIMIT = 3.0
_MOST_SAID = 120
_REMEDIES = {  # by the kind of an error, as the protocol has them
    2: Message("close other programs, or give pings more time in Intiface"),
    4: Message("see whether the toy is connected and charged"),
}
_UPDATE = Message("update or restart it")
_NONSENSE = b"?"
"""Stands for what makes no sense; the loop counts it."""


class ButtplugTranslator:
    """A force as messages for all motors (`paced.Translator`)."""

    def __init__(self, motors: list[Motor], version: int) -> None:
        self.motors, self._version = motors, version
        self._rumble = Rumble()
        stop = ("StopCmd", {"Inputs": True, "Outputs": True})
        self.off = text_of(stop if version >= 4 else ("StopAllDevices", {}))

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the messages for a force."""
        level = self._rumble.levels(force_n, now_s)[0]
        if not level:
            return self.off
        share = level / FULL_LEVEL
        say = self._newer if self._version >= 4 else self._older
        return text_of(*(say(motor, share) for motor in self.motors))

    def buttons(self, report: bytes) -> int | None:
        """Return that none is pressed; None for what is no list of messages."""
        return 0 if is_list(report) else None

    @staticmethod
    def _newer(motor: Motor, share: float) -> tuple[str, dict[str, Any]]:
        command = {VIBRATE: {"Value": round(share * motor.steps)}}
        at = {"DeviceIndex": motor.device, "FeatureIndex": motor.feature}
        return "OutputCmd", {**at, "Command": command}

    @staticmethod
    def _older(motor: Motor, share: float) -> tuple[str, dict[str, Any]]:
        scalar = {"Index": motor.feature, "Scalar": share, "ActuatorType": VIBRATE}
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
        self._where, self._clock = where, clock
        self._owed_since_s: dict[int, float] = {}  # by the number of the message
        self._errors, self._nonsense, self.notice = 0, 0, Message("")
        try:
            self._socket, info = self._greeted(4)
        except _OlderServerError:
            self._socket, info = self._greeted(3)
        self._version, self._ping_s = min(4, info.version), 1e-3 * info.max_ping_time
        try:
            listed = self._asked(self._socket, "RequestDeviceList", {}, "DeviceList")
            self._toys = self._vibrating(listed)
        except DeviceError:
            self._socket.close()
            raise
        gap_s = max(toy.gap_s for toy in self._toys.values())
        self.pace_s = max(gap_s, LEAST_GAP_S) if gap_s else 0.0
        self._overdue_s = overdue_s + self.pace_s
        motors = [motor for toy in self._toys.values() for motor in toy.motors]
        self.translator = ButtplugTranslator(motors, self._version)
        self._pinged_s = self._clock.now_s()
        hand_over(line, self._socket.fileno())

    def _vibrating(self, listed: Any) -> dict[int, Toy]:
        toys = self._understood(listed)
        if toys.found:
            return toys.found
        raise DeviceError(
            "Intiface has no device that vibrates; connect one in Intiface and choose "
            "the device again"
        )

    @property
    def _name(self) -> str:
        return f"{TITLE} at {self._where}"

    def _understood(self, listed: Any) -> Toys:
        toys = toys_of(listed, self._version, self._name)
        if toys.refused and not self.notice:
            self.notice = Message("a device is left out: {reason}", reason=toys.refused)
        return toys

    @property
    def is_quiet(self) -> bool:
        """Whether no answer is overdue; each message gets one with its number."""
        since_s = min([*self._owed_since_s.values()], default=math.inf)
        if self._clock.now_s() - since_s < self._overdue_s:
            return True
        if not self.notice:
            self.notice = Message(
                "{where} does not answer; see whether the toy is connected and charged, "
                "and restart Intiface",
                where=self._name,
            )
        return False

    @property
    def is_owed(self) -> bool:
        """Whether the answer to a stop may still come."""
        since_s = self._owed_since_s.get(ANSWERED["StopCmd"], -math.inf)
        return self._clock.now_s() - since_s < STILL_S

    def write(self, command: bytes) -> None:
        """Send messages."""
        for name, _ in messages_in(command, self._name):
            self._owed_since_s.setdefault(ANSWERED[name], self._clock.now_s())
        self._socket.send(command.decode())

    def read(self) -> bytes:
        """Return the next message; pings the server when it is time."""
        received = self._received()
        self._ping(self._clock.now_s())
        if not received:
            return b""
        if (heard := self._heard(received)) is None:
            self._nonsense += 1
            if self._nonsense == MOST_ERRORS:
                self.notice = Message(
                    "{where} sends messages that make no sense; restart it",
                    where=self._name,
                )
            return _NONSENSE
        for kind, left, content in heard:
            self._keep(left)
            self._note_answer(content.get("Id"))
            self._count_error(content, is_error=kind == "Error")
        if not self.is_quiet:
            return b""  # an answer to a stop is none to the strength that is owed
        return received.encode() if isinstance(received, str) else received

    def _ping(self, now_s: float) -> None:
        if self._ping_s and now_s - self._pinged_s >= self._ping_s / _PINGS_PER_LIMIT:
            self._pinged_s = now_s
            with contextlib.suppress(DeviceError):  # the next reading says why
                self.write(text_of(("Ping", {})))

    def _received(self) -> str | bytes:
        """The next message; a server says why before it goes."""
        try:
            return self._socket.receive()
        except DeviceError as problem:
            raise DeviceError(self.notice) if self._errors else problem from problem

    def _note_answer(self, number: Any) -> None:
        """Note what has been answered; a number that nothing has stands for all."""
        if number in ANSWERED.values():  # again, of the second of two stops
            self._owed_since_s.pop(number, None)
        elif number:  # 0 is no answer
            self._owed_since_s.clear()

    def close(self) -> None:
        """Let go; the server stops all devices."""
        self._socket.close()

    def _heard(
        self, received: str | bytes
    ) -> list[tuple[str, set[int], dict[str, Any]]] | None:
        """Of each message its kind, the toys after it, its content; None of nonsense."""
        try:
            return [
                (kind, self._left(kind, content), content)
                for kind, content in messages_in(received, self._name)
            ]
        except DeviceError:
            return None

    def _left(self, kind: str, content: dict[str, Any]) -> set[int]:
        """The numbers of the toys that are there after a message."""
        if kind == "DeviceList":
            return {*self._understood(content).found}
        if kind == "DeviceRemoved":
            return {*self._toys} - {
                understood(content, Removed, self._name).device_index
            }
        return {*self._toys}

    def _keep(self, left: set[int]) -> None:
        """Go on with these toys; raises DeviceError when there is none any more."""
        gone = {n: toy for n, toy in self._toys.items() if n not in left}
        if not gone:
            return
        names = ", ".join(toy.name or str(number) for number, toy in gone.items())
        self._toys = {n: toy for n, toy in self._toys.items() if n in left}
        what = Message(
            "{toy} has left Intiface; connect it there and choose the device again",
            toy=names[:_MOST_SAID],
        )
        if not self._toys:
            raise DeviceError(what)
        self.notice = what
        self.translator.motors = [
            motor for motor in self.translator.motors if motor.device in left
        ]

    def _count_error(self, content: dict[str, Any], *, is_error: bool) -> None:
        """Report an error; raises DeviceError when there are too many in a row."""
        self._errors = self._errors + 1 if is_error else 0
        if not is_error:
            return
        code = content.get("ErrorCode")
        self.notice = Message(
            "{where} reports an error ({reason}); {remedy}, and choose the device again",
            where=self._name,
            reason=error_text(content),
            remedy=_REMEDIES.get(code, _UPDATE) if isinstance(code, int) else _UPDATE,
        )
        if self._errors >= MOST_ERRORS:
            raise DeviceError(self.notice)

    def _greeted(self, version: int) -> tuple[Connection, ServerInfo]:
        """Return a connection and what the server says of itself."""
        opened = Connection(f"ws://{self._where}", TITLE)
        newer = {"ProtocolVersionMajor": 4, "ProtocolVersionMinor": 0}
        wanted = newer if version >= 4 else {"MessageVersion": 3}
        try:
            said = self._asked(
                opened,
                "RequestServerInfo",
                {"ClientName": "hapticplayer", **wanted},
                "ServerInfo",
            )
            return opened, understood(said, ServerInfo, self._name)
        except DeviceError as problem:
            opened.close()
            if version >= 4:
                raise _OlderServerError(message_of(problem)) from problem
            raise

    def _asked(
        self, opened: Connection, name: str, more: dict[str, Any], answer: str
    ) -> dict[str, Any]:
        """Ask, and return the answer of that name."""
        opened.send(text_of((name, more)).decode())
        until_s = self._clock.now_s() + OPENING_S
        while (left_s := until_s - self._clock.now_s()) > 0.0:
            received = opened.receive(left_s)
            for kind, content in messages_in(received, self._name) if received else ():
                if kind == answer:
                    return content
                if kind == "Error":
                    raise DeviceError(
                        "{where} refuses: {reason}; update it",
                        where=self._name,
                        reason=error_text(content),
                    )
        raise DeviceError(
            "{where} does not answer {name}; restart it", where=self._name, name=name
        )


class _OlderServerError(DeviceError):
    """The server does not speak version 4."""


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
