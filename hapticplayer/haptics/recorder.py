"""The recorder: a process that writes every tick of the loop into a file.

It only reads the ring that the loop writes anyway, so the loop neither waits for it
nor knows of it. It outlives player and loop by as long as the last ticks take: the
record holds the end of a player that was killed. Run as
`python -m hapticplayer.haptics.recorder`; started by `start_recorder`.
"""

import argparse
import contextlib
import enum
import errno
import os
import select
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import InputError, Message
from hapticplayer.haptics.records import RecordWriter, cannot_write, open_record
from hapticplayer.haptics.shared import TICK, SharedBlock
from hapticplayer.haptics.spawn import run_module

READ_PERIOD_S = 0.05
SYNC_PERIOD_S = 1.0
SILENCE_S = 10.0
"""Without a process to watch, a loop that writes nothing for so long has ended."""
NICENESS = 5  # the ring waits 32 s for us; the loop waits for nobody
_NO_TICKS = np.empty(0, dtype=TICK)


# --- the player's side ------------------------------------------------------


def start_recorder(
    block_descriptor: int,
    loop_pid: int,
    file: Path | int,
    header: Mapping[str, Any],
) -> subprocess.Popen[bytes]:
    """Start recording a loop; it goes on until the loop's process has gone.

    Whoever can tell the scheduling only once the loop is ready may start the
    recorder then: the ring holds 32 s.

    Args:
        block_descriptor: of the shared block; stays the caller's.
        loop_pid: process id of the loop, a child that has not been waited for.
        file: a path that must not exist yet, or what `open_record` returned, which
            is closed here in any case.
        header: provenance beside what is always there: device, scheduling, clip.

    Raises:
        InputError: when the file cannot be created or written.
        OSError: when the process cannot be started.
    """
    descriptor = open_record(file) if isinstance(file, Path) else file
    with contextlib.ExitStack() as stack:
        stack.callback(os.close, descriptor)
        try:
            RecordWriter(descriptor).begin(header)
        except OSError as problem:
            if isinstance(file, Path):
                file.unlink(missing_ok=True)
            raise cannot_write(problem, str(file)) from problem
        options = ["--block", str(block_descriptor), "--file", str(descriptor)]
        passed = [block_descriptor, descriptor]
        with contextlib.suppress(OSError):  # gone already: its ticks are still there
            watch = os.pidfd_open(loop_pid)
            stack.callback(os.close, watch)
            options += ["--loop-pidfd", str(watch)]
            passed.append(watch)
        return run_module(
            "hapticplayer.haptics.recorder",
            options,
            passed,
            stdout=subprocess.DEVNULL,
            start_new_session=True,  # what ends the player's group shall be recorded
        )


def recorder_problem(recorder: subprocess.Popen[bytes]) -> str:
    """Return why recording has ended too early, "" if it has not; never waits."""
    status = recorder.poll()
    if not status:
        return ""
    return _REASONS.get(status) or Message(
        "the record is not complete: its process ended with status {status}",
        status=status,
    )


def finish_recorder(recorder: subprocess.Popen[bytes], timeout_s: float = 5.0) -> str:
    """Wait, after the loop has ended, until all is written; return the problem or ""."""
    try:
        recorder.wait(timeout_s)
    except subprocess.TimeoutExpired:
        return Message("the record is not complete: the disk is too slow")
    return recorder_problem(recorder)


class Recording:
    """A record from the wish to the end; it never disturbs who plays.

    The file is made at once, so that a wrong name is told before anything starts.
    The process is started when the loop is ready and its scheduling is known; the
    ring keeps the ticks until then.

    Args:
        path: must not exist yet.
        block_descriptor: of the shared block; stays the caller's.

    Attributes:
        problem: why the record is not complete, "" while all is well.

    Raises:
        InputError: when the file cannot be created.
    """

    def __init__(self, path: Path, block_descriptor: int) -> None:
        self._problem = ""
        self._path = path
        self._recorder: subprocess.Popen[bytes] | None = None
        self._file: int | None = open_record(path)
        self._block = os.dup(block_descriptor)

    @property
    def problem(self) -> str:
        """Why the record is not complete, "" while all is well; never waits."""
        if self._recorder is not None and not self._problem:
            self._problem = recorder_problem(self._recorder)
        return self._problem

    def start(self, loop_pid: int, header: Mapping[str, Any]) -> None:
        """Record this loop; see `start_recorder`."""
        if self._file is None:
            return
        file, self._file = self._file, None
        try:
            self._recorder = start_recorder(self._block, loop_pid, file, header)
        except (OSError, InputError) as problem:
            self._problem = Message("nothing is recorded: {reason}", reason=problem)

    def finish(self) -> None:
        """Wait, after the loop has ended, until all is written."""
        if self._recorder is not None:
            self._problem = self._problem or finish_recorder(self._recorder)
        if self._file is not None:  # the loop was never ready: there is no record
            os.close(self._file)
            self._file = None
            self._path.unlink(missing_ok=True)
        if self._block >= 0:
            os.close(self._block)
            self._block = -1


# --- the recorder's side ----------------------------------------------------


class Recorder:
    """Moves ticks from the ring into the file.

    Args:
        clock: for the periods.
        block: shared with the loop; only read.
        writer: of a record that has its header.
    """

    def __init__(self, clock: Clock, block: SharedBlock, writer: RecordWriter) -> None:
        self._clock, self._block, self._writer = clock, block, writer
        self._next_number = 0
        self._lost = 0
        self._news_s = self._synced_s = clock.now_s()

    def run(self, loop_pidfd: int | None = None) -> None:
        """Record until the loop's process has gone.

        Without a process to watch: until there has been no tick for SILENCE_S.

        Raises:
            OSError: when the file cannot be written any more.
        """
        watch = select.poll()
        if loop_pidfd is not None:
            watch.register(loop_pidfd, select.POLLIN)
        while not watch.poll(READ_PERIOD_S * 1000):
            self.collect()
            is_silent = self._clock.now_s() - self._news_s > SILENCE_S
            if loop_pidfd is None and is_silent:
                break
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
            self._news_s = now_s
        if now_s - self._synced_s >= SYNC_PERIOD_S:
            self._synced_s = now_s
            self._writer.sync()

    def finish(self) -> None:
        """Write the last ticks and the end."""
        self.collect()
        self._writer.append(self._next_number, self._lost, _NO_TICKS)
        self._writer.sync()


class Status(enum.IntEnum):
    """How the process ends; 1 and 2 are the interpreter's own."""

    DONE = 0
    FULL = 3
    REMOVED = 4
    FAILED = 5


_REASONS: dict[int, Message] = {
    Status.FULL: Message(
        "the record is not complete: the disk is full, or the file as large as it may be"
    ),
    Status.REMOVED: Message("the record is not complete: its file was removed"),
    Status.FAILED: Message("the record is not complete: its file could not be written"),
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
    parser.add_argument("--block", type=int, required=True, help="descriptor")
    parser.add_argument(
        "--file",
        required=True,
        help="descriptor of a record with its header, or the path of a new one",
    )
    parser.add_argument("--loop-pidfd", type=int, help="descriptor")
    options = parser.parse_args(argv)
    # the end is the loop's end, whatever happens to the player
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    os.nice(NICENESS)
    try:
        writer = _writer_of(options.file)
        Recorder(SystemClock(), SharedBlock(options.block), writer).run(
            options.loop_pidfd
        )
    except (OSError, ValueError, InputError) as problem:
        with contextlib.suppress(OSError):  # the player may be gone, and its stderr
            sys.stderr.write(f"{parser.prog}: recording has ended: {problem}\n")
            sys.stderr.flush()
        code = problem.errno if isinstance(problem, OSError) else None
        return _STATUS_OF.get(code or 0, Status.FAILED)
    return Status.DONE


def _writer_of(file: str) -> RecordWriter:
    if file.isdecimal():
        return RecordWriter(int(file))
    writer = RecordWriter(open_record(Path(file)))
    writer.begin({})
    return writer


if __name__ == "__main__":
    sys.exit(main())
