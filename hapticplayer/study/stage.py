"""What a session needs of the stage where its trials are played."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

from hapticplayer.study.definition import Condition


@dataclass(frozen=True, slots=True)
class PlaybackResult:
    """The playback of a trial.

    Attributes:
        is_valid: whether it was valid.
        reasons: why it was not, a keyword each.
        playback: figures for the record.
    """

    is_valid: bool
    reasons: tuple[str, ...]
    playback: Mapping[str, Any]


class TrialStage(Protocol):
    """Plays clips; all calls on the thread that polls the player."""

    def check(self) -> None:
        """Raise StudyError where the next clip could not be felt."""
        ...

    def prepare(self, condition: Condition) -> None:
        """Load the next clip; its first frame may be shown."""
        ...

    def prepare_demonstration(self) -> None:
        """Load the demonstration of the device."""
        ...

    def begin(self) -> None:
        """Play from the beginning."""
        ...

    def is_over(self) -> bool:
        """Whether the clip has ended; also checks for faults."""
        ...

    def played(self, *reasons: str) -> PlaybackResult:
        """Return the result since `begin`; `reasons` are added."""
        ...

    @property
    def clip_s(self) -> Mapping[str, float]:
        """Durations of the sequences, by key."""
        ...

    @property
    def first_frame_s(self) -> float | None:
        """When media time 0 was on the screen, monotonic; None before that."""
        ...

    def media_s(self, monotonic_s: float) -> float | None:
        """Where the clip is at a time; None while it does not run."""
        ...

    @property
    def is_stopped(self) -> bool:
        """Whether the force is stopped until a person re-arms it."""
        ...

    def halt(self) -> None:
        """Stop force and playback at once, until `rearm`."""
        ...

    def interrupt(self) -> None:
        """Pause; the force fades out, and may come back with the next clip."""
        ...

    def rearm(self) -> None:
        """Allow force again: a person asks for it; as `Player.rearm`."""
        ...
