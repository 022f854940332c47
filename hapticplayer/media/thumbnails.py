"""Thumbnails of clips, for a seek bar or a library."""

import os
from pathlib import Path
from typing import NamedTuple

from hapticplayer.errors import MediaError, Progress
from hapticplayer.media.clip_info import probe
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder

MOST = 400


class Thumbnail(NamedTuple):
    """A small picture of a frame: width * height * 3 bytes, top row first."""

    media_s: float
    width: int
    height: int
    rgb: bytes


def thumbnails(
    path: str | os.PathLike[str],
    times_s: list[float],
    height_px: int,
    *,
    progress: Progress,
) -> list[Thumbnail]:
    """Return a thumbnail for each time, without those that cannot be decoded.

    At most `MOST` times grow. `progress` is called before each and raises Cancelled to
    stop.

    Raises:
        MediaError: when the clip cannot be opened.
    """
    made: list[Thumbnail] = []
    converter = FrameConverter()
    with VideoDecoder(path) as decoder:
        width_px = max(2, round(height_px * decoder.width / decoder.height))
        for number, media_s in enumerate(times_s[:MOST]):
            progress(number / len(times_s), "")
            try:
                decoder.seek(media_s)
                frame = decoder.next_frame()
                if frame is None:
                    continue
                rgb = converter.convert(frame, width_px, height_px).as_rgb()
            except MediaError:
                continue
            height, width = rgb.shape[:2]
            made.append(Thumbnail(frame.pts_s, width, height, rgb.tobytes()))
    return made


def cover_thumbnails(
    paths: list[Path],
    height_px: int,
    *,
    progress: Progress,
) -> list[Thumbnail | None]:
    """Return a thumbnail from the first third of each clip; None where that fails.

    `progress` is called before each clip and raises Cancelled to stop.
    """
    made: list[Thumbnail | None] = []
    for number, path in enumerate(paths):
        progress(number / len(paths), "")
        try:
            at_s = probe(path).duration_s / 3.0
            found = thumbnails(path, [at_s], height_px, progress=lambda _f, _s: None)
        except MediaError:
            found = []
        made.append(found[0] if found else None)
    return made
