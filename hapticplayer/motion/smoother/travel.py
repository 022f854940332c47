"""A vehicle goes where it points: a steady velocity in the sensor's own frame.

That the velocity is bounded is all that is known of a hand. What drives has a velocity
that turns with it: in a bend it is pushed to the side for as long as the bend lasts,
which a bound alone takes for tilt. So the velocity is split into a part u that is
constant in the sensor's frame and the rest v', and the bound holds for that:
    v[k] = R[k] u + v'[k]
    v'[k+1] - v'[k] = impulse - (R[k+1] - R[k]) u
which makes u three more columns of the calibration, the last ones. (That wheels do not
slide sideways has long been used: Dissanayake et al. 2001, IEEE T-RA 17(5):731; here
the direction is found, too.) What only sways has none: there u would be another name
for errors of the sensors.

What goes also has a bound that is not read off the velocity found place by place. A
recording that starts in the middle of an acceleration shows too small a velocity, and
with a bound that fits it more of the acceleration would be taken for tilt than in the
whole recording. How it goes is told by v / w, how far it is from the centre of its turns,
which hardly depends on where a recording was cut: 0.1 to 2.3 m for hands and bodies on
their feet, 5 to 6.5 m for a head on a downhill bike, 11 m and more for what drives. Each
has its usual bound. That of a driven one is wide and always holds; the others may be
faster than usual, and the bound follows from there on.

What u does follows from the heading, and the heading from the gyro's bias, so that u,
found about a wrong heading, is wrong itself. What drives is therefore solved for until
the bias stays where it is, and not as often as hands need: where that ended hung on a
hair, and moved the result when a recording was cut. Without turns, as in a train, there
is no heading to be found, only one that keeps the velocity small.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.nodes import Nodes

# Standard deviation of each component of u, for what is fast enough to have one, and
# for what just begins to be.
_ANY_MPS, _NO_MPS = 10.0, 0.01
# RMS speed from which there may be one: an arm that sways is slower. From the other on
# nothing is held against it.
_SWAYING_MPS, _GOING_MPS = 0.4, 0.55
# Distance from the centre of its turns up to which something goes on feet, and from which
# it is ridden; up to which a head moves by itself, and from which it goes with what drives.
_WALKED_M, _RIDDEN_M, _CARRIED_M, _DRIVEN_M = 2.8, 4.2, 6.5, 9.5
# Mean speed of rotation up to which nothing is seen of the heading, and from which it is.
_STRAIGHT_RADPS, _STEERED_RADPS = 0.005, 0.02
# The same as _ANY_MPS for what drives: beside a wide bound a tighter one makes u too small.
_DRIVEN_MPS = 80.0
# Bound on the rest v' for what drives, and the least for what is ridden or walks.
_DRIVEN_BOUND_MPS, _RIDDEN_BOUND_MPS, _WALKED_BOUND_MPS = 40.0, 8.0, 4.0
# What is faster has a bound this much smaller than for the velocity found.
_FASTER = 1.15
# A hole is forgotten after so long, and so much of a recording is enough to judge it by.
_FORGOTTEN_S, _ENOUGH = 15.0, 0.2
# Columns of u.
TRAVEL = 3


def with_travel(rows: Floats, nodes: Nodes, frames: Pair) -> Floats:
    """Return the rows of a problem (K, 5, 4 + C) with three more columns at the end.

    Args:
        rows: (K, 5, 1 + C) see `Problem`.
        nodes: of the block.
        frames: from frame I to the level frames at the nodes.
    """
    turned = np.diff(rot.matrices(rot.multiply(frames, nodes.at)), axis=2)
    out = np.zeros((*rows.shape[:2], rows.shape[2] + TRAVEL))
    out[..., :-TRAVEL] = rows
    out[:, 2:, -TRAVEL:] = -turned.transpose(2, 0, 1)
    return out


def travel_prior(
    prior: Floats, weight: Floats, sigma_mps: float
) -> tuple[Floats, Floats]:
    """Return what is expected, and how surely, with the three columns of u."""
    longer = np.zeros((2, len(prior) + TRAVEL))
    longer[:, :-TRAVEL] = prior, weight
    longer[1, -TRAVEL:] = sigma_mps**-2.0
    return longer[0], longer[1]


@dataclass(frozen=True, slots=True)
class Travel:
    """How something gets about, each from 0 to 1.

    Attributes:
        going: how far it goes, and does not only sway.
        ridden: how far it goes faster than feet.
        driven: how far it is a vehicle.
        steered: how far its heading can be found, too.
    """

    going: float = 0.0
    ridden: float = 0.0
    driven: float = 0.0
    steered: float = 0.0

    @property
    def expected_mps(self) -> float:
        """The standard deviation of u, 0 where there is no need for it."""
        if not self.going:
            return 0.0
        any_mps = _between(_ANY_MPS, _DRIVEN_MPS, self.driven)
        return _between(_NO_MPS, any_mps, self.going)

    def bound_mps(self, found_mps: Floats) -> Floats:
        """Return the bound on the rest v' from that for the velocity found."""
        if not self.going:
            return found_mps
        usual_mps = _between(_WALKED_BOUND_MPS, _RIDDEN_BOUND_MPS, self.ridden)
        going_mps = np.maximum(usual_mps, found_mps / _FASTER)
        own = found_mps ** (1.0 - self.going) * going_mps**self.going
        return np.asarray(own ** (1.0 - self.driven) * _DRIVEN_BOUND_MPS**self.driven)


def travel_of(velocity_mps: Floats, turn_radps: float) -> Travel:
    """Return how something gets about.

    Args:
        velocity_mps: (2, K + 1) horizontal, of a solution without u.
        turn_radps: mean speed of rotation.
    """
    speed_mps = rms_mps(velocity_mps)
    going = (speed_mps - _SWAYING_MPS) / (_GOING_MPS - _SWAYING_MPS)
    going = min(max(going, 0.0), 1.0)
    radius_m = speed_mps / max(turn_radps, 1e-9)
    ridden = going * _place(radius_m, _WALKED_M, _RIDDEN_M)
    driven = going * _place(radius_m, _CARRIED_M, _DRIVEN_M)
    steered = driven * _place(turn_radps, _STRAIGHT_RADPS, _STEERED_RADPS)
    return Travel(going, ridden, driven, steered)


def undisturbed(nodes: Nodes) -> NDArray[np.bool_]:
    """Return which nodes are far from any hole, (K + 1,); all where hardly any is.

    A hole is bridged by a velocity that nothing moved with.
    """
    total = np.cumsum(np.append(0.0, nodes.lost_s + nodes.doubt_s))
    time_s = np.cumsum(np.append(0.0, nodes.duration_s))
    if total[-1] > 0.0:
        before = np.interp(time_s - _FORGOTTEN_S, time_s, total)
        clear = np.interp(time_s + _FORGOTTEN_S, time_s, total) <= before
        if clear.mean() > _ENOUGH:
            return np.asarray(clear)
    return np.ones(len(time_s), np.bool_)


def rms_mps(velocity_mps: Floats) -> float:
    """Return the RMS of velocities (2, K + 1)."""
    count = velocity_mps.shape[1]
    return math.sqrt(float(np.square(velocity_mps).sum()) / count)


def _between(first: float, last: float, share: float) -> float:
    return float(first * (last / first) ** share)


def _place(value: float, first: float, last: float) -> float:
    """Return where a value lies from first to last by its logarithm, 0 to 1."""
    if value <= first:
        return 0.0
    return min(math.log(value / first) / math.log(last / first), 1.0)
