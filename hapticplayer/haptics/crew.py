"""The processes beside the player: the loop, its guard, and a simulated device.

Each survives the death of the others for as long as it takes to leave zero on the
wire: the loop ends when the player's line closes, the guard when the loop has gone,
the simulated device when nobody is left who could command it.
"""

import contextlib
import os
import socket
import subprocess
import sys
from collections.abc import Sequence

from hapticplayer.devices import DeviceEntry
from hapticplayer.haptics.alarm import alarm
from hapticplayer.haptics.lifeline import hold_lifeline
from hapticplayer.haptics.scheduling import DEVICE_PRIORITY, Scheduling, grant

QUIT_TIMEOUT_S = 2.0


class Crew:
    """Starts and ends them.

    Args:
        entry: the device.
        scheduling: of the loop; None for the best there is.
        device_options: for a simulated device: command line of its process.
        device_descriptors: descriptors that these options name.
        takes_faults: whether the loop may be told to go wrong.
    """

    def __init__(
        self,
        entry: DeviceEntry,
        scheduling: Scheduling | None = None,
        device_options: Sequence[str] = (),
        device_descriptors: Sequence[int] = (),
        *,
        takes_faults: bool = False,
    ) -> None:
        self.loop: subprocess.Popen[bytes] | None = None
        self.guard: subprocess.Popen[bytes] | None = None
        self.device: subprocess.Popen[bytes] | None = None
        self._entry, self._scheduling = entry, scheduling
        self._device_options = list(device_options)
        self._device_descriptors = list(device_descriptors)
        self._takes_faults = takes_faults
        self._all: list[subprocess.Popen[bytes]] = []

    def start(self, block: int, line: int) -> None:
        """Start all; the descriptors stay the caller's.

        Raises:
            OSError: when a process cannot be started; call `end`.
        """
        with contextlib.ExitStack() as stack:
            loops, guards = self._start_device(stack)
            shared = ["--block", str(block), "--device", self._entry.name]
            life = hold_lifeline()
            options = [*shared, "--handle", str(loops), "--line", str(line)]
            ear = alarm().ear.fileno()
            options += ["--lifeline", str(life), "--alarm", str(ear)]
            if self._takes_faults:
                options += ["--faults"]
            if self._scheduling is not None:
                options += ["--scheduling", self._scheduling.value]
            passed = [block, loops, line, life, ear]
            self.loop = self._run(
                "hapticplayer.haptics", [*options, "--guarded"], passed
            )
            self._start_guard(self.loop.pid, block, guards)

    def start_around(self, block: int) -> int:
        """Start device and guard only: the loop is this very process.

        Returns:
            the descriptor that a loop would get; it is the caller's.

        Raises:
            OSError: when a process cannot be started; call `end`.
        """
        with contextlib.ExitStack() as stack:
            ours, guards = self._start_device(stack)
            self._start_guard(os.getpid(), block, guards, hold_lifeline())
            self.hasten_device()
            return os.dup(ours)

    def hasten_device(self) -> None:
        """Let a simulated device be in time; once it serves, not while it starts.

        While its modules are loaded it computes for 0.3 s, which nobody waits for:
        the window shall have a core meanwhile.
        """
        if self.device is not None:
            grant(self.device.pid, self._scheduling, DEVICE_PRIORITY)

    def end(self) -> None:
        """Wait for all to end by themselves, and help where they don't."""
        for process in self._all[1:] + self._all[:1]:  # the device is the last to go
            try:
                process.wait(QUIT_TIMEOUT_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def _start_guard(
        self, pid: int, block: int, handle: int, life: int | None = None
    ) -> None:
        watch = os.pidfd_open(pid)
        try:
            options = ["--block", str(block), "--device", self._entry.name]
            options += ["--handle", str(handle), "--loop-pidfd", str(watch)]
            passed = [block, handle, watch]
            if life is not None:  # a loop has it in the block
                options += ["--lifeline", str(life)]
                passed += [life]
            self.guard = self._run("hapticplayer.haptics.guard", options, passed)
        finally:
            os.close(watch)

    def _start_device(self, stack: contextlib.ExitStack) -> tuple[int, int]:
        """Return the descriptors for loop and guard; see `DeviceEntry.server`."""
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        stack.enter_context(ours)
        stack.enter_context(theirs)
        if not self._entry.server:
            return ours.fileno(), theirs.fileno()
        options = ["--line", str(theirs.fileno()), *self._device_options]
        passed = [theirs.fileno(), *self._device_descriptors]
        self.device = self._run(self._entry.server, options, passed)
        return ours.fileno(), ours.fileno()

    def _run(
        self, module: str, options: Sequence[str], passed: Sequence[int]
    ) -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", module, *options],
            pass_fds=passed,
            stdin=subprocess.DEVNULL,
            # the loop needs no algebra, and threads of it would be locked memory
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        )
        self._all.append(process)
        return process
