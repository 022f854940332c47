"""The smoother's least squares against a dense solution of the same equations."""

import dataclasses

import numpy as np
import pytest
from scipy.linalg import cholesky_banded

from hapticplayer.model import STANDARD_GRAVITY_MPS2 as G
from hapticplayer.motion.smoother.evidence import (
    VelocityModel,
    log_evidence_of_prior,
    log_evidences,
    velocity_precisions,
)
from hapticplayer.motion.smoother.least_squares import (
    Problem,
    Solution,
    horizontal_band,
    minimise,
    with_prior,
)


def covariance(solution):
    """Return the covariance (C, C) of the calibration."""
    return solution.covariance_times(np.eye(len(solution.calibration)))


def random_problem(rng, intervals, columns, spread=1.0):
    """Return a problem whose weights vary by e^spread about sensible ones."""

    def weights(typical, count):
        return typical * np.exp(spread * rng.standard_normal(count))

    resting = rng.random(intervals) < 0.3
    duration_s = rng.uniform(0.1, 1.0, intervals)
    tilt = 0.01 * rng.standard_normal((1 + columns, 2, intervals))
    impulse = rng.standard_normal((1 + columns, 3, intervals))
    return Problem(
        duration_s=duration_s,
        tilt=tilt,
        impulse=impulse,
        tilt_weight=weights(1e5, intervals),
        velocity_weight=weights(1e3, intervals),
        bound_weight=weights(0.1, intervals + 1),
        zero_velocity_weight=np.where(resting, weights(1e3, intervals), 0.0),
        prior=0.01 * rng.standard_normal(columns),
        prior_weight=weights(400.0, columns),
    )


class Dense:
    """All equations of the module's docstring, one row each, weighted.

    Unknown: s (2, K + 1), v (3, K + 1), calibration (C,), in this order.
    """

    def __init__(self, problem: Problem) -> None:
        self._p = problem
        self.intervals = len(problem.duration_s)
        self.columns = len(problem.prior)
        self.nodes = self.intervals + 1
        self.unknowns = 5 * self.nodes + self.columns
        self._rows, self._right = [], []
        for k in range(self.intervals):
            self._between_nodes(k)
        for k in range(self.nodes):
            for axis in range(3):
                self._add({self.v(axis, k): 1.0}, 0.0, problem.bound_weight[k])
        for c in range(self.columns):
            weight = problem.prior_weight[c]
            self._add({self.c(c): 1.0}, problem.prior[c], weight)
        self.matrix = np.array(self._rows)
        self.right = np.array(self._right)

    def s(self, axis, node):
        return axis * self.nodes + node

    def v(self, axis, node):
        return (2 + axis) * self.nodes + node

    def c(self, number):
        return 5 * self.nodes + number

    def _between_nodes(self, k):
        p = self._p
        half = 0.5 * G * p.duration_s[k]
        for axis in range(2):
            change = {self.s(axis, k + 1): 1.0, self.s(axis, k): -1.0}
            known, by = p.tilt[0, axis, k], p.tilt[1:, axis, k]
            self._add(self._less(change, by), known, p.tilt_weight[k])
        for axis in range(3):
            change = {self.v(axis, k + 1): 1.0, self.v(axis, k): -1.0}
            if axis < 2:
                change |= {self.s(axis, k + 1): half, self.s(axis, k): half}
            known, by = p.impulse[0, axis, k], p.impulse[1:, axis, k]
            self._add(self._less(change, by), known, p.velocity_weight[k])
            rest = {self.v(axis, k + 1): 1.0, self.v(axis, k): -1.0}
            self._add(rest, 0.0, p.zero_velocity_weight[k])

    def _less(self, row, by):
        return row | {self.c(number): -value for number, value in enumerate(by)}

    def _add(self, row, right, weight):
        dense = np.zeros(self.unknowns)
        for column, value in row.items():
            dense[column] += value
        self._rows.append(np.sqrt(weight) * dense)
        self._right.append(np.sqrt(weight) * right)

    def solve(self):
        """Return (tilt, velocity, calibration)."""
        found = np.linalg.lstsq(self.matrix, self.right, rcond=None)[0]
        tilt = found[: 2 * self.nodes].reshape(2, -1)
        velocity = found[2 * self.nodes : 4 * self.nodes].reshape(2, -1)
        return tilt, velocity, found[5 * self.nodes :]

    def covariance(self):
        """Return the covariance of all unknowns, by way of the QR factor."""
        triangle = np.linalg.qr(self.matrix, mode="r")
        inverse = np.linalg.inv(triangle)
        return inverse @ inverse.T

    def tilt_variance(self):
        """Return the variance of both tilts together at the nodes."""
        diagonal = np.diag(self.covariance())[: 2 * self.nodes]
        return diagonal.reshape(2, -1).sum(axis=0)


def assert_same(got, expected, tolerance=1e-8):
    assert np.abs(got - expected).max() <= tolerance * np.abs(expected).max()


@pytest.mark.parametrize("columns", [1, 7, 16])
@pytest.mark.parametrize("intervals", [1, 2, 3, 30])
def test_all_unknowns_are_those_of_the_dense_problem(intervals, columns, rng):
    problem = random_problem(rng, intervals, columns)
    dense = Dense(problem)
    tilt, velocity, calibration = dense.solve()
    got = minimise(problem)
    assert_same(got.tilt, tilt)
    # one interval is explained by the tilt alone: a velocity of zero but for rounding
    assert np.allclose(got.velocity_mps, velocity, rtol=1e-8, atol=1e-9)
    assert_same(got.calibration, calibration)
    assert_same(covariance(got), dense.covariance()[-columns:, -columns:])


def test_the_states_of_a_column_match_the_dense_solution(rng):
    problem = random_problem(rng, 20, 7)
    sure = dataclasses.replace(problem, prior_weight=np.full(7, 1e16))
    got = minimise(problem).states[1:, ..., 0]
    base = Dense(sure).solve()[0]
    for number in range(7):
        moved = problem.prior.copy()
        moved[number] += 1.0
        tilt = Dense(dataclasses.replace(sure, prior=moved)).solve()[0]
        assert_same(got[number], tilt - base, 1e-6)


def test_columns_without_a_prior_wait_for_one(rng):
    """They take no part until they have one; then the factor is used again."""
    problem = random_problem(rng, 25, 10)
    of_fewer = {
        "prior": problem.prior[:7],
        "prior_weight": problem.prior_weight[:7],
    }
    cut = {"tilt": problem.tilt[:8], "impulse": problem.impulse[:8]}
    fewer = dataclasses.replace(problem, **cut, **of_fewer)
    first = minimise(dataclasses.replace(problem, **of_fewer))
    for got, wanted in (
        (first, fewer),
        (with_prior(first, problem.prior, problem.prior_weight), problem),
    ):
        dense = Dense(wanted)
        tilt, velocity, calibration = dense.solve()
        assert_same(got.tilt, tilt)
        assert_same(got.velocity_mps, velocity)
        assert_same(got.calibration, calibration)
        count = len(calibration)
        assert_same(covariance(got), dense.covariance()[-count:, -count:])


def test_a_parameter_without_influence_keeps_its_prior(rng):
    problem = random_problem(rng, 20, 3)
    problem.tilt[2], problem.impulse[2] = 0.0, 0.0
    got = minimise(problem)
    assert got.calibration[1] == pytest.approx(problem.prior[1], rel=1e-12)
    assert covariance(got)[1, 1] == pytest.approx(
        1 / problem.prior_weight[1], rel=1e-12
    )
    assert np.allclose(covariance(got)[1, [0, 2]], 0.0, atol=1e-15)


def test_a_problem_made_from_an_answer_gives_that_answer(rng):
    """Without noise the weights do not matter, if the answer also obeys the bounds."""
    problem = random_problem(rng, 40, 7)
    tilt = 0.02 * rng.standard_normal((2, 41))
    calibration = problem.prior
    tilt_rows = np.diff(tilt) - np.tensordot(calibration, problem.tilt[1:], 1)
    # a velocity that is zero throughout obeys bound and rest exactly
    mean = 0.5 * (tilt[:, 1:] + tilt[:, :-1])
    slope = np.concatenate([G * problem.duration_s * mean, np.zeros((1, 40))])
    pulse = slope - np.tensordot(calibration, problem.impulse[1:], 1)
    problem.tilt[0], problem.impulse[0] = tilt_rows, pulse
    got = minimise(problem)
    assert np.allclose(got.tilt, tilt, rtol=0.0, atol=1e-11)
    assert np.allclose(got.velocity_mps, 0.0, rtol=0.0, atol=1e-11)
    assert np.allclose(got.calibration, calibration, rtol=1e-9, atol=1e-11)


def dense_band(problem):
    """Return the normal matrix of one axis for the unknowns s[0], v[0], s[1], ..."""
    dense = Dense(problem)
    order = [
        place(0, node) for node in range(dense.nodes) for place in (dense.s, dense.v)
    ]
    columns = dense.matrix[:, order]
    return columns.T @ columns


def test_the_band_is_the_normal_matrix(rng):
    problem = random_problem(rng, 12, 2)
    expected, band = dense_band(problem), horizontal_band(problem)
    for below in range(4):
        got = band[below, : len(expected) - below]
        assert np.allclose(got, np.diag(expected, -below), rtol=1e-12)
    beyond = np.tril(expected, -4)
    assert not beyond.any()


@pytest.mark.parametrize("seed", range(20))
def test_the_band_is_positive_definite_for_extreme_weights(seed):
    rng = np.random.default_rng(seed)
    problem = random_problem(rng, 200, 7)
    extreme = dataclasses.replace(
        problem,
        tilt_weight=10.0 ** rng.uniform(-6.0, 6.0, 200),
        velocity_weight=10.0 ** rng.uniform(-6.0, 6.0, 200),
        bound_weight=10.0 ** rng.uniform(-6.0, 6.0, 201),
    )
    factor = cholesky_banded(horizontal_band(extreme), lower=True)
    assert (factor[0] > 0.0).all()
    assert_sound(minimise(extreme))


@pytest.mark.parametrize(
    "weights",
    [(1e12, 1.0, 1.0), (1.0, 1e12, 1.0), (1.0, 1.0, 1e12), (1e12, 1e12, 1.0)],
    ids=["tilt", "velocity", "bound", "both changes"],
)
def test_one_equation_may_weigh_twelve_decades_more_than_another(weights, rng):
    problem = random_problem(rng, 200, 7)
    tilt, velocity, bound = weights
    extreme = dataclasses.replace(
        problem,
        tilt_weight=np.full(200, tilt),
        velocity_weight=np.full(200, velocity),
        bound_weight=np.full(201, bound),
        zero_velocity_weight=np.zeros(200),
    )
    assert_sound(minimise(extreme))


def assert_sound(solution: Solution) -> None:
    """All numbers are finite, and no variance is negative."""
    for field in dataclasses.fields(solution):
        assert np.isfinite(getattr(solution, field.name)).all()
    values = np.linalg.eigvalsh(covariance(solution))
    assert values[0] >= -1e-12 * values[-1]


@pytest.mark.parametrize("spread", [0.0, 1.0, 3.0])
def test_no_variance_of_the_calibration_is_negative(spread, rng):
    for columns in (7, 16):
        assert_sound(minimise(random_problem(rng, 100, columns, spread)))


def test_more_evidence_never_makes_the_calibration_less_certain(rng):
    problem = random_problem(rng, 100, 7)
    doubled = {
        name: 2.0 * getattr(problem, name)
        for name in (
            *("tilt_weight", "velocity_weight"),
            *("bound_weight", "zero_velocity_weight"),
        )
    }
    better = covariance(minimise(dataclasses.replace(problem, **doubled)))
    gained = covariance(minimise(problem)) - better
    assert np.linalg.eigvalsh(gained)[0] > -1e-12 * np.abs(gained).max()


def test_the_input_is_not_changed(rng):
    problem = random_problem(rng, 10, 7)
    before = {
        field.name: getattr(problem, field.name).copy()
        for field in dataclasses.fields(problem)
    }
    minimise(problem)
    for name, values in before.items():
        assert np.array_equal(values, getattr(problem, name))


# ---- the evidence ---------------------------------------------------------------

MODELS = [VelocityModel(0.1, 0.5), VelocityModel(1.0, 2.0), VelocityModel(0.4, 30.0)]


def moving_problem(rng, intervals):
    problem = random_problem(rng, intervals, 7)
    return dataclasses.replace(problem, zero_velocity_weight=np.zeros(intervals))


def process_covariance(problem, model):
    """Return the covariance of a velocity at the nodes, sigma^2 exp(-|t| / tau)."""
    time_s = np.append(0.0, np.cumsum(problem.duration_s))
    apart_s = np.abs(time_s[:, None] - time_s)
    return model.sigma_mps**2 * np.exp(-apart_s / model.correlation_s)


def with_velocity_model(problem, model):
    bound, change = velocity_precisions(problem.duration_s, [model])
    return dataclasses.replace(
        problem, bound_weight=bound[0], zero_velocity_weight=change[0]
    )


@pytest.mark.parametrize("model", MODELS)
def test_a_velocity_model_is_a_gauss_markov_process(model, rng):
    problem = moving_problem(rng, 12)
    modelled = with_velocity_model(problem, model)
    change = np.diff(np.eye(13), axis=0)
    precision = change.T @ np.diag(modelled.zero_velocity_weight) @ change
    precision += np.diag(modelled.bound_weight)
    identity = precision @ process_covariance(problem, model)
    assert np.abs(identity - np.eye(13)).max() < 1e-9


def test_evidences_are_those_of_dense_equations(rng):
    problem = moving_problem(rng, 20)
    expected = []
    for model in MODELS:
        dense = Dense(with_velocity_model(problem, model))
        left = dense.matrix @ np.linalg.lstsq(dense.matrix, dense.right)[0]
        squares = np.square(left - dense.right).sum()
        _, log_states = np.linalg.slogdet(dense.matrix.T @ dense.matrix)
        _, log_process = np.linalg.slogdet(process_covariance(problem, model))
        expected.append(-0.5 * (squares + log_states + 3.0 * log_process))
    found = log_evidences(problem, MODELS)[0]
    assert np.diff(found) == pytest.approx(np.diff(expected), abs=1e-5)


def test_evidence_of_the_noise_counts_its_own_size(rng):
    """Of one gyro and the same with other noise; what was drawn has the most."""
    intervals, found = 2000, []
    problem = moving_problem(rng, intervals)
    model = VelocityModel(0.5, 1.0)
    drawn = np.linalg.cholesky(process_covariance(problem, model))
    velocity = drawn @ rng.standard_normal((intervals + 1, 2))
    noise = rng.standard_normal((2, 2, intervals))
    tilt_change = 3.0 * noise[0] / np.sqrt(problem.tilt_weight)
    tilt = np.concatenate([np.zeros((2, 1)), np.cumsum(tilt_change, axis=1)], axis=1)
    push = np.diff(velocity.T) + 0.5 * G * problem.duration_s * (
        tilt[:, 1:] + tilt[:, :-1]
    )
    push += noise[1] / np.sqrt(problem.velocity_weight)
    impulse = np.concatenate([push, np.zeros((1, intervals))])[None]
    ride = dataclasses.replace(
        problem,
        tilt=np.zeros((1, 2, intervals)),
        impulse=impulse,
        prior=np.zeros(0),
        prior_weight=np.zeros(0),
    )
    factors = (1.0, 2.0, 3.0, 4.0, 6.0)
    for factor in factors:
        noisier = dataclasses.replace(ride, tilt_weight=ride.tilt_weight / factor**2)
        found.append(log_evidences(noisier, [model])[0, 0])
    assert factors[int(np.argmax(found))] == 3.0


def test_the_evidence_of_a_prior_is_that_of_dense_equations(rng):
    problem = random_problem(rng, 12, 7)
    found, expected = [], []
    solution = minimise(problem)
    for share in (1.0, 0.1):
        weight = share * problem.prior_weight
        under = with_prior(solution, problem.prior, weight)
        found.append(log_evidence_of_prior(under, problem.prior, weight))
        dense = Dense(dataclasses.replace(problem, prior_weight=weight))
        left = dense.matrix @ np.linalg.lstsq(dense.matrix, dense.right)[0]
        squares = np.square(left - dense.right).sum()
        _, log_det = np.linalg.slogdet(dense.matrix.T @ dense.matrix)
        expected.append(0.5 * (np.log(weight).sum() - log_det - squares))
    assert found[1] - found[0] == pytest.approx(expected[1] - expected[0], abs=1e-5)
