"""Reads the motion of a recording in any supported format."""

from collections.abc import Mapping as Dict
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture import formats
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.capture.foreign import refuse_foreign, unknown, why_unreadable
from hapticplayer.capture.formats import Confidence, RecordingFormat
from hapticplayer.capture.source import LogPath, LogSource, open_source
from hapticplayer.errors import (
    InputError,
    MediaError,
    Message,
    TelemetryError,
    UsageError,
    entry_named,
    joined,
)
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.limits import GAP_STEPS


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """The motion of a recording and its clock map.

    Attributes:
        imu: samples on the sensor's own clock.
        clock_map: that clock to media time; confidence 0 if unknown.
        camera: that recorded it.
        notes: format, units, axes and warnings.
        provenance: the same in figures.
        lag: of the motion against the frames of the same camera; None if unknown.
        is_gravity_free: the recorder removed gravity: `imu` holds p[k] itself, without
            angular rate.
    """

    imu: ImuLog
    clock_map: ClockMap
    camera: str
    notes: tuple[str, ...] = ()
    provenance: Dict[str, Any] = field(default_factory=dict)
    lag: ClockLag | None = None
    is_gravity_free: bool = False


def read_recording(log: LogPath, choices: LogChoices | None = None) -> Recording:
    """Return the motion in a file or folder, recognised by its content.

    Args:
        log: a file, folder or zip in one of `formats.FORMATS`, or several files.
        choices: answers about a log that does not describe itself.

    Raises:
        InputError: when it cannot be read, holds no motion, or changes meanwhile.
        UsageError: when a decision is needed.
    """
    choices = choices or LogChoices()
    source = open_source(log)
    refuse_foreign(source)
    try:
        recording = find_format(source, choices).reader().read(source, choices)
    except (MediaError, TelemetryError) as error:
        if better := why_unreadable(source):
            raise better from error
        raise
    source.refuse_changed()
    if not choices.sampling:
        return recording
    sampled = replace(recording.imu, sampling=Sampling(choices.sampling))
    return replace(recording, imu=sampled)


def find_format(source: LogSource, choices: LogChoices) -> RecordingFormat:
    """Return the format of a source.

    Raises:
        InputError: when no format fits.
        UsageError: when several fit equally well, or the chosen one is unknown.
    """
    if choices.format and not source.is_binary:
        return _chosen(choices.format, source)
    if choices.columns and not source.is_binary:
        return formats.ANY_TABLE
    found = [(one.reader().recognises(source), one) for one in formats.FORMATS]
    best = max(confidence for confidence, _ in found)
    if best is Confidence.NO:
        raise unknown(source)
    fitting = [one for confidence, one in found if confidence is best]
    if len(fitting) > 1 and formats.ANY_TABLE in fitting:
        # the other format knows its columns, and checks them
        fitting.remove(formats.ANY_TABLE)
    if len(fitting) > 1:
        raise LogQuestion(
            Message(
                "could be {formats}",
                formats=joined(Message(" or "), [one.text for one in fitting]),
            ),
            tuple(f"format={one.name}" for one in fitting),
            str(source.path),
        )
    return fitting[0]


def _chosen(name: str, source: LogSource) -> RecordingFormat:
    known = {one.name: one for one in formats.FORMATS}
    form = known.get(name) or known.get(name.rpartition("-")[0])
    form = form or entry_named(known, name, Message("format"))
    if form.reader().recognises(source) is Confidence.NO:
        raise UsageError(
            "{path}: is not a log of {name}", path=source.path, name=form.text
        )
    return form


def refuse_gravity_free(recording: Recording) -> None:
    """Reject motion from which the recorder has removed gravity.

    Raises:
        InputError: with what to record instead.
    """
    if recording.is_gravity_free:
        raise InputError(
            "holds acceleration from which the recorder has removed gravity, so it "
            "cannot be checked or levelled",
            where=recording.imu.source,
            remedy="export the acceleration with gravity, and the gyroscope",
        )


def find_gaps(imu: ImuLog) -> NDArray[np.intp]:
    """Return the samples (G,) that are followed by a gap."""
    steps_s = np.diff(imu.time_s)
    if not steps_s.size:
        return np.zeros(0, dtype=np.intp)
    return np.flatnonzero(steps_s > GAP_STEPS * np.median(steps_s))


def gap_notes(imu: ImuLog) -> tuple[str, ...]:
    """Return the number and the longest of the gaps, in words."""
    steps_s, wide = np.diff(imu.time_s), find_gaps(imu)
    if not wide.size:
        return ()
    longest = int(wide[np.argmax(steps_s[wide])])
    count = (
        Message("one gap")
        if wide.size == 1
        else Message("{count} gaps", count=wide.size)
    )
    length_s, at_s = steps_s[longest], imu.time_s[longest]
    return (
        Message(
            "The log has {count}, the longest of {length_s:.2f} s at {at_s:.2f} s.",
            count=count,
            length_s=length_s,
            at_s=at_s,
        ),
    )
