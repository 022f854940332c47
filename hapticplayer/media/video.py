"""Decodes the frames of a clip at exact times; `frames` converts those that are shown."""

import math
from collections.abc import Iterator
from typing import ClassVar

from av.container import InputContainer
from av.video.frame import VideoFrame
from av.video.stream import VideoStream

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_info import frame_rate_hz, require_video, shown_size
from hapticplayer.media.demux import ClipDecoder, PacketReader
from hapticplayer.media.frames import DecodedFrame, check_convertible, rotation_of
from hapticplayer.media.opening import media_errors, origin_s, read_only
from hapticplayer.model.limits import MAX_PIXELS
from hapticplayer.untrusted import COPY_AGAIN

_FALLBACK_RATE_HZ = 30.0
_LONGEST_FRAME_S = 60.0
_TIME_TOLERANCE_S = 1e-6
"""Times travel as float64 seconds; a microsecond is far below any time base."""

# H.264 on one core of a 2 GHz server, fitted to 720p30 with 3.5 and 20 Mbit/s and
# 1080p60 with 9 Mbit/s, within 2 % of a core
_PERCENT_PER_MPIXEL_PER_S = 0.1
_PERCENT_PER_MBIT_PER_S = 1.0
_EASY_PERCENT = 30.0
"""A machine of a third of that speed still keeps up."""

_STEPS_BACK_S = (0.0, 1.0, 10.0, math.inf)
"""Where to seek again when a container lands behind the wanted frame."""


class VideoDecoder(ClipDecoder[VideoFrame]):
    """The frames of a clip, in order, from any position.

    One thread at a time. A damaged packet is skipped and counted in `damaged`; only an
    error that ends the stream raises. Sizes are as shown, after rotation and with
    square pixels.

    Raises:
        MediaError: when it cannot be opened or holds no video.
    """

    _WHAT = Message("its video cannot be set up")
    _OPTIONS: ClassVar[dict[str, str]] = {}
    """Further ones of the codec."""

    def _set_up(self) -> None:
        self._stream = require_video(self._container, self._path)
        self._origin_s = origin_s(self._container)
        self._tick_s = float(self._stream.time_base or 0)
        choose_threads(self._container, self._stream)
        options = {"max_pixels": str(MAX_PIXELS), **self._OPTIONS}
        self._stream.codec_context.options = options
        read_only(self._container, self._stream)
        self._reader = PacketReader[VideoFrame](
            self._container, self._stream, self._path
        )
        self.frame_rate_hz = frame_rate_hz(self._stream) or _FALLBACK_RATE_HZ
        self.width, self.height = shown_size(self._stream, 0)
        self._pending: list[DecodedFrame] = []
        self._last: DecodedFrame | None = None
        self._wanted: int | None = None
        first = self.next_frame()
        if first is None:
            raise MediaError(
                "none of its frames can be decoded",
                where=str(self._path),
                remedy=COPY_AGAIN,
            )
        with media_errors(self._path, Message("its pixel format cannot be converted")):
            check_convertible(first.native)
        self._pending.append(first)
        rotation_deg = rotation_of(first.native)
        self.width, self.height = shown_size(self._stream, rotation_deg)

    def close(self) -> None:
        """Release the file and the decoder."""
        self._pending.clear()
        super().close()

    def seek(self, media_s: float) -> None:
        """Go to the frame that covers `media_s`; `next_frame` returns it.

        Before the first frame the first one is next, after the last the last.
        Decodes up to one group of pictures, in H.264 without the frames that no other
        frame refers to.

        Raises:
            MediaError: when the file cannot be read any more.
        """
        frame: DecodedFrame | None = None
        for step_s in _STEPS_BACK_S:
            from_s = max(0.0, media_s - step_s)
            frame = self._land(from_s, media_s)
            is_before = frame and frame.pts_s <= media_s + _TIME_TOLERANCE_S
            if is_before or from_s == 0.0:
                break
        self._skip_to(frame, media_s)

    def _land(self, from_s: float, media_s: float) -> DecodedFrame | None:
        """Seek to the key frame before `from_s` and decode the first frame."""
        self._reader.seek(self._ticks(from_s))
        self._pending.clear()
        self._last = None
        self._wanted = self._reader.read_ahead(self._ticks(media_s))
        return self.next_frame()

    def _ticks(self, media_s: float) -> int:
        assert self._stream.time_base is not None
        container_s = media_s + self._origin_s + _TIME_TOLERANCE_S
        return math.floor(container_s / self._stream.time_base)

    def _skip_to(self, frame: DecodedFrame | None, media_s: float) -> None:
        """Decode until the next frame is later than `media_s`."""
        while frame is not None:
            if self._wanted is not None and frame.native.pts == self._wanted:
                self._pending = [frame]
                return
            following = self.next_frame()
            is_later = (
                following is None or following.pts_s > media_s + _TIME_TOLERANCE_S
            )
            if is_later:
                kept = (frame, following)
                self._pending = [f for f in kept if f is not None]
                return
            frame = following

    def frames(self) -> Iterator[DecodedFrame]:
        """Yield the frames from here to the end."""
        while (frame := self.next_frame()) is not None:
            yield frame

    def next_frame(self) -> DecodedFrame | None:
        """Return the next frame, or None at the end.

        Times increase strictly until the next `seek`: a frame without a time, or
        with one that runs backwards, follows its predecessor.

        Raises:
            MediaError: when the stream cannot be decoded any further.
        """
        if self._pending:
            return self._pending.pop(0)
        native = self._reader.next_frame()
        if native is None:
            return None
        frame = DecodedFrame(self._pts_s(native), self._duration_s(native), native)
        self._last = frame
        return frame

    def _pts_s(self, native: VideoFrame) -> float:
        last = self._last
        following_s = 0.0 if last is None else last.pts_s + last.duration_s
        if native.pts is not None:
            at_s = native.time  # in C: a Fraction for each frame costs 50 us
        elif native.dts is not None:
            at_s = native.dts * self._tick_s
        else:
            return following_s
        pts_s = at_s - self._origin_s
        is_backwards = last is not None and pts_s <= last.pts_s
        return following_s if is_backwards else pts_s

    def _duration_s(self, native: VideoFrame) -> float:
        duration_s = 0.0
        if native.duration:
            duration_s = native.duration * self._tick_s
        is_sane = 0.0 < duration_s < _LONGEST_FRAME_S
        return duration_s if is_sane else 1.0 / self.frame_rate_hz


def choose_threads(container: InputContainer, stream: VideoStream) -> None:
    """Decode with one thread where that is fast enough.

    Frame threads share a frame between two cores' caches: one thread takes 12 % less CPU
    (720p30 and 1080p60, H.264).
    """
    is_easy = 0.0 < _decoding_percent(container, stream) < _EASY_PERCENT
    stream.thread_type = "NONE" if is_easy else "AUTO"
    if is_easy:
        stream.codec_context.thread_count = 1


def _decoding_percent(container: InputContainer, stream: VideoStream) -> float:
    """The load of decoding, percent of a core; 0 where that is unknown."""
    rate = stream.average_rate or stream.guessed_rate
    bit_rate = stream.bit_rate or container.bit_rate
    if stream.codec_context.name != "h264" or not rate or not bit_rate:
        return 0.0
    mpixels_per_s = 1e-6 * stream.width * stream.height * float(rate)
    return (
        _PERCENT_PER_MPIXEL_PER_S * mpixels_per_s
        + _PERCENT_PER_MBIT_PER_S * 1e-6 * bit_rate
    )
