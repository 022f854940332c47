"""Effects as the JSON that a sequence keeps, `effects.json`; untrusted when it is read."""

from collections.abc import Iterable, Mapping
from typing import Any

from hapticplayer.errors import InputError, Message, UsageError, message_of
from hapticplayer.rendering.effects.values import Effect, EffectList, Target

SCHEMA, VERSION = "hapticplayer.effects", 1
MAX_BYTES = 1 << 20

_FIELDS: dict[str, tuple[type | tuple[type, ...], Message]] = {
    "kind": (str, Message("a text")),
    "target": (str, Message("a text")),
    "start_s": ((int, float), Message("a number")),
    "end_s": ((int, float), Message("a number")),
    "fade_in_s": ((int, float), Message("a number")),
    "fade_out_s": ((int, float), Message("a number")),
    "enabled": (bool, Message("true or false")),
    "parameters": (dict, Message("an object")),
    "direction": (list, Message("a list")),
    "curve": (list, Message("a list")),
}


def written(effects: EffectList) -> dict[str, Any]:
    """Return the list as JSON keeps it; what is as usual is left out."""
    entries = [described_effect(effect) for effect in effects.effects]
    return {"schema": SCHEMA, "version": VERSION, "effects": entries}


def described_effect(effect: Effect) -> dict[str, Any]:
    """Return one entry."""
    usual = Effect(effect.kind, effect.start_s, effect.end_s)
    entry: dict[str, Any] = {
        "kind": effect.kind,
        "start_s": effect.start_s,
        "end_s": effect.end_s,
        "target": effect.target.value,
    }
    if effect.direction != usual.direction:
        entry["direction"] = list(effect.direction)
    for name in ("fade_in_s", "fade_out_s"):
        if value := getattr(effect, name):
            entry[name] = value
    if effect.parameters:
        entry["parameters"] = dict(effect.parameters)
    if effect.curve:
        entry["curve"] = [list(point) for point in effect.curve]
    if not effect.enabled:
        entry["enabled"] = False
    return entry


def parsed(content: Any, where: str) -> EffectList:
    """Return the list in the JSON of an untrusted file.

    Args:
        content: as `written` returns it.
        where: the file, for messages.

    Raises:
        InputError: names the entry, its field and what is allowed there.
    """
    if not isinstance(content, Mapping) or content.get("schema") != SCHEMA:
        raise InputError(
            "is not a list of effects", where=where, remedy="give an effects.json"
        )
    if content.get("version") != VERSION:
        raise InputError(
            "has version {found}, this program reads {version}",
            where=where,
            remedy="update hapticplayer",
            found=str(content.get("version"))[:20],
            version=VERSION,
        )
    entries = content.get("effects")
    if not isinstance(entries, list):
        raise InputError("effects: must be a list", where=where)
    effects = [
        _effect(one, f"{where}: effects[{number}]")
        for number, one in enumerate(entries)
    ]
    try:
        return EffectList(tuple(effects))
    except UsageError as problem:
        raise InputError(message_of(problem), where=where) from None


def _effect(entry: Any, where: str) -> Effect:
    if not isinstance(entry, Mapping):
        raise InputError("must be an object", where=where)
    for name, value in entry.items():
        if name not in _FIELDS:
            raise InputError("{name}: unknown field", where=where, name=str(name)[:40])
        wanted, text = _FIELDS[name]
        if not isinstance(value, wanted) or (
            isinstance(value, bool) and wanted is not bool
        ):
            raise InputError(
                "{name}: must be {wanted}", where=where, name=name, wanted=text
            )
    for name in ("kind", "start_s", "end_s"):
        if name not in entry:
            raise InputError("{name}: is missing", where=where, name=name)
    fields = dict(entry)
    if entry.get("target", Target.FORCE) not in list(Target):
        raise InputError(
            "target: must be one of {known}", where=where, known=", ".join(Target)
        )
    fields["target"] = Target(entry.get("target", Target.FORCE))
    if "direction" in entry:
        fields["direction"] = _numbers(entry["direction"], 3, f"{where}.direction")
    fields["curve"] = tuple(
        _numbers(point, 2, f"{where}.curve[{number}]")
        for number, point in enumerate(entry.get("curve", ()))
    )
    try:
        return Effect(**fields)
    except UsageError as problem:
        raise InputError(message_of(problem), where=where) from None


def _numbers(values: Any, count: int, where: str) -> tuple[Any, ...]:
    """Return a list of so many numbers as a tuple."""
    if not isinstance(values, list) or len(values) != count or not _are_numbers(values):
        raise InputError("must be {count} numbers", where=where, count=count)
    return tuple(float(value) for value in values)


def _are_numbers(values: Iterable[Any]) -> bool:
    return all(
        isinstance(one, int | float) and not isinstance(one, bool) and abs(one) < 1e12
        for one in values
    )
