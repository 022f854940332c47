"""Events of a recording: found and offered, never applied.

Precision and recall on simulated rides: `python -m benchmarks.haptics events`.
"""

from collections.abc import Callable, Collection, Iterator

import numpy as np

from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.events.inputs import (
    GRID_HZ,
    EventInputs,
    Flags,
    LowSound,
    effect_on,
    low_sound,
    over,
)
from hapticplayer.extras.events.shocks import impacts
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.effects import Effect
from hapticplayer.sequence.events import Event

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


def hard_braking(inputs: EventInputs) -> list[Event]:
    """Where a recording loses speed at 0.3 g or more."""
    slow = _below(inputs.level[:, 0])
    found = []
    for span in _pushed_spans(-slow, BRAKING_MPS2):
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
    """Where a recording turns with 0.15 g or more sideways."""
    left, yaw = _below(inputs.level[:, 1]), _below(inputs.level[:, 2])
    found = []
    for side in (1.0, -1.0):
        for span in _pushed_spans(side * left, TURN_MPS2):
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
    """Whether the heading follows the turn as that of what travels does."""
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
    """Values (N,) without what is faster than 1 Hz."""
    from scipy.signal import butter, sosfiltfilt

    sections = butter(2, BELOW_HZ, fs=GRID_HZ, output="sos")
    padding = min(len(values) - 1, round(GRID_HZ))
    return np.asarray(sosfiltfilt(sections, values, padlen=padding))


def _pushed_spans(level: Floats, limit_mps2: float) -> Iterator[slice]:
    """Yield where a level stays above half of a limit, and reaches it long enough."""
    from hapticplayer.motion.conditioning.timing import runs

    for first, last in zip(*runs(level > ENDS * limit_mps2), strict=True):
        span = slice(int(first), int(last))
        above_s = np.count_nonzero(level[span] > limit_mps2) / GRID_HZ
        change_mps = float(level[span].sum()) / GRID_HZ
        if above_s >= LEAST_S and change_mps >= LEAST_CHANGE_MPS:
            yield span


def _described(level: Floats) -> tuple[float, float]:
    """The largest level, and the change of velocity."""
    return float(level.max()), float(level.sum()) / GRID_HZ


def _confidence(ratio: float) -> float:
    """0.5 at the threshold, 0.75 at twice of it."""
    return 1.0 - 0.5 / max(ratio, 1.0)


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
    """Spans of a second or more without motion, see `motion.stillness`.

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
    """Where a sensor was at the end of its range, see `motion.saturation`."""
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
    """gaps, samples that had to be filled in, and isolated spikes."""
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


DETECTORS: dict[str, Callable[[EventInputs], list[Event]]] = {
    "impact": impacts,
    "braking": hard_braking,
    "turn": turns,
    "stillness": stillness,
    "saturation": saturation,
    "artefact": artefacts,
}
"""Each gives its events in the order of time; rows for people are in `extension`."""


def find_events(
    motion: MotionTrack,
    imu: ImuLog | None = None,
    sound: LowSound | None = None,
    *,
    kinds: Collection[str] | None = None,
) -> tuple[Event, ...]:
    """The events of a recording, by their start.

    Args:
        motion: in media time.
        imu: its log in media time; without one no saturation is found.
        sound: of the clip; confirms impacts.
        kinds: names of detectors; all if None.
    """
    if len(motion) < 2 or (imu is not None and len(imu) < 2):
        raise InputError("there is no motion to find events in")
    inputs = EventInputs(motion, imu, sound)
    found = [
        event
        for kind, find in DETECTORS.items()
        if kinds is None or kind in kinds
        for event in find(inputs)
    ]
    return tuple(sorted(found, key=lambda one: (one.start_s, one.end_s)))


def events_heard(
    motion: MotionTrack,
    imu: ImuLog | None,
    sound: ClipSound | None,
    kinds: Collection[str],
) -> tuple[Event, ...]:
    """As `find_events`, with the whole sound of a clip."""
    low = low_sound(sound.samples, sound.rate_hz) if sound else None
    return find_events(motion, imu, low, kinds=kinds)
