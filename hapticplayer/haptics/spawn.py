"""Starts the processes of the haptics side, and waits for their end.

Each survives the death of the others for as long as it takes to leave zero on the
wire: the loop ends when the player's line closes, the guard when the loop has gone,
the simulated device when its last peer has gone.
"""

import contextlib
import os
import socket
import subprocess
import sys
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from hapticplayer.devices import DeviceEntry

QUIT_TIMEOUT_S = 2.0
Process = subprocess.Popen[bytes]


def run_module(
    module: str,
    descriptors: Mapping[str, int],
    options: Sequence[str] = (),
    also: Sequence[int] = (),
    **more: Any,
) -> Process:
    """Start a module as a process that inherits descriptors; raises OSError.

    They are given by the names of their options, but for those that `options` name.
    """
    words = [word for pair in descriptors.items() for word in map(str, pair)]
    return subprocess.Popen(
        [sys.executable, "-P", "-m", module, *words, *options],
        pass_fds=[*descriptors.values(), *also],
        stdin=subprocess.DEVNULL,
        # none of them needs algebra, and its threads would be locked memory
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        **more,
    )


def start_device(
    stack: contextlib.ExitStack,
    entry: DeviceEntry,
    options: Sequence[str] = (),
    descriptors: Sequence[int] = (),
) -> tuple[int, int, Process | None]:
    """Make the line of a device, and start what simulates it.

    Returned are descriptors for the loop and for the guard, see `DeviceEntry.server`,
    which the stack closes in this process; and the process, None for a real device. The
    given descriptors are those that its options name.
    """
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    stack.enter_context(ours)
    stack.enter_context(theirs)
    if not entry.server:
        return ours.fileno(), theirs.fileno(), None
    line = {"--line": theirs.fileno()}
    process = run_module(entry.server, line, options, descriptors)
    return ours.fileno(), ours.fileno(), process


def start_guard(
    entry: DeviceEntry, end: int, block: int, handle: int, lifeline: int | None = None
) -> Process:
    """Start the guard of a process, with a handle from `start_device`.

    `end` is of a pipe that closes when that process has ended. Only a loop has its
    lifeline in the block.
    """
    passed = {"--block": block, "--handle": handle, "--end": end}
    if lifeline is not None:
        passed["--lifeline"] = lifeline
    return run_module("hapticplayer.haptics.guard", passed, ["--device", entry.name])


def wait_for_end(
    processes: Iterable[Process | None], timeout_s: float = QUIT_TIMEOUT_S
) -> None:
    """Wait for each to end by itself, and kill what does not."""
    for process in filter(None, processes):
        try:
            process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
