"""The options of what force is written as and read from, and how a loss is said."""

import argparse
import math

from hapticplayer.cli.common import add_number
from hapticplayer.errors import UsageError
from hapticplayer.sequence.force_files import (
    FULL_SCALE_N,
    SAMPLE_RATE_HZ,
    STIFFNESS_N_PER_M,
    TOLERANCE_N,
    ReadChoices,
    WriteChoices,
)
from hapticplayer.sequence.force_formats import read_formats, written_formats

_WRITE, _READ = WriteChoices(), ReadChoices()


def written_text() -> str:
    return "; ".join(f"{one.name}: {one.text}" for one in written_formats().values())


def read_text() -> str:
    """Return the formats that are read, for help."""
    return "; ".join(
        f"{one.name} ({', '.join((one.suffix, *one.other_suffixes))}): {one.text}"
        for one in read_formats().values()
    )


def add_writing(command: argparse.ArgumentParser) -> None:
    """Add what can be chosen when force is written."""
    add_number(
        command,
        "--tolerance",
        TOLERANCE_N,
        metavar="N",
        default=_WRITE.tolerance_n,
        help="largest difference of the force vector where the format thins it "
        f"(default: {_WRITE.tolerance_n} N)",
    )
    add_number(
        command,
        "--sample-rate",
        SAMPLE_RATE_HZ,
        metavar="HZ",
        default=_WRITE.sample_rate_hz,
        help=f"samples per second in a WAV file (default: {_WRITE.sample_rate_hz})",
    )
    command.add_argument(
        "--funscript-version",
        choices=("1.0", "1.1", "2.0"),
        default=_WRITE.funscript_version,
        help="version of the format of a funscript "
        f"(default: {_WRITE.funscript_version})",
    )


def add_reading(command: argparse.ArgumentParser) -> None:
    """Add what a file may not say itself."""
    add_number(
        command,
        "--full-scale",
        FULL_SCALE_N,
        metavar="N",
        default=_READ.full_scale_n,
        help="force of amplitude 1 where the file gives no newtons "
        f"(default: {_READ.full_scale_n:g})",
    )
    command.add_argument(
        "--direction",
        metavar="X,Y,Z",
        type=direction,
        default=_READ.direction,
        help="direction of a force that has none in the file: right, up, towards the "
        "user (default: 0,1,0; before a minus use =, as in --direction=-1,0,0)",
    )
    add_number(
        command,
        "--stiffness",
        STIFFNESS_N_PER_M,
        metavar="N/M",
        default=_READ.stiffness_n_per_m,
        help="stiffness of the spring that follows the positions of a funscript "
        f"(default: {_READ.stiffness_n_per_m:g})",
    )
    command.add_argument(
        "--other-is",
        choices=("force", "vibration"),
        default=_READ.other_is,
        help="what an hjif perception is whose modality is Other, as the published "
        "encoder writes it (default: not read)",
    )


def write_choices(options: argparse.Namespace) -> WriteChoices:
    """The choices of writing; the file ends with the track."""
    return WriteChoices(
        tolerance_n=options.tolerance,
        sample_rate_hz=options.sample_rate,
        funscript_version=options.funscript_version,
        overwrite=options.overwrite,
    )


def read_choices(options: argparse.Namespace) -> ReadChoices:
    return ReadChoices(
        full_scale_n=options.full_scale,
        direction=options.direction,
        stiffness_n_per_m=options.stiffness,
        other_is=options.other_is,
    )


def direction(text: str) -> tuple[float, float, float]:
    """Return the unit vector in a text like `0,1,0`."""
    try:
        x, y, z = (float(part) for part in text.split(","))
    except ValueError:
        x = y = z = math.nan
    size = math.hypot(x, y, z)
    if not 1e-6 < size < 1e6:
        raise UsageError(f"--direction must be three numbers X,Y,Z, not {text[:40]!r}")
    return (x / size, y / size, z / size)
