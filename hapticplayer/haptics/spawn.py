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
from collections.abc import Iterable, Sequence
from typing import Any

from hapticplayer.devices import DeviceEntry

QUIT_TIMEOUT_S = 2.0
Process = subprocess.Popen[bytes]


def run_module(
    module: str, options: Sequence[str], descriptors: Sequence[int], **more: Any
) -> Process:
    """Start a module as a process that inherits some descriptors; raises OSError."""
    return subprocess.Popen(
        [sys.executable, "-P", "-m", module, *options],
        pass_fds=descriptors,
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

    The stack closes the line's ends in this process; the descriptors are those that the
    options of the simulating process name.

    Returns:
        descriptors for the loop and for the guard, see `DeviceEntry.server`; the
        process, None for a real device.
    """
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    stack.enter_context(ours)
    stack.enter_context(theirs)
    if not entry.server:
        return ours.fileno(), theirs.fileno(), None
    line = theirs.fileno()
    passed = [line, *descriptors]
    process = run_module(entry.server, ["--line", str(line), *options], passed)
    return ours.fileno(), ours.fileno(), process


def start_guard(
    entry: DeviceEntry, pid: int, block: int, handle: int, lifeline: int | None = None
) -> Process:
    """Start the guard of the process `pid`, with a handle from `start_device`.

    Only a loop has its lifeline in the block.
    """
    watch = os.pidfd_open(pid)
    try:
        options = ["--block", str(block), "--device", entry.name]
        options += ["--handle", str(handle), "--loop-pidfd", str(watch)]
        passed = [block, handle, watch]
        if lifeline is not None:
            options += ["--lifeline", str(lifeline)]
            passed += [lifeline]
        return run_module("hapticplayer.haptics.guard", options, passed)
    finally:
        os.close(watch)


def wait_for_end(
    processes: Iterable[Process | None], timeout_s: float = QUIT_TIMEOUT_S
) -> None:
    """Wait for each to end by itself, and kill what does not."""
    for process in processes:
        if process is None:
            continue
        try:
            process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
