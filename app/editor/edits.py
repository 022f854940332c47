"""Changes of a list of effects, without Qt: each returns another list."""

from dataclasses import replace

from app.editor.spans import Part
from hapticplayer.errors import UsageError
from hapticplayer.rendering.effects import Effect, EffectList, kind_of
from hapticplayer.sequence.events import LEAST_EFFECT_S

USUAL_FADE_S = 0.05
_DIGITS = 6  # of a second: no 0.30000000000000004 in a file


def added(effects: EffectList, effect: Effect) -> EffectList:
    """Return the list with one more effect, applied after the others."""
    return EffectList((*effects.effects, effect))


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


def replaced(effects: EffectList, number: int, effect: Effect) -> EffectList:
    every = list(effects.effects)
    every[number] = effect
    return EffectList(tuple(every))


def removed(effects: EffectList, number: int) -> EffectList:
    """Return the list without an effect."""
    every = effects.effects
    return EffectList(every[:number] + every[number + 1 :])


def reordered(effects: EffectList, number: int, to: int) -> EffectList:
    """Return the list with an effect applied in another place of the order."""
    every = list(effects.effects)
    every.insert(to, every.pop(number))
    return EffectList(tuple(every))


def moved(effect: Effect, by_s: float, duration_s: float) -> Effect:
    """Return an effect earlier or later, within the clip."""
    by_s = min(by_s, max(0.0, duration_s - effect.end_s))
    by_s = max(by_s, -effect.start_s)
    start_s = max(0.0, _tidy(effect.start_s + by_s))
    # the length stays, but for what the rounding of two ends would add
    return replace(effect, start_s=start_s, end_s=_tidy(start_s + effect.duration_s))


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


def copied_to(effect: Effect, at_s: float, duration_s: float) -> Effect:
    """Return a copy that begins at a time, or as late as the clip allows."""
    return moved(effect, at_s - effect.start_s, duration_s)


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
    fade_s = min(max(fade_s, 0.0), max(0.0, effect.duration_s - other_s))
    if is_in:
        return replace(effect, fade_in_s=fade_s)
    return replace(effect, fade_out_s=fade_s)


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


def changed_number(before: EffectList, after: EffectList) -> int | None:
    """Return the first place in which two lists differ, as it is in the second."""
    pairs = zip(before.effects, after.effects, strict=False)
    shared = next((k for k, (a, b) in enumerate(pairs) if a != b), None)
    if shared is not None:
        return shared
    return len(after) - 1 if len(after) else None


def _tidy(time_s: float) -> float:
    return round(time_s, _DIGITS)
