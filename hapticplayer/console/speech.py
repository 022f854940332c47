"""How the commands speak: results on stdout, everything else on stderr."""

import contextlib
import signal
import sys
import threading
from collections.abc import Iterator
from types import FrameType
from typing import Any

from hapticplayer.errors import Cancelled


@contextlib.contextmanager
def interruptible() -> Iterator[None]:
    """Let SIGTERM end the work like Ctrl-C does: tidied up."""
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
    sys.stdout.write(text + "\n")


def say_aside(text: str) -> None:
    """Print a remark that is no result."""
    sys.stderr.write(f"note: {text}\n")


def complain(text: str) -> None:
    """Print what went wrong."""
    sys.stderr.write(f"hapticplayer: {text}\n")
