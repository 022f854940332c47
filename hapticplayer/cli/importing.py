"""The command `import`: one video, or several, each with the log beside it."""

import argparse
import dataclasses
import json
from dataclasses import asdict, dataclass
from pathlib import Path

from hapticplayer.capture.mounting import BY_FRAMES
from hapticplayer.capture.recorded import is_take, parts_of
from hapticplayer.cli.common import (
    add_number,
    refuse_idle,
    say,
    shown_progress,
)
from hapticplayer.cli.mapping_options import (
    FIT,
    add_mapping,
    add_preset,
    chosen_mapping,
    mapping_text,
)
from hapticplayer.cli.recording_options import (
    OF_A_RECORDING,
    add_mounting,
    add_processing,
    add_reading,
    add_sync,
    chosen_log,
    chosen_mounting,
    chosen_processing,
    chosen_sync,
    keep_template,
    mounting_text,
    sync_text,
)
from hapticplayer.errors import (
    Cancelled,
    HapticPlayerError,
    Progress,
    UsageError,
    shell_line,
)
from hapticplayer.model import ranges
from hapticplayer.sequence import Sequence, open_sequence
from hapticplayer.sequence.build import Choices, build_sequence
from hapticplayer.sequence.description import written
from hapticplayer.sequence.import_batch import log_beside
from hapticplayer.sequence.mounting_by_frames import SHOWN
from hapticplayer.sequence.presets import DEFAULT_PRESET, preset_of
from hapticplayer.sequence.writing import ESTIMATE


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "videos",
        metavar="VIDEO",
        nargs="+",
        help="or a folder that record has made; with several, each becomes a folder in DIR, with the log beside "
        "it under the same name (ride.mp4, ride.csv), and a summary is printed",
    )
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument("--title", help="default: the name of the video")
    command.add_argument("--json", action="store_true", help="print a report as JSON")
    log = command.add_argument_group("motion log")
    log.add_argument(
        "--imu",
        metavar="LOG",
        action="append",
        help="motion in a file of its own: the log of a logger or a phone (a folder or "
        "zip where it writes several files, or once for each of them), or CSV with the columns "
        "time_s,ax,ay,az,gx,gy,gz[,mx,my,mz] in SI, x right, y front, z up",
    )
    add_reading(log)
    add_mounting(log)
    add_sync(command)
    add_processing(command)
    force = command.add_argument_group("force")
    add_mapping(force)
    add_preset(force, default=DEFAULT_PRESET)
    add_number(
        force,
        "--seed",
        ranges.SEED,
        help="makes the random feedback; the same seed gives the same force "
        "(default: from the clip)",
    )
    _add_suggestion(command.add_argument_group("video without any log"))


def _add_suggestion(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--suggest-motion",
        action="store_true",
        help="estimate sway (in turns) and bounce (walking, riding) from the frames. "
        "The force is the feedback 'estimated': nothing measured it, and studies "
        "refuse it unless they name it. Needs the extra vision",
    )
    add_number(
        group,
        "--suggest-gain",
        ranges.SUGGEST_GAIN,
        metavar="G",
        help="strength with --suggest-motion: frames do not show how high the camera "
        "is (default: 1, as at 1.5 m)",
    )


def _suggest_gain(options: argparse.Namespace) -> float | None:
    """Return the gain of an estimate; None where the motion was recorded."""
    if not options.suggest_motion:
        if options.suggest_gain is not None:
            raise UsageError("--suggest-gain belongs to --suggest-motion")
        return None
    return 1.0 if options.suggest_gain is None else float(options.suggest_gain)


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Import a video with its motion, showing the progress; several with a summary."""
    if len(options.videos) > 1:
        return import_batch(options)
    choices, video, log = chosen_import(options), Path(options.videos[0]), options.imu
    if is_take(video):
        video, log, choices = _of_take(video, choices, options)
    with shown_progress() as progress:
        folder = build_sequence(
            video, options.output, imu_log=log, choices=choices, progress=progress
        )
    keep_template(options)
    sequence = open_sequence(folder)
    if options.json:
        described = written(sequence.description)
        say(json.dumps({"sequence": str(folder), **described}, ensure_ascii=False))
        return 0
    _say_imported(folder, sequence)
    return 0


def _of_take(
    folder: Path, choices: Choices, options: argparse.Namespace
) -> tuple[Path, Path | None, Choices]:
    """The clip and the log of what `record` has made, mounted as it says."""
    refuse_idle(options, "with a recording, which has its own log", "--imu")
    clip, log, mounting = parts_of(folder)
    if choices.suggest_gain is not None:
        return clip, None, choices
    mounting = choices.mounting or mounting
    return clip, log, dataclasses.replace(choices, mounting=mounting)


def chosen_import(options: argparse.Namespace) -> Choices:
    """The choices of an import."""
    if options.suggest_motion:
        refuse_idle(options, "without a recording (--suggest-motion)", *OF_A_RECORDING)
    mapping, fits_gain = chosen_mapping(options)
    return Choices(
        title=options.title,
        mapping=mapping,
        fits_gain=fits_gain,
        preset=options.preset,
        processing=chosen_processing(options),
        seed=options.seed,
        log=chosen_log(options),
        sync=chosen_sync(options),
        mounting=BY_FRAMES
        if options.mounting == BY_FRAMES
        else chosen_mounting(options),
        suggest_gain=_suggest_gain(options),
    )


def _say_imported(folder: Path, sequence: Sequence) -> None:
    made_of = sequence.description.provenance
    if ESTIMATE in made_of:
        _say_estimated(folder, sequence)
        return
    fit = " (fit)" if made_of["rendering"]["gain_from"] == FIT else ""
    say(
        f"{folder}: {sequence.duration_s:.1f} s of "
        f"{made_of['camera'] or made_of['motion_source']} at "
        f"{made_of['imu_rate_hz']:.1f} Hz; force peak {sequence.rendered.peak_n():.2f} N; "
        f"{mapping_text(sequence.mapping)}{fit}; "
        f"preset {preset_of(sequence.rendered)}; "
        f"gravity removed by {made_of['gravity_removal']}; "
        f"accelerometer gain {made_of['accelerometer_gain']:.4f} "
        f"({made_of['accelerometer_gain_from']})"
    )
    found = made_of.get("synchronisation")
    synchronised = ""
    if found and found["method"] in ("pats", "frames", "variance"):
        synchronised = sync_text(found)
        say(synchronised)
    if (
        SHOWN in made_of
        and (shown := mounting_text(made_of[SHOWN])) not in synchronised
    ):
        say(shown)
    for note in (*made_of["conditioning"], *made_of["notes"]):
        if note not in synchronised:
            say(f"note: {note}")
    say(f"play it with: {shell_line('hapticplayer', 'play', folder)}")


def _say_estimated(folder: Path, sequence: Sequence) -> None:
    made_of = sequence.description.provenance
    found = made_of[ESTIMATE]
    say(
        f"{folder}: {sequence.duration_s:.1f} s, motion estimated from the "
        f"picture, not measured; sway in {found['sway_trust']:.0%} and bounce in "
        f"{found['bounce_trust']:.0%} of the clip, gain {found['gain']:g}; "
        f"force peak {sequence.rendered.peak_n():.2f} N; {mapping_text(sequence.mapping)}; "
        f"preset {preset_of(sequence.rendered)}"
    )
    for note in made_of["notes"]:
        say(f"note: {note}")
    say(f"play it with: {shell_line('hapticplayer', 'play', folder)}")


@dataclass(frozen=True, slots=True)
class Row:
    """What became of one video.

    Attributes:
        video: its name.
        sequence: the new folder, or "" where there is none.
        status: 0 done, 1 refused, 2 a decision is needed.
        text: the offset and its confidence, or what was wrong.
    """

    video: str
    sequence: str
    status: int
    text: str


def import_batch(options: argparse.Namespace) -> int:
    """Import all videos and print a summary; the status is the worst but 2 of doubt.

    Raises:
        UsageError: for options that only one video can have.
    """
    for name in ("imu", "offset", "drift", "title"):
        if getattr(options, name) is not None:
            raise UsageError(f"--{name} belongs to one video; import them one by one")
    videos = [Path(video) for video in options.videos]
    names = [video.stem for video in videos]
    if len(set(names)) < len(names):
        raise UsageError("two videos have one name; import them into different folders")
    choices, rows = chosen_import(options), []
    for video in videos:
        with shown_progress() as progress:
            target = Path(options.output) / video.stem
            rows.append(_import(video, target, choices, options, progress))
    if any(row.status == 0 for row in rows):
        keep_template(options)
    if options.json:
        say(json.dumps([asdict(row) for row in rows], ensure_ascii=False))
    else:
        _say(rows)
    statuses = {row.status for row in rows}
    return 1 if 1 in statuses else max(statuses)


def _import(
    video: Path,
    target: Path,
    choices: Choices,
    options: argparse.Namespace,
    progress: Progress,
) -> Row:
    try:
        clip, log = video, None
        if is_take(video):
            clip, log, choices = _of_take(video, choices, options)
        elif choices.suggest_gain is None:
            log = log_beside(video)
        folder = build_sequence(
            clip, target, imu_log=log, choices=choices, progress=progress
        )
        sequence = open_sequence(folder)
    except Cancelled:
        raise
    except UsageError as problem:
        return Row(video.name, "", 2, str(problem))
    except HapticPlayerError as problem:
        return Row(video.name, "", 1, str(problem))
    clock, made_of = sequence.description.clock_map, sequence.description.provenance
    if clock is None or ESTIMATE in made_of:
        text = f"{sequence.duration_s:.1f} s, {made_of['motion_source']}"
        return Row(video.name, str(folder), 0, text)
    sync = made_of["synchronisation"]
    text = (
        f"{sequence.duration_s:.1f} s at {made_of['imu_rate_hz']:.0f} Hz, "
        f"offset {sync['offset_s']:.3f} s by {sync['method']} "
        f"(confidence {clock.confidence:.2f}), {len(made_of['notes'])} notes"
    )
    return Row(video.name, str(folder), 0, text)


def _say(rows: list[Row]) -> None:
    words = ("done", "refused", "to be decided")
    width = max(len(row.video) for row in rows)
    for row in rows:
        say(f"{row.video:<{width}}  {words[row.status]:<13}  {row.text}")
    counts = [sum(row.status == status for row in rows) for status in (0, 1, 2)]
    named = zip(counts, words, strict=True)
    say(f"{len(rows)} videos: " + ", ".join(f"{n} {word}" for n, word in named))
