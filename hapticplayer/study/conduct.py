"""How a study was conducted: sessions, orders, times to answer, and playback."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from hapticplayer.study.definition import Definition
from hapticplayer.study.orders import balance_of
from hapticplayer.study.session_folder import SessionState, StoredSession
from hapticplayer.study.steps import answered_trials
from hapticplayer.study.trial_force import TrialForce
from hapticplayer.study.trial_forces import TrialKey


@dataclass(frozen=True, slots=True)
class AnsweredPlayback:
    """The playback of a trial whose answers were stored, including repeated ones.

    Attributes:
        feedback: of its condition.
        attempt: from 1; more if the trial was repeated.
        is_valid: whether the playback was without a fault.
        response_s: from page to answer, s; None if not measured.
        figures: of the playback, see `stage`; empty if there are none.
        trial: code of the participant, position and condition, for people.
        trial_force: what the hand got; None without a record, or if it was not read.
        reasons: why it was not valid.
    """

    feedback: str
    attempt: int
    is_valid: bool
    response_s: float | None = None
    figures: Mapping[str, Any] = field(default_factory=dict)
    trial: str = ""
    trial_force: TrialForce | None = None
    reasons: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Conduct:
    """How a study was conducted; empty for answers that are not of a folder.

    Attributes:
        title: of the study, for people.
        identifier: of the study.
        dates: ISO dates (UTC) of the first and last session.
        programs: versions with which sessions were recorded.
        sessions: number of sessions with answers.
        complete: how many of them were completed.
        order_method: how orders were made.
        at_position: smallest and largest count of a condition at a position.
        followed: smallest and largest count of a condition after another one.
        playbacks: of all trials with answers.
        feedbacks: what each is, by key.
        mean_positions: of the trials with each level of the sequences' factors.
    """

    title: str = ""
    identifier: str = ""
    dates: tuple[str, ...] = ()
    programs: tuple[str, ...] = ()
    sessions: int = 0
    complete: int = 0
    order_method: str = ""
    at_position: tuple[int, int] = (0, 0)
    followed: tuple[int, int] = (0, 0)
    playbacks: tuple[AnsweredPlayback, ...] = ()
    feedbacks: Mapping[str, str] = field(default_factory=dict)
    mean_positions: Mapping[str, float] = field(default_factory=dict)


def conduct_of(
    definition: Definition,
    sessions: Iterable[StoredSession],
    trial_forces: Mapping[str, Mapping[TrialKey, TrialForce]] | None = None,
) -> Conduct:
    """Return how a study was conducted.

    Args:
        definition: of the study.
        sessions: with answers.
        trial_forces: measured force per trial, by code.
    """
    by_code = trial_forces or {}
    sessions = list(sessions)
    dates = sorted(one.plan.created_utc[:10] for one in sessions)
    balance = balance_of(definition, [one.plan.order for one in sessions])
    return Conduct(
        title=definition.title,
        identifier=definition.id,
        dates=(dates[0], dates[-1]) if dates else (),
        programs=tuple(sorted({one.plan.program for one in sessions})),
        sessions=len(sessions),
        complete=sum(one.state is SessionState.COMPLETE for one in sessions),
        order_method=definition.order.method.value,
        at_position=balance.times_at_each_position(),
        followed=balance.times_after_each_other(),
        playbacks=tuple(
            AnsweredPlayback(
                trial.condition.feedback,
                trial.attempt,
                trial.is_valid,
                trial.response_s,
                trial.playback if isinstance(trial.playback, dict) else {},
                f"{one.code} {trial.position} ({trial.condition.key})",
                by_code.get(one.code, {}).get((trial.position, trial.attempt)),
                trial.reasons,
            )
            for one in sessions
            for trial in answered_trials(one.records)
        ),
        feedbacks={one.name: one.text for one in definition.chosen_feedbacks},
        mean_positions=_mean_positions(definition, sessions),
    )


def _mean_positions(
    definition: Definition, sessions: Iterable[StoredSession]
) -> dict[str, float]:
    """The mean place in the orders of each level of the sequences' factors."""
    found: dict[str, list[int]] = {}
    levels = {one.key: one.factors.values() for one in definition.sequences}
    for session in sessions if definition.sequence_factors else ():
        for position, condition in enumerate(session.plan.order, 1):
            for level in levels.get(condition.sequence, ()):
                found.setdefault(level, []).append(position)
    return {level: sum(each) / len(each) for level, each in found.items()}
