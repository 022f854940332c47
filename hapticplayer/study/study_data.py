"""The data of a study for exporters: answers, markers, and ticks of the device."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from hapticplayer.errors import Message, Progress
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import Definition
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import FIRST_FRAME, INTERVAL, MARKED, marker_text
from hapticplayer.study.ticks import tick_chunks
from hapticplayer.study.trial_force import TrialForce
from hapticplayer.study.trial_forces import TrialKey, measure_trial_forces

if TYPE_CHECKING:
    from hapticplayer.study.live_ratings import RatingTrack


@dataclass(frozen=True, slots=True)
class StudyData:
    """A study to be exported.

    Attributes:
        definition: of the study.
        answers: of all participants with answers.
        sessions: of the same participants.
        notices: list to which exporters add what is damaged or left out.
        progress: called with the fraction done and the step; raises to cancel.
    """

    definition: Definition
    answers: Answers
    sessions: list[StoredSession]
    notices: list[str]
    progress: Progress

    def ticks(self, session: StoredSession, path: Path) -> Iterator[NDArray[Any]]:
        """Yield the intact ticks of a session's record, with progress."""
        fraction = self.sessions.index(session) / len(self.sessions)
        for ticks in tick_chunks(path, self.notices):
            self.progress(fraction, Message("writing {code}", code=session.code))
            yield ticks

    def ratings(self, session: StoredSession) -> "list[RatingTrack]":
        """What was rated in a session while its clips played."""
        from hapticplayer.study.live_ratings import read_ratings  # few studies have it

        return read_ratings(session, self.notices)

    def trial_forces(self, session: StoredSession) -> dict[TrialKey, TrialForce]:
        """The measured force per trial of a session that has a record."""
        fraction = self.sessions.index(session) / len(self.sessions)
        step = Message("reading records of {code}", code=session.code)
        self.progress(fraction, step)
        return measure_trial_forces(session, self.notices)


@dataclass(frozen=True, slots=True)
class Marker:
    """An event of a session, without answers.

    Attributes:
        monotonic_s: of the machine's clock.
        text: such as `trial-03 begin bike/random`; each marker of a trial names its
            condition.
    """

    monotonic_s: float
    text: str


def markers_of(session: StoredSession) -> list[Marker]:
    """Return the events of a session, in order of time within each run."""
    found: list[Marker] = []
    begun = 0
    for record in session.records.intact:
        if record.kind not in MARKED:
            continue
        step = str(record.content.get("step") or "")
        if record.kind == "trial-begin":
            begun = len(found) + 1
        shown_s = record.content.get("playback", {}).get("first_frame_mono_s")
        if record.kind in ("trial", INTERVAL) and shown_s is not None:
            text = marker_text(step, FIRST_FRAME, session.plan.order)
            found.insert(begun, Marker(shown_s, text))
        text = marker_text(step, MARKED[record.kind], session.plan.order)
        found.append(Marker(record.monotonic_s, text))
        if record.kind == INTERVAL:  # behind it comes the second clip
            begun = len(found)
    return found
