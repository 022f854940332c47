"""Sound at another speed with the pitch it had, and each onset at its own time.

WSOLA (Verhelst and Roelands, ICASSP 1993): pieces of the sound are put one after the
other, each taken from near where the speed wants it and cross-faded where it fits best.
What begins suddenly is copied as it is and comes at the time that the speed gives it,
once (after Grofit and Lavner, IEEE TASL 2008): FFmpeg's `atempo` puts such onsets 11 to
36 ms early, in a band of up to 25 ms, and a person notices 24 ms between sound and force.
"""

from collections import deque

import numpy as np
from numpy.typing import NDArray

from hapticplayer.media.audio import AudioBlock

Floats = NDArray[np.float32]

_GAP_S = 0.005
"""A block farther than this from the end of the last one begins a new run."""

_PIECE_S = 0.040
_FADE_S = 0.030
_SHORTEST_FADE_S = 0.002
_SEARCH_S = 0.015
"""Each way. The four of them were chosen by what three chords lose of their purity."""
_ONSET_SEARCH_S = 0.0005
_ATTACK_S = 0.005
"""Of an onset; it is not repeated."""
_HOLD_S = 0.010
"""So long after an onset the sound is copied as it is."""
_NEARER = 0.02
"""A fit has to be better by this to be taken from as far as the search goes."""

_BIN_S = 0.001
_BINS_BEFORE, _BINS_AFTER, _BINS_BETWEEN = 12, 2, 30
_ONSET_RATIO = 8.0
"""Of the energy; pulses of a voice reach 5 against the 12 ms before."""
_LIKE_THE_GREATEST = 0.7
_SILENCE = 1e-7


class AudioStretcher:
    """Takes blocks of sound, returns blocks that last 1/speed as long.

    The time of a returned block is the media time of its first sample; the next
    sample lies `speed / rate_hz` later.

    Args:
        speed: 0.5 to 4; what is left of one second of media is 1/speed seconds.
        rate_hz: of the blocks.
        channels: of the blocks.
    """

    def __init__(self, speed: float, rate_hz: int, channels: int) -> None:
        self.is_over = False
        self._speed = speed
        self._rate_hz = rate_hz
        self._channels = channels
        self._run: _Run | None = None
        self._next_s = 0.0  # media time that follows what was taken
        self._out_s = 0.0  # media time of the next sample that is returned

    def push(self, block: AudioBlock | None) -> list[AudioBlock]:
        """Return what has become ready; None says that the sound has ended."""
        if block is None:
            self.is_over = True
            return self._flush()
        made: list[AudioBlock] = []
        if self._run is None or abs(block.media_s - self._next_s) > _GAP_S:
            made = self._flush()
            self._run = _Run(self._speed, self._rate_hz, self._channels)
            self._out_s = block.media_s
        self._next_s = block.media_s + len(block.samples) / self._rate_hz
        self._run.take(block.samples)
        return made + self._blocks(self._run.ready())

    def _flush(self) -> list[AudioBlock]:
        if self._run is None:
            return []
        made = self._blocks(self._run.rest())
        self._run = None
        return made

    def _blocks(self, pieces: list[Floats]) -> list[AudioBlock]:
        if not pieces:
            return []
        samples = np.concatenate(pieces)
        block = AudioBlock(self._out_s, samples)
        self._out_s += len(samples) / self._rate_hz * self._speed
        return [block]


class _Run:
    """Sound without a gap; indices count its samples, in and out."""

    def __init__(self, speed: float, rate_hz: int, channels: int) -> None:
        self._speed = speed
        self._piece, self._fade, self._search = (
            round(s * rate_hz) for s in (_PIECE_S, _FADE_S, _SEARCH_S)
        )
        self._short, self._tight, self._attack, self._hold = (
            round(s * rate_hz)
            for s in (_SHORTEST_FADE_S, _ONSET_SEARCH_S, _ATTACK_S, _HOLD_S)
        )
        self._sound: Floats = np.zeros((0, channels), np.float32)
        self._first = 0  # index of the first sample that is kept
        self._out = self._next = 0  # next of the output; of the input, unless cut
        self._onsets = _Onsets(rate_hz)
        self._last_onset = -self._piece

    @property
    def _end(self) -> int:
        return self._first + len(self._sound)

    def take(self, samples: Floats) -> None:
        """Append input."""
        self._onsets.take(samples)
        self._sound = np.concatenate([self._sound, samples])

    def ready(self) -> list[Floats]:
        """Return the pieces for which enough input is known."""
        pieces = []
        # an onset is looked for so far ahead, and its piece ends behind it
        far = round(self._speed * (self._piece + self._short))
        far += 2 * (self._piece + self._fade) + self._search + self._onsets.lookahead
        while max(self._nominal(), self._next) + far < self._end:
            pieces.append(self._make_piece())
        self._forget()
        return pieces

    def rest(self) -> list[Floats]:
        """Return the end, as long as the speed makes it."""
        wanted = round(self._end / self._speed) - self._out
        padding = round(6 * self._piece * max(1.0, self._speed))
        silence = np.zeros((padding, self._sound.shape[1]), np.float32)
        self._sound = np.concatenate([self._sound, silence])
        pieces = []
        while wanted > 0:
            piece = self._make_piece()[:wanted]
            wanted -= len(piece)
            pieces.append(piece)
        return pieces

    def _nominal(self) -> int:
        """Where a piece begins whose middle is where the speed wants it."""
        half = 0.5 * self._piece
        return max(0, round(self._speed * (self._out + half) - half))

    def _make_piece(self) -> Floats:
        """Return the next piece and go on behind it."""
        onset = self._onsets.next_after((self._out + self._short) * self._speed)
        length, fade, at = self._piece, self._fade, self._nominal()
        low = max(at - self._search, self._last_onset + self._attack)
        high = at + self._search
        if onset is not None:
            ahead = round(onset / self._speed) - self._out
            fade = max(self._short, min(fade, ahead, onset - self._next))
            if ahead <= self._piece + self._short:
                length, at = ahead + self._hold, onset - ahead
                low, high = at - self._tight, at + self._tight
                self._last_onset = onset
            else:
                high = min(high, onset - length - self._short)
        begin = self._best(max(low, self._first), at, high, fade)
        piece = self._between(begin, length).copy()
        self._fade_in(piece[:fade])
        self._next = begin + length
        self._out += length
        return piece

    def _fade_in(self, head: Floats) -> None:
        """Cross-fade the head of a piece with how the sound before goes on."""
        share = np.linspace(1.0, 0.0, len(head), dtype=np.float32)[:, None]
        head += share * (self._between(self._next, len(head)) - head)

    def _best(self, low: int, at: int, high: int, fade: int) -> int:
        """Return where in `low`..`high` the sound goes on best, near `at` if it can."""
        if high <= low:
            return max(high, self._first)
        wanted = self._between(self._next, fade).sum(axis=1)
        there = self._between(low, high - low + fade).sum(axis=1)
        product = np.correlate(there, wanted, "valid")
        energy = np.concatenate([[0.0], np.cumsum(there.astype(np.float64) ** 2)])
        norm = np.sqrt((energy[fade:] - energy[:-fade]).clip(0.0))
        norm *= np.linalg.norm(wanted)
        off = np.abs(np.arange(low, high + 1) - at) / self._search
        return low + int(np.argmax(product / (norm + _SILENCE) - _NEARER * off))

    def _between(self, begin: int, count: int) -> Floats:
        at = begin - self._first
        return self._sound[at : at + count]

    def _forget(self) -> None:
        """Drop what no piece will want any more."""
        oldest = min(self._nominal(), self._next) - 4 * self._piece
        if oldest > self._first + 8 * self._piece:
            self._sound = self._sound[oldest - self._first :]
            self._first = oldest


class _Onsets:
    """Finds where the energy of the differences leaps up.

    Attributes:
        lookahead: so many samples before the end, onsets are not known yet.
    """

    def __init__(self, rate_hz: int) -> None:
        self._bin = round(_BIN_S * rate_hz)
        self.lookahead = (_BINS_AFTER + _BINS_BETWEEN + 1) * self._bin
        self._rest: Floats = np.zeros(1, np.float32)
        # the first of these bins is the first that still may be an onset, less 12
        self._energies: NDArray[np.float64] = np.zeros(_BINS_BEFORE)
        self._bins = -_BINS_BEFORE  # number of the first
        self._found: deque[int] = deque()

    def take(self, samples: Floats) -> None:
        """Look at more sound."""
        mono = np.concatenate([self._rest, samples.sum(axis=1)])
        whole = (len(mono) - 1) // self._bin
        self._rest = mono[whole * self._bin :]
        steps = np.diff(mono[: whole * self._bin + 1]).astype(np.float64)
        fresh = (steps.reshape(whole, self._bin) ** 2).mean(axis=1)
        self._energies = np.concatenate([self._energies, fresh])
        self._look()

    def next_after(self, index: float) -> int | None:
        """Return the first onset at or after an index, forgetting those before."""
        while self._found and self._found[0] < index:
            self._found.popleft()
        return self._found[0] if self._found else None

    def _look(self) -> None:
        """Find the onsets of those bins whose neighbours are known."""
        count = len(self._energies) - _BINS_BEFORE - _BINS_AFTER - _BINS_BETWEEN
        if count <= 0:
            return
        leap = self._leaps()
        done = 0
        while done < count:
            first = done + int(np.argmax(leap[done:] > 0.0))
            if leap[first] <= 0.0 or first >= count:
                done = count
                break
            group = leap[first : first + _BINS_BETWEEN]
            # what a lossy codec lets be heard before is less than the onset itself
            onset = first + int(np.argmax(group >= _LIKE_THE_GREATEST * group.max()))
            self._found.append((self._bins + _BINS_BEFORE + onset) * self._bin)
            done = onset + _BINS_BETWEEN
        kept = min(done, len(self._energies) - _BINS_BEFORE)
        self._energies = self._energies[kept:]
        self._bins += kept

    def _leaps(self) -> NDArray[np.float64]:
        """Return by how much the energy leaps at each bin, 0 where it does not."""
        sums = np.concatenate([[0.0], np.cumsum(self._energies)])
        at = np.arange(_BINS_BEFORE, len(self._energies) - _BINS_AFTER + 1)
        before = (sums[at] - sums[at - _BINS_BEFORE]) / _BINS_BEFORE
        after = (sums[at + _BINS_AFTER] - sums[at]) / _BINS_AFTER
        return np.where(after > _ONSET_RATIO * before + _SILENCE, after - before, 0.0)
