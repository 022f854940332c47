"""The command `effects`: the effects on the timeline of a sequence."""

import argparse
import json
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

from hapticplayer import storage
from hapticplayer.cli.common import (
    refuse_idle,
    say,
    say_figures,
    shown_progress,
)
from hapticplayer.errors import UsageError, counted
from hapticplayer.rendering.condition import Value
from hapticplayer.rendering.effects import (
    EFFECTS,
    Effect,
    EffectList,
    Target,
    kind_of,
)
from hapticplayer.sequence import open_sequence, store
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.effects_file import written
from hapticplayer.sequence.figures import sequence_figures

_ROUNDED_S = 1e-3
"""By which the end of a clip may be typed too large."""
_KINDS = "; ".join(
    f"{kind.name}: {', '.join(one.name for one in kind.parameters) or 'no parameters'}"
    for kind in EFFECTS
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "sequence", metavar="SEQUENCE", help="its motion never changes"
    )
    command.add_argument("--json", action="store_true", help="print the list as JSON")
    actions = command.add_subparsers(dest="action", required=True, metavar="ACTION")
    actions.add_parser("list", help="print the effects with their numbers")
    _add_new(actions.add_parser("add", help=f"add one at the end. {_KINDS}"))
    for name, text in (
        ("remove", "remove one"),
        ("enable", "switch one on"),
        ("disable", "switch one off"),
        ("move", "move one on the timeline"),
    ):
        action = actions.add_parser(name, help=text)
        action.add_argument("number", type=int, metavar="N", help="as listed, from 1")
        if name == "move":
            action.add_argument(
                "--by",
                type=float,
                required=True,
                metavar="S",
                help="seconds; later > 0",
            )


def _add_new(new: argparse.ArgumentParser) -> None:
    new.add_argument("kind", choices=[kind.name for kind in EFFECTS], help=_KINDS)
    new.add_argument("--start", type=float, required=True, metavar="S")
    new.add_argument("--end", type=float, required=True, metavar="S")
    new.add_argument(
        "--param",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="a parameter; the others have their defaults",
    )
    new.add_argument(
        "--point",
        action="append",
        default=[],
        metavar="S,VALUE",
        help="control point of a gain or an engine, S after the start",
    )
    new.add_argument("--fade-in", type=float, default=0.0, metavar="S")
    new.add_argument("--fade-out", type=float, default=0.0, metavar="S")
    new.add_argument("--target", choices=list(Target), default=Target.FORCE)
    new.add_argument(
        "--direction",
        default="0,1,0",
        metavar="X,Y,Z",
        help="direction of what is added; x right, y up, z towards the user for a force; "
        "x right, y front, z up for the motion",
    )


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Show or change the effects of a sequence."""
    folder = Path(options.sequence)
    is_changed = options.action != "list"
    with storage.locked(folder) if is_changed else nullcontext():
        sequence = open_sequence(folder)
        effects = store.effects_of(sequence)
        if is_changed:
            effects = _changed(effects, options, sequence.duration_s)
            with shown_progress() as progress:
                set_effects(folder, effects, progress=progress)
    if options.json:
        say(json.dumps({"sequence": options.sequence, **written(effects)}))
        return 0
    for number, effect in enumerate(effects.effects, 1):
        say(f"{number:3d}  {effect.described()}{'' if effect.enabled else ' (off)'}")
    for marker in effects.markers:
        say(f"     at {marker.time_s:g} s: {marker.name}")
    say(counted(len(effects), "effect"))
    if is_changed:
        after = sequence_figures(open_sequence(folder))
        say_figures(sequence_figures(sequence), after)
    return 0


def _changed(
    effects: EffectList, options: argparse.Namespace, duration_s: float
) -> EffectList:
    every = list(effects.effects)
    if options.action == "add":
        new = _within(_new(options), duration_s)
        return replace(effects, effects=(*every, new))
    row = options.number - 1
    if not 0 <= row < len(every):
        raise UsageError(
            "there is no effect {number}; the list has {count}",
            number=options.number,
            count=len(every),
        )
    if options.action == "remove":
        del every[row]
    elif options.action == "move":
        every[row] = _within(every[row].moved(options.by), duration_s)
    else:
        every[row] = replace(every[row], enabled=options.action == "enable")
    return replace(effects, effects=tuple(every))


def _within(effect: Effect, duration_s: float) -> Effect:
    """The effect, unless a part of it could never be felt."""
    if effect.start_s < 0.0 or effect.end_s > duration_s + _ROUNDED_S:
        raise UsageError(
            "an effect from {start_s:g} to {end_s:g} s is not within the clip; give "
            "times from 0 to {most:.3f} s",
            start_s=effect.start_s,
            end_s=effect.end_s,
            most=duration_s,
        )
    return effect


def _new(options: argparse.Namespace) -> Effect:
    kind = kind_of(options.kind)
    if kind.wave is None:
        refuse_idle(options, f"on {kind.name}, which adds nothing", "--direction")
    known = {one.name: one for one in kind.parameters}
    parameters: dict[str, float] = {}
    for text in options.param:
        name, _, value = text.partition("=")
        if name in parameters:
            raise UsageError(f"--param {text!r}: give {name!r} once")
        read: Value = known[name].read(value) if name in known else 0.0
        parameters[name] = float(read) if isinstance(read, str) else read
    x, y, z = _numbers(options.direction, 3)
    points = tuple(_numbers(text, 2) for text in options.point)
    return Effect(
        options.kind,
        options.start,
        options.end,
        Target(options.target),
        (x, y, z),
        options.fade_in,
        options.fade_out,
        parameters,
        tuple((time_s, value) for time_s, value in points),
    )


def _numbers(text: str, count: int) -> list[float]:
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != count:
        raise UsageError(
            "{text!r} must be {count} numbers with commas", text=text[:40], count=count
        )
    return numbers
