"""What a log's reader hands over: streams as they are stored, and what they mean."""

import enum
from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.capture.logs.choices import LogChoices
from hapticplayer.capture.logs.source import Source
from hapticplayer.model.arrays import Floats


class Confidence(enum.IntEnum):
    """How sure a reader is that a source is its own."""

    NO = 0
    POSSIBLE = 1
    """It can be read so, but something more special may fit."""
    LIKELY = 2
    """Its layout fits; another format could look the same."""
    CERTAIN = 3
    """It says so itself: by a header or a mark that nothing else has."""


@dataclass(frozen=True, slots=True, eq=False)
class Stream:
    """One sensor on its own times.

    Attributes:
        time_s: (N,) as recorded: it may jump, repeat or hold NaN.
        values: (N, 3) in the file's unit; may hold NaN.
    """

    time_s: Floats
    values: Floats


@dataclass(frozen=True, slots=True, eq=False)
class RawLog:
    """A log before anything was checked.

    Attributes:
        name: of the format, for people.
        force: accelerometer, so that it is +1 g on the axis that points up at rest.
        rate: gyroscope, or None.
        field: magnetometer, or None.
        force_unit: see `units.FORCE`.
        rate_unit: see `units.RATE`.
        field_unit: see `units.FIELD`.
        axes: right, front and up of frame A in the stored axes, such as "x,-z,y".
        axes_words: what the stored axes are, for people.
        back_axis: the axis that points away from the camera's view in a phone
            held upright; "" where there is no camera.
        frame0_s: when the first picture was taken on the log's clock, or None.
        is_gravity_free: gravity was removed by the recorder.
        notes: what the reader found.
    """

    name: str
    force: Stream
    rate: Stream | None
    field: Stream | None = None
    force_unit: str = "m/s2"
    rate_unit: str = "rad/s"
    field_unit: str = "uT"
    axes: str = "x,y,z"
    axes_words: str = ""
    back_axis: str = ""
    frame0_s: float | None = None
    is_gravity_free: bool = False
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Format:
    """One format that can be read.

    Attributes:
        key: how `format=` calls it.
        name: for people.
        recognises: from the beginnings of the files; reads no more of them.
        read: the whole log.
    """

    key: str
    name: str
    recognises: Callable[[Source], Confidence]
    read: Callable[[Source, LogChoices], RawLog]
