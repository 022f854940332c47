"""Forces to get to know a device by: every direction and strength, without surprise.

Danieau et al. 2012 let their participants feel what the device can do before the first
clip, so that no participant rates surprise. Strengths come gentle first; each force rises and
falls as half a cosine, slowly enough to let go.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from hapticplayer.model import ForceTrack
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N

RISE_S, HOLD_S, REST_S = 0.6, 0.8, 0.8
LEAD_S = 1.0
STRENGTHS = (0.25, 0.5, 1.0)
_STEP_S = 0.01
_DIRECTIONS: dict[str, tuple[float, float, float]] = {
    "right": (1.0, 0.0, 0.0),
    "left": (-1.0, 0.0, 0.0),
    "up": (0.0, 1.0, 0.0),
    "down": (0.0, -1.0, 0.0),
    "towards you": (0.0, 0.0, 1.0),
    "away from you": (0.0, 0.0, -1.0),
}
NO_DIRECTION = "vibration"


@dataclass(frozen=True, slots=True)
class DemonstrationStep:
    """One force of the demonstration.

    Attributes:
        begin_s, end_s: media time.
        direction: a name of frame D, or "vibration".
        strength_n: at its height.
    """

    begin_s: float
    end_s: float
    direction: str
    strength_n: float


def demonstration(
    capabilities: DeviceCapabilities, strengths: Sequence[float] = STRENGTHS
) -> tuple[ForceTrack, tuple[DemonstrationStep, ...]]:
    """Return a force track (frame D, N) and what is felt when.

    Args:
        capabilities: of the device; its axes are gone through in turns, a device
            without direction only gets the strengths.
        strengths: of each turn, as shares of the largest force.
    """
    cap_n = min(DEFAULT_FORCE_LIMIT_N, capabilities.peak_force_n)
    first, axes = capabilities.first_axis, capabilities.axes
    names = list(_DIRECTIONS)[2 * first : 2 * (first + axes)] or [NO_DIRECTION]
    length_s = 2 * RISE_S + HOLD_S
    steps, begin_s = [], LEAD_S
    for strength in strengths:
        for name in names:
            end_s = begin_s + length_s
            steps.append(DemonstrationStep(begin_s, end_s, name, strength * cap_n))
            begin_s = end_s + REST_S
    times = np.arange(0.0, begin_s + _STEP_S, _STEP_S)
    force = np.zeros((len(times), 3))
    for step in steps:
        direction = _DIRECTIONS.get(step.direction, (1.0, 0.0, 0.0))
        from_ends = np.minimum(times - step.begin_s, step.end_s - times)
        share = np.clip(from_ends / RISE_S, 0.0, 1.0)
        shape = step.strength_n * 0.5 * (1.0 - np.cos(np.pi * share))
        force += np.outer(shape, direction)
    made = {"made": "demonstration"}
    track = ForceTrack(times, force.astype(np.float32), provenance=made)
    return track, tuple(steps)
