"""From a real fault to no force on the motors: distribution beside the bar.

    python benchmarks/faults.py [--repetitions 20] [--only NAME ...] [--resume FILE]

Real processes: the window (offscreen) plays a turning force of 4 N into the simulated
Falcon, which is a process of its own and writes down when the force on its motors
changed. Faults come at random moments. A sentinel at the highest FIFO priority tells
which outliers were stalls of the machine: what it lost between the fault and the zero is
subtracted for the verdict, and shown. After each stop that leaves the player alive, the
force is re-armed and must belong to the right moment of the clip again.
With --resume every repetition is kept in FILE, and those that are there are not repeated.
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
from common import ROOT, save, table
from sentinel import Sentinel, sentinel

from hapticplayer.haptics.contract import Cause
from hapticplayer.haptics.shared import SharedBlock
from hapticplayer.media import write_clip
from hapticplayer.simulation.falcon.record_reader import read_record
from hapticplayer.simulation.falcon.remote import Controls

FORCE_N, TURN_RADPS, CLIP_S = 4.0, 2.0, 600
ROW_S = 0.01
READY_TIMEOUT_S = 60.0
# 4 N for longer is more than the motors may bear: the limiter comes down to 3 N
TURNS_A_PLAYER = 4
BACK_IN_SYNC_S = 0.002
BACK_WITHIN_S, CLEAR_N = 5.0, 1.0


@dataclass(frozen=True)
class Fault:
    """One way to end the force.

    Attributes:
        bar_s: after which there must be none.
        inject: does it and returns the monotonic time at which it was done.
        kills: whether the player does not survive it.
        settle_s: time until all reactions are over.
    """

    bar_s: float
    inject: Callable[["Player"], float]
    kills: bool = False
    settle_s: float = 0.2


class Player:
    """A victim process, its device's record, and the loop's own ticks."""

    def __init__(self, clip: Path, force: Path) -> None:
        self.record = os.memfd_create("record")
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.controls = Controls(ours.detach())
        victim = Path(__file__).with_name("fault_victim.py")
        descriptors = (self.record, theirs.fileno())
        self.process = subprocess.Popen(
            [
                sys.executable,
                str(victim),
                str(clip),
                str(force),
                *map(str, descriptors),
            ],
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
        self.block = _shared_block(self.loop)

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
        sys.exit("the player that was to be hurt did not start")

    def tell(self, word: str) -> float:
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


def _shared_block(loop: int) -> SharedBlock:
    arguments = Path(f"/proc/{loop}/cmdline").read_text().split("\0")
    number = arguments[arguments.index("--block") + 1]
    with Path(f"/proc/{loop}/fd/{number}").open("r+b") as file:
        return SharedBlock(file.fileno())


def _signal(number: int) -> Callable[[Player], float]:
    def inject(player: Player) -> float:
        at_s = time.monotonic()
        os.kill(player.process.pid, number)
        return at_s

    return inject


def _freeze(player: Player) -> float:
    at_s = _signal(signal.SIGSTOP)(player)
    time.sleep(1.5)
    os.kill(player.process.pid, signal.SIGCONT)
    return at_s


def _kill_loop(player: Player) -> float:
    at_s = time.monotonic()
    os.kill(player.loop, signal.SIGKILL)
    return at_s


def _freeze_loop(player: Player) -> float:
    at_s = time.monotonic()
    os.kill(player.loop, signal.SIGSTOP)
    time.sleep(0.2)
    os.kill(player.loop, signal.SIGCONT)
    return at_s


def _press(player: Player) -> float:
    at_s = time.monotonic()
    player.controls.press(1)
    time.sleep(0.1)
    player.controls.press(0)
    return at_s


FAULTS: dict[str, Fault] = {
    "player SIGKILL": Fault(0.025, _signal(signal.SIGKILL), kills=True),
    "player SIGSEGV": Fault(0.025, _signal(signal.SIGSEGV), kills=True),
    "GUI frozen (SIGSTOP)": Fault(0.200, _freeze, settle_s=0.1),
    "loop SIGKILL": Fault(0.010, _kill_loop, kills=True),
    # a fresh player each time: what it missed would hold the force to 3 N for 10 s
    "loop frozen (SIGSTOP)": Fault(0.025, _freeze_loop, kills=True),
    "Esc": Fault(0.025, lambda p: p.tell("esc")),
    "stop button": Fault(0.025, lambda p: p.tell("stop")),
    "grip button": Fault(0.025, _press),
    "Ctrl-C": Fault(0.025, _signal(signal.SIGINT), kills=True),
    "closing the window": Fault(0.025, lambda p: p.tell("close"), kills=True),
}


def zero_after_s(player: Player, at_s: float) -> float:
    """Return how long after the fault the motors were without force for good, s."""
    record = read_record(player.record)
    record = record[record["monotonic_s"] > at_s - 0.1]
    pushed = record["applied_n"].any(axis=1)
    before = record["monotonic_s"] <= at_s
    if not (pushed & before).any():
        raise RuntimeError("there was no force to be ended")
    last = np.flatnonzero(pushed & (record["monotonic_s"] < at_s + 1.0))[-1]
    if last + 1 >= len(record):
        return float("inf")
    return float(max(0.0, record["applied_since_s"][last + 1] - at_s))


def tripped_after_s(player: Player, at_s: float, cause: Cause) -> float:
    """Return when the loop tripped for this cause, s after the fault."""
    ticks, _, _ = player.block.read_ticks(0)
    found = ticks[(ticks["monotonic_s"] > at_s) & (ticks["cause"] == cause)]
    return float(found["monotonic_s"][0] - at_s) if len(found) else float("inf")


def out_of_sync_s(player: Player) -> float:
    """Re-arm, and return by how much force and clip differ once it is back, s.

    The direction of the force tells which moment of the clip it belongs to; the
    published clock tells which it is. A force that went away once more, because the
    decoder did not keep up on a busy machine, has no direction.
    """
    player.tell("rearm")
    player.hear("ready")
    deadline_s = time.monotonic() + BACK_WITHIN_S
    while True:
        time.sleep(0.4)
        ticks = player.block.read_ticks(0)[0][-100:]
        sample = player.block.read_clock()
        pushed_n = np.linalg.norm(
            (ticks["force_n"] - ticks["centring_n"])[:, :2], axis=1
        )
        if sample is not None and pushed_n.min() > CLEAR_N:
            break
        if time.monotonic() > deadline_s:
            return float("inf")
    clock, _ = sample
    media_s = clock.media0_s + clock.rate * (ticks["monotonic_s"] - clock.monotonic0_s)
    expected = TURN_RADPS * ROW_S * np.floor(media_s / ROW_S)  # rows are held
    x, y = (ticks["force_n"] - ticks["centring_n"])[:, :2].T
    wrong = np.angle(np.exp(1j * (np.arctan2(y, x) - expected)))
    return float(np.abs(wrong).max() / TURN_RADPS)


@contextlib.contextmanager
def material() -> Iterator[tuple[Path, Path]]:
    """Make a clip and a force that turns."""
    with tempfile.TemporaryDirectory() as folder:
        clip, force = Path(folder) / "clip.mp4", Path(folder) / "force.csv"
        pictures = (np.full((90, 160, 3), k % 200, np.uint8) for k in range(5 * CLIP_S))
        write_clip(clip, pictures, frame_rate_hz=5)
        t = np.arange(0, CLIP_S, ROW_S)
        x, y = FORCE_N * np.cos(TURN_RADPS * t), FORCE_N * np.sin(TURN_RADPS * t)
        rows = [f"{a:.2f},{b:.5f},{c:.5f},0" for a, b, c in zip(t, x, y, strict=True)]
        force.write_text("time_s,fx_n,fy_n,fz_n\n" + "\n".join(rows) + "\n")
        yield clip, force


def run(
    name: str, count: int, files: tuple[Path, Path], witness: Sentinel, seed: int
) -> Iterator[dict[str, float]]:
    """Yield one result after the other."""
    fault, player = FAULTS[name], None
    moments = np.random.default_rng(seed)
    try:
        for turn in range(1, count + 1):
            player = player or Player(*files)
            time.sleep(moments.uniform(0.05, 0.35))
            at_s = fault.inject(player)
            time.sleep(fault.settle_s)
            after_s = zero_after_s(player, at_s)
            result = {
                "zero_s": after_s,
                "stalled_s": witness.stalled_s(at_s, at_s + min(after_s, 2.0)),
            }
            if name.startswith("GUI"):
                result["trip_s"] = tripped_after_s(player, at_s, Cause.HEARTBEAT_LOST)
            if not fault.kills:
                result["out_of_sync_s"] = out_of_sync_s(player)
            if fault.kills or turn % TURNS_A_PLAYER == 0:
                player.close()
                player = None
            yield result
    finally:
        if player is not None:
            player.close()


def report(results: dict[str, list[dict[str, float]]]) -> list[list[Any]]:
    """Return the rows of the table."""
    rows: list[list[Any]] = []
    for name, found in results.items():
        bar_ms = 1e3 * FAULTS[name].bar_s
        zero_ms = 1e3 * np.array([r["zero_s"] for r in found])
        stalled_ms = 1e3 * np.array([r["stalled_s"] for r in found])
        p50, p99 = np.percentile(zero_ms, [50, 99])
        unexplained = int(np.sum(zero_ms - stalled_ms > bar_ms))
        sync = [1e3 * r["out_of_sync_s"] for r in found if "out_of_sync_s" in r]
        trips = [r["trip_s"] for r in found if "trip_s" in r]
        rows.append(
            [
                name,
                len(found),
                bar_ms,
                float(p50),
                float(p99),
                float(zero_ms.max()),
                int(np.sum(zero_ms > bar_ms)),
                unexplained,
                float(max(sync)) if sync else "-",
                f"{min(trips):.3f}..{max(trips):.3f}" if trips else "-",
            ]
        )
    return rows


def main() -> int:
    """Hurt, measure, tell."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repetitions", type=int, default=20)
    parser.add_argument("--only", nargs="+", choices=FAULTS, default=list(FAULTS))
    parser.add_argument("--resume", type=Path)
    options = parser.parse_args()
    results: dict[str, list[dict[str, float]]] = {name: [] for name in options.only}
    if options.resume and options.resume.exists():
        for line in options.resume.read_text().splitlines():
            entry = json.loads(line)
            if entry["fault"] in results:
                results[entry["fault"]].append(entry["result"])
    with material() as files, sentinel() as witness:
        for name, done in results.items():
            missing = max(0, options.repetitions - len(done))
            for result in run(name, missing, files, witness, seed=len(done)):
                done.append(result)
                if options.resume:
                    with options.resume.open("a") as file:
                        file.write(json.dumps({"fault": name, "result": result}) + "\n")
            print(f"{name}: {len(done)} done", file=sys.stderr)
    header = ["fault", "n", "bar ms", "p50", "p99", "max", "over", "unexplained"]
    header += ["sync ms", "trip s"]
    rows = report(results)
    print(table(header, rows))
    save("faults", {"columns": header, "rows": rows})
    late = [row[0] for row in rows if row[7] or row[4] > row[2]]
    unsynced = [
        row[0] for row in rows if row[8] != "-" and row[8] > 1e3 * BACK_IN_SYNC_S
    ]
    for name in late:
        print(f"{name}: later than its bar")
    for name in unsynced:
        print(f"{name}: not in sync after re-arming")
    return 1 if late or unsynced else 0


if __name__ == "__main__":
    sys.exit(main())
