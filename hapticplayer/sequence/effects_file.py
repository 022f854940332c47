"""Effects as the JSON that a sequence keeps, `effects.json`; untrusted when it is read."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, TypeVar

from msgspec import Meta, Struct, structs, to_builtins

from hapticplayer.errors import (
    InputError,
    Message,
    SequenceError,
    UsageError,
    message_of,
)
from hapticplayer.rendering.effects.values import (
    UP,
    Effect,
    EffectList,
    Target,
    TimeMarker,
)
from hapticplayer.structures import check_schema, convert, read_json

SCHEMA, VERSION = "hapticplayer.effects", 1
MAX_BYTES = 1 << 20
_GIVE = Message("give an effects.json")

_ALWAYS = ("kind", "start_s", "end_s", "target")
Value = TypeVar("Value")
_Number = Annotated[float, Meta(ge=-1e12, le=1e12)]


class _Entry(Struct, forbid_unknown_fields=True):
    kind: str
    start_s: float
    end_s: float
    target: Target = Target.FORCE
    direction: tuple[_Number, _Number, _Number] = UP
    fade_in_s: float = 0.0
    fade_out_s: float = 0.0
    parameters: dict[str, float] = {}
    curve: tuple[tuple[_Number, _Number], ...] = ()
    enabled: bool = True


class _Marker(Struct, forbid_unknown_fields=True):
    time_s: float
    name: str


class _List(Struct):
    effects: list[_Entry]
    markers: list[_Marker] = []


def read_effects(path: Path) -> EffectList:
    """The list in an untrusted file; raises InputError, which names entry and field."""
    content = read_json(path, dict[str, Any], SequenceError, _GIVE, MAX_BYTES)
    return effects_in(content, str(path))


def written(effects: EffectList) -> dict[str, Any]:
    """Return the list as JSON keeps it; what is as usual is left out."""
    entries = [described_effect(effect) for effect in effects.effects]
    markers = {"markers": to_builtins(effects.markers)} if effects.markers else {}
    return {"schema": SCHEMA, "version": VERSION, "effects": entries, **markers}


def described_effect(effect: Effect) -> dict[str, Any]:
    usual = to_builtins(Effect(effect.kind, effect.start_s, effect.end_s))
    return {
        name: value
        for name, value in to_builtins(effect).items()
        if name in _ALWAYS or value != usual[name]
    }


def effects_in(content: Any, where: str) -> EffectList:
    """Return the list in the JSON of an untrusted file.

    Args:
        content: as `written` returns it.
        where: the file, for messages.
    """
    other = Message("is not a list of effects"), _GIVE
    check_schema(content, (SCHEMA, VERSION), where, other)
    found = convert(content, _List, where)
    with _placed(where):
        return EffectList(
            tuple(_checked(found.effects, Effect, f"{where}, effects")),
            tuple(_checked(found.markers, TimeMarker, f"{where}, markers")),
        )


def _checked(
    entries: Iterable[Struct], make: Callable[..., Value], where: str
) -> Iterator[Value]:
    for number, entry in enumerate(entries):
        with _placed(f"{where}[{number}]"):
            yield make(**structs.asdict(entry))


@contextmanager
def _placed(where: str) -> Iterator[None]:
    """Say in which file and entry a value is not allowed."""
    try:
        yield
    except UsageError as problem:
        raise InputError(message_of(problem), where=where) from None
