"""The command line: `hapticplayer COMMAND`.

Exit status: 0 done, 1 refused or failed, 2 wrong usage or a decision is needed, 128 + n
ended by signal n (130 for Ctrl-C).
Errors are one sentence on stderr. Each command has a module, which is imported when it
is the one that was asked for: `--help` needs neither numpy nor PyAV nor Qt.
"""

import argparse
import contextlib
import errno
import importlib
import io
import os
import resource
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, NamedTuple, NoReturn

from hapticplayer import __version__, extension
from hapticplayer.errors import HapticPlayerError, UsageError
from hapticplayer.linux import taken_away
from hapticplayer.untrusted import ESCAPED, without_controls

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

OpenWindow = Callable[[argparse.Namespace], int]
"""Shows the window for a command, and returns the exit status."""

LEAST_ADDRESS_SPACE_BYTES = 1 << 30
"""Drawing needs 0.7 GB. With less, libraries end the process or wait for ever."""

LEAST_FILES = 64
"""Playing needs 25, and the window more; usual are 1024."""

_MEMORY = "not enough memory; close other programs, or raise the limit (ulimit -v)"
_FILES = "too many open files; close other programs, or raise the limit (ulimit -n)"
_WORDS = {
    "failed to map segment": _MEMORY,
    "annot allocate memory": _MEMORY,
    "can't start new thread": _MEMORY,
    "oo many open files": _FILES,
}
_ERRNO = {errno.ENOMEM: _MEMORY, errno.EMFILE: _FILES, errno.ENFILE: _FILES}


class _ArgumentParser(argparse.ArgumentParser):
    """Quotes words without commands to the terminal, and says if help cannot be read.

    The options that differ from their defaults are `given` of what was parsed.
    """

    def parse_known_args(  # type: ignore[override]
        self,
        args: Sequence[str] | None = None,
        namespace: argparse.Namespace | None = None,
    ) -> tuple[argparse.Namespace, list[str]]:
        found, rest = super().parse_known_args(args, namespace)
        given = {
            option
            for action in self._actions
            # as texts: a mapping may hold arrays
            if repr(getattr(found, action.dest, action.default)) != repr(action.default)
            for option in action.option_strings
        }
        found.given = getattr(found, "given", frozenset()) | given
        return found, rest

    def print_help(self, file: "SupportsWrite[str] | None" = None) -> None:
        (file or sys.stdout).write(self.format_help())

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        super().exit(status, message and without_controls(message, "\n"))


_UNREACHABLE = (errno.ENAMETOOLONG, errno.EACCES)
_OUTPUT_ERRNO = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)


class Command(NamedTuple):
    """A command of the program.

    Attributes:
        name: as it is typed.
        summary: for `--help`.
        module: has `add_options(parser)`, which also sets `run`; absolute, or a
            part of `hapticplayer.cli` as ".play".
        examples: what people type behind `hapticplayer NAME`, for its `--help`.
    """

    name: str
    summary: str
    module: str
    examples: tuple[str, ...] = ()


COMMANDS = (
    Command(
        "play",
        "play a sequence, or any video with any force track",
        ".play",
        ("ride", "ride --device falcon --device rig:outsim", "clip.mp4 --force f.csv"),
    ),
    Command(
        "import",
        "make a sequence of a video and its motion",
        ".importing",
        (
            "GX010042.MP4 -o ride",
            "clip.mp4 --imu log.csv -o ride",
            "take -o ride",
            "clip.mp4 --imu log.csv --read-as accel-unit=g --offset -6.39 -o ride",
        ),
    ),
    Command(
        "record",
        "record camera, microphone and IMU on one clock",
        ".record",
        (
            "--list",
            "-o take --camera /dev/video0 --audio default --imu wt901:/dev/ttyUSB0",
        ),
    ),
    Command(
        "render",
        "give a sequence another mapping from motion to force",
        ".render",
        ("ride --preset faithful --in-place", "ride --gain 0.8 -o stronger"),
    ),
    Command(
        "effects",
        "show and change the effects on the timeline",
        ".effects",
        ("ride list",),
    ),
    Command(
        "sync",
        "synchronise a motion log with a clip",
        ".sync",
        ("clip.mp4 log.csv", "clip.mp4 log.csv --plot taps.png", "log.csv --check"),
    ),
    Command(
        "process",
        "report how good a recording's motion is; compare methods",
        ".process",
        ("log.csv", "clip.mp4 --compare"),
    ),
    Command(
        "pack",
        "write a sequence as one video file, to send to someone",
        ".pack",
        ("ride -o ride.mkv",),
    ),
    Command(
        "unpack",
        "make a sequence of a file that was packed",
        ".unpack",
        ("ride.mkv -o ride",),
    ),
    Command(
        "export",
        "write a sequence's force for other programs",
        ".export",
        ("ride -o ride.funscript", "ride --feedback random -o ride.csv"),
    ),
    Command(
        "import-force",
        "give a sequence force made elsewhere",
        ".import_force",
        ("ride force.csv", "force.hjif --check"),
    ),
    Command(
        "study",
        "run an experiment and keep its data",
        ".study",
        ("new my-study", "run my-study", "analyse my-study"),
    ),
    Command(
        "device",
        "haptic devices",
        ".device",
        ("list", "info simulated", "test falcon"),
    ),
    Command(
        "feel",
        "feel what a sensor measures now",
        ".feel",
        ("--imu wt901:/dev/ttyUSB0,rate=200 --device falcon", "--imu csv:- --gain 0.8"),
    ),
    Command("doctor", "list what is missing, by package name", "hapticplayer.doctor"),
)


def commands() -> Iterator[Command]:
    """Those of the core and of extensions, as far as they are asked for."""
    return extension.rows("commands", Command, COMMANDS)


def main(
    argv: Sequence[str] | None = None, open_window: OpenWindow | None = None
) -> int:
    """Run one command and return its exit status.

    Args:
        argv: arguments without the program's name; sys.argv if None.
        open_window: shows the window for `play` or no command at all; None where
            there is no display, and everything plays headless.
    """
    unheard = _replace_closed_streams()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=ESCAPED)
    words = list(sys.argv[1:] if argv is None else argv)
    try:
        status = _run(words, open_window)
        sys.stdout.flush()
    except BrokenPipeError:
        return 1
    except (Exception, KeyboardInterrupt) as problem:  # noqa: BLE001 - faults are raised
        sentence, status = _sentence_and_status(problem)
        if "--" in sentence:
            from hapticplayer.cli.remedies import with_commands

            names = (one.name for one in commands())
            sentence = with_commands(sentence, _command_in(words), build_parser, names)
        return _refuse(sentence, status)
    finally:
        for found in extension.take_problems():
            _refuse(found, 0)
    if unheard and unheard.getvalue():
        return _refuse("the standard output is closed", status or 1)
    return status


def _sentence_and_status(problem: BaseException) -> tuple[str, int]:
    """Sentence and exit status; a fault of this program is raised."""
    if isinstance(problem, HapticPlayerError):
        return str(problem), 2 if isinstance(problem, UsageError) else 1
    if isinstance(problem, KeyboardInterrupt):
        number = getattr(problem, "number", signal.SIGINT)
        return "interrupted; no file was left half written", 128 + number
    if sentence := _shortage_of(problem):
        return sentence, 1
    if isinstance(problem, OSError) and problem.errno in _UNREACHABLE:
        where, reason = problem.filename, problem.strerror
        remedy = "check the name, and the rights of its folder"
        return f"{where}: cannot be reached ({reason}); {remedy}", 1
    if isinstance(problem, OSError) and problem.errno in _OUTPUT_ERRNO:
        return f"the output cannot be written ({problem.strerror})", 1
    raise problem


def _replace_closed_streams() -> io.StringIO | None:
    """A stand-in for an output that whoever started the program has closed."""
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115
    if sys.stdout is not None:
        return None
    sys.stdout = unheard = io.StringIO()
    return unheard


def _run(words: list[str], open_window: OpenWindow | None) -> int:
    if any(word.startswith("--read-as") for word in words):
        from hapticplayer.capture.choices import each_with_its_option

        words = each_with_its_option(words)
    command = _command_in(words)
    if _is_played(words) and command not in {c.name for c in commands()}:
        command, words = "play", ["play", *words]
    if command != "doctor" and (command or not words):
        _refuse_small_limits()
    if taken_away():
        importlib.import_module("hapticplayer.facilities").refuse_unknown()
    try:
        options = build_parser(command).parse_args(words)
        if "run" not in options:  # no command: the demo
            options = build_parser("play").parse_args(["play", ""])
        if "--overwrite" in options.given:
            from hapticplayer.cli.common import refuse_idle_overwrite

            refuse_idle_overwrite(options)
        with _work_that_can_be_interrupted(), _ended_by_signals():
            return int(options.run(options, open_window))
    except SystemExit as end:  # of --help, or wrong usage
        return int(end.code or 0)


def _command_in(words: Sequence[str]) -> str | None:
    return next((word for word in words if not word.startswith("-")), None)


def _is_played(words: Sequence[str]) -> bool:
    """Whether something to play stands in the place of a command, or behind options."""
    found = [word for word in words if not word.startswith("-")]
    if not words or not words[0].startswith("-"):
        return any(map(_is_file_name, found[:1]))
    behind = words[words.index("--") :] if "--" in words else []
    return any(map(_is_file_name, [*found, *behind]))


def _is_file_name(word: str) -> bool:
    is_there = os.path.exists(word)  # noqa: PTH110 - False for what can be no name
    return "/" in word or bool(Path(word).suffix) or is_there


class _Interrupted(KeyboardInterrupt):
    """A signal ends the work as Ctrl-C does."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


@contextlib.contextmanager
def _ended_by_signals() -> Iterator[None]:
    """Let SIGTERM, SIGHUP and SIGQUIT end the work like Ctrl-C, leaving nothing behind.

    One that is ignored, as after nohup, stays so.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(number: int, _frame: FrameType | None) -> None:
        raise _Interrupted(number)

    with contextlib.ExitStack() as stack:
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
            before = signal.getsignal(number)
            if before is not signal.SIG_IGN:
                signal.signal(number, interrupt)
                stack.callback(signal.signal, number, before)
        yield


@contextlib.contextmanager
def _work_that_can_be_interrupted() -> Iterator[None]:
    """Let Ctrl-C raise, as what runs from here on has something to tidy up.

    Until then it may end the process at once. Where Python cannot raise, as in the
    callbacks of an import, the signal is repeated.
    """

    def repeat(unraisable: "sys.UnraisableHookArgs") -> None:
        if issubclass(unraisable.exc_type, KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        else:
            sys.__unraisablehook__(unraisable)

    before = signal.getsignal(signal.SIGINT)
    is_main = threading.current_thread() is threading.main_thread()
    if not is_main or before in {None, signal.SIG_IGN, signal.default_int_handler}:
        yield
        return
    hook, sys.unraisablehook = sys.unraisablehook, repeat
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        sys.unraisablehook = hook


def build_parser(wanted: str | None) -> argparse.ArgumentParser:
    """Return the parser of all commands, with the options of the one that is wanted."""
    parser = _ArgumentParser(
        prog="hapticplayer",
        usage="hapticplayer [-h] [--version] [COMMAND ... | FILE ...]",
        description="Play a video and feel the motion of whoever recorded it. "
        "With files it plays them, as the command play does; without anything it opens "
        "the window on the built-in demo.",
    )
    parser.add_argument("--version", action="version", version=__version__)
    parts = parser.add_subparsers(
        title="commands", metavar="COMMAND", prog="hapticplayer"
    )
    for command in commands():
        part = parts.add_parser(
            command.name,
            help=command.summary,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            epilog=_shown_examples(command),
        )
        if command.name == wanted:
            importlib.import_module(command.module, __name__).add_options(part)
            break  # the others are not read
    return parser


def _shown_examples(command: Command) -> str | None:
    words = (("  hapticplayer", command.name, one) for one in command.examples)
    lines = map(" ".join, words)
    return "\n".join(("examples:", *lines)) if command.examples else None


def _refuse(problem: object, status: int) -> int:
    sentence = without_controls(f"hapticplayer: {problem}")
    with contextlib.suppress(OSError):  # the status says it too
        print(sentence, file=sys.stderr)  # noqa: T201 - the command line speaks
    return status


def _refuse_small_limits() -> None:
    """Check the limits of this process before anything is loaded."""
    space, files = (
        resource.getrlimit(which)[0]
        for which in (resource.RLIMIT_AS, resource.RLIMIT_NOFILE)
    )
    if space != resource.RLIM_INFINITY:
        # each of its threads reserves memory, and there is one for each core
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
        if space < LEAST_ADDRESS_SPACE_BYTES:
            raise HapticPlayerError(
                f"the memory of a process is limited to {space >> 20} MB; "
                f"raise the limit to {LEAST_ADDRESS_SPACE_BYTES >> 20} MB or more "
                f"(ulimit -v {LEAST_ADDRESS_SPACE_BYTES >> 10})"
            )
    if files != resource.RLIM_INFINITY and files < LEAST_FILES:
        raise HapticPlayerError(
            f"the number of open files is limited to {files}; raise the limit to "
            f"{LEAST_FILES} or more (ulimit -n {LEAST_FILES})"
        )


def _shortage_of(problem: BaseException | None) -> str:
    """The shortage that caused a problem, else ""."""
    while problem is not None:
        if isinstance(problem, MemoryError):
            return _MEMORY
        if isinstance(problem, OSError) and problem.errno in _ERRNO:
            return _ERRNO[problem.errno]
        if isinstance(problem, (ImportError, OSError, RuntimeError)):
            text = str(problem)
            for words, sentence in _WORDS.items():
                if words in text:
                    return sentence
        problem = problem.__cause__ or problem.__context__
    return ""
