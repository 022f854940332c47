"""Kinematics against reference rows, finite differences, numpy and closed forms."""

import math
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.devices.falcon import kinematics, matrix3
from hapticplayer.devices.falcon.kinematics import (
    FALCON_GEOMETRY,
    WORD_LIMIT,
    Kinematics,
    OutOfReachError,
)

# Traced from the vendor's own driver: force, N, and motor words.
TRACED = [
    ((0.0, 0.0, -12.5), (661, 731, 766)),
    ((0.0, 0.0, -25.0), (1311, 1453, 1526)),
    ((0.0, 0.0, -50.0), (2752, 2780, 2888)),
    ((10.0, 0.0, 0.0), (-679, 2529, -1862)),
    ((-12.5, 0.0, 0.0), (399, -3087, 1135)),
    ((0.0, 10.0, 0.0), (2481, -669, -1691)),
    ((0.0, -12.5, 0.0), (-2900, 27, 929)),
]


def in_workspace(rng, count, radius_m=0.045):
    """Points of a sphere that is a little larger than the one that is used."""
    directions = rng.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    radii = radius_m * rng.uniform(size=(count, 1)) ** (1 / 3)
    return [tuple(p) for p in (directions * radii + [0.0, 0.0, 0.12]).tolist()]


def test_the_ten_reference_rows_are_met(golden):
    assert len(golden["kinematics"]) == 10
    for row in golden["kinematics"]:
        theta = kinematics.angles(row["counts"])
        assert theta == pytest.approx(row["theta"], abs=1e-15)
        position, jacobian = kinematics.pose(theta)
        assert position == pytest.approx(row["p"], abs=1e-12)
        np.testing.assert_allclose(jacobian, row["J"], rtol=0, atol=1e-10)
        torques = matrix3.transposed_times(jacobian, (1.0, 2.0, -3.0))
        assert torques == pytest.approx(row["tau"], abs=1e-9)
        words = kinematics.motor_words(jacobian, (1.0, 2.0, -3.0))
        assert words == pytest.approx([-10_000.0 * tau for tau in row["tau"]], abs=1e-5)
        assert matrix3.condition(jacobian) == pytest.approx(row["cond"], rel=1e-7)


def test_forward_undoes_inverse_over_the_workspace(rng):
    for position in in_workspace(rng, 3000):
        theta = kinematics.inverse(position)
        found = kinematics.forward(theta)
        assert math.dist(found, position) < 1e-9
        near = tuple(part + 0.002 for part in position)
        assert math.dist(kinematics.forward(theta, near), position) < 1e-9


def test_forward_undoes_inverse_wherever_the_legs_reach(rng):
    reached = 0
    for position in rng.uniform([-0.06, -0.06, 0.07], [0.06, 0.06, 0.18], (4000, 3)):
        try:
            theta = kinematics.inverse(tuple(position.tolist()))
        except OutOfReachError:
            continue
        reached += 1
        assert math.dist(kinematics.forward(theta), position) < 1e-9
    assert reached > 3000


def test_a_bad_start_leads_to_the_same_pose(rng):
    for position in in_workspace(rng, 500):
        start = tuple(rng.uniform(-0.3, 0.3, 3).tolist())
        found = kinematics.forward(kinematics.inverse(position), start)
        assert math.dist(found, position) < 1e-9


def test_the_closure_of_every_leg_holds_at_the_solution(rng):
    """The constraint itself, written out with numpy and not with our formulas."""
    g = FALCON_GEOMETRY
    for theta in rng.uniform(math.radians(-20), math.radians(60), (300, 3)):
        try:
            p = np.array(kinematics.forward(tuple(theta.tolist())))
        except OutOfReachError:
            continue
        for phi, angle in zip(g.azimuths_rad, theta, strict=True):
            turn = np.array(
                [
                    [math.cos(phi), math.sin(phi), 0.0],
                    [-math.sin(phi), math.cos(phi), 0.0],
                    [0.0, 0.0, 1.0],
                ]
            )
            grip = turn @ p + [g.grip_radius_m, g.grip_offset_m, 0.0]
            knee = np.array(
                [
                    g.base_radius_m + g.thigh_m * math.cos(angle),
                    g.base_offset_m,
                    g.thigh_m * math.sin(angle),
                ]
            )
            u, v, w = grip - knee
            along = math.hypot(u, w) - g.shin_ends_m
            assert math.hypot(along, v) == pytest.approx(g.shin_m, abs=1e-9)


def test_the_jacobian_is_that_of_finite_differences(rng):
    step = 1e-5
    for position in in_workspace(rng, 200):
        jacobian = np.array(kinematics.jacobian(position))
        theta = np.array(kinematics.inverse(position))
        columns = []
        for joint in range(3):
            ahead, behind = theta.copy(), theta.copy()
            ahead[joint] += step
            behind[joint] -= step
            columns.append(
                (
                    np.array(kinematics.forward(tuple(ahead.tolist()), position))
                    - kinematics.forward(tuple(behind.tolist()), position)
                )
                / (2 * step)
            )
        error = np.abs(np.array(columns).T - jacobian).max()
        assert error < 1e-5 * np.abs(jacobian).max()


def test_torques_do_the_work_of_the_force(rng):
    for position in in_workspace(rng, 50):
        jacobian = kinematics.jacobian(position)
        force, rates = rng.normal(size=3), rng.normal(size=3)
        power_w = force @ np.array(jacobian) @ rates
        torques = matrix3.transposed_times(jacobian, tuple(force))
        assert np.dot(torques, rates) == pytest.approx(power_w, rel=1e-12)


def test_condition_numbers_are_those_of_numpy(rng):
    for size in (0.01, 1.0, 1e4):
        for rows in size * rng.normal(size=(300, 3, 3)):
            expected = np.linalg.cond(rows)
            found = matrix3.condition(tuple(map(tuple, rows.tolist())))
            if expected < 1000:
                assert found == pytest.approx(expected, rel=1e-6)
            assert matrix3.condition_bound(rows.tolist()) >= expected * (1 - 1e-9)
    one = ((2.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 2.0))
    assert matrix3.condition(one) == 1.0
    assert matrix3.condition_bound(one) == pytest.approx(2.0)
    flat = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0))
    assert matrix3.condition(flat) == math.inf
    assert matrix3.condition_bound(flat) == math.inf
    assert matrix3.condition(((0.0,) * 3,) * 3) == math.inf


def test_the_force_does_not_fade_in_the_workspace(rng):
    assert all(
        kinematics.fade(kinematics.jacobian(p)) == 1.0 for p in in_workspace(rng, 500)
    )


def test_force_fades_out_evenly_near_singular_poses():
    """diag(1, 1, 1/k) has the condition number k."""

    def share(k):
        return kinematics.fade(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0 / k)))

    assert share(5.9) == share(6.0) == 1.0
    assert share(7.5) == pytest.approx(0.5)
    assert share(8.7) == pytest.approx(0.1, abs=1e-6)
    assert share(9.0) == pytest.approx(0.0, abs=1e-6)
    assert share(50.0) == 0.0
    # the zone that the reference names: far out and off the axis
    at_the_edge = kinematics.jacobian((0.050, 0.0, 0.165))
    assert matrix3.condition(at_the_edge) == pytest.approx(9.17, abs=0.01)
    assert kinematics.motor_words(at_the_edge, (1.0, 2.0, 3.0)) == pytest.approx(
        (0.0, 0.0, 0.0)
    )


def test_saturation_keeps_the_direction_of_the_force(rng):
    saturated = 0
    for position in in_workspace(rng, 300):
        jacobian = kinematics.jacobian(position)
        force = rng.normal(size=3) * rng.uniform(1.0, 200.0)
        words = np.array(kinematics.motor_words(jacobian, tuple(force)))
        assert np.abs(words).max() <= WORD_LIMIT
        saturated += np.abs(words).max() == pytest.approx(WORD_LIMIT)
        felt = np.linalg.solve(np.array(jacobian).T, -words)
        sine = np.linalg.norm(np.cross(felt, force)) / (
            np.linalg.norm(felt) * np.linalg.norm(force)
        )
        assert sine < 1e-12
        assert felt @ force > 0.0
        # rounding to whole words costs at most half a word in each motor
        assert np.abs(np.round(words) - words).max() <= 0.5
    assert saturated > 200


def test_sixty_newtons_do_not_wrap_round_and_reverse():
    """39044 as a 16-bit word is -26492: the force of libnifalcon turns round."""
    jacobian = kinematics.jacobian((0.0, 0.0, 0.1346))
    words = kinematics.motor_words(jacobian, (60.0, 0.0, 0.0))
    assert max(map(abs, words)) == pytest.approx(WORD_LIMIT)
    unlimited = [
        -10_000.0 * t for t in matrix3.transposed_times(jacobian, (60.0, 0.0, 0.0))
    ]
    assert max(map(abs, unlimited)) == pytest.approx(39_044, abs=5)


@pytest.mark.parametrize(("force_n", "traced"), TRACED)
def test_traced_packets_have_our_order_and_signs(force_n, traced):
    """Where the grip was is not recorded; near z = 63 mm and 70 mm fits best."""
    place = (0.0, 0.0, 0.063 if force_n[2] else 0.070)
    words = np.array(kinematics.motor_words(kinematics.jacobian(place), force_n))
    cosine = words @ traced / (np.linalg.norm(words) * np.linalg.norm(traced))
    assert cosine > (0.99 if 10.0 in force_n else 0.92)
    significant = np.abs(traced) > 100
    assert (np.sign(words) == np.sign(traced))[significant].all()


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e308])
def test_a_force_that_is_no_number_is_refused(bad):
    jacobian = kinematics.jacobian((0.0, 0.0, 0.12))
    for axis in range(3):
        force = [0.0, 0.0, 0.0]
        force[axis] = bad
        with pytest.raises(ValueError, match="finite"):
            kinematics.motor_words(jacobian, tuple(force))


def test_out_of_reach_is_said():
    for position in ((0.0, 0.0, 0.3), (0.2, 0.0, 0.12), (math.nan, 0.0, 0.12)):
        with pytest.raises(OutOfReachError, match="no leg reaches"):
            kinematics.inverse(position)
    with pytest.raises(OutOfReachError, match="cannot be assembled"):
        kinematics.forward((3.0, -2.0, 1.0))
    with pytest.raises(OutOfReachError):
        kinematics.forward((math.nan, 0.0, 0.0))


def test_counts_are_angles_to_the_nearest_count(rng):
    legs = Kinematics()
    for counts in rng.integers(-1700, 900, (100, 3)).tolist():
        assert legs.counts(legs.angles(tuple(counts))) == tuple(counts)
    degrees = math.degrees(legs.angles((1, 0, 0))[0] - legs.angles((0, 0, 0))[0])
    assert degrees == pytest.approx(0.0364347, abs=1e-7)


def test_another_geometry_is_another_position():
    """One degree at count 0 is 1.2 mm in z; s = f turns nothing any more."""
    turned = Kinematics(replace(FALCON_GEOMETRY, theta0_rad=math.radians(36.0)))
    moved = turned.forward(turned.angles((-300, -300, -300)))
    was = kinematics.forward(kinematics.angles((-300, -300, -300)))
    assert moved[2] - was[2] == pytest.approx(0.0012, abs=0.0003)
    straight = Kinematics(
        replace(FALCON_GEOMETRY, base_offset_m=FALCON_GEOMETRY.grip_offset_m)
    )
    row = straight.jacobian((0.0, 0.0, 0.12))[0]
    ratios = [math.cos(phi) for phi in FALCON_GEOMETRY.azimuths_rad]
    assert np.array(row) / ratios == pytest.approx([row[0] / ratios[0]] * 3, rel=1e-9)
