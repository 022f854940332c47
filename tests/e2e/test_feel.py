"""`feel` with the real processes: a board on a pseudo-terminal, the force in the log."""

import os
import signal
import struct
import threading
import tty

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from tests.e2e.command import forces_of, hapticplayer, read_log, refused, started

PERIOD_S, PATIENCE_S = 0.01, 60.0
G_COUNTS = 2048  # of the WT901
PUSHED_N = 0.4 * 9.80665 / 2


def wt901(up_g, rate=0):
    """The two frames of a sample; `rate` in counts about x."""
    frames = b""
    for kind, numbers in ((0x51, (0, 0, round(up_g * G_COUNTS))), (0x52, (rate, 0, 0))):
        frame = struct.pack("<BB4h", 0x55, kind, *numbers, 0)
        frames += frame + bytes([sum(frame) & 0xFF])
    return frames


def wait(seconds):
    clock = SystemClock()
    clock.sleep_until(clock.now_s() + seconds)


class Board:
    """Sends 100 samples a second on a pseudo-terminal, from a thread."""

    def __init__(self):
        self.ours, theirs = os.openpty()
        tty.setraw(theirs)
        self.path, self.theirs = os.ttyname(theirs), theirs
        self.up_g, self.is_sending, self.is_over = 1.0, True, False
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()

    def _run(self):
        while not self.is_over:
            if self.is_sending:
                os.write(self.ours, wt901(self.up_g))
            wait(PERIOD_S)

    def unplug(self):
        self.is_over = True
        self.thread.join()
        os.close(self.ours)
        os.close(self.theirs)


@pytest.fixture
def board():
    made = Board()
    yield made
    if not made.is_over:
        made.unplug()


def wait_for_event(log, name, count=1):
    for _ in range(round(PATIENCE_S / 0.02)):
        if log.exists() and log.read_text().count(f'"name": "{name}"') >= count:
            return
        wait(0.02)
    raise AssertionError(f"no {name} came")


def feel(board, log, *more):
    return started(
        "feel", "--imu", f"wt901:{board.path},baud=115200", "--log", log, *more
    )


@pytest.mark.realtime
def test_a_push_on_the_sensor_is_felt_until_ctrl_c(board, tmp_path):
    log = tmp_path / "log.jsonl"
    process = feel(board, log)
    wait_for_event(log, "force_following")
    board.up_g = 1.5
    wait(0.5)
    board.is_sending = False
    wait_for_event(log, "ramp")
    board.is_sending = True
    wait_for_event(log, "force_following", 2)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0, said
    assert "Traceback" not in said
    lines = read_log(log)
    _, _, force_n = forces_of(lines)
    assert force_n[:, 1].max() == pytest.approx(PUSHED_N, abs=0.1)
    assert np.abs(force_n[:, [0, 2]]).max() < 0.1
    causes = [x["cause"] for x in lines if x.get("name") in ("ramp", "trip")]
    assert causes[0] == "source_silent"
    assert causes[1] == "stopped"  # Ctrl+C takes the force away at once


@pytest.mark.realtime
def test_a_sensor_that_is_unplugged_ends_the_command(board, tmp_path):
    log = tmp_path / "log.jsonl"
    process = feel(board, log)
    wait_for_event(log, "force_following")
    board.unplug()
    _, said = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 1
    assert "connect it again" in said
    assert not forces_of(read_log(log))[2][-1].any()


@pytest.mark.parametrize(
    ("more", "why"),
    [
        (["--gain", "fit"], "--gain"),
        (["--mounting", "auto"], "auto"),
        (["--device", "none"], "name a --device"),
    ],
)
def test_options_without_a_sense_here_are_refused(board, more, why):
    done = hapticplayer("feel", "--imu", f"wt901:{board.path}", *more)
    assert why in refused(done, status=2)


def test_a_port_that_is_not_there_is_refused():
    assert "no-port" in refused(hapticplayer("feel", "--imu", "wt901:/dev/no-port"))
