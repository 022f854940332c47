"""Packets between a player and the process of the simulated Falcon.

Little-endian and of fixed size: four bytes that name the kind, a serial number,
the sender's CLOCK_MONOTONIC, a payload, and the CRC-32 of everything before it.
A packet that was corrupted on its way is therefore recognised.
"""

import enum
import math
import struct
import zlib
from typing import NamedTuple

from hapticplayer.model.device import DeviceReading, Vector

_COMMAND = struct.Struct("<4sIdddd")
_REPLY = struct.Struct("<4sIddddHBx")
_CONTROL = struct.Struct("<4sIdB7x")
_CHECKSUM_BYTES = 4
_SEALED_COMMAND = struct.Struct("<4sIddddI")
_SEALED_REPLY = struct.Struct("<4sIddddHBxI")
_COMMAND_MAGIC, _REPLY_MAGIC, _CONTROL_MAGIC = b"HPf1", b"HPr1", b"HPc1"
SERIAL_MASK = 0xFFFFFFFF
MAX_BYTES = 256


class ForceCommand(NamedTuple):
    """A force in N, frame D, and when it was commanded."""

    serial: int
    stamp_s: float
    force_n: Vector


class ScriptedEvent(enum.IntEnum):
    """Something that a test makes happen to the device; `value` says how much."""

    HELLO = 0  # nothing happens; asks whether anybody is there
    LET_GO = 1
    GRASP = 2
    BUTTONS = 3  # bit mask of those that are pressed
    UNPLUG = 4
    STALL = 5  # seconds
    CORRUPT = 6  # number of replies
    LOSE_HOMING = 7


class Control(NamedTuple):
    """One event, with how much of it."""

    event: ScriptedEvent
    value: float = 0.0


Packet = ForceCommand | Control


def command_bytes(serial: int, stamp_s: float, force_n: Vector) -> bytes:
    """Return the bytes of a command; its fields, and no `ForceCommand`, because it is at 1 kHz."""
    x, y, z = force_n
    number = serial & SERIAL_MASK
    return _sealed(_COMMAND.pack(_COMMAND_MAGIC, number, stamp_s, x, y, z))


def pack_reply(serial: int, reading: DeviceReading) -> bytes:
    """Return the bytes of the answer to a command, as of `replied_s`."""
    (x, y, z), buttons, is_homed, stamp_s, *_ = reading
    number = serial & SERIAL_MASK
    body = _REPLY.pack(_REPLY_MAGIC, number, stamp_s, x, y, z, buttons, is_homed)
    return _sealed(body)


def pack_control(control: Control) -> bytes:
    return _sealed(_CONTROL.pack(_CONTROL_MAGIC, 0, control.value, control.event))


def unpack(data: bytes) -> Packet | None:
    """Return the command or event in the bytes, or None if they make no sense.

    None covers another size, kind or checksum, and numbers that are not finite.
    """
    body = data[:-_CHECKSUM_BYTES]
    if len(data) == _SEALED_COMMAND.size:
        kind, serial, stamp_s, x, y, z, checksum = _SEALED_COMMAND.unpack(data)
        is_sound = kind == _COMMAND_MAGIC and zlib.crc32(body) == checksum
        if is_sound and math.isfinite(stamp_s + x + y + z):
            return ForceCommand(serial, stamp_s, (x, y, z))
    elif len(body) == _CONTROL.size and data[len(body) :] == _checksum(body):
        kind, _, value, event = _CONTROL.unpack(body)
        is_known = event in ScriptedEvent.__members__.values() and math.isfinite(value)
        if kind == _CONTROL_MAGIC and is_known:
            return Control(ScriptedEvent(event), value)
    return None


def read_reply(data: bytes) -> tuple[int, DeviceReading] | None:
    """Return serial number and reading of a reply; None as for `unpack`."""
    if len(data) != _SEALED_REPLY.size:
        return None
    kind, serial, stamp_s, x, y, z, buttons, homed, checksum = _SEALED_REPLY.unpack(
        data
    )
    is_sound = kind == _REPLY_MAGIC and zlib.crc32(data[:-4]) == checksum
    if not (is_sound and math.isfinite(stamp_s + x + y + z)):
        return None
    fields = ((x, y, z), buttons, bool(homed), stamp_s, 0, (), "")
    return serial, tuple.__new__(DeviceReading, fields)  # at 1 kHz


def _sealed(body: bytes) -> bytes:
    return body + _checksum(body)


def _checksum(body: bytes) -> bytes:
    return zlib.crc32(body).to_bytes(_CHECKSUM_BYTES, "little")
