"""Stillness, saturated sensors and artefacts, as the processing of the motion knows them."""

from collections.abc import Iterator

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.effects import Effect
from hapticplayer.rendering.event import (
    GRID_HZ,
    Event,
    EventInputs,
    Flags,
    effect_on,
    over,
)

MERGE_S = 0.25
LEAST_STILL_S = 0.9
PUSHED_MPS2 = 0.5
"""Gravity that is left in the motion stays below it, a calm driver does not."""

ARTEFACT_MERGE_S = 0.05
_STILL = Message("No motion: force here is gravity that was not removed")
_FORCE_CLIPPED = Message("The accelerometer is at the end of its range")
_RATE_CLIPPED = Message("The gyro is at the end of its range")
_MISSING = Message("Samples are missing")
_SPIKE = Message("Spike of a single sample, as a faulty logger writes")
FADE_S, SHORT_FADE_S, SMOOTH_BELOW_HZ = 0.2, 0.05, 8.0


def stillness(inputs: EventInputs) -> list[Event]:
    """Return spans of a second or more without motion, see `motion.stillness`.

    A sensor that is pushed evenly reads as little change as one at rest; the motion tells.
    """
    from scipy.ndimage import uniform_filter1d

    from hapticplayer.motion.stillness import find_still

    imu = inputs.imu
    still = np.interp(inputs.grid_s, imu.time_s, find_still(imu).mask(len(imu)))
    square = np.square(inputs.acceleration_mps2).sum(axis=1)
    mean = uniform_filter1d(square, round(LEAST_STILL_S * GRID_HZ))
    is_still = (still > 0.5) & (mean < PUSHED_MPS2**2)
    confidence = 0.95 if inputs.is_log_given else 0.8
    found = []
    for start_s, end_s in _spans(is_still, inputs.grid_s, 0.0):
        if end_s - start_s < LEAST_STILL_S - 0.5 / GRID_HZ:
            continue
        fade_s = min(FADE_S, 0.25 * (end_s - start_s))
        effect = effect_on("mute", (start_s, end_s), fade_s)
        found.append(Event("stillness", start_s, end_s, confidence, _STILL, effect))
    return found


def saturation(inputs: EventInputs) -> list[Event]:
    """Return where a sensor was at the end of its range, see `motion.saturation`."""
    from hapticplayer.motion.flaws import find_flaws

    if not inputs.is_log_given:
        return []
    flaws = find_flaws(inputs.imu)
    return [
        Event("saturation", *span_s, 0.9, text, _smoothed(span_s))
        for clipped, text in (
            (flaws.force_clipped, _FORCE_CLIPPED),
            (flaws.rate_clipped, _RATE_CLIPPED),
        )
        for span_s in _spans(clipped, inputs.imu.time_s, MERGE_S)
    ]


def artefacts(inputs: EventInputs) -> list[Event]:
    """Return gaps, samples that had to be filled in, and isolated spikes."""
    imu = inputs.imu
    return [
        Event("artefact", *span_s, confidence, text, over("mute", span_s, SHORT_FADE_S))
        for mask, confidence, text in (
            (inputs.unknown, 0.95, _MISSING),
            (inputs.spiky, 0.8, _SPIKE),
        )
        for span_s in _spans(mask, imu.time_s, ARTEFACT_MERGE_S)
    ]


def _smoothed(span_s: tuple[float, float]) -> Effect:
    return over("low-pass", span_s, SHORT_FADE_S, cutoff_hz=SMOOTH_BELOW_HZ)


def _spans(
    mask: Flags, time_s: Floats, merge_s: float
) -> Iterator[tuple[float, float]]:
    """Yield start and end of runs, those closer than `merge_s` as one."""
    from hapticplayer.motion.conditioning.timing import runs

    firsts, lasts = runs(mask)
    starts_s, ends_s = time_s[firsts], time_s[lasts - 1]
    is_apart = starts_s[1:] - ends_s[:-1] > merge_s
    begins = starts_s[np.append(True, is_apart)[: len(firsts)]]
    yield from zip(
        begins.tolist(),
        ends_s[np.append(is_apart, True)[: len(firsts)]].tolist(),
        strict=True,
    )
