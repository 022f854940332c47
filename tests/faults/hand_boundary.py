"""Where a sampled spring on the free grip begins to oscillate, found and computed."""

import math

import numpy as np
from hand_cases import SMOOTH

from hapticplayer.haptics.centring import Centring, ahead_of
from hapticplayer.haptics.hand import SMOOTHING_S, HandState, observe
from hapticplayer.haptics.limiter import PERIOD_S, ZERO, Limits
from hapticplayer.simulation.falcon.kinematics import PlantKinematics
from hapticplayer.simulation.falcon.parameters import Electronics, PlantGeometry
from hapticplayer.simulation.falcon.simulation import Simulation

PIPELINE_S = PERIOD_S  # a command is made of the reading that came a period before
_PLUCKED_M, _STEPS = 0.004, 14
_AT_REST_M = 0.0003  # six counts of the encoder


def sideways(mechanism=SMOOTH):
    """Return mass, kg, and friction, N s/m, that the free grip has along x."""
    rows = PlantKinematics(PlantGeometry()).inverse(ZERO).rates
    per_m2 = sum(row[0] ** 2 for row in rows)
    mass = mechanism.joint_inertia_kg_m2 * per_m2 + mechanism.grip_mass_kg
    return mass, mechanism.viscous_nm_s * per_m2


def growth(stiffness_n_per_m, delay_s, ahead_s=0.0, mechanism=SMOOTH, seconds=2.4):
    """Return the swing of a plucked grip at the end of a trial, as share of before.

    The spring acts along all axes; along x it is plucked, and the grip is lightest.
    """
    simulation = Simulation(
        None, mechanism=mechanism, electronics=Electronics(delay_s=delay_s)
    )
    simulation.place((_PLUCKED_M, 0.0, 0.0))
    hand, reading, way = HandState(), None, []
    centring, limits = Centring(ahead_s=ahead_s), Limits()
    for tick in range(round(seconds / PERIOD_S)):
        now_s = 1.0 + tick * PERIOD_S
        hand = observe(hand, reading, limits)
        seen_m = ahead_of(hand, centring) if reading else (_PLUCKED_M, 0.0, 0.0)
        force = tuple(-stiffness_n_per_m * value for value in seen_m)
        simulation.command(force, now_s)
        reading = simulation.reading(now_s)
        way.append(math.hypot(*simulation.position_m))
        if way[-1] > 3.0 * _PLUCKED_M:
            return math.inf
    part = len(way) // 3
    last_m = max(way[-part:])
    return last_m / max(way[part : 2 * part]) if last_m > _AT_REST_M else 0.0


def largest_stable(delay_s, ahead_s=0.0, mechanism=SMOOTH, between=(20.0, 8000.0)):
    """Return the stiffness at which the swing neither grows nor shrinks, N/m."""
    low, high = between
    for _ in range(_STEPS):
        middle = math.sqrt(low * high)
        if growth(middle, delay_s, ahead_s, mechanism) > 1.0:
            high = middle
        else:
            low = middle
    return math.sqrt(low * high)


def computed_boundary(mass, friction, delay_ticks, ahead_s):
    """Return the same from the eigenvalues of the sampled linear loop, N/m."""
    low, high = 1.0, 1e5
    while high / low > 1.001:
        middle = math.sqrt(low * high)
        radius = _spectral_radius(middle, mass, friction, delay_ticks, ahead_s)
        low, high = (low, middle) if radius > 1.0 else (middle, high)
    return low


def _spectral_radius(stiffness, mass, friction, delay_ticks, ahead_s):
    """Mass with friction under -K (x + ahead v'), v' smoothed, so many ticks late."""
    decay = math.exp(-friction / mass * PERIOD_S)
    travel = mass / friction * (1.0 - decay)
    lag = PERIOD_S / SMOOTHING_S
    size = 4 + delay_ticks  # place, speed, place before, smoothed speed, forces due
    rows = np.zeros((size, size))
    smoothed = np.zeros(size)
    smoothed[[0, 2, 3]] = lag / PERIOD_S, -lag / PERIOD_S, 1.0 - lag
    force = -stiffness * (np.eye(size)[0] + ahead_s * smoothed)
    acting = np.eye(size)[-1] if delay_ticks else force
    rows[0] = np.eye(size)[0] + travel * np.eye(size)[1]
    rows[0] += (PERIOD_S - travel) / friction * acting
    rows[1] = decay * np.eye(size)[1] + (1.0 - decay) / friction * acting
    rows[2], rows[3] = np.eye(size)[0], smoothed
    for late in range(delay_ticks):
        rows[4 + late] = force if late == 0 else np.eye(size)[3 + late]
    return np.abs(np.linalg.eigvals(rows)).max()
