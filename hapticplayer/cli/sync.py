"""The command `sync`: clock offset and rate, checks of the pats, skews of cameras."""

import argparse
import dataclasses
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer import storage
from hapticplayer.capture import read_recording
from hapticplayer.capture.recording import Recording
from hapticplayer.capture.sync.check import check_log, check_sound
from hapticplayer.capture.sync.synchronize import read_sound
from hapticplayer.cli.common import complain, refuse_idle, say
from hapticplayer.cli.plots import draw_sync
from hapticplayer.cli.recording_options import (
    add_reading,
    add_sync,
    chosen_log,
    chosen_sync,
    keep_template,
    plot_overwritten,
    plot_target,
    rarity_text,
    sync_text,
)
from hapticplayer.errors import MediaError, TelemetryError, UsageError
from hapticplayer.media.clip_info import ClipInfo, probe
from hapticplayer.sequence.synchronizing import (
    SyncChoices,
    ask_for_pace,
    contradicted,
    find_sync,
    store_skew,
    uncertainty,
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "clip", metavar="CLIP", help="a video; with --check also a log"
    )
    command.add_argument(
        "logs",
        nargs="*",
        metavar="LOG",
        help="as --imu of `import` (default: the clip's own motion)",
    )
    command.add_argument(
        "--imu", metavar="LOG", action="append", help="the same, as for `import`"
    )
    add_reading(command)
    add_sync(command)
    command.add_argument(
        "--check",
        action="store_true",
        help="say whether the taps of a recording can be used, right after making it",
    )
    command.add_argument(
        "--plot",
        metavar="FILE",
        help="draw sound and acceleration on one timeline (.png or .svg)",
    )
    command.add_argument(
        "--store-skew",
        action="store_true",
        help="keep --skew for all clips of --camera",
    )
    command.add_argument("--json", action="store_true", help="print the report as JSON")


@dataclass(frozen=True, slots=True, eq=False)
class _CheckInput:
    """What there is to check: a clip's sound, a motion, or both."""

    clip: ClipInfo | None
    recording: Recording | None


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Print clock offset and rate; status 2 where a decision is needed."""
    options.imu = [*options.logs, *(options.imu or ())] or None
    if options.store_skew:
        _store_skew(options)
    choices, plot = chosen_sync(options), plot_target(options)
    if options.check:
        idle = ("--plot", "--sync", "--offset", "--drift", "--slow-motion")
        refuse_idle(options, "with --check", *idle)
        checked = _read_either(options)
        keep_template(options)
        return _check(checked, options, choices)
    clip = probe(options.clip)
    ask_for_pace(clip, choices)
    recording = read_recording(options.imu or options.clip, chosen_log(options))
    keep_template(options)
    found = find_sync(clip, recording, choices)
    if plot:
        sound = read_sound(clip.path)
        with storage.file_written_aside(plot, plot_overwritten(options)) as part:
            draw_sync(part, sound, recording.imu, found)
    described = found.described()
    say(json.dumps(described) if options.json else sync_text(described))
    if plot and not options.json:
        say(f"drawn: {plot}")
    if found.is_confident:
        return 0
    complain(uncertainty(found, clip.path.name))
    return 2


def _store_skew(options: argparse.Namespace) -> None:
    if options.camera is None or options.skew is None:
        raise UsageError("--store-skew needs --camera NAME and --skew S")
    store_skew(options.camera, options.skew)


def _read_either(options: argparse.Namespace) -> _CheckInput:
    """Read a clip, a log, or both; what one file lacks is no error."""
    log = chosen_log(options)
    try:
        clip = probe(options.clip)
    except MediaError as problem:
        if options.imu is not None:
            raise
        try:
            return _CheckInput(None, read_recording(options.clip, log))
        except (MediaError, TelemetryError):
            raise problem from None
    try:
        return _CheckInput(clip, read_recording(options.imu or options.clip, log))
    except TelemetryError:
        if options.imu is not None or not clip.has_audio:
            raise
        return _CheckInput(clip, None)


def _check(
    found: _CheckInput, options: argparse.Namespace, choices: SyncChoices
) -> int:
    """Say whether the pats of what there is can be used."""
    clip, recording = found.clip, found.recording
    report: dict[str, Any] = {}
    knows_clock = recording is not None and recording.clock_map.confidence > 0.0
    if clip and recording and knows_clock and not contradicted(recording, clip):
        report = {"is_usable": True, "needs_pats": False}
        text = (
            f"{recording.camera} keeps its motion on the clip's clock: no taps needed"
        )
        say(json.dumps(report) if options.json else text)
        return 0
    if clip is not None and clip.has_audio:
        report["sound"] = check_sound(read_sound(clip.path)).described()
    if recording is not None:
        report["motion"] = check_log(recording.imu).described()
    usable = bool(report) and all(part["is_usable"] for part in report.values())
    lines = [check_text(name, part) for name, part in report.items()]
    if len(report) == 2 and clip is not None and recording is not None:
        both = find_sync(clip, recording, dataclasses.replace(choices, method="pats"))
        report["together"] = both.described()
        lines.append(sync_text(report["together"]))
        usable = both.is_confident
    report["is_usable"] = usable
    verdict = "the taps can be used" if usable else _ADVICE
    say(json.dumps(report) if options.json else "\n".join([*lines, verdict]))
    return 0 if usable else 2


_ADVICE = (
    "the taps cannot be used: hold still, tap the camera three times, half a second "
    "apart and harder than anything else, and record again (see docs/recording.md)"
)


def check_text(name: str, found: Mapping[str, Any]) -> str:
    """Return the sentence on what `StreamCheck.described` holds."""
    times = ", ".join(f"{at:.2f}" for at in found["pats_s"])
    if not found["pats_s"]:
        return f"{name}: no three taps in a rhythm"
    verdict = "stand out" if found["is_usable"] else "do not stand out"
    return (
        f"{name}: three taps at {times} s {verdict} "
        f"(the weakest is {rarity_text(found['rarity_hz'])})"
    )
