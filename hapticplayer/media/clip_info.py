"""Says what a clip holds before anything of it is played."""

import math
from dataclasses import dataclass
from pathlib import Path

import av.error
from av.container import InputContainer
from av.video.frame import VideoFrame
from av.video.stream import VideoStream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import AnyClip, ClipBytes
from hapticplayer.media.frames import rotation_of
from hapticplayer.media.opening import (
    CONVERT,
    context_of,
    find_video,
    media_errors,
    open_media,
    origin_s,
    read_only,
)
from hapticplayer.media.telemetry import find_telemetry
from hapticplayer.model.limits import MAX_DURATION_S
from hapticplayer.untrusted import COPY_AGAIN

_MAX_PACKETS_TO_FIRST_FRAME = 1000
POINTER = "hapticplayer"
"""Key in the metadata of a clip to which force belongs."""

_MAKES = ("com.apple.quicktime.make", "com.android.manufacturer", "make")
_MODELS = ("com.apple.quicktime.model", "com.android.model", "model")
_LONGEST_NAME = 80


@dataclass(frozen=True, slots=True)
class ClipInfo:
    """A clip as it is shown; the path is absolute, with symbolic links resolved.

    Of a clip from elsewhere the path is only its name, and `remote` is what it is read by.
    """

    path: Path
    duration_s: float  # from the first frame to the end of the last
    width: int  # px as shown, like `height`: after rotation, with square pixels
    height: int
    frame_rate_hz: float  # average; 0 where the file does not say
    frame_count: int  # as the file states it, else 0
    has_audio: bool  # whether there is sound that can be decoded
    audio_rate_hz: int  # as stored; 0 without sound
    has_telemetry: bool
    names_force: bool = False  # whether its metadata say that force belongs to it
    camera: str = ""  # that its metadata name
    remote: ClipBytes | None = None
    audio_track: int = 0  # which of its sounds is heard

    @property
    def content(self) -> Path | ClipBytes:
        """What decoders open."""
        return self.remote or self.path


def probe(path: AnyClip) -> ClipInfo:
    """Open a clip, decode its first frame, return what it holds; raises MediaError."""
    remote = path if isinstance(path, ClipBytes) else None
    with (
        open_media(path) as container,
        media_errors(path, Message("it cannot be probed")),
    ):
        video = require_video(container, path)
        audio = next((s for s in container.streams.audio if context_of(s)), None)
        duration_s = _duration_s(container, video, path)
        rotation_deg = rotation_of(_first_frame(container, video, path))
        width, height = shown_size(video, rotation_deg)
        return ClipInfo(
            path=Path(remote.name) if remote else Path(str(path)).resolve(),
            duration_s=duration_s,
            width=width,
            height=height,
            frame_rate_hz=frame_rate_hz(video),
            frame_count=video.frames,
            has_audio=audio is not None,
            audio_rate_hz=audio.rate if audio is not None else 0,
            has_telemetry=find_telemetry(container, path) is not None,
            names_force=any(key.lower() == POINTER for key in container.metadata),
            camera=_camera(container),
            remote=remote,
        )


def _camera(container: InputContainer) -> str:
    """Return the name of the camera of a clip, "" if unknown."""
    said = {key.lower(): value for key, value in container.metadata.items()}
    make, model = (
        next((said[key].strip() for key in keys if said.get(key, "").strip()), "")
        for keys in (_MAKES, _MODELS)
    )
    if not model and (firmware := said.get("firmware", "")):
        make, model = "GoPro", firmware.partition(".")[0]  # such as HD9.01.01.60.00
    whole = model if model.startswith(make) else f"{make} {model}"
    return whole.strip()[:_LONGEST_NAME]


def require_video(container: InputContainer, path: AnyClip) -> VideoStream:
    """Return the video stream; raises MediaError when none can be decoded."""
    video = find_video(container)
    if video is None or video.time_base is None:
        raise MediaError(
            "it holds no video that can be shown", where=str(path), remedy=CONVERT
        )
    return video


def frame_rate_hz(video: VideoStream) -> float:
    """Return the average frame rate, or 0 where the file does not say."""
    rate = video.average_rate or video.guessed_rate
    return float(rate) if rate else 0.0


def shown_size(video: VideoStream, rotation_deg: int) -> tuple[int, int]:
    """Return width and height in px as shown, with square pixels."""
    width, height = video.width, video.height
    aspect = video.sample_aspect_ratio
    if aspect and 0.25 <= aspect <= 4.0:
        width = round(width * aspect)
    return (height, width) if rotation_deg in {90, 270} else (width, height)


def _duration_s(container: InputContainer, video: VideoStream, path: AnyClip) -> float:
    duration_s = 0.0
    if video.duration and video.time_base:
        duration_s = float(video.duration * video.time_base)
    elif container.duration:  # Matroska: one end for all streams, counted from 0
        duration_s = container.duration / 1e6 - origin_s(container)
    if not (math.isfinite(duration_s) and 0.0 < duration_s <= MAX_DURATION_S):
        raise MediaError(
            "it gives {duration_s:.0f} s as its duration",
            where=str(path),
            remedy="remux it to MP4 so that its duration is written",
            duration_s=duration_s,
        )
    return duration_s


def _first_frame(
    container: InputContainer, video: VideoStream, path: AnyClip
) -> VideoFrame:
    read_only(container, video)
    for count, packet in enumerate(container.demux(video)):
        try:
            frames = packet.decode()
        except av.error.FFmpegError:  # the next one may be whole
            frames = []
        if frames:
            return frames[0]
        if count >= _MAX_PACKETS_TO_FIRST_FRAME:
            break
    raise MediaError(
        "none of its frames can be decoded", where=str(path), remedy=COPY_AGAIN
    )
