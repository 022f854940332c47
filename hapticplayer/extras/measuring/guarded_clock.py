"""A guard for programs that command a device without the haptic loop.

Measurements of a device need pauses that no loop would allow. The guard is the one of
the loop: it writes zero when the program dies or stalls.
"""

import contextlib
import os
from collections.abc import Iterator, Sequence

from hapticplayer.clock import Clock
from hapticplayer.devices import find_device
from hapticplayer.errors import HapticsError
from hapticplayer.haptics.contract import GAP_RAMP_S, GUARD_RAMP_S
from hapticplayer.haptics.lifeline import hold_lifeline
from hapticplayer.haptics.messages import close_descriptor
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.spawn import Process, start_device, start_guard, wait_for_end
from hapticplayer.linux import DEVICE_PRIORITY, anonymous_memory, grant

BEAT_S = 0.002
_STARTING_S = 10.0
_CHECK_S = 0.005  # from the guard's check to its zero


class GuardedClock:
    """Starts a guard for this process, and beats whenever the time is read.

    It is the clock of whatever decides about a force, within `force()`: code that does
    not read the time there for 20 ms has stalled. Never give it to another thread, such
    as a driver's, which would beat for a dead one.

    Raises:
        DeviceError: when there is no such device.
        HapticsError: when the guard does not start.
    """

    def __init__(
        self,
        clock: Clock,
        device: str,
        device_options: Sequence[str] = (),
        device_descriptors: Sequence[int] = (),
    ) -> None:
        self._clock = clock
        self._is_acting, self._beat_s, self._was_disturbed = False, 0.0, False
        self._guard: Process | None = None
        self._simulator: Process | None = None
        self._held = -1  # open until the end of this process
        entry = find_device(device)
        block = anonymous_memory("hapticplayer-watched", BLOCK_BYTES)
        with contextlib.ExitStack() as stack:
            stack.callback(os.close, block)
            self._block = SharedBlock(block)
            try:
                ours, for_guard, self._simulator = start_device(
                    stack, entry, device_options, device_descriptors
                )
                if self._simulator is not None:
                    grant(self._simulator.pid, None, DEVICE_PRIORITY)
                end, self._held = os.pipe()
                stack.callback(os.close, end)
                self._guard = start_guard(entry, end, block, for_guard, hold_lifeline())
                self._handle = os.dup(ours)
            except OSError as problem:
                self._end()
                raise HapticsError(
                    "the guard could not be started: {reason}", reason=problem
                ) from problem
        self._wait_for_the_guard()

    @property
    def guard_pid(self) -> int | None:
        """Process id of the guard."""
        return self._guard.pid if self._guard else None

    def handle(self) -> int:
        """Return a new descriptor of what a loop gets; it is the caller's."""
        return os.dup(self._handle)

    @contextlib.contextmanager
    def force(self) -> Iterator[None]:
        """Make the guard expect beats in this block."""
        self._is_acting, self._beat_s = True, self._clock.now_s()
        try:
            yield
        finally:
            self._is_acting = False
            self._block.beat_loop(0.0)

    def now_s(self) -> float:
        """Return the time, and beat."""
        now_s = self._clock.now_s()
        if self._is_acting:
            if now_s - self._block.guard_s() > GUARD_RAMP_S:
                raise HapticsError("the guard has ended; measure again")
            if now_s - self._beat_s > GAP_RAMP_S - _CHECK_S:
                self._was_disturbed = True
            self._beat_s = now_s
            self._block.beat_loop(now_s)
        return now_s

    def was_disturbed(self) -> bool:
        """Whether the guard may have sent a zero since the last call: we stalled."""
        was, self._was_disturbed = self._was_disturbed, False
        return was

    def sleep_until(self, deadline_s: float) -> None:
        """Wait, and beat meanwhile."""
        while (now_s := self.now_s()) < deadline_s:
            self._clock.sleep_until(min(deadline_s, now_s + BEAT_S))

    def close(self) -> None:
        """End the guard; the device has been left at zero before."""
        os.close(self._handle)
        self._end()

    def _end(self) -> None:
        if self._guard is not None:
            self._guard.kill()  # it ends only with this process, and ignores signals
        wait_for_end((self._guard, self._simulator))
        close_descriptor(self._held)
        self._held = -1

    def _wait_for_the_guard(self) -> None:
        end_s = self._clock.now_s() + _STARTING_S
        while self._block.guard_s() == 0.0:
            guard = self._guard
            has_ended = guard is None or guard.poll() is not None
            if has_ended or self._clock.now_s() > end_s:
                self.close()
                raise HapticsError(
                    "the guard did not start, so nothing is measured; run "
                    "'hapticplayer doctor'"
                )
            self._clock.sleep_until(self._clock.now_s() + BEAT_S)
