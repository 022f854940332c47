"""Synchronises by three pats on the camera, in its sound and in the log."""

import dataclasses
import math
from dataclasses import dataclass

import numpy as np

from hapticplayer.capture.sync.events import Events, shock_events, shocks
from hapticplayer.capture.sync.fit import Whitener, fit_shift
from hapticplayer.capture.sync.result import Pat, Rival, Synchronisation
from hapticplayer.capture.sync.shifts import Candidate, Coincidence, candidates
from hapticplayer.model import ClockMap, ImuLog

LONG_S = 150.0
"""From this length on the clock rate is estimated: 50 ppm are 8 ms."""

DRIFT_PRIOR = 50e-6  # SD of a quartz
_DRIFT_LIMIT = 300e-6
_END_S = 90.0  # searched at each end of a long clip
_APART_S = 0.06  # an alternative is at least this far away
_RIVALS = 5
_FIT_REACH_S = 0.012
_LEAST_END = 9.0  # evidence of pats near the shift of the other end
_ANY_SHIFT = (-math.inf, math.inf)
_ENOUGH, _CHANCE = 4.0, 10.0  # fitted on simulated clips, right, wrong and mismatched
_CHANCE_S2 = 60.0 * 66.0  # of their sound times their log: in less, chance gives less


@dataclass(frozen=True, slots=True, eq=False)
class _Streams:
    """Both streams, prepared."""

    imu: ImuLog
    sound: Events
    shock: Events
    match: Coincidence
    whitener: Whitener


@dataclass(frozen=True, slots=True, eq=False)
class _FittedShift:
    """A shift, fitted.

    `chance` is the evidence expected by chance: the logarithm of the number of pairs of
    events, which grows with the length of either stream.
    """

    best: Candidate
    rivals: list[Candidate]
    pats: tuple[Pat, ...]
    shift_s: float
    sigma_s: float
    chance: float

    @property
    def margin(self) -> float:
        rival = self.rivals[0].evidence if self.rivals else 0.0
        return self.best.evidence - max(rival, 0.0)

    @property
    def score(self) -> float:
        """The basis of confidence: the margin, and the evidence beyond chance."""
        return min(self.margin, 0.6 * (self.best.evidence - self.chance))

    @property
    def at_s(self) -> float:
        """Log time at which the shift applies."""
        return float(np.mean([pat.felt_s for pat in self.pats]))


def synchronize_pats(
    imu: ImuLog, sound: Events, allowed_s: tuple[float, float] = _ANY_SHIFT
) -> Synchronisation | None:
    """Return the clock map of the log to the sound, None if nothing coincides.

    Args:
        imu: the log; at least averages at 30 Hz.
        sound: events of the sound, in media time.
        allowed_s: least and largest shift, where a clock tells.
    """
    shock = shock_events(imu, shocks(imu))
    if len(sound) < 3 or len(shock) < 3:
        return None
    step_s = 1.0 / imu.rate_hz
    match = Coincidence(0.003 + 0.25 * step_s, math.hypot(0.003, 0.4 * step_s))
    streams = _Streams(imu, sound, shock, match, Whitener.of(imu))
    begin_s, end_s = float(sound.time_s[0]), float(sound.time_s[-1])
    if end_s - begin_s < LONG_S:
        found = _find(streams, sound, allowed_s)
        return None if found is None else _result(found, None)
    return _long(streams, begin_s, end_s, allowed_s)


def _long(
    streams: _Streams, begin_s: float, end_s: float, allowed_s: tuple[float, float]
) -> Synchronisation | None:
    """Anchor at the more certain end; the other gives the clock rate."""
    ends = [
        streams.sound.within(begin_s, begin_s + _END_S),
        streams.sound.within(end_s - _END_S, end_s),
    ]
    slack_s = _DRIFT_LIMIT * (end_s - begin_s) + streams.match.sigma_s
    ranked = [
        candidates(part, streams.shock, streams.match, allowed_s) for part in ends
    ]
    found = [
        _found(streams, ends[0], _supported(ranked[0], ranked[1], slack_s), allowed_s),
        _found(streams, ends[1], _supported(ranked[1], ranked[0], slack_s), allowed_s),
    ]
    scores = [-math.inf if one is None else one.score for one in found]
    anchor_end = int(np.argmax(scores))
    anchor = found[anchor_end]
    if anchor is None or anchor.score < _ENOUGH:
        whole = _find(streams, streams.sound.rarest(600), allowed_s)
        if whole is not None and (anchor is None or whole.score > anchor.score):
            return _result(whole, None)
    if anchor is None:
        return None
    near_s = (anchor.shift_s - slack_s, anchor.shift_s + slack_s)
    other = _find(streams, ends[1 - anchor_end], near_s)
    is_felt = other is not None and other.best.evidence >= _LEAST_END
    return _result(anchor, other if is_felt else None)


def _supported(
    ranked: list[Candidate], others: list[Candidate], slack_s: float
) -> list[Candidate]:
    """Add the evidence of the other end for about the same shift, beyond chance."""
    triples = [one for one in others if one.triple is not None]
    shifts_s = np.array([one.shift_s for one in triples])
    gains = np.array([one.evidence - _CHANCE for one in triples])
    supported = []
    for one in ranked:
        near = np.abs(shifts_s - one.shift_s) <= slack_s
        gain = max(0.0, float(gains[near].max())) if near.any() else 0.0
        supported.append(dataclasses.replace(one, evidence=one.evidence + gain))
    return sorted(supported, key=lambda one: -one.evidence)


def _find(
    streams: _Streams, sound: Events, allowed_s: tuple[float, float]
) -> _FittedShift | None:
    ranked = candidates(sound, streams.shock, streams.match, allowed_s)
    return _found(streams, sound, ranked, allowed_s)


def _found(
    streams: _Streams,
    sound: Events,
    ranked: list[Candidate],
    allowed_s: tuple[float, float],
) -> _FittedShift | None:
    """Return the best of some shifts, fitted."""
    best = next((one for one in ranked if one.triple is not None), None)
    if best is None or best.triple is None:
        return None
    rivals = [one for one in ranked if _is_rival(one, best)]
    heard, felt = best.triple.sound, best.triple.shock
    pats = tuple(
        Pat(
            float(sound.time_s[a]),
            float(streams.shock.time_s[b]),
            float(sound.rarity_hz[a]),
            float(streams.shock.rarity_hz[b]),
        )
        for a, b in zip(heard, felt, strict=True)
    )
    late_s = streams.match.late_s
    mean_s = float(np.mean([pat.heard_s - pat.felt_s for pat in pats])) + late_s
    reach_s = _FIT_REACH_S + 1.0 / streams.imu.rate_hz
    fit = fit_shift(streams.imu, streams.whitener, sound.time_s[heard], mean_s, reach_s)
    shifts_s = min(allowed_s[1] - allowed_s[0], float(np.ptp(streams.imu.time_s)))
    tried_s2 = float(np.ptp(sound.time_s)) * shifts_s
    chance = _CHANCE + math.log(min(1.0, max(tried_s2, 1.0) / _CHANCE_S2))
    return _FittedShift(best, rivals[:_RIVALS], pats, fit.shift_s, fit.sigma_s, chance)


def _is_rival(one: Candidate, best: Candidate) -> bool:
    """Whether a shift is an alternative: neither near the best, nor of the same pats."""
    if abs(one.shift_s - best.shift_s) <= _APART_S:
        return False
    if one.triple is None or best.triple is None:
        return True
    is_same_sound = np.array_equal(one.triple.sound, best.triple.sound)
    return not (is_same_sound and np.array_equal(one.triple.shock, best.triple.shock))


def _result(found: _FittedShift, other: _FittedShift | None) -> Synchronisation:
    """Return the line through one end, or through both with the prior on the rate."""
    drift, sigma_s, pats = 0.0, found.sigma_s, found.pats
    drift_sigma = DRIFT_PRIOR
    shift_s, at_s = found.shift_s, found.at_s
    if other is not None:
        apart_s = other.at_s - at_s
        variance = (found.sigma_s**2 + other.sigma_s**2) / apart_s**2
        trust = DRIFT_PRIOR**2 / (DRIFT_PRIOR**2 + variance)
        drift_sigma = math.sqrt(trust * variance)
        measured = (other.shift_s - shift_s) / apart_s
        drift = trust * measured
        # the part of the rate that the prior removes is shared by both ends
        weight = found.sigma_s**2 / (found.sigma_s**2 + other.sigma_s**2)
        shift_s += weight * (measured - drift) * apart_s
        pats = tuple(sorted(found.pats + other.pats, key=lambda pat: pat.heard_s))
        sigma_s = math.sqrt((found.sigma_s**2 + other.sigma_s**2) / 2.0)
    confidence = 1.0 / (1.0 + math.exp(min(50.0, _ENOUGH - found.score)))
    return Synchronisation(
        # shift(t) = shift + drift (t - at), as a line through log time zero
        ClockMap(shift_s - drift * at_s, 1.0 + drift, sigma_s, confidence),
        "pats",
        found.best.evidence,
        found.margin,
        pats,
        tuple(Rival(one.shift_s, one.evidence) for one in found.rivals),
        has_drift=other is not None,
        offset_sigma_s=sigma_s,
        drift_sigma_ppm=1e6 * drift_sigma,
    )
