"""Reads the packets of `extras.rigs.packets` from their published layouts, not with them.

OutSim is recognised by its 64 or 68 bytes, BeamNG by "BNG1" and 88 bytes, Codemasters by 264.
"""

import math
import struct
from typing import NamedTuple

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.device import Vector

_NEUTRAL = 1e-3  # m/s^2, rad and m/s that nobody feels


class DecodedPacket(NamedTuple):
    """What one packet says; x right, y front, z up.

    Attributes:
        format: name of the format.
        time_s: in the packet; None where the format has none.
        acceleration_mps2: in the world (OutSim) or the vehicle; Codemasters has no up.
        pitch_rad: nose up.
        roll_rad: right side down.
        heading_rad: to the left.
        velocity_mps: in the world.
    """

    format: str
    time_s: float | None
    acceleration_mps2: Vector
    pitch_rad: float
    roll_rad: float
    heading_rad: float
    velocity_mps: Vector

    @property
    def is_neutral(self) -> bool:
        """Whether a rig would stand level and still."""
        angles = (self.pitch_rad, self.roll_rad, self.heading_rad)
        values = (*self.acceleration_mps2, *angles, *self.velocity_mps)
        return all(abs(value) < _NEUTRAL for value in values)


def decode(packet: bytes) -> DecodedPacket | None:
    """The decoded packet, None for one of no known format."""
    if len(packet) in (64, 68):
        return _outsim(packet)
    if len(packet) == 88 and packet.startswith(b"BNG1"):
        return _beamng(packet)
    return _codemasters(packet) if len(packet) == 264 else None


def _outsim(packet: bytes) -> DecodedPacket:
    (milliseconds,) = struct.unpack_from("<I", packet, 0)
    heading, pitch, roll = struct.unpack_from("<3f", packet, 16)
    acceleration = struct.unpack_from("<3f", packet, 28)
    velocity = struct.unpack_from("<3f", packet, 40)
    time_s = 1e-3 * milliseconds
    return DecodedPacket("outsim", time_s, acceleration, pitch, roll, heading, velocity)


def _beamng(packet: bytes) -> DecodedPacket:
    velocity = struct.unpack_from("<3f", packet, 16)
    acceleration = struct.unpack_from("<3f", packet, 28)
    roll, pitch, yaw = struct.unpack_from("<3f", packet, 52)
    return DecodedPacket("beamng", None, acceleration, pitch, roll, -yaw, velocity)


def _codemasters(packet: bytes) -> DecodedPacket:
    (time_s,) = struct.unpack_from("<f", packet, 0)
    vx, vy, vz = struct.unpack_from("<3f", packet, 32)
    _, right_up, _ = struct.unpack_from("<3f", packet, 44)
    fx, fy, fz = struct.unpack_from("<3f", packet, 56)
    left_g, front_g = struct.unpack_from("<2f", packet, 136)
    g = STANDARD_GRAVITY_MPS2
    return DecodedPacket(
        "codemasters",
        time_s,
        (-g * left_g, g * front_g, 0.0),
        math.asin(min(max(fy, -1.0), 1.0)),
        -math.asin(min(max(right_up / max(math.hypot(fx, fz), 1e-6), -1.0), 1.0)),
        math.atan2(fx, fz),
        (-vx, vz, vy),
    )
