"""Reads the motion of a recording in any supported format."""

from dataclasses import replace

import numpy as np

from hapticplayer.capture import formats
from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.foreign import refuse_foreign, unknown, why_unreadable
from hapticplayer.capture.formats import Confidence, RecordingFormat
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.source import LogPath, LogSource, open_source
from hapticplayer.capture.stuck import ask_about_stuck
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
    choices = replace(choices or LogChoices())  # of which nothing is taken yet
    source = open_source(log)
    refuse_foreign(source)
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # damage, found later
            form = find_format(source, choices)
            recording = form.reader().read(source, choices)
    except (MediaError, TelemetryError) as error:
        if better := why_unreadable(source):
            raise better from error
        raise
    source.refuse_changed()
    imu, sampling = recording.imu, choices.take("sampling")
    if sampling:
        imu = replace(imu, sampling=Sampling(sampling))
    ask_about_stuck(recording, choices, str(source.path))
    choices.refuse_untaken(form.text, str(source.path))
    answers = choices.given()
    if not answers:
        return recording
    text = " ".join(f"{key}={value}" for key, value in answers.items())
    return replace(
        recording,
        imu=imu,
        notes=(*recording.notes, Message("applied as given: {answers}", answers=text)),
        provenance={**recording.provenance, "answers": answers},
    )


def find_format(source: LogSource, choices: LogChoices) -> RecordingFormat:
    """Return the format of a source."""
    if choices.format:
        return _chosen(choices, source)
    rows = formats.recording_formats()
    found = [(one.reader().recognises(source), one) for one in rows]
    by_hand = [one for sure, one in found if one.is_any and sure is not Confidence.NO]
    if choices.columns and by_hand:
        return by_hand[0]
    best = max(confidence for confidence, _ in found)
    if best is Confidence.NO:
        raise unknown(source)
    fitting = [one for confidence, one in found if confidence is best]
    # a format that knows its columns checks them
    fitting = [one for one in fitting if not one.is_any] or fitting
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


def _chosen(choices: LogChoices, source: LogSource) -> RecordingFormat:
    known, name = {one.name: one for one in formats.recording_formats()}, choices.format
    if name in known:
        choices.take("format")
    form = known.get(name) or known.get(name.rpartition("-")[0])  # or its reader does
    form = form or entry_named(known, name, Message("format"))
    if form.reader().recognises(source) is Confidence.NO:
        raise UsageError(
            "{path}: is not a log of {name}", path=source.path, name=form.text
        )
    return form
