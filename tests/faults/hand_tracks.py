"""Force tracks that push a hand for long or hard: rides, and hostile ones."""

import functools

import numpy as np

from hapticplayer.model import Feedback, ForceTrack, Mapping, MotionTrack
from hapticplayer.model import quaternions as quat
from hapticplayer.model.force import Reconstruction
from hapticplayer.rendering import random_feedback, render_force

GRAVITY_MPS2 = 9.80665
RATE_HZ = 200.0
SEED = 2012
STRONGEST_N = Mapping().force_limit_n


def rendered(time_s, acceleration_mps2):
    """Return the force of a motion at the default gain."""
    count = len(time_s)
    motion = MotionTrack(
        time_s=time_s,
        acceleration_mps2=acceleration_mps2,
        gravity_mps2=np.tile([0.0, 0.0, GRAVITY_MPS2], (count, 1)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)),
        gravity_sigma_mps2=None,
        valid=np.ones(count, dtype=bool),
    )
    return render_force(motion)


def demo():
    """The built-in ride: a bend, a kerb, a hard stop."""
    from hapticplayer.extras.rides.recording import simulate

    truth = simulate("demo", SEED).truth
    up = np.array([0.0, 0.0, GRAVITY_MPS2])
    gravity = quat.rotate(quat.conjugate(truth.quaternion_wxyz), up)
    return rendered(truth.time_s - truth.time_s[0], truth.specific_force_mps2 - gravity)


def bike():
    """A mountain bike downhill: knocks up to the limit of the force."""
    from hapticplayer.extras.rides.motion_scenes import simulate_motion

    ride = simulate_motion("mountain-bike", SEED, duration_s=20.0)
    return rendered(ride.imu.time_s - ride.imu.time_s[0], ride.acceleration_mps2)


def horse():
    """A gallop: 1.8 strides per second, up and down by up to 1 g."""
    t = np.arange(0.0, 15.0, 1.0 / RATE_HZ)
    stride = 2.0 * np.pi * 1.8 * t
    along = 3.0 * np.sin(stride + 1.2) + np.sin(2.0 * stride)
    up = 7.0 * np.sin(stride) + 3.0 * np.sin(2.0 * stride + 1.0)
    up += 1.5 * np.sin(3.0 * stride + 0.3)
    across = 1.5 * np.sin(0.5 * stride)
    away = np.clip(t, 0.0, 1.0)[:, None]
    return rendered(t, away * np.stack([across, along, up], axis=1))


def turning():
    """Roundabouts at 0.92 g, 4 s to each side, the change within 0.6 s."""
    t = np.arange(0.0, 20.0, 1.0 / RATE_HZ)
    across = 9.0 * _plateaus(t, [(1, 5, 1), (5, 9, -1), (9, 13, 1), (13, 19, -1)], 0.6)
    road = np.random.default_rng(SEED).normal(0.0, 0.5, len(t))
    return rendered(t, np.stack([across, 0.0 * t, road], axis=1))


def braking():
    """Away at 0.4 g, and full brakes: 0.97 g, then 1.1 g that ends with a jerk."""
    t = np.arange(0.0, 18.0, 1.0 / RATE_HZ)
    along = 4.0 * _plateaus(t, [(1, 4, 1), (10.5, 13, 1)], 0.5)
    along -= 9.5 * _plateaus(t, [(6, 9, 1)], 0.2)
    along -= 11.0 * _plateaus(t, [(14.5, 16.5, 1)], 0.1)
    road = np.random.default_rng(SEED).normal(0.0, 0.6, len(t))
    return rendered(t, np.stack([0.0 * t, along, road], axis=1))


TRACKS = {
    "demo": demo,
    "bike": bike,
    "horse": horse,
    "turning": turning,
    "braking": braking,
}


@functools.cache
def track(name):
    """Return one of the five rides."""
    return TRACKS[name]()


def hostile():
    """Return tracks that no recording gives, by name."""
    knocks = [shaken(f"knocks {f:g} Hz {'xyz'[axis]}", f, axis)
              for f, axis in ((2.0, 0), (3.0, 0), (3.0, 2), (5.0, 1))]  # fmt: skip
    steady = [("steady " + "xyz"[axis], steady_push(STRONGEST_N, axis, 6.0))
              for axis in range(3)]  # fmt: skip
    noise = random_feedback(scaled(track("turning"), 1.5), SEED)
    return dict([*knocks, *steady, (f"{Feedback.RANDOM} 1.5x", noise)])


def shaken(name, frequency_hz, axis, duration_s=6.0):
    """Return full force to and fro, (name, track)."""
    t = np.arange(0.0, duration_s, 0.002)
    force = np.zeros((len(t), 3))
    force[:, axis] = STRONGEST_N * np.sign(np.sin(2.0 * np.pi * frequency_hz * t))
    return name, ForceTrack(t, force)


def steady_push(force_n, axis, duration_s, rise_s=0.5):
    """Return a force that rises and stays."""
    force = np.zeros((4, 3))
    force[2:, axis] = force_n
    return ForceTrack([0.0, 0.3, 0.3 + rise_s, duration_s], force)


def scaled(whole, factor):
    """Return a track with every force multiplied, up to the limit."""
    force = factor * whole.force_n.astype(np.float64)
    size = np.linalg.norm(force, axis=1, keepdims=True)
    force *= np.minimum(1.0, STRONGEST_N / np.maximum(size, 1e-9))
    return ForceTrack(whole.time_s, force, Reconstruction.LINEAR)


def excerpt(whole, begin_s, end_s):
    """Return a part of a track, from time 0 on."""
    inside = (whole.time_s >= begin_s) & (whole.time_s <= end_s)
    return ForceTrack(whole.time_s[inside] - begin_s, whole.force_n[inside])


def _plateaus(t, spans, edge_s):
    """Return levels over (begin, end, level), with soft edges."""
    total = np.zeros_like(t)
    for begin_s, end_s, level in spans:
        for at_s, sign in ((begin_s, 1.0), (end_s, -1.0)):
            u = np.clip((t - at_s) / edge_s, 0.0, 1.0)
            total += sign * level * u * u * (3.0 - 2.0 * u)
    return total
