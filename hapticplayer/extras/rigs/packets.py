"""The packets that rig software takes from games; all little-endian, without padding.

OutSim has 64 bytes, 68 with an ID, BeamNG's MotionSim 88, Codemasters' extradata=3 264 (66
floats). A position is never sent: it is 0. Which way each number is positive, and what
says so, are the `signs` of a format.
"""

import math
import struct
from collections.abc import Callable
from typing import NamedTuple, Protocol

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.device import Vector
from hapticplayer.model.rig import NEUTRAL, RigMotion

_OUTSIM = struct.Struct("<I12f3i")
_OUTSIM_ID = struct.Struct("<i")
_BEAMNG = struct.Struct("<4s21f")
_CODEMASTERS = struct.Struct("<66f")
_NOWHERE = (0.0, 0.0, 0.0)


class PacketChoices(Protocol):
    """What a person may choose about packets; see `RigSettings`."""

    @property
    def id(self) -> int: ...


class Sign(NamedTuple):
    """Which way a number of a packet is positive.

    Attributes:
        field: its name in the format.
        offset: of its four bytes.
        motion: one with which it is positive.
        positive: that motion in words.
        source: what says so.
    """

    field: str
    offset: int
    motion: RigMotion
    positive: str
    source: str


class RigFormat(NamedTuple):
    """A format that can be chosen by name.

    Attributes:
        name: for command lines.
        title: for people.
        port: where its receivers listen, unless a person says otherwise.
        encode: returns the packet of a motion at a time of the packets, s.
        signs: which way its numbers are positive.
    """

    name: str
    title: str
    port: int
    encode: Callable[[RigMotion, float, PacketChoices], bytes]
    signs: tuple[Sign, ...]


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
    """Return BeamNG's MotionSim packet; the acceleration is in the vehicle.

    The game's yaw is to the right, in an otherwise right-handed world.
    """
    return _BEAMNG.pack(
        b"BNG1",
        *_NOWHERE,
        *in_world(motion, motion[12:15]),
        *motion[0:3],
        *in_world(motion, (0.0, 0.0, 1.0)),
        *(motion.roll_rad, motion.pitch_rad, -motion.heading_rad),
        *(motion.roll_radps, motion.pitch_radps, -motion.yaw_radps),
        *(motion.roll_radps2, motion.pitch_radps2, -motion.yaw_radps2),
    )


def codemasters(motion: RigMotion, time_s: float, _settings: PacketChoices) -> bytes:
    """Return Codemasters' "extradata=3" packet; heave is only in the velocity.

    The game's world is the mirror image of a right-handed one: y up, and x to the left of
    z. Its lateral g is to the left.
    """
    values = [0.0] * 66
    values[0] = values[1] = time_s
    values[7] = math.hypot(*motion[12:15])
    values[8:11] = _mirrored(in_world(motion, motion[12:15]))
    values[11:14] = _mirrored(in_world(motion, (1.0, 0.0, 0.0)))
    values[14:17] = _mirrored(in_world(motion, (0.0, 1.0, 0.0)))
    values[34] = -motion.right_mps2 / STANDARD_GRAVITY_MPS2
    values[35] = motion.front_mps2 / STANDARD_GRAVITY_MPS2
    return _CODEMASTERS.pack(*values)


def _mirrored(vector: Vector) -> Vector:
    x, y, z = vector
    return (-x, z, y)


def _signs(source: str, *rows: tuple[str, int, str, str]) -> tuple[Sign, ...]:
    """Signs of one source; "-yaw_radps" is a motion with -1 there, and 0 elsewhere."""
    return tuple(
        Sign(field, offset, _unit(motion), positive, source)
        for field, offset, motion, positive in rows
    )


def _unit(name: str) -> RigMotion:
    value = -1.0 if name.startswith("-") else 1.0
    return NEUTRAL._replace(**{name.removeprefix("-"): value})


_RIGHT, _FRONT, _UP = "to the right", "to the front", "up"
_NOSE_UP, _RIGHT_DOWN = "nose up", "right side down"
_LEFT, _RIGHT_TURN = "to the left", "a turn to the right"
_OUTSIM_SIGNS = _signs(
    "InSim.txt of Live for Speed: x and y on the ground, z up, angles anticlockwise from "
    "above, from the right and from the front",
    ("AngVel x", 4, "pitch_radps", _NOSE_UP),
    ("AngVel y", 8, "roll_radps", _RIGHT_DOWN),
    ("AngVel z", 12, "yaw_radps", "a turn to the left"),
    ("Heading", 16, "heading_rad", "a turn to the left"),
    ("Pitch", 20, "pitch_rad", _NOSE_UP),
    ("Roll", 24, "roll_rad", _RIGHT_DOWN),
    ("Accel x", 28, "right_mps2", _RIGHT),
    ("Accel y", 32, "front_mps2", _FRONT),
    ("Accel z", 36, "up_mps2", _UP),
    ("Vel x", 40, "right_mps", _RIGHT),
    ("Vel y", 44, "front_mps", _FRONT),
    ("Vel z", 48, "up_mps", _UP),
)
_BEAMNG_SIGNS = (
    *_signs(
        "the game's motionSim.lua: the velocity of its world, z up",
        ("velX", 16, "right_mps", _RIGHT),
        ("velY", 20, "front_mps", _FRONT),
        ("velZ", 24, "up_mps", _UP),
    ),
    *_signs(
        "motionSim.lua sends minus the sensors; esc.lua: speed -= sensorY dt, "
        "virtualSensors.lua: accX is speed times yawRate in a steady curve",
        ("accX", 28, "right_mps2", _RIGHT),
        ("accY", 32, "front_mps2", _FRONT),
        ("accZ", 36, "up_mps2", _UP),
    ),
    *_signs(
        "motionSim.lua, computed with toEulerYXZ and quatFromDir of the game's mathlib.lua",
        ("rollPos", 52, "roll_rad", _RIGHT_DOWN),
        ("pitchPos", 56, "pitch_rad", _NOSE_UP),
        ("yawPos", 60, "-heading_rad", _RIGHT_TURN),
    ),
    *_signs(
        "the game's esc.lua: minus the yaw rate is positive while turning left; the other "
        "two are of the same vector (BeamMP: velocity is position x rate; x left, y back, z up)",
        ("rollRate", 64, "roll_radps", _RIGHT_DOWN),
        ("pitchRate", 68, "pitch_radps", _NOSE_UP),
        ("yawRate", 72, "-yaw_radps", _RIGHT_TURN),
        ("rollAcc", 76, "roll_radps2", _RIGHT_DOWN),
        ("pitchAcc", 80, "pitch_radps2", _NOSE_UP),
        ("yawAcc", 84, "-yaw_radps2", _RIGHT_TURN),
    ),
)
_CODEMASTERS_SIGNS = _signs(
    "three recordings of DiRT Rally 2.0 that come with dr2_logger (36,000 packets): g along "
    "the vector right r -0.999, along the vector forward r 0.996, right x forward is +y, "
    "velocity along forward",
    ("8 velocity x", 32, "-right_mps", _LEFT),
    ("9 velocity y", 36, "up_mps", _UP),
    ("10 velocity z", 40, "front_mps", _FRONT),
    ("12 right, its y", 48, "-roll_rad", "left side down"),
    ("14 forward, its x", 56, "heading_rad", "a turn to the left"),
    ("15 forward, its y", 60, "pitch_rad", _NOSE_UP),
    ("34 lateral g", 136, "-right_mps2", _LEFT),
    ("35 longitudinal g", 140, "front_mps2", _FRONT),
)
FORMATS: dict[str, RigFormat] = {
    one.name: one
    for one in (
        RigFormat("outsim", "OutSim", 4123, outsim, _OUTSIM_SIGNS),
        RigFormat(
            "codemasters",
            "Codemasters",
            20777,
            codemasters,
            _CODEMASTERS_SIGNS,
        ),
        RigFormat("beamng", "BeamNG", 4444, beamng, _BEAMNG_SIGNS),
    )
}
