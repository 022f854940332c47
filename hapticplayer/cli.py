"""The command line: `hapticplayer COMMAND`.

Exit status: 0 done, 1 refused or failed, 2 wrong usage or a decision is needed.
Errors are one sentence on stderr. Imports are lazy, so that `--help` needs neither
numpy nor PyAV nor Qt.
"""

import argparse
import sys
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from hapticplayer import __version__
from hapticplayer.errors import HapticPlayerError, UsageError

OpenWindow = Callable[[argparse.Namespace], int]
DEVICE_NAMES = ("simulated", "falcon", "none")


def main(
    argv: Sequence[str] | None = None, open_window: OpenWindow | None = None
) -> int:
    """Run one command and return its exit status.

    Args:
        argv: arguments without the program's name; sys.argv if None.
        open_window: shows the window for `play` or no command at all; None where
            there is no display, and everything plays headless.
    """
    parser = build_parser()
    options = parser.parse_args(argv)
    try:
        return int(options.run(options, open_window))
    except UsageError as problem:
        return _refuse(problem, 2)
    except HapticPlayerError as problem:
        return _refuse(problem, 1)
    except KeyboardInterrupt:
        return _refuse("interrupted; nothing half-done was left behind", 1)
    except BrokenPipeError:
        return 1


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    parser = argparse.ArgumentParser(
        prog="hapticplayer",
        description="Play a video and feel the motion of whoever recorded it. "
        "Without a command it opens the window on the built-in demo.",
    )
    parser.add_argument("--version", action="version", version=__version__)
    parser.set_defaults(run=_demo, **_PLAY_DEFAULTS)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")
    _add_play(commands)
    _add_import(commands)
    _add_simulate(commands)
    _add_device(commands)
    _add_doctor(commands)
    return parser


_PLAY_DEFAULTS: dict[str, Any] = {
    "source": None,
    "feedback": None,
    "force": None,
    "device": "simulated",
    "headless": False,
    "fullscreen": False,
    "plots": True,
    "close_at_end": False,
    "start": 0.0,
    "duration": None,
    "log": None,
    "scheduling": None,
    "json": False,
}


def _add_play(commands: Any) -> None:
    play = commands.add_parser(
        "play", help="play a sequence, or any video with any force track"
    )
    play.set_defaults(run=_play)
    play.add_argument(
        "source", metavar="SEQUENCE_OR_VIDEO", help="folder of a sequence, or a video"
    )
    play.add_argument(
        "--feedback",
        metavar="F",
        help="realistic, none, random or another of its tracks",
    )
    play.add_argument(
        "--force",
        metavar="FILE.csv",
        help="force track: rows of time_s,fx_n,fy_n,fz_n, held between rows",
    )
    play.add_argument("--device", choices=DEVICE_NAMES, default="simulated")
    play.add_argument("--headless", action="store_true", help="without a window")
    play.add_argument("--fullscreen", action="store_true")
    play.add_argument(
        "--no-plots", dest="plots", action="store_false", help="hide the live plots"
    )
    play.add_argument(
        "--close-at-end", action="store_true", help="close the window after the clip"
    )
    play.add_argument(
        "--start", type=_seconds, default=0.0, metavar="S", help="media time, s"
    )
    play.add_argument(
        "--duration", type=_seconds, metavar="S", help="stop after S seconds"
    )
    play.add_argument("--log", metavar="FILE", help="write what happened as JSON lines")
    play.add_argument(
        "--scheduling",
        choices=("fifo", "slice", "normal"),
        help="at most this class for the haptic loop; for measurements "
        "(default: the best there is)",
    )
    play.add_argument("--json", action="store_true", help="print the summary as JSON")


def _add_import(commands: Any) -> None:
    command = commands.add_parser(
        "import", help="make a sequence of a video and its motion"
    )
    command.set_defaults(run=_import)
    command.add_argument("video", metavar="VIDEO")
    command.add_argument(
        "--imu",
        metavar="LOG",
        help="motion in a file of its own: CSV with the columns "
        "time_s,ax,ay,az,gx,gy,gz[,mx,my,mz] in SI, x right, y front, z up",
    )
    command.add_argument(
        "--offset",
        type=_number,
        metavar="S",
        help="media time at which the log's clock reads zero (default 0)",
    )
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument("--title", help="default: the name of the video")
    command.add_argument(
        "--gain", type=_number, metavar="N", help="newtons per m/s^2 (default 0.4)"
    )
    command.add_argument(
        "--seed", type=int, help="of the random feedback (default: from the clip)"
    )
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def _add_simulate(commands: Any) -> None:
    command = commands.add_parser(
        "simulate", help="make a sequence of a simulated ride with known truth"
    )
    command.set_defaults(run=_simulate)
    command.add_argument("scenario", metavar="SCENARIO", help="demo")
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument("--seed", type=int, help="of the sensor noise")


def _add_device(commands: Any) -> None:
    command = commands.add_parser("device", help="haptic devices")
    command.set_defaults(run=lambda *_: _usage(command))
    actions = command.add_subparsers(title="actions", metavar="ACTION")
    listing = actions.add_parser("list", help="devices that can be chosen")
    listing.add_argument("--json", action="store_true")
    listing.set_defaults(run=_device_list)


def _add_doctor(commands: Any) -> None:
    command = commands.add_parser("doctor", help="what is missing, by package name")
    command.add_argument("--json", action="store_true")
    command.set_defaults(run=_doctor)


# --- commands ---------------------------------------------------------------


def _demo(options: argparse.Namespace, open_window: OpenWindow | None) -> int:
    from hapticplayer import console

    if open_window is not None:
        return open_window(options)
    options.source = console.demo_folder()
    return console.play(options)


def _play(options: argparse.Namespace, open_window: OpenWindow | None) -> int:
    from hapticplayer import console

    if options.headless or open_window is None:
        return console.play(options)
    return open_window(options)


def _import(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    from hapticplayer import console

    return console.import_recording(options)


def _simulate(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    from hapticplayer import console

    return console.simulate(options)


def _device_list(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    from hapticplayer import console

    return console.list_devices(options)


def _doctor(options: argparse.Namespace, _open_window: OpenWindow | None) -> int:
    from hapticplayer import doctor

    return doctor.main(["--json"] if options.json else [])


# --- arguments --------------------------------------------------------------


def _number(text: str) -> float:
    value = float(text)
    if value != value or value in (float("inf"), float("-inf")):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def _seconds(text: str) -> float:
    value = _number(text)
    if value < 0.0:
        raise argparse.ArgumentTypeError(f"{text!r} is negative")
    return value


def _usage(parser: argparse.ArgumentParser) -> NoReturn:
    parser.error("an action is needed")


def _refuse(problem: object, status: int) -> int:
    print(f"hapticplayer: {problem}", file=sys.stderr)  # noqa: T201 - the command line speaks
    return status
