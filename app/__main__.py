"""Composition root and the command `hapticplayer`.

Qt is imported only when a window is needed.
"""

import argparse
import atexit
import contextlib
import os
import sys
from collections.abc import Sequence

from hapticplayer import cli
from hapticplayer.doctor import explain_import_error, x_server_answers


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; with a window where there is a display."""
    return cli.main(argv, _open_window if has_display() else None)


def command() -> int:
    """Run a command as a process of its own, which then ends without delay.

    Taking modules and Qt's classes apart one by one costs 0.1 s, and nobody needs it.
    """
    statuses: list[int] = []

    def leave() -> None:
        if statuses:  # else something was raised, which Python reports
            with contextlib.suppress(OSError, ValueError):  # nobody reads it any more
                sys.stdout.flush()
                sys.stderr.flush()
            os._exit(statuses[0])

    atexit.register(leave)  # the first is called last, when all threads have ended
    statuses.append(main())
    return statuses[0]


def has_display() -> bool:
    """Whether a window could be opened; a stale DISPLAY does not count."""
    if os.environ.get("QT_QPA_PLATFORM") or os.environ.get("WAYLAND_DISPLAY"):
        return True
    display = os.environ.get("DISPLAY", "")
    return bool(display) and x_server_answers(display)


def _open_window(options: argparse.Namespace) -> int:
    try:
        from app.bridge.interrupts import hold_signals

        hold_signals()
        if getattr(options, "study", None) is not None:
            from app.participant.application import run
        else:
            from app.player.application import run
    except ImportError as problem:
        sys.stderr.write(f"hapticplayer: {explain_import_error(problem)}\n")
        return 1
    return run(options)


if __name__ == "__main__":
    sys.exit(command())
