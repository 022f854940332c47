"""What may be declared of ratings while a clip plays: entries, limits, what moves them."""

import re
from collections.abc import Iterator

from hapticplayer.errors import Message
from hapticplayer.structures import missing
from hapticplayer.study.definition import Definition, LiveRating, RatingKind
from hapticplayer.study.questions import Fault

MOVERS = ("mouse", "wheel", "keys")
AXES = (
    *("grip-x", "grip-y", "grip-z"),
    *("joystick-x", "joystick-y", "joystick-z", "joystick-throttle"),
)
_HOLD = re.compile("[a-z]|enter|shift|control")

_RANGE = ("least", "most", "stop_at", "rest")
USES = {
    RatingKind.SLIDER: (*_RANGE, "labels", "by"),
    RatingKind.NUMBER: (*_RANGE, "every_s", "spoken"),
    RatingKind.HELD_KEY: ("hold",),
}
"""Entries that only some kinds have."""
_NEEDS = {
    RatingKind.SLIDER: ("least", "most", "by"),
    RatingKind.NUMBER: ("least", "most", "every_s"),
    RatingKind.HELD_KEY: ("hold",),
}
_CORRECT = Message("correct it")


def faults(made: Definition) -> Iterator[Fault]:
    """What is wrong with the ratings of a study."""
    ratings = made.while_watching
    if made.standard is not None:
        what = Message("is not used in {kind} trials", kind=made.trial.value)
        yield "while_watching", what, Message("remove it")
    for number, one in enumerate(ratings):
        for name, what, remedy in _faults_of(one):
            yield f"while_watching[{number}].{name}", what, remedy
    taken: set[str] = set()
    for number, one in enumerate(ratings):
        for used in (*one.by, *([f"key {one.hold}"] if one.hold else [])):
            if used in taken:
                what = Message("{used!r} is used by another rating", used=used)
                remedy = Message("choose another one")
                name = "hold" if one.hold else "by"
                yield f"while_watching[{number}].{name}", what, remedy
            taken.add(used)


def _faults_of(one: LiveRating) -> Iterator[Fault]:
    every = dict.fromkeys(name for names in USES.values() for name in names)
    for name in every:
        given = getattr(one, name)
        if given not in (None, (), False) and name not in USES[one.kind]:
            what = Message("is not used in ratings by {kind}", kind=one.kind.value)
            yield name, what, Message("remove it")
    for name in _NEEDS[one.kind]:
        if getattr(one, name) in (None, ()):
            yield name, *missing(name)
    if one.hold is not None and not _HOLD.fullmatch(one.hold):
        what = Message("must be a letter from a to z, enter, shift or control")
        yield "hold", what, _CORRECT
    yield from _mover_faults(one)
    if one.kind is RatingKind.NUMBER and (one.least or 0) < 0:
        yield "least", Message("must be at least {limit}", limit=0), _CORRECT
    if one.least is not None and one.most is not None:
        yield from _range_faults(one, one.least, one.most)
    if one.rest is not None and one.stop_at is None:
        yield "rest", Message("is not used without stop_at"), Message("remove it")


def _mover_faults(one: LiveRating) -> Iterator[Fault]:
    for name in one.by:
        if name not in (*MOVERS, *AXES):
            known = ", ".join((*MOVERS, *AXES))
            what = Message("{name!r} moves no slider", name=name)
            yield "by", what, Message("choose one of {known}", known=known)
    if len(set(one.by).intersection(AXES)) > 1:
        yield "by", Message("has two axes"), Message("remove one of them")


def _range_faults(one: LiveRating, least: int, most: int) -> Iterator[Fault]:
    if least >= most:
        yield "most", Message("must be more than least"), _CORRECT
    points = [("stop_at", one.stop_at)]
    points += [(f"labels[{n}].at", label.at) for n, label in enumerate(one.labels)]
    for name, at in points:
        if at is not None and not least <= at <= most:
            text = "must be between {least} and {most}"
            yield name, Message(text, least=least, most=most), _CORRECT


def start_of(one: LiveRating) -> float:
    """Where a slider stands when a clip begins: at 0 if that is in its range."""
    least, most = one.least or 0, one.most or 0
    return float(min(max(0, least), most))
