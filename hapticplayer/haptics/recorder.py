"""The recorder: a process that writes every tick of the loop into a file.

It only reads the ring that the loop writes anyway, so the loop neither waits for it
nor knows of it. It outlives player and loop by as long as the last ticks take: the
record holds the end of a player that was killed. Run as
`python -m hapticplayer.haptics.recorder` by `LoopRecording`.
"""

import argparse
import contextlib
import enum
import errno
import os
import select
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import Message
from hapticplayer.haptics.lifeline import outlive_the_player
from hapticplayer.haptics.records import RecordWriter, open_record
from hapticplayer.haptics.shared import TICK, SharedBlock
from hapticplayer.haptics.spawn import Process, run_module
from hapticplayer.storage import disk_of, write_problem

READ_PERIOD_S = 0.05
SYNC_PERIOD_S = 1.0
NICENESS = 5  # the ring holds 32 s, and the loop never waits
_NO_TICKS = np.empty(0, dtype=TICK)


# --- the player's side ------------------------------------------------------


class LoopRecording:
    """A record of one loop; it never disturbs playing.

    The file is created at once, so that a wrong name is reported before anything
    starts. The process is started when the loop is ready and its scheduling is known;
    the ring keeps the ticks until then. It ends after the loop's process.

    Raises:
        InputError: when the file cannot be created.
    """

    def __init__(self, path: Path, block_descriptor: int) -> None:
        self.process: Process | None = None
        self._path, self._problem = path, ""
        self._file = open_record(path)
        self._descriptors = contextlib.ExitStack()
        self._descriptors.callback(os.close, self._file)
        self._block = os.dup(block_descriptor)
        self._descriptors.callback(os.close, self._block)

    @property
    def problem(self) -> str:
        """Why the recording is incomplete, "" while all is well; never waits."""
        status = self.process.poll() if self.process else None
        if status and not self._problem:
            reason = _REASONS.get(status, _ENDED)
            disk = disk_of(self._path)
            self._problem = Message(reason, disk=disk, status=status)
        return self._problem

    def start(self, end: int, header: Mapping[str, Any]) -> None:
        """Record a loop until the pipe `end` closes, which only the loop holds open.

        The header is provenance beside what is always there: device, scheduling.
        """
        if self._file < 0:  # closed
            return
        passed = {"--block": self._block, "--file": self._file, "--end": end}
        with self._descriptors:
            try:
                RecordWriter(self._file).begin(header)
                self.process = run_module(
                    "hapticplayer.haptics.recorder",
                    passed,
                    stdout=subprocess.DEVNULL,
                    start_new_session=True,  # signals to the player's group spare it
                )
            except OSError as problem:
                self._problem = Message(
                    "nothing is being recorded: {reason}",
                    reason=write_problem(problem, self._path),
                )

    def finish(self, timeout_s: float = 5.0) -> None:
        """Wait, after the loop has ended, until all is written."""
        if self.process is not None:
            try:
                self.process.wait(timeout_s)
            except subprocess.TimeoutExpired:
                self._problem = Message(
                    "the recording is incomplete: the disk is too slow"
                )
        elif not self._problem:  # the loop was never ready: there is no record
            self._path.unlink(missing_ok=True)
        self._descriptors.close()
        self._file = -1


# --- the recorder's side ----------------------------------------------------


class TickRecorder:
    """Moves ticks from the ring into the file of a writer that has its header."""

    def __init__(self, clock: Clock, block: SharedBlock, writer: RecordWriter) -> None:
        self._clock, self._block, self._writer = clock, block, writer
        self._next_number = 0
        self._lost = 0
        self._synced_s = clock.now_s()

    def run(self, end: int) -> None:
        """Record until the loop's process has gone.

        Raises:
            OSError: when the file cannot be written any more.
        """
        watch = select.poll()
        watch.register(end, select.POLLIN)
        while not watch.poll(READ_PERIOD_S * 1000):
            self.collect()
        self.finish()

    def collect(self) -> None:
        """Write the ticks since the last call; once a second make them durable."""
        now_s = self._clock.now_s()
        ticks, head, lost = self._block.read_ticks(self._next_number)
        self._next_number = head
        self._lost += lost
        if len(ticks):
            self._writer.append(head - len(ticks), self._lost, ticks)
            self._lost = 0
        if now_s - self._synced_s >= SYNC_PERIOD_S:
            self._synced_s = now_s
            self._writer.sync()

    def finish(self) -> None:
        self.collect()
        self._writer.append(self._next_number, self._lost, _NO_TICKS)
        self._writer.sync()


class Status(enum.IntEnum):
    """How the process ends; 1 and 2 are the interpreter's own."""

    DONE = 0
    FULL = 3
    REMOVED = 4
    FAILED = 5


_ENDED = Message("the recording is incomplete: its process ended with status {status}")
_REASONS: dict[int, Message] = {
    Status.FULL: Message(
        "the recording is incomplete: the disk at {disk} is full, or the file has reached its size limit"
    ),
    Status.REMOVED: Message("the recording is incomplete: its file was removed"),
    Status.FAILED: Message(
        "the recording is incomplete: its file could not be written"
    ),
}
_STATUS_OF = {
    errno.ENOSPC: Status.FULL,
    errno.EDQUOT: Status.FULL,
    errno.EFBIG: Status.FULL,
    errno.ENOENT: Status.REMOVED,
}


def main(argv: list[str] | None = None) -> int:
    """Record one loop until its end."""
    parser = argparse.ArgumentParser(prog="hapticplayer.haptics.recorder")
    for name in ("--block", "--file", "--end"):
        parser.add_argument(name, type=int, required=True, help="descriptor")
    options = parser.parse_args(argv)
    # the end is the loop's end, whatever happens to the player
    outlive_the_player()
    os.nice(NICENESS)
    try:
        writer = RecordWriter(options.file)
        recorder = TickRecorder(SystemClock(), SharedBlock(options.block), writer)
        recorder.run(options.end)
    except (OSError, ValueError) as problem:
        with contextlib.suppress(OSError):  # the player may be gone, and its stderr
            sys.stderr.write(f"{parser.prog}: recording has ended: {problem}\n")
            sys.stderr.flush()
        code = problem.errno if isinstance(problem, OSError) else None
        return _STATUS_OF.get(code or 0, Status.FAILED)
    return Status.DONE


if __name__ == "__main__":
    sys.exit(main())
