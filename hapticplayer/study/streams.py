"""Streams of a session for other programs, while it runs; extras have them."""

from typing import NamedTuple, Protocol, cast

import numpy as np
from numpy.typing import NDArray

from hapticplayer import extension
from hapticplayer.errors import StudyError


class Observer(Protocol):
    """Receives events for other programs, without answers and codes."""

    def marker(self, text: str, monotonic_s: float) -> None:
        """Receive an event."""

    def force(
        self, monotonic_s: NDArray[np.float64], force_n: NDArray[np.float32]
    ) -> None:
        """Receive forces (N, 3) sent to the device, with their times (N,), s."""


class StudyStream(Observer, Protocol):
    """An observer that is open until `close`."""

    def close(self) -> None:
        """End the stream."""


class StreamKind(NamedTuple):
    """A way to stream.

    Attributes:
        name: of an option and in the definition of a study.
        home: "module:function", called without arguments, returns a `StudyStream`.
    """

    name: str
    home: str


def open_stream(name: str) -> StudyStream:
    """A stream of that kind."""
    for kind in extension.rows("study_streams", StreamKind):
        if kind.name == name:
            return cast(StudyStream, extension.load(kind.home)())
    raise StudyError(
        "this installation has no streams of the kind {name!r}; leave them out",
        name=name,
    )
