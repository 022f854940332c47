"""The packets that rig software takes from games; all little-endian, without padding.

Sources: LFS InSim.txt and OutSimPack.txt (64 bytes, 68 with an ID), BeamNG's MotionSim
protocol (88 bytes, "BNG1"), SpaceMonkey's CodemastersExtraData3.xml (264 bytes, 66
floats). A position is never sent: it is 0.
"""

import math
import struct
from collections.abc import Callable
from typing import NamedTuple, Protocol

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.device import Vector
from hapticplayer.model.rig import RigMotion

_OUTSIM = struct.Struct("<I12f3i")
_OUTSIM_ID = struct.Struct("<i")
_BEAMNG = struct.Struct("<4s21f")
_CODEMASTERS = struct.Struct("<66f")
_NOWHERE = (0.0, 0.0, 0.0)


class PacketChoices(Protocol):
    """What a person may choose about packets; see `RigSettings`."""

    @property
    def id(self) -> int: ...

    @property
    def forward_first(self) -> bool: ...


class RigFormat(NamedTuple):
    """A format that can be chosen by name.

    Attributes:
        name: for command lines.
        port: where its receivers listen, unless a person says otherwise.
        encode: returns the packet of a motion at a time of the packets, s.
    """

    name: str
    port: int
    encode: Callable[[RigMotion, float, PacketChoices], bytes]


def in_world(motion: RigMotion, vector: Vector) -> Vector:
    """Return a vector of frame A in the level world: Rz(heading) Rx(pitch) Ry(roll) v."""
    x, y, z = vector
    c, s = math.cos(motion.roll_rad), math.sin(motion.roll_rad)
    x, z = c * x + s * z, c * z - s * x
    c, s = math.cos(motion.pitch_rad), math.sin(motion.pitch_rad)
    y, z = c * y - s * z, s * y + c * z
    c, s = math.cos(motion.heading_rad), math.sin(motion.heading_rad)
    return (c * x - s * y, s * x + c * y, z)


def outsim(motion: RigMotion, time_s: float, settings: PacketChoices) -> bytes:
    """Return LFS's OutSimPack; angular rate, acceleration and velocity in the world."""
    packet = _OUTSIM.pack(
        int(1e3 * time_s) & 0xFFFF_FFFF,
        *in_world(motion, motion[6:9]),
        motion.heading_rad,
        motion.pitch_rad,
        motion.roll_rad,
        *in_world(motion, motion[0:3]),
        *in_world(motion, motion[12:15]),
        *(0, 0, 0),
    )
    return packet + _OUTSIM_ID.pack(settings.id) if settings.id else packet


def beamng(motion: RigMotion, _time_s: float, _settings: PacketChoices) -> bytes:
    """Return BeamNG's MotionSim packet; the acceleration is in the vehicle."""
    return _BEAMNG.pack(
        b"BNG1",
        *_NOWHERE,
        *in_world(motion, motion[12:15]),
        *motion[0:3],
        *in_world(motion, (0.0, 0.0, 1.0)),
        *(motion.roll_rad, motion.pitch_rad, motion.heading_rad),
        *(motion.roll_radps, motion.pitch_radps, motion.yaw_radps),
        *(motion.roll_radps2, motion.pitch_radps2, motion.yaw_radps2),
    )


def codemasters(motion: RigMotion, time_s: float, settings: PacketChoices) -> bytes:
    """Return Codemasters' "extradata=3" packet: x right, y up, z forward.

    Two sources contradict each other on which unit vector comes first; see
    `PacketChoices.forward_first`. Heave is only in the velocity.
    """
    values = [0.0] * 66
    values[0] = values[1] = time_s
    values[7] = math.hypot(*motion[12:15])
    values[8:11] = _y_up(in_world(motion, motion[12:15]))
    right = _y_up(in_world(motion, (1.0, 0.0, 0.0)))
    forward = _y_up(in_world(motion, (0.0, 1.0, 0.0)))
    first, second = (forward, right) if settings.forward_first else (right, forward)
    values[11:14], values[14:17] = first, second
    values[34] = motion.right_mps2 / STANDARD_GRAVITY_MPS2
    values[35] = motion.front_mps2 / STANDARD_GRAVITY_MPS2
    return _CODEMASTERS.pack(*values)


def _y_up(vector: Vector) -> Vector:
    x, y, z = vector
    return (x, z, y)


FORMATS: dict[str, RigFormat] = {
    one.name: one
    for one in (
        RigFormat("outsim", 4123, outsim),
        RigFormat("codemasters", 20777, codemasters),
        RigFormat("beamng", 4444, beamng),
    )
}
