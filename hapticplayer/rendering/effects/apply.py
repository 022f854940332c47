"""Applies a list of effects to a motion or a force track."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.rendering.effects.kinds import kind_of
from hapticplayer.rendering.effects.signals import RATE_HZ, Span
from hapticplayer.rendering.effects.values import Effect, EffectList, Target


def applied_to_motion(motion: MotionTrack, effects: EffectList) -> MotionTrack:
    """Return a motion in media time (frame A, m/s^2) with the effects on it.

    It keeps its samples; what is added is seen at their times.
    """
    chosen = effects.chosen(Target.MOTION)
    if not chosen or not len(motion):
        return motion
    acceleration = motion.acceleration_mps2.copy()
    for effect in chosen:
        _change(effect, motion.time_s, acceleration)
    return replace(motion, acceleration_mps2=acceleration)


def applied_to_force(
    track: ForceTrack,
    effects: EffectList,
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N,
) -> ForceTrack:
    """Return a LINEAR track (frame D, N) with the effects on it.

    In the spans of effects it has entries every millisecond; outside of them its own
    are untouched. A vector that effects have made longer than the limit is shortened.
    """
    chosen = effects.chosen(Target.FORCE)
    if not chosen:
        return track
    time_s = _dense(track.time_s, chosen)
    before = track.at(time_s)
    force = before.copy()
    for effect in chosen:
        _change(effect, time_s, force)
    is_changed = np.any(force != before, axis=1)
    length = np.linalg.norm(force, axis=1)
    over = is_changed & (length > force_limit_n)
    force[over] *= (force_limit_n / length[over])[:, None]
    own = np.searchsorted(time_s, track.time_s)
    kept = ~is_changed[own]
    force_n = force.astype(np.float32)
    force_n[own[kept]] = track.force_n[kept]
    return replace(track, time_s=time_s, force_n=force_n)


def faded_share(effect: Effect, time_s: Floats) -> Floats:
    """Return how much of an effect counts at times (N,): 0 outside, 1 between the fades."""
    share = ((time_s >= effect.start_s) & (time_s <= effect.end_s)).astype(np.float64)
    if effect.fade_in_s > 0.0:
        rising = (time_s - effect.start_s) / effect.fade_in_s
        share *= np.clip(rising, 0.0, 1.0)
    if effect.fade_out_s > 0.0:
        falling = (effect.end_s - time_s) / effect.fade_out_s
        share *= np.clip(falling, 0.0, 1.0)
    return share


def _dense(time_s: Floats, effects: Sequence[Effect]) -> Floats:
    """Return the times with those of a 1 kHz grid in the spans.

    The last value before a span and the first after it stay the track's own: one entry
    lies a millisecond outside of each end.
    """
    first_s, last_s = float(time_s[0]), float(time_s[-1])
    grids = [time_s]
    done = -1.0  # number of the last entry of the grid
    for effect in sorted(effects, key=lambda one: one.start_s):
        start_s, end_s = max(effect.start_s, first_s), min(effect.end_s, last_s)
        first = max(np.floor(start_s * RATE_HZ) - 1.0, done + 1.0)
        last = np.ceil(end_s * RATE_HZ) + 1.0
        grids.append(np.arange(first, last + 1.0) / RATE_HZ)
        grids.append(np.array([effect.start_s, effect.end_s]))
        done = max(done, last)
    grid_s = np.concatenate(grids)
    return np.unique(grid_s[(grid_s >= first_s) & (grid_s <= last_s)])


def _change(effect: Effect, time_s: Floats, values: Floats) -> None:
    """Change values (N, 3) at times (N,) within the span of an effect."""
    first, last = np.searchsorted(time_s, (effect.start_s, effect.end_s))
    rows = slice(first, min(last + 1, len(time_s)))
    times_s = time_s[rows]
    share = faded_share(effect, times_s)[:, None]
    if not share.any():
        return
    kind, start_s = kind_of(effect.kind), effect.start_s

    def before(since_s: Floats) -> Floats:
        at_s = since_s + start_s
        return np.stack([np.interp(at_s, time_s, axis) for axis in values.T], axis=1)

    span = Span(
        times_s - start_s,
        values[rows],
        effect.duration_s,
        (float(time_s[0]) - start_s, float(time_s[-1]) - start_s),
        before,
        effect.values(),
        effect.curve,
    )
    if kind.wave is not None:
        unit = np.array(effect.direction) / np.linalg.norm(effect.direction)
        change = kind.wave(span)[:, None] * unit
    else:
        assert kind.change is not None  # a kind has one of both
        change = kind.change(span) - values[rows]
    values[rows] += share * change
