"""The command `play`, and the demo that plays without a command."""

import argparse
import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hapticplayer import __version__, extension
from hapticplayer.cli import OpenWindow
from hapticplayer.cli.common import (
    add_accept_changed,
    add_number,
    add_outputs,
    add_overwrite,
    complain,
    peak_text,
    refuse_idle,
    say,
    say_aside,
)
from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import Message, UsageError
from hapticplayer.haptics.limiter import Limits
from hapticplayer.haptics.records import is_record
from hapticplayer.linux import Scheduling, taken_away
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.model import ranges
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.latency import saved_latencies
from hapticplayer.playback.log import PlaybackLog, is_log
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import FASTEST, SLOWEST, Player
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import FROM_FILE, Source, open_source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.rendering import FEEDBACKS
from hapticplayer.shipped import DEMO
from hapticplayer.storage import FILE, make_way, refuse_existing

_ADDRESS = re.compile(r"([a-z][a-z0-9+.-]+)://", re.IGNORECASE)
_OF_THE_WINDOW = ("--fullscreen", "--no-plots", "--close-at-end")
ACCEPT_IT = "--accept-changed-video plays the force with it"


@dataclass(frozen=True, slots=True)
class RemoteSource:
    """Addresses from which a clip can be read.

    Args:
        name: of the row.
        schemes: what the addresses begin with.
        home: "module:class" of their `ClipBytes`, called with address and clock.
    """

    name: str
    schemes: tuple[str, ...]
    home: str


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.set_defaults(run=run)
    parser.add_argument(
        "source",
        metavar="SEQUENCE_OR_VIDEO",
        help="folder of a sequence, a file that was packed, any video, or the URL of "
        "a file that was packed; in the window also the folder of a study",
    )
    parser.add_argument(
        "more", nargs="*", metavar="MORE", help="in the window: played after it"
    )
    parser.add_argument(
        "--allow-network",
        action="store_true",
        help="fetch the file of a URL; nothing else ever uses a network",
    )
    parser.add_argument(
        "--feedback",
        metavar="F",
        help=f"{_feedback_names()}, or another of its tracks",
    )
    parser.add_argument(
        "--force",
        metavar="FILE.csv",
        help="force track: rows of time_s,fx_n,fy_n,fz_n, held between rows",
    )
    add_accept_changed(parser)
    add_outputs(parser)
    parser.add_argument("--headless", action="store_true", help="without a window")
    parser.add_argument(
        "--mute",
        action="store_true",
        help="silent; without a window no sound is decoded",
    )
    parser.add_argument("--fullscreen", action="store_true")
    parser.add_argument(
        "--no-plots", dest="plots", action="store_false", help="hide the live plots"
    )
    parser.add_argument(
        "--close-at-end", action="store_true", help="close the window after the clip"
    )
    add_number(
        parser,
        "--start",
        ranges.MEDIA_TIME_S,
        default=0.0,
        metavar="S",
        help="media time, s",
    )
    add_number(
        parser,
        "--duration",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="stop after S seconds",
    )
    add_number(
        parser,
        "--speed",
        ranges.SPEED,
        default=1.0,
        metavar="X",
        help=f"{SLOWEST:g} to {FASTEST:g} (default: 1)",
    )
    add_running(parser)


def add_running(parser: argparse.ArgumentParser) -> None:
    """Add what is kept of a run, and how its loop is scheduled."""
    parser.add_argument(
        "--log", metavar="FILE", help="write what happened as JSON lines"
    )
    parser.add_argument(
        "--record",
        metavar="FILE",
        help="record every tick of the haptic loop; see `export`",
    )
    add_overwrite(parser, "--log", "--record")
    parser.add_argument(
        "--scheduling",
        choices=("fifo", "slice", "normal"),
        help="at most this class for the haptic loop; for measurements "
        "(default: the best there is)",
    )
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")


def _feedback_names() -> str:
    """Return the conditions, with their parameters: `delayed[:delay_s=...]`."""
    return ", ".join(
        one.name
        + (
            f"[:{','.join(f'{p.name}=...' for p in one.parameters)}]"
            * bool(one.parameters)
        )
        for one in FEEDBACKS
    )


def run(options: argparse.Namespace, open_window: OpenWindow | None) -> int:
    """Play in the window, or without one."""
    if open_window is not None and not options.headless:
        return open_window(options)
    if options.more:
        raise UsageError(
            "without a window one clip is played; give {name} to a run of its own",
            name=options.more[0],
        )
    if options.headless:
        refuse_idle(options, "without a window", *_OF_THE_WINDOW)
    elif idle := [one for one in _OF_THE_WINDOW if one in options.given]:
        say_aside(f"there is no window here: {', '.join(idle)} has no effect")
    if not options.source:
        options.source = DEMO
    return play(options)


ROUNDING_N = 1e-3  # tracks are stored as float32


def play(options: argparse.Namespace) -> int:
    """Play in real time without a window, and print the summary."""
    source, feedback = with_feedback(opened(options), options.feedback)
    if feedback != FROM_FILE:
        refuse_idle(options, f"with --feedback {feedback}", "--force")
    if not options.outputs:
        refuse_idle(options, "without a device", "--scheduling")
    end_s = until_s(options, source)
    refuse_outputs(options)
    advise(source, feedback)
    clock = SystemClock()
    record = record_target(options, options.outputs)
    audio = None if options.mute else SoundProcess
    player = Player(clock, audio=audio, scheduling=wanted_scheduling(options))
    player.set_latencies(saved_latencies())
    if source.clip.has_audio:
        player.prepare_sound()  # in parallel with the device
    try:
        player.set_outputs(options.outputs, record)
        player.wait_ready()
        attach_log(player, options, about(source, feedback))
        player.open(source, feedback)
        if options.speed != 1.0:
            player.set_speed(options.speed)
        said = advise_of_video(source)
        _play_headless(
            player,
            clock,
            start_s=options.start,
            until_s=end_s,
        )
        problems, notes = problems_of(player.snapshot())
    finally:
        player.close()
    problems += faults_of(player.snapshot())  # at the end
    report = player.summary()
    say(json.dumps(report) if options.json else _summary_text(source, feedback, report))
    now = player.snapshot()
    for sentence in dict.fromkeys((*now.notices, *notes)):
        if sentence != said and not any(sentence in one for one in problems):
            say_aside(sentence)
    problems += [now.leading.record_problem, now.log_problem]
    found = [sentence for sentence in dict.fromkeys(problems) if sentence]
    for sentence in found:
        complain(sentence)
    return int(bool(found))


def problems_of(now: Snapshot) -> tuple[list[str], list[str]]:
    """What makes the status 1, and what is only said.

    Nothing was felt where the leading output played nothing, or all of them.
    """
    problems: list[str] = [now.problem, *faults_of(now)]
    notes = [one.note for one in now.outputs if one.note]
    if now.leading.note or (notes and len(notes) == len(now.outputs)):
        return problems + notes, []
    return problems, notes


def faults_of(now: Snapshot) -> list[str]:
    """What kept each output from playing, the others than the leading one by name."""
    return [
        what
        if one is now.leading
        else Message("{output}: {what}", output=one.name, what=what)
        for one in now.outputs
        if (what := one.problem or one.fault)
    ]


def opened(options: argparse.Namespace) -> Source:
    """Return the source that the command line names."""
    if address := _ADDRESS.match(str(options.source)):
        source = _opened_remotely(options, address[1].lower())
    else:
        refuse_idle(options, "on a file of this machine", "--allow-network")
        source = open_source(options.source, options.force)
    if source.check is None:
        refuse_idle(options, "on a video without force", "--accept-changed-video")
    elif options.accept_changed_video:
        source.check.accept()
    return source


def _opened_remotely(options: argparse.Namespace, scheme: str) -> Source:
    rows = extension.rows("sources", RemoteSource)
    found = next((row for row in rows if scheme in row.schemes), None)
    if found is None:
        raise UsageError(
            "no part of this installation plays addresses that begin with "
            f"{scheme}://; download the file and play it"
        )
    if not options.allow_network:
        raise UsageError(
            "nothing is fetched from a network without --allow-network; play a file, "
            "or give that option if you trust who offers this"
        )
    open_clip: Callable[[str, Clock], ClipBytes] = extension.load(found.home)
    clip = open_clip(options.source, SystemClock())
    try:
        return open_source(clip, options.force)
    except BaseException:
        clip.close()
        raise


def advise_of_video(source: Source) -> Message | None:
    """Wait until the video is known; say, and return, that it is another one."""
    check = source.check
    if check is None or check.glance() is not Verdict.ANOTHER:
        return None
    say_aside(f"{check.notice}; {ACCEPT_IT}")
    return check.notice


def advise(source: Source, feedback: str) -> None:
    """Say on stderr what a user of this source may not expect."""
    if source.notice:
        say_aside(source.notice)
    track = source.tracks[feedback]
    if notice := source.coverage_notice(feedback):
        say_aside(notice)
    cap_n = Limits().force_cap_n
    if track.peak_n() > cap_n + ROUNDING_N:
        say_aside(f"forces above {cap_n} N are capped")
    if source.clip.has_telemetry and source.motion is None and feedback == "none":
        say_aside("the clip holds motion: import it to feel it")


def wanted_scheduling(options: argparse.Namespace) -> Scheduling | None:
    """Return the scheduling class that was asked for."""
    return Scheduling(options.scheduling) if options.scheduling else None


def record_target(options: argparse.Namespace, outputs: Sequence[str]) -> Path | None:
    """Return the new file that is to hold every tick of the loop, if one is wanted."""
    if options.record is None:
        return None
    if not outputs:
        raise UsageError("--record needs a device, for its loop is what is recorded")
    target = Path(options.record)
    make_way(target, is_record if options.overwrite else None)
    return target


def until_s(options: argparse.Namespace, source: Source) -> float:
    """Return the media time at which to stop."""
    if options.start >= source.clip.duration_s:
        raise UsageError(
            f"--start {options.start:g} is after the end of {source.title} "
            f"({source.clip.duration_s:.1f} s)"
        )
    if options.duration is None:
        return source.clip.duration_s
    return float(options.start + options.duration)


def refuse_outputs(options: argparse.Namespace) -> None:
    """Refuse files that exist, before anything begins."""
    for name, is_ours in ((options.log, is_log), (options.record, is_record)):
        if name is not None:
            refuse_existing(Path(name), FILE, is_ours if options.overwrite else None)


def attach_log(
    player: Player, options: argparse.Namespace, about: Mapping[str, Any]
) -> None:
    """Let the player write a log, if one was asked for.

    Args:
        player: with its outputs.
        options: of `add_running`.
        about: what is played, for the header.
    """
    if options.log is None:
        return
    header = {
        "program": f"hapticplayer {__version__}",
        **about,
        "outputs": player.output_names,
        "scheduling": player.snapshot().leading.scheduling,
        "without": taken_away(),
        "time": "seconds of CLOCK_MONOTONIC",
    }
    path, overwrite = Path(options.log), options.overwrite
    player.attach_log(PlaybackLog(path, header, overwrite=overwrite))


def about(source: Source, feedback: str) -> dict[str, Any]:
    """What is played, for the header of a log."""
    return {
        "clip": source.clip.path.name,
        "title": source.title,
        "duration_s": source.clip.duration_s,
        "feedback": feedback,
    }


def _summary_text(source: Source, feedback: str, report: dict[str, Any]) -> str:
    frames = report["frames"]
    lines = [
        f"{source.title} - feedback {feedback}, device {report['device']}",
        f"  frames     {frames['shown']} shown, {frames['dropped']} dropped",
        f"  clock      {report['clock']}"
        + (
            f", {report['audio_underrun_s']} s of sound missing"
            if report["audio_underrun_s"]
            else ""
        ),
    ]
    lines += loop_text(report)
    for name, key in (("video", "video"), ("sound", "audio")):
        stats = report[f"haptic_minus_{key}_ms"]
        if stats:
            lines.append(
                f"  sync       force minus {name}: median {stats['p50']:+.2f} ms, "
                f"5 to 95 %: {stats['p05']:+.2f} to {stats['p95']:+.2f} ms"
            )
    lines += _channel_texts(report["channels"])
    for name, one in list(report["outputs"].items())[1:]:
        lines += [_output_text(name, one), *_channel_texts(one["channels"])]
    return "\n".join(lines)


def loop_text(report: dict[str, Any]) -> list[str]:
    """What the loop of the leading output did, in a line."""
    lateness = report["lateness_us"]
    if not lateness:
        return []
    line = f"  loop       {report['ticks']} ticks, {report['missed']} missed, lateness "
    line += f"p50 {lateness['p50']:.0f} us, p99 {lateness['p99']:.0f} us, "
    return [f"{line}p99.9 {lateness['p999']:.0f} us ({report['scheduling']})"]


def _channel_texts(channels: list[dict[str, Any]]) -> list[str]:
    return [f"  channel {one['channel']}  {peak_text(one)}" for one in channels]


def _output_text(name: str, report: dict[str, Any]) -> str:
    line = f"  output     {name}: {report['ticks']} ticks, {report['missed']} missed"
    if stats := report["haptic_minus_video_ms"]:
        line += f", minus video: median {stats['p50']:+.2f} ms, "
        line += f"5 to 95 %: {stats['p05']:+.2f} to {stats['p95']:+.2f} ms"
    return line


def _play_headless(
    player: Player, clock: Clock, *, start_s: float, until_s: float
) -> None:
    """Play from `start_s` to `until_s` of media time, or to the end of the clip.

    Raises:
        KeyboardInterrupt: from the user; the caller closes the player.
    """
    player.set_end(min(until_s, player.snapshot().end_s))
    if start_s > 0.0:
        player.seek(start_s)
    player.play()
    while player.snapshot().phase is not Phase.ENDED:
        clock.sleep_until(player.poll())
    # a little longer, so that the record shows the force at rest
    deadline_s = clock.now_s() + 0.1
    while clock.now_s() < deadline_s:
        clock.sleep_until(player.poll())
