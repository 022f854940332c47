"""What all commands share: how they speak, numbers, and the choice of a device."""

import argparse
import contextlib
import signal
import sys
import threading
from collections.abc import Iterator
from functools import partial
from types import FrameType
from typing import Any

from hapticplayer.devices import device_names
from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.model.ranges import Range
from hapticplayer.untrusted import without_controls


@contextlib.contextmanager
def interruptible() -> Iterator[None]:
    """Make SIGTERM end the work like Ctrl-C does: nothing half-done is left."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


@contextlib.contextmanager
def shown_progress() -> Iterator[Any]:
    """Yield a progress callback that draws one line on a terminal's stderr.

    Where stderr is no terminal, each step is a line of its own.
    """
    is_terminal = sys.stderr.isatty()
    last_step = ""

    def progress(fraction: float, step: str) -> None:
        nonlocal last_step
        step = without_controls(step)
        if is_terminal:
            bar = "#" * round(24 * fraction)
            sys.stderr.write(f"\r[{bar:<24}] {100 * fraction:3.0f} %  {step:<40.40}")
            sys.stderr.flush()
        elif step != last_step:
            sys.stderr.write(f"{step}\n")
        last_step = step

    try:
        yield progress
    except KeyboardInterrupt:
        raise Cancelled from None
    finally:
        if is_terminal and last_step:
            sys.stderr.write("\r" + " " * 76 + "\r")


def say(text: str) -> None:
    """Print a result."""
    sys.stdout.write(without_controls(text, "\n") + "\n")


def say_aside(text: str) -> None:
    """Print a remark that is no result."""
    sys.stderr.write(f"note: {without_controls(text)}\n")


def complain(text: str) -> None:
    """Print what went wrong."""
    sys.stderr.write(f"hapticplayer: {without_controls(text)}\n")


def add_number(
    command: argparse._ActionsContainer, option: str, within: Range, **how: Any
) -> None:
    """Add an option that takes a number of a range; see `hapticplayer.model.ranges`."""
    command.add_argument(option, type=partial(within.parse, option), **how)


def agreed(options: argparse.Namespace, question: str) -> None:
    """Ask, unless `--yes` has answered.

    Raises:
        UsageError: when there is no terminal to ask on, or the answer is no.
    """
    if options.yes:
        return
    if not sys.stdin.isatty():
        raise UsageError(f"a decision is needed: {question} (answer with --yes)")
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    if sys.stdin.readline().strip().lower() not in ("y", "yes"):
        raise UsageError("nothing was done, as you did not agree")


def add_overwrite(command: argparse.ArgumentParser) -> None:
    """Add what lets the files that a command writes be replaced."""
    command.add_argument(
        "--overwrite",
        action="store_true",
        help="replace a file that this program wrote for the same option; nothing "
        "else that exists is ever overwritten",
    )


def add_device_name(
    command: argparse.ArgumentParser, default: str = "simulated"
) -> None:
    """Add the option that names a haptic device."""
    names = device_names()

    def device_name(text: str) -> str:
        if text.partition(":")[0] not in names:
            raise argparse.ArgumentTypeError(
                f"{text!r} is not a device; choose one of {', '.join(names)}"
            )
        return text

    command.add_argument(
        "--device",
        type=device_name,
        default=default,
        metavar="NAME[:SERIAL]",
        help=f"{', '.join(names)}; of several Falcons one by its number "
        f"(default: {default})",
    )
