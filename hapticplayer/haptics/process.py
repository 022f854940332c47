"""The player's handle on the haptics process."""

import enum
import os
import socket
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import find_device, load
from hapticplayer.errors import (
    DeviceError,
    HapticsError,
    InputError,
    Message,
    UsageError,
)
from hapticplayer.haptics.crew import Crew
from hapticplayer.haptics.messages import Line, Word
from hapticplayer.haptics.recorder import Recording
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.track import anonymous_memory, to_shared_memory
from hapticplayer.model import ForceTrack, PlaybackClock

GUARD_LATE_S = 0.1  # it beats every 19 ms; only then the kernel is asked about it


class Health(enum.StrEnum):
    """State of the process as the player sees it."""

    NONE = ""  # no device
    STARTING = "starting"
    READY = "ready"
    FAILED = "failed"
    GONE = "gone"


class HapticsProcess:
    """Starts the 1 kHz process, feeds it tracks and clocks, and reads its ticks.

    Args:
        clock: for waiting and for the first heartbeat.
        device: name of the device, see `hapticplayer.devices`.
        scheduling: None for the best there is.
        record: a new file for every tick of the loop; None records nothing.
        device_options: command line of the process that simulates the device.
        device_descriptors: descriptors that these options name.
        takes_faults: whether `inject` may be called; for simulated devices only.

    Raises:
        UsageError: when a real device shall take faults.
        DeviceError: when this version has no driver for the device.
        InputError: when the record cannot be created.
        HapticsError: when the process cannot be started.
    """

    def __init__(  # noqa: PLR0913 - two of them only simulated devices know
        self,
        clock: Clock,
        device: str = "simulated",
        *,
        scheduling: Scheduling | None = None,
        record: Path | None = None,
        device_options: Sequence[str] = (),
        device_descriptors: Sequence[int] = (),
        takes_faults: bool = False,
    ) -> None:
        self.device = device
        self._device_faults: Any = None
        self.health = Health.STARTING
        self.scheduling = Scheduling.NORMAL
        self.problem = ""
        self._clock = clock
        self._tail = 0
        self._next_track_id = 1
        self._is_loop_ready = False
        entry = find_device(device)
        if takes_faults and not entry.faults:
            raise UsageError(
                "{device} is a real device and takes no faults", device=device
            )
        self._patience_s = entry.patience_s
        descriptor = anonymous_memory("hapticplayer-loop", BLOCK_BYTES)
        try:
            self._recording = Recording(record, descriptor) if record else None
        except InputError:
            os.close(descriptor)
            raise
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._block = SharedBlock(descriptor)
        self.beat()
        act, acted_on = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        if takes_faults:
            device_options = [*device_options, "--control", str(acted_on.fileno())]
            device_descriptors = [*device_descriptors, acted_on.fileno()]
            self._device_faults = load(f"{entry.faults}:DeviceFaults")(act.detach())
        self._crew = Crew(
            entry,
            scheduling,
            device_options,
            device_descriptors,
            takes_faults=takes_faults,
        )
        try:
            self._crew.start(descriptor, theirs.fileno())
        except OSError as problem:
            self._crew.end()
            if self._recording:
                self._recording.finish()
            raise HapticsError(
                "the haptics process could not be started: {reason}", reason=problem
            ) from problem
        finally:
            for end in (theirs, act, acted_on):
                end.close()
            os.close(descriptor)
        self._line = Line(ours, outbox=self._block.outbox)

    @property
    def pid(self) -> int:
        """Process id, for supervision and measurements."""
        assert self._crew.loop is not None  # started, or the constructor has raised
        return self._crew.loop.pid

    @property
    def record_problem(self) -> str:
        """Why the record is not complete, "" while all is well."""
        return self._recording.problem if self._recording else ""

    def wait_ready(self) -> None:
        """Wait for the device to be open.

        Raises:
            DeviceError: with the device's own reason.
            HapticsError: when the process died or said nothing in time.
        """
        deadline_s = self._clock.now_s() + self._patience_s
        while self.health is Health.STARTING and self._clock.now_s() < deadline_s:
            self._read_line(timeout_ms=50)
            self._note_guard()
            self.beat()
        if self.health is Health.FAILED:
            raise DeviceError(self.problem)
        if self.health is not Health.READY:
            raise HapticsError(
                "the haptics process did not become ready; try again, "
                "and run 'hapticplayer doctor' if it stays so"
            )

    def poll(self) -> Health:
        """Read what the process has said since, and return its health."""
        while self._read_line():
            pass
        self._note_guard()
        return self.health

    def _note_guard(self) -> None:
        """Without a guard that watches, nothing is ready."""
        guard = self._crew.guard
        if self.health is Health.STARTING and self._is_loop_ready:
            if self._block.guard_s() > 0.0:
                self.health = Health.READY
        elif (
            self.health is Health.READY
            and guard is not None
            and self._clock.now_s() > self._block.guard_s() + GUARD_LATE_S
            and guard.poll() is not None
        ):
            self.problem = Message(
                "the guard of the haptics process has ended, so there is no force; "
                "choose the device again"
            )
            self.health = Health.FAILED

    def beat(self) -> None:
        """Tell the loop that the main thread is alive; call it at least at 10 Hz."""
        self._block.beat(self._clock.now_s())

    def load_track(self, track: ForceTrack) -> int:
        """Hand over a track and return the id under which a clock can play it."""
        track_id = self._next_track_id
        self._next_track_id += 1
        descriptor = to_shared_memory(track)
        self._line.send(Word.TRACK, str(track_id), descriptor)
        os.close(descriptor)
        return track_id

    def forget_track(self, track_id: int) -> None:
        """Let the process release a track."""
        self._line.send(Word.FORGET, str(track_id))

    def publish(self, clock: PlaybackClock, track_id: int) -> None:
        """Say where the media is and which track belongs to it.

        Nothing is said before the process is ready: until it is known to be, a
        simulated device has no priority, and would be late under the first force.
        """
        if self.health is Health.READY:
            self._block.write_clock(clock, track_id)

    def stop_force(self) -> None:
        """TRIP: zero at the next tick, until `rearm`."""
        self._line.send(Word.STOP)

    def rearm(self) -> None:
        """Let the force fade in again after a TRIP."""
        self._line.send(Word.REARM)

    @property
    def takes_faults(self) -> bool:
        """Whether `inject` may be called."""
        return self._device_faults is not None

    def inject(self, fault: str) -> float:
        """Make a fault happen, and return the monotonic time.

        Raises:
            UsageError: when this process was not started to take faults.
            DeviceError: when the simulated device is gone.
        """
        if self._device_faults is None:
            raise UsageError(
                "faults are only for simulated devices that were chosen with them"
            )
        now_s = self._clock.now_s()
        if not self._device_faults.inject(fault):
            self._line.send(Word.FAULT, fault)
        return now_s

    def read_ticks(self) -> tuple[NDArray[Any], int]:
        """Return the ticks since the last call (see TICK) and how many were lost."""
        records, self._tail, lost = self._block.read_ticks(self._tail)
        return records, lost

    def close(self) -> None:
        """Bring the force to zero, let go of the device and end the process."""
        self._line.send(Word.QUIT)
        self._crew.end()
        if self._recording:
            self._recording.finish()
        self._line.close()
        if self._device_faults is not None:
            self._device_faults.close()
        if self.health is not Health.FAILED:
            self.health = Health.GONE

    def _read_line(self, timeout_ms: int = 0) -> bool:
        message = self._line.receive(timeout_ms)
        if message is None:
            if not self._line.is_open and self.health is not Health.FAILED:
                self.health = Health.GONE
            return False
        if message.word is Word.READY:
            self._is_loop_ready = True
            self.scheduling = Scheduling(message.text)
            self._crew.hasten_device()  # the loop has opened it: it serves
            if self._recording:
                header = {"device": self.device, "scheduling": self.scheduling.value}
                self._recording.start(self.pid, header)
        elif message.word is Word.FAILED:
            self.problem = message.text
            if self.health is Health.STARTING:
                self.health = Health.FAILED
        elif message.word is Word.LOST:
            self.problem, self.health = message.text, Health.FAILED
        return True
