"""What all commands share: how they speak, numbers, and the choice of a device."""

import argparse
import contextlib
import dataclasses
import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from hapticplayer.devices import NO_DEVICE, device_names, find_device, takes_motion
from hapticplayer.errors import DeviceError, UsageError
from hapticplayer.model.ranges import Range
from hapticplayer.sequence.figures import ForceFigures
from hapticplayer.untrusted import without_controls


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
            _write_aside(f"\r[{bar:<24}] {100 * fraction:3.0f} %  {step:<40.40}")
        elif step != last_step:
            _write_aside(f"{step}\n")
        last_step = step

    try:
        yield progress
    finally:
        if is_terminal and last_step:
            _write_aside("\r" + " " * 76 + "\r")


def say(text: str) -> None:
    """Print a result."""
    sys.stdout.write(without_controls(text, "\n") + "\n")


def say_aside(text: str) -> None:
    """Print a notice beside the result."""
    _write_aside(f"note: {without_controls(text)}\n")


def complain(text: str) -> None:
    """Print what went wrong."""
    _write_aside(f"hapticplayer: {without_controls(text)}\n")


def _write_aside(text: str) -> None:
    """Write to stderr; the work does not depend on it."""
    with contextlib.suppress(OSError):
        sys.stderr.write(text)
        sys.stderr.flush()


def refuse_idle_overwrite(options: argparse.Namespace) -> None:
    """Raise UsageError where --overwrite was given and no file is written."""
    writing = [
        one for one in options.writing if hasattr(options, one[2:].replace("-", "_"))
    ]
    if writing and not options.given.intersection(writing):
        refuse_idle(options, f"without {' or '.join(writing)}", "--overwrite")


def refuse_idle(options: argparse.Namespace, why: str, *idle: str) -> None:
    """Raise UsageError for options that were given although they have no effect."""
    given = [one for one in idle if one in getattr(options, "given", ())]
    if given:
        raise UsageError(f"{', '.join(given)} would have no effect {why}; leave it out")


def add_number(
    command: argparse._ActionsContainer, option: str, within: Range, **how: Any
) -> None:
    """Add an option that takes a number of a range; see `hapticplayer.model.ranges`."""
    command.add_argument(option, type=partial(within.parse, option), **how)


def add_agreement(command: argparse.ArgumentParser) -> None:
    """Add what answers the question of `agreed`."""
    command.add_argument("--yes", action="store_true", help="do not ask")


def agreed(options: argparse.Namespace, question: str) -> None:
    """Ask, unless `--yes` has answered."""
    if options.yes:
        return
    if not sys.stdin.isatty():
        raise UsageError(f"a decision is needed: {question} (answer with --yes)")
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    if sys.stdin.readline().strip().lower() not in ("y", "yes"):
        raise UsageError("nothing was done, as you did not agree")


def add_overwrite(command: argparse._ActionsContainer, *writing: str) -> None:
    """Add what lets the files that a command writes be replaced.

    Args:
        command: to which it is added.
        writing: options that name such a file, where the command has them; without
            any there always is one.
    """
    command.set_defaults(writing=writing)
    command.add_argument(
        "--overwrite",
        action="store_true",
        help="replace a file that this program wrote for the same option; nothing "
        "else that exists is ever overwritten",
    )


def add_accept_changed(command: argparse.ArgumentParser) -> None:
    """Add what agrees to a video that is not the one that its force was made for."""
    command.add_argument(
        "--accept-changed-video",
        action="store_true",
        help="use the force of a packed file although the video is not the one that it "
        "was made for",
    )


def add_outputs(command: argparse.ArgumentParser) -> None:
    """Add the option that names an output, once for each; the first one leads.

    They are `outputs`.
    """
    names = device_names()
    command.set_defaults(outputs=("simulated",))
    command.add_argument(
        "--device",
        dest="outputs",
        action=_AddOutput,
        type=partial(_known_name, names),
        metavar="NAME[:OPTIONS]",
        help=f"{', '.join(names)}; several play at once, each with its own --device, and "
        "the first one leads; falcon:SERIAL for one of several Falcons, "
        "rig:FORMAT[,HOST:PORT][,NAME=VALUE] for a motion rig, see docs/devices.md "
        "(default: simulated)",
    )


class _AddOutput(argparse.Action):
    """Takes the default away with the first name."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: Any,
        _option: str | None = None,
    ) -> None:
        named = getattr(namespace, "named_outputs", ())
        if values in named:
            parser.error(f"argument --device: {values} appears twice")
        namespace.named_outputs = named = (*named, values)
        if NO_DEVICE in named and len(named) > 1:
            parser.error(
                f"argument --device: {NO_DEVICE} means no device at all; leave it out, "
                "or name no other"
            )
        namespace.outputs = tuple(n for n in named if n != NO_DEVICE)


def _known_name(names: Sequence[str], text: str) -> str:
    """Return the name of a device, with settings that it takes."""
    if text.partition(":")[0] not in names:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a device; choose one of {', '.join(names)}"
        )
    try:
        if text != NO_DEVICE:
            find_device(text)
    except DeviceError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from problem
    return text


class _TakeGiven(argparse.Action):
    """Leaves what an option has said when nothing stands in this place."""

    def __call__(
        self,
        _parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: Any,
        _option: str | None = None,
    ) -> None:
        if values is not self.default:
            setattr(namespace, self.dest, values)


def add_device_name(
    command: argparse.ArgumentParser,
    default: str = "simulated",
    *,
    motion: bool = False,
) -> None:
    """Add the option that names a haptic device, also one that takes motion.

    With `motion` its name may also stand alone.
    """
    names = [
        name
        for name in device_names()
        if name != NO_DEVICE and (motion or not takes_motion(name))
    ]
    known = partial(_known_name, names)
    named = command.add_mutually_exclusive_group()
    if motion:
        named.add_argument(
            "device",
            nargs="?",
            action=_TakeGiven,
            type=known,
            default=default,
            metavar="NAME",
            help="the device, as with --device",
        )
    named.add_argument(
        "--device",
        type=known,
        default=default,
        metavar="NAME[:OPTIONS]",
        help=f"{', '.join(names)}; falcon:SERIAL for one of several Falcons, see "
        f"docs/devices.md for what else takes options (default: {default})",
    )


def peak_text(channel: Mapping[str, Any]) -> str:
    """Return how loud a sound channel was at most; see `Loudest.described`."""
    limited = ", limited" * channel["is_limited"]
    return f"peak {channel['peak_db']:.1f} dB{limited}"


def say_figures(before: ForceFigures, after: ForceFigures) -> None:
    """Print both, one below the other."""
    for name, figures in (("before", before), ("after", after)):
        say(f"{name:6}  {_text(figures)}")


def described_figures(before: ForceFigures, after: ForceFigures) -> dict[str, Any]:
    """The report as JSON."""
    return {
        "before": dataclasses.asdict(before),
        "after": dataclasses.asdict(after),
    }


def _text(figures: ForceFigures) -> str:
    reaches = ", ".join(f"{hand} {r:.0%}" for hand, r in figures.reaches.items())
    text = (
        f"RMS {figures.rms_n:.2f} N, peak {figures.peak_n:.2f} N, at the limit "
        f"{figures.saturated_share:.1%} of the time; workspace used: {reaches}"
    )
    trips = ", ".join(figures.trips)
    return f"{text}; a {trips} hand trips the device" if trips else text
