"""Makes sequences: of recordings, and of simulated rides."""

import argparse
import json
from collections.abc import Mapping as Dict
from pathlib import Path
from typing import Any

from hapticplayer.capture.choices import LogChoices, parse_choices, write_template
from hapticplayer.capture.mounting import mounting_axes
from hapticplayer.capture.sync.methods import AUTO
from hapticplayer.console.speech import interruptible, say, shown_progress
from hapticplayer.console.sync_text import sync_text
from hapticplayer.errors import UsageError
from hapticplayer.model import Mapping
from hapticplayer.sequence import build_sequence, files, open_sequence
from hapticplayer.sequence.build import Choices
from hapticplayer.sequence.processing import Processing
from hapticplayer.sequence.synchronizing import (
    SyncChoices,
    checked_skew,
    stored_skews,
)
from hapticplayer.simulation.demo import DEMO_SEED, write_simulated_sequence
from hapticplayer.simulation.demo import demo_folder as make_demo_folder
from hapticplayer.simulation.recordings import (
    CLIP,
    LOG,
    READ_AS,
    write_simulated_recording,
)


def demo_folder() -> Path:
    """Return the demo, made on first use with the progress shown."""
    with shown_progress() as progress:
        return make_demo_folder(progress)


def import_recording(options: argparse.Namespace) -> int:
    """Import a video with its motion, showing the progress; several with a summary."""
    if len(options.videos) > 1:
        from hapticplayer.console.batch import import_batch

        return import_batch(options)
    with interruptible(), shown_progress() as progress:
        folder = build_sequence(
            options.videos[0],
            options.output,
            imu_log=options.imu,
            choices=chosen_import(options),
            progress=progress,
        )
    description = open_sequence(folder).description
    if options.json:
        say(json.dumps({"sequence": str(folder), **description}, ensure_ascii=False))
        return 0
    _say_imported(folder, description)
    return 0


def chosen_import(options: argparse.Namespace) -> Choices:
    """Return what the options of an import say."""
    mapping = (
        Mapping() if options.gain is None else Mapping(gain_n_per_mps2=options.gain)
    )
    return Choices(
        title=options.title,
        mapping=mapping,
        processing=chosen_processing(options),
        seed=options.seed,
        log=chosen_log(options),
        sync=chosen_sync(options),
        mounting=chosen_mounting(options),
    )


def chosen_mounting(options: argparse.Namespace) -> str:
    """Return the axes of the mounting that was named, or ""."""
    return "" if options.mounting is None else mounting_axes(options.mounting)


def chosen_log(options: argparse.Namespace) -> LogChoices:
    """Return what the options decide about a log, kept as a template if wanted."""
    choices = parse_choices(options.read_as)
    if options.save_template is not None:
        write_template(Path(options.save_template), choices)
    return choices


def chosen_sync(options: argparse.Namespace) -> SyncChoices:
    """Return what the options say about the clocks."""
    late_s = options.skew
    if late_s is None and options.camera is not None:
        skews = stored_skews()
        if options.camera not in skews:
            known = ", ".join(sorted(skews)) or "none"
            raise UsageError(
                f"no skew is stored for the camera {options.camera!r} (stored: {known})"
                "; store one with sync --camera NAME --skew S --store-skew"
            )
        late_s = skews[options.camera]
    return SyncChoices(
        method=options.sync_method or AUTO,
        offset_s=options.offset,
        sound_late_s=None if late_s is None else checked_skew(late_s),
    )


def chosen_processing(options: argparse.Namespace) -> Processing:
    """Return what the options say about the motion."""
    method = {} if options.method is None else {"method": options.method}
    return Processing(
        **method,
        time_constant_s=options.time_constant,
        remove_spikes=options.remove_spikes,
        repair_clipping=options.repair_clipping,
        average_hz=options.average,
        lowpass_hz=options.lowpass,
    )


def _say_imported(folder: Path, description: Dict[str, Any]) -> None:
    made_of = description["provenance"]
    realistic = description["feedbacks"]["realistic"]
    say(
        f"{folder}: {description['clip']['duration_s']:.1f} s of "
        f"{made_of['camera'] or made_of['motion_source']} at "
        f"{made_of['imu_rate_hz']:.1f} Hz; force peak {realistic['peak_n']:.2f} N; "
        f"gravity removed by {made_of['gravity_removal']}; "
        f"accelerometer gain {made_of['accelerometer_gain']:.4f} "
        f"({made_of['accelerometer_gain_from']})"
    )
    found = made_of.get("synchronisation")
    if found and found["method"] in ("pats", "variance"):
        say(sync_text(found))
    for note in (*made_of["conditioning"], *made_of["notes"]):
        say(f"note: {note}")
    say(f"play it with: hapticplayer play {folder}")


def simulate(options: argparse.Namespace) -> int:
    """Write a simulated ride: a recording, a sequence, or motion and truth only."""
    # the simulator brings half of scipy along, which playing does not need
    from hapticplayer.simulation.rides.catalogue import RIDES, SCENES
    from hapticplayer.simulation.rides.motion_scenes import MOTION_SCENES

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
    with interruptible(), shown_progress() as progress:
        folder = write_simulated_sequence(
            options.scenario, Path(options.output), seed=seed, progress=progress
        )
    say(f"{folder}: play it with: hapticplayer play {folder}")
    return 0


def _simulate_ride(options: argparse.Namespace, seed: int) -> int:
    """Write what a camera and a board would have, beside the truth."""
    with interruptible(), shown_progress() as progress:
        folder = write_simulated_recording(
            options.scenario,
            Path(options.output),
            seed=seed,
            with_gopro=options.gopro,
            progress=progress,
        )
    say(
        f"{folder}: import it with: hapticplayer import {folder / CLIP} --imu "
        f"{folder / LOG} --read-as {READ_AS} -o SEQUENCE"
    )
    return 0


def _simulate_motion(name: str, seed: int, target: Path) -> int:
    """Write imu.csv and truth.npz of a scene without a clip."""
    from hapticplayer.capture.si_csv import write_imu_csv
    from hapticplayer.simulation.rides.motion_scenes import simulate_motion

    with (
        interruptible(),
        shown_progress() as progress,
        files.written_aside(target) as aside,
    ):
        progress(0.0, "riding")
        ride = simulate_motion(name, seed)
        progress(0.4, "writing")
        write_imu_csv(aside / "imu.csv", ride.imu)
        files.write_arrays(aside / "truth.npz", **ride.truth_arrays())
    say(
        f"{target}: {ride.title}, {len(ride.imu)} samples at "
        f"{ride.imu.rate_hz:.0f} Hz in imu.csv, the exact motion in truth.npz"
    )
    return 0
