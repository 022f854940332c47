"""What a force format is: how files of it are written and read, and with which choices."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.model.applied import AppliedAnswers
from hapticplayer.model.ranges import Range
from hapticplayer.storage import IsOurs

TOLERANCE_N = Range(1e-4, 1.0, "N")
SAMPLE_RATE_HZ = Range(1000, 8000, "Hz", is_whole=True)
FULL_SCALE_N = Range(0.01, 10.0, "N")
STIFFNESS_N_PER_M = Range(1.0, 200.0, "N/m")

Direction = tuple[float, float, float]
UP: Direction = (0.0, 1.0, 0.0)


@dataclass(frozen=True, slots=True)
class WriteChoices(AppliedAnswers):
    """What can be chosen when a force track is written.

    Attributes:
        duration_s: of the clip, where the file ends; None: that of the track.
        tolerance_n: the force vector differs by this much at most, where a format
            thins it, at every millisecond of media time.
        sample_rate_hz: of audio.
        funscript_version: "1.0", "1.1" or "2.0".
        part: of the formats that write several files, what stands before the suffix.
        overwrite: replace a file that this program wrote in the same format.
        with_motion: write the motion of a sequence beside the force.
        motion: that motion.
    """

    duration_s: float | None = None
    tolerance_n: float = 0.01
    sample_rate_hz: int = 1000
    funscript_version: str = "1.1"
    part: str = ""
    overwrite: bool = False
    with_motion: bool = False
    motion: MotionTrack | None = None


ASK = "ask"
"""The choice of who can be asked: where a file makes it necessary, a ForceQuestion is raised."""


class ForceQuestion(UsageError):  # noqa: N818 - it asks
    """What an hjif perception `Other` is has to be said.

    Attributes:
        has_more: the file holds something else, too, that is read.
    """

    def __init__(self, where: str, has_more: bool) -> None:
        super().__init__("{file}: what is its perception Other?", file=where)
        self.where, self.has_more = where, has_more

    def __reduce__(self) -> tuple[Any, ...]:
        """Let it pass from one process to another."""
        return type(self), (self.where, self.has_more)


@dataclass(frozen=True, slots=True)
class ReadChoices(AppliedAnswers):
    """What a file may not say itself.

    Attributes:
        full_scale_n: force of amplitude 1 where the file gives no unit.
        direction: unit vector in frame D of what has no direction.
        stiffness_n_per_m: of the spring whose set-point a position script moves.
        until_s: later force is not wanted, and may be left out.
        other_is: what an hjif perception `Other` is: force, vibration, "" where it is not
            to be read, or ASK.
    """

    full_scale_n: float = 1.0
    direction: Direction = UP
    stiffness_n_per_m: float = 40.0
    until_s: float = math.inf
    other_is: str = ""


class ForceFile(NamedTuple):
    """What was read.

    Attributes:
        track: in frame D, media time.
        assumed: what the file does not say.
        unread: what was not understood, and has no force.
    """

    track: ForceTrack
    assumed: tuple[Message, ...] = ()
    unread: tuple[Message, ...] = ()

    @property
    def notes(self) -> tuple[Message, ...]:
        """All of it, for people."""
        return (*self.assumed, *self.unread)


class Loss(NamedTuple):
    """How a file differs from its track at the milliseconds of media time.

    Attributes:
        rms_n: RMS length of the difference; None where the file holds no newtons.
        max_n: the largest difference.
        of: what was compared.
    """

    rms_n: float | None
    max_n: float | None
    of: Message


def refuse_untaken(choices: ReadChoices | WriteChoices, form: str, where: str) -> None:
    """Raise UsageError for a choice that had no effect on a file."""
    for name in choices.untaken():
        if name in _OPTIONS and getattr(choices, name) != ASK:
            raise UsageError(
                "{file}: {option} has no effect: {form} does not use it, or this file "
                "says it itself; leave it out",
                file=where,
                option=_OPTIONS[name],
                form=form,
            )


_OPTIONS = {
    "tolerance_n": "--tolerance",
    "sample_rate_hz": "--sample-rate",
    "funscript_version": "--funscript-version",
    "full_scale_n": "--full-scale",
    "direction": "--direction",
    "stiffness_n_per_m": "--stiffness",
    "other_is": "--other-is",
}
"""Of the choices that a person makes."""

NOT_MEASURED = "estimated from the picture, not measured"


def origin(track: ForceTrack) -> str:
    """The origin of a file's force: "; ...", or nothing."""
    return f"; {NOT_MEASURED}" if track.is_estimated else ""


Write = Callable[[ForceTrack, BinaryIO, WriteChoices], tuple[Message, ...]]
"""Returns what of the track the file leaves out."""

Read = Callable[[Path, ReadChoices], ForceFile]
MeasureLoss = Callable[[ForceTrack, Path, WriteChoices], Loss]


def one_file(_choices: WriteChoices) -> tuple[str, ...]:
    return ("",)


@dataclass(frozen=True, slots=True)
class ForceFormat:
    """A format of files with force in them.

    Attributes:
        name: for `--format`.
        suffix: of its files, with the dot.
        text: for people.
        keeps: what a file keeps of a force track, for people.
        is_ours: recognises our files by their beginning, to overwrite them.
        write: None where it is only read.
        read: None where it is only written.
        loss: reads a file that was just written and compares it.
        other_suffixes: of files that are read, too.
        takes_motion: motion is written beside the force, if it is given.
        parts: what stands before the suffix of each file that is written.
        is_sampled: at the sample rate that is chosen, instead of every millisecond.
    """

    name: str
    suffix: str
    text: Message
    keeps: Message
    is_ours: IsOurs
    write: Write | None
    read: Read | None
    loss: MeasureLoss
    other_suffixes: tuple[str, ...] = ()
    takes_motion: bool = False
    parts: Callable[[WriteChoices], tuple[str, ...]] = one_file
    is_sampled: bool = False
