"""Hard braking and turns: seconds of acceleration that change the velocity.

Both look at the level acceleration below 1 Hz, forwards and to the left of the recorder's
heading. A camera waved by hand reaches the same levels, but its velocity comes back within
a second; what travels keeps the change.
"""

from collections.abc import Iterator

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.event import GRID_HZ, Event, EventInputs, over

BELOW_HZ = 1.0
BRAKING_MPS2 = 0.3 * STANDARD_GRAVITY_MPS2
"""What telematics calls harsh; drivers mostly stay below 0.2 g."""

TURN_MPS2 = 0.15 * STANDARD_GRAVITY_MPS2
"""0.6 N at the default gain; gravity that is left in the motion reaches 0.5 m/s^2."""

LEAST_S = 0.4
LEAST_CHANGE_MPS = 1.5
"""A waving hand changes its velocity by 1 m/s within a swing."""

ENDS = 0.5
LEAST_YAW_RADPS = 0.03
LARGEST_SPEED_MPS, LEAST_SPEED_MPS = 80.0, 1.0
"""Lateral acceleration over yaw rate is the speed, for what travels where it looks."""

EMPHASIS = 1.3
FADE_S = 0.2


def hard_braking(inputs: EventInputs) -> list[Event]:
    """Return where a recording loses speed at 0.3 g or more."""
    slow = _below(inputs.level[:, 0])
    found = []
    for span in _spans(-slow, BRAKING_MPS2):
        level, change = _described(-slow[span])
        text = Message(
            "Braking at up to {level_mps2:.1f} m/s², {change_mps:.0f} m/s slower",
            level_mps2=level,
            change_mps=change,
        )
        confidence = _confidence(level / BRAKING_MPS2)
        found.append(_event("braking", inputs, span, confidence, text))
    return found


def turns(inputs: EventInputs) -> list[Event]:
    """Return where a recording turns with 0.15 g or more sideways."""
    left, yaw = _below(inputs.level[:, 1]), _below(inputs.level[:, 2])
    found = []
    for side in (1.0, -1.0):
        for span in _spans(side * left, TURN_MPS2):
            level, change = _described(side * left[span])
            rate = float(np.mean(side * yaw[span]))
            length_s = (span.stop - span.start) / GRID_HZ
            if not _travels(change, rate, length_s):
                continue
            text = Message(
                "Turn to the left with up to {level_mps2:.1f} m/s² for {length_s:.1f} s"
                if side > 0.0
                else "Turn to the right with up to {level_mps2:.1f} m/s² for "
                "{length_s:.1f} s",
                level_mps2=level,
                length_s=length_s,
            )
            confidence = _confidence(level / TURN_MPS2)
            found.append(_event("turn", inputs, span, confidence, text))
    return sorted(found, key=lambda one: one.start_s)


def _travels(change_mps: float, yaw_radps: float, length_s: float) -> bool:
    """Return whether the heading follows the turn as that of what travels does."""
    if yaw_radps < LEAST_YAW_RADPS:
        return False
    return LEAST_SPEED_MPS <= change_mps / (yaw_radps * length_s) <= LARGEST_SPEED_MPS


def _event(
    kind: str, inputs: EventInputs, span: slice, confidence: float, text: Message
) -> Event:
    start_s, end_s = inputs.grid_s[[span.start, span.stop - 1]].tolist()
    effect = over("gain", (start_s, end_s), FADE_S, gain=EMPHASIS)
    return Event(kind, start_s, end_s, confidence, text, effect)


def _below(values: Floats) -> Floats:
    """Return values (N,) without what is faster than 1 Hz."""
    from scipy.signal import butter, sosfiltfilt

    sections = butter(2, BELOW_HZ, fs=GRID_HZ, output="sos")
    padding = min(len(values) - 1, round(GRID_HZ))
    return np.asarray(sosfiltfilt(sections, values, padlen=padding))


def _spans(level: Floats, limit_mps2: float) -> Iterator[slice]:
    """Yield where a level stays above half of a limit, and reaches it long enough."""
    from hapticplayer.motion.conditioning.timing import runs

    for first, last in zip(*runs(level > ENDS * limit_mps2), strict=True):
        span = slice(int(first), int(last))
        above_s = np.count_nonzero(level[span] > limit_mps2) / GRID_HZ
        change_mps = float(level[span].sum()) / GRID_HZ
        if above_s >= LEAST_S and change_mps >= LEAST_CHANGE_MPS:
            yield span


def _described(level: Floats) -> tuple[float, float]:
    """Return the largest level, and the change of velocity."""
    return float(level.max()), float(level.sum()) / GRID_HZ


def _confidence(ratio: float) -> float:
    """Return 0.5 at the threshold, 0.75 at twice of it."""
    return 1.0 - 0.5 / max(ratio, 1.0)
