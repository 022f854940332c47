"""Whether accelerometer and gyroscope tell of one motion; a person is asked if not.

A gyro rotates gravity in the accelerometer's axes. Where it would do so better with
other axes or signs, one of the two is mirrored, turned, or not what it is taken for.
"""

import dataclasses
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    RATE_UNITS,
    SWAPPED,
    LogChoices,
    LogQuestion,
    factor,
    is_factor,
    kept_as,
    rate_unit_times,
)
from hapticplayer.capture.mounting import (
    AS_RECORDED,
    AXES,
    axes_matrix,
    axes_text,
    mean_up,
    signed_axes,
)
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import COARSE_REST_MPS2, REST_MPS2, UPRIGHT

if TYPE_CHECKING:
    from hapticplayer.motion.repair.rotation import Doubt

_WINDOW_ROWS, _CALM_PERCENT = 32, 20.0
_MOST_ANSWERS, _GAP_OF_A_MISTAKE = 3, 2.0
_DAMAGED_LOG_SCALE = math.log(20.0)
_KEYS = "accel_axes", "rate_axes"


def own_axes(values: Sequence[Floats], choices: LogChoices) -> list[Floats]:
    """Return accelerometer and gyroscope (N, 3) in the axes that a person gave each."""
    turned = []
    for sensor, name in zip(values, _KEYS, strict=True):
        given = choices.take(name)
        if given and (change := signed_axes(given)) is not None:
            turned.append(np.asarray(sensor @ change.T))
        elif given:
            raise UsageError(
                "{key}={axes} are not three axes; give the sensor's x, y, z in its "
                "columns, such as y,x,z or x,-y,z",
                key=name.replace("_", "-"),
                axes=given[:80],
            )
        else:
            turned.append(sensor)
    return turned


def ask_about_agreement(
    imu: ImuLog,
    choices: LogChoices,
    where: str,
    axes: str = AS_RECORDED,
    rate_unit: str = "rad/s",
    *,
    is_of_camera: bool = False,
) -> tuple[Message, ...]:
    """Ask for what is wrong where gyroscope and accelerometer contradict each other.

    Args:
        imu: in frame A.
        choices: what a person gave for a sensor is noted, not questioned.
        where: the file.
        axes: right, front, up of frame A in the stored axes.
        rate_unit: that the gyroscope was read in.
        is_of_camera: its maker states the scale; that gravity shows another is noted, but
            for one so far off that it is damage.
    """
    from hapticplayer.motion.repair.rotation import dead_axes, doubt_about

    doubt = doubt_about(imu)
    if dead := dead_axes(imu, doubt):
        what, answers = _dead(dead, axes)
    elif doubt is None or doubt.scale is not None:
        scale = doubt.scale if doubt else None
        found = _scaled(scale, rate_unit) if scale else _not_shown(imu)
        if found is None or is_factor(choices.rate_unit, RATE_UNITS):
            return ()
        what, answers = found
        is_damage = scale is not None and abs(math.log(scale)) > _DAMAGED_LOG_SCALE
        if is_of_camera and not is_damage:
            return (what,)
    elif doubt.delay_s:
        what, answers = _delayed(doubt.delay_s)
        if choices.rate_delay:
            return (Message("{what}, with the delay that was given", what=what),)
    else:
        what, answers = _turned(doubt, imu, axes)
    if choices.accel_axes or choices.rate_axes:
        return (Message("{what}, with the axes that were given", what=what),)
    raise LogQuestion(what, answers, where)


_KEPT = Message("rate-axes={axes} to keep both as they are", axes=AS_RECORDED)
_AGAIN = Message("record it again")


def _dead(dead: Sequence[int], axes: str) -> tuple[Message, list[Message]]:
    stored = axes_matrix(axes).T
    names = [AXES[int(np.argmax(np.abs(stored[:, axis])))] for axis in dead]
    what = Message(
        "its gyroscope reads exactly 0 about {axes} throughout, but gravity turns in its "
        "accelerometer as it does not show",
        axes=", ".join(sorted(names)),
    )
    return what, [_KEPT, _AGAIN]


def _not_shown(imu: ImuLog) -> tuple[Message, list[Message]] | None:
    from hapticplayer.motion.repair.rotation import unseen_turn_rad

    turn_rad = unseen_turn_rad(imu)
    if not turn_rad:
        return None
    what = Message(
        "gravity turns by {turn_deg:.0f} degrees within 8 s in its accelerometer as its "
        "gyroscope does not show: an axis is dead, or the range of one or all another",
        turn_deg=math.degrees(turn_rad),
    )
    return what, [_KEPT, _AGAIN]


def _scaled(scale: float, rate_unit: str) -> tuple[Message, list[Message]]:
    what = Message(
        "the rate of its gyroscope is about {times:.2g} times too {how} for how gravity "
        "turns in its accelerometer",
        times=max(scale, 1.0 / scale),
        how=Message("low") if scale > 1.0 else Message("high"),
    )
    unit = rate_unit_times(scale, rate_unit)
    return what, [
        Message("rate-unit={unit} to scale it to gravity", unit=unit),
        kept_as("rate-unit", rate_unit, RATE_UNITS, Message("to keep it")),
    ]


def _delayed(delay_s: float) -> tuple[Message, list[Message]]:
    what = Message(
        "its gyroscope shows how gravity turns in its accelerometer {size_s:.2f} s too "
        "{how}: their clocks differ",
        size_s=abs(delay_s),
        how=Message("late") if delay_s > 0.0 else Message("early"),
    )
    return what, [
        Message("rate-delay={delay_s:.2f} to take it back", delay_s=delay_s),
        Message("rate-delay=0 to keep both as they are"),
    ]


def _turned(doubt: "Doubt", imu: ImuLog, axes: str) -> tuple[Message, list[Message]]:
    what = Message(
        "the rotation of its gyroscope does not match that of gravity in its "
        "accelerometer: their axes or signs differ"
    )
    assert doubt.change is not None
    fits = [
        fit
        for gap, change in [(0.0, doubt.change), *doubt.gaps]
        for fit in _fits(change, gap, imu)
    ]
    fits.sort(key=lambda fit: fit.unlikely)
    # where gravity alone does not decide, no rotation is named without a mirror image
    named = fits[:_MOST_ANSWERS]
    kinds = {fit.is_mirrored for fit in named}
    named += [fit for fit in fits if fit.is_mirrored not in kinds][:1]
    stored = axes_matrix(axes)
    answers = [
        Message(
            "{key}={axes} if the {sensor} is {how}",
            key=fit.key,
            axes=axes_text(stored.T @ fit.change @ stored),
            sensor=fit.sensor,
            how=how_changed(fit.change),
        )
        for fit in named
    ]
    if any(np.array_equal(fit.change, -np.eye(3)) for fit in named):
        answers += _both_mirrored(imu, stored)
    return what, [*answers, _KEPT]


def _both_mirrored(imu: ImuLog, stored: Floats) -> Iterator[Message]:
    """Sensors that are mirrored alike rotate as if the gyroscope were reversed."""
    up = mean_up(imu)
    for axis in np.eye(3):
        change = np.eye(3) - 2.0 * np.diag(axis)
        if up is None or (change @ up)[2] >= UPRIGHT:
            text = axes_text(stored.T @ change @ stored)
            yield Message(
                "accel-axes={accel} rate-axes={rate} if both sensors are {how}",
                accel=text,
                rate=text,
                how=how_changed(change),
            )


class _Fit(NamedTuple):
    """What would make both sensors agree: axes (3, 3) of one of them."""

    unlikely: float
    change: Floats
    sensor: Message
    key: str

    @property
    def is_mirrored(self) -> bool:
        return bool(np.linalg.det(self.change) < 0.0)


def _fits(change: Floats, gap: float, imu: ImuLog) -> Iterator[_Fit]:
    """The axes of either sensor; the fewer mistakes lead to them, the likelier."""
    far = _GAP_OF_A_MISTAKE * gap
    yield _Fit(edits(change) + far, change, Message("gyroscope"), "rate-axes")
    if np.linalg.det(change) < 0.0:
        return
    up, force = mean_up(imu), change.T
    # the sign does not matter to the gyro; up is up
    if up is not None and (force @ up)[2] < 0.0:
        force = -force
    yield _Fit(edits(force) + far, force, Message("accelerometer"), "accel-axes")


def edits(change: Floats) -> int:
    """Return how many mistakes lead to other axes: signs, and columns in another order."""
    minus = int(np.count_nonzero(change.sum(axis=1) < 0.0))
    moved = int(np.count_nonzero(np.diag(change) == 0.0))
    return (1 if minus == 3 else minus) + max(0, moved - 1)


def how_changed(change: Floats) -> Message:
    is_mirrored, is_in_order = np.linalg.det(change) < 0.0, np.diag(change).all()
    if is_mirrored:
        return Message("mirrored") if is_in_order else Message("in swapped columns")
    return Message("turned")


def sensors_as_answered(raw: RawLog, choices: LogChoices) -> RawLog:
    """Return the log with swapped columns and the gyro's clock as a person said."""
    if raw.rate is not None and (delay_s := choices.take_rate_delay_s()):
        rate = SensorStream(raw.rate.time_s - delay_s, raw.rate.values)
        raw = dataclasses.replace(raw, rate=rate)
    if choices.swapped not in SWAPPED:
        choices.take("swapped")
        return raw
    other = SWAPPED[choices.swapped]
    held = raw.accel, raw.rate if other == "rate" else raw.field
    if held[1] is None:
        return raw
    choices.take("swapped")
    ratio = raw.scale_ratio if other == "rate" else 1.0
    accel = SensorStream(held[1].time_s, held[1].values * ratio)
    values = SensorStream(held[0].time_s, held[0].values / ratio)
    if other == "rate":
        return dataclasses.replace(raw, accel=accel, rate=values)
    return dataclasses.replace(raw, accel=accel, field=values)


def ask_if_swapped(raw: RawLog, choices: LogChoices, where: str) -> None:
    """Ask whether columns are swapped if those of another sensor show gravity."""
    if choices.swapped:
        return
    to_si = factor(raw.accel_unit, ACCEL_UNITS, "accel-unit")
    norm = to_si * _calm_norm(raw.accel)
    if COARSE_REST_MPS2[0] <= norm <= COARSE_REST_MPS2[1]:
        return
    others = (
        (Message("gyroscope"), raw.rate, to_si * raw.scale_ratio),
        (Message("magnetometer"), raw.field, to_si),
    )
    for key, (name, other, scale) in zip(SWAPPED, others, strict=True):
        if other is None:
            continue
        found = scale * _calm_norm(other)
        if REST_MPS2[0] <= found <= REST_MPS2[1]:
            raise LogQuestion(
                Message(
                    "its accelerometer reads {norm:.3g} m/s2 where it is calm, and its "
                    "{sensor} would read {found:.3g}, as gravity: these columns are "
                    "swapped",
                    norm=norm,
                    sensor=name,
                    found=found,
                ),
                (
                    Message("swapped={key} to swap them", key=key),
                    Message("swapped=no to keep them"),
                ),
                where,
            )


def _calm_norm(stream: SensorStream) -> float:
    """Return the norm of the mean of a sensor (N, 3) where it changes least."""
    values = stream.values[np.isfinite(stream.values).all(axis=1)]
    count = len(values) // _WINDOW_ROWS
    if not count:
        return float(np.linalg.norm(np.median(values, axis=0))) if len(values) else 0.0
    blocks = values[: count * _WINDOW_ROWS].reshape(count, _WINDOW_ROWS, 3)
    with np.errstate(all="ignore"):
        spread = blocks.var(axis=1).sum(axis=1)
    if not np.isfinite(spread).all():  # enormous numbers
        return math.inf
    calm = spread <= np.percentile(spread, _CALM_PERCENT)
    return float(np.median(np.linalg.norm(blocks[calm].mean(axis=1), axis=1)))
