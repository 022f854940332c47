"""The frames that Falcon and computer exchange once the firmware runs.

Both are 16 bytes: '<', three signed 16-bit words in four bytes each, lights or
buttons, an unknown byte, '>'. A byte carries one nibble as 0x41 + nibble, the least
significant one first. The Falcon answers each frame with one of its own and never
speaks first. Facts: libnifalcon's FalconFirmwareNovintSDK; no code was taken.

A frame holds no '<' or '>' but its own, so a stream is found again at any '<' that
has a '>' 15 bytes on and only allowed bytes between.
"""

import re
from abc import ABC, abstractmethod
from enum import IntFlag
from typing import Generic, NamedTuple, TypeVar

FRAME_BYTES = 16
Words = tuple[int, int, int]

_DIGITS = b"0123456789abcdef"
_TO_NIBBLES = bytes.maketrans(_DIGITS, b"ABCDEFGHIJKLMNOP")
_TO_DIGITS = bytes.maketrans(b"ABCDEFGHIJKLMNOP", _DIGITS)
_BASE = 0x41
# Byte 14 is always 0x41 as far as is known; others are let through.
_COMMAND = re.compile(rb"<[A-P]{12}[A-P][\x41-\xc0]>")
_REPLY = re.compile(rb"<[A-P]{12}[\x41-\xc0]{2}>")


class Lights(IntFlag):
    """Byte 13 to the Falcon: the ring of light, and whether homing is wanted."""

    HOMING = 1
    GREEN = 2
    BLUE = 4
    RED = 8


class MotorCommand(NamedTuple):
    """A frame for the Falcon: motor words top, right, lower left; lights."""

    words: Words
    lights: int


class Reply(NamedTuple):
    """What the Falcon answers: encoders top, right, lower left, and bit masks.

    `homed` has the encoders that have found their zero; 7 is all.
    """

    counts: Words
    buttons: int  # 1 far right, 2 towards the device, 4 with the logo, 8 far left
    homed: int

    @property
    def is_homed(self) -> bool:
        """Whether all three encoders have found their zero."""
        return self.homed == 7


def encode_command(words: Words, lights: int = 0) -> bytes:
    """Return the frame with these words; raises ValueError when one does not fit."""
    if not 0 <= lights <= 15:
        raise ValueError(f"lights {lights} are more than four bits")
    return b"<%sA>" % (_packed(words, lights))


def encode_reply(reply: Reply) -> bytes:
    """Return the Falcon's frame; raises ValueError when something does not fit."""
    if not (0 <= reply.buttons <= 15 and 0 <= reply.homed <= 7):
        raise ValueError(f"{reply} cannot be sent by a Falcon")
    return b"<%sA>" % _packed(reply.counts, reply.homed << 4 | reply.buttons)


def _packed(words: Words, last: int) -> bytes:
    i, j, k = words
    if not (
        -0x8000 <= i <= 0x7FFF and -0x8000 <= j <= 0x7FFF and -0x8000 <= k <= 0x7FFF
    ):
        raise ValueError(f"words {words} do not fit into 16 bits")
    together = (k & 0xFFFF) << 32 | (j & 0xFFFF) << 16 | (i & 0xFFFF)
    return (b"%012x" % together)[::-1].translate(_TO_NIBBLES) + bytes((_BASE + last,))


def _words(frame: bytes) -> Words:
    together = int(frame[12:0:-1].translate(_TO_DIGITS), 16)
    i, j, k = together & 0xFFFF, together >> 16 & 0xFFFF, together >> 32
    # the sign bit counts -0x8000
    return (
        (i ^ 0x8000) - 0x8000,
        (j ^ 0x8000) - 0x8000,
        (k ^ 0x8000) - 0x8000,
    )


_Frame = TypeVar("_Frame", MotorCommand, Reply)


class _FrameParser(ABC, Generic[_Frame]):
    """Finds frames in a stream that may be cut, torn or full of noise."""

    _pattern: re.Pattern[bytes]

    def __init__(self) -> None:
        self._rest = b""
        self._noise_bytes = 0

    @property
    def malformed(self) -> int:
        """Frames' worth of bytes since the last good frame that belonged to none."""
        return (self._noise_bytes + FRAME_BYTES - 1) // FRAME_BYTES

    def feed(self, data: bytes) -> list[_Frame]:
        """Return the frames that these bytes complete, oldest first."""
        stream = self._rest + data
        frames, end = [], 0
        for match in self._pattern.finditer(stream):
            frames.append(self._decode(match.group()))
            end, self._noise_bytes = match.end(), 0
        kept_from = max(end, len(stream) - FRAME_BYTES + 1)
        self._noise_bytes += kept_from - end
        self._rest = stream[kept_from:]
        return frames

    @abstractmethod
    def _decode(self, frame: bytes) -> _Frame:
        """The reply in a frame that the pattern has matched."""


class ReplyParser(_FrameParser[Reply]):
    """Finds the Falcon's frames."""

    _pattern = _REPLY

    def _decode(self, frame: bytes) -> Reply:
        flags = frame[13] - _BASE
        return Reply(_words(frame), flags & 0x0F, flags >> 4)


class CommandParser(_FrameParser[MotorCommand]):
    """Finds the computer's frames; for simulators."""

    _pattern = _COMMAND

    def _decode(self, frame: bytes) -> MotorCommand:
        return MotorCommand(_words(frame), frame[13] - _BASE)
