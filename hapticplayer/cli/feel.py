"""The command `feel`: what a sensor measures now is felt now."""

import argparse
import json
import math
from typing import Any

from hapticplayer.capture.live.source import OpenedSource
from hapticplayer.cli.common import (
    add_number,
    add_outputs,
    complain,
    say,
    say_aside,
)
from hapticplayer.cli.mapping_options import add_mapping, chosen_mapping
from hapticplayer.cli.play import (
    add_running,
    attach_log,
    faults_of,
    loop_text,
    problems_of,
    record_target,
    refuse_outputs,
    wanted_scheduling,
)
from hapticplayer.cli.recording_options import chosen_mounting
from hapticplayer.cli.source_options import add_source, opened_source
from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import Message, UsageError
from hapticplayer.model import Mapping, ranges
from hapticplayer.playback.feel import Feel, FeelPhase
from hapticplayer.playback.player import Player

_AT_REST_S = 0.1  # so that log and record show the force at rest


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    add_source(command, is_required=True)
    add_mapping(command, is_live=True)
    add_outputs(command)
    add_number(
        command,
        "--duration",
        ranges.MEDIA_TIME_S,
        metavar="S",
        help="stop by itself (default: Ctrl+C stops)",
    )
    add_running(command)


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Feel it until Ctrl+C, the duration, a stop or the end of the source."""
    mapping, _ = chosen_mapping(options)
    if not options.outputs:
        raise UsageError("there is nothing to feel it with; name a --device")
    refuse_outputs(options)
    clock = SystemClock()
    source = opened_source(options, clock)
    try:
        return _felt(options, clock, source, mapping)
    finally:
        source.close()


def _felt(
    options: argparse.Namespace, clock: Clock, source: OpenedSource, mapping: Mapping
) -> int:
    player = Player(clock, audio=None, scheduling=wanted_scheduling(options))
    try:
        feel = Feel(player, source, mapping, clock, chosen_mounting(options))
        player.set_outputs(options.outputs, record_target(options, options.outputs))
        player.wait_ready()
        attach_log(player, options, {"source": options.imu})
        feel.start()
        try:
            _until_stopped(player, feel, clock, options.duration or math.inf)
        except KeyboardInterrupt as stop:
            feel.stop_force()
            if hasattr(stop, "number"):  # of a signal that is not a person's
                raise
        state = feel.snapshot()
        problems, notes = problems_of(player.snapshot())
        feel.stop()
        _poll_until(player, clock, clock.now_s() + _AT_REST_S)
    finally:
        player.close()
    report = {**player.summary(), **feel.summary()}
    say(json.dumps(report) if options.json else _summary_text(report))
    for note in notes:
        say_aside(note)
    problems += faults_of(player.snapshot())  # at the end
    if state.phase is FeelPhase.LOST:
        problems.append(state.text)
    elif not report["felt_s"]:
        problems.append(Message("nothing was felt: {why}", why=state.text))
    for sentence in filter(None, dict.fromkeys(problems)):
        complain(sentence)
    return int(any(problems))


def _until_stopped(player: Player, feel: Feel, clock: Clock, duration_s: float) -> None:
    end_s, said = clock.now_s() + duration_s, ""
    while clock.now_s() < end_s:
        clock.sleep_until(min(player.poll(), end_s))
        state = feel.snapshot()
        if state.text != said:
            say_aside(said := state.text)
        if state.phase is FeelPhase.LOST or player.snapshot().is_stopped:
            return


def _poll_until(player: Player, clock: Clock, end_s: float) -> None:
    while clock.now_s() < end_s:
        clock.sleep_until(player.poll())


def _summary_text(report: dict[str, Any]) -> str:
    line = f"  sensor     {report['samples']} samples, {report['skipped']} skipped, "
    line += f"felt for {report['felt_s']:.1f} s"
    head = f"{report['source']} - device {report['device']}"
    return "\n".join([head, line, *loop_text(report)])
