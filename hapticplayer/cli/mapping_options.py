"""The options of a mapping, which `import` and `render` share."""

import argparse
from dataclasses import replace

from hapticplayer.capture.mounting import device_axes
from hapticplayer.errors import UsageError
from hapticplayer.model import Mapping, ranges
from hapticplayer.model.mapping import SOFT_KNEE_N, AxisGains
from hapticplayer.rendering import LEVER_ARMS_M
from hapticplayer.sequence.presets import PRESETS

FIT = "fit"


def add_mapping(command: argparse._ActionsContainer, *, is_live: bool = False) -> None:
    """Add what maps motion to force; an option that is not given is None.

    Motion that is felt live has neither a fitted gain nor a lever arm: both need the
    whole recording.
    """
    text = "newtons per m/s^2 (default 0.4), for all axes or for right, up and towards "
    fit = (
        "; fit: 99.5 %% of the force at most 3.5 N, from 0.2 to 1.6, which makes clips "
    )
    command.add_argument(
        "--gain",
        type=_gains if is_live else _gain,
        metavar="S|SX,SY,SZ" if is_live else "S|SX,SY,SZ|fit",
        help=f"{text}the user" + ("" if is_live else f"{fit}incomparable"),
    )
    command.add_argument(
        "--axes",
        type=device_axes,
        metavar="AXES",
        help="what the device's right, up and towards the user are in the wearer's axes "
        "(x right, y front, z up): three of them (default x,z,-y; write --axes=-x,...) "
        "or the nine numbers of a rotation, row by row",
    )
    if not is_live:
        _add_lever_arm(command)
    command.add_argument(
        "--soft-knee",
        action=argparse.BooleanOptionalAction,
        help=f"compress forces above {SOFT_KNEE_N:g} N smoothly instead of cutting them "
        "at the limit",
    )


def _add_lever_arm(command: argparse._ActionsContainer) -> None:
    command.add_argument(
        "--lever-arm",
        type=_lever_arm,
        metavar="X,Y,Z",
        help="feel another point of the rigid body: metres right, front and up from "
        "the recorder (default 0,0,0; write --lever-arm=-0.1,...), or a rough example for a recorder on the chest: "
        + ", ".join(LEVER_ARMS_M),
    )


def add_preset(command: argparse._ActionsContainer, default: str | None) -> None:
    """Add the choice of a preset; None stands for the one that a sequence has."""
    texts = " ".join(f"{preset.name}: {preset.text}" for preset in PRESETS)
    command.add_argument(
        "--preset",
        choices=[preset.name for preset in PRESETS],
        default=default,
        help=f"{texts} Default: {default or 'as the sequence was rendered'}",
    )


def chosen_mapping(
    options: argparse.Namespace, before: Mapping | None = None
) -> tuple[Mapping, bool]:
    """Return a mapping changed by the options, and whether its gain is to be fitted.

    Args:
        options: of `add_mapping`.
        before: the default mapping if None.
    """
    chosen = {"axes": options.axes}
    chosen["lever_arm_m"] = getattr(options, "lever_arm", None)
    fits_gain = options.gain == FIT
    if not fits_gain:
        chosen["gain_n_per_mps2"] = options.gain
    changes = {name: value for name, value in chosen.items() if value is not None}
    if options.soft_knee is not None:
        changes["soft_knee_n"] = SOFT_KNEE_N if options.soft_knee else None
    return replace(before or Mapping(), **changes), fits_gain


def mapping_text(mapping: Mapping) -> str:
    """Return the mapping for people."""
    gain = mapping.gain_n_per_mps2
    gains = gain if isinstance(gain, tuple) else (gain,)
    text = f"gain {', '.join(f'{one:.4g}' for one in gains)} N per m/s^2"
    if mapping.soft_knee_n is not None:
        text += f", soft knee at {mapping.soft_knee_n:g} N"
    if mapping.moves_point:
        arm = ", ".join(f"{one:g}" for one in mapping.lever_arm_m)
        text += f", lever arm {arm} m"
    return text


def _gain(text: str) -> float | AxisGains | str:
    return FIT if text == FIT else _gains(text)


def _gains(text: str) -> float | AxisGains:
    parts = text.split(",")
    if len(parts) == 1:
        return ranges.GAIN_N_PER_MPS2.parse("--gain", text)
    return _three("--gain", text, ranges.GAIN_N_PER_MPS2)


def _lever_arm(text: str) -> tuple[float, float, float]:
    known = LEVER_ARMS_M.get(text)
    return known or _three("--lever-arm", text, ranges.LEVER_ARM_M)


def _three(option: str, text: str, within: ranges.Range) -> tuple[float, float, float]:
    parts = text.split(",")
    if len(parts) != 3:
        raise UsageError(
            "{option} takes three numbers, such as 1,2,3, not {text}",
            option=option,
            text=text[:40],
        )
    x, y, z = (within.parse(option, part) for part in parts)
    return x, y, z
