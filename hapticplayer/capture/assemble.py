"""From a raw log to a recording: units, axes, common times, checks, repairs.

Nothing is guessed: what a format declares is checked against gravity and plausible
rates, and a person is asked if it fails.
"""

import dataclasses
import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture import log_checks
from hapticplayer.capture.agreement import (
    ask_about_agreement,
    ask_if_swapped,
    own_axes,
    sensors_as_answered,
)
from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    FIELD_UNITS,
    RATE_UNITS,
    TIME_UNITS,
    LogChoices,
    LogQuestion,
    factor,
    is_factor,
    kept_as,
)
from hapticplayer.capture.formats import Confidence, Reader, WhyNot, without_reason
from hapticplayer.capture.mounting import axes_matrix, mounted
from hapticplayer.capture.recording import Placing, Recording
from hapticplayer.capture.source import LogSource
from hapticplayer.capture.streams import (
    AlignedSamples,
    RawLog,
    SensorStream,
    on_common_times,
)
from hapticplayer.capture.stuck import Repeats, working
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import COARSE_REST_MPS2
from hapticplayer.model.timing import TIME

if TYPE_CHECKING:
    from hapticplayer.motion.repair.timestamps import Repair

Reals = NDArray[np.floating[Any]]

_FRAMES_SLACK_S = 0.2  # a few frames, which a list may have and a video not
_TRIED_ROWS = 60_000
_WOULD_FIT = "{what}, but the numbers would fit another unit"
_ONE_G = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])


def log_reader(
    recognises: Callable[[LogSource], Confidence],
    read_raw: Callable[[LogSource, LogChoices], RawLog],
    why_not: WhyNot = without_reason,
) -> Reader:
    """Return the reader of a format whose logs are assembled here."""

    def read(source: LogSource, choices: LogChoices) -> Recording:
        # no other reference, so that `assemble` can free what it has used
        return assemble(read_raw(source, choices), choices, str(source.path))

    return Reader(recognises, read, why_not)


def only_one(found: list[str], source: LogSource) -> str:
    """Return the one member that was found.

    Raises:
        LogQuestion: when there are several.
    """
    if len(found) > 1:
        raise LogQuestion(
            Message(
                "holds {count} logs ({known})",
                count=len(found),
                known=", ".join(found)[:120],
            ),
            (Message("give the file or folder of one of them instead"),),
            str(source.path),
        )
    return found[0]


def assemble(raw: RawLog, choices: LogChoices, where: str) -> Recording:
    """Return the recording that a raw log holds, in SI and frame A."""
    raw = _decided(raw, choices)
    if raw.rate is not None and not raw.is_gravity_free:
        ask_if_swapped(raw, choices, where)
    try:
        samples, found = _common(raw, where)
    except InputError as error:
        _ask_about_time(error, raw.accel.time_s, choices, where)
        raise _in_its_names(error, raw) from error
    # ten hours take half a gigabyte: free early
    raw = _without_samples(raw)
    stream_notes = samples.notes
    part = _beginning(samples)
    in_si = _in_si(samples, raw)
    del samples
    try:
        imu, repairs = _cleaned(in_si, raw, where)
    except InputError as error:
        ask_about_units(error, part, raw, choices, where)
        raise _in_its_names(error, raw) from error
    del in_si
    # streams with their own times have their own notes on gaps
    texts = [one.text for one in repairs if not (stream_notes and one.kind == "lost")]
    figures = log_checks.figures(imu, raw)
    if raw.is_gravity_free:
        notes: tuple[str, ...] = (
            Message("gravity was already removed by the recorder"),
        )
    else:
        log_checks.check_norm(figures, raw, choices, where)
        log_checks.check_rate(imu, raw, choices, where)
        notes = ask_about_agreement(imu, choices, where, raw.axes, raw.rate_unit)
        notes += log_checks.check_upright(imu, raw, choices, where)
    first_s, last_s = raw.frames_s or (0.0, 0.0)
    known = raw.frames_s is not None
    return Recording(
        imu=imu,
        clock_map=ClockMap(offset_s=-first_s, confidence=1.0 if known else 0.0),
        placing=Placing((0.0, last_s - first_s), _FRAMES_SLACK_S) if known else None,
        camera=raw.name,
        notes=(
            log_checks.how_read(raw, figures),
            *notes,
            *raw.notes,
            *found.notes,
            *stream_notes,
            *texts,
        ),
        provenance={
            "reader": raw.name,
            "force_unit": raw.accel_unit,
            "rate_unit": raw.rate_unit,
            "axes": raw.axes,
            **found.provenance,
            **figures,
        },
        is_gravity_free=raw.is_gravity_free,
    )


def _decided(raw: RawLog, choices: LogChoices) -> RawLog:
    """Return the log with the answers of a person in place of what it declares."""
    raw = sensors_as_answered(raw, choices)
    accel, units = raw.accel, {"accel_unit": choices.take("accel_unit")}
    if raw.rate is not None and not raw.is_gravity_free:
        both = own_axes((accel.values, raw.rate.values), choices)
        accel = SensorStream(accel.time_s, both[0])
        raw = dataclasses.replace(raw, rate=SensorStream(raw.rate.time_s, both[1]))
    if choices.take("accel_sign") == "-":
        accel = SensorStream(accel.time_s, -accel.values)
    if raw.rate is not None and not raw.is_gravity_free:
        units["rate_unit"] = choices.take("rate_unit")
    if raw.field is not None:
        units["field_unit"] = choices.take("field_unit")
    given = {**units, "axes": choices.take("axes")}
    answers: dict[str, Any] = {name: text for name, text in given.items() if text}
    return dataclasses.replace(raw, accel=accel, **answers)


def as_answered(recording: Recording, choices: LogChoices) -> Recording:
    """Return a recording whose format states axes and units, with those of a person."""
    imu = recording.imu
    force, rate = own_axes((imu.specific_force_mps2, imu.angular_rate_radps), choices)
    if choices.take("accel_sign") == "-":
        force = -force
    unit = choices.rate_unit or "rad/s"
    is_of_camera = recording.placing is not None
    if is_of_camera and choices.take("rate_unit"):
        rate = rate * factor(unit, RATE_UNITS, "rate-unit")
    imu = dataclasses.replace(imu, specific_force_mps2=force, angular_rate_radps=rate)
    notes = ask_about_agreement(
        imu, choices, imu.source, rate_unit=unit, is_of_camera=is_of_camera
    )
    return dataclasses.replace(
        recording,
        imu=mounted(imu, choices.take("axes")),
        notes=(*recording.notes, *notes),
    )


def _common(raw: RawLog, where: str) -> tuple[AlignedSamples, Repeats]:
    if raw.rate is not None and not raw.is_gravity_free:
        streams = working(raw.accel, raw.rate, raw.field, where)
        common = on_common_times(streams.accel, streams.rate, streams.field, where)
        return common, streams.repeats
    if not raw.is_gravity_free:
        raise InputError(
            "holds no angular rate; gravity cannot be removed without it",
            where=where,
            remedy="record the gyroscope too",
        )
    # gravity-free motion needs no rotation
    stationary = np.zeros_like(raw.accel.values)
    samples = AlignedSamples(raw.accel.time_s, raw.accel.values, stationary, None, ())
    return samples, Repeats()


def _in_its_names(error: InputError, raw: RawLog) -> InputError:
    """Return an error with the names that the times have in the file."""
    names = dict(zip(("time", "scale"), raw.time_names, strict=True))

    def named(text: str) -> str:
        if not isinstance(text, Message):
            return text
        own = {key: name for key, name in names.items() if text.values.get(key) == TIME}
        return Message(text.template, **{**text.values, **own})

    return InputError(named(error.what), where=error.where, remedy=named(error.remedy))


def _beginning(samples: AlignedSamples) -> AlignedSamples:
    """Return a copy of the first rows, so that the others can be freed."""
    time_s, accel, rate = (part[:_TRIED_ROWS].copy() for part in samples[:3])
    return AlignedSamples(time_s, accel, rate, None, ())


def _without_samples(raw: RawLog) -> RawLog:
    """Return the log with empty streams."""
    empty = SensorStream(np.zeros(0), np.zeros((0, 3)))
    return dataclasses.replace(
        raw,
        accel=empty,
        rate=None if raw.rate is None else empty,
        field=None if raw.field is None else empty,
    )


def _in_si(samples: AlignedSamples, raw: RawLog) -> AlignedSamples:
    """Return the samples in SI and frame A; float32, because no sensor has 24 bits."""
    rotated = axes_matrix(raw.axes).T
    accel_factor = factor(raw.accel_unit, ACCEL_UNITS, "accel-unit")
    rate_factor = factor(raw.rate_unit, RATE_UNITS, "rate-unit")
    field_factor = factor(raw.field_unit, FIELD_UNITS, "field-unit")
    # overflow is damage, detected later
    with np.errstate(all="ignore"):
        accel = _finite(samples.accel) @ (rotated * accel_factor)
        if raw.is_gravity_free:  # for the checks, which expect gravity
            accel += _ONE_G
        rate = _finite(samples.rate) @ (rotated * rate_factor)
        field = samples.field
        if field is not None:
            field = (_finite(field) @ (rotated * field_factor)).astype(np.float32)
        return AlignedSamples(
            samples.time_s,
            accel.astype(np.float32),
            rate.astype(np.float32),
            field,
            samples.notes,
        )


def _finite(values: Floats) -> Floats:
    is_finite = np.isfinite(values)
    return values if is_finite.all() else np.where(is_finite, values, np.nan)


def _cleaned(
    samples: AlignedSamples, raw: RawLog, where: str
) -> tuple[ImuLog, tuple["Repair", ...]]:
    from hapticplayer.motion.repair import repair_samples  # brings scipy along

    imu, repairs = repair_samples(*samples[:4], source=where)
    if not raw.is_gravity_free:
        return imu, repairs
    free = np.asarray(imu.specific_force_mps2 - _ONE_G)
    repairs = tuple(one for one in repairs if one.kind != "no rotation")
    return dataclasses.replace(imu, specific_force_mps2=free), repairs


def ask_about_units(
    error: InputError,
    part: AlignedSamples,
    raw: RawLog,
    choices: LogChoices,
    where: str,
) -> None:
    """Ask about the units if the log was refused and a part of it would fit others."""
    _ask_about_time(error, part.time_s, choices, where)
    rate_units = [*dict.fromkeys([raw.rate_unit, "rad/s", "deg/s"])]
    if is_factor(choices.rate_unit, RATE_UNITS):
        rate_units = [raw.rate_unit]
    answers: list[str] = _other_units(part, raw, where, rate_units)
    if not answers:
        return
    what = Message(_WOULD_FIT, what=error.what)
    if "rate-unit" in answers[0]:
        as_is = log_checks.AS_IT_IS
        answers.append(kept_as("rate-unit", raw.rate_unit, RATE_UNITS, as_is))
    raise LogQuestion(what, answers, where) from error


def _ask_about_time(
    error: InputError, time_s: Floats, choices: LogChoices, where: str
) -> None:
    """Ask about the unit of times that were refused and would fit another one."""
    from hapticplayer.motion.repair.timestamps import repair_times  # brings scipy

    if "time_unit" not in choices.taken or not choices.time_unit:
        return
    time_s = time_s[:_TRIED_ROWS] / factor(choices.time_unit, TIME_UNITS, "time-unit")
    for unit, step_s in TIME_UNITS.items():
        try:
            repair_times(step_s * time_s, [], where)
        except InputError:
            continue
        if unit != choices.time_unit:
            what = Message(_WOULD_FIT, what=error.what)
            raise LogQuestion(what, [f"time-unit={unit}"], where) from error
        return


def _other_units(
    part: AlignedSamples,
    raw: RawLog,
    where: str,
    rate_units: list[str],
) -> list[str]:
    """Return units that a part of the log would fit, as choices, the nearest first.

    Two that are nearly alike, such as cm/s2 and mg, fit both.
    """
    for rate_unit in rate_units:
        fits = []
        for accel_unit in {raw.accel_unit: 1.0, **ACCEL_UNITS}:
            other = dataclasses.replace(raw, accel_unit=accel_unit, rate_unit=rate_unit)
            words = _unit_words(other, raw)
            if not words:
                continue
            off = _off_gravity(part, other, where)
            if off is not None:
                fits.append((off, words))
        if fits:
            return [words for _, words in sorted(fits, key=lambda fit: fit[0])]
    return []


def _unit_words(other: RawLog, raw: RawLog) -> str:
    words = []
    if other.accel_unit != raw.accel_unit:
        words.append(f"accel-unit={other.accel_unit}")
    if other.rate_unit != raw.rate_unit:
        words.append(f"rate-unit={other.rate_unit}")
    return joined(Message(" and "), words)


def _off_gravity(part: AlignedSamples, raw: RawLog, where: str) -> float | None:
    """How far a part of a log in these units is off gravity; None if it cannot be used."""
    from hapticplayer.motion.repair.rotation import doubt_about
    from hapticplayer.motion.repair.units import calm_norm

    try:
        imu, _ = _cleaned(_in_si(part, raw), raw, where)
    except InputError:
        return None
    if raw.is_gravity_free:
        return 0.0
    low, high = COARSE_REST_MPS2
    at_rest = log_checks.norm_at_rest(imu)
    if at_rest is None:
        norm = calm_norm(imu.time_s, imu.specific_force_mps2)
    elif low <= at_rest <= high:
        norm = at_rest
    else:
        return None
    doubt = doubt_about(imu)
    if doubt is not None and doubt.scale is not None:
        return None
    return abs(math.log(norm / STANDARD_GRAVITY_MPS2))
