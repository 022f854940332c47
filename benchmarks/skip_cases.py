"""The cases of skips.py: the same work with a skip, and with the skip turned off."""
# ruff: noqa: SLF001 - a skip has no switch: it is turned off from inside

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest import mock

import av
import numpy as np
from common import HEIGHT, WIDTH
from plots import sequence
from PySide6.QtWidgets import QApplication

from app.player.application import make_application
from app.player.video_surface import VideoSurface
from app.plots.panel import PlotPanel
from app.widgets.room import is_seen
from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon import driver as falcon
from hapticplayer.devices.falcon.kinematics import Kinematics
from hapticplayer.devices.falcon.protocol import Reply, encode_command
from hapticplayer.devices.falcon.tracker import Tracker
from hapticplayer.haptics.shared import TICK
from hapticplayer.haptics.track import LoadedTrack, map_track, to_shared_memory
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.media.opening import open_media, read_only
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ForceTrack
from hapticplayer.playback.audio import AudioRing
from hapticplayer.playback.feeders import VideoFeeder
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.sound_process import SilentOut
from hapticplayer.playback.source import Source, open_source

PICTURES, TICKS, SEEKS = 60, 20_000, 20
PLOT_PX = (1280, 240)
SHAKEN_S = 4.0


@dataclass(frozen=True, slots=True)
class Case:
    """Something that can be done with a skip and without.

    Attributes:
        unit: what is counted.
        run: does the work with the skip (True) or without; returns how many units.
    """

    unit: str
    run: Callable[[bool], int]


@dataclass(frozen=True, slots=True)
class Stage:
    """One step on the way of a picture, a block of sound or a tick.

    Attributes:
        name: for people.
        unit: what is counted.
        run: does it; returns how many units.
    """

    name: str
    unit: str
    run: Callable[[], int]


def never(*_: object, **__: object) -> bool:
    """Turn a skip off."""
    return False


@contextmanager
def off(
    target: Any, name: str, is_skipping: bool, instead: Any = never
) -> Iterator[None]:
    """Replace what decides about a skip, unless it shall be made."""
    if is_skipping:
        yield
        return
    with mock.patch.object(target, name, instead):
        yield


def decoded(path: Path, count: int = PICTURES) -> list[DecodedFrame]:
    """Return the first frames of a clip as they were decoded."""
    with VideoDecoder(path) as decoder:
        return [f for f, _ in zip(decoder.frames(), range(count), strict=False)]


def shown_surface() -> VideoSurface:
    """Return a surface of the clip's size on the screen."""
    surface = VideoSurface()
    surface.setMinimumSize(WIDTH, HEIGHT)
    surface.set_clip_size(WIDTH, HEIGHT)
    show(surface)
    return surface


def show(widget: Any) -> None:
    """Put a widget on the screen and wait until it is there."""
    widget.show()
    while not is_seen(widget):
        QApplication.processEvents()


def all_cases(
    folder: Path, clip: Path, stack: ExitStack
) -> dict[str, Callable[[], Case]]:
    """Return what makes each case, by its name."""
    stack.callback(make_application().processEvents)
    moving, surface = decoded(clip), shown_surface()
    stack.callback(surface.close)
    return {
        "unseen window: conversion, painting": lambda: unseen_frames(moving, surface),
        "unseen plots: drawing": lambda: unseen_plots(
            open_source(sequence(folder, SHAKEN_S)), stack
        ),
        "streams that nobody shows: reading": lambda: other_streams(
            crowded_clip(folder, clip)
        ),
        "span without force, `none`: interpolation": interpolation,
        "zero force: torques and frame": torques,
        "grip at rest: pose": poses,
        "small seek: decoding again": lambda: small_seeks(clip),
    }


def unseen_frames(frames: list[DecodedFrame], surface: VideoSurface) -> Case:
    """Frames of a window that is hidden, minimised, or known to be covered."""

    def run(is_skipping: bool) -> int:
        if is_skipping:
            surface.hide()
        else:
            show(surface)
        for frame in frames:
            surface.present(frame)
        return len(frames)

    return Case("frame", run)


def unseen_plots(source: Source, stack: ExitStack) -> Case:
    """Plots and grip that are hidden, or in a window that is not seen."""
    panel = PlotPanel()
    panel.resize(*PLOT_PX)
    panel.set_source(source)
    stack.callback(panel.close)
    ticks = np.zeros(round(1e3 * SHAKEN_S), TICK)
    ticks["monotonic_s"] = ticks["media_s"] = 1e-3 * np.arange(len(ticks))
    ticks["force_n"] = np.sin(ticks["media_s"])[:, None]
    history = TickHistory()
    history.add(ticks, 0)

    def run(is_skipping: bool) -> int:
        if is_skipping:
            panel.hide()
        else:
            show(panel)
        for number in range(PICTURES):
            if is_seen(panel):
                now = Snapshot(media_s=number / 30.0, feedback="realistic")
                panel.follow(now, history.since)
            QApplication.processEvents()
        return PICTURES

    return Case("drawing", run)


def other_streams(path: Path) -> Case:
    """Other languages and pictures in the same file."""

    def run(is_skipping: bool) -> int:
        with open_media(path) as container:
            video = container.streams.video[0]
            if is_skipping:
                read_only(container, video)
            wanted = [p for p in container.demux() if p.stream is video]
        return len(wanted)

    return Case("packet", run)


def interpolation() -> Case:
    """A track with force in none of its spans, as for the feedback `none`."""
    time_s = np.arange(0.0, 60.0, 0.005)
    track = ForceTrack(time_s, np.zeros((len(time_s), 3)))
    empty, whole = loaded(track), loaded(track)
    whole._span_edges_s = [-1.0]  # type: ignore[assignment]

    def run(is_skipping: bool) -> int:
        track = empty if is_skipping else whole
        for number in range(TICKS):
            track.force_at(1e-3 * number)
        return TICKS

    return Case("tick", run)


def loaded(track: ForceTrack) -> LoadedTrack:
    """Return a track as the loop has it."""
    descriptor = to_shared_memory(track)
    try:
        return map_track(descriptor)
    finally:
        os.close(descriptor)


def torques() -> Case:
    """The Falcon's frame for zero is made once."""
    kinematics = Kinematics()
    counts = (40, -25, 10)
    jacobian = kinematics.pose(kinematics.angles(counts)).jacobian
    rest, zero = encode_command((0, 0, 0)), (0.0, 0.0, 0.0)

    def run(is_skipping: bool) -> int:
        for _ in range(TICKS):
            if is_skipping:
                _ = rest
            else:
                i, j, k = falcon.motor_words(jacobian, zero)
                encode_command((round(i), round(j), round(k)))
        return TICKS

    return Case("tick", run)


def poses() -> Case:
    """A grip at rest has the counts of the answer before."""
    tracker = Tracker(Kinematics())
    reply = Reply((40, -25, 10), 0, 7)

    def run(is_skipping: bool) -> int:
        for number in range(TICKS):
            if not is_skipping and tracker._counts is not None:
                tracker._counts = (40, -25, 11)  # as if it had moved
            tracker.take(reply, 1e-3 * number)
        return TICKS

    return Case("tick", run)


class Newest:
    """Counts pictures (FrameSink)."""

    def __init__(self) -> None:
        self.count = 0

    def show(self, _picture: object) -> None:
        """Count it."""
        self.count += 1


def small_seeks(clip: Path) -> Case:
    """Two pictures on, paused, ten times after each long seek, with sound."""
    source = open_source(clip)

    def run(is_skipping: bool) -> int:
        with (
            off(VideoFeeder, "_keep_from", is_skipping),
            off(AudioRing, "resume_from", is_skipping),
        ):
            return play_and_seek(source)

    return Case("seek", run)


def play_and_seek(source: Source) -> int:
    """Seek in a paused player, and wait for each picture."""
    clock, seen = SystemClock(), Newest()
    player = Player(clock, seen, audio=SilentOut)
    player.open(source)
    at_s = 0.5
    try:
        for number in range(SEEKS):
            at_s += 2.9 if number % 10 == 0 else 2.0 / 30.0
            count = seen.count
            player.seek(at_s)
            until_s = clock.now_s() + 5.0
            while seen.count == count and clock.now_s() < until_s:
                player.poll()
                clock.sleep_until(clock.now_s() + 0.003)
            clock.sleep_until(clock.now_s() + 0.05)  # the queue fills
    finally:
        player.close()
    return SEEKS


def crowded_clip(folder: Path, clip: Path) -> Path:
    """Copy a clip with its sound four times and its pictures twice (MP4)."""
    path = folder / "crowded.mp4"
    with av.open(str(clip)) as source, av.open(str(path), "w") as target:
        video, sound = source.streams.video[0], source.streams.audio[0]
        copies = {
            s.index: [target.add_stream_from_template(s) for _ in range(count)]
            for s, count in ((video, 2), (sound, 4))
        }
        for packet in source.demux(video, sound):
            if packet.dts is None:
                continue
            data, times = bytes(packet), (packet.pts, packet.dts, packet.duration)
            for stream in copies[packet.stream.index]:
                copy = av.Packet(data)
                copy.pts, copy.dts, copy.duration = times
                copy.time_base, copy.stream = packet.time_base, stream
                copy.is_keyframe = packet.is_keyframe
                target.mux(copy)
    return path
