"""What the Falcon's legs measure, as a value that another calibration can replace."""

import math
from dataclasses import dataclass

from hapticplayer.model.device import Vector


@dataclass(frozen=True, slots=True)
class Geometry:
    """Delta kinematics with three legs; m and rad.

    The letters are those of libnifalcon's FalconGeometry.h, from which the values
    come. Its maintainers call them doubtful near the edge of the workspace; one
    degree in `theta0_rad` ("approx." there) is 1.2 mm in z.

    Attributes:
        thigh_m: a, from the motor's axis to the knee.
        shin_m: b, length of the parallelogram between knee and grip.
        grip_radius_m: c, from the grip's axis to where a shin ends.
        shin_ends_m: d + e, what the shin's two ends add beyond the parallelogram.
        grip_offset_m: f, across the leg, at the grip.
        base_radius_m: r, from the device's axis to a motor's axis.
        base_offset_m: s, across the leg, at the base. That it differs from f by
            1.9 mm turns the lateral frame by -1.8 degrees, which packets traced from
            the vendor's driver do not show: s = f may be nearer to the truth.
        azimuths_rad: directions of the legs seen from the front: top, right, lower
            left; the order of motors and encoders.
        theta0_rad: angle of the thighs at encoder count 0.
        count_rad: one count: 320 slots read four times per turn of the 14.25 mm
            shaft, which drives a sector of 110 mm.
        centre_z_m: middle of the usable sphere, in front of the device's origin.
    """

    thigh_m: float = 0.060
    shin_m: float = 0.1025
    grip_radius_m: float = 0.01443
    shin_ends_m: float = 0.01125 + 0.01125
    grip_offset_m: float = -0.025
    base_radius_m: float = 0.0400
    base_offset_m: float = -0.02309
    azimuths_rad: Vector = (
        math.radians(105.0),
        math.radians(-15.0),
        math.radians(-135.0),
    )
    theta0_rad: float = math.radians(35.0)
    count_rad: float = math.radians(0.01425 / 0.110 * 360.0 / 1280.0)
    centre_z_m: float = 0.120


FALCON_GEOMETRY = Geometry()
