"""The one entry to all methods of synchronisation."""

import dataclasses
import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.errors import InputError, UsageError
from hapticplayer.media import AudioDecoder
from hapticplayer.model import ClockMap, ImuLog

METHODS = ("pats", "variance", "embedded", "offset")
SOUND_RATE_HZ = 16_000
LEAST_IMU_RATE_HZ = 20.0
MAX_SOUND_S = 4 * 3600.0

_LEAST_SOUND_RATE_HZ = 4000.0
_AGREES_S = 0.0167


@dataclass(frozen=True, slots=True, eq=False)
class Sound:
    """The sound of a clip, mono, from media time 0.

    Attributes:
        samples: (n,) float32.
        rate_hz: of the samples.
    """

    samples: NDArray[np.float32]
    rate_hz: int = SOUND_RATE_HZ


def read_sound(clip: str | os.PathLike[str]) -> Sound:
    """Return the sound of a clip; gaps in it are silent.

    Raises:
        MediaError: when it cannot be read or holds no sound.
    """
    decoder = AudioDecoder(clip, rate_hz=SOUND_RATE_HZ, channels=1)
    parts: list[NDArray[np.float32]] = []
    count, limit = 0, round(MAX_SOUND_S * SOUND_RATE_HZ)
    try:
        while (block := decoder.next_block()) is not None and count < limit:
            begin = round(block.media_s * SOUND_RATE_HZ)
            samples = block.samples[max(0, count - begin) :, 0]
            gap = min(max(0, begin - count), limit - count)
            parts += [np.zeros(gap, np.float32), samples]
            count += gap + len(samples)
    finally:
        decoder.close()
    return Sound(np.concatenate([*parts, np.zeros(0, np.float32)])[:limit])


def synchronize(
    imu: ImuLog,
    audio: NDArray[np.floating] | None = None,
    audio_rate_hz: float = SOUND_RATE_HZ,
    *,
    method: str = "pats",
    known: ClockMap | None = None,
    sound_late_s: float = 0.0,
) -> Synchronisation:
    """Return how the clock of a log lies to a clip, and why that may be believed.

    Args:
        imu: the log, on its own clock.
        audio: (n,) or (n, channels) sound from media time 0; of "pats", "variance".
        audio_rate_hz: of the sound.
        method: "pats" (rare events of both streams, three of them in a rhythm; drift
            where a long clip has pats at both ends), "variance" (the paper's
            threshold, for comparison), "embedded" (the camera's own clock) or
            "offset" (given).
        known: what "offset" and "embedded" rest on: `ClockMap(offset)`, or the
            recording's own; without one, "embedded" takes both clocks as one.
        sound_late_s: how much later than its picture the camera's sound comes; the
            pats tell the time of the sound, the result is that of the picture.

    Raises:
        UsageError: for a method that does not exist or lacks its argument.
        InputError: when there is nothing to compare: no sound, silence, a still log.
    """
    if method == "offset":
        if known is None:
            raise UsageError("the method offset needs one; give --offset S")
        return Synchronisation(known, "offset")
    if method == "embedded":
        return Synchronisation(known or ClockMap(), "embedded")
    if method not in METHODS:
        raise UsageError(f"there is no method {method!r}; choose one of {METHODS}")
    mono = _checked_sound(audio, audio_rate_hz)
    if imu.rate_hz < LEAST_IMU_RATE_HZ:
        raise InputError(
            f"has only {imu.rate_hz:.1f} samples per second, in which pats do not show",
            where=imu.source,
            remedy="record at 100 Hz or more, or give --offset S",
        )
    found = _by_pats(imu, mono, audio_rate_hz)
    if method == "variance":
        found = _by_variance(imu, mono, audio_rate_hz, found)
    clock = dataclasses.replace(
        found.clock_map, offset_s=found.clock_map.offset_s - sound_late_s
    )
    return dataclasses.replace(found, clock_map=clock, sound_late_s=sound_late_s)


def _checked_sound(
    audio: NDArray[np.floating] | None, rate_hz: float
) -> NDArray[np.floating]:
    if audio is None or not np.size(audio):
        raise InputError(
            "there is no sound in which pats could be heard",
            remedy="record with sound, or give --offset S",
        )
    mono = np.asarray(audio)
    mono = mono if mono.ndim == 1 else mono.mean(axis=1)
    if not rate_hz >= _LEAST_SOUND_RATE_HZ:
        raise InputError(f"a sound of {rate_hz} Hz is too coarse; give 8000 or more")
    if not np.isfinite(mono).all():
        raise InputError("the sound holds values that are not finite")
    if float(np.ptp(mono)) == 0.0:
        raise InputError(
            "the sound is silent", remedy="record with sound, or give --offset S"
        )
    return mono


def _by_pats(
    imu: ImuLog, mono: NDArray[np.floating], rate_hz: float
) -> Synchronisation:
    # these bring scipy along, which a given offset does not need
    from hapticplayer.capture.sync.events import sound_events, sound_onsets
    from hapticplayer.capture.sync.pats import synchronize_pats

    found = synchronize_pats(imu, sound_events(sound_onsets(mono, rate_hz)))
    return found or Synchronisation(ClockMap(confidence=0.0), "pats")


def _by_variance(
    imu: ImuLog,
    mono: NDArray[np.floating],
    rate_hz: float,
    by_pats: Synchronisation,
) -> Synchronisation:
    """A threshold cannot tell how sure it is; agreement with the pats does."""
    from hapticplayer.capture.sync.variance import variance_shift

    shift_s = variance_shift(imu, mono, rate_hz)
    if shift_s is None:
        return Synchronisation(ClockMap(confidence=0.0), "variance")
    clock = by_pats.clock_map
    middle_s = float(imu.time_s[len(imu) // 2])
    expected_s = clock.offset_s + (clock.rate - 1.0) * middle_s
    agrees = abs(shift_s - expected_s) <= _AGREES_S
    confidence = clock.confidence if agrees else 0.0
    return Synchronisation(
        ClockMap(shift_s, 1.0, abs(shift_s - expected_s), confidence), "variance"
    )
