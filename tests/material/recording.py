"""A camera whose frames turn, and a board on a pseudo-terminal that turns with them.

Both go by the machine's wall clock, so that the true offset of a recording is known.
"""

import contextlib
import math
import os
import subprocess
import sys
import termios
import threading
import tty
from typing import NamedTuple

import numpy as np

from hapticplayer.capture import read_recording
from hapticplayer.capture.recorded import parts_of, read_take
from hapticplayer.capture.si_csv import RECORDING
from hapticplayer.clock import SystemClock, realtime_minus_monotonic_s
from hapticplayer.errors import HapticPlayerError
from hapticplayer.media.clip_info import probe
from hapticplayer.model import ClockMap

TURNS = ((0.5, 0.4), (0.3, 0.73))
"""Amplitude in rad and frequency in Hz of the roll, about the axis to the front."""

RATE_HZ, PPM = 200.0, 40.0
_HEADER = "time_s,ax,ay,az,gx,gy,gz\n"


def camera(size="320x240", seconds=None, source="testsrc2"):
    """The name of a camera that films 30 frames a second, and is unplugged after some time."""
    roll = "+".join(f"{a}*sin(2*PI*{hz}*t)" for a, hz in TURNS)
    length = "" if seconds is None else f":duration={seconds}"
    return (
        f"lavfi:{source}=size={size}:rate=30{length},settb=1/1000000,realtime,"
        f"setpts=RTCTIME/1000000/TB,rotate='{roll}'"
    )


MICROPHONE = (
    "lavfi:sine=frequency=440:sample_rate=48000:samples_per_frame=1024,"
    "asettb=1/1000000,arealtime,asetpts=RTCTIME/1000000/TB"
)


def roll_rad(wall_s):
    return sum(a * np.sin(2 * np.pi * hz * np.asarray(wall_s)) for a, hz in TURNS)


def rolled(wall_s):
    """Acceleration and rate (n, 6) of a board that rolls as the frames do.

    Its gyro integrates: a rate is the mean since the sample before.
    """
    angle = roll_rad(wall_s)
    rate = RATE_HZ * (angle - roll_rad(np.asarray(wall_s) - 1.0 / RATE_HZ))
    zero = 0.0 * angle
    accel = [-9.80665 * np.sin(angle), zero, 9.80665 * np.cos(angle)]
    return np.column_stack([*accel, zero, rate, zero])


class Board:
    """Lines of CSV at 200 Hz on a pseudo-terminal, in batches, on a clock of its own."""

    def __init__(self, batch_s=0.008, seed=7):
        self._batch_s, self._rng = batch_s, np.random.default_rng(seed)
        self._clock, self._over = SystemClock(), threading.Event()
        self._asleep = threading.Event()
        self.plug_in()
        # its lines would not fit into the usual 115200 baud
        self.source = f"csv:{self.port},baud=921600"

    def plug_in(self, name=None):
        """Begin anew, its clock too; under a lasting name, as a real one has."""
        self._over.clear()
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave, termios.TCSANOW)
        os.set_blocking(self._master, False)
        self.port = os.ttyname(self._slave)
        if name is not None:
            name.unlink(missing_ok=True)
            name.symlink_to(self.port)
        self._thread = threading.Thread(target=self._send, daemon=True)
        self._thread.start()

    def _send(self):
        begin_s, wall_s, count = self._clock.now_s(), realtime_minus_monotonic_s(), 0
        while not self._over.wait(self._batch_s):
            until = int((self._clock.now_s() - begin_s) * RATE_HZ)
            at_s = begin_s + np.arange(count, until) / RATE_HZ
            count = until
            if not len(at_s) or self._asleep.is_set():
                continue
            noise = self._rng.normal(0.0, 0.02, (len(at_s), 6))
            values = rolled(at_s + wall_s) + noise
            stamps_s = 100.0 + (at_s - begin_s) * (1 - 1e-6 * PPM)
            rows = np.column_stack([stamps_s, values]).tolist()
            lines = [",".join(f"{one:.6f}" for one in row) + "\n" for row in rows]
            # again and again, for whoever begins to listen later
            with contextlib.suppress(BlockingIOError):
                os.write(self._master, "".join([_HEADER, *lines]).encode())

    def sleep(self, is_asleep):
        """As a phone in a pocket does: it measures on, and sends nothing."""
        (self._asleep.set if is_asleep else self._asleep.clear)()

    def unplug(self):
        """May be called again."""
        self._over.set()
        self._thread.join()
        for descriptor in (self._master, self._slave):
            if descriptor >= 0:
                os.close(descriptor)
        self._master = self._slave = -1


def clock_error_s(imu, take, clock_map=None):
    """By how much a log of a board is late in media time, by what it has measured."""
    clock_map = clock_map or ClockMap()
    wall_s = take.zero_s + realtime_minus_monotonic_s()
    media_s = clock_map.rate * imu.time_s + clock_map.offset_s
    measured, late_s, step_s = imu.angular_rate_radps[:, 1], 0.0, 1e-3
    for _ in range(5):
        true, later = (rolled(wall_s + media_s - late_s + d)[:, 4] for d in (0, step_s))
        slope = (later - true) / step_s
        late_s -= float(slope @ (measured - true) / (slope @ slope))
    return late_s


class Kill(NamedTuple):
    """What a killed recorder has left: seconds missing at the end, or why nothing."""

    film_lost_s: float
    motion_lost_s: float
    problem: str


def killed(folder, after_s):
    """Record, kill the recorder some time after its first frame, and read what is there."""
    board, clock = Board(), SystemClock()
    words = ["record", "-o", folder, "--camera", camera("160x120")]
    words += ["--audio", MICROPHONE, "--imu", board.source]
    line = [sys.executable, "-m", "app", *map(str, words)]
    recorder = subprocess.Popen(line, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        while not (folder / RECORDING).exists() and recorder.poll() is None:
            clock.sleep_until(clock.now_s() + 0.01)
        clock.sleep_until(clock.now_s() + after_s)
        recorder.kill()
        killed_s = clock.now_s()
        said = recorder.communicate()[1].decode()
    finally:
        board.unplug()
    try:
        parts = parts_of(folder)
        imu = read_recording(parts.log).imu
        ends_s = probe(parts.clip).duration_s, float(imu.time_s[-1])
    except (HapticPlayerError, OSError) as problem:
        return Kill(math.nan, math.nan, f"{problem} {said}")
    media_s = killed_s - read_take(folder).zero_s
    return Kill(media_s - ends_s[0], media_s - ends_s[1], "")
