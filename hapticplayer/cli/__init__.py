"""The command line: `hapticplayer COMMAND`.

Exit status: 0 done, 1 refused or failed, 2 wrong usage or a decision is needed, 128 + n
ended by signal n (130 for Ctrl-C).
Errors are one sentence on stderr. Each command has a module, which is imported when it
is the one that was asked for: `--help` needs neither numpy nor PyAV nor Qt.
"""

import argparse
import importlib
import io
import signal
import sys
from collections.abc import Callable, Sequence
from typing import NamedTuple, NoReturn

from hapticplayer import __version__
from hapticplayer.errors import HapticPlayerError, UsageError
from hapticplayer.untrusted import ESCAPED, without_controls

OpenWindow = Callable[[argparse.Namespace], int]
"""Shows the window for a command, and returns the exit status."""


class _Parser(argparse.ArgumentParser):
    """Quotes words of the command line without commands to the terminal."""

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        super().exit(status, message and without_controls(message, "\n"))


class Command(NamedTuple):
    """A command of the program.

    Attributes:
        name: as it is typed.
        summary: for `--help`.
        module: has `add_options(parser)`, which also sets `run`.
    """

    name: str
    summary: str
    module: str


COMMANDS = (
    Command("play", "play a sequence, or any video with any force track", "play"),
    Command("import", "make a sequence of a video and its motion", "importing"),
    Command("sync", "synchronise a motion log with a clip", "sync"),
    Command(
        "process", "report how good a recording's motion is; compare methods", "process"
    ),
    Command("simulate", "make a simulated ride with known truth", "simulate"),
    Command("export", "convert a record that `play --record` has written", "export"),
    Command("study", "run an experiment and keep its data", "study"),
    Command("device", "haptic devices", "device"),
    Command("doctor", "list what is missing, by package name", "doctor"),
)


def main(
    argv: Sequence[str] | None = None, open_window: OpenWindow | None = None
) -> int:
    """Run one command and return its exit status.

    Args:
        argv: arguments without the program's name; sys.argv if None.
        open_window: shows the window for `play` or no command at all; None where
            there is no display, and everything plays headless.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=ESCAPED)
    words = list(sys.argv[1:] if argv is None else argv)
    command = next((word for word in words if not word.startswith("-")), None)
    try:
        options = build_parser(command).parse_args(words)
        if "run" not in options:  # no command: the demo
            options = build_parser("play").parse_args(["play", ""])
        return int(options.run(options, open_window))
    except UsageError as problem:
        return _refuse(problem, 2)
    except HapticPlayerError as problem:
        return _refuse(problem, 1)
    except KeyboardInterrupt as problem:
        number = getattr(problem, "number", signal.SIGINT)
        return _refuse("interrupted; nothing half-done was left behind", 128 + number)
    except BrokenPipeError:
        return 1


def build_parser(wanted: str | None) -> argparse.ArgumentParser:
    """Return the parser of all commands, with the options of the one that is wanted."""
    parser = _Parser(
        prog="hapticplayer",
        description="Play a video and feel the motion of whoever recorded it. "
        "Without a command it opens the window on the built-in demo.",
    )
    parser.add_argument("--version", action="version", version=__version__)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND")
    for command in COMMANDS:
        part = commands.add_parser(command.name, help=command.summary)
        if command.name == wanted:
            module = importlib.import_module(f"{__name__}.{command.module}")
            module.add_options(part)
    return parser


def _refuse(problem: object, status: int) -> int:
    sentence = without_controls(f"hapticplayer: {problem}")
    print(sentence, file=sys.stderr)  # noqa: T201 - the command line speaks
    return status
