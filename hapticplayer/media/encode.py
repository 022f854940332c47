"""Writes clips as H.264 and AAC in MP4: for the simulator, the demo and the tests."""

import os
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
from av.audio.frame import AudioFrame
from av.audio.stream import AudioStream
from av.bitstream import BitStreamFilterContext
from av.container import OutputContainer
from av.video.frame import VideoFrame
from av.video.reformatter import Colorspace, VideoReformatter
from av.video.stream import VideoStream
from numpy.typing import NDArray

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.audio import LAYOUTS
from hapticplayer.media.opening import media_errors, open_media
from hapticplayer.storage import file_replaced

KEY_FRAME_INTERVAL_S = 2.0
"""Exact seeking decodes at most this much."""

_SMALL = {"crf": "20", "preset": "veryfast", "threads": "1", "mbtree": "0"}
_QUICK = {"crf": "26", "preset": "ultrafast", "threads": "1"}
"""One thread: the bytes shall not depend on how many cores there are; and no macroblock
tree, with which x264 gave five different files in five runs of small frames. The quick one
takes a fourth of the time, for a file of about the same size that is of slightly lower quality.
"""

_BT709 = 1
"""Value of AVColorSpace, AVColorPrimaries and AVColorTransferCharacteristic."""

_LIMITED_RANGE = 1
"""AVCOL_RANGE_MPEG: luma 16 to 235."""

_FORMATS = {3: "rgb24", 4: "rgba"}
_AAC_BITS_PER_S = 160_000
_AUDIO_CHUNK = 8192

Progress = Callable[[float], None]


def key_frame_interval(frame_rate_hz: Fraction | float) -> int:
    return max(1, round(KEY_FRAME_INTERVAL_S * frame_rate_hz))


def write_clip(  # noqa: PLR0913 - two kinds of content, one file
    path: str | os.PathLike[str],
    frames: Iterable[NDArray[np.uint8]],
    *,
    frame_rate_hz: float,
    audio: NDArray[np.float32] | None = None,
    audio_rate_hz: int = 48_000,
    is_quick: bool = False,
    rate_factor: float | None = None,
    progress: Progress | None = None,
    rest: Callable[[], Path] | None = None,
) -> None:
    """Encode frames and sound; the file appears only when it is complete.

    Both begin at media time 0. Colours are written as BT.709 and tagged so; the index
    comes first, so that a truncated copy still plays its first part.

    Args:
        path: the file to write; an older one is replaced.
        frames: (h, w, 3) uint8 RGB, all of one size with even sides; or (h, w, 4),
            whose last channel is ignored.
        frame_rate_hz: of the frames.
        audio: (n, channels) with 1 or 2 channels, 1.0 is full scale, or None.
        audio_rate_hz: of the sound.
        is_quick: save time rather than quality.
        rate_factor: of x264, instead of the usual one; smaller is finer.
        progress: called after each frame with the seconds written so far; what
            it raises (Cancelled) ends the work and leaves nothing behind.
        rest: called after the last frame; gives a clip that this function has
            written of the frames that follow, which are not encoded again.
    """
    target = Path(path)
    rate = Fraction(frame_rate_hz).limit_denominator(1001)
    options = dict(_QUICK if is_quick else _SMALL)
    if rate_factor is not None:
        options["crf"] = f"{rate_factor:g}"
    sound = None if audio is None else (audio, audio_rate_hz)
    failed = Message("cannot be written"), Message("choose another folder")
    with file_replaced(target) as part, media_errors(target, *failed):
        _write(part, iter(frames), rate, options, sound, progress, rest)


def _write(  # noqa: PLR0913 - as write_clip
    part: Path,
    frames: Iterator[NDArray[np.uint8]],
    rate: Fraction,
    options: dict[str, str],
    audio: tuple[NDArray[np.float32], int] | None,
    progress: Progress | None,
    rest: Callable[[], Path] | None,
) -> None:
    first = next(frames, None)
    if first is None:
        raise MediaError("there are no frames to write", where=str(part.parent))
    container = av.open(
        str(part), "w", format="mp4", options={"movflags": "+faststart"}
    )
    with container:
        video = _video_stream(container, rate, first, options)
        sound = None
        if audio is not None:
            sound = _SoundWriter(container, *audio)
        reformatter = VideoReformatter()
        pixels: NDArray[np.uint8] | None = first
        count = 0
        while pixels is not None:
            frame = _yuv_frame(reformatter, pixels, first.shape)
            frame.pts, frame.time_base = count, 1 / rate
            container.mux(video.encode(frame))
            count += 1
            written_s = float(count / rate)
            if sound is not None:
                sound.write_until(written_s)
            if progress is not None:
                progress(written_s)
            pixels = next(frames, None)
        container.mux(video.encode())
        if rest is not None:
            _append(container, video, rest(), count, sound)
        if sound is not None:
            sound.finish()


def _append(
    container: OutputContainer,
    video: VideoStream,
    path: Path,
    after: int,
    sound: "_SoundWriter | None",
) -> None:
    """Copy the frames of a clip that was encoded in the same way."""
    with open_media(path) as source:
        stream = source.streams.video[0]
        base, step = stream.time_base, 1 / Fraction(video.codec_context.framerate)
        assert base is not None
        begin = round(after * step / base)
        # an MP4 stores the parameter sets apart, an encoder sends them inline
        inline = BitStreamFilterContext("h264_mp4toannexb", stream)
        for packet in source.demux(stream):
            if packet.pts is None or packet.dts is None:
                continue
            for one in inline.filter(packet):
                one.pts, one.dts = (one.pts or 0) + begin, (one.dts or 0) + begin
                one.stream = video
                if sound is not None:
                    sound.write_until(float(one.dts * base))
                container.mux(one)


def _video_stream(
    container: OutputContainer,
    rate: Fraction,
    first: NDArray[np.uint8],
    options: dict[str, str],
) -> VideoStream:
    height, width = first.shape[:2]
    gop = key_frame_interval(rate)
    stream = container.add_stream(
        "libx264", rate=rate, options={**options, "g": str(gop)}
    )
    stream.width, stream.height = width, height
    stream.pix_fmt = "yuv420p"
    context = stream.codec_context
    context.time_base = 1 / rate
    context.colorspace = context.color_primaries = context.color_trc = _BT709
    context.color_range = _LIMITED_RANGE
    return stream


def _yuv_frame(
    reformatter: VideoReformatter,
    pixels: NDArray[np.uint8],
    shape: tuple[int, ...],
) -> VideoFrame:
    kind = _FORMATS.get(pixels.shape[-1])
    if pixels.shape != shape or kind is None or pixels.dtype != np.uint8:
        raise MediaError(
            "a frame has the shape {shape}, expected {expected} of uint8",
            shape=pixels.shape,
            expected=shape,
        )
    frame = VideoFrame.from_ndarray(np.ascontiguousarray(pixels), format=kind)
    return reformatter.reformat(
        frame,
        format="yuv420p",
        dst_colorspace=Colorspace.ITU709,
        dst_color_range=_LIMITED_RANGE,
    )


class _SoundWriter:
    """Encodes sound beside the frames, so that the file is interleaved."""

    def __init__(
        self,
        container: OutputContainer,
        audio: NDArray[np.float32],
        rate_hz: int,
    ) -> None:
        if audio.ndim != 2 or audio.shape[1] not in LAYOUTS:
            raise MediaError(
                "the sound has the shape {shape}, expected (n, 1) or (n, 2)",
                shape=audio.shape,
            )
        self._container = container
        self._audio = audio
        self._rate_hz = rate_hz
        self._layout = LAYOUTS[audio.shape[1]]
        self._done = 0
        self._stream: AudioStream = container.add_stream(
            "aac", rate=rate_hz, layout=self._layout
        )
        self._stream.bit_rate = _AAC_BITS_PER_S

    def write_until(self, media_s: float) -> None:
        """Encode what is heard before `media_s`."""
        until = min(len(self._audio), round(media_s * self._rate_hz))
        while self._done < until:
            chunk = self._audio[self._done : min(until, self._done + _AUDIO_CHUNK)]
            planar = np.ascontiguousarray(chunk.T, dtype=np.float32)
            frame = AudioFrame.from_ndarray(planar, format="fltp", layout=self._layout)
            frame.sample_rate = self._rate_hz
            frame.pts = self._done
            frame.time_base = Fraction(1, self._rate_hz)
            self._container.mux(self._stream.encode(frame))
            self._done += len(chunk)

    def finish(self) -> None:
        """Encode the rest and flush."""
        self.write_until(len(self._audio) / self._rate_hz)
        self._container.mux(self._stream.encode(None))
