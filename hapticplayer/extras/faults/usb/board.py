"""The processors behind the chip: boot, loader and firmware, byte by byte.

Which of them answers what is an inference from the vendor's traffic (the boot
processor at 9600 baud, then the DSP's ROM loader); the bytes are facts.
"""

import enum
from dataclasses import dataclass

from hapticplayer.devices.falcon.firmware import (
    KNOWN_IMAGES,
    FirmwareImage,
    MemoryBlock,
    build_image,
    parse_image,
)
from hapticplayer.devices.falcon.firmware.loader import AUTOBAUD, HELLO, HELLO_ANSWER
from hapticplayer.devices.falcon.ftdi import HELLO_BAUD, RUN_BAUD
from hapticplayer.devices.falcon.protocol import CommandParser, encode_reply
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.mechanics import Mechanics

_LOADER_MOST_BAUD = 250_000.0
_TOLERANCE = 0.04  # of a rate; a serial line forgives about that much
_END_OF_IMAGE = b"\x00\x00"


class Stage(enum.Enum):
    """What runs on the board."""

    DARK = "waits for DTR to rise"
    BOOT = "waits for the hello"
    GREETED = "waits for DTR to fall"
    LOADER = "waits for the letter A"
    LOADING = "takes the image"
    RUNNING = "answers frames"
    DEAD = "runs something else"


@dataclass
class BoardFaults:
    """What goes wrong; all of it can be changed at any time.

    Attributes:
        hello: the answer to the hello; b"" for none.
        clear_to_send_s: after DTR has fallen the loader is deaf for so long and then
            raises CTS; None: it is ready at once and raises nothing.
        wrong_echo_at: byte of the image (the letter A is byte -1) that comes back
            wrong, once.
        echo_ends_at: from this byte of the image on nothing comes back, once.
        corrupt: so many of the next replies have a wrong byte.
        silent: so many of the next frames are not answered.
        noise: sent before the next reply, once.
    """

    hello: bytes = HELLO_ANSWER
    clear_to_send_s: float | None = 0.005
    wrong_echo_at: int | None = None
    echo_ends_at: int | None = None
    corrupt: int = 0
    silent: int = 0
    noise: bytes = b""


class Board:
    """Takes bytes from the line and returns those that it sends back.

    `mechanics` is what the motors move. A Falcon that was used before begins at
    RUNNING; `accepts_any` runs an unknown image like a known one.
    """

    def __init__(self, mechanics: Mechanics, stage: Stage = Stage.DARK) -> None:
        self.mechanics = mechanics
        self.stage = stage
        self.faults = BoardFaults()
        self.image = b""
        self.accepts_any = True
        self.clear_to_send_at_s = float("inf")
        self._heard = b""
        self._rate = 0.0
        self._parser = CommandParser()

    def set_dtr(self, *, is_high: bool, was_high: bool, at_s: float) -> None:
        """Follow the line DTR: its rise resets all, its fall starts the loader."""
        if is_high and not was_high:
            self.stage, self._heard, self.image = Stage.BOOT, b"", b""
            self.clear_to_send_at_s = float("inf")
        elif was_high and not is_high and self.stage is Stage.GREETED:
            self.stage = Stage.LOADER
            if self.faults.clear_to_send_s is not None:
                self.clear_to_send_at_s = at_s + self.faults.clear_to_send_s

    def receive(self, data: bytes, baud: float, at_s: float) -> bytes:
        """Take bytes that have arrived by `at_s`; return the answer."""
        if self.stage is Stage.BOOT or self.stage is Stage.GREETED:
            return self._greet(data) if _fits(baud, HELLO_BAUD.baud) else b""
        if self.stage is Stage.LOADER:
            return self._take_rate(data, baud, at_s)
        if self.stage is Stage.LOADING:
            return self._load(data) if _fits(baud, self._rate) else b""
        if self.stage is Stage.RUNNING and _fits(baud, RUN_BAUD.baud):
            return self._run(data, at_s)
        return b""

    def _greet(self, data: bytes) -> bytes:
        self._heard += data
        if HELLO not in self._heard:
            return b""
        self._heard = b""
        if self.faults.hello.endswith(HELLO_ANSWER):
            self.stage = Stage.GREETED
        return self.faults.hello

    def _take_rate(self, data: bytes, baud: float, at_s: float) -> bytes:
        waits = self.faults.clear_to_send_s is not None
        is_deaf = waits and at_s < self.clear_to_send_at_s
        if is_deaf or baud > _LOADER_MOST_BAUD or not data.startswith(AUTOBAUD):
            return b""
        self.stage, self._rate = Stage.LOADING, baud
        return self._echo(AUTOBAUD, -1)

    def _load(self, data: bytes) -> bytes:
        start = len(self.image)
        self.image += data
        if self.image.endswith(_END_OF_IMAGE):
            self._start()
        return self._echo(data, start)

    def _start(self) -> None:
        try:
            image = parse_image(self.image)
        except DeviceError:
            return  # not its end yet
        runs = self.accepts_any or image.sha256 in KNOWN_IMAGES
        self.stage = Stage.RUNNING if runs else Stage.DEAD

    def _echo(self, data: bytes, start: int) -> bytes:
        faults, end = self.faults, start + len(data)
        wrong, last = faults.wrong_echo_at, faults.echo_ends_at
        if last is not None and last < end:
            data, faults.echo_ends_at = data[: max(0, last - start)], None
            self.stage = Stage.DEAD
        if wrong is not None and start <= wrong < end:
            echo = bytearray(data)
            echo[wrong - start] ^= 0x10
            data, faults.wrong_echo_at = bytes(echo), None
        return data

    def _run(self, data: bytes, at_s: float) -> bytes:
        answer, faults = b"", self.faults
        for command in self._parser.feed(data):
            self.mechanics.command(command, at_s)
            if faults.silent:
                faults.silent -= 1
                continue
            reply = encode_reply(self.mechanics.reply(at_s))
            if faults.corrupt:
                faults.corrupt -= 1
                reply = reply[:5] + b"\x7f" + reply[6:]
            answer += faults.noise + reply
            faults.noise = b""
        return answer


def _fits(baud: float, expected: float) -> bool:
    return abs(baud / expected - 1.0) <= _TOLERANCE


def synthetic_image(words: int = 4000) -> FirmwareImage:
    """Return an image of the size of a real one that no processor could run."""
    block = MemoryBlock(0x3F8002, tuple(range(1, words + 1)))
    return parse_image(build_image(block.address, (block,)))
