"""A clip in which flash, beep and a gentle force come at the same moment, each second.

With it a person finds out what the machine cannot know: how late a screen, a sound
output and a device are. Between the beats nothing is seen, heard or felt.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.errors import Progress, no_progress
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import Feedback, ForceTrack
from hapticplayer.playback.source import Source, no_feedback_for
from hapticplayer.storage import cache_root

PERIOD_S, FIRST_S, COUNT = 1.0, 0.4, 40
LENGTH_S = 0.080  # of flash, beep and force
PULSE_N = 0.8
LONGEST_AFTER_S = 0.7
"""A tap later than this after a beat is one before the next beat."""

FELT = Feedback.REALISTIC.value
_RATE_HZ, _SOUND_HZ, _TONE_HZ = 25, 48_000, 1000.0
_SIZE_PX = (320, 180)
_RISE_S, _LOUDNESS = 0.002, 0.5


def beat_times_s() -> NDArray[np.float64]:
    return FIRST_S + PERIOD_S * np.arange(COUNT, dtype=np.float64)


def beat_track() -> ForceTrack:
    """Return a push upwards at each beat (frame D, N)."""
    corners_s = np.array([-0.001, 0.0, LENGTH_S, LENGTH_S + 0.001])
    times_s = (beat_times_s()[:, None] + corners_s).ravel()
    force_n = np.zeros((len(times_s), 3), np.float32)
    force_n[:, 1] = np.tile([0.0, PULSE_N, PULSE_N, 0.0], COUNT)
    return ForceTrack(times_s, force_n, provenance={"made": "beats"})


def beat_source(progress: Progress = no_progress) -> Source:
    """Return the clip with its force, made in 1 s on first use; raises MediaError."""
    path = cache_root() / f"beats-{__version__}.mp4"
    if not path.is_file():
        length_s = COUNT * PERIOD_S
        write_clip(
            path,
            _frames(),
            frame_rate_hz=_RATE_HZ,
            audio=_sound(),
            is_quick=True,
            progress=lambda done_s: progress(done_s / length_s, ""),
        )
    clip = probe(path)
    tracks = {FELT: beat_track(), Feedback.NONE.value: no_feedback_for(clip)}
    return Source("beats", path, clip, tracks, None, FELT)


def _since_beat_s(rate_hz: int) -> NDArray[np.float64]:
    """Return for each sample how long ago the last beat was; counted in samples."""
    number = np.arange(round(COUNT * PERIOD_S * rate_hz))
    since = (number - round(FIRST_S * rate_hz)) % round(PERIOD_S * rate_hz)
    return since.astype(np.float64) / rate_hz


def _frames() -> Iterator[NDArray[np.uint8]]:
    width, height = _SIZE_PX
    dark = np.zeros((height, width, 3), np.uint8)
    bright = np.full_like(dark, 255)
    for since_s in _since_beat_s(_RATE_HZ):
        yield bright if since_s < LENGTH_S - 1e-9 else dark


def _sound() -> NDArray[np.float32]:
    since_s = _since_beat_s(_SOUND_HZ)
    edge_s = np.minimum(since_s, LENGTH_S - since_s)
    wave = np.sin(2.0 * np.pi * _TONE_HZ * since_s)
    tone = _LOUDNESS * np.clip(edge_s / _RISE_S, 0.0, 1.0) * wave
    return np.repeat(tone.astype(np.float32)[:, None], 2, axis=1)


class TapMeter:
    """How late a person taps to a beat: median and spread of the last taps.

    People tap a little before a beat they expect, for each sense by another few
    hundredths of a second; so this is a first guess, to be refined by eye, ear and hand.
    """

    LEAST, MOST = 8, 32

    def __init__(self) -> None:
        self._after_s: list[float] = []

    def tap(self, media_s: float) -> float:
        """Note a tap; return how long after its beat it came, s."""
        latest_s = LONGEST_AFTER_S - PERIOD_S
        after_s = (media_s - FIRST_S - latest_s) % PERIOD_S + latest_s
        self._after_s = [*self._after_s, after_s][-self.MOST :]
        return after_s

    @property
    def count(self) -> int:
        return len(self._after_s)

    @property
    def median_s(self) -> float | None:
        """The median, once there are enough taps."""
        if self.count < self.LEAST:
            return None
        return float(np.median(self._after_s))

    @property
    def spread_s(self) -> float:
        """Half of the middle half of the taps, s."""
        if not self._after_s:
            return 0.0
        low, high = np.percentile(self._after_s, [25.0, 75.0])
        return float(high - low) / 2.0


def relative_latencies_s(
    display_s: float, tapped_s: dict[str, float]
) -> dict[str, float]:
    """Return the latency of each output from the taps, s; none is negative.

    The first of the medians is the display, whose latency is known: taps show only
    differences.
    """
    reference_s = next(iter(tapped_s.values()))
    found = {name: display_s + at_s - reference_s for name, at_s in tapped_s.items()}
    below_s = min(0.0, *found.values())
    return {name: value - below_s for name, value in found.items()}
