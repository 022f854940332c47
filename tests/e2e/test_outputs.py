"""Rigs beside a device: a run of the command, and the death of one of their loops."""

import contextlib
import json
import os
import signal
import socket
import subprocess
import threading
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.extras.rigs.receiver import PacketReceiver
from hapticplayer.model import RigTrack
from hapticplayer.playback import device_test
from tests.e2e.command import DISPLAYS, command_line, hapticplayer

pytestmark = pytest.mark.realtime
PATIENCE_S = 60.0


class Listener:
    """Two rigs at free ports, heard in a thread."""

    def __init__(self):
        self.receiver = PacketReceiver(SystemClock(), [0, 0])
        self.first, self.second = self.receiver.rigs
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._listen)
        self._thread.start()

    def _listen(self):
        while not self._is_over.is_set():
            for _ in self.receiver.listen(0.05):
                pass

    def close(self):
        self._is_over.set()
        self._thread.join()
        self.receiver.close()

    @property
    def devices(self):
        outsim = f"rig:outsim,127.0.0.1:{self.first}"
        return outsim, f"rig:beamng,127.0.0.1:{self.second},rate=100"


@pytest.fixture
def rigs():
    made = Listener()
    yield made
    made.close()


def started(demo, devices, *more):
    options = [word for name in devices for word in ("--device", name)]
    options += ["--headless", "--mute", "--start", 3, *more]
    return subprocess.Popen(
        command_line("play", demo, *options),
        env={name: text for name, text in os.environ.items() if name not in DISPLAYS},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def loop_of(player, device):
    """Return the pid of the loop of an output, once it runs."""
    clock = SystemClock()
    end_s = clock.now_s() + PATIENCE_S
    while clock.now_s() < end_s:
        children = Path(f"/proc/{player.pid}/task/{player.pid}/children").read_text()
        for pid in children.split():
            with contextlib.suppress(OSError):
                words = Path(f"/proc/{pid}/cmdline").read_text().split("\0")
                if "hapticplayer.haptics" in words and device in words:
                    return int(pid)
        clock.sleep_until(clock.now_s() + 0.05)
    raise AssertionError("its loop did not start")


def wait_for(condition):
    clock = SystemClock()
    end_s = clock.now_s() + PATIENCE_S
    while not condition():
        assert clock.now_s() < end_s, "it did not happen"
        clock.sleep_until(clock.now_s() + 0.02)


def test_a_device_and_two_rigs_play_and_come_to_rest(demo, rigs):
    devices = ("simulated", *rigs.devices)
    player = started(demo, devices, "--duration", 2, "--json")
    out, err = player.communicate(timeout=PATIENCE_S)
    assert player.returncode == 0, err
    summary = json.loads(out)
    assert summary["device"] == "simulated"
    assert summary["ticks"] > 1000
    assert list(summary["outputs"]) == list(devices)
    assert all(one["ticks"] > 100 for one in summary["outputs"].values())
    rigs.close()
    for port, kind in ((rigs.first, "outsim"), (rigs.second, "beamng")):
        report = rigs.receiver.report()[port]
        assert report["format"] == kind
        assert report["peak_mps2"] > 0.5
        assert report["is_neutral"]
        assert report["time_went_back"] == 0
    # by the sender's own clock: two seconds and more of neutral
    assert rigs.receiver.rigs[rigs.first].last.time_s > 2.0 + 0.5 + 2.0 - 0.1


@pytest.mark.parametrize("name", ["outsim", "codemasters", "beamng"])
@pytest.mark.parametrize("leads", [True, False])
def test_a_rig_that_nobody_listens_to_is_said(demo, tmp_path, name, leads):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as unused:
        unused.bind(("127.0.0.1", 0))
        where = f"127.0.0.1:{unused.getsockname()[1]}"
    rig, log = f"rig:{name},{where}", tmp_path / "log.jsonl"
    devices = (rig, "simulated") if leads else ("simulated", rig)
    player = started(demo, devices, "--duration", 1, "--json", "--log", log)
    out, err = player.communicate(timeout=PATIENCE_S)
    said = f"nobody listens at {where}: start the rig's software"
    assert said in err
    assert player.returncode == int(leads)
    assert json.loads(out)["outputs"][rig]["fault"] == said
    events = [json.loads(line) for line in log.read_text().splitlines()]
    (event,) = [one for one in events if one.get("name") == "nobody_listens"]
    assert event["output"] == rig


def test_a_rig_is_tested_and_left_in_neutral(rigs, monkeypatch):
    time_s, motion = np.arange(0.0, 1.5, 0.01), np.zeros((150, 15))
    motion[20:60, 2] = 0.4  # up
    track = RigTrack(time_s, motion)
    monkeypatch.setattr(device_test, "rig_demonstration", lambda: (track, ()))
    name = rigs.devices[0]
    done = hapticplayer("device", "test", "--device", name, "--yes", "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["is_heard"]
    assert report["packets"] > 200
    rigs.close()
    heard = rigs.receiver.report()[rigs.first]
    assert heard["packets"] >= report["packets"]
    assert heard["is_neutral"]
    assert heard["peak_mps2"] > 0.0


def test_a_dead_loop_is_brought_to_rest_and_the_other_plays_on(demo, rigs):
    player = started(demo, rigs.devices, "--duration", 4)
    first = rigs.receiver.rigs[rigs.first]
    second = rigs.receiver.rigs[rigs.second]
    wait_for(lambda: first.peak_mps2 > 0.5 and second.peak_mps2 > 0.5)
    os.kill(loop_of(player, rigs.devices[0]), signal.SIGKILL)
    wait_for(lambda: first.last.is_neutral)
    wait_for(lambda: not second.last.is_neutral)
    _, err = player.communicate(timeout=PATIENCE_S)
    assert player.returncode == 1
    assert "the haptics process has ended" in err
    assert first.report(SystemClock().now_s())["neutral_s"] > 1.5
    assert second.last.is_neutral
