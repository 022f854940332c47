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
"""

import math
from dataclasses import replace

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.rotations import Pair
from hapticplayer.motion.smoother.calibrated import Problem
from hapticplayer.motion.smoother.nodes import Nodes

# Standard deviation of each component of u, for what is fast enough to have one, and
# for what just begins to be.
_ANY_MPS, _NO_MPS = 10.0, 0.01
# RMS speed from which there may be one: an arm that sways is slower. From the other on
# nothing is held against it.
_SWAYING_MPS, _GOING_MPS = 0.5, 0.8
# Columns of u.
TRAVEL = 3


def with_travel(
    problem: Problem, nodes: Nodes, frames: Pair, sigma_mps: float
) -> Problem:
    """Return the problem with three more columns at the end, the velocity u in m/s.

    Without any where sigma is 0.

    Args:
        problem: the linearised block.
        nodes: of the block.
        frames: from frame I to the level frames at the nodes.
        sigma_mps: standard deviation of each component of u.
    """
    if not sigma_mps:
        return problem
    turned = np.diff(rot.matrices(rot.multiply(frames, nodes.at)), axis=2)
    rows = np.zeros((turned.shape[2], 5, problem.rows.shape[2] + TRAVEL))
    rows[..., :-TRAVEL] = problem.rows
    rows[:, 2:, -TRAVEL:] = -turned.transpose(2, 0, 1)
    prior, weight = travel_prior(problem.prior, problem.prior_weight, sigma_mps)
    return replace(problem, rows=rows, prior=prior, prior_weight=weight)


def travel_prior(
    prior: Floats, weight: Floats, sigma_mps: float
) -> tuple[Floats, Floats]:
    """Return what is expected, and how surely, with the three columns of u."""
    return (
        np.concatenate([prior, np.zeros(TRAVEL)]),
        np.concatenate([weight, np.full(TRAVEL, sigma_mps**-2.0)]),
    )


def expected_mps(velocity_mps: Floats) -> float:
    """Return the standard deviation of u, 0 where there is no need for it.

    Args:
        velocity_mps: (2, K + 1) horizontal, of a solution without u.
    """
    speed = math.sqrt(float(np.square(velocity_mps).sum(axis=0).mean()))
    share = (speed - _SWAYING_MPS) / (_GOING_MPS - _SWAYING_MPS)
    if share <= 0.0:
        return 0.0
    return float(_NO_MPS * (_ANY_MPS / _NO_MPS) ** min(share, 1.0))
