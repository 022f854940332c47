"""What is played in a trial other than of ratings, and what its answer says.

A two-interval trial plays a clip twice, with the standard and with another force, in an
order that seed, code, position and attempt decide. The levels of a staircase follow from
the answers before (Levitt 1971, transformed up-down): after two or three correct ones in
a row the change gets smaller, after a wrong one larger, so that it converges to where
71 or 79 % are correct. Nothing is kept beside the records: a session that is resumed
goes on at the right level.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model import ranges
from hapticplayer.study.definition import (
    CORRECT,
    Condition,
    Definition,
    FeedbackLevel,
    Staircase,
    TrialKind,
)
from hapticplayer.study.plan import Plan, number_of
from hapticplayer.study.questions import Fault
from hapticplayer.study.steps import AnsweredTrial

_INTERVALS = 4  # a stream of the seed, beside those of `orders`
_OF_TWO = 2
_LAST = 8
_LIMITS = {"delay_s": ranges.FORCE_DELAY_S, "gain": ranges.FORCE_GAIN}


@dataclass(frozen=True, slots=True)
class StaircaseTrack:
    """The course of a staircase.

    Attributes:
        changes: level of each trial so far, and of the next one.
        reversals: places in `changes` at which the direction changed.
    """

    changes: tuple[float, ...]
    reversals: tuple[int, ...]

    @property
    def threshold(self) -> float | None:
        """The geometric mean of the last reversals, at most eight.

        The first two are left out, and one more where peaks and valleys are not as
        many. None with fewer than four.
        """
        kept = self.reversals[_OF_TWO + len(self.reversals) % _OF_TWO :][-_LAST:]
        if len(kept) < _OF_TWO:
            return None
        return float(np.exp(np.mean([np.log(self.changes[one]) for one in kept])))


def track_of(rule: Staircase, correct: Iterable[bool]) -> StaircaseTrack:
    """The course of a staircase after some answers."""
    changes, reversals = [rule.start], list[int]()
    in_row, direction = 0, 0
    for place, is_correct in enumerate(correct):
        in_row = in_row + 1 if is_correct else 0
        turn = 0 if 0 < in_row < rule.correct else (-1 if is_correct else 1)
        if turn:
            in_row = 0
            if turn == -direction:
                reversals.append(place)
            direction = turn
        step = rule.steps[min(len(reversals), len(rule.steps) - 1)]
        level = changes[-1] + turn * step
        changes.append(round(min(max(level, rule.steps[-1]), rule.start), 9))
    return StaircaseTrack(tuple(changes), tuple(reversals))


def converges_to(rule: Staircase) -> float:
    """The share of correct answers at which a staircase settles."""
    return float(0.5 ** (1.0 / rule.correct))


def presented(
    definition: Definition,
    plan: Plan,
    position: int,
    attempt: int,
    before: Iterable[AnsweredTrial] = (),
) -> tuple[Condition, ...]:
    """What is played in a trial: a condition, or the two of two intervals.

    Args:
        definition: of the session.
        plan: of the session.
        position: of the trial, from 1.
        attempt: at it, from 1.
        before: the answered trials of the session.
    """
    condition, standard = plan.order[position - 1], definition.standard
    if standard is None:
        return (condition,)
    delay_s, gain = condition.delay_s, condition.gain
    if (rule := definition.staircase) is not None:
        others = [one for one in before if one.position != position]
        change = track_of(rule, correct_answers(definition, others, condition))
        delay_s, gain = _changed(standard, rule, change.changes[-1])
    sequence = condition.sequence
    pair = (
        Condition(sequence, condition.feedback, delay_s, gain),
        Condition(sequence, standard.feedback, standard.delay_s, standard.gain),
    )
    of = [definition.order.seed, _INTERVALS, number_of(plan.code), position, attempt]
    is_first = bool(np.random.default_rng(of).integers(2))
    return pair if is_first else pair[::-1]


def _changed(
    standard: FeedbackLevel, rule: Staircase, change: float
) -> tuple[float, float]:
    if rule.changes == "delay_s":
        return round(standard.delay_s + change, 9), standard.gain
    return standard.delay_s, round(standard.gain + change, 9)


def correct_answers(
    definition: Definition, trials: Iterable[AnsweredTrial], of: Condition
) -> list[bool]:
    """Whether the other force was chosen, in valid trials of a sequence and feedback."""
    found = {
        one.position: is_chosen
        for one in trials
        if one.is_valid
        and (one.condition.sequence, one.condition.feedback)
        == (of.sequence, of.feedback)
        and (is_chosen := judged(definition, one)) is not None
    }
    return [bool(one) for one in found.values()]


def compared(definition: Definition, trial: AnsweredTrial) -> FeedbackLevel | None:
    """The force that was compared with the standard, or that was judged alone."""
    standard = definition.standard
    if standard is None:
        return trial.condition.level
    others = [one for one in trial.presented if one != standard]
    is_whole = len(trial.presented) == _OF_TWO and len(others) == 1
    return others[0] if is_whole else None


def played_as(
    definition: Definition, trial: AnsweredTrial
) -> tuple[FeedbackLevel, int | None]:
    """The force that was judged, and which of two clips had it; None of one."""
    force = compared(definition, trial)
    if force is None or not trial.presented:
        return force or trial.condition.level, None
    return force, 1 + trial.presented.index(force)


def judged(definition: Definition, trial: AnsweredTrial) -> bool | float | None:
    """What the answer says: yes or no, a number, or whether the standard was not chosen.

    None without an answer, or without a record of what was played.
    """
    asked = definition.judgement
    value = None if asked is None else trial.values.get(asked.key)
    if asked is None or value is None or definition.trial is not TrialKind.TWO_INTERVAL:
        return value
    other = compared(definition, trial)
    keys = [one.key for one in asked.choices]
    if other is None or value not in keys:
        return None
    return trial.presented[keys.index(value)] == other


_QUESTION = {
    TrialKind.YES_NO: Message("has no yes-or-no question after a clip"),
    TrialKind.TWO_INTERVAL: Message("has no choice of one answer after the clips"),
    TrialKind.MAGNITUDE: Message("has no question for a number after a clip"),
}


def faults_of_trials(made: Definition) -> Iterator[Fault]:
    """What trials other than of ratings lack."""
    if (asked := made.judgement) is None:
        yield "pages", _QUESTION[made.trial], Message("add one: it is analysed")
    if made.trial is not TrialKind.TWO_INTERVAL:
        return
    if made.while_watching:
        what = Message("is not used in {kind} trials", kind=made.trial.value)
        yield "while_watching", what, Message("remove it")
    if asked is not None and len(asked.choices) != _OF_TWO:
        what = Message("the answers to {key!r} must be two: the clips", key=asked.key)
        yield "pages", what, Message("offer the first and the second clip")
    if made.standard is None:
        what = Message("is missing: what the other force is compared with")
        yield "standard", what, Message("enter a feedback")
    elif made.standard.feedback not in made.feedback_keys:
        known = ", ".join(made.feedback_keys)
        what = Message("{key!r} is not a feedback", key=made.standard.feedback)
        remedy = Message("choose one of {known}", known=known)
        yield "standard.feedback", what, remedy
    elif made.staircase is not None:
        yield from _faults_of_staircase(made.standard, made.staircase)


def _faults_of_staircase(standard: FeedbackLevel, rule: Staircase) -> Iterator[Fault]:
    if not 0.0 < rule.steps[-1] <= rule.start:
        what = Message("the last step must be above 0 and not above the first change")
        yield "staircase.steps", what, CORRECT
    if getattr(standard, rule.changes) + rule.start > _LIMITS[rule.changes].largest:
        most = _LIMITS[rule.changes].largest
        what = Message("{name} would be above {most:g}", name=rule.changes, most=most)
        yield "staircase.start", what, CORRECT
