"""What `import`, `sync` and `process` share: options, and a synchronisation in words."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from hapticplayer.capture.choices import (
    LogChoices,
    parse_choices,
    refuse_existing_template,
    write_template,
)
from hapticplayer.capture.mounting import MOUNTINGS, mounting_axes
from hapticplayer.capture.sync import methods
from hapticplayer.capture.sync.result import COARSE, FoundMounting
from hapticplayer.cli.common import add_number, add_overwrite, refuse_idle
from hapticplayer.cli.plots import is_plot
from hapticplayer.errors import Message, UsageError
from hapticplayer.installation import require
from hapticplayer.model import ranges
from hapticplayer.motion import DEFAULT_METHOD, METHODS
from hapticplayer.sequence.calibration import read_calibration
from hapticplayer.sequence.processing import Processing
from hapticplayer.sequence.synchronizing import (
    SyncChoices,
    coarse_notes,
    stored_skews,
)
from hapticplayer.storage import FILE, IsOurs, refuse_existing

PLOT_FORMATS = (".png", ".svg")


def add_reading(command: argparse._ActionsContainer) -> None:
    """Add what decides how a log is read."""
    command.add_argument(
        "--read-as",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="decide what a log does not say, such as axes=x,-z,y or accel-unit=g or "
        "template=FILE or format=NAME (see docs/formats.md); the question names the key, "
        "and more of them may follow",
    )
    command.add_argument(
        "--save-template",
        metavar="FILE",
        help="keep these decisions for other logs of the same logger",
    )
    add_overwrite(command, "--save-template", "--plot", "--save-calibration")


OF_A_RECORDING = (
    *("--read-as", "--save-template", "--mounting", "--sync", "--offset", "--camera"),
    *(
        "--drift",
        "--slow-motion",
        "--skew",
        "--method",
        "--time-constant",
        "--remove-spikes",
        "--repair-clipping",
    ),
    *("--average", "--lowpass", "--calibration"),
)
"""Options that say how a recording is read, synchronised and processed."""


def add_mounting(command: argparse._ActionsContainer) -> None:
    """Add how the recorder was mounted."""
    command.add_argument(
        "--mounting",
        metavar="HOW",
        help="how the camera or logger was mounted on the wearer: "
        f"{', '.join(MOUNTINGS)}, or the wearer's right, front and up in the "
        "recorder's axes, such as --mounting=-x,y,-z (default: forward, and gravity and "
        "frames have to agree); with `import` also auto: as the frames tell",
    )


def add_sync(command: argparse.ArgumentParser) -> None:
    """Add what decides on the synchronisation."""
    group = command.add_argument_group("synchronisation")
    group.add_argument(
        "--sync",
        dest="sync_method",
        choices=[one.name for one in methods.sync_methods()],
        default=methods.AUTO,
        help="; ".join(f"{one.name}: {one.text}" for one in methods.sync_methods())
        + f" (default: {methods.AUTO})",
    )
    add_number(
        group,
        "--offset",
        ranges.OFFSET_S,
        metavar="S",
        help="media time at which the log's clock reads zero; with --drift as it is in the "
        "middle of the clip, as it is printed",
    )
    add_number(
        group,
        "--drift",
        ranges.DRIFT_PPM,
        metavar="PPM",
        help="with --offset: by how much faster the video runs than the log's clock",
    )
    add_number(
        group,
        "--slow-motion",
        ranges.SLOWED,
        metavar="N",
        help="the video plays N times as slow as it was recorded (0.1: ten times as "
        "fast), 1 for not at all, whatever its metadata say",
    )
    group.add_argument(
        "--camera",
        metavar="NAME",
        help="apply the skew that is stored for this camera (default: the camera "
        "that the clip names)",
    )
    add_number(
        group,
        "--skew",
        ranges.SKEW_S,
        metavar="S",
        help="delay of the camera's sound against its video",
    )


def add_processing(command: argparse.ArgumentParser) -> None:
    """Add how the samples are conditioned and gravity is removed."""
    group = command.add_argument_group("motion")
    group.add_argument(
        "--method",
        choices=METHODS,
        help="how gravity is removed. "
        + "; ".join(f"{one.name}: {one.text}" for one in METHODS.values())
        + f" (default: {DEFAULT_METHOD})",
    )
    add_number(
        group,
        "--time-constant",
        ranges.TIME_CONSTANT_S,
        metavar="S",
        help="with the smoother: accelerations that last much longer than S seconds "
        "count as gravity (default: from how fast the recording moves)",
    )
    group.add_argument(
        "--remove-spikes", action="store_true", help="replace isolated spikes"
    )
    group.add_argument(
        "--repair-clipping",
        action="store_true",
        help="reconstruct short peaks beyond the sensor's range",
    )
    add_number(
        group,
        "--average",
        ranges.AVERAGE_HZ,
        metavar="HZ",
        help="average the samples first",
    )
    add_number(
        group,
        "--lowpass",
        ranges.LOWPASS_HZ,
        metavar="HZ",
        help="low-pass the motion, zero phase",
    )
    group.add_argument(
        "--calibration",
        metavar="FILE",
        help="what another recording of this sensor tells of its errors, written by "
        "`process --save-calibration`: a prior of the smoother, for short recordings",
    )


def chosen_mounting(options: argparse.Namespace) -> str:
    return "" if options.mounting is None else mounting_axes(options.mounting)


def chosen_log(options: argparse.Namespace) -> LogChoices:
    if options.save_template is not None:
        refuse_existing_template(Path(options.save_template), options.overwrite)
    return parse_choices(options.read_as)


def keep_template(options: argparse.Namespace) -> None:
    """Keep the choices as a template, if wanted, now that they have read the log."""
    if options.save_template is not None:
        path, choices = Path(options.save_template), parse_choices(options.read_as)
        write_template(path, choices, overwrite=options.overwrite)


def chosen_sync(options: argparse.Namespace) -> SyncChoices:
    """The choices about the clocks."""
    if options.sync_method not in {methods.AUTO, "offset"}:
        why = f"with the method {options.sync_method}, which finds it"
        refuse_idle(options, why, "--offset")
    if options.offset is None:
        refuse_idle(options, "without --offset, which it belongs to", "--drift")
    late_s = options.skew
    is_stored = getattr(options, "store_skew", False)
    if late_s is not None and not is_stored:
        refuse_idle(options, "beside --skew, which is taken", "--camera")
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
        method=options.sync_method,
        offset_s=options.offset,
        drift_ppm=options.drift or 0.0,
        slowed=options.slow_motion,
        sound_late_s=late_s,
        refuses_idle_skew=late_s is not None and not is_stored,
    )


def chosen_processing(options: argparse.Namespace) -> Processing:
    """The choices about the motion."""
    given = options.calibration
    calibration = None if given is None else read_calibration(Path(given))
    method = {} if options.method is None else {"method": options.method}
    return Processing(
        **method,
        time_constant_s=options.time_constant,
        remove_spikes=options.remove_spikes,
        repair_clipping=options.repair_clipping,
        average_hz=options.average,
        lowpass_hz=options.lowpass,
        calibration=calibration,
    )


def plot_target(options: argparse.Namespace) -> Path | None:
    """Return the file to draw, checked before the long work starts."""
    if options.plot is None:
        return None
    require("study", Message("drawing a figure"))
    target = Path(options.plot)
    if target.suffix.lower() not in PLOT_FORMATS:
        raise UsageError(
            f"--plot {target.name} must end in {' or '.join(PLOT_FORMATS)}"
        )
    refuse_existing(target, FILE, plot_overwritten(options))
    return target


def plot_overwritten(options: argparse.Namespace) -> IsOurs | None:
    return is_plot if options.overwrite else None


def sync_text(found: Mapping[str, Any]) -> str:
    """Return the sentences on what `Synchronisation.described` holds."""
    first = (
        f"offset {found['offset_s']:.3f} s by {found['method']}, "
        f"confidence {found['confidence']:.2f}, "
        f"residual {1e3 * found['residual_s']:.1f} ms"
    )
    if found["drift_is_fitted"]:
        first += f", drift {found['drift_ppm']:+.1f}"
        if found["drift_sigma_ppm"]:
            first += f" ± {found['drift_sigma_ppm']:.1f}"
        first += " ppm"
    if found["sound_late_s"]:
        skew_ms = 1e3 * found["sound_late_s"]
        first += f", {skew_ms:.0f} ms of the camera's skew taken off"
    lines = [first, *_lag_text(found), *_frames_text(found)]
    if found["drift_is_fitted"]:
        lines.append(
            f"  the same again: --offset {found['offset_s']:.6f} "
            f"--drift {found['drift_ppm']:.3f}"
        )
    for count, pat in enumerate(found["pats"], start=1):
        lines.append(
            f"  tap {count}: heard at {pat['heard_s']:.3f} s, felt at "
            f"{pat['felt_s']:.3f} s of the log; events this strong: "
            f"{rarity_text(pat['heard_rarity_hz'])} in the sound, "
            f"{rarity_text(pat['felt_rarity_hz'])} in the log"
        )
    return "\n".join(lines)


def _lag_text(found: Mapping[str, Any]) -> list[str]:
    lag = found.get("lag")
    return [f"  {lag['text']}"] if lag else []


def _frames_text(found: Mapping[str, Any]) -> list[str]:
    """Return the result of the frames, and that of a second method."""
    lines, evidence, second = [], found.get("frames"), found.get("second")
    if evidence:
        lines.append(
            f"  frames: the gyro explains {100 * evidence['explained']:.0f} % of the "
            f"camera's rotation; offset ± {1e3 * found['offset_sigma_s']:.1f} ms, "
            f"read-out {1e3 * evidence['read_out_s']:.0f} ± "
            f"{1e3 * evidence['read_out_sigma_s']:.0f} ms"
        )
        if evidence.get("kind") == COARSE:
            lines += [f"  {note}" for note in coarse_notes()]
    if found.get("mounting"):
        lines.append(f"  {mounting_text(found['mounting'])}")
    if second:
        lines.append(
            f"  by {second['method']}: offset {second['offset_s']:.3f} s "
            f"± {1e3 * second['offset_sigma_s']:.1f} ms, "
            f"confidence {second['confidence']:.2f}"
        )
    if found.get("seen"):
        lines.append(f"  {found['seen']}")
    return lines


def mounting_text(found: Mapping[str, Any]) -> str:
    """Return the sentence on what `FoundMounting.described` holds."""
    if FoundMounting(**found).is_clear:
        return f"mounting {found['axes']} by the frames, ratio {found['ratio']:.1f}"
    return (
        f"mounting {found['axes']} or {found['next_best']}: the frames do not tell, "
        f"ratio {found['ratio']:.2f}"
    )


def rarity_text(rarity_hz: float) -> str:
    """Return how often events so strong occur."""
    if rarity_hz < 1 / 60:
        return "less than one a minute"
    return f"{60 * rarity_hz:.0f} a minute"
