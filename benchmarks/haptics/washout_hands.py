"""What hands get under the presets: the reduced model of device and hand, in virtual time.

`sequence.excursion.Grip` with the device's spring, fade and caps (a warm motor's too).
Felt is the force that is sent. The desired force is that of `faithful`.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from scipy import signal

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import HANDS, RELAXED, Hand
from hapticplayer.haptics.centring import centring_of
from hapticplayer.haptics.limiter import cap_when_warm, limits_of
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.washout import magnitude_rms_n, weighted
from hapticplayer.sequence.excursion import RATE_HZ, Grip
from hapticplayer.sequence.presets import YIELDING

HELD: dict[str, Hand] = {
    **HANDS,
    "mild": replace(RELAXED, yield_s=1.0, return_s=1.0),
    "yielding": YIELDING,
    "limp": Hand(RELAXED.mass_kg, 60.0, 5.0),
}
LIMP = "limp"
LIMITS = limits_of(FALCON)
HEAT_SHARE = 1.0 / (RATE_HZ * LIMITS.heat_time_s)
FELT_HZ = 250.0
AFTER_S, WARMTH_S, TRIPS_S = 2.0, 0.1, 1.0
FALSE_HZ, AGAINST_N, NOTHING_N, GHOST_N = 8.0, 0.2, 0.1, 0.3


class Held(NamedTuple):
    """What hands did under a track: force sent (hands, 3, N) N, reach, trips (hands,)."""

    sent_n: Floats
    reach: Floats
    trips: Floats


def hold(tracks: Sequence[ForceTrack]) -> list[Held]:
    """The motion of the hands of HELD under tracks, all side by side."""
    grip = Grip(list(HELD.values()), LIMITS, centring_of(LIMITS))
    grip.rest(len(tracks))
    ends_s = np.array([track.end_s for track in tracks]) + AFTER_S
    steps, every = math.ceil(ends_s.max() * RATE_HZ), round(RATE_HZ / FELT_HZ)
    shape = (len(HELD), len(tracks))
    sent = np.zeros((steps // every + 1, 3, *shape), np.float32)
    heat_n2, reach, trips = np.zeros((3, *shape))
    tripped_s = np.full(shape, -np.inf)
    for first in range(0, steps, block := round(WARMTH_S * RATE_HZ)):
        forces = _planned(tracks, (first + np.arange(block)) / RATE_HZ)
        for step, planned in enumerate(forces, first):
            reach = np.maximum(reach, grip.advance(planned))
            heat_n2 += HEAT_SHARE * (np.square(grip.sent_n).sum(axis=0) - heat_n2)
            is_late = step / RATE_HZ > tripped_s + TRIPS_S
            is_new = is_late & (grip.is_fast | grip.is_outside)
            trips += is_new
            tripped_s[is_new] = step / RATE_HZ
            if step % every == 0 and step < steps:
                sent[step // every] = grip.sent_n
        caps = [cap_when_warm(one, LIMITS) for one in heat_n2.ravel().tolist()]
        grip.cap_n = np.reshape(caps, shape)
    counts = np.ceil(ends_s * FELT_HZ).astype(int)
    return [
        Held(sent[:count, :, :, k].transpose(2, 1, 0), reach[:, k], trips[:, k])
        for k, count in enumerate(counts.tolist())
    ]


def _planned(tracks: Sequence[ForceTrack], time_s: Floats) -> Floats:
    """Return the force (N, 3, tracks) at times; it fades in as the loop enters."""
    force = np.stack([track.at(time_s) for track in tracks], axis=2)
    entry = np.minimum(1.0, time_s * FALCON.rate_hz / LIMITS.entry_ticks)
    return np.asarray(force * entry[:, None, None])


def judged(desired: ForceTrack, held: Held) -> dict[str, Any]:
    """Return errors, false cues, reach and trips by hand, and the spread of the force.

    The spread is the largest difference between two hands, limp ones left out.
    """
    count = held.sent_n.shape[2]
    wanted = desired.at(np.arange(count) / FELT_HZ).T
    size_n = max(magnitude_rms_n(weighted(wanted, FELT_HZ)), 1e-9)
    felt = {
        name: weighted(one.astype(float), FELT_HZ)
        for name, one in zip(HELD, held.sent_n, strict=True)
    }
    aimed = weighted(wanted, FELT_HZ)
    firm = [one for name, one in felt.items() if name != LIMP]
    spread_n = max(magnitude_rms_n(one - other) for one in firm for other in firm)
    return {
        "error": {n: magnitude_rms_n(one - aimed) / size_n for n, one in felt.items()},
        "false": {
            name: false_share(one.astype(float), wanted, FELT_HZ)
            for name, one in zip(HELD, held.sent_n, strict=True)
        },
        "reach": dict(zip(HELD, held.reach.tolist(), strict=True)),
        "trips": dict(zip(HELD, held.trips.tolist(), strict=True)),
        "spread": spread_n / size_n,
    }


def false_share(felt: Floats, desired: Floats, rate_hz: float) -> float:
    """Return the share of time with a force that is against the desired one, or a ghost.

    Against: 0.2 N against a desired force of more than 0.2 N. A ghost: more than 0.3 N
    where less than 0.1 N is desired. Below 8 Hz; forces (3, N).
    """
    sections = signal.butter(2, FALSE_HZ, fs=rate_hz, output="sos")
    felt, desired = (signal.sosfiltfilt(sections, one) for one in (felt, desired))
    size = np.linalg.norm(desired, axis=0)
    along = (felt * desired).sum(axis=0) / np.maximum(size, 1e-9)
    is_against = (size > AGAINST_N) & (along < -AGAINST_N)
    is_ghost = (size < NOTHING_N) & (np.linalg.norm(felt, axis=0) > GHOST_N)
    return float(np.mean(is_against | is_ghost))


def overview(each: Sequence[Mapping[str, Any]]) -> dict[str, float]:
    """Return means and worst values over rides."""
    others = [name for name in HELD if name != LIMP]

    def mean(key: str, hand: str) -> float:
        return float(np.mean([one[key][hand] for one in each]))

    false = [share for one in each for share in one["false"].values()]
    return {
        "error, relaxed": mean("error", "relaxed"),
        "yielding": mean("error", "yielding"),
        "limp": mean("error", LIMP),
        "spread": float(np.mean([one["spread"] for one in each])),
        "worst spread": max(one["spread"] for one in each),
        "reach": max(one["reach"][name] for one in each for name in others),
        "limp reach": max(one["reach"][LIMP] for one in each),
        "trips": sum(one["trips"][name] for one in each for name in others),
        "limp trips": sum(one["trips"][LIMP] for one in each),
        "false cues": float(np.mean(false)),
    }
