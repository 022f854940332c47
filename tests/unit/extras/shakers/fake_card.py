"""A sound card in virtual time: it asks ahead, in blocks, and keeps what has sounded."""

import numpy as np

from hapticplayer.extras.shakers.driver import AHEAD_S, BLOCK
from hapticplayer.extras.shakers.signal import SAMPLE_HZ

BLOCK_S = BLOCK / SAMPLE_HZ


class FakeCard:
    def __init__(self, clock):
        self.clock = clock
        self.is_asking, self.is_there, self.problem = True, True, ""
        self.fill, self.waiting, self.width = None, None, 2
        self._blocks = []  # (time of the first sample, samples)
        self._next_s = 0.0

    def stream(self, settings, fill, _clock):
        self.waiting, self.width = fill, settings.width
        return self

    def begin(self):
        self.fill = self.waiting
        self._next_s = self.clock.now_s() + AHEAD_S

    def drop(self):
        now_s = self.clock.now_s()
        self._blocks = [one for one in self._blocks if one[0] < now_s]
        self._next_s = now_s + AHEAD_S

    def close(self):
        self.drop()
        self.fill = None

    def play(self):
        while self.fill and self.is_asking:
            if self._next_s > self.clock.now_s() + AHEAD_S:
                return
            out = np.zeros((BLOCK, self.width), np.float32)
            self.fill(out, self._next_s, BLOCK)
            self._blocks.append((self._next_s, out))
            self._next_s += BLOCK_S

    def heard(self, seconds):
        """Return what has sounded in the last seconds, (samples, width)."""
        now_s = self.clock.now_s()
        if not self._blocks or not self.is_there:
            return np.zeros((0, self.width))
        times = np.concatenate(
            [begin_s + np.arange(BLOCK) / SAMPLE_HZ for begin_s, _ in self._blocks]
        )
        samples = np.concatenate([out for _, out in self._blocks])
        return samples[(times > now_s - seconds) & (times <= now_s)]
