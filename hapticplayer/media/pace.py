"""Whether a clip plays as fast as it was recorded, by what its metadata say."""

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from hapticplayer.errors import Message, shell_line
from hapticplayer.media.clip_bytes import open_clip, size_of
from hapticplayer.media.clip_info import frame_rate_hz, require_video
from hapticplayer.media.mp4 import boxes, content_of, tracks_of
from hapticplayer.media.opening import open_media

_ANDROID, _PHOTOS = "com.android.capture.fps", "com.apple.photos.capturemode"
_SONY = re.compile(rb'captureFps="(\d+(?:\.\d+)?)p?"\s+formatFps="(\d+(?:\.\d+)?)p?"')
_GOPRO_LAPSE = b"MTYPB\x01\x00\x01\x01"
_GOPRO_RATE = re.compile(rb"RATEc(.)(..)", re.DOTALL)
_GOPRO_INTERVAL = re.compile(r"(\d+)(?:_(\d+))?SEC")
_SAMSUNG_END, _SAMSUNG_PART = b"SEFT", b"Super_SlowMotion_Data"
_MAX_META_BYTES, _TAIL_BYTES = 1 << 20, 1 << 16
_LAPSE = Message("its metadata say that it is a time lapse")
_SAME = 1.45  # a phone in low light gives fewer frames than it says, but not by this


class Pace(NamedTuple):
    """A pace of playback that is not that of the recording.

    Attributes:
        slowed: how many times as slow as it was recorded it plays; None if unknown.
        why: what says so.
    """

    slowed: float | None
    why: Message

    def question(self, path: Path) -> Message:
        """What a person has to decide, and how."""
        slowed = self.slowed or 1.0
        real = path.with_name(f"{path.stem}-real{path.suffix}")
        scale = f"{1.0 / slowed:.6g}"
        words = ("-itsscale", scale, "-i", path, "-map", "0:v", "-c", "copy", real)
        copy = shell_line("ffmpeg", *words)
        if self.slowed is None:
            copy = Message("your video editor")
        return Message(
            "{clip}: {why}; make a copy at its real speed ({copy}), or take it as it plays "
            "(--slow-motion 1), or stretch the motion (--slow-motion {slowed} --offset S)",
            clip=path.name,
            why=self.why,
            copy=copy,
            slowed=f"{slowed:.4g}" if self.slowed else "N",
        )


def pace_of(path: str | os.PathLike[str]) -> Pace | None:
    """The pace of a clip where its metadata say that it is another, else None.

    Android writes the rate of capture, Apple the mode, Sony both rates (S&Q), GoPro the
    kind of recording and its rate, Samsung that a part is Super Slow-mo; an edit list may
    stretch the video, which FFmpeg does not do. Slow motion of iPhones plays at its real
    speed; DJI and Insta360 write nothing of the kind.
    """
    with open_media(path) as container:
        video = require_video(container, path)
        both = {**container.metadata, **video.metadata}
        rates_hz = (frame_rate_hz(video), float(video.guessed_rate or 0.0))
    said = {key.lower(): value for key, value in both.items()}
    captured_hz = _number(said.get(_ANDROID, ""))
    if captured_hz and rates_hz[0] and (found := _by_rates(captured_hz, rates_hz)):
        return found
    for content in _meta_boxes(path):
        if found := _by_sony(content) or _by_gopro(content, rates_hz):
            return found
    if "lapse" in said.get(_PHOTOS, "").lower():
        return Pace(None, _LAPSE)
    return _by_samsung(path) or _by_edits(path)


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


def _by_sony(content: bytes) -> Pace | None:
    match = _SONY.search(content)
    if match is None:
        return None
    captured_hz, shown_hz = (_number(part.decode()) for part in match.groups())
    return _by_rates(captured_hz, (shown_hz,)) if captured_hz and shown_hz else None


def _by_gopro(content: bytes, shown_hz: tuple[float, ...]) -> Pace | None:
    """By its settings in GPMF: the rate is empty but in time lapse and TimeWarp."""
    match = _GOPRO_RATE.search(content)
    rate = ""
    if match is not None:
        length = match[1][0] * int.from_bytes(match[2], "big")
        rate = content[match.end() :][:length].decode("latin-1").strip(" \0")
    interval = _GOPRO_INTERVAL.fullmatch(rate)
    if interval is not None:
        step_s = _number(f"{interval[1]}.{interval[2] or 0}")
        return _by_rates(1.0 / step_s, shown_hz) if step_s and shown_hz[0] else None
    if rate:
        return Pace(
            None,
            Message("it is a time lapse or TimeWarp (GoPro's rate: {rate})", rate=rate),
        )
    return Pace(None, _LAPSE) if _GOPRO_LAPSE in content else None


def _by_samsung(path: str | os.PathLike[str]) -> Pace | None:
    with open_clip(path) as stream:
        stream.seek(max(0, size_of(stream) - _TAIL_BYTES))
        tail = stream.read(_TAIL_BYTES)
    if not tail.endswith(_SAMSUNG_END) or _SAMSUNG_PART not in tail:
        return None
    return Pace(None, Message("a part of it was recorded faster (Super Slow-mo)"))


def _meta_boxes(path: str | os.PathLike[str]) -> Iterator[bytes]:
    with open_clip(path) as stream:
        for box in boxes(stream, frozenset([b"moov", b"udta"])):
            if box.kind in {b"meta", b"uuid", b"GPMF"}:
                yield content_of(stream, box, _MAX_META_BYTES)


def _by_edits(path: str | os.PathLike[str]) -> Pace | None:
    """The pace of a video of which a part is stretched."""
    for track in tracks_of(path):
        rates = {e.rate for e in track.edits if e.media_s is not None}
        if track.kind == "vide" and rates - {1.0}:
            slowest = min(rates)
            slowed = 1.0 / slowest if len(rates) == 1 and slowest > 0.0 else None
            return Pace(slowed, Message("its edit list stretches time"))
    return None
