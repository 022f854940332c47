"""When the effects of MPEG-V act: groups, references, activation, seconds.

An effect has the attributes of its group where it has none of its own. A reference is the
declared effect with the reference's own attributes. Times in a declared group, and those
that all lie before the time of their group, count from its begin. An effect without a duration lasts until
the next one of its kind and place, `activate="false"` among them, as PlaySEM writes them;
PlaySEM also counts durations in seconds whatever the time scale is.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple
from xml.etree.ElementTree import Element

from hapticplayer.errors import InputError, Message
from hapticplayer.model.limits import MAX_SECONDS
from hapticplayer.untrusted import ANOTHER

_XSI = "{http://www.w3.org/2001/XMLSchema-instance}type"
_SI = "{urn:mpeg:mpeg21:2003:01-DIA-XSI-NS}"
_INHERITED = (
    *("activate", "duration", "fade", "location", "position"),
    *("intensity", "intensity-value", "intensity-range"),
)
_KINESTHETIC = ("PassiveKinestheticForce", "ActiveKinesthetic", "RigidBodyMotion")
_TIMES = ("pts", "timestamp")
_OTHER_TIMES = (
    *("ptsDelta", "absTime", "absTimeDelta", "relTime"),
    *("start", "startTime", "begin", "time"),
)
_MAX_DEPTH = 8
_UNDERSTOOD = {
    *(*_INHERITED, *_TIMES, "timeScale", "type", "uri"),
    *("id", "lang", "schemaLocation", "noNamespaceSchemaLocation"),  # change no force
    *("timeSamples", "autoExtraction"),  # as the reader says
}

SHORT_S = 0.02
"""Nobody feels a vibration of less than a period."""


class Attributes(NamedTuple):
    """Attributes of an element, with and without their namespaces.

    Attributes:
        values: by name.
        where: the file, for errors.
    """

    values: dict[str, str]
    where: str

    def number(self, name: str, default: float, least: float, most: float) -> float:
        text = self.values.get(name)
        try:
            value = default if text is None else number_in(text)
        except ValueError:
            raise self.refusal(
                Message("{name} must be a number, not {text!r}", name=name, text=text)
            ) from None
        if not least <= value <= most:
            raise self.refusal(Message("{name} is out of range", name=name))
        return value

    def flag(self, name: str) -> bool:
        """Whether it is true; an absent one is."""
        text = self.values.get(name, "true").strip().lower()
        if text not in ("true", "false", "1", "0"):
            raise self.refusal(Message("{name} must be true or false", name=name))
        return text in ("true", "1")

    def refusal(self, what: Message) -> InputError:
        return InputError(what, where=self.where, remedy=ANOTHER)


class _SemPlace(NamedTuple):
    """Where an element stands.

    Attributes:
        given: what it has from its groups.
        scale: ticks in a second.
        begin_s: of its group, if that has a time.
        base_s: what its own time counts from.
        depth: of nesting.
    """

    given: dict[str, str]
    scale: float = 1000.0
    begin_s: float | None = None
    base_s: float = 0.0
    depth: int = 0


@dataclass(slots=True)
class SemEffect:
    """An effect, and when it acts.

    Attributes:
        kind: without its namespace and the ending `Type`.
        element: with its parameters.
        attributes: its own, and those of its group and reference.
        begin_s: in media time.
        length_s: None until something ends it.
        fade_s: until it has its level.
        release_s: from its end until nothing is left.
        rise_from: share of its level at the begin of the fade.
    """

    kind: str
    element: Element
    attributes: Attributes
    begin_s: float
    length_s: float | None
    fade_s: float = 0.0
    release_s: float = 0.0
    rise_from: float = 0.0

    @property
    def place(self) -> tuple[str, str]:
        """What an effect without a duration is replaced by: the next of these."""
        return self.kind, self.attributes.values.get("location", "")

    @property
    def is_beyond(self) -> bool:
        """Whether its intensity is outside of its range."""
        return not 0.0 <= self._share() <= 1.0

    @property
    def level(self) -> float:
        """Intensity as a share of its range, 0 to 1."""
        return min(1.0, max(0.0, self._share()))

    def _share(self) -> float:
        span = self.attributes.values.get("intensity-range", "0 100").split()
        try:
            least, most = (number_in(text) for text in span)
        except ValueError:
            least = most = 0.0
        if not least < most:
            raise self.attributes.refusal(
                Message("{name} is out of range", name="intensity-range")
            )
        names = ("intensity", "intensity-value")
        name = next((one for one in names if one in self.attributes.values), names[1])
        value = self.attributes.number(name, 0.0, -1e6, 1e6)
        if least < 0.0:
            return abs(value) / max(most, -least)
        return (value - least) / (most - least)


class EffectTimes:
    """Finds the effects of a file with their times.

    Args:
        where: the file, for errors.
        until_s: end of the clip, if it is known.
        most: effects that are taken; references repeat them.

    Attributes:
        assumed: what was taken for what.
        unread: how often each thing was not understood.
    """

    def __init__(self, where: str, until_s: float, most: int) -> None:
        self._where, self._until_s, self._left = where, until_s, most
        self._declared: dict[str, Element] = {}
        self._has_other_clock = False
        self.assumed: dict[Message, None] = {}
        self.unread: Counter[str] = Counter()

    def effects(self, root: Element) -> list[SemEffect]:
        """Those that act, in the order of their begin."""
        for element in root.iter():
            if name_of(element.tag) == "Declarations":
                self._declare(element)
        self._is_other(root, "SEM")
        self.list_attributes(root, _UNDERSTOOD)
        found = list(self._inside(root, _SemPlace({})))
        if found and not any("timeScale" in _attributes_of(x) for x in root.iter()):
            self.assumed[Message("times were taken as milliseconds")] = None
        if self._counts_seconds(found):
            self.assumed[Message("durations were taken as seconds, as in PlaySEM")] = (
                None
            )
        else:
            for one in found:
                scale = one.attributes.number("timeScale", 1000.0, 1.0, 1e9)
                one.length_s = None if one.length_s is None else one.length_s / scale
        self._refuse_late(found)
        return self._ended(sorted(found, key=lambda one: one.begin_s))

    def _declare(self, declarations: Element) -> None:
        for element in declarations.iter():
            name = element.get("id") or element.get(f"{_SI}id")
            if name:
                self._declared[name] = element

    def _inside(self, parent: Element, place: _SemPlace) -> Iterator[SemEffect]:
        """Yield the effects of an element; lengths are still in ticks."""
        own = Attributes(_attributes_of(parent), self._where)
        scale = own.number("timeScale", place.scale, 1.0, 1e9)
        for element in parent:
            yield from self._one(element, place._replace(scale=scale))

    def _one(
        self, element: Element, place: _SemPlace, declared_s: float | None = None
    ) -> Iterator[SemEffect]:
        name = name_of(element.tag)
        self._left -= 1
        if self._left < 0 or place.depth > _MAX_DEPTH:
            what = Message("holds too many values")
            raise InputError(what, where=self._where, remedy=ANOTHER)
        if name in ("Declarations", "Parameter") or self._is_other(element, name):
            return
        self.list_attributes(element, _UNDERSTOOD)
        own = _attributes_of(element)
        merged = Attributes({**place.given, **own}, self._where)
        place = place._replace(scale=merged.number("timeScale", place.scale, 1.0, 1e9))
        begin_s = self._begin_s(own, place)
        if begin_s is not None and begin_s < (place.begin_s or 0.0):
            self.unread["a time before that of its group"] += 1
            return
        place = place._replace(begin_s=begin_s)
        if name == "ReferenceEffect":
            yield from self._referred(own, place)
        elif name == "Effect":
            if place.begin_s is None:
                self.assumed[Message("effects without a time begin at 0 s")] = None
            yield self._effect(element, merged, place.scale, place.begin_s or 0.0)
        else:
            passed = {k: v for k, v in merged.values.items() if k in _INHERITED}
            place = place._replace(given=passed, depth=place.depth + 1)
            place = place._replace(base_s=self._base_s(element, place, declared_s))
            yield from self._inside(element, place)

    def list_attributes(self, element: Element, understood: set[str]) -> None:
        """List those that are not understood."""
        for name in _attributes_of(element).keys() - understood:
            self.unread[f"{name[:40]} of {name_of(element.tag)[:40]}"] += 1

    def _is_other(self, element: Element, name: str) -> bool:
        """Whether an element has times that are not understood, which are listed."""
        own = _attributes_of(element).keys()
        is_other = not own & set(_TIMES) and bool(own & set(_OTHER_TIMES))
        if is_other:
            self.unread[f"{name} with another time"] += 1
        return is_other

    def _begin_s(self, own: dict[str, str], place: _SemPlace) -> float | None:
        """The time of an element itself, else that of its group."""
        begin_s = place.begin_s
        for time in _TIMES:
            if time in own:
                given = Attributes(own, self._where).number(time, 0.0, 0.0, 1e15)
                begin_s = place.base_s + given / place.scale
                self._has_other_clock |= time == "timestamp"
        return begin_s

    def _base_s(
        self, group: Element, place: _SemPlace, declared_s: float | None
    ) -> float:
        """What the times in a group count from."""
        begin_s = place.begin_s
        times_s = [
            Attributes(own, self._where).number(time, 0.0, 0.0, 1e15) / place.scale
            for own in map(_attributes_of, group)
            for time in _TIMES
            if time in own
        ]
        if begin_s is None or not times_s:
            return place.base_s
        if declared_s is not None:
            said = Message("times in a declared group count from its reference")
            self.assumed[said] = None
            return begin_s - (declared_s if min(times_s) >= declared_s else 0.0)
        if max(times_s) + place.base_s >= begin_s:
            return place.base_s
        said = Message("times before that of their group count from it")
        self.assumed[said] = None
        return begin_s

    def _referred(self, own: dict[str, str], place: _SemPlace) -> Iterator[SemEffect]:
        """The effects that a reference plays."""
        meant = self._declared.get(own.get("uri", "").rpartition("#")[2])
        if meant is None:
            self.unread["ReferenceEffect"] += 1
            return
        its_own = Attributes(_attributes_of(meant), self._where)
        known = _UNDERSTOOD - {"id", "uri", "type"}
        kept = {k: v for k, v in own.items() if k in known}
        attributes, declared_s = {**its_own.values, **kept}, None
        if place.begin_s is not None:
            scale = its_own.number("timeScale", place.scale, 1.0, 1e9)
            declared_s = max(its_own.number(time, 0.0, 0.0, 1e15) for time in _TIMES)
            declared_s /= scale
            attributes = {k: v for k, v in attributes.items() if k not in _TIMES}
        made = Element(meant.tag, attributes)
        made.extend(meant)
        yield from self._one(made, place._replace(depth=place.depth + 1), declared_s)

    def _effect(
        self, element: Element, attributes: Attributes, scale: float, begin_s: float
    ) -> SemEffect:
        kind = element.get(_XSI, element.get("type", "")).rpartition(":")[2]
        kind = kind.removesuffix("Type")
        length = attributes.number("duration", -1.0, -1.0, 1e15)
        attributes.values["timeScale"] = str(scale)
        return SemEffect(
            kind[:1].upper() + kind[1:],
            element,
            attributes,
            begin_s,
            length if length > 0.0 else None,
            attributes.number("fade", 0.0, 0.0, 1e15) / scale,
        )

    def _counts_seconds(self, found: list[SemEffect]) -> bool:
        """Whether durations make sense as seconds only."""
        timed = [one for one in found if one.length_s is not None]
        if self._has_other_clock or any(one.kind in _KINESTHETIC for one in found):
            return False
        scales = [one.attributes.number("timeScale", 1.0, 1.0, 1e9) for one in timed]
        ticks = [one.length_s or 0.0 for one in timed]
        if not timed or max(map(float.__truediv__, ticks, scales)) >= SHORT_S:
            return False
        begins: dict[tuple[str, str], list[tuple[float, float]]] = {}
        for one, seconds in zip(timed, ticks, strict=True):
            begins.setdefault(one.place, []).append((one.begin_s, seconds))
        return all(
            begin_s + seconds <= later_s
            for spans in map(sorted, begins.values())
            for (begin_s, seconds), (later_s, _) in pairwise(spans)
        )

    def _refuse_late(self, found: list[SemEffect]) -> None:
        for one in found:
            if one.begin_s + (one.length_s or 0.0) + one.fade_s > MAX_SECONDS:
                what = Message("an effect lies outside of any clip")
                raise InputError(what, where=self._where, remedy=ANOTHER)

    def _ended(self, found: list[SemEffect]) -> list[SemEffect]:
        """Those that act, ended by what follows them."""
        kept: list[SemEffect] = []
        running: dict[tuple[str, str], list[SemEffect]] = {}
        for one in found:
            is_on = one.attributes.flag("activate")
            if not is_on and "location" not in one.attributes.values:
                for place in [other for other in running if other[0] == one.kind]:
                    _end(running.pop(place), one, is_on=False)
                continue
            others = running.setdefault(one.place, [])
            _end(others, one, is_on=is_on)
            others[:] = [] if not is_on else [*_still(others, one.begin_s), one]
            if is_on:
                kept.append(one)
        for one in kept:
            if one.length_s is None and one.begin_s < self._until_s < float("inf"):
                one.length_s = self._until_s - one.begin_s
            elif one.length_s is None:
                self.unread[f"{one.kind or '?'} without an end"] += 1
        return [one for one in kept if one.length_s]


def number_in(text: str) -> float:
    """The number of an attribute; raises ValueError."""
    if "_" in text or not text.isascii():  # Python's own digits
        raise ValueError(text)
    return float(text)


def name_of(tag: str) -> str:
    """A name without its namespace."""
    return tag.rpartition("}")[2]


def _attributes_of(element: Element) -> dict[str, str]:
    """Attributes without namespaces; those of the time prefix count first."""
    plain = {name_of(name): text for name, text in element.attrib.items()}
    timed = [one for one in element.attrib.items() if one[0].startswith(_SI)]
    return plain | {name_of(name): text for name, text in timed}


def _share(before: SemEffect, after: SemEffect) -> float:
    """How much of the level of an effect the one before it had."""
    if before.kind != "Vibration" or after.level <= 0.0:
        return 0.0
    return before.level / after.level


def _end(others: list[SemEffect], one: SemEffect, *, is_on: bool) -> None:
    """End what an effect replaces, or switches off."""
    for other in others:
        end_s = other.begin_s + (other.length_s or 0.0)
        if other.length_s is None or (not is_on and end_s > one.begin_s):
            other.length_s = one.begin_s - other.begin_s
            other.release_s = 0.0 if is_on else one.fade_s
            one.rise_from = _share(other, one) if is_on else 0.0


def _still(effects: list[SemEffect], at_s: float) -> list[SemEffect]:
    return [one for one in effects if one.begin_s + (one.length_s or 0.0) > at_s]
