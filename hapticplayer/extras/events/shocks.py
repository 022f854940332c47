"""Impacts: shocks that stand out of what surrounds them, felt and perhaps heard.

A shock: the size of the motion above 4 Hz, as RMS over 40 ms. A landing: how much higher
the upward acceleration is over the next 0.12 s than over the last 0.2 s, where those were
a fall. Either is divided by its background, the larger of the medians of RMS over 0.25 s
in the 4 s before and after: a single shock does not move them, and regular ones, such as
footfalls, are their own background.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.extras.events.inputs import (
    GRID_HZ,
    LOW_HZ,
    EventInputs,
    Flags,
    LowSound,
    effect_on,
)
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.events import Event

HIGH_PASS_HZ = 4.0
"""A brake that is applied within 0.35 s stays below it, a landing does not."""

SIZE_S, BLOCK_S, AROUND_BLOCKS = 0.04, 0.25, 16
LEAST_MPS2 = 0.7
"""0.3 N at the default gain, seven times the least force that a hand feels (0.04 N)."""

FLOOR_MPS2 = 0.18
"""Of the background: the noise of a sensor in three axes."""

STANDS_OUT, STANDS_OUT_IF_HEARD = 4.0, 3.2
"""On rides of seeds 100 to 102 five shocks exceeded 4.0 that were none, in 2.5 hours."""

ENDS = 0.5
"""Of the threshold, until where an impact reaches."""

MERGE_S, PART_SHARE = 0.1, 0.33

FALL_S, LANDING_S = 0.20, 0.12
FALL_MPS2 = 0.45 * STANDARD_GRAVITY_MPS2
LANDING_MPS2 = 0.8 * STANDARD_GRAVITY_MPS2
LANDING_STANDS_OUT = 5.0
"""On the same rides 14 to 24 for landings; 2.2 for steps of a runner."""

HEARD_BAND_HZ = (30.0, 400.0)
HEARD_RATIO = 2.5
"""Of the sound's level beside its median over 2 s: wind and tyres stay below twice."""

HEARD_BEFORE_S, HEARD_AFTER_S = 0.05, 0.15
MOST_HEARD_SHARE = 0.25
"""Of the 4 s around: where much is heard, as in speech and on stairs, it confirms nothing."""

KNOCK_HZ, KNOCK_DECAY_S, KNOCK_N_PER_MPS2, MOST_KNOCK_N = 60.0, 0.05, 0.05, 1.0
KNOCK_DECAYS = 6.0  # 0.25 % of it is left


class Shock(NamedTuple):
    """An impact as it is felt.

    Attributes:
        start_s, end_s: media time.
        peak_s: where it stands out most.
        size_mps2: RMS over 40 ms above 4 Hz.
        share: of what it needs to count, 1 or more.
        is_heard: whether the sound confirms it.
        is_landing: whether it is known by the fall before it, not by its speed.
    """

    start_s: float
    end_s: float
    peak_s: float
    size_mps2: float
    share: float
    is_heard: bool
    is_landing: bool


def impacts(inputs: EventInputs) -> list[Event]:
    return [_event(shock) for shock in find_shocks(inputs)]


def find_shocks(inputs: EventInputs) -> list[Shock]:
    """The impacts of a recording, by their start."""
    size = shock_size(inputs.acceleration_mps2)
    heard = _heard(inputs.sound, inputs.grid_s)
    needed = np.where(heard, STANDS_OUT_IF_HEARD, STANDS_OUT)
    is_shock = (size > LEAST_MPS2) & ~_is_released(inputs.upward_mps2)
    fast = np.where(is_shock, size / background(size) / needed, 0.0)
    share = np.maximum(fast, landings(inputs.upward_mps2))
    time_s = inputs.grid_s
    return [
        Shock(
            float(time_s[span.start]),
            float(time_s[span.stop - 1]),
            float(time_s[span.start + int(np.argmax(share[span]))]),
            float(size[span].max()),
            float(share[span].max()),
            bool(heard[span].any()),
            float(fast[span].max()) <= 1.0,
        )
        for first, last in _merged(share > ENDS)
        for span in _parts(share, first, last)
        if share[span].max() > 1.0
    ]


def _parts(share: Floats, first: int, last: int) -> Iterator[slice]:
    """Yield the parts of a run that reach a third of its highest value."""
    is_high = share[first:last] > PART_SHARE * share[first:last].max()
    for begin, end in _merged(is_high):
        yield slice(first + begin, first + end)


def shock_size(acceleration_mps2: Floats) -> Floats:
    """The RMS over 40 ms of the motion above 4 Hz, (N,)."""
    from scipy.ndimage import uniform_filter1d
    from scipy.signal import butter, sosfiltfilt

    sections = butter(2, HIGH_PASS_HZ, "high", fs=GRID_HZ, output="sos")
    padding = min(len(acceleration_mps2) - 1, round(GRID_HZ))
    fast = sosfiltfilt(sections, acceleration_mps2, axis=0, padlen=padding)
    square = np.einsum("ij,ij->i", fast, fast)
    mean = uniform_filter1d(square, round(SIZE_S * GRID_HZ), mode="constant")
    return np.asarray(np.sqrt(np.maximum(mean, 0.0)))


def landings(upward_mps2: Floats) -> Floats:
    """How much of its threshold a landing reaches, (N,); 0 without a fall."""
    before = _mean_of_last(upward_mps2, FALL_S)
    after = _mean_of_last(upward_mps2[::-1], LANDING_S)[::-1]
    swing = np.maximum(after - before, 0.0)
    is_landing = (before < -FALL_MPS2) & (after > LANDING_MPS2)
    share = swing / background(swing) / LANDING_STANDS_OUT
    return np.where(is_landing, share, 0.0)


def _is_released(upward_mps2: Floats) -> Flags:
    """(N,) where a fall begins: felt, but nothing has been hit."""
    count = round(FALL_S * GRID_HZ)
    is_fall = _mean_of_last(upward_mps2, FALL_S) < -FALL_MPS2
    return np.asarray(np.concatenate([is_fall, np.zeros(count, np.bool_)])[count:])


def _mean_of_last(values: Floats, span_s: float) -> Floats:
    count = round(span_s * GRID_HZ)
    total = np.cumsum(np.concatenate([np.zeros(count + 1), values]))
    return np.asarray((total[count:] - total[:-count])[1:] / count)


def background(size: Floats) -> Floats:
    """The level (N,) around a shock, at least the floor."""
    block = round(BLOCK_S * GRID_HZ)
    count = -(-len(size) // block)
    padded = np.pad(np.square(size), (0, count * block - len(size)), mode="reflect")
    rms = np.sqrt(padded.reshape(count, block).mean(axis=1))
    sides = np.pad(rms, AROUND_BLOCKS, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(sides, AROUND_BLOCKS)
    medians = np.median(windows, axis=1)
    usual = np.maximum(medians[:count], medians[AROUND_BLOCKS + 1 :])
    at = (np.arange(len(size)) + 0.5) / block - 0.5
    return np.asarray(np.maximum(np.interp(at, np.arange(count), usual), FLOOR_MPS2))


def _merged(mask: Flags) -> list[tuple[int, int]]:
    """First and one past last of runs, those closer than 0.1 s as one."""
    from hapticplayer.motion.conditioning.timing import runs

    merged: list[tuple[int, int]] = []
    for first, last in zip(*(edges.tolist() for edges in runs(mask)), strict=True):
        if merged and first - merged[-1][1] < MERGE_S * GRID_HZ:
            merged[-1] = (merged[-1][0], last)
        else:
            merged.append((first, last))
    return merged


def _heard(sound: LowSound | None, grid_s: Floats) -> Flags:
    """(N,) whether a blow is heard about each time."""
    if sound is None or not len(sound.samples):
        return np.zeros(len(grid_s), np.bool_)
    from scipy.ndimage import maximum_filter1d, median_filter, uniform_filter1d

    band = sound.band(*HEARD_BAND_HZ)
    level = np.sqrt(uniform_filter1d(np.square(band), round(0.02 * LOW_HZ)))
    coarse = level[:: LOW_HZ // 50]
    usual = median_filter(coarse, 101, mode="nearest")
    usual = np.maximum(usual, 0.2 * np.median(coarse) + 1e-5)
    ratio = level / np.interp(np.arange(len(level)), np.arange(len(coarse)) * 20, usual)
    reach = round((HEARD_BEFORE_S + HEARD_AFTER_S) * LOW_HZ)
    shift = round((HEARD_AFTER_S - HEARD_BEFORE_S) * LOW_HZ / 2)
    loudest = maximum_filter1d(ratio, reach, origin=-min(shift, reach // 2))
    at = np.arange(len(level)) / LOW_HZ
    heard = np.interp(grid_s, at, loudest, 0.0, 0.0) > HEARD_RATIO
    share = uniform_filter1d(heard.astype(float), round(4.0 * GRID_HZ))
    return np.asarray(heard & (share < MOST_HEARD_SHARE))


def _event(shock: Shock) -> Event:
    confidence, peak_mps2 = 1.0 - 0.5 / shock.share, shock.size_mps2
    text = Message("Impact of {peak_mps2:.1f} m/s²", peak_mps2=peak_mps2)
    if shock.is_heard:
        confidence = 0.5 + 0.5 * confidence
        text = Message("Impact of {peak_mps2:.1f} m/s², heard too", peak_mps2=peak_mps2)
    knock = {
        "amplitude": round(min(KNOCK_N_PER_MPS2 * peak_mps2, MOST_KNOCK_N), 2),
        "frequency_hz": KNOCK_HZ,
        "decay_s": KNOCK_DECAY_S,
    }
    end_s = shock.peak_s + KNOCK_DECAYS * KNOCK_DECAY_S
    effect = effect_on("knock", (shock.peak_s, end_s), **knock)
    return Event("impact", shock.start_s, shock.end_s, confidence, text, effect)
