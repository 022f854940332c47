"""JSON as typed structures: the field that is wrong is named, in our words."""

import enum
from typing import Annotated, Literal

import pytest
from msgspec import Meta, Struct

from hapticplayer.errors import InputError, SequenceError
from hapticplayer.model.ranges import finite_number
from hapticplayer.structures import convert


class Level(enum.StrEnum):
    LOW = "low"
    HIGH = "high"


class Part(Struct, forbid_unknown_fields=True):
    size: Annotated[float, Meta(ge=-1.5, le=1e6)]
    place: tuple[float, float] = (0.0, 0.0)


class Whole(Struct, forbid_unknown_fields=True):
    parts: dict[str, Part | Annotated[list[float], Meta(min_length=2)] | None] = {}
    count: Annotated[int, Meta(ge=0)] = 0
    level: Level = Level.LOW
    word: Literal["a", "b"] = "a"
    name: Annotated[str, Meta(max_length=3)] = ""


SMALL = {"size": 0.0}


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ([], "file: must be an object, not a list; correct it"),
        ({"count": True}, "file, count: must be a whole number, not true or false"),
        ({"count": -1}, "file, count: must be at least 0; correct it"),
        ({"name": "abcd"}, "file, name: must have at most 3 characters"),
        (
            {"level": "mid"},
            "file, level: 'mid' is not allowed; choose one of low, high",
        ),
        ({"word": "c"}, "file, word: 'c' is not allowed; choose one of a, b"),
        ({"parts": {"a": SMALL, "b": {}}}, "file, parts.b: missing entry 'size'"),
        ({"parts": {"b": {"size": -2}}}, "parts.b.size: must be at least -1.5"),
        ({"parts": {"b": {"size": 1e9}}}, "parts.b.size: must be at most 1e+06"),
        ({"parts": {"b": {"size": float("nan")}}}, "parts.b.size: must be"),
        ({"parts": {"b": {"size": 10**400}}}, "parts.b.size: "),
        ({"parts": {"b": [1.0]}}, "parts.b: must have at least 2 entries"),
        ({"parts": {"b": [1.0, "2"]}}, "parts.b[1]: must be a number, not a text"),
        (
            {"parts": {"b": {**SMALL, "place": [1]}}},
            "parts.b.place: must have 2 entries",
        ),
        ({"parts": {"\x1b" * 99: 3}}, "parts.'\\x1b"),
        ({"x": 1}, "unknown entry 'x'; allowed: parts, count, level, word, name"),
        ({"x" * 999: 1}, "unknown entry 'xxx"),
        ({"x - at `$.count": 1}, "file"),
        ({"x - at `$.parts[...].y[3]": 1}, "file"),
        ({"x`\n'y - at `$.z": 1}, "file"),
    ],
)
def test_a_wrong_field_is_named(value, said):
    with pytest.raises(InputError) as refusal:
        convert(value, Whole, "file")
    assert said in str(refusal.value)
    assert len(str(refusal.value)) < 400


def test_error_and_remedy_can_be_given():
    with pytest.raises(SequenceError, match=r"^file, count: .*; import it again$"):
        convert({"count": "1"}, Whole, "file", SequenceError, "import it again")


def test_valid_values_are_typed():
    made = convert({"parts": {"a": {"size": 1}}, "level": "high"}, Whole, "file")
    assert made == Whole({"a": Part(1.0)}, level=Level.HIGH)


@pytest.mark.parametrize("value", [True, "1", None, [], 10**400, -(10**400), 1e999])
def test_a_value_that_is_not_a_finite_number_is_none(value):
    assert finite_number(value) is None


def test_a_finite_number_is_a_float():
    assert finite_number(3) == 3.0
    assert finite_number(float("nan")) is None
