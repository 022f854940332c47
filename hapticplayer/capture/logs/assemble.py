"""From a raw log to an ImuLog: units, axes, common times, checks, repairs.

Nothing is guessed: what a format declares is held against gravity and against what
hands can do, and where that fails a person is asked.
"""

import dataclasses
from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hapticplayer.capture.cleaning import clean
from hapticplayer.capture.logs import units
from hapticplayer.capture.logs.axes import axes_matrix, check_upright
from hapticplayer.capture.logs.choices import LogChoices, question
from hapticplayer.capture.logs.common_times import Samples, on_common_times
from hapticplayer.capture.logs.raw import RawLog, Stream
from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.model.arrays import Floats

REST_NORM_MPS2 = (8.5, 11.0)
"""What accelerometers show at rest; cheap ones are up to 10 % off."""

MAX_PLAUSIBLE_RADPS = 35.0
"""Sensors end at 2000 deg/s; no hand turns faster for long."""

_WINDOW_S = 0.5
_STILL_MPS2 = 0.25
_STILL_RADPS = 0.15
_LEAST_STILL_WINDOWS = 4
_FAST_SHARE = 0.001
_TRIED_ROWS = 60_000
_ONE_G = np.array([0.0, 0.0, STANDARD_GRAVITY_MPS2])


@dataclass(frozen=True, slots=True, eq=False)
class LogReading:
    """A log in SI and frame A.

    Attributes:
        imu: the samples; without gravity where `is_gravity_free`.
        clock_map: to media time; confidence 0 where the log does not know it.
        name: of the format.
        notes: how it was read, and what a person should know.
        provenance: the same in figures.
        is_gravity_free: the recorder had removed gravity.
    """

    imu: ImuLog
    clock_map: ClockMap
    name: str
    notes: tuple[str, ...]
    provenance: Dict[str, Any] = field(default_factory=dict)
    is_gravity_free: bool = False


def assemble(raw: RawLog, choices: LogChoices, where: str) -> LogReading:
    """Return the log that a raw one holds.

    Raises:
        InputError: when it cannot be used.
        UsageError: when units or axes are doubtful; says how to decide.
    """
    raw = _decided(raw, choices)
    samples = _common(raw, where)
    # ten hours fill half a gigabyte: nothing is kept longer than it is needed
    raw = _without_samples(raw)
    said = samples.notes
    part = _beginning(samples)
    in_si = _in_si(samples, raw)
    del samples
    try:
        imu, repairs = _cleaned(in_si, raw, where)
    except InputError as error:
        other = _other_units(part, raw, choices, where)
        if other is None:
            raise
        what = f"{error.what}, but the numbers would fit another unit"
        raise question(what, (other,), where) from error
    del in_si
    if said:  # the streams have said themselves where they have gaps
        repairs = tuple(note for note in repairs if "never recorded" not in note)
    figures = _figures(imu, raw)
    if raw.is_gravity_free:
        notes: tuple[str, ...] = ("gravity was already removed by the recorder",)
    else:
        _check_norm(figures, raw, choices, where)
        notes = check_upright(imu.specific_force_mps2, raw, choices, where)
    _check_rate(imu, raw, choices, where)
    known = raw.frame0_s is not None
    return LogReading(
        imu=imu,
        clock_map=ClockMap(
            offset_s=-(raw.frame0_s or 0.0), confidence=1.0 if known else 0.0
        ),
        name=raw.name,
        notes=(_how_read(raw, figures), *notes, *raw.notes, *said, *repairs),
        provenance={
            "reader": raw.name,
            "force_unit": raw.force_unit,
            "rate_unit": raw.rate_unit,
            "axes": raw.axes,
            **figures,
        },
        is_gravity_free=raw.is_gravity_free,
    )


def _decided(raw: RawLog, choices: LogChoices) -> RawLog:
    """Return the log with what a person decided in place of what it declares."""
    force = raw.force
    if choices.force_sign == "-":
        force = Stream(force.time_s, -force.values)
    return dataclasses.replace(
        raw,
        force=force,
        force_unit=choices.force_unit or raw.force_unit,
        rate_unit=choices.rate_unit or raw.rate_unit,
        field_unit=choices.field_unit or raw.field_unit,
        axes=choices.axes or raw.axes,
    )


def _common(raw: RawLog, where: str) -> Samples:
    if raw.rate is not None and not raw.is_gravity_free:
        return on_common_times(raw.force, raw.rate, raw.field, where)
    if not raw.is_gravity_free:
        raise InputError(
            "holds no angular rate, without which gravity cannot be told from motion",
            where=where,
            remedy="record the gyroscope too",
        )
    # where gravity is gone nothing needs to be turned
    still = np.zeros_like(raw.force.values)
    return Samples(raw.force.time_s, raw.force.values, still, None, ())


def _beginning(samples: Samples) -> Samples:
    """Return a copy of the first rows, which does not keep the others alive."""
    return Samples(
        samples.time_s[:_TRIED_ROWS].copy(),
        samples.force[:_TRIED_ROWS].copy(),
        samples.rate[:_TRIED_ROWS].copy(),
        None,
        (),
    )


def _without_samples(raw: RawLog) -> RawLog:
    """Return the log with empty streams."""
    empty = Stream(np.zeros(0), np.zeros((0, 3)))
    return dataclasses.replace(
        raw,
        force=empty,
        rate=None if raw.rate is None else empty,
        field=None if raw.field is None else empty,
    )


def _in_si(samples: Samples, raw: RawLog) -> Samples:
    """Return the samples in SI and frame A; float32, as no sensor has 24 bits."""
    turned = axes_matrix(raw.axes).T
    force_factor = units.factor(raw.force_unit, units.FORCE, "force-unit")
    rate_factor = units.factor(raw.rate_unit, units.RATE, "rate-unit")
    field_factor = units.factor(raw.field_unit, units.FIELD, "field-unit")
    # what overflows here is damage, and is found to be so
    with np.errstate(all="ignore"):
        force = _finite(samples.force) @ (turned * force_factor)
        if raw.is_gravity_free:  # for the checks, which look for gravity
            force += _ONE_G
        rate = _finite(samples.rate) @ (turned * rate_factor)
        field = samples.field
        if field is not None:
            field = (_finite(field) @ (turned * field_factor)).astype(np.float32)
        return Samples(
            samples.time_s,
            force.astype(np.float32),
            rate.astype(np.float32),
            field,
            samples.notes,
        )


def _cleaned(
    samples: Samples, raw: RawLog, where: str
) -> tuple[ImuLog, tuple[str, ...]]:
    time_s, force, rate, field, _ = samples
    imu, notes = clean(time_s, force, rate, field, source=where)
    if not raw.is_gravity_free:
        return imu, notes
    free = np.asarray(imu.specific_force_mps2 - _ONE_G)
    notes = tuple(note for note in notes if "angular rate is zero" not in note)
    return dataclasses.replace(imu, specific_force_mps2=free), notes


def _finite(values: Floats) -> Floats:
    is_finite = np.isfinite(values)
    return values if is_finite.all() else np.where(is_finite, values, np.nan)


def _other_units(
    part: Samples, raw: RawLog, choices: LogChoices, where: str
) -> str | None:
    """Return which other units a part of the log would fit, as a choice, or None."""
    force_units = [raw.force_unit] if choices.force_unit else ["m/s2", "g", "mg"]
    rate_units = [raw.rate_unit] if choices.rate_unit else ["rad/s", "deg/s"]
    for force_unit in force_units:
        for rate_unit in rate_units:
            if (force_unit, rate_unit) == (raw.force_unit, raw.rate_unit):
                continue
            other = dataclasses.replace(raw, force_unit=force_unit, rate_unit=rate_unit)
            try:
                _cleaned(_in_si(part, other), other, where)
            except InputError:
                continue
            words = []
            if force_unit != raw.force_unit:
                words.append(f"force-unit={force_unit}")
            if rate_unit != raw.rate_unit:
                words.append(f"rate-unit={rate_unit}")
            return " and ".join(words)
    return None


def _figures(imu: ImuLog, raw: RawLog) -> dict[str, Any]:
    rate = imu.angular_rate_radps
    at_rest = None if raw.is_gravity_free else norm_at_rest(imu)
    return {
        "norm_at_rest_mps2": None if at_rest is None else round(at_rest, 3),
        "largest_rate_radps": round(float(np.abs(rate).max()), 3),
    }


def norm_at_rest(imu: ImuLog) -> float | None:
    """Return the norm of the specific force while the sensor is still, or None."""
    force, rate = imu.specific_force_mps2, imu.angular_rate_radps
    count = max(2, round(_WINDOW_S * imu.rate_hz))
    windows = len(imu) // count
    if windows < _LEAST_STILL_WINDOWS:
        return None
    shape = (windows, count, 3)
    blocks = force[: windows * count].reshape(shape)
    turning = np.abs(rate[: windows * count].reshape(shape)).mean(axis=(1, 2))
    spread = blocks.std(axis=1).max(axis=1)
    scale = float(np.median(np.linalg.norm(force, axis=1))) / STANDARD_GRAVITY_MPS2
    still = (spread < _STILL_MPS2 * min(1.0, scale)) & (turning < _STILL_RADPS)
    if np.count_nonzero(still) < _LEAST_STILL_WINDOWS:
        return None
    return float(np.median(np.linalg.norm(blocks[still].mean(axis=1), axis=1)))


def _check_norm(
    figures: Dict[str, Any], raw: RawLog, choices: LogChoices, where: str
) -> None:
    norm = figures["norm_at_rest_mps2"]
    low, high = REST_NORM_MPS2
    if norm is None or low <= norm <= high or choices.force_unit:
        return
    factor = units.factor(raw.force_unit, units.FORCE, "force-unit")
    fitting = factor * STANDARD_GRAVITY_MPS2 / norm
    raise question(
        f"the specific force is {norm:.3g} m/s2 at rest when it is read in "
        f"{raw.force_unit}, but gravity is 9.81",
        (
            f"force-unit={raw.force_unit} to take it as it is",
            f"force-unit={fitting:.6g} to scale it to gravity",
        ),
        where,
    )


def _check_rate(imu: ImuLog, raw: RawLog, choices: LogChoices, where: str) -> None:
    fast = np.abs(imu.angular_rate_radps).max(axis=1) > MAX_PLAUSIBLE_RADPS
    if choices.rate_unit or np.mean(fast) <= _FAST_SHARE:
        return
    largest = float(np.abs(imu.angular_rate_radps).max())
    other = "deg/s" if raw.rate_unit == "rad/s" else "rad/s"
    raise question(
        f"the angular rate reaches {largest:.3g} rad/s when it is read in "
        f"{raw.rate_unit}, which no sensor shows",
        (
            f"rate-unit={other}",
            f"rate-unit={raw.rate_unit} to take it as it is",
        ),
        where,
    )


def _how_read(raw: RawLog, figures: Dict[str, Any]) -> str:
    """Return one sentence with units, axes and what speaks for them."""
    parts = [f"read as {raw.name}: specific force in {_unit(raw.force_unit)}"]
    if raw.rate is not None and not raw.is_gravity_free:
        parts.append(f"angular rate in {_unit(raw.rate_unit)}")
    if raw.field is not None:
        parts.append(f"magnetic field in {_unit(raw.field_unit)}")
    words = f" ({raw.axes_words})" if raw.axes_words else ""
    parts.append(f"{raw.axes}{words} are right, front, up")
    norm = figures["norm_at_rest_mps2"]
    if norm is not None:
        parts.append(f"{norm:.2f} m/s2 at rest")
    if raw.rate is not None and not raw.is_gravity_free:
        parts.append(f"turning at {figures['largest_rate_radps']:.2f} rad/s at most")
    return ", ".join(parts)


def _unit(unit: str) -> str:
    """Return how a unit is said; a factor is a number of counts."""
    is_named = unit in {**units.FORCE, **units.RATE, **units.FIELD}
    return unit if is_named else f"counts of {float(unit):.4g}"
