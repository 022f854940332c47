"""Reads the motion of a recording in any supported format."""

from dataclasses import replace

from hapticplayer.capture import formats
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.foreign import refuse_foreign, unknown, why_unreadable
from hapticplayer.capture.formats import Confidence, RecordingFormat
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.source import LogPath, LogSource, open_source
from hapticplayer.errors import (
    MediaError,
    Message,
    TelemetryError,
    UsageError,
    entry_named,
    joined,
)
from hapticplayer.model import Sampling


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
    """Return the format of a source."""
    if choices.format and not source.is_binary:
        return _chosen(choices.format, source)
    if choices.columns and not source.is_binary:
        return formats.ANY_TABLE
    found = [
        (one.reader().recognises(source), one) for one in formats.recording_formats()
    ]
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
    known = {one.name: one for one in formats.recording_formats()}
    form = known.get(name) or known.get(name.rpartition("-")[0])
    form = form or entry_named(known, name, Message("format"))
    if form.reader().recognises(source) is Confidence.NO:
        raise UsageError(
            "{path}: is not a log of {name}", path=source.path, name=form.text
        )
    return form
