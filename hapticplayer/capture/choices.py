"""Answers about a log that does not describe itself.

The same keys serve the command line (`--read-as KEY=VALUE`) and templates: JSON files
written once for a logger and used for all its logs.
"""

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hapticplayer.errors import InputError, Message, UsageError, joined
from hapticplayer.model import STANDARD_GRAVITY_MPS2, Sampling
from hapticplayer.model.applied import AppliedAnswers
from hapticplayer.model.limits import MAX_TEMPLATE_BYTES
from hapticplayer.model.ranges import RATE_DELAY_S, SAMPLE_RATE_HZ, UNIT_FACTOR
from hapticplayer.storage import FILE, file_written_aside, json_text, refuse_existing
from hapticplayer.untrusted import parse_json, read_regular

OPTION = "--read-as"

ACCEL_UNITS: Mapping[str, float] = {
    "m/s2": 1.0,
    "g": STANDARD_GRAVITY_MPS2,
    "mg": STANDARD_GRAVITY_MPS2 / 1000.0,
    "cm/s2": 0.01,
}
RATE_UNITS: Mapping[str, float] = {
    "rad/s": 1.0,
    "deg/s": math.pi / 180.0,
    "mdeg/s": math.pi / 180_000.0,
}
FIELD_UNITS: Mapping[str, float] = {
    "uT": 1.0,
    "nT": 1e-3,
    "mT": 1e3,
    "T": 1e6,
    "gauss": 100.0,
    "mG": 0.1,
}
SWAPPED: Mapping[str, str] = {"accel,rate": "rate", "accel,field": "field"}
TIME_UNITS: Mapping[str, float] = {
    "s": 1.0,
    "ms": 1e-3,
    "us": 1e-6,
    "ns": 1e-9,
    "d": 86_400.0,
}
"""Days are those of spreadsheets."""


@dataclass(frozen=True, slots=True)
class LogChoices(AppliedAnswers):
    """Answers about a log; "" leaves one to the format.

    Attributes:
        format: name of a format, instead of recognising it.
        columns: of a table: a name for each cell of a row: time, ax ay az, gx gy gz,
            mx my mz, "-" to ignore it; "/" between tables.
        time_unit: s, ms, us, ns or d.
        accel_unit: m/s2, g, mg, cm/s2 or the factor to m/s2.
        rate_unit: rad/s, deg/s or the factor to rad/s.
        field_unit: uT, gauss ... or the factor to uT.
        axes: right, front and up in the log's axes, such as "x,-z,y".
        accel_sign: "-" if the accelerometer reads -1 g upwards at rest.
        accel_axes: the accelerometer's x, y, z in its columns, such as "y,x,z", mirrored
            perhaps; `axes` is of all sensors, and a rotation.
        rate_axes: the same of the gyroscope.
        rate_delay: seconds by which the gyroscope's times are late.
        swapped: two sensors whose columns are swapped, such as "accel,rate"; or "no".
        rate_hz: samples per second, for a log without timestamps.
        sampling: "averaged" if each sample is a mean over a window around its time,
            "instant" if not.
        stuck: "no-force" for a log whose sensors were stuck: no force there.
    """

    format: str = ""
    columns: str = ""
    time_unit: str = ""
    accel_unit: str = ""
    rate_unit: str = ""
    field_unit: str = ""
    axes: str = ""
    accel_sign: str = ""
    accel_axes: str = ""
    rate_axes: str = ""
    rate_delay: str = ""
    swapped: str = ""
    rate_hz: str = ""
    sampling: str = ""
    stuck: str = ""

    def take_rate_hz(self) -> float | None:
        """The samples per second of a log without timestamps, applied now."""
        text: str = self.take("rate_hz")
        return SAMPLE_RATE_HZ.parse("rate-hz", text) if text else None

    def take_rate_delay_s(self) -> float:
        """By which the gyroscope's times are late, applied now."""
        text: str = self.take("rate_delay")
        return RATE_DELAY_S.parse("rate-delay", text) if text else 0.0

    def given(self) -> dict[str, str]:
        """The answers by key, as a person types them."""
        values = ((key, getattr(self, key.replace("-", "_"))) for key in KEYS)
        return {key: value for key, value in values if value}

    def refuse_untaken(self, form: str, where: str) -> None:
        """Raise UsageError for an answer that no part of the reading has applied."""
        for name in self.untaken():
            key = name.replace("_", "-")
            raise UsageError(
                "{file}: {option} {key}={value} has no effect on a log of {form}: "
                "{why}; leave it out",
                file=where,
                option=OPTION,
                key=key,
                value=getattr(self, name)[:80],
                form=form,
                why=_WHY_UNTAKEN[key],
            )


KEYS = tuple(
    field.name.replace("_", "-")
    for field in dataclasses.fields(LogChoices)
    if field.init
)
_SAVE = Message("save the answers of another log (--save-template FILE)")
_UNITS_ARE_KNOWN = Message("it holds no such samples, or states their unit")
_WHY_UNTAKEN: Mapping[str, Message] = {
    "format": Message("its last part names no variant of it"),
    "columns": Message("its columns are known"),
    "time-unit": Message("the unit of its times is known, or it has no times"),
    "accel-unit": _UNITS_ARE_KNOWN,
    "rate-unit": _UNITS_ARE_KNOWN,
    "field-unit": _UNITS_ARE_KNOWN,
    "rate-delay": Message("it holds no gyroscope, or its sensors share a clock"),
    "swapped": Message("its format tells its sensors apart, or it does not have both"),
    "stuck": Message("no sensor of it was stuck"),
    "rate-hz": Message("its samples have times, or a rate of their own"),
}


def factor(unit: str, table: Mapping[str, float], key: str) -> float:
    """Return the factor of a unit.

    Args:
        unit: a name in the table, or the factor itself as a number.
        table: of units.
        key: of the choice, for the message.
    """
    if unit in table:
        return table[unit]
    value = UNIT_FACTOR.find(unit)
    if value is None:
        raise UsageError(
            "{key}={unit} is not a unit; choose {known}, or give the factor to SI as "
            "a number between {least:g} and {largest:g}",
            key=key,
            unit=unit,
            known=", ".join(table),
            least=UNIT_FACTOR.least,
            largest=UNIT_FACTOR.largest,
        )
    return value


def is_factor(unit: str, table: Mapping[str, float]) -> bool:
    """Whether a unit was given as a number, which nothing questions."""
    return bool(unit) and unit not in table


def rate_unit_times(scale: float, unit: str) -> str:
    """Another unit of the angular rate, so many times as large."""
    fitting = scale * factor(unit, RATE_UNITS, "rate-unit")
    names = (name for name, one in RATE_UNITS.items() if math.isclose(one, fitting))
    return next(names, f"{fitting:.9g}")


def kept_as(key: str, unit: str, table: Mapping[str, float], words: Message) -> Message:
    """The answer that keeps a unit although it is in doubt: its factor."""
    return Message(
        "{key}={factor:.9g} {words}",
        key=key,
        factor=factor(unit, table, key),
        words=words,
    )


def each_with_its_option(words: Sequence[str]) -> list[str]:
    """Return the words of a command with the option before each answer that follows it."""
    found: list[str] = []
    in_answers = False
    for word in words:
        if word.startswith(OPTION):
            in_answers = True
        elif in_answers and found[-1] != OPTION:
            key, equals, _ = word.partition("=")
            in_answers = bool(equals) and key in {*KEYS, "template"}
            found += [OPTION] * in_answers
        found.append(word)
    return found


def parse_choices(words: Sequence[str]) -> LogChoices:
    """Return the answers in `KEY=VALUE` words; `template=FILE` adds those of a file."""
    values: dict[str, str] = {}
    of_template: dict[str, str] = {}
    for word in words:
        key, equals, value = word.partition("=")
        key, value = key.strip().lower(), value.strip()
        name = key.replace("-", "_")
        if key == "template" and value:
            of_template |= _template(value)
        elif not equals or key not in KEYS:
            raise UsageError(
                "{option} {word!r} is not understood; give KEY=VALUE with one of {known}",
                option=OPTION,
                word=word,
                known=", ".join((*KEYS, "template")),
            )
        elif not value or values.get(name, value) != value:
            raise UsageError(
                "{option} {key}={value} {fault}; give one value",
                option=OPTION,
                key=key,
                value=value[:80],
                fault=Message("comes after another value")
                if value
                else Message("has no value"),
            )
        else:
            values[name] = value
    values = {**of_template, **values}
    if values.get("accel_sign", "") not in {"", "+", "-"}:
        raise UsageError("accel-sign must be + or -")
    if values.get("sampling", "") not in {"", *(kind.value for kind in Sampling)}:
        raise UsageError("sampling must be averaged or instant")
    if values.get("swapped", "") not in {"", "no", *SWAPPED}:
        raise UsageError(
            "swapped must be {known}", known=joined(Message(" or "), [*SWAPPED, "no"])
        )
    if values.get("stuck", "") not in {"", "no-force"}:
        raise UsageError("stuck must be no-force")
    return LogChoices(**values)


def _template(name: str) -> dict[str, str]:
    """The choices in a file, or those that are kept under a name."""
    from hapticplayer.capture.log_tables import KEPT, kept_answers

    kept = None if Path(name).exists() else kept_answers().get(name)
    if kept is None:
        return read_template(Path(name))
    return _by_attribute(kept.answers, KEPT)


def read_template(path: Path) -> dict[str, str]:
    """Return the choices of a template by attribute."""
    text = read_regular(path, MAX_TEMPLATE_BYTES)
    return _by_attribute(parse_json(text, str(path), InputError, _SAVE), str(path))


def _by_attribute(content: Any, where: str) -> dict[str, str]:
    if not _are_answers(content):
        raise InputError(
            "is not a template for logs (it must hold texts for {known})",
            where=where,
            remedy=_SAVE,
            known=", ".join(KEYS),
        )
    return {key.replace("-", "_"): value for key, value in content.items()}


def _are_answers(content: Any) -> bool:
    return isinstance(content, dict) and all(
        key in KEYS and isinstance(value, str) for key, value in content.items()
    )


def _is_template(content: bytes) -> bool:
    try:
        answers = parse_json(content, "", InputError, "")
    except InputError:
        return False
    return bool(answers) and _are_answers(answers)


def refuse_existing_template(path: Path, overwrite: bool) -> None:
    """Raise InputError for a file that exists and is no template to be overwritten."""
    refuse_existing(path, FILE, _is_template if overwrite else None)


def write_template(path: Path, choices: LogChoices, *, overwrite: bool = False) -> None:
    """Write answers as a template."""
    with file_written_aside(path, _is_template if overwrite else None) as part:
        part.write_bytes(json_text(choices.given()))


class LogQuestion(UsageError):  # noqa: N818 - it asks
    """A decision about a log is needed (exit status 2).

    Attributes:
        what: is ambiguous.
        answers: each as typed (KEY=VALUE), with its meaning.
        where: the file.
    """

    def __init__(self, what: str, answers: Sequence[str], where: str) -> None:
        super().__init__(
            "{file}: {what}; decide with {option} {answers}",
            file=where,
            what=what,
            option=OPTION,
            answers=joined(Message(", or "), answers),
        )
        self.what, self.answers, self.where = what, tuple(answers), where

    def __reduce__(self) -> tuple[type, tuple[str, tuple[str, ...], str]]:
        """Let it pass from one process to another."""
        return type(self), (self.what, self.answers, self.where)
