"""Composition root and the command `hapticplayer`.

Little is imported before Ctrl-C has a handler, and Qt only when a window is needed.
"""

import os
import signal
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence
    from types import FrameType


_WITHOUT_WINDOW = {"-h", "--help", "--version"}


def main(argv: "Sequence[str] | None" = None) -> int:
    """Run a command; with a window where there is a display."""
    from hapticplayer import cli

    words = set(sys.argv[1:] if argv is None else argv)
    is_shown = words.isdisjoint(_WITHOUT_WINDOW) and has_display()
    return cli.main(argv, _open_window if is_shown else None)


def command() -> int:
    """Run a command as a process of its own, which then ends without delay.

    Taking modules and Qt's classes apart one by one costs 0.1 s, and nobody needs it.
    """
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as after nohup
        signal.signal(signal.SIGINT, _exit_at_once)
    statuses: list[int] = []

    def leave() -> None:
        if statuses:  # else something was raised, which Python reports
            try:
                sys.stdout.flush()
                sys.stderr.flush()
            except (OSError, ValueError):  # nobody reads it any more
                pass
            os._exit(statuses[0])

    try:
        _open_standard_streams()
        import atexit

        atexit.register(leave)  # the first is called last, when all threads have ended
        statuses.append(main())
    except (MemoryError, ImportError, OSError) as problem:
        if not isinstance(problem, MemoryError) and "Too many open" not in str(problem):
            raise
        os.write(2, b"hapticplayer: not enough memory, or too many open files\n")
        return 1
    return statuses[0]


def _exit_at_once(_number: int, _frame: "FrameType | None") -> None:
    """End while nothing has begun: an exception in an import may leave a traceback."""
    try:
        os.write(2, b"hapticplayer: interrupted; nothing was done\n")
    finally:
        os._exit(128 + signal.SIGINT)


def _open_standard_streams() -> None:
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        os.set_inheritable(number, True)
    os.close(number)


def has_display() -> bool:
    """Whether a window could be opened; a stale DISPLAY does not count."""
    if os.environ.get("QT_QPA_PLATFORM") or os.environ.get("WAYLAND_DISPLAY"):
        return True
    from hapticplayer.doctor import x_server_answers

    display = os.environ.get("DISPLAY", "")
    return bool(display) and x_server_answers(display)


def _open_window(options: "argparse.Namespace") -> int:
    from hapticplayer.doctor import missing_for_window

    if missing := missing_for_window():
        sys.stderr.write(f"hapticplayer: {missing}\n")
        return 1
    try:
        from app.bridge.interrupts import hold_signals

        hold_signals()
        if getattr(options, "study", None) is not None:
            from app.participant.application import run
        else:
            from app.player.application import run
    except ImportError as problem:
        from hapticplayer.doctor import explain_import_error

        sys.stderr.write(f"hapticplayer: {explain_import_error(problem)}\n")
        return 1
    return run(options)


if __name__ == "__main__":
    sys.exit(command())
