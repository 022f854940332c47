"""Decodes sound into float32 blocks whose times are exact to the sample."""

import math
from collections import deque
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from av.audio.frame import AudioFrame
from av.audio.resampler import AudioResampler
from numpy.typing import NDArray

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import AnyClip
from hapticplayer.media.demux import ClipDecoder, PacketReader
from hapticplayer.media.opening import context_of, media_errors, origin_s, read_only
from hapticplayer.model.limits import MAX_AUDIO_CHANNELS, MAX_AUDIO_RATE_HZ

_PREROLL_S = 0.15
"""AAC needs the frame before, Opus 80 ms, MP3 its bit reservoir."""

_JITTER_S = 2.5e-3
"""Matroska rounds times to 1 ms; below this a block follows its predecessor."""

LAYOUTS = {1: "mono", 2: "stereo"}


@dataclass(frozen=True, slots=True, eq=False)
class AudioBlock:
    """Sound (n, channels) from `media_s` on: float32, C-contiguous, 1.0 full scale."""

    media_s: float
    samples: NDArray[np.float32]


class AudioDecoder(ClipDecoder[AudioFrame]):
    """The sound of a clip, resampled, from any position.

    One thread at a time. Gaps and edit lists show in the times of the blocks: a block
    that does not begin where the last one ended is preceded by silence.
    """

    _WHAT = Message("its sound cannot be set up")

    def __init__(
        self,
        path: AnyClip,
        *,
        rate_hz: int = 48_000,
        channels: int = 2,
        track: int = 0,
    ) -> None:
        """Open a sound of a clip at media time 0; more than 2 channels are mixed."""
        if channels not in LAYOUTS:
            raise ValueError(f"{channels} channels: only 1 or 2 can be asked for")
        self.rate_hz = rate_hz
        self.channels, self._track = channels, track
        super().__init__(path)

    def _set_up(self) -> None:
        heard = [s for s in self._container.streams.audio if context_of(s)]
        stream = heard[self._track] if self._track < len(heard) else None
        if stream is None or stream.time_base is None:
            raise MediaError(
                "it holds no sound",
                where=str(self._path),
                remedy="choose a clip with sound",
            )
        if not (
            0 < stream.rate <= MAX_AUDIO_RATE_HZ
            and 0 < stream.channels <= MAX_AUDIO_CHANNELS
        ):
            raise MediaError(
                "its sound has {channels} channels at {rate} Hz",
                where=str(self._path),
                remedy="convert its sound to stereo at 48 kHz",
                channels=stream.channels,
                rate=stream.rate,
            )
        self._time_base = stream.time_base
        self._origin_s = origin_s(self._container)
        read_only(self._container, stream)
        self._reader = PacketReader[AudioFrame](self._container, stream, self._path)
        self._restart(0.0)

    def seek(self, media_s: float) -> None:
        """Go to `media_s`: the next block begins there, or after it in a gap.

        Raises:
            MediaError: when the file cannot be read any more.
        """
        media_s = max(0.0, media_s)
        start_s = media_s - _PREROLL_S + self._origin_s
        self._reader.seek(math.floor(start_s / self._time_base))
        self._restart(media_s)

    def _restart(self, from_s: float) -> None:
        self._from_s = from_s
        self._blocks: deque[AudioBlock] = deque()
        self._begin_run()
        self._is_over = False

    def _begin_run(self) -> None:
        """Forget the run of contiguous sound; the next frame anchors a new one."""
        self._resampler: AudioResampler | None = None
        self._format: tuple[str, str, int] | None = None
        self._expected_s: float | None = None
        self._run_s = 0.0
        self._run_samples = 0

    def next_block(self) -> AudioBlock | None:
        """Return the next block, None at the end; raises MediaError if that fails."""
        while not self._blocks:
            if self._is_over:
                return None
            frame = self._reader.next_frame()
            with media_errors(self._path, Message("its sound cannot be resampled")):
                self._take(frame)
        return self._blocks.popleft()

    def _take(self, frame: AudioFrame | None) -> None:
        if frame is None:
            self._is_over = True
            self._flush()
            return
        format_ = (frame.format.name, frame.layout.name, frame.sample_rate)
        start_s = self._start_s(frame)
        if format_ != self._format or self._is_gap(start_s):
            self._flush()
            self._begin_run()
            layout = LAYOUTS[self.channels]
            if format_ != ("fltp", layout, self.rate_hz):
                self._resampler = AudioResampler("flt", layout, self.rate_hz)
            self._format = format_
            self._run_s = start_s
            self._expected_s = start_s
        assert self._expected_s is not None
        self._expected_s += frame.samples / frame.sample_rate
        resampler = self._resampler
        self._emit([frame] if resampler is None else resampler.resample(frame))

    def _flush(self) -> None:
        """Push the resampler's last samples out at the end of a run."""
        if self._resampler is not None:
            self._emit(self._resampler.resample(None))

    def _start_s(self, frame: AudioFrame) -> float:
        if frame.time is None:
            return 0.0 if self._expected_s is None else self._expected_s
        return frame.time - self._origin_s

    def _is_gap(self, start_s: float) -> bool:
        return self._expected_s is None or abs(start_s - self._expected_s) > _JITTER_S

    def _emit(self, frames: list[AudioFrame]) -> None:
        for frame in frames:
            samples = self._samples(frame)
            media_s = self._run_s + self._run_samples / self.rate_hz
            self._run_samples += len(samples)
            early = max(0, round((self._from_s - media_s) * self.rate_hz))
            if early < len(samples):
                kept = np.ascontiguousarray(samples[early:])
                kept.setflags(write=False)
                self._blocks.append(AudioBlock(media_s + early / self.rate_hz, kept))

    def _samples(self, frame: AudioFrame) -> NDArray[np.float32]:
        planes = cast("Any", frame.planes)
        samples = np.empty((frame.samples, self.channels), np.float32)
        if frame.format.is_planar:
            for channel, plane in enumerate(planes):
                samples[:, channel] = np.frombuffer(plane, np.float32, frame.samples)
        else:
            flat = np.frombuffer(planes[0], np.float32, samples.size)
            samples[:] = flat.reshape(samples.shape)
        return samples
