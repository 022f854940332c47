"""Everything that PyAV does here: open, probe, decode, take telemetry, encode.

Media time 0 is where the first picture is shown; all times of this room count
from there, in seconds. PyAV is loaded when the first name is used.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.media.audio import AudioBlock, AudioDecoder
    from hapticplayer.media.clip_info import ClipInfo, camera_of, probe
    from hapticplayer.media.encode import write_clip
    from hapticplayer.media.frames import BgraImage, DecodedFrame, FrameConverter
    from hapticplayer.media.opening import open_media
    from hapticplayer.media.small_pictures import Thumbnail, cover_pictures, thumbnails
    from hapticplayer.media.telemetry import (
        TelemetryPacket,
        data_track_names,
        read_telemetry_packets,
    )
    from hapticplayer.media.telemetry_writer import add_telemetry
    from hapticplayer.media.tempo import TempoFilter
    from hapticplayer.media.video import VideoDecoder

_HOMES = {
    "AudioBlock": "audio",
    "AudioDecoder": "audio",
    "ClipInfo": "clip_info",
    "BgraImage": "frames",
    "DecodedFrame": "frames",
    "FrameConverter": "frames",
    "TelemetryPacket": "telemetry",
    "TempoFilter": "tempo",
    "Thumbnail": "small_pictures",
    "VideoDecoder": "video",
    "add_telemetry": "telemetry_writer",
    "camera_of": "clip_info",
    "cover_pictures": "small_pictures",
    "data_track_names": "telemetry",
    "open_media": "opening",
    "probe": "clip_info",
    "read_telemetry_packets": "telemetry",
    "thumbnails": "small_pictures",
    "write_clip": "encode",
}

__all__ = [
    "AudioBlock",
    "AudioDecoder",
    "BgraImage",
    "ClipInfo",
    "DecodedFrame",
    "FrameConverter",
    "TelemetryPacket",
    "TempoFilter",
    "Thumbnail",
    "VideoDecoder",
    "add_telemetry",
    "camera_of",
    "cover_pictures",
    "data_track_names",
    "open_media",
    "probe",
    "read_telemetry_packets",
    "thumbnails",
    "write_clip",
]


def __getattr__(name: str) -> object:
    """Load the module of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = getattr(module, name)
    return globals()[name]
