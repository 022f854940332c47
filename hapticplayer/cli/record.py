"""The command `record`: camera, microphone and IMU into a folder that `import` takes."""

import argparse
import math
import select
import sys
from collections.abc import Iterable
from typing import TextIO

from hapticplayer.capture.live.recorder import Recorder
from hapticplayer.capture.live.recorder_state import RecorderState
from hapticplayer.capture.live.source import live_sources
from hapticplayer.capture.recorded import read_take
from hapticplayer.cli.common import add_number, say, say_aside, shown_progress
from hapticplayer.cli.recording_options import chosen_mounting
from hapticplayer.cli.source_options import STANDARD_INPUT, add_source, opened_source
from hapticplayer.clock import SystemClock
from hapticplayer.errors import UsageError, shell_line
from hapticplayer.media.camera_modes import CameraMode, camera_modes
from hapticplayer.media.live_input import CAMERAS, MICROPHONES, device_names
from hapticplayer.model import ranges

_TICK_S = 0.1
_SHOWN_GAPS = 20
_EXAMPLES = {CAMERAS: "/dev/video0", MICROPHONES: "default"}


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument("-o", "--output", metavar="DIR", help="a new folder")
    command.add_argument(
        "--camera",
        metavar="NAME",
        help="as --list shows it, with options of the camera behind commas: "
        "/dev/video0,video_size=1280x720,framerate=30 (default: without)",
    )
    command.add_argument(
        "--audio",
        metavar="NAME",
        help="a microphone, as --list shows it (default: without)",
    )
    add_source(command)
    add_number(
        command,
        "--duration",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="stop by itself (default: Ctrl+C stops; Enter marks a moment)",
    )
    command.add_argument(
        "--list", action="store_true", help="list cameras, microphones and sources"
    )


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Record until Ctrl+C or the duration; then say how to import it."""
    if options.list:
        _list()
        return 0
    if options.output is None:
        raise UsageError("give a new folder for the recording (-o DIR)")
    clock = SystemClock()
    source = opened_source(options, clock) if options.imu else None
    recorder = Recorder(
        options.output,
        options.camera,
        options.audio,
        source,
        clock,
        source_name=options.imu or "",
        mounting=chosen_mounting(options),
    )
    recorder.start()
    try:
        _until_stopped(recorder, options)
    except KeyboardInterrupt:  # as a person stops it
        pass
    finally:
        recorder.stop()
    return _report(recorder)


def _until_stopped(recorder: Recorder, options: argparse.Namespace) -> None:
    heard, told = _listened_to(options), 0
    with shown_progress() as progress:
        while True:
            state = recorder.snapshot(with_frame=False)
            for notice in state.notices[told:]:
                say_aside(notice)
            told = len(state.notices)
            if state.is_over or state.elapsed_s >= (options.duration or math.inf):
                return
            if sys.stderr.isatty():
                progress(state.elapsed_s / (options.duration or math.inf), _line(state))
            if select.select(heard, [], [], _TICK_S)[0]:
                heard = _marked(recorder)


def _listened_to(options: argparse.Namespace) -> list[TextIO]:
    """The standard input, if there is one and it is not the source's."""
    try:
        sys.stdin.fileno()
    except (AttributeError, OSError):
        return []
    is_read = (options.imu or "").partition(",")[0] == STANDARD_INPUT
    return [] if is_read else [sys.stdin]


def _marked(recorder: Recorder) -> list[TextIO]:
    """Mark for a line; what is listened to from now on."""
    if not sys.stdin.readline():
        return []
    say_aside(f"marked at {recorder.mark():.1f} s")
    return [sys.stdin]


def _line(state: RecorderState) -> str:
    parts = [f"{state.elapsed_s:.0f} s"]
    if state.frames:
        parts.append(f"{state.camera_hz:.0f} frames/s")
    if state.samples:
        parts.append(f"{state.imu_hz:.0f} samples/s")
    if state.level_db is not None:
        parts.append(f"{state.level_db:.0f} dB")
    parts.append(f"{state.free_bytes / 1e9:.1f} GB free")
    if lost := state.dropped_frames + state.dropped_samples:
        parts.append(f"{lost} dropped")
    return ", ".join(parts)


def _report(recorder: Recorder) -> int:
    """Say what was recorded, how well the clocks are known, and how to go on."""
    folder, take = recorder.folder, read_take(recorder.folder)
    state = recorder.snapshot(with_frame=False)
    say(
        f"{folder}: {state.frames} frames ({state.dropped_frames} dropped), "
        f"{state.samples} samples ({state.dropped_samples} dropped), "
        f"{len(take.gaps)} gaps, {len(take.marks_s)} marks"
    )
    for clock in filter(None, (take.clock, *take.restarts)):
        say(
            f"clock of the IMU: {1e6 * (clock.rate - 1.0):+.0f} ppm, residual "
            f"{1e3 * clock.residual_s:.1f} ms"
        )
    for gap in take.gaps[:_SHOWN_GAPS]:
        say(f"gap: {gap.stream} from {gap.begin_s:.2f} to {gap.end_s:.2f} s")
    if take.camera is not None:
        suggested = [] if take.imu is not None else ["--suggest-motion"]
        line = shell_line(
            "hapticplayer", "import", folder, *suggested, "-o", "SEQUENCE"
        )
        say(f"import it with: {line}")
    return 1 if state.is_over or not take.is_finished else 0


def _list() -> None:
    clocks = ((CAMERAS, "cameras"), (MICROPHONES, "microphones"))
    for kind, title in clocks:
        names = device_names(kind)
        say(f"{title} (--{'camera' if kind == CAMERAS else 'audio'}):")
        for name, text in names:
            say(f"  {name}  {text}")
            for size in _fastest(name) if kind == CAMERAS else ():
                say(f"    {name}{size.options}")
        if not names:
            say(f"  none was found; plug one in, or give its name ({_EXAMPLES[kind]})")
    say("sources of motion (--imu):")
    for row in live_sources():
        place = f"{row.name}:{row.example}" if row.example else row.name
        say(f"  {place:<36} {row.text}")


def _fastest(camera: str) -> Iterable[CameraMode]:
    """Of each size that a camera offers, the mode with the highest rate."""
    return {one[:2]: one for one in reversed(camera_modes(camera))}.values()
