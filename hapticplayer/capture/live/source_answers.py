"""What a live source declares of its numbers, what a person answers, and whether it fits.

Answers are the same as for a log (`choices.KEYS`), and are kept under the source's name in
the same file.
"""

from dataclasses import dataclass, replace

import numpy as np

from hapticplayer.capture.assemble import assemble
from hapticplayer.capture.choices import (
    ACCEL_UNITS,
    RATE_UNITS,
    LogChoices,
    LogQuestion,
    factor,
    parse_choices,
)
from hapticplayer.capture.log_tables import keep_answers, kept_answers
from hapticplayer.capture.mounting import AS_RECORDED, signed_axes
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.model.arrays import Floats


@dataclass(frozen=True, slots=True)
class Declaration:
    """What a source tells of its numbers; "" has to be asked.

    Attributes:
        axes: right, front and up in its axes, such as "y,x,-z".
        axes_words: its axes in words.
        accel_sign: "-" where it reads -1 g on the axis that is up.
        accel_unit: see `choices.ACCEL_UNITS`.
        rate_unit: see `choices.RATE_UNITS`.
    """

    axes: str = AS_RECORDED
    axes_words: str = ""
    accel_sign: str = "+"
    accel_unit: str = "m/s2"
    rate_unit: str = "rad/s"


_QUESTIONS = {
    "accel_sign": (
        Message("the sign of its accelerometer"),
        (
            Message("accel-sign=+ if it reads +1 g on the axis that is up, at rest"),
            Message("accel-sign=- if it reads -1 g there"),
        ),
    ),
    "accel_unit": (
        Message("the unit of its accelerometer"),
        ("accel-unit=m/s2", "accel-unit=g"),
    ),
    "rate_unit": (
        Message("the unit of its gyroscope"),
        ("rate-unit=rad/s", "rate-unit=deg/s"),
    ),
}
_NO_GRAVITY_MPS2 = 0.5
"""A mean reading below it is no gravity, not even one in g."""

_ANSWERED = (*_QUESTIONS, "axes")


def source_key(text: str) -> str:
    """Under which the answers about a source are kept: its name and place."""
    name, _, place = text.partition(":")
    return f"{name}:{place.partition(',')[0].rpartition('/')[2]}"


def with_kept(text: str, choices: LogChoices) -> LogChoices:
    """Answers with those that are kept for the source; the newer ones count."""
    kept = kept_answers().get(source_key(text)[:60])
    if kept is None:
        return choices
    words = {**kept.answers, **choices.given()}
    return parse_choices([f"{key}={value}" for key, value in words.items()])


def keep(text: str, choices: LogChoices) -> None:
    """Keep answers for the source, unless they are kept already."""
    given, key = choices.given(), source_key(text)[:60]
    kept = kept_answers().get(key)
    if given and (kept is None or kept.answers != given):
        keep_answers(key, (), given)


def answered(declares: Declaration, choices: LogChoices) -> Declaration:
    """What a source declares, with the answers of a person in place."""
    given = {name: choices.take(name) for name in _ANSWERED}
    return replace(declares, **{name: text for name, text in given.items() if text})


def ask_for_missing(declares: Declaration, choices: LogChoices, where: str) -> None:
    """Raise LogQuestion for what neither the source nor a person tells."""
    known = answered(declares, choices)
    missing = [name for name in _QUESTIONS if not getattr(known, name)]
    if missing:
        asked = [_QUESTIONS[name] for name in missing]
        what = joined(Message(" and "), [one[0] for one in asked])
        answers = [answer for one in asked for answer in one[1]]
        raise LogQuestion(Message("does not declare {what}", what=what), answers, where)


def refuse_gravity_free(accel_mps2: Floats, text: str) -> None:
    """Raise InputError for acceleration without gravity, as imports do.

    Nothing could be checked, and nothing levelled.
    """
    if (
        len(accel_mps2)
        and np.linalg.norm(np.median(accel_mps2, axis=0)) < _NO_GRAVITY_MPS2
    ):
        raise InputError(
            "sends acceleration from which gravity was removed",
            where=text,
            remedy="choose its acceleration with gravity (the raw accelerometer)",
        )


def checked(
    time_s: Floats,
    samples: tuple[Floats, Floats],
    declares: Declaration,
    choices: LogChoices,
    text: str,
) -> Recording:
    """What a source has measured so far, as a log that is checked at rest and in turns.

    Args:
        time_s: (N,) of its clock, increasing.
        samples: acceleration and angular rate (N, 3), in SI and with the answers applied.
        declares: of its row.
        choices: the answers.
        text: that names the source.

    Raises:
        LogQuestion: where gravity contradicts a unit, a sign or the axes; with answers that
            `open_source` takes.
        InputError: where they are no motion with gravity.
    """
    known = answered(declares, choices)
    if not len(time_s):
        remedy = Message("see whether it is switched on")
        raise InputError("has sent no sample yet", where=text, remedy=remedy)
    refuse_gravity_free(samples[0], text)
    sign = -1.0 if known.accel_sign == "-" else 1.0
    accel = samples[0] / (sign * factor(known.accel_unit, ACCEL_UNITS, "accel-unit"))
    rate = samples[1] / factor(known.rate_unit, RATE_UNITS, "rate-unit")
    raw = RawLog(
        name=text,
        accel=SensorStream(time_s, _as_stored(accel, choices.accel_axes)),
        rate=SensorStream(time_s, _as_stored(rate, choices.rate_axes)),
        accel_unit=known.accel_unit,
        rate_unit=known.rate_unit,
        axes=known.axes,
        axes_words=declares.axes_words,
    )
    # a copy: its answers are applied anew
    return assemble(raw, replace(choices, accel_sign=known.accel_sign), text)


def _as_stored(values: Floats, axes: str) -> Floats:
    """What `own_axes` was given."""
    change = signed_axes(axes) if axes else None
    return values if change is None else np.asarray(values @ change)
