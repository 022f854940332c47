"""Moments at which three simulated outputs act, against each other and the frames.

A clip with sound plays without a window on a simulated Falcon and on two simulated rigs
(OutSim and BeamNG, `--rate` packets a second), all led by the sound. Every 13 frames force
and acceleration step up; an output acts when its other side has the step: the Falcon's
record of commands, the kernel's time of the first packet that has more than half of it.
Spread: the last of the three minus the first, for each step. Packets lie on multiples of
their period, so a step waits up to a period and is, by their lead, as often early as late.
"""

import argparse
import contextlib
import os
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report
from benchmarks.stage import RATE_HZ, need, sound_server
from hapticplayer.clock import SystemClock
from hapticplayer.extras.rigs.decode import DecodedPacket
from hapticplayer.extras.rigs.receiver import PacketReceiver
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.linux import hasten_window
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from tests.material.plant_record import read_record
from tools.witness import machine_witness

Floats = NDArray[np.float64]
STEP_FRAMES, HELD_S, EDGE_S, STEP = 13, 0.15, 1e-3, 1.0
FIRST_S = 3.0  # the fade of 0.5 s is over, and the clock has settled
NEAR_S = 0.1
MOST_MS = 5.0
FALCON = "Falcon"


class Shown:
    """Notes when frames are shown."""

    def __init__(self, clock: SystemClock) -> None:
        self._clock = clock
        self.frames: dict[int, float] = {}

    def show(self, frame: Any) -> None:
        self.frames[round(frame.pts_s * RATE_HZ)] = self._clock.now_s()


def small_clip(folder: Path, seconds: float) -> Path:
    """Write a clip of small frames with sound: what is measured is no decoder."""
    path = folder / "small.mp4"
    grey = (
        np.full((90, 160, 3), 20 + k % 200, np.uint8)
        for k in range(round(seconds * RATE_HZ))
    )
    sound = np.full((round(seconds * 48_000), 2), 0.05, np.float32)
    write_clip(path, grey, frame_rate_hz=RATE_HZ, audio=sound)
    return path


def stepping(clip: Path) -> tuple[Source, NDArray[np.int64]]:
    """Return a source that steps, and the frames at which it does."""
    source = open_source(clip)
    end_s = source.clip.duration_s
    frames = np.arange(0, round((end_s - HELD_S) * RATE_HZ), STEP_FRAMES)
    frames = frames[frames > FIRST_S * RATE_HZ]
    up_s = frames / RATE_HZ
    # half of the step is reached at the time of its frame
    edges = np.array([-0.5 * EDGE_S, 0.5 * EDGE_S, HELD_S, HELD_S + EDGE_S])
    time_s = np.concatenate([[0.0], (up_s[:, None] + edges).ravel(), [end_s + 1.0]])
    size = np.concatenate([[0.0], np.tile([0.0, STEP, STEP, 0.0], len(up_s)), [0.0]])
    up = np.zeros((len(time_s), 3))
    up[:, 2] = size
    motion = MotionTrack(
        time_s,
        up,
        np.zeros_like(up),
        1.0,
        np.tile([1.0, 0.0, 0.0, 0.0], (len(up), 1)),
        None,
        np.ones(len(up), bool),
    )
    force = ForceTrack(time_s, up[:, [0, 2, 1]].astype(np.float32))
    tracks = {"realistic": force}
    return replace(source, tracks=tracks, motion=motion, feedback="realistic"), frames


def rises(time_s: Floats, values: Floats) -> Floats:
    """Return when values went above half of the step."""
    is_up = values > 0.5 * STEP
    return time_s[1:][is_up[1:] & ~is_up[:-1]]


def play(source: Source, rate: int) -> tuple[dict[str, Floats], Shown, dict[str, Any]]:
    """Play; return when each output acted, the frames, and the player's summary."""
    clock, record = SystemClock(), os.memfd_create("outputs")
    receiver = PacketReceiver(clock, [0, 0])
    heard: list[tuple[int, float, DecodedPacket]] = []
    device: dict[str, Any] = {
        "device_options": ["--hand", "firm", "--record", str(record)],
        "device_descriptors": [record],
    }

    def haptics(clock: Any, name: str, **options: Any) -> HapticsProcesses:
        more = device if name == "simulated" else {}
        return HapticsProcesses(clock, name, **options, **more)

    shown = Shown(clock)
    player = Player(clock, shown, haptics=haptics)
    try:
        kinds = zip(("outsim", "beamng"), receiver.rigs, strict=True)
        names = [f"rig:{kind},127.0.0.1:{port},rate={rate}" for kind, port in kinds]
        player.set_outputs(["simulated", *names])
        player.prepare_sound()
        player.wait_ready()
        player.open(source)
        player.play()
        while player.snapshot().phase is not Phase.ENDED:
            clock.sleep_until(player.poll())
            heard += receiver.listen(0.0)
    finally:
        player.close()
    turns = read_record(record)
    acted = {FALCON: rises(turns["monotonic_s"], turns["commanded_n"][:, 1])}
    for port in receiver.rigs:
        rows = [(at_s, one.acceleration_mps2[2]) for p, at_s, one in heard if p == port]
        kind = next(one.format for p, _, one in heard if p == port)
        acted[kind] = rises(*np.array(rows).T)
    receiver.close()
    os.close(record)
    return acted, shown, player.summary()


def moments(
    acted: dict[str, Floats], shown: Shown, frames: NDArray[np.int64]
) -> Iterator[tuple[float, dict[str, float]]]:
    """Yield when a frame with a step was shown, and when each output acted, s."""
    for number in frames.tolist():
        if number not in shown.frames:
            continue
        shown_s = shown.frames[number]
        nearest = {
            name: float(times[np.abs(times - shown_s).argmin()])
            for name, times in acted.items()
        }
        if all(abs(at_s - shown_s) < NEAR_S for at_s in nearest.values()):
            yield shown_s, nearest


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rate", type=int, default=200, help="packets a second")
    parser.add_argument("--rounds", type=int, default=4)
    parser.add_argument("--seconds", type=float, default=30.0)


def run(options: argparse.Namespace, report: Report) -> None:
    """Play the rounds and judge all their steps."""
    need("pulseaudio", "pactl")
    hasten_window()  # as the window does for the thread that shows the frames
    rounds, seconds = (1, 12.0) if options.quick else (options.rounds, options.seconds)
    found: list[tuple[float, dict[str, float]]] = []
    summary: dict[str, Any] = {}
    missed = steps = 0
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        clip = small_clip(folder, seconds)
        os.environ.update(stack.enter_context(sound_server()).environment)
        witness = stack.enter_context(machine_witness())
        for _ in range(rounds):
            source, frames = stepping(clip)
            acted, shown, summary = play(source, options.rate)
            these = list(moments(acted, shown, frames))
            steps, missed = steps + len(frames), missed + len(frames) - len(these)
            found += these
        report.figures["machine_stalls"] = witness.seen().summary()
    shown_s = np.array([at_s for at_s, _ in found])
    at_s = {name: np.array([one[name] for _, one in found]) for name in found[0][1]}
    together = np.array(list(at_s.values()))
    spread_ms = 1e3 * (together.max(axis=0) - together.min(axis=0))
    rows = [["spread of the three", *_figures(spread_ms)]]
    report.target("spread, ms, 95 %", _p95(spread_ms), ("<=", MOST_MS))
    for name, times in at_s.items():
        late_ms = 1e3 * (times - shown_s)
        rows.append([f"{name} - frame", *_figures(late_ms)])
        report.target(f"{name} - frame, ms, 95 %", _p95(late_ms), ("<=", MOST_MS))
    report.target(
        "steps that an output or the screen missed", missed, ("<=", 0.02 * steps)
    )
    report.table("Outputs, ms", ["what", "n", "5 %", "50 %", "95 %", "|95 %|"], rows)
    report.figures |= {"rows": rows, "steps": steps, "clock": summary["clock"]}
    report.figures |= {"scheduling": summary["scheduling"], "rate_hz": options.rate}
    print(f"clock {summary['clock']}, scheduling {summary['scheduling']}")


def _figures(values_ms: Floats) -> list[float]:
    quantiles = np.percentile(values_ms, [5.0, 50.0, 95.0]).tolist()
    return [len(values_ms), *quantiles, _p95(values_ms)]


def _p95(values_ms: Floats) -> float:
    return float(np.percentile(np.abs(values_ms), 95.0))
