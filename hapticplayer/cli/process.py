"""The command `process`: the quality report of a recording, and the methods compared."""

import argparse
import dataclasses
import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import storage
from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.mounting import mounted, refuse_upside_down
from hapticplayer.capture.recording import Recording, refuse_gravity_free
from hapticplayer.cli.common import (
    add_number,
    refuse_idle,
    say,
    shown_progress,
)
from hapticplayer.cli.plots import draw_motion
from hapticplayer.cli.recording_options import (
    add_mounting,
    add_processing,
    add_reading,
    chosen_log,
    chosen_mounting,
    chosen_processing,
    keep_template,
    plot_overwritten,
    plot_target,
)
from hapticplayer.clock import SystemClock, utc_now_iso
from hapticplayer.errors import Progress, UsageError
from hapticplayer.media.memory import give_back_freed_memory
from hapticplayer.model import ClockMap, ranges
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.motion.gravity import MIN_SAMPLES
from hapticplayer.sequence.calibration import (
    StoredCalibration,
    refuse_existing_calibration,
    write_calibration,
)
from hapticplayer.sequence.process_report import compare_methods, describe_quality
from hapticplayer.sequence.processing import (
    Processed,
    Processing,
    process_motion,
)
from hapticplayer.sequence.report import notes_on_motion
from hapticplayer.sequence.store import DESCRIPTION, read_recorded
from hapticplayer.sequence.surroundings import MARGIN_S, surroundings


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "recording",
        metavar="RECORDING",
        help="a camera's video, a log as for `import --imu`, or a sequence's folder",
    )
    add_reading(command)
    add_mounting(command)
    command.add_argument(
        "--compare",
        action="store_true",
        help="run all methods and print them side by side",
    )
    command.add_argument(
        "--plot",
        metavar="FILE",
        help="draw raw, gravity and motion over time (.png or .svg)",
    )
    add_number(
        command,
        "--start",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="report on a part that begins S seconds after the first sample; the motion "
        f"is estimated from up to {MARGIN_S / 60.0:g} minutes more on either side",
    )
    add_number(
        command,
        "--duration",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="length of the part (default: to the end)",
    )
    add_processing(command)
    command.add_argument(
        "--save-calibration",
        metavar="FILE",
        help="keep what the recording tells of the sensor's errors (.json) for "
        "--calibration with other recordings of it",
    )
    command.add_argument("--json", action="store_true", help="print the report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Print the quality report of a recording, with what else was asked for."""
    plot, target = plot_target(options), _calibration_target(options)
    processing = chosen_processing(options)
    with shown_progress() as progress:
        progress(0.0, f"reading {Path(options.recording).name}")
        recording = _read(
            Path(options.recording),
            chosen_log(options),
            chosen_mounting(options),
            options,
        )
        keep_template(options)
        progress(0.3, f"removing gravity: {processing.method}")
        give_back_freed_memory()  # a third of what an hour at 1 kHz needs
        mounting = chosen_mounting(options) or recording.provenance.get("mounting", "")
        processing = processing.mounted(mounting)
        recording, whole, part, elsewhere = _estimated(recording, processing, options)
        processed = whole.part(part)
        give_back_freed_memory()
        report = describe_quality(recording, processed)
        report["notes"] = notes_on_motion(processed.imu, processed.summary)
        if len(processed.track) < len(whole.track):
            report["notes"].append(_surroundings_text(whole))
        if processing.calibration is not None:
            report["notes"] += processing.calibration.notes(recording.camera)
        if options.compare:
            report["methods"] = _compared(
                whole, processing, progress, elsewhere=elsewhere, part=part
            )
        if target is not None:
            _save(target, processed, recording, mounting, options)
        if plot:
            progress(0.9, f"drawing {plot.name}")
            with storage.file_written_aside(plot, plot_overwritten(options)) as aside:
                draw_motion(aside, processed, report["recording"]["source"])
    _say(report, processed, options)
    return 0


def _read(
    path: Path, choices: LogChoices, mounting: str, options: argparse.Namespace
) -> Recording:
    """Return the motion of a recording, or of the folder of a sequence."""
    if not (path / DESCRIPTION).is_file():
        recording = read_recording(path, choices)
        refuse_gravity_free(recording)
        turned = mounted(recording.imu, mounting)
        if mounting:
            refuse_upside_down(turned, path.name, mounting)
        return dataclasses.replace(recording, imu=turned)
    of_a_log = ("--mounting", "--read-as", "--save-template")
    refuse_idle(options, f"on {path.name}, which is a sequence", *of_a_log)
    imu, made_of = read_recorded(path)
    kept = {k: str(made_of[k]) for k in ("mounting",) if k in made_of}
    return Recording(imu, ClockMap(), str(made_of.get("camera", "")), provenance=kept)


def _estimated(
    recording: Recording, processing: Processing, options: argparse.Namespace
) -> tuple[Recording, Processed, slice, SensorCalibration | None]:
    """Return the part of a recording, the motion around it, and which of that it is."""
    imu = recording.imu
    if options.start is None and options.duration is None:
        return recording, process_motion(imu, processing), slice(None), None
    start_s = float(imu.time_s[0]) + (options.start or 0.0)
    length_s = math.inf if options.duration is None else options.duration
    near, elsewhere = surroundings(imu, start_s, start_s + length_s)
    part = _part(near.time_s, start_s, length_s, options)
    whole = process_motion(near, processing, elsewhere)
    shown = dataclasses.replace(recording, imu=near.part(part))
    # conditioning may have averaged the samples
    part = _part(whole.track.time_s, start_s, length_s, options)
    return shown, whole, part, elsewhere


def _part(
    time_s: Floats, start_s: float, length_s: float, options: argparse.Namespace
) -> slice:
    first, last = np.searchsorted(time_s, [start_s, start_s + length_s]).tolist()
    if last - first < MIN_SAMPLES:
        name = Path(options.recording).name
        length = "" if options.duration is None else f" --duration {length_s:g}"
        raise UsageError(
            f"--start {options.start or 0.0:g}{length}: there is no motion in this part "
            f"of {name}"
        )
    return slice(first, last)


def _surroundings_text(whole: Processed) -> str:
    time_s = whole.track.time_s
    return f"estimated from the {time_s[-1] - time_s[0]:.0f} s around this part"


def _calibration_target(options: argparse.Namespace) -> Path | None:
    """Return the file for the calibration, checked before the long work starts."""
    if options.save_calibration is None:
        return None
    target = Path(options.save_calibration)
    refuse_existing_calibration(target, overwrite=options.overwrite)
    return target


def _save(
    target: Path,
    processed: Processed,
    recording: Recording,
    mounting: str,
    options: argparse.Namespace,
) -> None:
    """Write the calibration, in the recorder's axes."""
    if processed.calibration is None:
        raise UsageError(
            "--save-calibration needs the method smoother, without --time-constant"
        )
    stored = StoredCalibration(
        processed.calibration,
        recording.camera,
        Path(recording.imu.source).name,
        utc_now_iso(),
    )
    write_calibration(target, stored.dismounted(mounting), overwrite=options.overwrite)


def _compared(
    whole: Processed,
    processing: Processing,
    progress: Progress,
    *,
    elsewhere: SensorCalibration | None,
    part: slice,
) -> list[dict[str, Any]]:
    rows = []
    progress(0.4, "comparing the methods")
    for row in compare_methods(
        whole.imu, processing, SystemClock(), elsewhere=elsewhere, part=part
    ):
        rows.append(dataclasses.asdict(row))
        progress(min(0.85, 0.4 + 0.1 * len(rows)), f"compared {row.method}")
    return rows


def _say(
    report: dict[str, Any], processed: Processed, options: argparse.Namespace
) -> None:
    if options.json:
        say(json.dumps(report, ensure_ascii=False, allow_nan=False))
        return
    say(quality_text(report))
    if options.compare:
        say("\n" + comparison_text(report["methods"], processed.summary["method"]))
    if options.save_calibration:
        say(f"\ncalibration: {options.save_calibration}")
    if options.plot:
        say(f"\ndrawn: {options.plot}")


_COLUMNS = (
    ("RMS of p", "rms_mps2", 3),
    ("at rest", "leak_at_rest_mps2", 3),
    ("to default", "difference_mps2", 3),
    ("sigma", "gravity_sigma_mps2", 3),
    ("us/sample", "us_per_sample", 2),
)


def quality_text(report: dict[str, Any]) -> str:
    """Return a quality report (`sequence.process_report.describe_quality`) as lines."""
    read, found = report["recording"], report["gravity_removal"]
    lines = [
        f"{read['source']} - {read['camera']}",
        _line("recording", _recording_text(read)),
        *(_line("as read", note) for note in read["notes"]),
        *(_line("conditioned", step) for step in report["conditioning"]),
        _line("method", _method_text(found)),
        *(_line(name, text) for name, text in _bias_texts(found)),
        _line(
            "gain",
            f"{found['accelerometer_gain']:.4f} ({found['accelerometer_gain_from']})",
        ),
        _line("at rest", _leak_text(found)),
        _line(
            "samples",
            f"{_percent(found['saturated_share'])} at the sensor's limit, "
            f"{_percent(found['invalid_share'])} not valid",
        ),
        _line("uncertainty", _sigma_text(found)),
        _line("motion", _motion_text(report["motion"])),
        *(_line(*entry) for entry in _excursion_texts(report["excursion"])),
    ]
    return "\n".join(lines + [f"note: {note}" for note in report.get("notes", ())])


def comparison_text(rows: list[dict[str, Any]], chosen: str) -> str:
    """Return the methods side by side; the chosen one has a star."""
    head = f"{'m/s^2':<14}" + "".join(f"{name:>12}" for name, _, _ in _COLUMNS)
    lines = [head]
    for row in rows:
        name = row["method"] + (" *" if row["method"] == chosen else "")
        cells = (_number(row[key], digits) for _, key, digits in _COLUMNS)
        lines.append(f"{name:<14}" + "".join(f"{cell:>12}" for cell in cells))
    return "\n".join(lines)


def _line(name: str, text: str) -> str:
    return f"  {name:<13}{text}"


def _recording_text(read: dict[str, Any]) -> str:
    text = (
        f"{read['samples']} samples in {read['duration_s']:.2f} s "
        f"at {read['rate_hz']:.2f} Hz, "
    )
    if not read["gaps"]:
        return text + "no gaps"
    count = "one gap" if read["gaps"] == 1 else f"{read['gaps']} gaps"
    return text + f"{count}, the longest of {read['longest_gap_s']:.2f} s"


def _method_text(found: dict[str, Any]) -> str:
    constants_s = found.get("time_constant_s")
    if not constants_s:
        return str(found["method"])
    shortest_s, longest_s = constants_s
    span = f"{shortest_s:.1f} s"
    if longest_s - shortest_s >= 0.05:
        span = f"{shortest_s:.1f} to {longest_s:.1f} s"
    return f"{found['method']}, time constant {span} ({found['time_constant_from']})"


def _bias_texts(found: dict[str, Any]) -> list[tuple[str, str]]:
    texts = []
    if gyro := found.get("gyro_bias_radps"):
        degrees = ", ".join(f"{math.degrees(value):+.3f}" for value in gyro)
        source = found.get("gyro_bias_from")
        texts.append(
            ("gyro bias", f"{degrees} deg/s" + (f" ({source})" * bool(source)))
        )
    if force := found.get("accelerometer_bias_mps2"):
        numbers = ", ".join(f"{value:+.3f}" for value in force)
        texts.append(("acc. bias", f"{numbers} m/s^2"))
    return texts


def _leak_text(found: dict[str, Any]) -> str:
    leak_mps2 = found["leak_at_rest_mps2"]
    if leak_mps2 is None:
        return "no stationary span to measure how much gravity is left"
    return f"{leak_mps2:.3f} m/s^2 of gravity left, over {found['still_s']:.1f} s"


def _sigma_text(found: dict[str, Any]) -> str:
    sigma_mps2 = found["gravity_sigma_mps2"]
    if sigma_mps2 is None:
        return "not known to this method"
    return f"{sigma_mps2:.3f} m/s^2 (median sigma of the removed gravity)"


def _motion_text(motion: dict[str, Any]) -> str:
    if motion["rms_mps2"] is None:
        return "no valid sample"
    return (
        f"RMS {motion['rms_mps2']:.3f} m/s^2, peak {motion['peak_mps2']:.2f} m/s^2 "
        f"at {motion['peak_at_s']:.2f} s"
    )


def _excursion_texts(found: dict[str, Any]) -> list[tuple[str, str]]:
    """Return how far hands would go."""
    hands = found["hands"]
    reached = ", ".join(
        f"{name} {100.0 * one['reach']:.0f} %" for name, one in hands.items()
    )
    far = f"{_percent(hands['relaxed']['far_share'])} of the time beyond"
    heat = f"{_percent(found['thermal_share'])} of the continuous force"
    return [
        ("excursion", f"{reached} of the workspace (at the default gain)"),
        ("relaxed hand", f"{far} {100.0 * found['far']:.0f} %"),
        *(("trip", _trip_text(*entry)) for entry in hands.items() if entry[1]["trip"]),
        ("motors", f"{found['rms_10s_n']:.2f} N over 10 s at most, {heat}"),
    ]


def _trip_text(name: str, one: dict[str, Any]) -> str:
    return f"{name} hand: {one['trip']} at {one['trip_at_s']:.1f} s stops the force"


def _number(value: float | None, digits: int) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def _percent(share: float) -> str:
    return f"{100.0 * share:.3g} %"
