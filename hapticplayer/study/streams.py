"""Streams of a session for other programs, while it runs; extras have them."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol, cast

import numpy as np
from numpy.typing import NDArray

from hapticplayer import extension
from hapticplayer.errors import StudyError
from hapticplayer.study.definition import Condition
from hapticplayer.study.journal import JournalRecord
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import FIRST_FRAME, MARKED, marker_text


class Observer(Protocol):
    """Receives events for other programs, without answers and codes."""

    def marker(self, text: str, monotonic_s: float) -> None:
        """Receive an event."""

    def force(
        self, monotonic_s: NDArray[np.float64], force_n: NDArray[np.float32]
    ) -> None:
        """Receive forces (N, 3) sent to the device, with their times (N,), s."""

    def check(self) -> None:
        """Raise StudyError why a trial may not begin."""


class StudyStream(Observer, Protocol):
    """An observer that is open until `close`."""

    def begin(self, session: StoredSession) -> None:
        """Prepare for a session, before anything happens in it."""

    def close(self) -> None:
        """End the stream."""


class Markers:
    """Tells an observer what happens in a session, with the times of its records."""

    def __init__(self, observer: Observer | None, order: Sequence[Condition]) -> None:
        self._observer, self._order = observer, order
        self._shown_s: float | None = None  # of the first frame that was told

    def record(self, record: JournalRecord) -> None:
        """Tell a record of a kind that has a marker."""
        if record.kind in MARKED:
            step = str(record.content.get("step") or "")
            text = marker_text(step, MARKED[record.kind], self._order)
            self.mark(text, record.monotonic_s)

    def first_frame(self, step: str, shown_s: float | None) -> None:
        """Tell once when the first frame of a clip was shown, if it was."""
        if shown_s is not None and shown_s != self._shown_s:
            self._shown_s = shown_s
            self.mark(marker_text(step, FIRST_FRAME, self._order), shown_s)

    def check(self) -> None:
        if self._observer is not None:
            self._observer.check()

    def mark(self, text: str, monotonic_s: float) -> None:
        if self._observer is not None:
            self._observer.marker(text, monotonic_s)


class Wanted(NamedTuple):
    """What has to be there besides: names of streams, a recorder, its port."""

    streams: tuple[str, ...] = ()
    recorder: bool = False
    port: int = 22345


class StreamKind(NamedTuple):
    """A way to stream.

    Attributes:
        name: of an option and in the definition of a study.
        home: "module:function", called with `Wanted`, returns a `StudyStream`.
    """

    name: str
    home: str


def open_stream(name: str, wanted: Wanted) -> StudyStream:
    for kind in extension.rows("study_streams", StreamKind):
        if kind.name == name:
            return cast(StudyStream, extension.load(kind.home)(wanted))
    raise StudyError(
        "this installation has no streams of the kind {name!r}; leave them out",
        name=name,
    )
