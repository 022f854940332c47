"""One sample of the signal for a motion rig: fifteen numbers.

Without numpy: the rig's loop loads this.
"""

from typing import NamedTuple


class RigMotion(NamedTuple):
    """Motion of the actor at one moment; all zero is neutral.

    Vectors are in frame A (x right, y front, z up), without gravity. The attitude is
    R = Rz(heading) Rx(pitch) Ry(roll), frame A to the level world: nose up, right side
    down and a turn to the left are positive. Rates and angular accelerations are about
    x (pitch), y (roll) and z (yaw) of frame A.
    """

    right_mps2: float = 0.0
    front_mps2: float = 0.0
    up_mps2: float = 0.0
    pitch_rad: float = 0.0
    roll_rad: float = 0.0
    heading_rad: float = 0.0
    pitch_radps: float = 0.0
    roll_radps: float = 0.0
    yaw_radps: float = 0.0
    pitch_radps2: float = 0.0
    roll_radps2: float = 0.0
    yaw_radps2: float = 0.0
    right_mps: float = 0.0
    front_mps: float = 0.0
    up_mps: float = 0.0


NEUTRAL = RigMotion()
