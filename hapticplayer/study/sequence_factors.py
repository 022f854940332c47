"""What may be declared of factors in which the sequences of a study differ."""

from collections.abc import Iterator

from hapticplayer.errors import Message
from hapticplayer.structures import missing
from hapticplayer.study.definition import Definition, TrialKind
from hapticplayer.study.questions import Fault

MOST_LEVELS = 6
_OF_ANALYSIS = ("feedback", "measure", "all")
"""Which effects, figures and rows of the analysis are named by."""


def faults(made: Definition) -> Iterator[Fault]:
    """What is wrong with the factors of a study."""
    if made.trial is not TrialKind.RATING:
        what = Message("is not used in {kind} trials", kind=made.trial.value)
        yield "sequences[0].factors", what, Message("remove it")
    taken = {*_OF_ANALYSIS, *made.languages, *made.feedback_keys}
    taken |= {one.key for one in made.sequences}
    divided: list[tuple[int, ...]] = []
    for name, levels in made.sequence_factors.items():
        for number, level in enumerate(levels):
            if not level:
                yield f"sequences[{number}].factors", *missing(name)
        known = list(dict.fromkeys(filter(None, levels)))
        field = f"sequences[0].factors.{name}"
        for one in (name, *known):
            if one in taken:
                what = Message("{name!r} is the name of something else", name=one)
                yield field, what, Message("choose another name")
        taken.update((name, *known))
        if not 2 <= len(known) <= MOST_LEVELS:
            what = Message(
                "must have 2 to {most} levels, has {count}",
                most=MOST_LEVELS,
                count=len(known),
            )
            yield field, what, Message("give the sequences different levels")
        parts = tuple(levels.index(level) for level in levels)
        if parts in divided:
            what = Message("divides the sequences as another factor does")
            yield field, what, Message("remove one of them")
        divided.append(parts)
