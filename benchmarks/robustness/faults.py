"""From a real fault to no force on the motors, beside the limit of each fault.

The window (offscreen) plays a rotating force of 4 N into the simulated Falcon, which is
a process of its own and records when the force on its motors changed. Faults come at
random moments. A sleeper of the highest priority on each core tells what the machine
itself lost between fault and zero: that is subtracted for the verdict, and shown. After
each stop that leaves the player alive the force is re-armed and must belong to the right
moment of the clip again.
"""

import argparse
import contextlib
import json
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report
from hapticplayer.haptics.contract import Cause
from hapticplayer.haptics.shared import SharedBlock
from hapticplayer.media.encode import write_clip
from hapticplayer.simulation.falcon.remote import Controls
from tests.material.plant_record import read_record
from tools.witness import Witness, machine_witness

FORCE_N, READY_FORCE_N, TURN_RADPS, CLIP_S = 4.0, 3.9, 2.0, 600
ROW_S = 0.01
READY_TIMEOUT_S = 60.0
# 4 N for longer is more than the motors may bear: the limiter comes down to 3 N
FAULTS_PER_PLAYER = 4
BACK_IN_SYNC_S = 0.002
BACK_WITHIN_S, CLEAR_N = 5.0, 1.0


class Victim:
    """A player process, its device's record, and the ticks of its haptic loop."""

    def __init__(self, clip: Path, force: Path) -> None:
        self.record = os.memfd_create("record")
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.controls = Controls(ours.detach())
        descriptors = (self.record, theirs.fileno())
        command = [sys.executable, "-m", "benchmarks.robustness.faults", str(clip)]
        self.process = subprocess.Popen(
            [*command, str(force), *map(str, descriptors)],
            pass_fds=descriptors,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=None if os.environ.get("SHOW") else subprocess.DEVNULL,
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
            cwd=ROOT,
            bufsize=0,
        )
        theirs.close()
        self.loop = int(self.hear("ready")["loop"])
        arguments = Path(f"/proc/{self.loop}/cmdline").read_text().split("\0")
        number = arguments[arguments.index("--block") + 1]
        with Path(f"/proc/{self.loop}/fd/{number}").open("r+b") as file:
            self.block = SharedBlock(file.fileno())

    def hear(self, key: str) -> dict[str, Any]:
        """Wait for an answer that has this key."""
        assert self.process.stdout is not None
        while select.select([self.process.stdout], [], [], READY_TIMEOUT_S)[0]:
            line = self.process.stdout.readline()
            if not line:
                break
            answer = json.loads(line)
            if key in answer:
                return dict(answer)
        sys.exit("the player under test did not start")

    def ask(self, word: str) -> float:
        """Let it do something; return when it did."""
        assert self.process.stdin is not None
        self.process.stdin.write(f"{word}\n".encode())
        return float(self.hear("word")["at_s"])

    def close(self) -> None:
        """End it, whatever state it is in."""
        self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout):
            if pipe is not None:
                pipe.close()
        self.controls.close()
        os.close(self.record)


@dataclass(frozen=True)
class Fault:
    """One way to end the force.

    Attributes:
        limit_s: after which there must be none.
        inject: does it and returns the monotonic time at which it was done.
        kills: whether the player does not survive it.
        settle_s: time until all reactions are over.
        usual_s: that the 99th percentile stays below.
    """

    limit_s: float
    inject: Callable[[Victim], float]
    kills: bool = False
    settle_s: float = 0.2
    usual_s: float = 0.010


def _signal(number: int, *, to_loop: bool = False) -> Callable[[Victim], float]:
    def inject(victim: Victim) -> float:
        at_s = time.monotonic()
        os.kill(victim.loop if to_loop else victim.process.pid, number)
        return at_s

    return inject


def _freeze(seconds: float, *, loop: bool) -> Callable[[Victim], float]:
    def inject(victim: Victim) -> float:
        at_s = _signal(signal.SIGSTOP, to_loop=loop)(victim)
        time.sleep(seconds)
        _signal(signal.SIGCONT, to_loop=loop)(victim)
        return at_s

    return inject


def _press(victim: Victim) -> float:
    at_s = time.monotonic()
    victim.controls.press(1)
    time.sleep(0.1)
    victim.controls.press(0)
    return at_s


FAULTS: dict[str, Fault] = {
    "player SIGKILL": Fault(0.025, _signal(signal.SIGKILL), kills=True),
    "player SIGSEGV": Fault(0.025, _signal(signal.SIGSEGV), kills=True),
    "GUI frozen (SIGSTOP)": Fault(
        0.200, _freeze(1.5, loop=False), settle_s=0.1, usual_s=0.200
    ),
    "loop SIGKILL": Fault(
        0.010, _signal(signal.SIGKILL, to_loop=True), kills=True, usual_s=0.003
    ),
    # a fresh player each time: what it missed would hold the force to 3 N for 10 s
    "loop frozen (SIGSTOP)": Fault(
        0.025, _freeze(0.2, loop=True), kills=True, usual_s=0.025
    ),
    "Esc": Fault(0.025, lambda p: p.ask("esc")),
    "stop button": Fault(0.025, lambda p: p.ask("stop")),
    "grip button": Fault(0.025, _press),
    "Ctrl-C": Fault(0.025, _signal(signal.SIGINT), kills=True),
    "closing the window": Fault(0.025, lambda p: p.ask("close"), kills=True),
}


def zero_after_s(victim: Victim, at_s: float) -> float:
    """Return how long after the fault the motors were without force for good, s."""
    record = read_record(victim.record)
    record = record[record["monotonic_s"] > at_s - 0.1]
    has_force = record["applied_n"].any(axis=1)
    if not (has_force & (record["monotonic_s"] <= at_s)).any():
        raise RuntimeError("there was no force to be ended")
    last = np.flatnonzero(has_force & (record["monotonic_s"] < at_s + 1.0))[-1]
    if last + 1 >= len(record):
        return float("inf")
    return float(max(0.0, record["applied_since_s"][last + 1] - at_s))


def tripped_after_s(victim: Victim, at_s: float, cause: Cause) -> float:
    """Return when the loop tripped for this cause, s after the fault."""
    ticks, _, _ = victim.block.read_ticks(0)
    found = ticks[(ticks["monotonic_s"] > at_s) & (ticks["cause"] == cause)]
    return float(found["monotonic_s"][0] - at_s) if len(found) else float("inf")


def out_of_sync_s(victim: Victim) -> float:
    """Re-arm, and return by how much force and clip differ once it is back, s.

    The direction of the force tells which moment of the clip it belongs to; the
    published clock tells which it is. A force that has gone again, because the
    decoder did not keep up on a busy machine, has no direction.
    """
    victim.ask("rearm")
    victim.hear("ready")
    deadline_s = time.monotonic() + BACK_WITHIN_S
    while True:
        time.sleep(0.4)
        ticks = victim.block.read_ticks(0)[0][-100:]
        sample = victim.block.read_clock()
        content_n = (ticks["force_n"] - ticks["centring_n"])[:, :2]
        if sample is not None and np.linalg.norm(content_n, axis=1).min() > CLEAR_N:
            break
        if time.monotonic() > deadline_s:
            return float("inf")
    clock, _ = sample
    media_s = clock.media0_s + clock.rate * (ticks["monotonic_s"] - clock.monotonic0_s)
    expected = TURN_RADPS * ROW_S * np.floor(media_s / ROW_S)  # rows are held
    x, y = content_n.T
    wrong = np.angle(np.exp(1j * (np.arctan2(y, x) - expected)))
    return float(np.abs(wrong).max() / TURN_RADPS)


@contextlib.contextmanager
def material() -> Iterator[tuple[Path, Path]]:
    """Make a clip and a force that turns."""
    with tempfile.TemporaryDirectory() as folder:
        clip, force = Path(folder) / "clip.mp4", Path(folder) / "force.csv"
        frames = (np.full((90, 160, 3), k % 200, np.uint8) for k in range(5 * CLIP_S))
        write_clip(clip, frames, frame_rate_hz=5)
        t = np.arange(0, CLIP_S, ROW_S)
        angle = TURN_RADPS * t
        rows = [t, FORCE_N * np.cos(angle), FORCE_N * np.sin(angle), 0 * t]
        header = "time_s,fx_n,fy_n,fz_n"
        rows = np.stack(rows, axis=1)
        np.savetxt(force, rows, "%.5f", delimiter=",", header=header, comments="")
        yield clip, force


def repeat(
    name: str, count: int, files: tuple[Path, Path], witness: Witness
) -> Iterator[dict[str, float]]:
    """Yield the result of each repetition of a fault."""
    fault, victim = FAULTS[name], None
    moments = np.random.default_rng(len(name))
    try:
        for number in range(1, count + 1):
            victim = victim or Victim(*files)
            time.sleep(moments.uniform(0.05, 0.35))
            at_s = fault.inject(victim)
            time.sleep(fault.settle_s)
            zero_s = zero_after_s(victim, at_s)
            stalled_s = witness.seen().stalled_s(at_s, at_s + min(zero_s, 2.0))
            result = {"zero_s": zero_s, "stalled_s": stalled_s}
            if name.startswith("GUI"):
                result["trip_s"] = tripped_after_s(victim, at_s, Cause.HEARTBEAT_LOST)
            if not fault.kills:
                result["out_of_sync_s"] = out_of_sync_s(victim)
            if fault.kills or number % FAULTS_PER_PLAYER == 0:
                victim.close()
                victim = None
            yield result
    finally:
        if victim is not None:
            victim.close()


def judged(name: str, found: list[dict[str, float]], report: Report) -> list[Any]:
    """Note the targets of a fault and return its row."""
    limit_ms = 1e3 * FAULTS[name].limit_s
    zero_ms = 1e3 * np.array([r["zero_s"] for r in found])
    stalled_ms = 1e3 * np.array([r["stalled_s"] for r in found])
    p50, p99 = np.percentile(zero_ms, [50, 99]).tolist()
    unexplained = int(np.sum(zero_ms - stalled_ms > limit_ms))
    report.target(f"{name}: p99, ms", p99, ("<=", 1e3 * FAULTS[name].usual_s))
    report.target(f"{name}: later, not by the machine", unexplained, ("<=", 0))
    sync_ms = [1e3 * r["out_of_sync_s"] for r in found if "out_of_sync_s" in r]
    if sync_ms:
        limit = ("<=", 1e3 * BACK_IN_SYNC_S)
        report.target(f"{name}: sync after re-arming, ms", max(sync_ms), limit)
    trips_s = [r["trip_s"] for r in found if "trip_s" in r]
    over = int(np.sum(zero_ms > limit_ms))
    row = [name, len(found), limit_ms, p50, p99, float(zero_ms.max()), over]
    row += [unexplained, max(sync_ms, default="-")]
    return [*row, f"{min(trips_s):.3f}..{max(trips_s):.3f}" if trips_s else "-"]


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--repetitions", type=int, help="of each fault (20)")
    parser.add_argument("--only", nargs="+", choices=FAULTS, default=list(FAULTS))


def run(options: argparse.Namespace, report: Report) -> None:
    """Repeat every fault."""
    count = options.repetitions or (2 if options.quick else 20)
    rows = []
    with material() as files, machine_witness() as witness:
        for name in options.only:
            rows.append(judged(name, list(repeat(name, count, files, witness)), report))
            print(f"{name}: {count} done", file=sys.stderr)
    header = ["fault", "n", "limit ms", "p50", "p99", "max", "over", "unexplained"]
    header += ["sync ms", "trip s"]
    report.table("From a fault to no force, ms", header, rows)
    report.figures |= {"columns": header, "rows": rows}


# --- the player under test ---------------------------------------------------------


class _Commanded:
    """A window that does what standard input says, and says when."""

    def __init__(self, clip: Path, force: Path, record: str, control: str) -> None:
        from PySide6.QtCore import QSocketNotifier, QTimer

        from benchmarks.window import open_window, say, with_device_options
        from hapticplayer.playback.source import open_source

        device = ["--hand", "firm", "--record", record, "--control", control]
        descriptors = [int(record), int(control)]
        haptics = with_device_options(*device, descriptors=descriptors)
        self.opened = open_window(clip.parent / "settings.json", haptics=haptics)
        self._say = say
        self.window, self.player = self.opened.window, self.opened.player
        self.window.session.show_source(open_source(clip, force))
        self.player.play()
        self._timer = QTimer(interval=10)
        self._timer.timeout.connect(self._report_when_ready)
        self._timer.start()
        self._input = QSocketNotifier(0, QSocketNotifier.Type.Read)
        self._input.activated.connect(self._obey)

    def _report_when_ready(self) -> None:
        if self.window.session.is_stopped:
            self.window.session.rearm()
            self.player.play()
        latest = self.player.snapshot().leading.tick
        if latest is None or np.hypot(*latest["force_n"][:2]) < READY_FORCE_N:
            return
        self._timer.stop()
        self._say(ready=True, loop=self.player.snapshot().leading.loop_pid)

    def _obey(self) -> None:
        words = os.read(0, 4096).decode().split()
        if not words:  # the benchmark has ended
            self._input.setEnabled(False)
            self.window.close()
        for word in words:
            now_s = self.opened.clock.now_s()
            self._do(word)
            self._say(word=word, at_s=now_s)

    def _do(self, word: str) -> None:
        from PySide6.QtCore import Qt, QTimer
        from PySide6.QtTest import QTest

        if word == "esc":
            QTest.keyClick(self.window.windowHandle(), Qt.Key.Key_Escape)
        elif word == "stop":
            self.window.transport.stop.click()
        elif word == "close":
            QTimer.singleShot(0, self.window.close)
        elif word == "rearm":
            self._timer.start()


def _be_the_player(clip: str, force: str, record: str, control: str) -> None:
    from PySide6.QtCore import QTimer

    from app.bridge.interrupts import closing_on_signals, hold_signals

    hold_signals()
    commanded = _Commanded(Path(clip), Path(force), record, control)
    application = commanded.opened.application

    def close() -> None:
        commanded.window.close()
        application.quit()

    with closing_on_signals(lambda: QTimer.singleShot(0, close)):
        application.exec()


if __name__ == "__main__":
    _be_the_player(*sys.argv[1:])
