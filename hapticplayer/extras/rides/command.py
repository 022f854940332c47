"""The command `simulate`: a recording, a sequence, or motion and truth only."""

import argparse
from pathlib import Path

from hapticplayer import storage
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.cli.common import add_number, say, shown_progress
from hapticplayer.errors import UsageError, shell_line
from hapticplayer.extras.rides.catalogue import RIDES, SCENES
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.extras.rides.recordings import (
    CLIP,
    DEMO_SEED,
    LOG,
    READ_AS,
    write_simulated_recording,
    write_simulated_sequence,
)
from hapticplayer.model import ranges
from hapticplayer.sequence.arrays import write_arrays

SEQUENCES = [name for name in SCENES if name not in RIDES]


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "scenario",
        metavar="SCENARIO",
        help=f"a recording (clip.mp4, imu.csv, truth.npz): {', '.join(RIDES)}; "
        f"a sequence: {', '.join(SEQUENCES)}; motion only (imu.csv and truth.npz): "
        f"{', '.join(MOTION_SCENES)}",
    )
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument(
        "--gopro",
        action="store_true",
        help="also write gopro.mp4 beside a recording: the clip with a telemetry track",
    )
    add_number(
        command, "--seed", ranges.SEED, help="seed of the ride and the sensor noise"
    )


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Write a simulated ride: a recording, a sequence, or motion and truth only."""
    seed = DEMO_SEED if options.seed is None else options.seed
    if options.scenario in RIDES:
        return _simulate_ride(options, seed)
    if options.gopro:
        raise UsageError(f"--gopro is for a recording: {', '.join(RIDES)}")
    if options.scenario in MOTION_SCENES:
        return _simulate_motion(options.scenario, seed, Path(options.output))
    if options.scenario not in SCENES:
        known = ", ".join([*SCENES, *MOTION_SCENES])
        raise UsageError(
            f"there is no scenario {options.scenario!r}; choose one of {known}"
        )
    with shown_progress() as progress:
        folder = write_simulated_sequence(
            options.scenario, Path(options.output), seed=seed, progress=progress
        )
    say(f"{folder}: play it with: {shell_line('hapticplayer', 'play', folder)}")
    return 0


def _simulate_ride(options: argparse.Namespace, seed: int) -> int:
    """Write what a camera and a board would have, beside the truth."""
    with shown_progress() as progress:
        folder = write_simulated_recording(
            options.scenario,
            Path(options.output),
            seed=seed,
            with_gopro=options.gopro,
            progress=progress,
        )
    words = ("import", folder / CLIP, "--imu", folder / LOG, "--read-as", READ_AS)
    line = shell_line("hapticplayer", *words, "-o", "SEQUENCE")
    say(f"{folder}: import it with: {line}")
    return 0


def _simulate_motion(name: str, seed: int, target: Path) -> int:
    """Write imu.csv and truth.npz of a scene without a clip."""
    with (
        shown_progress() as progress,
        storage.folder_written_aside(target) as aside,
    ):
        progress(0.0, "riding")
        ride = simulate_motion(name, seed)
        progress(0.4, "writing")
        write_imu_csv(aside / "imu.csv", ride.imu)
        write_arrays(aside / "truth.npz", **ride.truth_arrays())
    say(
        f"{target}: {ride.title}, {len(ride.imu)} samples at "
        f"{ride.imu.rate_hz:.0f} Hz in imu.csv, the exact motion in truth.npz"
    )
    return 0
