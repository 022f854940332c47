"""Scores every shift between two clocks by the events that coincide there.

A shift is likely if events coincide that are rare in both streams. A pair of events with
rarities r_a, r_i and an error e from the shift has the likelihood ratio

    n g(r_a) g(r_i) N(e; 0, s)

of one common event against two that coincide by chance: chance pairs have density 1 per
unit of r_a, r_i and e, by the definition of rarity. g is the density of a common event's
rarity, c / (r + c)^2. For three pats the sum over triples of pairs with plausible
intervals is added (`best_triple`).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from hapticplayer.capture.sync.events import Events
from hapticplayer.model.arrays import Floats

INTERVAL_S = (0.18, 1.0)
"""Shortest and longest time between two pats."""

_COMMON_PER_S = 0.15  # common events other than pats
_COMMON_RARITY_HZ = 0.25
_PAT_RARITY_HZ = 0.06  # half of all pats are rarer
_RHYTHM = 0.16  # SD of the logarithm of the second interval over the first
_REACH = 3.0  # standard deviations of coincidence
_STEPS = 3  # grid points per standard deviation
_CANDIDATES = 40
_PATS_AT_MOST = 40  # pairs considered for triples
_MISS = 30.0
_MOST_CELLS = 4_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Coincidence:
    """Agreement of the times of coincident events.

    Attributes:
        late_s: mean delay of the log's event against the sound's.
        sigma_s: SD of the difference.
    """

    late_s: float
    sigma_s: float


@dataclass(frozen=True, slots=True, eq=False)
class Triple:
    """Three pats in both streams.

    Attributes:
        sound: (3,) indices of events of the sound.
        shock: (3,) indices of events of the log.
        evidence: logarithm of the likelihood ratio of all triples at this shift.
    """

    sound: NDArray[np.intp]
    shock: NDArray[np.intp]
    evidence: float


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A shift with its evidence.

    Attributes:
        shift_s: media time minus log time.
        evidence: logarithm of the likelihood ratio against chance.
        common: the part of it without the pats.
        triple: the pats, or None.
    """

    shift_s: float
    evidence: float
    common: float
    triple: Triple | None


@dataclass(frozen=True, slots=True, eq=False)
class _Pairs:
    """All pairs of events with an allowed shift."""

    sound: NDArray[np.intp]
    shock: NDArray[np.intp]
    shift_s: Floats
    common: Floats  # n g(r_a) g(r_i)
    pat: Floats  # log(g(r_a) g(r_i))


def candidates(
    sound: Events,
    shock: Events,
    match: Coincidence,
    allowed_s: tuple[float, float],
) -> list[Candidate]:
    """Return shifts with positive evidence, the best first.

    Args:
        sound: events of the sound, in media time.
        shock: events of the log, in its own time.
        match: agreement of coincident events.
        allowed_s: smallest and largest shift.
    """
    pairs = _pairs(sound, shock, match, allowed_s)
    if not len(pairs.shift_s):
        return []
    found = []
    for shift_s in _coarse(pairs, match):
        near = np.abs(pairs.shift_s - shift_s) < _REACH * match.sigma_s
        found.append(_weigh(pairs, np.flatnonzero(near), sound, shift_s, match))
    found.sort(key=lambda candidate: -candidate.evidence)
    return found


def _pairs(
    sound: Events,
    shock: Events,
    match: Coincidence,
    allowed_s: tuple[float, float],
) -> _Pairs:
    shift_s = sound.time_s[:, None] - (shock.time_s - match.late_s)[None, :]
    i, j = np.nonzero((shift_s >= allowed_s[0]) & (shift_s <= allowed_s[1]))
    densities = [
        [rare / (events.rarity_hz + rare) ** 2 for events in (sound, shock)]
        for rare in (_COMMON_RARITY_HZ, _PAT_RARITY_HZ)
    ]
    common, pat = (a[i] * b[j] for a, b in densities)
    return _Pairs(i, j, shift_s[i, j], _COMMON_PER_S * common, np.log(pat))


def _coarse(pairs: _Pairs, match: Coincidence) -> Floats:
    """Return the shifts with the most coincident events."""
    step_s = max(match.sigma_s / _STEPS, float(np.ptp(pairs.shift_s)) / _MOST_CELLS)
    begin_s = float(pairs.shift_s.min()) - 2 * _REACH * match.sigma_s
    cell = np.round((pairs.shift_s - begin_s) / step_s).astype(np.intp)
    reach = round(_REACH * _STEPS)
    count = int(cell.max()) + reach + 2
    total = np.zeros(count)
    # a pair of pats counts like one of three within seconds, to rank triples first
    odds = np.maximum(pairs.common, 0.05 * np.exp(pairs.pat))
    strong = odds * _normal(0.0, match.sigma_s) > 0.02
    cell, odds = cell[strong], odds[strong]
    for k in range(-reach, reach + 1):
        gain = np.log1p(odds * _normal(k * step_s, match.sigma_s))
        total += np.bincount(cell + k, gain, count)[:count]
    found = []
    for _ in range(_CANDIDATES):
        best = int(np.argmax(total))
        if total[best] <= 0.0:
            break
        found.append(begin_s + best * step_s)
        total[max(0, best - 2 * _STEPS) : best + 2 * _STEPS + 1] = 0.0
    return np.array(found)


def _normal(error_s: float | Floats, sigma_s: float) -> Floats:
    z = np.asarray(error_s) / sigma_s
    return np.asarray(np.exp(-0.5 * z * z) / (np.sqrt(2 * np.pi) * sigma_s))


def _weigh(
    pairs: _Pairs,
    near: NDArray[np.intp],
    sound: Events,
    shift_s: float,
    match: Coincidence,
) -> Candidate:
    """Score one shift: one partner per event, pats and other events."""
    close = _normal(pairs.shift_s[near] - shift_s, match.sigma_s)
    near = near[_one_to_one(pairs, near, pairs.common[near] * close)]
    close = _normal(pairs.shift_s[near] - shift_s, match.sigma_s)
    gain = np.log1p(pairs.common[near] * close)
    triple = best_triple(pairs, near, sound, match)
    common = float(gain.sum())
    if triple is None:
        return Candidate(shift_s, common - _MISS, common, None)
    is_pat = np.isin(pairs.sound[near], triple.sound)
    common -= float(gain[is_pat].sum())
    return Candidate(shift_s, common + triple.evidence, common, triple)


def _one_to_one(
    pairs: _Pairs, near: NDArray[np.intp], weight: Floats
) -> NDArray[np.intp]:
    kept, sounds, shocks = [], set(), set()
    for k in np.argsort(-weight):
        a, b = int(pairs.sound[near[k]]), int(pairs.shock[near[k]])
        if a not in sounds and b not in shocks:
            sounds.add(a)
            shocks.add(b)
            kept.append(int(k))
    return np.array(sorted(kept), dtype=np.intp)


def best_triple(
    pairs: _Pairs, near: NDArray[np.intp], sound: Events, match: Coincidence
) -> Triple | None:
    """Return the most likely three pats among pairs that share a shift."""
    strongest = near[np.argsort(-pairs.pat[near])[:_PATS_AT_MOST]]
    chosen = strongest[np.argsort(sound.time_s[pairs.sound[strongest]])]
    time_s = sound.time_s[pairs.sound[chosen]]
    gap_s = time_s[None, :] - time_s[:, None]
    p, q = np.nonzero((gap_s >= INTERVAL_S[0]) & (gap_s <= INTERVAL_S[1]))
    # each (p, q) is followed by every (q, r)
    follow = np.flatnonzero(q[:, None] == p[None, :])
    if not len(follow):
        return None
    first, second = np.divmod(follow, len(p))
    rows = np.stack([p[first], q[first], q[second]], axis=1)
    weight = _triple_weight(pairs, chosen[rows], time_s[rows], match)
    best = chosen[rows[int(np.argmax(weight))]]
    return Triple(pairs.sound[best], pairs.shock[best], float(logsumexp(weight)))


def _triple_weight(
    pairs: _Pairs, rows: NDArray[np.intp], time_s: Floats, match: Coincidence
) -> Floats:
    """Return the log likelihood ratio of each triple (M,)."""
    shifts_s = pairs.shift_s[rows]
    error_s = shifts_s - shifts_s.mean(axis=1, keepdims=True)
    apart = (error_s**2).sum(axis=1) / match.sigma_s**2
    # the mean is fitted and has the density of one pair's shift
    fit = -0.5 * apart - 2.0 * np.log(np.sqrt(2 * np.pi) * match.sigma_s)
    gaps_s = np.diff(time_s, axis=1)
    rhythm = unevenness(gaps_s)
    steady = -0.5 * rhythm**2 - np.log(np.sqrt(2 * np.pi) * _RHYTHM * gaps_s[:, 1])
    first = -np.log(INTERVAL_S[1] - INTERVAL_S[0])
    return np.asarray(pairs.pat[rows].sum(axis=1) + fit + steady + first)


def unevenness(gaps_s: Floats) -> Floats:
    """Return how much the rhythm of pats (..., 2) changes, in standard deviations."""
    return np.asarray(np.log(gaps_s[..., 1] / gaps_s[..., 0]) / _RHYTHM)
