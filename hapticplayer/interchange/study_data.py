"""The data of a study for exporters: answers, markers, and ticks of the device."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.sequence.files import Progress
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import Definition
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.session_setup import RECORD
from hapticplayer.study.steps import position_of

_MARKED = {
    "trial-begin": "begin",
    "trial": "end",
    "pause": "pause",
    "go-on": "go on",
    "repeat": "repeat",
    "skip": "skip",
    "resume": "resume",
    "end": "session end",
}
_WANTED = ("monotonic_s", "media_s", "force_n", "position_m")


@dataclass(frozen=True, slots=True)
class StudyData:
    """A study to be exported.

    Attributes:
        definition: of the study.
        answers: of all participants with answers.
        sessions: of the same participants.
        remarks: list to which exporters add what is damaged or left out.
        progress: called with the fraction done and the step; raises to cancel.
    """

    definition: Definition
    answers: Answers
    sessions: list[StoredSession]
    remarks: list[str]
    progress: Progress

    def ticks(self, session: StoredSession, path: Path) -> Iterator[NDArray[Any]]:
        """Yield the intact ticks of a session's record, with progress."""
        fraction = self.sessions.index(session) / len(self.sessions)
        for ticks in tick_chunks(path, self.remarks):
            self.progress(fraction, Message("writing {code}", code=session.code))
            yield ticks


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
    found = []
    for record in session.records.intact:
        if record.kind not in _MARKED:
            continue
        step = str(record.content.get("step") or "")
        parts = [step, _MARKED[record.kind], _condition_key(session, step)]
        found.append(Marker(record.monotonic_s, " ".join(filter(None, parts))))
    return found


def _condition_key(session: StoredSession, step: str) -> str:
    """Return the condition of a trial; empty for other steps."""
    position = position_of(step)
    return session.plan.order[position - 1].key if position else ""


def tick_files(session: StoredSession) -> list[Path]:
    """Return the records of the device, one for each run of the session."""
    pattern = RECORD.format(0).replace("00", "*")
    return sorted(session.folder.glob(pattern))


def tick_chunks(path: Path, remarks: list[str]) -> Iterator[NDArray[Any]]:
    """Yield the intact ticks of a record; damage is added to the remarks."""
    name = f"{path.parent.name}/{path.name}"
    try:
        with RecordReader(path) as reader:
            if not set(_WANTED) <= set(reader.dtype.names or ()):
                what = Message("lacks what is to be exported")
                remarks.append(joined(": ", (name, what)))
                return
            for frame in reader.frames():
                yield frame.ticks
            if reader.notice:
                remarks.append(joined(": ", (name, reader.notice)))
    except InputError as problem:
        remarks.append(joined(": ", (name, problem.what)))
