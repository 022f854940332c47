"""How far the gyro can be trusted, from the recording alone.

The smoother assumes the noise of a calibrated gyro. One that saturates, has a wrong
scale or repeats samples is worse, and a bound on the velocity that follows the velocity
found then takes drift for motion. The evidence (`evidence`) says which factor on the
gyro's noise is likely. Where a larger one explains more it is used, interval by interval
as the expected squares of the gyro's noise tell (expectation maximisation, Shumway and
Stoffer 1982): the levelling becomes shorter, and sigma larger.
"""

import itertools
import math
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import uniform_filter1d

from hapticplayer.model.arrays import Floats
from hapticplayer.motion import rotations as rot
from hapticplayer.motion.smoother.evidence import (
    VelocityModel,
    log_evidences,
    with_velocity_model,
)
from hapticplayer.motion.smoother.least_squares import (
    BIAS_COLUMNS,
    Problem,
    Solution,
    minimise,
    tilt_change_variances,
    with_fixed_calibration,
)
from hapticplayer.motion.smoother.parameters import SmootherParameters

# Factors on the deviation of the gyro's noise, upwards; half and twice of them cost 1 %.
GYRO_NOISE_FACTORS = (2.0, 4.0, 8.0)
# Deviations (m/s) and correlation times (s) of the velocity that are tried: from a hand
# to a bicycle, from a step to a bend.
VELOCITY_MODELS = tuple(
    itertools.starmap(
        VelocityModel, itertools.product((0.1, 0.3, 1.0, 3.0), (0.5, 2.0, 8.0))
    )
)
# No step on the way up may lose more evidence than this (natural logarithm): beyond a
# valley lies a gyro that is worth nothing, which explains any vehicle.
MAX_LOG_EVIDENCE_LOSS = 0.5
# Rounds of expectation maximisation, and intervals that share a factor.
LOCAL_NOISE_ROUNDS, LOCAL_NOISE_INTERVALS = 6, 3


@dataclass(frozen=True, slots=True)
class GyroTrust:
    """A gyro that is noisier than usual, and how the sensor moves.

    Attributes:
        noise_factor: on the deviation of the gyro's noise.
        velocity: the model that goes with it.
    """

    noise_factor: float
    velocity: VelocityModel

    def bound_mps(self, p: SmootherParameters) -> float:
        """The bound on the velocity with the same low frequencies, for a usual gyro."""
        sigma_mps, correlation_s = self.velocity
        wide_mps = p.velocity_margin * sigma_mps * math.sqrt(correlation_s)
        return wide_mps / self.noise_factor


def gyro_trust(
    problem: Problem, solution: Solution, body: slice, p: SmootherParameters
) -> GyroTrust | None:
    """Return how much noisier the gyro is than usual, or None where it is not.

    A walk in circles looks like an error of the gyro unless the velocity in the body's
    frame is known, a shaken head if it is: what counts is the evidence either way.

    Args:
        problem: the last one.
        solution: of it.
        body: columns of the velocity in the body's frame.
        p: settings.
    """
    resting = solution.calibration.copy()
    resting[body] = 0.0
    moving, still = (
        with_fixed_calibration(problem, calibration, BIAS_COLUMNS)
        for calibration in (solution.calibration, resting)
    )
    both = replace(
        moving,
        tilt=np.concatenate([still.tilt[:1], moving.tilt]),
        impulse=np.concatenate([still.impulse[:1], moving.impulse]),
    )
    usual: Floats | None = None
    best, best_gain, last_gain = None, p.noise_evidence, 0.0
    for factor in GYRO_NOISE_FACTORS:
        evidences = log_evidences(_noisier(both, factor), VELOCITY_MODELS, 2)
        least = evidences.max(axis=1) - last_gain + MAX_LOG_EVIDENCE_LOSS
        if usual is None:
            # two velocities are mostly enough to see that the usual gyro explains more
            likely = [VELOCITY_MODELS[place] for place in evidences.argmax(axis=1)]
            if (log_evidences(both, likely, 2).max(axis=1) > least).any():
                return best
            usual = log_evidences(both, VELOCITY_MODELS, 2).max(axis=1)
        if (usual > least).any():
            return best
        gains = evidences - usual[:, None]
        last_gain = float(gains.max(axis=1).min())
        if last_gain > best_gain:
            model = VELOCITY_MODELS[int(np.argmax(gains[0]))]
            best, best_gain = GyroTrust(factor, model), last_gain
    return best


def with_gyro_trust(
    problem: Problem, trust: GyroTrust, p: SmootherParameters
) -> Problem:
    """Return the problem with a noisier gyro, interval by interval."""
    usual = problem.tilt_weight
    moving = with_velocity_model(problem, trust.velocity)
    noise_factor = np.full(len(usual), trust.noise_factor)
    for _ in range(LOCAL_NOISE_ROUNDS):
        moving = replace(moving, tilt_weight=usual / noise_factor**2)
        expected = usual * _expected_square(moving, minimise(moving))
        shared = uniform_filter1d(expected, LOCAL_NOISE_INTERVALS, mode="nearest")
        noise_factor = np.sqrt(np.maximum(shared, 1.0))
    sigma_mps, correlation_s = trust.velocity
    wider = VelocityModel(p.velocity_margin * sigma_mps, correlation_s)
    noisier = replace(problem, tilt_weight=usual / noise_factor**2)
    return with_velocity_model(noisier, wider)


def _noisier(problem: Problem, noise_factor: float) -> Problem:
    return replace(problem, tilt_weight=problem.tilt_weight / noise_factor**2)


def _expected_square(problem: Problem, solution: Solution) -> Floats:
    """Return the expected square of the gyro's noise about one axis, (K,) rad^2."""
    columns = problem.tilt[: 1 + len(solution.calibration)]
    known = np.tensordot(np.append(1.0, solution.calibration), columns, 1)
    noise = np.diff(solution.tilt) - known
    return np.asarray(0.5 * rot.squared_norm(noise) + tilt_change_variances(problem))
