"""TCode 0.3: boards that vibrate, by UDP or on a serial port.

Source: multiaxis/TCode-Specification. A line such as "V05000I20" sets channel V0 to half
within 20 ms; "DSTOP" stops everything. Boards keep their last target for ever, so `DSTOP`
is sent on every way out, and by the guard. They answer nothing as long as all is well: a
line that speaks of an error, and a greeting in the middle, are faults.
"""

import contextlib
import math
import os
import re
import select
import socket
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.options import (
    DeviceOptions,
    Fields,
    fields_of,
    host_and_port,
)
from hapticplayer.devices.paced import (
    FULL_LEVEL,
    PacedDriver,
    QuietPort,
    Rumble,
    silencer,
)
from hapticplayer.devices.serial_line import open_serial
from hapticplayer.devices.websocket import reported
from hapticplayer.errors import DeviceError, Message
from hapticplayer.extras.toys.extension import TCODE
from hapticplayer.model.device import DeviceCapabilities, Vector

DEFAULT = "127.0.0.1:8000"
REFRESH_S = 0.5
STOP = b"DSTOP\n"
FULL_S = 0.25
MOST_ERRORS, IN_A_ROW_S = 3, 1.0
"""So many errors, none longer after the one before: nothing is felt any more."""
GREETING_S = 3.0
"""A board that opening has reset greets so long after it."""
_ERROR = re.compile(
    rb"(?<!no )(?<!0 )(?<![a-z])err(or)?s?(?![a-z])"
    rb"|\b(fail|invalid|unknown|panic|overh|brown)",
    re.IGNORECASE,
)
_GREETING = re.compile(rb"\btcode\b|\brst:|\bboot|\brestart|\breset\b", re.IGNORECASE)
_LEAST_GREETING = 5
_FULL, _RAMP_MS = 9999, 20
_MOST_READ, _LONGEST_LINE = 256, 1024
_SERIAL_BAUD = 115_200


@dataclass(frozen=True, slots=True)
class TcodeOptions(DeviceOptions):
    """HOST:PORT or a serial port, and which channel of it vibrates."""

    capabilities: DeviceCapabilities = TCODE
    address: str = DEFAULT
    channel: str = "V0"


class TcodeTranslator:
    """A force as the strength of one channel (`paced.Translator`)."""

    def __init__(self, channel: str) -> None:
        self._channel, self._rumble = channel, Rumble()
        self.off = f"{channel}0000\n".encode() + STOP

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the line for a force."""
        level = self._rumble.levels(force_n, now_s)[0]
        if not level:
            return self.off
        share = level * _FULL // FULL_LEVEL
        return f"{self._channel}{share:04}I{_RAMP_MS}\n".encode()

    def buttons(self, report: bytes) -> int | None:
        """Return that none is pressed; a board has none."""
        return 0 if report.isascii() else None


class TCodePort(QuietPort):
    """A board at the other end of a descriptor (`paced.Port`)."""

    def __init__(
        self,
        descriptor: int,
        where: str,
        translator: TcodeTranslator,
        clock: Clock | None = None,
    ) -> None:
        self.translator, self._where = translator, where
        self._clock = clock or SystemClock()
        self._heard, self._greetings = b"", Counter[bytes]()
        self._errors, self._error_s = 0, -math.inf
        self._opened_s = self._clock.now_s()
        self._descriptor: int | None = descriptor
        os.set_blocking(descriptor, False)

    def write(self, command: bytes) -> None:
        """Send whole lines; a board that takes none for `FULL_S` has gone."""
        with self._failing_at_once():
            while command:
                if not select.select([], [self._open()], [], FULL_S)[1]:
                    raise TimeoutError
                command = command[os.write(self._open(), command) :]

    def read(self) -> bytes:
        """What the board says; raises DeviceError for errors in a row."""
        report = b""
        with self._failing_at_once(), contextlib.suppress(BlockingIOError):
            report = os.read(self._open(), _MOST_READ)
            if not report and self._where.startswith("/"):
                raise BrokenPipeError  # of a line; a datagram may be empty
        if report:
            *lines, left = re.split(rb"[\r\n]+", self._heard + report)
            self._heard = left[-_LONGEST_LINE:]
            for line in filter(None, lines):
                self._note(line, self._clock.now_s())
        return report

    def _note(self, line: bytes, now_s: float) -> None:
        """Note a line that the board says by itself."""
        if _ERROR.search(line):
            is_next = now_s - self._error_s < IN_A_ROW_S
            self._errors, self._error_s = self._errors * is_next + 1, now_s
            self.notice = Message(
                "the board at {where} reports an error ({said}); check its channel, "
                "cable and supply, and choose the device again",
                where=self._where,
                said=_shown(line),
            )
            if self._errors >= MOST_ERRORS:
                raise DeviceError(self.notice)
        elif now_s - self._opened_s < GREETING_S:
            self._greetings[line] += len(line) >= _LEAST_GREETING
        elif self._greetings[line] == 1 or _GREETING.search(line):
            self.notice = Message(
                "the board at {where} has restarted ({said}); check its supply and cable",
                where=self._where,
                said=_shown(line),
            )

    def close(self) -> None:
        """Release the device."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    def _open(self) -> int:
        if self._descriptor is None:
            raise self._gone()
        return self._descriptor

    @contextlib.contextmanager
    def _failing_at_once(self) -> Iterator[None]:
        try:
            yield
        except OSError as problem:
            self.close()  # a datagram's failure is reported once
            raise self._gone() from problem

    def _gone(self) -> DeviceError:
        return DeviceError(
            "nothing takes TCode at {where} any more; connect it and choose the device "
            "again",
            where=self._where,
        )


def _shown(line: bytes) -> str:
    return reported(line.decode(errors="replace"))


def tcode_options(text: str) -> TcodeOptions:
    """What follows "tcode:", such as "/dev/ttyUSB0,channel=V1"; raises DeviceError."""
    return TcodeOptions(
        **fields_of("tcode", text, _board, {"channel": ("channel", _channel)})
    )


def _board(part: str) -> Fields:
    if not part.startswith("/"):
        host_and_port(part)
    return {"address": part}


def _channel(_name: str, text: str) -> str:
    if not re.fullmatch(r"[LRVA]\d", text):
        raise DeviceError("use L, R, V or A and a digit, such as V0")
    return text


def open_board(options: TcodeOptions, clock: Clock | None = None) -> TCodePort:
    """The board, open; raises DeviceError."""
    where = options.address
    try:
        descriptor = (
            open_serial(where, _SERIAL_BAUD) if where.startswith("/") else _udp(where)
        )
    except OSError as problem:
        raise DeviceError(
            "{where} cannot be opened: {reason}; see whether the board is connected and "
            "you may use it",
            where=where,
            reason=problem.strerror or str(problem),
        ) from problem
    return TCodePort(descriptor, where, TcodeTranslator(options.channel), clock)


def _udp(where: str) -> int:
    host, port = host_and_port(where)
    family, kind, protocol, _, address = socket.getaddrinfo(
        host, port, type=socket.SOCK_DGRAM
    )[0]
    with socket.socket(family, kind, protocol) as end:
        end.connect(address)
        return end.detach()


def make(_line: int, options: TcodeOptions) -> PacedDriver:
    return PacedDriver("tcode", TCODE, lambda: open_board(options), REFRESH_S)


def silence(_line: int, options: TcodeOptions) -> Callable[[], bool]:
    """What stops a board, for the guard."""
    return silencer(lambda: open_board(options))
