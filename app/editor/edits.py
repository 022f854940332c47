"""Changes of a list of effects, without Qt: each returns another list or effect."""

from bisect import bisect
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

import numpy as np

from app.editor.spans import Part
from hapticplayer.errors import UsageError
from hapticplayer.rendering.effects import Effect, EffectList, TimeMarker, kind_of
from hapticplayer.sequence.events import LEAST_EFFECT_S

USUAL_FADE_S = 0.05
_DIGITS = 6  # of a second: no 0.30000000000000004 in a file
_APART_S = 0.001  # of control points, the step of the loop


def added(effects: EffectList, *more: Effect) -> EffectList:
    """Return the list with more effects, applied after the others."""
    return replace(effects, effects=(*effects.effects, *more))


def new_effect(kind: str, at_s: float, duration_s: float) -> Effect:
    """Return an effect of a kind with its usual parameters, within a clip.

    What changes the force is faded, so that it does not jump.
    """
    row = kind_of(kind)
    length_s = min(row.usual_s, duration_s)
    start_s = _tidy(min(max(at_s, 0.0), duration_s - length_s))
    is_added = row.wave is not None
    fade_s = 0.0 if is_added else min(USUAL_FADE_S, 0.25 * length_s)
    end_s = _tidy(start_s + length_s)
    return Effect(kind, start_s, end_s, fade_in_s=fade_s, fade_out_s=fade_s)


def replaced(effects: EffectList, changed: Mapping[int, Effect]) -> EffectList:
    """Return the list with others in the places of some effects."""
    every = enumerate(effects.effects)
    return replace(effects, effects=tuple(changed.get(k, one) for k, one in every))


def removed(effects: EffectList, numbers: Collection[int]) -> EffectList:
    """Return the list without some effects."""
    every = enumerate(effects.effects)
    return replace(effects, effects=tuple(one for k, one in every if k not in numbers))


def reordered(effects: EffectList, number: int, to: int) -> EffectList:
    """Return the list with an effect applied in another place of the order."""
    every = list(effects.effects)
    every.insert(to, every.pop(number))
    return replace(effects, effects=tuple(every))


def moved(effect: Effect, by_s: float, duration_s: float) -> Effect:
    """Return an effect earlier or later, within the clip."""
    by_s = min(by_s, max(0.0, duration_s - effect.end_s))
    by_s = max(by_s, -effect.start_s)
    start_s = max(0.0, _tidy(effect.start_s + by_s))
    # the length stays, but for what the rounding of two ends would add
    return replace(effect, start_s=start_s, end_s=_tidy(start_s + effect.duration_s))


def moved_together(
    effects: Iterable[Effect], by_s: float, duration_s: float
) -> list[Effect]:
    """Return effects earlier or later, as far as all of them can go."""
    every = list(effects)
    last_s = max(one.end_s for one in every)
    by_s = min(by_s, max(0.0, duration_s - last_s))
    by_s = max(by_s, -min(one.start_s for one in every))
    return [moved(one, by_s, duration_s) for one in every]


def copies_at(
    effects: Iterable[Effect], at_s: float, duration_s: float
) -> list[Effect]:
    """Return copies of which the first begins at a time, or as late as the clip allows."""
    every = list(effects)
    first_s = min(one.start_s for one in every)
    return moved_together(every, at_s - first_s, duration_s)


def stretched(effect: Effect, part: Part, to_s: float, duration_s: float) -> Effect:
    """Return an effect whose begin or end lies elsewhere within the clip.

    Its fades shrink where they would not fit; its control points keep their places in
    the effect.
    """
    if part is Part.START:
        to_s = max(0.0, min(to_s, effect.end_s - LEAST_EFFECT_S))
        span_s = max(0.0, _tidy(to_s)), effect.end_s
    else:
        to_s = min(max(to_s, effect.start_s + LEAST_EFFECT_S), duration_s)
        span_s = effect.start_s, _tidy(to_s)
    length_s = span_s[1] - span_s[0]
    if length_s <= 0.0:
        return effect
    fades_s = effect.fade_in_s + effect.fade_out_s
    share = min(1.0, length_s / fades_s) if fades_s else 1.0
    factor = length_s / effect.duration_s
    return replace(
        effect,
        start_s=span_s[0],
        end_s=span_s[1],
        fade_in_s=share * effect.fade_in_s,
        fade_out_s=share * effect.fade_out_s,
        curve=tuple((factor * at_s, value) for at_s, value in effect.curve),
    )


def with_parameter(effect: Effect, name: str, value: float) -> Effect:
    """Return an effect with another parameter; raises UsageError."""
    known = next(one for one in kind_of(effect.kind).parameters if one.name == name)
    if known.range is not None and known.range.is_whole:
        value = round(value)
    others = {key: one for key, one in effect.parameters.items() if key != name}
    if value == known.default:
        return replace(effect, parameters=others)
    return replace(effect, parameters={**others, name: value})


def with_fade(effect: Effect, name: str, fade_s: float) -> Effect:
    """Return an effect with another `fade_in_s` or `fade_out_s`, beside the other."""
    is_in = name == "fade_in_s"
    other_s = effect.fade_out_s if is_in else effect.fade_in_s
    fade_s = min(max(_tidy(fade_s), 0.0), max(0.0, effect.duration_s - other_s))
    if is_in:
        return replace(effect, fade_in_s=fade_s)
    return replace(effect, fade_out_s=fade_s)


# --- control points --------------------------------------------------------------


def with_curve(effect: Effect, text: str) -> Effect:
    """Return an effect with control points such as "0 1; 0.5 2", or without any."""
    points = []
    for part in filter(None, map(str.strip, text.split(";"))):
        try:
            time_s, value = (float(one.replace(",", ".")) for one in part.split())
        except ValueError:
            raise UsageError(
                "{text!r} must be a time in s and a value", text=part[:40]
            ) from None
        points.append((time_s, value))
    return replace(effect, curve=tuple(points))


def value_at(effect: Effect, since_s: float) -> float:
    """Return the value of the control points, or what they would stand for."""
    if not effect.curve:
        return effect.values()[kind_of(effect.kind).curve]
    times_s, values = zip(*effect.curve, strict=True)
    return float(np.interp(since_s, times_s, values))


def with_point(effect: Effect, point: int, since_s: float, value: float) -> Effect:
    """Return an effect whose control point lies elsewhere, between its neighbours."""
    points = list(effect.curve)
    least_s = points[point - 1][0] + _APART_S if point else 0.0
    last = point == len(points) - 1
    most_s = effect.duration_s if last else points[point + 1][0] - _APART_S
    since_s = max(least_s, min(since_s, most_s))
    points[point] = _tidy(since_s), _within(effect, value)
    return replace(effect, curve=tuple(points))


def with_new_point(
    effect: Effect, since_s: float, value: float | None = None
) -> tuple[Effect, int]:
    """Return an effect with one more control point, and its number.

    Without a value the curve stays as it is. The first point gets one at each end of the
    effect, so that the rest keeps its value. Where there is one already, it is that.
    """
    since_s = min(max(_tidy(since_s), 0.0), effect.duration_s)
    points, usual = effect.curve, value_at(effect, since_s)
    if not points:
        points = (0.0, usual), (_tidy(effect.duration_s), usual)
    times_s = [time_s for time_s, _ in points]
    near = min(range(len(points)), key=lambda k: abs(times_s[k] - since_s))
    if abs(times_s[near] - since_s) < _APART_S:
        changed = replace(effect, curve=points)
        kept = points[near][1] if value is None else value
        return with_point(changed, near, times_s[near], kept), near
    place = bisect(times_s, since_s)
    point = since_s, _within(effect, usual if value is None else value)
    return replace(effect, curve=(*points[:place], point, *points[place:])), place


def without_point(effect: Effect, point: int) -> Effect:
    return replace(effect, curve=effect.curve[:point] + effect.curve[point + 1 :])


def _within(effect: Effect, value: float) -> float:
    """Return a value that the parameter of the curve may have."""
    kind = kind_of(effect.kind)
    allowed = next(one.range for one in kind.parameters if one.name == kind.curve)
    if allowed is None:
        return value
    return min(max(value, allowed.least), allowed.largest)


# --- markers ---------------------------------------------------------------------


def with_markers(effects: EffectList, markers: Iterable[TimeMarker]) -> EffectList:
    """Return the list with these markers, in the order of their times."""
    in_order = sorted(markers, key=lambda one: one.time_s)
    return replace(effects, markers=tuple(in_order))


def with_marker(effects: EffectList, at_s: float, name: str) -> EffectList:
    """Return the list with one more marker, or that of this time renamed."""
    at_s = _tidy(at_s)
    others = (one for one in effects.markers if one.time_s != at_s)
    return with_markers(effects, (*others, TimeMarker(at_s, name)))


def without_marker(effects: EffectList, marker: TimeMarker) -> EffectList:
    return with_markers(effects, (one for one in effects.markers if one != marker))


# --- what has changed ------------------------------------------------------------


def changed_numbers(before: EffectList, after: EffectList) -> tuple[int, ...]:
    """Return the places in which two lists differ, as they are in the second.

    What was added, or is another; where some were removed, the first that follows.
    """
    if before.effects == after.effects:
        return ()
    new = after.effects
    if len(after) > len(before):
        return _added_numbers(before.effects, new)
    pairs = zip(before.effects, new, strict=False)
    differing = tuple(k for k, (a, b) in enumerate(pairs) if a != b)
    if len(after) == len(before):
        return differing
    return differing[:1] or ((len(new) - 1,) if new else ())


def _added_numbers(
    before: tuple[Effect, ...], after: tuple[Effect, ...]
) -> tuple[int, ...]:
    kept, found = 0, []
    for number, one in enumerate(after):
        if kept < len(before) and before[kept] == one:
            kept += 1
        else:
            found.append(number)
    return tuple(found)


def _tidy(time_s: float) -> float:
    return round(time_s, _DIGITS)
