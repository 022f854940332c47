"""From a sample on the wire to the force on the device, measured from outside.

A board on a pseudo-terminal sends WT901 frames; every half second its acceleration steps
by half a g. The command `feel` reads it, or (`feel_window`) the recorder of the window,
which films FFmpeg's test source meanwhile; the simulated Falcon keeps what reached it, on the
same clock. A step counts from the return of the write of its sample until the device has
90 % of the force. A process that only reads a second pseudo-terminal is the reference: so
much is the machine's.
"""

import argparse
import contextlib
import os
import random
import select
import struct
import subprocess
import sys
import time
import tty
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import ROOT, Report
from tests.material.plant_record import read_record
from tools.witness import machine_witness

if TYPE_CHECKING:
    from app.player.video_surface import SurfaceSink
    from hapticplayer.clock import Clock

MOST_MS = 15.0
FILM = "lavfi:testsrc2=size=640x360:rate=30"
RATES_HZ = (200.0, 100.0)
STEP_G, STEP_S, FULL = 0.5, 0.5, 0.9
BEGINS_S, REST_S = 40.0, 5.0  # at most until it is felt; at rest before the first step
FORCE_N = 0.4 * STEP_G * 9.80665
_COUNTS_PER_G, _PRIORITY = 2048, 70
Floats = NDArray[np.float64]


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--seconds", type=float, help="of steps (60, quick: 15)")


window_options = options


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure each rate."""
    _run(options, report, "feel")


def window(options: argparse.Namespace, report: Report) -> None:
    """From a sample to the force, felt by the recorder in the window while it films."""
    _run(options, report, "window")


def _run(options: argparse.Namespace, report: Report, host: str) -> None:
    seconds = options.seconds or (15.0 if options.quick else 60.0)
    rows = []
    with machine_witness() as witness, contextlib.suppress(PermissionError):
        os.sched_setscheduler(
            0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(_PRIORITY)
        )
        for rate_hz in RATES_HZ[:1] if options.quick else RATES_HZ:
            for what, late_ms in measured(rate_hz, seconds, host).items():
                p50, p95 = np.percentile(late_ms, (50, 95), method="higher").tolist()
                rows.append(
                    [f"{rate_hz:g} Hz", what, len(late_ms), p50, p95, late_ms.max()]
                )
                report.figures[f"{what}, {rate_hz:g} Hz"] = {"p50": p50, "p95": p95}
                if what != REFERENCE:
                    name = f"{rate_hz:g} Hz: sample to {what}, p95, ms"
                    report.target(name, p95, ("<=", MOST_MS))
        report.figures["machine_stalls"] = witness.seen().summary()
    header = ["samples", "until", "steps", "median", "95 %", "most"]
    report.table("After the write of a sample, ms", header, rows, mark="feel")


REFERENCE = "it is read"


def measured(rate_hz: float, seconds: float, host: str) -> dict[str, Floats]:
    """How long after each step it was felt, and read, ms."""
    record = os.memfd_create("feel")
    with TemporaryDirectory() as folder, _terminal() as felt, _terminal() as read:
        command = [sys.executable, "-m", __spec__.name]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "cwd": ROOT}
        environment = {**os.environ, "XDG_CONFIG_HOME": folder}
        feel = subprocess.Popen([*command, host, felt.path, str(record)],
                                pass_fds=(record,), env=environment, **quiet)  # fmt: skip
        times = Path(folder) / "times"
        reader = subprocess.Popen([*command, "read", read.path, str(times)], **quiet)
        try:
            steps_s = _steps([felt, read], record, 1.0 / rate_hz, seconds)
            device = read_record(record)
        finally:
            for process in (feel, reader):
                process.terminate()
                process.communicate(timeout=20.0)
        seen_s = np.fromfile(times)
    up_n = device["commanded_n"][:, 1].astype(float)
    found = {f"{share:.0%} of the force": np.array(
        [_reached_s(device["monotonic_s"], up_n, step_s, share) for step_s in steps_s]
    ) for share in (0.5, FULL)}  # fmt: skip
    found[REFERENCE] = (
        seen_s[np.searchsorted(seen_s, steps_s)] if len(seen_s) else seen_s
    )
    return {what: 1e3 * (at_s - steps_s) for what, at_s in found.items()}


def _reached_s(time_s: Floats, up_n: Floats, step_s: float, share: float) -> float:
    """When the device had so much of a step, infinity for never."""
    at = int(np.searchsorted(time_s, step_s))
    before_n = up_n[at - 1]
    sign = 1.0 if before_n < 0.5 * FORCE_N else -1.0
    moved = sign * (up_n[at:] - before_n) >= share * FORCE_N
    row = int(np.argmax(moved))
    after_s = float(time_s[at + row]) if moved.any() else np.inf
    return after_s if after_s < step_s + STEP_S else np.inf


class _Terminal:
    """The board's end of a pseudo-terminal."""

    def __init__(self) -> None:
        self.ours, self.theirs = os.openpty()
        tty.setraw(self.theirs)
        os.set_blocking(self.ours, False)
        self.path = os.ttyname(self.theirs)

    def send(self, data: bytes) -> None:
        with contextlib.suppress(BlockingIOError):  # nobody reads yet
            os.write(self.ours, data)


@contextlib.contextmanager
def _terminal() -> Iterator[_Terminal]:
    made = _Terminal()
    try:
        yield made
    finally:
        os.close(made.ours)
        os.close(made.theirs)


def _steps(
    terminals: list[_Terminal], record: int, period_s: float, seconds: float
) -> Floats:
    """Send samples: at rest until they are felt, then steps; when those were written."""
    steps_s: list[float] = []
    is_up, felt_s, begin_s = False, 0.0, time.monotonic()
    due_s, step_s, end_s = begin_s, np.inf, np.inf
    while due_s < end_s:
        time.sleep(max(0.0, due_s - time.monotonic()))
        has_stepped = due_s >= step_s
        if has_stepped:
            is_up = not is_up
            step_s = due_s + STEP_S + random.uniform(0.0, 0.02)  # noqa: S311 - phases
        sample = _wt901(1.0 + STEP_G * is_up)
        for terminal in terminals:
            terminal.send(sample)
        if has_stepped:
            steps_s.append(time.monotonic())
        if not felt_s and due_s > begin_s + BEGINS_S:
            sys.exit("nothing was felt; run the command `feel` to see why")
        if not felt_s and _is_on(record):
            felt_s = due_s
            step_s, end_s = due_s + REST_S, due_s + REST_S + seconds
        due_s += period_s
    return np.array(steps_s[:-1])  # the last may not have had its time


def _is_on(record: int) -> bool:
    """Whether the device gets commands, so that the command has opened it."""
    with contextlib.suppress(ValueError):
        return len(read_record(record)) > 0
    return False


def _wt901(up_g: float) -> bytes:
    """The two frames of a sample: acceleration and angular rate."""
    frames = b""
    for kind, z in ((0x51, round(up_g * _COUNTS_PER_G)), (0x52, 0)):
        frame = struct.pack("<BB4h", 0x55, kind, 0, 0, z, 0)
        frames += frame + bytes([sum(frame) & 0xFF])
    return frames


# --- the processes -----------------------------------------------------------------


def feel(path: str, record: str) -> int:
    """The command, with a device that keeps what reached it."""
    from benchmarks.window import with_device_options
    from hapticplayer import cli
    from hapticplayer.playback import player

    device = ("--hand", "firm", "--record", record)
    make = with_device_options(*device, descriptors=[int(record)])
    player.HapticsProcesses = make  # type: ignore[assignment,misc]
    return cli.main(["feel", "--imu", f"wt901:{path},baud=921600"])


def window_that_feels(path: str, record: str) -> int:
    """The button of the recorder, in a window that plays nothing beside it."""
    from PySide6.QtCore import QTimer

    from app.bridge.settings import RECORD
    from app.experimenter.record_feel import FeelSetup
    from app.experimenter.record_page import RecordPage
    from benchmarks.window import open_window, with_device_options
    from hapticplayer.model import Mapping
    from hapticplayer.playback.player import Player

    device = ("--hand", "firm", "--record", record)
    make = with_device_options(*device, descriptors=[int(record)])
    opened = open_window(None)
    opened.player.set_outputs([])
    takes = Path(os.environ["XDG_CONFIG_HOME"], "takes")
    chosen = {"camera": FILM, "sensor": "wt901", "place": f"{path},baud=921600"}
    opened.window.settings.keep(RECORD, {**chosen, "folder": str(takes)})

    def player(clock: "Clock", sink: "SurfaceSink", output: str) -> Player:
        return Player(clock, sink, outputs=[output], audio=None, haptics=make)

    latch = opened.player.latch
    setup = FeelSetup(opened.clock, "simulated", Mapping(), player, latch)
    page = RecordPage(opened.window.settings, setup, opened.window)
    page.show()
    page.record()
    timer = QTimer(page, interval=100)

    def begin() -> None:
        if page.recorder is not None and page.recorder.snapshot().samples:
            timer.stop()
            page.feeling.button.click()

    timer.timeout.connect(begin)
    timer.start()
    return opened.application.exec()


def read(path: str, times: str) -> int:
    """Note when a sample came that differs from the one before."""
    port, before = os.open(path, os.O_RDONLY | os.O_NOCTTY), b""
    with Path(times).open("wb", buffering=0) as file:
        while select.select([port], [], [], 60.0)[0]:
            now = os.read(port, 4096)
            if now[:22] != before[:22]:
                file.write(struct.pack("<d", time.monotonic()))
            before = now
    return 0


if __name__ == "__main__":
    name, *arguments = sys.argv[1:]
    sys.exit(
        {"feel": feel, "window": window_that_feels, "read": read}[name](*arguments)
    )
