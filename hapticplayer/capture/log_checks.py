"""Checks what a log declares against gravity and plausible rates.

A person is asked if a figure does not fit, also about a unit that was given by name; a
factor is not questioned.
"""

from collections.abc import Mapping as Dict
from typing import Any

import numpy as np

from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    FIELD_UNITS,
    RATE_UNITS,
    LogChoices,
    LogQuestion,
    factor,
    is_factor,
    kept_as,
)
from hapticplayer.capture.mounting import AXES, WRONG_SIGN, axes_matrix, mean_up
from hapticplayer.capture.streams import RawLog
from hapticplayer.errors import Message, joined
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_USUAL_RATE_RADPS, REST_MPS2, UPRIGHT

AS_IT_IS = Message("to take it as it is")

_WINDOW_S = 0.5
_STATIONARY_MPS2 = 0.25
_STATIONARY_RADPS = 0.15
_MIN_STATIONARY_WINDOWS = 4
_FAST_SHARE = 0.001
# A car that brakes evenly for half a second seems at rest, with a larger norm.
_AT_REST_PERCENT, _SPEEDING_UP = 10.0, 1.03


def figures(imu: ImuLog, raw: RawLog) -> dict[str, Any]:
    """Return the norm at rest and the largest rate of a log in SI.

    And whether the motion shows if the gyroscope's axes are right.
    """
    from hapticplayer.motion.repair.rotation import turns_gravity

    at_rest = None if raw.is_gravity_free else norm_at_rest(imu)
    return {
        "norm_at_rest_mps2": None if at_rest is None else round(at_rest, 3),
        "largest_rate_radps": round(float(np.abs(imu.angular_rate_radps).max()), 3),
        "is_rate_compared": not raw.is_gravity_free and turns_gravity(imu),
    }


def norm_at_rest(imu: ImuLog) -> float | None:
    """Return the norm of the specific force while stationary, or None."""
    accel, rate = imu.specific_force_mps2, imu.angular_rate_radps
    count = max(2, round(_WINDOW_S * imu.rate_hz))
    windows = len(imu) // count
    if windows < _MIN_STATIONARY_WINDOWS:
        return None
    shape = (windows, count, 3)
    blocks = accel[: windows * count].reshape(shape)
    rate_mean = np.abs(rate[: windows * count].reshape(shape)).mean(axis=(1, 2))
    spread = blocks.std(axis=1).max(axis=1)
    scale = float(np.median(np.linalg.norm(accel, axis=1))) / STANDARD_GRAVITY_MPS2
    stationary = (spread < _STATIONARY_MPS2 * min(1.0, scale)) & (
        rate_mean < _STATIONARY_RADPS
    )
    if np.count_nonzero(stationary) < _MIN_STATIONARY_WINDOWS:
        return None
    norm = np.linalg.norm(blocks[stationary].mean(axis=1), axis=1)
    least = np.percentile(norm, _AT_REST_PERCENT, method="lower")
    return float(np.median(norm[norm <= _SPEEDING_UP * least]))


def check_norm(
    found: Dict[str, Any], raw: RawLog, choices: LogChoices, where: str
) -> None:
    """Ask for the unit of the specific force if the norm at rest is not 1 g.

    Args:
        found: of `figures`.
        raw: the log; its units were applied.
        choices: a chosen factor is not questioned.
        where: the file.
    """
    norm = found["norm_at_rest_mps2"]
    low, high = REST_MPS2
    if (
        norm is None
        or low <= norm <= high
        or is_factor(choices.accel_unit, ACCEL_UNITS)
    ):
        return
    to_si = factor(raw.accel_unit, ACCEL_UNITS, "accel-unit")
    fitting = to_si * STANDARD_GRAVITY_MPS2 / norm
    raise LogQuestion(
        Message(
            "the specific force is {norm:.3g} m/s2 at rest when read in "
            "{accel_unit}, but gravity is 9.81",
            norm=norm,
            accel_unit=raw.accel_unit,
        ),
        (
            kept_as("accel-unit", raw.accel_unit, ACCEL_UNITS, Message("to keep it")),
            Message("accel-unit={fitting:.6g} to scale it to gravity", fitting=fitting),
        ),
        where,
    )


def check_rate(imu: ImuLog, raw: RawLog, choices: LogChoices, where: str) -> None:
    """Ask for the unit of the angular rate if it is beyond any sensor."""
    fast = np.abs(imu.angular_rate_radps).max(axis=1) > MAX_USUAL_RATE_RADPS
    if is_factor(choices.rate_unit, RATE_UNITS) or np.mean(fast) <= _FAST_SHARE:
        return
    largest = float(np.abs(imu.angular_rate_radps).max())
    other = "deg/s" if raw.rate_unit == "rad/s" else "rad/s"
    raise LogQuestion(
        Message(
            "the angular rate reaches {largest:.3g} rad/s when it is read in "
            "{rate_unit}, which no sensor shows",
            largest=largest,
            rate_unit=raw.rate_unit,
        ),
        (
            f"rate-unit={other}",
            kept_as("rate-unit", raw.rate_unit, RATE_UNITS, AS_IT_IS),
        ),
        where,
    )


def how_read(raw: RawLog, found: Dict[str, Any]) -> str:
    """Return one sentence with format, units, axes and the figures that support them."""
    parts = [
        Message(
            "read as {name}: specific force in {unit}",
            name=raw.name,
            unit=_unit(raw.accel_unit),
        )
    ]
    if raw.rate is not None and not raw.is_gravity_free:
        parts.append(Message("angular rate in {unit}", unit=_unit(raw.rate_unit)))
    if raw.field is not None:
        parts.append(Message("magnetic field in {unit}", unit=_unit(raw.field_unit)))
    words = Message(" ({words})", words=raw.axes_words) if raw.axes_words else ""
    parts.append(
        Message("{axes}{words} are right, front, up", axes=raw.axes, words=words)
    )
    if raw.rate is not None and not (raw.is_gravity_free or found["is_rate_compared"]):
        parts.append(
            Message("those of the gyroscope not checked: gravity hardly turns")
        )
    norm = found["norm_at_rest_mps2"]
    if norm is not None:
        parts.append(Message("{norm:.2f} m/s2 at rest", norm=norm))
    if raw.rate is not None and not raw.is_gravity_free:
        parts.append(
            Message(
                "at most {largest_radps:.2f} rad/s",
                largest_radps=found["largest_rate_radps"],
            )
        )
    return joined(", ", parts)


def _unit(unit: str) -> str:
    """Return the name of a unit; a factor is shown as counts."""
    is_named = unit in {**ACCEL_UNITS, **RATE_UNITS, **FIELD_UNITS}
    return unit if is_named else Message("counts of {unit:.4g}", unit=float(unit))


def check_upright(
    imu: ImuLog, raw: RawLog, choices: LogChoices, where: str
) -> tuple[str, ...]:
    """Check that the specific force points up in frame A; return notes.

    Args:
        imu: of the log, in frame A as declared.
        raw: the log; its axes were applied.
        choices: chosen axes are not questioned.
        where: the file.
    """
    mean = mean_up(imu)
    if mean is None:
        return (
            Message("the sensor rotated so much that gravity does not show its axes"),
        )
    if mean[2] >= UPRIGHT:
        return ()
    stored = axes_matrix(raw.axes).T @ np.array(mean)
    up = int(np.argmax(np.abs(stored)))
    up_name = ("-" if stored[up] < 0.0 else "") + AXES[up]
    if choices.axes:
        return (
            Message(
                "gravity shows that {axis} was up, not the axis that was chosen",
                axis=up_name,
            ),
        )
    words = Message(" ({words})", words=raw.axes_words) if raw.axes_words else ""
    proposal = _proposal(up, stored[up] < 0.0, raw.back_axis)
    answers = [
        Message("axes={axes}, or the axes that were right, front, up", axes=proposal)
    ]
    if not choices.accel_sign:
        answers.insert(0 if stored[up] < 0.0 else 1, WRONG_SIGN)
    raise LogQuestion(
        Message(
            "its axis {axis} was up, so the sensor was not mounted with {axes} to "
            "the right, front and up{words}",
            axis=up_name,
            axes=raw.axes,
            words=words,
        ),
        answers,
        where,
    )


def _proposal(up: int, is_down: bool, back_axis: str) -> str:
    """Return right, front, up for the axis that was up."""
    upward, front = np.zeros(3), np.zeros(3)
    upward[up] = -1.0 if is_down else 1.0
    back = AXES.find(back_axis) if back_axis else -1
    if back not in (-1, up):
        front[back] = -1.0
    else:
        front[1 if up == 2 else 2] = 1.0
    rows = (np.cross(front, upward), front, upward)
    return ",".join(_name(row) for row in rows)


def _name(row: Floats) -> str:
    at = int(np.argmax(np.abs(row)))
    return ("-" if row[at] < 0.0 else "") + AXES[at]
