"""The command line: `hapticplayer COMMAND`.

Exit status: 0 done, 1 refused or failed, 2 wrong usage or a decision is needed.
Errors are one sentence on stderr. Imports are lazy, so that `--help` needs neither
numpy nor PyAV nor Qt.
"""

import argparse
import sys
from collections.abc import Sequence

from hapticplayer import __version__
from hapticplayer.cli import commands as run
from hapticplayer.cli import options, study, study_analysis
from hapticplayer.cli.commands import OpenWindow
from hapticplayer.cli.options import (
    CLIP_SCENARIOS,
    DEVICE_NAMES,
    METHOD_NAMES,
    MOTION_SCENARIOS,
    MOUNTING_NAMES,
    RIDE_SCENARIOS,
)
from hapticplayer.errors import HapticPlayerError, UsageError

__all__ = [
    "CLIP_SCENARIOS",
    "DEVICE_NAMES",
    "METHOD_NAMES",
    "MOTION_SCENARIOS",
    "MOUNTING_NAMES",
    "RIDE_SCENARIOS",
    "OpenWindow",
    "build_parser",
    "main",
]


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
    chosen = parser.parse_args(argv)
    try:
        return int(chosen.run(chosen, open_window))
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
    parser.set_defaults(run=run.demo, **options.PLAY_DEFAULTS)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")
    options.add_play(commands)
    options.add_import(commands)
    options.add_sync(commands)
    options.add_process(commands)
    options.add_simulate(commands)
    options.add_export(commands)
    study.add_study(commands, study_analysis.register)
    options.add_device(commands)
    options.add_doctor(commands)
    return parser


def _refuse(problem: object, status: int) -> int:
    print(f"hapticplayer: {problem}", file=sys.stderr)  # noqa: T201 - the command line speaks
    return status
