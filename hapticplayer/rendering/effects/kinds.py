"""The kinds of effects, one entry each: name, text, parameters and function."""

from collections.abc import Callable
from typing import NamedTuple

from hapticplayer.errors import Message, entry_named
from hapticplayer.model.arrays import Floats
from hapticplayer.model.ranges import Range
from hapticplayer.rendering.condition import Parameter, ParameterKind
from hapticplayer.rendering.effects import signals
from hapticplayer.rendering.effects.signals import Span

SHORT_S = 0.2
AMPLITUDE = "N or m/s^2"
"""Unit of what is added: N to a force, m/s^2 to a motion."""


class EffectKind(NamedTuple):
    """One kind of effect.

    Attributes:
        name: in files and on the command line.
        text: for people.
        parameters: numbers, in the order in which people see them.
        change: returns the new signal (N, 3); None for what is added.
        wave: returns what is added along the effect's direction, (N,), else None.
        curve: the parameter for which control points may stand, "" where none.
        usual_s: length of a new one.
    """

    name: str
    text: Message
    parameters: tuple[Parameter, ...] = ()
    change: Callable[[Span], Floats] | None = None
    wave: Callable[[Span], Floats] | None = None
    curve: str = ""
    usual_s: float = 1.0


def _number(name: str, text: Message, default: float, range_: Range) -> Parameter:
    return Parameter(name, text, ParameterKind.NUMBER, default, range_)


def _amplitude(default: float, name: str = "amplitude") -> Parameter:
    text = {
        "amplitude": Message("Amplitude"),
        "from_amplitude": Message("Amplitude at the start"),
        "to_amplitude": Message("Amplitude at the end"),
        "rms": Message("RMS"),
    }
    least = 0.0 if name == "rms" else -20.0
    return _number(name, text[name], default, Range(least, 20.0, AMPLITUDE))


def _frequency(default_hz: float) -> Parameter:
    allowed = Range(0.05, 200.0, "Hz")
    return _number("frequency_hz", Message("Frequency"), default_hz, allowed)


def _cutoff(default_hz: float, least_hz: float, largest_hz: float) -> Parameter:
    allowed = Range(least_hz, largest_hz, "Hz")
    return _number("cutoff_hz", Message("Cut-off frequency"), default_hz, allowed)


EFFECTS: tuple[EffectKind, ...] = (
    EffectKind(
        "gain",
        Message("Gain"),
        (_number("gain", Message("Gain"), 1.5, Range(0.0, 10.0)),),
        change=signals.scaled,
        curve="gain",
    ),
    EffectKind(
        "low-pass",
        Message("Low-pass"),
        (_cutoff(5.0, 0.2, 200.0),),
        change=signals.low_passed,
    ),
    EffectKind(
        "high-pass",
        Message("High-pass"),
        (_cutoff(0.5, 0.05, 50.0),),
        change=signals.high_passed,
    ),
    EffectKind("mute", Message("Silence"), change=signals.silent),
    EffectKind(
        "pulse",
        Message("Pulse"),
        (_amplitude(1.0),),
        wave=signals.pulse,
        usual_s=SHORT_S,
    ),
    EffectKind(
        "ramp",
        Message("Ramp"),
        (_amplitude(0.0, "from_amplitude"), _amplitude(1.0, "to_amplitude")),
        wave=signals.ramp,
    ),
    EffectKind(
        "sine", Message("Sine"), (_amplitude(1.0), _frequency(10.0)), wave=signals.sine
    ),
    EffectKind(
        "knock",
        Message("Knock (decaying sine)"),
        (
            _amplitude(2.0),
            _frequency(60.0),
            _number("decay_s", Message("Decay time"), 0.03, Range(0.002, 2.0, "s")),
        ),
        wave=signals.knock,
        usual_s=SHORT_S,
    ),
    EffectKind(
        "noise",
        Message("Noise"),
        (
            _amplitude(0.3, "rms"),
            _number("low_hz", Message("From"), 5.0, Range(0.1, 200.0, "Hz")),
            _number("high_hz", Message("Up to"), 50.0, Range(0.2, 400.0, "Hz")),
            _number("seed", Message("Seed"), 1.0, Range(0, 1_000_000, is_whole=True)),
        ),
        wave=signals.noise,
    ),
    EffectKind(
        "engine",
        Message("Engine"),
        (_amplitude(0.5), _frequency(30.0)),
        wave=signals.engine,
        curve="frequency_hz",
    ),
)
"""In the order in which people see them."""


def kind_of(name: str) -> EffectKind:
    return entry_named({one.name: one for one in EFFECTS}, name, Message("effect"))
