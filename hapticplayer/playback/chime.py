"""A short sound beside that of a clip, through an output of its own."""

import numpy as np

from hapticplayer.playback.sound import AudioFactory
from hapticplayer.playback.sound_memory import CHANNELS
from hapticplayer.playback.sound_ring import RATE_HZ, AudioRing

TONE_HZ, LASTS_S, FADE_S, LOUD = 880.0, 0.18, 0.02, 0.25


class Chime:
    """Can be heard from now until `close`; without an output it is silent.

    Raises:
        OSError: when the output cannot be opened.
    """

    def __init__(self, make: AudioFactory, volume: float) -> None:
        self._ring = AudioRing()
        self._ring.gain = volume**3
        self._out = make(self._ring)
        time_s = np.arange(0.0, LASTS_S, 1.0 / RATE_HZ)
        fade = np.minimum(1.0, np.minimum(time_s, LASTS_S - time_s) / FADE_S)
        tone = LOUD * fade * np.sin(2.0 * np.pi * TONE_HZ * time_s)
        self._tone = np.repeat(tone[:, None], CHANNELS, axis=1).astype(np.float32)

    def play(self) -> None:
        self._out.poll()
        generation = self._ring.load(0, 0.0)
        self._ring.write(generation, 0.0, self._tone)
        self._ring.finish(generation)
        self._ring.play()

    def close(self) -> None:
        self._out.close()
        self._ring.close()
