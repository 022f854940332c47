"""At the command line nothing re-arms: a force that was stopped stays away."""

import os
import signal
import socket
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.media.encode import write_clip
from hapticplayer.simulation.falcon.remote import Controls
from tests.e2e.command import ROOT, forces_of, read_log, started
from tests.material.plant_record import read_record
from tests.needed_extras import needs

CLIP_S, SUSPENDED_S = 5, 1.5
LATER_S = 0.3  # a loop notices a silent player, then nothing more may come


@pytest.fixture(scope="module")
def felt_clip(tmp_path_factory):
    """A grey clip and a steady gentle force."""
    folder = tmp_path_factory.mktemp("clip")
    grey = (np.full((72, 128, 3), 90, np.uint8) for _ in range(30 * CLIP_S))
    write_clip(folder / "clip.mp4", grey, frame_rate_hz=30)
    force = folder / "force.csv"
    force.write_text(f"time_s,fx_n,fy_n,fz_n\n0,0,0.3,0\n{CLIP_S},0,0.3,0\n")
    return folder / "clip.mp4", force


@pytest.mark.realtime
def test_a_player_that_was_suspended_plays_on_without_force(felt_clip, tmp_path):
    clip, force = felt_clip
    log = tmp_path / "log.jsonl"
    options = ("--headless", "--mute", "--force", force, "--log", log)
    clock = SystemClock()
    process = started("play", clip, *options)
    for _ in range(600):
        if log.exists() and '"force_following"' in log.read_text():
            break
        clock.sleep_until(clock.now_s() + 0.05)
    process.send_signal(signal.SIGSTOP)
    clock.sleep_until(clock.now_s() + SUSPENDED_S)
    process.send_signal(signal.SIGCONT)
    _, said = process.communicate(timeout=60)
    assert "Traceback" not in said
    lines = read_log(log)
    trips = [x["monotonic_s"] for x in lines if x.get("name") == "trip"]
    assert trips, "a player that is silent for a second is a trip"
    time_s, _, force_n = forces_of(lines)
    assert np.abs(force_n[time_s < trips[0]]).max() > 0.2
    after = force_n[time_s > trips[0] + LATER_S]
    assert len(after)
    assert not after.any()


@needs("faults", "measuring")
@pytest.mark.realtime
def test_a_grip_button_ends_the_forces_of_a_measurement():
    record, clock = os.memfd_create("record"), SystemClock()
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    passed = (record, theirs.fileno())
    command = [sys.executable, "-m", "tests.e2e.measuring_owner", *map(str, passed)]
    controls = Controls(ours.detach())
    with subprocess.Popen(
        command, pass_fds=passed, stderr=subprocess.PIPE, text=True, cwd=ROOT
    ) as process:
        try:
            while process.poll() is None and not _has_pushed(record):
                clock.sleep_until(clock.now_s() + 0.01)
            pressed_s = clock.now_s()
            controls.press(1)
            _, said = process.communicate(timeout=60)
        finally:
            process.kill()
            theirs.close()
            controls.close()
    assert process.returncode == 1, said
    assert "stopped by a button on the grip" in said
    ticks = read_record(record)
    os.close(record)
    pushes = ticks["commanded_n"].any(axis=1)
    assert pushes.any()
    assert not pushes[-1]
    begins = np.diff(pushes[ticks["monotonic_s"] > pressed_s].astype(int)) > 0
    assert begins.sum() <= 1  # what was on its way when the button went down


def _has_pushed(record: int) -> bool:
    try:
        return bool(read_record(record)["commanded_n"][-1:].any())
    except ValueError:  # it has not begun to write
        return False
