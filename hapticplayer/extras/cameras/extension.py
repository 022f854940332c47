"""Telemetry of cameras beyond GoPro, read by an optional library in a child process."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.capture.formats import RecordingFormat


def recording_formats() -> "tuple[RecordingFormat, ...]":
    """What `telemetry-parser` reads."""
    from hapticplayer.capture.formats import RecordingFormat

    return (
        RecordingFormat(
            "camera",
            Message("another camera"),
            "hapticplayer.extras.cameras.other_cameras:READER",
            "`telemetry-parser`, if installed",
            "at the first sample, from which telemetry-parser counts",
            "the library on a HERO5 clip; no clip of another camera",
        ),
    )
