"""Effects as values, checked where they are made, and applied to a motion or a track."""

import enum
import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from hapticplayer.errors import UsageError
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import Vector
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.model.ranges import MEDIA_TIME_S
from hapticplayer.rendering.condition import Parameter, described
from hapticplayer.rendering.effects.kinds import AMPLITUDE, EffectKind, kind_of
from hapticplayer.rendering.effects.signals import RATE_HZ, Points, Span

MAX_EFFECTS, MAX_POINTS = 500, 500
MAX_MARKERS, MAX_MARKER_NAME = 500, 100
MAX_EFFECT_S = 3600.0
"""Of one effect: it has a value each millisecond."""

UP: Vector = (0.0, 1.0, 0.0)
"""In frame D, where forces are; in frame A it is forwards."""


class Target(enum.StrEnum):
    """What an effect changes."""

    MOTION = "motion"
    FORCE = "force"

    def unit_of(self, parameter: Parameter) -> str:
        unit = parameter.range.unit if parameter.range else ""
        amplitude = "N" if self is Target.FORCE else "m/s^2"
        return amplitude if unit == AMPLITUDE else unit


@dataclass(frozen=True, slots=True)
class Effect:
    """A span in which a motion or a force is changed.

    Attributes:
        kind: name of an entry of `EFFECTS`.
        start_s, end_s: media time.
        target: the motion p before, or the force F after mapping and gain.
        direction: of what is added, in frame A for a motion, D for a force; its
            length does not count.
        fade_in_s, fade_out_s: within the span.
        parameters: those that are not the kind's defaults.
        curve: control points, time from `start_s` in s and value, for the kind's `curve`.
        enabled: whether it is switched on.

    Raises:
        UsageError: when a value is not allowed; names it.
    """

    kind: str
    start_s: float
    end_s: float
    target: Target = Target.FORCE
    direction: Vector = UP
    fade_in_s: float = 0.0
    fade_out_s: float = 0.0
    parameters: Mapping[str, float] = field(default_factory=dict)
    curve: Points = ()
    enabled: bool = True

    def __post_init__(self) -> None:
        kind = kind_of(self.kind)
        _check_times(self)
        length = math.hypot(*self.direction)
        if not (math.isfinite(length) and length > 1e-6):
            raise UsageError("direction: must be three numbers that are not all zero")
        for name, value in self.parameters.items():
            _parameter(kind, name).check(value)
        if self.curve:
            _check_curve(kind, self.curve)

    @property
    def duration_s(self) -> float:
        """Length of the span."""
        return self.end_s - self.start_s

    def values(self) -> dict[str, float]:
        """Return all parameters, with the defaults of the kind."""
        known = kind_of(self.kind).parameters
        return {
            one.name: float(self.parameters.get(one.name, one.default)) for one in known
        }

    def moved(self, by_s: float) -> "Effect":
        """Return it earlier or later, but not before the start of the clip."""
        by_s = max(by_s, -self.start_s)
        return replace(self, start_s=self.start_s + by_s, end_s=self.end_s + by_s)

    def described(self) -> str:
        """Return it as people read it: "knock 1.2 to 1.5 s, force, amplitude 2"."""
        parts = [f"{self.kind} {self.start_s:g} to {self.end_s:g} s", self.target.value]
        if self.parameters:
            parts.append(described(self.parameters))
        return ", ".join(parts)


@dataclass(frozen=True, slots=True)
class TimeMarker:
    """A media time with a name, for people: nothing is changed there.

    Raises:
        UsageError: when a value is not allowed; names it.
    """

    time_s: float
    name: str

    def __post_init__(self) -> None:
        MEDIA_TIME_S.parse("time_s", str(self.time_s))
        if not (0 < len(self.name) <= MAX_MARKER_NAME and self.name.isprintable()):
            raise UsageError(
                "name: must have 1 to {most} characters in one line",
                most=MAX_MARKER_NAME,
            )


@dataclass(frozen=True, slots=True)
class EffectList:
    """Effects in the order in which they are applied, and markers beside them.

    Raises:
        UsageError: for too many.
    """

    effects: tuple[Effect, ...] = ()
    markers: tuple[TimeMarker, ...] = ()

    def __post_init__(self) -> None:
        if len(self.markers) > MAX_MARKERS:
            raise UsageError("at most {most} markers in a list", most=MAX_MARKERS)
        if len(self.effects) > MAX_EFFECTS:
            raise UsageError("at most {most} effects in a list", most=MAX_EFFECTS)

    def __len__(self) -> int:
        return len(self.effects)

    def chosen(self, target: Target) -> tuple[Effect, ...]:
        """Return those that are switched on and change the target."""
        return tuple(e for e in self.effects if e.enabled and e.target is target)

    @property
    def is_idle(self) -> bool:
        """Whether nothing is switched on."""
        return not any(effect.enabled for effect in self.effects)


NO_EFFECTS = EffectList()


def _check_times(effect: Effect) -> None:
    for name in ("start_s", "end_s", "fade_in_s", "fade_out_s"):
        MEDIA_TIME_S.parse(name, str(getattr(effect, name)))
    if not 0.0 < effect.duration_s <= MAX_EFFECT_S:
        raise UsageError(
            "end_s: {end_s:g} s must come after start_s ({start_s:g} s), by {most_s:g} s "
            "at most",
            end_s=effect.end_s,
            start_s=effect.start_s,
            most_s=MAX_EFFECT_S,
        )
    fades_s = effect.fade_in_s + effect.fade_out_s
    if fades_s > effect.duration_s * (1.0 + 1e-9):
        raise UsageError(
            "fades: {fades_s:g} s together must fit into the {duration_s:g} s of the "
            "effect",
            fades_s=fades_s,
            duration_s=effect.duration_s,
        )


def _parameter(kind: EffectKind, name: str) -> Parameter:
    for one in kind.parameters:
        if one.name == name:
            return one
    raise UsageError(
        "{name}: {kind} has no such parameter; it has {known}",
        name=name[:40],
        kind=kind.name,
        known=", ".join(one.name for one in kind.parameters) or "-",
    )


def _check_curve(kind: EffectKind, curve: Points) -> None:
    most = MAX_POINTS if kind.curve else 0
    if len(curve) > most:
        raise UsageError(
            "curve: {kind} takes {most} points at most", kind=kind.name, most=most
        )
    for _time_s, value in curve:
        _parameter(kind, kind.curve).check(value)
    times_s = [time_s for time_s, _ in curve]
    is_ordered = all(a < b for a, b in itertools.pairwise(times_s))
    if not (is_ordered and times_s[0] >= 0.0 and math.isfinite(times_s[-1])):
        raise UsageError("curve: its times must increase from 0 s")


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
