"""Synchronises a log with a clip by one of `methods.SYNC_METHODS`."""

import dataclasses
import math
import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer import extension
from hapticplayer.capture.frames import frame_function
from hapticplayer.capture.recording import OtherPlace
from hapticplayer.capture.sync.methods import AUTO, sync_method
from hapticplayer.capture.sync.result import (
    SOUND_RATE_HZ,
    ClipSound,
    Synchronisation,
    SyncInput,
)
from hapticplayer.errors import InputError, MediaError, Message, UsageError
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.model import ClockMap, ImuLog

MIN_IMU_RATE_HZ = 20.0
MAX_SOUND_S = 4 * 3600.0

NO_PATS = Message("no three taps are both heard and felt")
NO_FIT = Message(
    "the camera's rotation in the frames fits the log nowhere (is it the log of this "
    "clip, and the video not stabilised?)"
)

BY_PACKETS = Message("as its own times place it")

CONTRADICTED = 0.2  # the confidence of a clock that is
_MIN_SOUND_RATE_HZ = 4000.0
_AGREES_S = 0.0167
_PATS_SIGMA_S = 0.004  # of pats at the least, beyond what their fit says
MOST_SIGMAS = 3.0
_BY_RECORDER = "hapticplayer.capture.sync.by_recorder:corrected"  # seldom needed


def read_sound(clip: str | os.PathLike[str], late_s: float = 0.0) -> ClipSound:
    """Return the sound of a clip; gaps in it are silent.

    Args:
        clip: the video.
        late_s: how much later than its frame the camera's sound comes.

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
    samples = np.concatenate([*parts, np.zeros(0, np.float32)])[:limit]
    return ClipSound(samples, late_s=late_s)


def synchronize(
    imu: ImuLog,
    audio: NDArray[np.floating] | None = None,
    audio_rate_hz: float = SOUND_RATE_HZ,
    *,
    method: str = AUTO,
    known: ClockMap | None = None,
    sound_late_s: float = 0.0,
) -> Synchronisation:
    """Return the clock map of a log, with its evidence.

    Args:
        imu: the log, on its own clock.
        audio: (n,) or (n, channels) sound from media time 0.
        audio_rate_hz: of the sound.
        method: one of `methods.SYNC_METHODS`.
        known: the clock map that "offset" and "embedded" take.
        sound_late_s: how much later than its frame the camera's sound comes; pats
            give the time of the sound, the result is that of the frame.

    Raises:
        UsageError: for a method that does not exist or lacks its argument.
        InputError: without sound, for silence or a log at too low a rate.
    """

    def hear() -> ClipSound:
        samples = np.zeros(0) if audio is None else np.asarray(audio)
        mono = samples if samples.ndim == 1 else samples.mean(axis=1)
        return ClipSound(mono, audio_rate_hz, sound_late_s)

    given = known if method == "offset" else None
    return sync_method(method).function()(SyncInput(imu, hear, given, known))


def automatic(inputs: SyncInput) -> Synchronisation:
    """Use a given offset, else the recording's own clock, else pats and frames."""
    if inputs.given is not None:
        return by_given_offset(inputs)
    if inputs.own is not None:
        return by_own_clock(inputs)
    return _by_pats_and_frames(inputs)


def _by_pats_and_frames(inputs: SyncInput) -> Synchronisation:
    if inputs.look is None:
        return by_pats(inputs)
    pats, problem = tried(by_pats, inputs)
    frames, unseen = tried(sync_method("frames").function(), inputs)
    if pats is not None and frames is not None:
        return joined_findings(pats, frames)
    if frames is not None:
        assert problem is not None
        return dataclasses.replace(frames, unused=problem.what)
    assert unseen is not None
    if pats is not None:
        return dataclasses.replace(pats, unused=unseen.what)
    assert problem is not None
    raise _with_both_reasons(problem, unseen)


def tried(
    method: Callable[[SyncInput], Synchronisation], inputs: SyncInput
) -> tuple[Synchronisation | None, InputError | None]:
    """The result of a method, or why it cannot be used."""
    try:
        return method(inputs), None
    except InputError as problem:
        return None, problem


def _with_both_reasons(unheard: InputError, unseen: InputError) -> InputError:
    """Return why there are no pats and what is wrong with the frames, with remedies."""
    what = Message("{one}; {other}", one=unheard.what, other=unseen.what)
    remedy = unheard.remedy
    if isinstance(unseen, MediaError) and unseen.remedy:
        remedy = Message("{one}; {other}", one=unseen.remedy, other=remedy)
    return InputError(what, where=unheard.where, remedy=remedy)


def joined_findings(pats: Synchronisation, frames: Synchronisation) -> Synchronisation:
    """Return one result: where both agree the frames', if they are certain."""
    if frames.frames is None:
        return dataclasses.replace(pats, unused=NO_FIT)
    if not pats.pats:
        return dataclasses.replace(frames, unused=NO_PATS)
    likelier, other = frames, pats
    if pats.clock_map.confidence > frames.clock_map.confidence:
        likelier, other = pats, frames
    if agree(pats, frames):
        doubt = (1.0 - pats.clock_map.confidence) * (1.0 - frames.clock_map.confidence)
        if frames.is_confident and not (frames.is_coarse and pats.is_confident):
            likelier, other = frames, pats
        best = likelier
        clock = dataclasses.replace(best.clock_map, confidence=1.0 - doubt)
        found = dataclasses.replace(best, clock_map=clock, pats=pats.pats)
        return _with_second(found, other, frames)
    if pats.is_confident and frames.is_confident:
        clock = dataclasses.replace(likelier.clock_map, confidence=0.0)
        likelier = dataclasses.replace(likelier, clock_map=clock)
    return _with_second(likelier, other, frames)


def _with_second(
    found: Synchronisation, other: Synchronisation, frames: Synchronisation
) -> Synchronisation:
    """Return a result with that of another method, and the mounting of the frames."""
    return dataclasses.replace(found, second=other, mounting=frames.mounting)


def agree(pats: Synchronisation, frames: Synchronisation) -> bool:
    """Whether two results differ by no more than their sigmas allow."""
    assert frames.frames is not None
    clock = frames.clock_map
    log_s = (frames.frames.middle_s - clock.offset_s) / clock.rate
    apart_s = pats.media_s(log_s) - frames.media_s(log_s)
    since_s = log_s - float(np.mean([pat.felt_s for pat in pats.pats]))
    sigma_s = math.hypot(
        max(pats.offset_sigma_s, _PATS_SIGMA_S),
        1e-6 * pats.drift_sigma_ppm * since_s,
        frames.offset_sigma_s,
    )
    return abs(apart_s) <= MOST_SIGMAS * sigma_s


def by_given_offset(inputs: SyncInput) -> Synchronisation:
    """Use the offset given by a person."""
    if inputs.given is None:
        raise UsageError("no offset is given, which this method needs (--offset S)")
    return Synchronisation(inputs.given, "offset")


def by_own_clock(inputs: SyncInput) -> Synchronisation:
    """Use the clock of the recording, which is the clip's.

    Where its lag is not known, the frames measure it, if they can.
    """
    if inputs.own is None:
        raise UsageError(
            "{name} does not know the clip's clock; use the taps (--sync pats), or enter "
            "the offset (--offset S)",
            name=Path(inputs.imu.source).name,
        )
    if inputs.contradiction:
        return _decided(inputs, inputs.own)
    lag = inputs.lag
    if lag is not None and lag.is_of_machine:
        found: Synchronisation = extension.load(_BY_RECORDER)(inputs)
        return found
    if lag is not None and not lag.is_measured and inputs.look is not None:
        measured = frame_function("lag")(inputs.imu, inputs.own, inputs.look)
        assert isinstance(measured, Synchronisation)
        return measured
    return Synchronisation(
        inputs.own,
        "embedded",
        has_drift=lag is not None and lag.is_measured,
        offset_sigma_s=0.0 if lag is None else lag.sigma_s,
        lag=lag,
    )


def _decided(inputs: SyncInput, own: ClockMap) -> Synchronisation:
    """A clock that is contradicted: frames and pats decide, else a person."""
    found, problem = tried(_by_pats_and_frames, inputs)
    if found is not None and found.is_confident:
        return dataclasses.replace(found, contradiction=inputs.contradiction)
    return Synchronisation(
        dataclasses.replace(own, confidence=CONTRADICTED),
        "embedded",
        second=found,
        unused=problem.what if problem else "",
        lag=inputs.lag,
        contradiction=inputs.contradiction,
        others=(OtherPlace(BY_PACKETS, own.offset_s), *inputs.others),
    )


def by_pats(inputs: SyncInput) -> Synchronisation:
    """Find three pats in the sound and in the log; two groups also give the drift."""
    # these bring scipy along, which a given offset does not need
    from hapticplayer.capture.sync.events import sound_events, sound_onsets
    from hapticplayer.capture.sync.pats import synchronize_pats

    sound = _checked(inputs)
    events = sound_events(sound_onsets(sound.samples, sound.rate_hz))
    near = (-math.inf, math.inf)
    if inputs.near_s is not None and inputs.own is not None:
        near = (
            inputs.own.offset_s - inputs.near_s,
            inputs.own.offset_s + inputs.near_s,
        )
    found = synchronize_pats(inputs.imu, events, near)
    if found is None:
        found = Synchronisation(ClockMap(confidence=0.0), "pats")
    return _without_skew(found, sound)


def by_variance(inputs: SyncInput) -> Synchronisation:
    """Compare when two variances rise: the paper's method, for comparison.

    It has no confidence of its own; agreement with the pats gives one.
    """
    from hapticplayer.capture.sync.variance import variance_shift

    sound, imu = _checked(inputs), inputs.imu
    shift_s = variance_shift(imu, sound.samples, sound.rate_hz)
    if shift_s is None:
        return _without_skew(
            Synchronisation(ClockMap(confidence=0.0), "variance"), sound
        )
    clock = by_pats(inputs._replace(hear=lambda: sound)).clock_map
    middle_s = float(imu.time_s[len(imu) // 2])
    expected_s = clock.offset_s + sound.late_s + (clock.rate - 1.0) * middle_s
    apart_s = abs(shift_s - expected_s)
    confidence = clock.confidence if apart_s <= _AGREES_S else 0.0
    found = Synchronisation(ClockMap(shift_s, 1.0, apart_s, confidence), "variance")
    return _without_skew(found, sound)


def _without_skew(found: Synchronisation, sound: ClipSound) -> Synchronisation:
    """Return the clock map to the frames, from that to the sound."""
    clock = found.clock_map
    clock = dataclasses.replace(clock, offset_s=clock.offset_s - sound.late_s)
    return dataclasses.replace(found, clock_map=clock, sound_late_s=sound.late_s)


def _checked(inputs: SyncInput) -> ClipSound:
    """Return the sound, if sound and log are usable."""
    sound = inputs.hear()
    if not len(sound.samples):
        raise InputError(
            "the clip has no sound, which taps need",
            remedy="record with sound, or enter the offset (--offset S)",
        )
    if not sound.rate_hz >= _MIN_SOUND_RATE_HZ:
        raise InputError(
            "a sound of {rate_hz} Hz is too coarse; give 8000 or more",
            rate_hz=sound.rate_hz,
        )
    if not np.isfinite(sound.samples).all():
        raise InputError("the sound holds values that are not finite")
    if float(np.ptp(sound.samples)) == 0.0:
        raise InputError(
            "the sound is silent",
            remedy="record with sound, or enter the offset (--offset S)",
        )
    if inputs.imu.rate_hz < MIN_IMU_RATE_HZ:
        raise InputError(
            "has only {rate_hz:.1f} samples per second, too few for taps",
            where=inputs.imu.source,
            remedy="record at 100 Hz or more, or enter the offset (--offset S)",
            rate_hz=inputs.imu.rate_hz,
        )
    return sound
