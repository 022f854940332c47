"""The real process: it starts, follows, dies well, and imports little."""

import json
import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import GUARD_LATE_S, HapticsProcesses, Health
from hapticplayer.haptics.shared import SharedBlock
from hapticplayer.linux import SWITCH, Scheduling
from hapticplayer.model import ForceTrack, PlaybackClock
from tests.material.plant_record import read_record

pytestmark = pytest.mark.realtime

HERE = Path(__file__).parent


def follow(process, clock, until, track="track"):
    """Keep the loop fed until a condition on all its ticks holds."""
    start_s, ticks = clock.now_s(), []
    while True:
        now_s = clock.now_s()
        process.beat()
        process.publish(PlaybackClock(1, start_s, 0.0, 1.0, now_s + 0.15), track)
        records, _ = process.read_ticks()
        ticks.append(records)
        everything = np.concatenate(ticks)
        if until(everything) or process.poll() is Health.GONE:
            return everything
        tripped = len(everything) and everything["mode"][-1] == Mode.TRIPPED
        assert not tripped, f"tripped: {Cause(everything['cause'][-1]).name}"
        clock.sleep_until(now_s + 0.01)


def wait_for_end(pid):
    """Wait until a child has ended, which its owner still has to take note of."""
    os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)


def kill(pid):
    os.kill(pid, signal.SIGKILL)
    wait_for_end(pid)


def test_the_process_follows_a_track_exactly():
    clock = SystemClock()
    process = HapticsProcesses(clock)
    try:
        process.wait_ready()
        t = np.arange(0, 60, 0.01)
        wave = np.stack([np.sin(3 * t), 2 * np.cos(5 * t), 0 * t], axis=1)
        track = ForceTrack(t, wave)
        process.load({"track": track})
        ticks = follow(
            process, clock, lambda r: np.sum(r["mode"] == Mode.FOLLOWING) > 300
        )
    finally:
        process.close()
    followed = ticks[ticks["mode"] == Mode.FOLLOWING]
    error = followed["force_n"] - track.at(followed["media_s"])
    assert np.abs(error).max() < 1e-6
    assert Scheduling(process.scheduling)
    assert process.health is Health.GONE


def test_no_force_is_requested_before_the_device_has_priority():
    """Until then it may wait for a core, and be late under the first force."""
    clock = SystemClock()
    process = HapticsProcesses(clock)
    try:
        process.load({"track": ForceTrack(np.arange(9.0), np.ones((9, 3)))})
        playing = PlaybackClock(1, clock.now_s(), 0.0, 1.0, clock.now_s() + 60.0)
        process.publish(playing, "track")
        assert process.block.read_clock() is None
        process.wait_ready()
        process.publish(playing, "track")
        assert process.block.read_clock() == (playing, 1)
    finally:
        process.close()


def test_an_unknown_device_is_refused_in_one_sentence():
    with pytest.raises(DeviceError, match="no driver"):
        HapticsProcesses(SystemClock(), device="falcon of wood")


def test_a_killed_process_is_noticed():
    process = HapticsProcesses(SystemClock())
    process.wait_ready()
    kill(process.pids["loop"])
    assert process.poll() is Health.GONE
    process.close()


def shared_block_of(loop_pid):
    """Hold the memory of a loop that is about to die."""
    arguments = Path(f"/proc/{loop_pid}/cmdline").read_text().split("\0")
    number = arguments[arguments.index("--block") + 1]
    with Path(f"/proc/{loop_pid}/fd/{number}").open("r+b") as file:
        return SharedBlock(file.fileno())


@pytest.mark.parametrize(
    ("number", "without"),
    [(signal.SIGKILL, ""), (signal.SIGSEGV, ""), (signal.SIGKILL, "robust-mutex")],
)
def test_the_force_goes_to_zero_when_the_player_is_killed(number, without):
    player = subprocess.Popen(
        [sys.executable, str(HERE / "killed_player.py")],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, SWITCH: without},
    )
    try:
        loop_pid = int(player.stdout.readline())
        watch = os.pidfd_open(loop_pid)
        block = shared_block_of(loop_pid)
        os.kill(player.pid, number)
        # the loop ends by itself once zero is on the wire
        ended, _, _ = select.select([watch], [], [], 30)
        os.close(watch)
    finally:
        player.kill()
        player.wait()
        player.stdout.close()
    assert ended
    records, _, _ = block.read_ticks(0)
    force = np.linalg.norm(records["force_n"], axis=1)
    gone = np.flatnonzero(records["cause"] == Cause.PLAYER_GONE)
    assert force[gone[0] - 1] == pytest.approx(2.8, abs=1e-5)
    assert not force[gone].any()  # from the very tick that noticed
    assert records["mode"][-1] == Mode.TRIPPED
    assert len(gone) >= 5


def test_the_guard_writes_zero_when_the_loop_is_killed(tmp_path):
    clock = SystemClock()
    with (tmp_path / "record").open("w+b") as record:
        process = HapticsProcesses(
            clock,
            device_options=["--hand", "firm", "--record", str(record.fileno())],
            device_descriptors=[record.fileno()],
        )
        try:
            process.wait_ready()
            track = ForceTrack([0.0, 1e4], [[0, 0, 2.8], [0, 0, 2.8]])
            process.load({"track": track})
            follow(process, clock, lambda r: r["force_n"][-1:, 2].sum() > 2.79)
            assert read_record(record.fileno())["applied_n"][-1][2] > 2.79
            kill(process.pids["loop"])
            wait_for_end(process.pids["guard"])
        finally:
            process.close()
        felt = read_record(record.fileno())
    assert not felt["applied_n"][-1].any()
    pushed = np.flatnonzero(felt["applied_n"].any(axis=1))
    last = felt["applied_n"][pushed[-1]]
    assert last[2] == pytest.approx(2.8, abs=1e-3)  # from full force to none at once


def test_a_dead_guard_is_told_once_its_beat_is_late(capfd):
    clock = SystemClock()
    process = HapticsProcesses(clock)
    try:
        process.wait_ready()
        kill(process.pids["guard"])
        until_s = process.block.guard_s() + GUARD_LATE_S
        clock.sleep_until(until_s + 0.001)
        assert process.poll() is Health.FAILED
        assert "guard" in process.problem
    finally:
        process.close()


def test_a_simulated_device_that_is_unplugged_is_told():
    clock = SystemClock()
    process = HapticsProcesses(clock)
    try:
        process.wait_ready()
        kill(process.pids["device"])
        ticks = follow(
            process,
            clock,
            lambda r: len(r) and r["cause"][-1] == Cause.UNPLUGGED,
            track="",
        )
        assert process.poll() is Health.FAILED
    finally:
        process.close()
    assert "unplugged" in process.problem
    assert ticks["cause"][-1] == Cause.UNPLUGGED


@pytest.mark.parametrize(
    "module",
    ["haptics.__main__", "haptics.guard", "simulation.falcon.__main__"],
)
def test_processes_of_the_force_import_nothing_heavy(module: str) -> None:
    code = (
        f"import sys, json, hapticplayer.{module}; "
        "print(json.dumps(sorted({m.split('.')[0] for m in sys.modules})))"
    )
    found = json.loads(
        subprocess.run(
            [sys.executable, "-P", "-c", code], capture_output=True, check=True
        ).stdout
    )
    heavy = {"av", "PySide6", "scipy", "sounddevice", "vqf"}
    assert not {*heavy, "numpy"} & set(found)
    assert "mmap" in found
