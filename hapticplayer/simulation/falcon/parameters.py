"""Geometry and electronics of the simulated Falcon; see also `devices.dynamics`.

The geometry is written down apart from the driver's on purpose: a driver that is tested
against its own constants could not be wrong.
"""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PlantGeometry:
    """Delta kinematics with three legs (libnifalcon), m and rad.

    Attributes:
        thigh_m: from the motor's axis to the knee.
        shin_m: from the knee to the grip, as a parallelogram.
        shin_ends_m: the two ends of the shin beyond the parallelogram, together.
        radial_m: the knee circle's centre outwards of the device's axis, less the
            grip's own arm (r - c).
        sideways_m: the same across the leg (s - f).
        azimuths_rad: directions of the legs, seen from the front.
        centre_z_m: middle of the usable sphere, in front of the device's origin.
        theta0_rad: angle of the thighs at count 0; known to about a degree.
        count_rad: one encoder count: 1280 to a turn of the 14.25 mm shaft that
            drives a sector of 110 mm.
    """

    thigh_m: float = 0.060
    shin_m: float = 0.1025
    shin_ends_m: float = 0.0225
    radial_m: float = 0.0400 - 0.01443
    sideways_m: float = -0.02309 + 0.025
    azimuths_rad: tuple[float, float, float] = (
        math.radians(105.0),
        math.radians(-15.0),
        math.radians(-135.0),
    )
    centre_z_m: float = 0.120
    theta0_rad: float = math.radians(35.0)
    count_rad: float = math.radians(0.01425 / 0.110 * 360.0 / 1280.0)


@dataclass(frozen=True, slots=True)
class Electronics:
    """What lies between a command and the motors.

    Attributes:
        hold_s: how long the last force stays on the motors after the commands
            have fallen silent, counted from when the next was due; not known for the
            Falcon. 0, 0.020, and for ever, which is the worst and therefore assumed.
        delay_s: from a command to its force; 0 to 0.003.
    """

    hold_s: float = math.inf
    delay_s: float = 0.0
