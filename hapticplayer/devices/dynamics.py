"""Mechanism of the Falcon and hands on its grip, each figure with its range and source.

For the prediction of how far a track moves a hand, and for the simulated Falcon.
"libnifalcon" stands for the constants of its FalconGeometry.h, "ros_falcon" for the
gains in its parameter files; neither holds a measured friction or end stop, nor does
any other public source known to us. What is assumed says so and has a range, over
which whoever relies on it should vary it.
"""

import math
from dataclasses import dataclass, replace

from hapticplayer.devices.capabilities import FALCON


@dataclass(frozen=True, slots=True)
class Mechanism:
    """Inertia, friction and end stops of the device.

    The weight of the grip is left out: it is not known, and a hand carries it.

    Attributes:
        joint_inertia_kg_m2: motor and sector of one leg; 0.83e-3 to 1.2e-3 from
            ros_falcon's critical gains (m = K / omega^2: 0.13 kg sideways and 0.46 kg
            along the axis, in the ratio that the Jacobian has at the home position).
        grip_mass_kg: what moves with the grip and is no rotor; 0 to 0.1, assumed
            0 because the ratio above leaves nothing to explain.
        viscous_nm_s: per joint and rad/s; 0.5e-3 to 4e-3. From the same critical
            gain, b = K (T/2 + delay): 185 N/m at 1 ms and 1 ms of delay, seen
            through the Jacobian.
        coulomb_nm: dry friction per joint; assumed, 0 to 0.03 (0.6 N at the grip).
        stick_radps: below this speed dry friction falls in proportion to the speed,
            which a joint at rest leaves again only by creeping (0.7 mm/s at the
            grip); numerical, 0.003 to 0.03.
        stop_radius_m: the grip's reach around the centre; assumed as wide as the
            usable sphere, to be on the safe side; 0.04 to 0.05.
        restitution: share of the speed that comes back from an end stop; assumed,
            0 to 0.5. The stop itself does not yield.
    """

    joint_inertia_kg_m2: float = 0.9e-3
    grip_mass_kg: float = 0.0
    viscous_nm_s: float = 1.8e-3
    coulomb_nm: float = 0.005
    stick_radps: float = 0.01
    stop_radius_m: float = FALCON.workspace_radius_m
    restitution: float = 0.2

    def with_lateral_mass(self, mass_kg: float) -> "Mechanism":
        """Return it with the joint inertia that makes the free grip so heavy.

        Args:
            mass_kg: felt sideways in the centre of the workspace; 0.05 to 0.3. Along
                the axis it is 2.8 times as much, near the device and away from the
                centre more.
        """
        return replace(self, joint_inertia_kg_m2=mass_kg * _LATERAL_M_PER_RAD**2)


# The Jacobian's lateral singular value in the centre; a test holds it to the kinematics.
_LATERAL_M_PER_RAD = 0.07311


@dataclass(frozen=True, slots=True)
class Hand:
    """A hand on the grip: mass, spring and damper about a rest point.

    Stiffness and damping rise steadily with the grip force (Hasser & Cutkosky 2002,
    pinch grasp) and with co-contraction of the arm (Gomi & Osu 1998); the figures of
    the presets are assumed, within the ranges given here.

    Attributes:
        mass_kg: that moves with the grip; 0.1 (fingers) to 1.5 (forearm too).
        stiffness_n_per_m: 50 to 1000.
        damping_n_s_per_m: 2 to 50.
        yield_s: time constant with which the rest point gives way to the grip;
            0.3 s and more; infinite: the person holds the place.
        return_s: time constant with which the person brings the rest point back to
            the place that was aimed at; 0.3 to 2 s.
    """

    mass_kg: float
    stiffness_n_per_m: float
    damping_n_s_per_m: float
    yield_s: float = math.inf
    return_s: float = 0.5


RELAXED = Hand(0.32, 150.0, 8.2)  # 4.5 N moves it by 3 cm; damping ratio 0.5
LIGHT = Hand(0.35, 230.0, 11.0)
NORMAL = Hand(0.45, 350.0, 15.0)
TENSE = Hand(0.60, 550.0, 22.0)
FIRM = Hand(0.80, 900.0, 32.0)
HANDS: dict[str, Hand] = {
    "relaxed": RELAXED,
    "light": LIGHT,
    "normal": NORMAL,
    "tense": TENSE,
    "firm": FIRM,
}
