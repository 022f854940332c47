"""The command `device` and its actions; needs nothing but the standard library."""

import argparse
import math
from collections.abc import Callable
from typing import Any, NoReturn

OpenWindow = Callable[[argparse.Namespace], int]
HOMING_S = 120.0


def add_device(commands: Any, add_name: Callable[..., None]) -> None:
    """Add the command.

    Args:
        commands: what argparse returned for the sub-commands.
        add_name: adds the option `--device` with this default to a parser.
    """
    command = commands.add_parser("device", help="haptic devices")
    command.set_defaults(run=lambda *_: _usage(command))
    actions = command.add_subparsers(title="actions", metavar="ACTION")

    def add(name: str, text: str, device: str = "falcon") -> argparse.ArgumentParser:
        action: argparse.ArgumentParser = actions.add_parser(
            name, help=text, description=f"{text[0].upper()}{text[1:]}."
        )
        action.set_defaults(run=_runs(name))
        if device:
            add_name(action, device)
        action.add_argument("--json", action="store_true", help="report as JSON")
        return action

    add("list", "devices that can be chosen, and what is plugged in", device="")
    add("info", "what a device can do, its firmware, whether it is homed")
    home = add("home", "let the Falcon find its zero, with guidance")
    home.add_argument(
        "--timeout",
        type=_seconds,
        default=HOMING_S,
        metavar="S",
        help=f"give up after S seconds (default {HOMING_S:g})",
    )
    upload = add("upload-firmware", "keep your copy of the Falcon's firmware, load it")
    upload.add_argument(
        "file", nargs="?", metavar="FILE", help="without it: load the one that is kept"
    )
    upload.add_argument(
        "--accept-unknown",
        action="store_true",
        help="also an image that is sound and not among the known ones",
    )
    _add_yes(upload)
    _add_yes(add("test", "draw a slow circle of 0.8 N, after asking"))
    measure = add("measure", "measure what is not known of a Falcon, at low force")
    measure.add_argument(
        "-o", "--output", metavar="FILE", help="the report, as JSON (a new file)"
    )
    _add_yes(measure)


def _seconds(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is no time to wait")
    return value


def _add_yes(action: argparse.ArgumentParser) -> None:
    action.add_argument("--yes", action="store_true", help="do not ask")


def _runs(name: str) -> Callable[[argparse.Namespace, OpenWindow | None], int]:
    def run(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
        from hapticplayer.console import devices

        return devices.ACTIONS[name](options)

    return run


def _usage(parser: argparse.ArgumentParser) -> NoReturn:
    parser.error("an action is needed")
