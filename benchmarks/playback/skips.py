"""What each skip saves: the same work with it and without, alternating.

CPU time of this process (all its threads) for each frame, tick, packet or seek. The
muted run is a process tree of its own, sound process included. Tests hold what remains
equal (`tests/**/test_skips.py`, `tests/app/test_unseen.py`).
"""
# ruff: noqa: SLF001 - a skip has no switch: it is turned off from inside

import argparse
import os
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import av
import numpy as np
from PySide6.QtWidgets import QApplication

from app.player.application import make_application
from app.player.video_surface import VideoSurface
from app.plots.panel import PlotPanel
from app.widgets.layout import is_seen
from benchmarks.common import Report, interleaved, medians, ratio
from benchmarks.playback.plots_and_seeks import PausedPlayer, shaken_sequence
from benchmarks.stage import (
    HEIGHT,
    WIDTH,
    player_command,
    run_measured,
    scrolling_clip,
    sound_server,
)
from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.driver import Tracker
from hapticplayer.devices.falcon.kinematics import Kinematics, motor_words
from hapticplayer.devices.falcon.protocol import Reply, encode_command
from hapticplayer.haptics.shared import TICK
from hapticplayer.haptics.track import map_track, to_shared_memory
from hapticplayer.media.opening import open_media, read_only
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ForceTrack
from hapticplayer.playback.feeders import VideoFeeder
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.sound_ring import AudioRing
from hapticplayer.playback.source import open_source
from tests.material.sound_output import SilentOutput

CLIP_S, RUN_S, SHAKEN_S = 8.0, 5.0, 4.0
FRAMES, TICKS, SEEKS = 60, 20_000, 20
PLOT_PX = (1280, 240)


class Case(NamedTuple):
    """Work that is done with a skip (True) or without; returns how many units."""

    unit: str
    run: Callable[[bool], int]


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(5)")
    parser.add_argument("--only", nargs="*", default=[], help="parts of names")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure every case."""
    rounds = options.rounds or (2 if options.quick else 5)
    rows = []
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="hp-")))
        os.environ["XDG_CONFIG_HOME"] = str(folder)
        clip = scrolling_clip(folder, CLIP_S, "1280x720", 30)
        stack.callback(make_application().processEvents)
        for make in CASES:
            name = (make.__doc__ or "").rstrip(".")
            if options.only and not any(part in name for part in options.only):
                continue
            case = make(folder, clip, stack)
            contenders = {w: _timed(case, w == "with") for w in ("with", "without")}
            rows.append(
                _row(name, case.unit, interleaved(contenders, rounds, warm_up=True))
            )
        if not options.only and not options.quick:
            unit, name = "second", "`--headless --mute`: sound decoding, sound process"
            rows.append(_row(name, unit, muted_runs(clip, max(2, rounds // 2))))
    header = ["skipped", "per", "with, us", "without", "ratio", "least", "largest"]
    report.table("Skips", header, rows)
    report.figures |= {"rounds": rounds, "columns": header, "rows": rows}


def _timed(case: Case, with_skip: bool) -> Callable[[], dict[str, float]]:
    def us_each() -> dict[str, float]:
        begin_s = time.process_time()
        count = case.run(with_skip)
        return {"us": 1e6 * (time.process_time() - begin_s) / count}

    return us_each


def _row(name: str, unit: str, found: dict[str, list[dict[str, float]]]) -> list[Any]:
    us = {kind: [one["us"] for one in each] for kind, each in found.items()}
    middle = [medians(found[kind])["us"] for kind in ("with", "without")]
    return [name, unit, *middle, *ratio(us["with"], us["without"])]


def muted_runs(clip: Path, rounds: int) -> dict[str, list[dict[str, float]]]:
    """Play without a window, with sound and without; CPU time per second played."""
    command = player_command("play", str(clip), "--headless", "--device", "none")
    command += ["--duration", str(RUN_S), "--json"]
    with sound_server() as server:

        def play(*more: str) -> dict[str, float]:
            arguments = [*command, *more]
            _, cpu_s, _ = run_measured(arguments, server.environment, 60.0)
            return {"us": 1e6 * cpu_s / RUN_S}

        contenders = {"with": lambda: play("--mute"), "without": play}
        return interleaved(contenders, rounds)


@contextmanager
def off(target: Any, name: str, with_skip: bool) -> Iterator[None]:
    """Replace what decides about a skip, unless it shall be made."""
    if with_skip:
        yield
        return
    with mock.patch.object(target, name, return_value=False):
        yield


def show(widget: Any) -> None:
    """Put a widget on the screen and wait until it is there."""
    widget.show()
    QApplication.processEvents()
    while not is_seen(widget):
        QApplication.processEvents()


def unseen_frames(_folder: Path, clip: Path, stack: ExitStack) -> Case:
    """Unseen window: conversion and painting of frames."""
    with VideoDecoder(clip) as decoder:
        frames = [f for f, _ in zip(decoder.frames(), range(FRAMES), strict=False)]
    surface = VideoSurface()
    surface.setMinimumSize(WIDTH, HEIGHT)
    surface.set_clip_size(WIDTH, HEIGHT)
    stack.callback(surface.close)

    def work(with_skip: bool) -> int:
        if with_skip:
            surface.hide()
        else:
            show(surface)
        for frame in frames:
            surface.present(frame)
        return len(frames)

    return Case("frame", work)


def unseen_plots(folder: Path, _clip: Path, stack: ExitStack) -> Case:
    """Unseen window, or hidden: drawing of plots and grip."""
    panel = PlotPanel()
    panel.resize(*PLOT_PX)
    panel.set_source(open_source(shaken_sequence(folder, SHAKEN_S)))
    stack.callback(panel.close)
    ticks = np.zeros(round(1e3 * SHAKEN_S), TICK)
    ticks["monotonic_s"] = ticks["media_s"] = 1e-3 * np.arange(len(ticks))
    ticks["force_n"] = np.sin(ticks["media_s"])[:, None]
    history = TickHistory()
    history.add(ticks, 0)

    def work(with_skip: bool) -> int:
        if with_skip:
            panel.hide()
        else:
            show(panel)
        for number in range(FRAMES):
            if is_seen(panel):
                now = Snapshot(media_s=number / 30.0, feedback="realistic")
                panel.follow(now, history.since)
            QApplication.processEvents()
        return FRAMES

    return Case("drawing", work)


def other_streams(folder: Path, clip: Path, _stack: ExitStack) -> Case:
    """Streams that are not shown (1 video, 3 sounds): reading."""
    path = folder / "crowded.mp4"
    with av.open(str(clip)) as source, av.open(str(path), "w") as target:
        video, sound = source.streams.video[0], source.streams.audio[0]
        copies = {
            s.index: [target.add_stream_from_template(s) for _ in range(count)]
            for s, count in ((video, 2), (sound, 4))
        }
        for packet in source.demux(video, sound):
            for stream in copies[packet.stream.index] if packet.dts is not None else ():
                copy = av.Packet(bytes(packet))
                copy.pts, copy.dts = packet.pts, packet.dts
                copy.duration, copy.time_base = packet.duration, packet.time_base
                copy.stream, copy.is_keyframe = stream, packet.is_keyframe
                target.mux(copy)

    def work(with_skip: bool) -> int:
        with open_media(path) as container:
            wanted = container.streams.video[0]
            if with_skip:
                read_only(container, wanted)
            return sum(1 for p in container.demux() if p.stream is wanted)

    return Case("packet", work)


def interpolation(_folder: Path, _clip: Path, _stack: ExitStack) -> Case:
    """Span without force, or the feedback `none`: interpolation."""
    time_s = np.arange(0.0, 60.0, 0.005)
    descriptor = to_shared_memory(ForceTrack(time_s, np.zeros((len(time_s), 3))))
    empty, whole = map_track(descriptor), map_track(descriptor)
    os.close(descriptor)
    whole._span_edges_s = [-1.0]  # type: ignore[assignment]

    def work(with_skip: bool) -> int:
        track = empty if with_skip else whole
        for number in range(TICKS):
            track.force_at(1e-3 * number)
        return TICKS

    return Case("tick", work)


def torques(_folder: Path, _clip: Path, _stack: ExitStack) -> Case:
    """Zero force of the Falcon: torques and frame."""
    kinematics, zero = Kinematics(), (0.0, 0.0, 0.0)
    jacobian = kinematics.pose(kinematics.angles((40, -25, 10))).jacobian
    rest = encode_command((0, 0, 0))

    def work(with_skip: bool) -> int:
        for _ in range(TICKS):
            if with_skip:
                _ = rest
            else:
                i, j, k = motor_words(jacobian, zero)
                encode_command((round(i), round(j), round(k)))
        return TICKS

    return Case("tick", work)


def poses(_folder: Path, _clip: Path, _stack: ExitStack) -> Case:
    """Grip of the Falcon at rest: Newton's method."""
    tracker = Tracker(Kinematics())
    replies = Reply((40, -25, 10), 0, 7), Reply((40, -25, 11), 0, 7)

    def work(with_skip: bool) -> int:
        for number in range(TICKS):
            reply = replies[0 if with_skip else number & 1]
            tracker.take(reply, 1e-3 * number)
        return TICKS

    return Case("tick", work)


def small_seeks(_folder: Path, clip: Path, _stack: ExitStack) -> Case:
    """Seek within what is decoded (18 of 20): decoding again."""
    source, clock = open_source(clip), SystemClock()

    def silent(ring: AudioRing) -> SilentOutput:
        return SilentOutput(ring, clock)

    def work(with_skip: bool) -> int:
        with (
            off(VideoFeeder, "_keep_from", with_skip),
            off(AudioRing, "resume_from", with_skip),
        ):
            paused, at_s = PausedPlayer(source, silent), 0.5
            for number in range(SEEKS):
                at_s += 2.9 if number % 10 == 0 else 2.0 / 30.0
                paused.seek(at_s)
                time.sleep(0.05)  # the queue fills
            paused.player.close()
        return SEEKS

    return Case("seek", work)


CASES = (
    *(unseen_frames, unseen_plots, other_streams, interpolation, torques, poses),
    small_seeks,
)
