"""Tries which codecs play in which containers: a short clip is written and played."""

import os
import tempfile
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path

import av
import numpy as np

from hapticplayer.errors import InputError
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.containers import CONTAINERS, OTHERS
from hapticplayer.media.video import VideoDecoder

VIDEO = {
    "H.264": ("libx264", "yuv420p"),
    "H.265": ("libx265", "yuv420p"),
    "H.265 10 bit": ("libx265", "yuv420p10le"),
    "AV1": ("libsvtav1", "yuv420p"),
    "VP8": ("libvpx", "yuv420p"),
    "VP9": ("libvpx-vp9", "yuv420p"),
    "MPEG-4": ("mpeg4", "yuv420p"),
    "MPEG-2": ("mpeg2video", "yuv420p"),
    "Motion JPEG": ("mjpeg", "yuvj420p"),
    "ProRes": ("prores_ks", "yuv422p10le"),
    "FFV1": ("ffv1", "yuv420p"),
}
SOUND = {
    "AAC": ("aac", "fltp"),
    "MP3": ("libmp3lame", "fltp"),
    "Opus": ("libopus", "flt"),
    "AC-3": ("ac3", "fltp"),
    "FLAC": ("flac", "s16"),
    "ALAC": ("alac", "s16p"),
    "PCM 16 bit": ("pcm_s16le", "s16"),
    "PCM 24 bit": ("pcm_s24le", "s32"),
}
_QUIET = {"libx265": {"x265-params": "log-level=none"}}
_FRAMES, _RATE_HZ, _SOUND_HZ = 5, 25, 48_000


@cache
def rows() -> tuple[tuple[str, ...], ...]:
    """Each container with its endings and what plays in it, or how to convert it."""
    os.environ["SVT_LOG"] = "0"
    with tempfile.TemporaryDirectory() as folder:
        read = [
            (
                one.name,
                ", ".join(f"`{ending}`" for ending in one.endings),
                ", ".join(_that_play(Path(folder), one.endings, VIDEO)) or "none",
                ", ".join(_that_play(Path(folder), one.endings, SOUND)),
            )
            for one in CONTAINERS
        ]
    return (*read, *_others())


def _others() -> Iterator[tuple[str, ...]]:
    for one in {one.name: one for one in OTHERS}.values():
        endings = ", ".join(f"`{ending}`" for ending in one.endings)
        options = " ".join(one.options)
        yield one.name, endings, f"not read: `ffmpeg -i … {options} ….mp4`", ""


def _that_play(
    folder: Path, endings: tuple[str, ...], codecs: dict[str, tuple[str, str]]
) -> Iterator[str]:
    is_video = codecs is VIDEO
    for name, (codec, form) in codecs.items():
        paths = [folder / f"{codec}-{form}{ending}" for ending in endings]
        if any(
            _is_written(path, codec, form) and _plays(path, is_video=is_video)
            for path in paths
        ):
            yield name


def _is_written(path: Path, codec: str, form: str) -> bool:
    """Whether FFmpeg puts the codec into the container at all."""
    try:
        with av.open(str(path), "w") as file:
            rate = _RATE_HZ if av.Codec(codec, "w").type == "video" else _SOUND_HZ
            stream = file.add_stream(codec, rate=rate, options=_QUIET.get(codec, {}))
            if isinstance(stream, av.VideoStream):
                stream.width, stream.height, stream.pix_fmt = 128, 96, form
            else:
                stream.codec_context.layout = "stereo"
                stream.codec_context.format = form
            for number in range(_FRAMES):
                frame = _image(number) if rate == _RATE_HZ else _tone(number)
                file.mux(stream.codec_context.encode(frame))
            file.mux(stream.codec_context.encode(None))
    except (av.error.FFmpegError, ValueError):
        return False
    return True


def _image(number: int) -> av.VideoFrame:
    content = np.full((96, 128, 3), 40 * number, np.uint8)
    frame = av.VideoFrame.from_ndarray(content, format="rgb24")
    frame.pts, frame.time_base = number, Fraction(1, _RATE_HZ)
    return frame


def _tone(number: int) -> av.AudioFrame:
    samples = np.zeros((1, 2 * 1920), np.int16)
    frame = av.AudioFrame.from_ndarray(samples, "s16", "stereo")
    frame.sample_rate, frame.pts = _SOUND_HZ, number * 1920
    frame.time_base = Fraction(1, _SOUND_HZ)
    return frame


def _plays(path: Path, *, is_video: bool) -> bool:
    try:
        if is_video:
            with VideoDecoder(path) as video:
                return sum(1 for _ in video.frames()) == _FRAMES
        with AudioDecoder(path) as audio:
            return audio.next_block() is not None
    except InputError:
        return False
