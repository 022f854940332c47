"""Whether a clip plays as fast as it was recorded, by what its metadata say."""

import os
import re
from typing import NamedTuple

from hapticplayer.errors import Message
from hapticplayer.media.clip_bytes import open_clip
from hapticplayer.media.clip_info import frame_rate_hz, require_video
from hapticplayer.media.mp4 import boxes, content_of, tracks_of
from hapticplayer.media.opening import open_media

_ANDROID, _PHOTOS = "com.android.capture.fps", "com.apple.photos.capturemode"
_SONY = re.compile(rb'captureFps="(\d+(?:\.\d+)?)p?"\s+formatFps="(\d+(?:\.\d+)?)p?"')
_MAX_META_BYTES = 1 << 20
_SAME = 1.45  # a phone in low light gives fewer frames than it says, but not by this


class Pace(NamedTuple):
    """A pace of playback that is not that of the recording.

    Attributes:
        slowed: how many times as slow as it was recorded it plays; None if unknown.
        why: what says so.
    """

    slowed: float | None
    why: Message


def pace_of(path: str | os.PathLike[str]) -> Pace | None:
    """The pace of a clip where its metadata say that it is another, else None.

    Android writes the rate of capture, Apple the mode, Sony both rates (S&Q); an edit list
    may stretch the video, which FFmpeg does not do.
    """
    with open_media(path) as container:
        said = {key.lower(): value for key, value in container.metadata.items()}
        video = require_video(container, path)
        rates_hz = (frame_rate_hz(video), float(video.guessed_rate or 0.0))
    captured_hz = _number(said.get(_ANDROID, ""))
    if captured_hz and rates_hz[0] and (found := _by_rates(captured_hz, rates_hz)):
        return found
    if found := _by_sony(path):
        return found
    if "lapse" in said.get(_PHOTOS, "").lower():
        return Pace(None, Message("its metadata say that it is a time lapse"))
    return _by_edits(path)


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        return 0.0
    return value if 0.0 < value < 1e5 else 0.0


def _by_rates(captured_hz: float, shown_hz: tuple[float, ...]) -> Pace | None:
    """The pace by the rate of capture, where no rate of the video is like it."""
    known = [rate for rate in shown_hz if rate]
    if any(1 / _SAME < captured_hz / rate < _SAME for rate in known):
        return None
    why = Message(
        "it was recorded at {captured_hz:g} frames per second and plays at {shown_hz:g}",
        captured_hz=round(captured_hz, 2),
        shown_hz=round(known[0], 2),
    )
    return Pace(captured_hz / known[0], why)


def _by_sony(path: str | os.PathLike[str]) -> Pace | None:
    for content in _meta_boxes(path):
        if match := _SONY.search(content):
            captured_hz, shown_hz = (_number(part.decode()) for part in match.groups())
            if captured_hz and shown_hz:
                return _by_rates(captured_hz, (shown_hz,))
    return None


def _meta_boxes(path: str | os.PathLike[str]) -> list[bytes]:
    with open_clip(path) as stream:
        return [
            content_of(stream, box, _MAX_META_BYTES)
            for box in boxes(stream, frozenset([b"moov"]))
            if box.kind in {b"meta", b"uuid"}
        ]


def _by_edits(path: str | os.PathLike[str]) -> Pace | None:
    """The pace of a video of which a part is stretched."""
    for track in tracks_of(path):
        rates = {e.rate for e in track.edits if e.media_s is not None}
        if track.kind == "vide" and rates - {1.0}:
            slowest = min(rates)
            slowed = 1.0 / slowest if len(rates) == 1 and slowest > 0.0 else None
            return Pace(slowed, Message("its edit list stretches time"))
    return None
