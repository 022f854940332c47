"""Writes a clip while it is filmed, so that a kill loses less than a second of it."""

import contextlib
import itertools
import math
import threading
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager
from fractions import Fraction
from pathlib import Path
from typing import cast

import av
import av.error
import numpy as np
from av.audio.frame import AudioFrame
from av.audio.resampler import AudioResampler
from av.container import OutputContainer
from av.video.frame import PictureType, VideoFrame
from av.video.reformatter import VideoReformatter
from av.video.stream import VideoStream
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.media.audio import LAYOUTS
from hapticplayer.media.encode import key_frame_interval
from hapticplayer.media.live_input import Live, LiveInput
from hapticplayer.media.opening import media_errors
from hapticplayer.media.packets import AnyPacket

_MATROSKA = {
    "cluster_time_limit": "400",
    "flush_packets": "1",
    # a stream that pauses does not hold the other back
    "max_interleave_delta": "300000",
}
_QUICK = {"preset": "ultrafast", "tune": "zerolatency", "crf": "23"}
"""x264 that keeps up with a camera and holds no frame back."""

_STEP = Fraction(1, 1000)
"""Of the times in Matroska, s."""

_SETTLING_S, _FOLLOWING_S = 2.0, 5.0
_JUMP_S = 0.05
_SHOWN_PX = 320
_MOST_BROKEN = 150  # frames, before the first whole one
_SILENCE_DB = -100.0


class LiveClip:
    """Frames and sound on one machine clock, in Matroska.

    Args:
        path: of the new file.
        camera: whose frames are encoded, or copied where it has compressed them.
        microphone: whose sound is kept as PCM; None without.
        zero_s: monotonic time of media time 0.
    """

    def __init__(
        self, path: Path, camera: LiveInput, microphone: LiveInput | None, zero_s: float
    ) -> None:
        self.path, self.zero_s, self._camera = path, zero_s, camera
        self._writing, self._last_ms, self._is_open = threading.Lock(), -1, True
        self._reformatter = VideoReformatter()
        self._latest: VideoFrame | None = None
        with self._failing():
            self._file = av.open(str(path), "w", format="matroska", options=_MATROSKA)
            self._video = _video_stream(self._file, camera)
            self.sound = SoundLine(self._file, microphone) if microphone else None

    def add(self, live: Live, *, is_shown: bool) -> bool:
        """Write what was filmed; False for a frame that is broken or has no time of its own.

        Frames that the camera has compressed are decoded only if they are shown.
        """
        ms = round(1e3 * (live.host_s - self.zero_s))
        if ms <= self._last_ms:
            return False
        is_copied = self._camera.is_copied
        frame = _decoded(live.packet) if is_shown or not is_copied else None
        self._latest = frame or self._latest
        with self._failing():
            if is_copied:
                live.packet.stream = self._video
                self._write([live.packet], ms)
            elif frame is None:
                return False
            else:
                self._write(self._encoded(frame, ms), ms)
        self._last_ms = ms
        return True

    def _encoded(self, frame: VideoFrame, ms: int) -> list[AnyPacket]:
        yuv = self._reformatter.reformat(frame, format="yuv420p")
        yuv.pts, yuv.time_base = ms, _STEP
        yuv.pict_type = PictureType.NONE  # a raw frame says "key frame", each of them
        return self._video.encode(yuv)

    def _write(self, packets: Sequence[AnyPacket], ms: int) -> None:
        for one in packets:
            one.pts = one.dts = ms
            one.time_base = _STEP
            with self._writing:
                self._file.mux_one(one)

    def shown(self) -> NDArray[np.uint8] | None:
        """The latest frame that was decoded, small, as RGB."""
        frame = self._latest
        if frame is None:
            return None
        width = min(_SHOWN_PX, frame.width)
        height = max(1, round(frame.height * width / frame.width))
        small = VideoReformatter().reformat(frame, width, height, "rgb24")
        return np.asarray(small.to_ndarray(), dtype=np.uint8)

    def add_sound(self, live: Live) -> None:
        """Write what was heard; nothing of before media time 0."""
        assert self.sound is not None
        with self._failing():
            for one in self.sound.packets(live.packet, live.host_s - self.zero_s):
                with self._writing:
                    self._file.mux_one(one)

    def close(self) -> None:
        """Write the index; a file that is closed already stays as it is."""
        if not self._is_open:
            return
        self._is_open = False
        with self._failing(), self._writing:
            self._file.close()

    def _failing(self) -> AbstractContextManager[None]:
        return media_errors(
            self.path, Message("cannot be written"), Message("choose another folder")
        )


def _decoded(packet: AnyPacket) -> VideoFrame | None:
    with contextlib.suppress(
        av.error.FFmpegError
    ):  # as those at the start of some cameras
        for frame in packet.decode():
            return frame
    return None


def first_shown(camera: LiveInput, live: Iterator[Live]) -> Live:
    """The first frame that a clip can begin with; those before it are left out."""
    for one in itertools.islice(live, _MOST_BROKEN):
        is_whole = one.packet.is_keyframe or not camera.is_copied
        if is_whole and _decoded(one.packet) is not None:
            return one
    raise InputError(
        "none of its first {count} frames can be decoded",
        where=camera.name,
        remedy="choose another format of the camera (NAME,input_format=mjpeg)",
        count=_MOST_BROKEN,
    )


def _video_stream(file: OutputContainer, camera: LiveInput) -> VideoStream:
    source = camera.video
    if camera.is_copied:
        return file.add_stream_from_template(source)
    stream = file.add_stream("libx264", rate=camera.rate_hz, options=_QUICK)
    context = stream.codec_context
    context.width, context.height = (
        side - side % 2 for side in (source.width, source.height)
    )
    context.pix_fmt, context.time_base = "yuv420p", _STEP
    context.gop_size = key_frame_interval(camera.rate_hz)
    return stream


class SoundLine:
    """The sound of a microphone, placed by its stamps.

    They scatter by a millisecond or so, and the sound card's clock is not the machine's: the
    place of the samples follows the mean of the stamps, and never goes back. A jump begins
    a new run.
    """

    def __init__(self, file: OutputContainer, microphone: LiveInput) -> None:
        source = microphone.sound
        self._rate_hz, layout = source.rate, LAYOUTS[min(2, source.channels)]
        self._resampler = AudioResampler("s16", layout, self._rate_hz)
        self._stream = file.add_stream("pcm_s16le", rate=self._rate_hz, layout=layout)
        self._end_s, self._settled_s, self._written = -math.inf, 0.0, 0
        self._squares, self._blocks, self.jumps = 0.0, 0, 0
        self.level_db = _SILENCE_DB

    @property
    def residual_s(self) -> float:
        """RMS of the stamps about the line that places the sound."""
        return math.sqrt(self._squares / max(1, self._blocks))

    def packets(self, packet: AnyPacket, stamp_s: float) -> list[AnyPacket]:
        """What was heard from a media time on, encoded."""
        found: list[AnyPacket] = []
        for frame in cast("list[AudioFrame]", packet.decode()):
            for one in self._resampler.resample(frame):
                begin_s = self._placed_s(stamp_s, one.samples / self._rate_hz)
                self._measure(one)
                count = round(begin_s * self._rate_hz)
                if count >= self._written:
                    one.pts, one.time_base = count, Fraction(1, self._rate_hz)
                    found += self._stream.encode(one)
                    self._written = count + one.samples // 2
                stamp_s += one.samples / self._rate_hz
        return found

    def _placed_s(self, stamp_s: float, length_s: float) -> float:
        """The media time of a block: the end of the last one, or its stamp after a jump."""
        error_s = stamp_s - self._end_s
        if abs(error_s) > _JUMP_S:
            self.jumps += self._settled_s > 0.0
            self._end_s, self._settled_s, error_s = stamp_s, 0.0, 0.0
        elif self._settled_s > _SETTLING_S:
            self._squares, self._blocks = self._squares + error_s**2, self._blocks + 1
        self._settled_s += length_s
        share = length_s / min(_FOLLOWING_S, self._settled_s)
        begin_s = self._end_s + share * error_s
        self._end_s = begin_s + length_s
        return begin_s

    def _measure(self, frame: AudioFrame) -> None:
        peak = float(np.abs(frame.to_ndarray().astype(np.float32)).max(initial=0.0))
        self.level_db = max(_SILENCE_DB, 20.0 * math.log10(max(peak, 1e-9) / 32768.0))
