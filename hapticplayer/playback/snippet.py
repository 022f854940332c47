"""A few seconds of a clip's sound, with ticks at the tap marks of a log, played once."""

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.playback.sound_memory import CHANNELS
from hapticplayer.playback.sound_ring import RATE_HZ

LONGEST_S = 20.0
_PEAK = 0.8
_TICK_HZ, _TICK_S, _TICK = 2000.0, 0.012, 0.5

Samples = NDArray[np.float32]


def pats_sound(
    clip: Path, begin_s: float, end_s: float, ticks_s: Sequence[float]
) -> Samples:
    """The sound of a span of media time (n, 2), with a tick at some times.

    The clip is on the left and the ticks are on the right, so that even a few
    milliseconds between them are heard; on one loudspeaker both are. The span is at
    most `LONGEST_S` long.
    """
    begin_s = max(0.0, begin_s)
    count = max(1, round(min(end_s - begin_s, LONGEST_S) * RATE_HZ))
    heard = np.zeros((count, CHANNELS), dtype=np.float32)
    with AudioDecoder(clip, rate_hz=RATE_HZ, channels=1) as decoder:
        decoder.seek(begin_s)
        while (block := decoder.next_block()) is not None:
            at = round((block.media_s - begin_s) * RATE_HZ)
            if at >= count:
                break
            _add(heard[:, 0], at, block.samples[:, 0])
    loudest = float(np.abs(heard).max())
    if loudest > 0.0:
        heard *= _PEAK / loudest
    time_s = np.arange(round(_TICK_S * RATE_HZ)) / RATE_HZ
    tick = _TICK * np.sin(2 * np.pi * _TICK_HZ * time_s) * np.exp(-time_s / 0.003)
    for at_s in ticks_s:
        _add(heard[:, 1], round((at_s - begin_s) * RATE_HZ), tick.astype(np.float32))
    return heard


def _add(target: Samples, at: int, samples: Samples) -> None:
    """Add samples that begin at a row; what is outside is left out."""
    first, last = max(0, at), min(len(target), at + len(samples))
    if last > first:
        target[first:last] += samples[first - at : last - at]


def play(samples: Samples) -> None:
    """Begin to play (n, 2) samples at `RATE_HZ` in place of others; raises OSError."""
    import sounddevice  # raises OSError without PortAudio

    try:
        sounddevice.play(samples, RATE_HZ)
    except Exception as problem:
        raise OSError(
            Message("there is no sound output: {reason}", reason=problem)
        ) from problem


def stop() -> None:
    if sounddevice := sys.modules.get("sounddevice"):  # else nothing has played
        sounddevice.stop()
