"""Sensors that repeat readings: a stuck one has none there, a slow one has fewer."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.streams import SensorStream
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.model.arrays import Floats, all_of_rows
from hapticplayer.model.limits import MAX_MISSING

Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]

ASKED_SHARE = 0.1
"""Of the readings of a sensor that was stuck; more is a decision for a person."""

_STUCK = "stuck"  # in the provenance of a recording
_NAMES = Message("accelerometer"), Message("gyroscope"), Message("magnetometer")
_SHOWN_SPANS = 3


class Repeats(NamedTuple):
    """What sensors repeat.

    Attributes:
        notes: on stuck and slow ones.
        stuck_share: of the readings of accelerometer or gyroscope, whichever is more.
    """

    notes: tuple[Message, ...] = ()
    stuck_share: float = 0.0

    @property
    def provenance(self) -> dict[str, Any]:
        """For a recording, where a sensor was stuck."""
        share = round(self.stuck_share, 5)
        found = {"share": share, "what": joined("; ", self.notes)}
        return {_STUCK: found} if share else {}


class Working(NamedTuple):
    """The streams of a log as far as its sensors worked.

    Attributes:
        accel: accelerometer; NaN where it was stuck, one row for each reading.
        rate: gyroscope, the same.
        field: magnetometer, NaN where it was stuck, or None.
        repeats: what was found.
        rows: (K,) of the accelerometer that were kept.
    """

    accel: SensorStream
    rate: SensorStream
    field: SensorStream | None
    repeats: Repeats
    rows: Rows


def working(
    accel: SensorStream, rate: SensorStream, field: SensorStream | None, where: str
) -> Working:
    """The streams of a log without what stuck and slow sensors repeat.

    Raises:
        InputError: for a sensor that was stuck most of the time.
    """
    from hapticplayer.motion.repair.frozen import frozen_rows, readings_each

    given = [accel, rate] if field is None else [accel, rate, field]
    stuck = [frozen_rows(stream.values) for stream in given]
    _exempt_rest(given, stuck)
    each = [readings_each(stream.values) for stream in given[:2]]
    rows = [_rows_of_readings(*pair) for pair in zip(given[:2], each, strict=True)]
    is_shared = rate.time_s is accel.time_s
    if is_shared and each[0] == each[1]:
        rows = [np.union1d(*rows)] * 2
    notes = [
        _stuck_text(name, stream.time_s, flags)
        for name, stream, flags in zip(_NAMES, given, stuck, strict=False)
        if flags.any()
    ] + [
        _held_text(name, stream.time_s, count)
        for name, stream, count in zip(_NAMES, given, each, strict=False)
        if count > 1
    ]
    streams = [
        SensorStream(stream.time_s, np.where(flags[:, None], np.nan, stream.values))
        if flags.any()
        else stream
        for stream, flags in zip(given, stuck, strict=True)
    ]
    if max(each) > 1:
        kept_s = [one.time_s[kept] for one, kept in zip(given, rows, strict=False)]
        if is_shared and rows[0] is rows[1]:
            kept_s[1] = kept_s[0]
        streams[:2] = [
            SensorStream(time_s, stream.values[kept])
            for time_s, stream, kept in zip(kept_s, streams, rows, strict=False)
        ]
    repeats = Repeats(tuple(notes), max(float(np.mean(flags)) for flags in stuck[:2]))
    if repeats.stuck_share > MAX_MISSING:
        raise InputError(
            "{notes}",
            where=where,
            remedy="give a recording of sensors that worked",
            notes=joined("; ", notes),
        )
    field = streams[2] if field is not None else None
    return Working(streams[0], streams[1], field, repeats, rows[0])


def ask_about_stuck(recording: Recording, choices: LogChoices, where: str) -> None:
    """Ask whether a log may be used whose sensors were stuck for long."""
    found = recording.provenance.get(_STUCK)
    if found is None or choices.take("stuck") or found["share"] <= ASKED_SHARE:
        return
    raise LogQuestion(
        found["what"],
        (Message("stuck=no-force to have no force there, or record it again"),),
        where,
    )


def _rows_of_readings(stream: SensorStream, each: int) -> Rows:
    """Return the first row of each reading, which is held for so many."""
    values = stream.values
    count = len(values)
    if each == 1:
        return np.arange(count)
    is_new = np.append(True, ~all_of_rows(values[1:] == values[:-1]))
    last = np.maximum.accumulate(np.where(is_new, np.arange(count), 0))
    return np.flatnonzero((np.arange(count) - last) % each == 0)


def _exempt_rest(streams: Sequence[SensorStream], stuck: Sequence[Flags]) -> None:
    """Take back, in place, that the sensors were stuck where the gyro reads exactly 0.

    A program's log of something at rest repeats itself, and so do sensors that suppress
    their noise there. Stuck ones repeat what they read last.
    """
    accel, rate = streams[:2]
    if not (stuck[0].any() and stuck[1].any()):
        return
    is_still = stuck[1] & ~rate.values.any(axis=1)
    if rate.time_s is accel.time_s:
        at_rest, of_rate = is_still & stuck[0], is_still & stuck[0]
    else:
        at_rest = stuck[0] & _nearest(is_still, rate.time_s, accel.time_s)
        of_rate = is_still & _nearest(stuck[0], accel.time_s, rate.time_s)
    stuck[0][at_rest] = False
    stuck[1][of_rate] = False


def _nearest(flags: Flags, time_s: Floats, at_s: Floats) -> Flags:
    return np.asarray(flags[np.searchsorted(time_s, at_s).clip(0, len(flags) - 1)])


def _stuck_text(name: str, time_s: Floats, flags: Flags) -> Message:
    edges = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    spans = [
        Message(
            "{begin_s:.2f} to {end_s:.2f} s",
            begin_s=time_s[begin] - time_s[0],
            end_s=time_s[end - 1] - time_s[0],
        )
        for begin, end in zip(edges[::2], edges[1::2], strict=True)
    ]
    more = len(spans) - _SHOWN_SPANS
    if more > 0:
        spans[_SHOWN_SPANS:] = [Message("{more} more", more=more)]
    return Message(
        "the {sensor} repeats its readings as a stuck sensor does, {share:.1%} of "
        "the time ({spans} from the start of the log); they are not used",
        sensor=name,
        share=float(np.mean(flags)),
        spans=joined(", ", spans),
    )


def _held_text(name: str, time_s: Floats, each: int) -> Message:
    return Message(
        "the {sensor} is slower than the log: each reading is held for {each} rows, so "
        "that there are {rate_hz:.4g} a second",
        sensor=name,
        each=each,
        rate_hz=1.0 / (each * float(np.nanmedian(np.diff(time_s)))),
    )
