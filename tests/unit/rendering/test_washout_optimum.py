"""The optimised washout beside an interior-point method, on short rides."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.extras.rides.motion_scenes import simulate_motion
from hapticplayer.rendering.washout import DesignHand, Washout, solve

HAND = DesignHand((0.45, 0.45, 0.69), (8.6, 8.6, 9.2), 150.0)
YIELDING = dataclasses.replace(HAND, yield_s=0.3, return_s=2.0)
LIMITS = Washout((YIELDING, HAND), 0.022)
RATE_HZ, COUNT, PAD = 50.0, 125, 400
GAP = 1e-4
CAP_N, ASIDE_N = 4.5, 0.15


def ride(scene, begin_s):
    """Return 2.5 s of the force of a simulated ride, (3, COUNT) N at 50 Hz."""
    made = simulate_motion(scene, 1, duration_s=30.0)
    at_s = made.imu.time_s[0] + begin_s + np.arange(COUNT) / RATE_HZ
    axes = [np.interp(at_s, made.imu.time_s, axis) for axis in made.acceleration_mps2.T]
    force = 0.4 * np.stack([axes[0], axes[2], -axes[1]])
    return force * np.minimum(1.0, CAP_N / np.linalg.norm(force, axis=0))


def responses(spectrum, size):
    """Return the columns (size, COUNT) that unit samples have after a filter."""
    columns = np.fft.rfft(np.eye(size, COUNT), axis=0)
    return np.fft.irfft(spectrum[:, None] * columns, size, axis=0)


def ways(size):
    """Return the way of each hand in limits, (hands, 3, size, COUNT), per N."""
    s = 2j * np.pi * np.fft.rfftfreq(size, 1.0 / RATE_HZ)
    kept = 1.0 - (1.0 / 0.3) / (s + 1.0 / 0.3 + 0.5)
    made = [
        [
            responses((1.0 + 0.01 * s) / (m * s**2 + b * s + k) / 0.022, size)
            for m, b in ((0.45, 8.6), (0.45, 8.6), (0.69, 9.2))
        ]
        for k in (150.0 * kept, 150.0 + 0.0 * s)
    ]
    return np.array(made)


def error_matrix(size):
    """Return Q with u'Qu the squared weighted size of one axis."""
    f = np.fft.rfftfreq(size, 1.0 / RATE_HZ)
    square = (0.09 + (f / 0.5) ** 2) / (1.0 + (f / 0.5) ** 2) / (1.0 + (f / 15.0) ** 4)
    root = responses(np.sqrt(square), size)
    return root.T @ root


def newton(u, wanted, quadratic, sides, balls, sharpness):
    """Return the Newton step of the barrier problem and its decrement."""
    low, high = sides
    gradient = sharpness * (quadratic @ (u - wanted).T).T + 1.0 / (high - u)
    gradient -= 1.0 / (u - low)
    hessian = np.zeros((3, COUNT, 3, COUNT))
    each = range(3)
    for axis in each:
        walls = 1.0 / (high[axis] - u[axis]) ** 2 + 1.0 / (u[axis] - low[axis]) ** 2
        hessian[axis, :, axis] += sharpness * quadratic + np.diag(walls)
    for rows in balls:
        z = np.einsum("asc,ac->as", rows, u)
        slack = 1.0 - np.square(z).sum(axis=0)
        gradient += np.einsum("asc,as->ac", rows, 2.0 * z / slack)
        for a, b in [(a, b) for a in each for b in each]:
            share = 4.0 * z[a] * z[b] / slack**2 + (2.0 / slack if a == b else 0.0)
            hessian[a, :, b] += rows[a].T @ (share[:, None] * rows[b])
    step = -np.linalg.solve(hessian.reshape(3 * COUNT, -1), gradient.ravel())
    return step.reshape(3, COUNT), float(-step @ gradient.ravel())


def interior_point(wanted, quadratic, sides, balls):
    """Return u within GAP of the least cost, by the barrier method.

    Boyd & Vandenberghe, Convex Optimization, 11.3: with m constraints the centre of
    sharpness t costs at most m/t more than the optimum.
    """
    low, high = sides
    constraints = 6 * COUNT + sum(rows.shape[1] for rows in balls)

    def barrier(u, sharpness):
        room = [u - low, high - u]
        room += [
            1.0 - np.square(np.einsum("asc,ac->as", rows, u)).sum(axis=0)
            for rows in balls
        ]
        if min(one.min() for one in room) <= 0.0:
            return np.inf
        off = u - wanted
        cost = 0.5 * np.einsum("ac,cd,ad->", off, quadratic, off)
        return sharpness * cost - sum(np.log(one).sum() for one in room)

    u, sharpness = np.zeros((3, COUNT)), 1e3
    while constraints / sharpness > GAP:
        sharpness *= 30.0
        for _ in range(100):
            step, decrement = newton(u, wanted, quadratic, sides, balls, sharpness)
            if decrement < 1e-6:
                break
            size, now = 1.0, barrier(u, sharpness)
            while barrier(u + size * step, sharpness) > now - 0.1 * size * decrement:
                size *= 0.5
            u += size * step
        assert decrement < 1e-6
    return u


@pytest.mark.parametrize(
    ("scene", "begin_s"), [("run", 12.0), ("car-hard", 9.0), ("mountain-bike", 18.0)]
)
def test_an_interior_point_method_finds_no_better(scene, begin_s):
    wanted = ride(scene, begin_s)
    size = COUNT + PAD
    quadratic, hands = error_matrix(size), ways(size)
    quadratic /= np.einsum("ac,cd,ad->", wanted, quadratic, wanted)
    sides = np.minimum(0.0, wanted) - ASIDE_N, np.maximum(0.0, wanted) + ASIDE_N
    cap = np.stack([np.eye(COUNT) / CAP_N] * 3)
    best = interior_point(wanted, quadratic, sides, [*hands, cap])
    found = solve(wanted, LIMITS)
    reach = np.linalg.norm(np.einsum("hasc,ac->has", hands, found), axis=1).max()
    assert reach < 1.01
    assert np.all((found > sides[0] - 1e-6) & (found < sides[1] + 1e-6))
    errors = [
        np.sqrt(np.einsum("ac,cd,ad->", one - wanted, quadratic, one - wanted))
        for one in (found, best)
    ]
    assert errors[1] > 0.25
    assert errors[0] == pytest.approx(errors[1], rel=0.01)
