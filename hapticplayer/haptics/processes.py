"""The owner of the haptics processes: the player's side of the loop."""

import contextlib
import enum
import os
import socket
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.devices import FAULTS, NO_DEVICE, DeviceEntry, find_device
from hapticplayer.errors import DeviceError, HapticsError, Message, UsageError
from hapticplayer.extension import load
from hapticplayer.haptics.lifeline import hold_lifeline
from hapticplayer.haptics.live import ScaledForce
from hapticplayer.haptics.messages import MessageKind, MessageSocket, signal_alarm
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.spawn import (
    Process,
    run_module,
    start_device,
    start_guard,
    wait_for_end,
)
from hapticplayer.haptics.track import to_shared_memory
from hapticplayer.linux import DEVICE_PRIORITY, Scheduling, anonymous_memory, grant
from hapticplayer.model import ForceTrack, PlaybackClock, RigTrack
from hapticplayer.model.device import ChannelLevel

if TYPE_CHECKING:
    from hapticplayer.haptics.recorder import LoopRecording

Signal = ForceTrack | RigTrack | ScaledForce
"""What a loop plays."""

GUARD_LATE_S = 0.1  # it beats every 19 ms; only then the kernel is asked about it


class Health(enum.StrEnum):
    """State of the process as the player sees it."""

    NONE = ""  # no device
    STARTING = "starting"
    READY = "ready"
    FAILED = "failed"
    GONE = "gone"


class HapticsProcesses:
    """Owns the 1 kHz loop, its guard, a simulated device and the recorder.

    Args:
        clock: for waiting and for the first heartbeat.
        device: name of the device, see `hapticplayer.devices`; "none" starts nothing.
        scheduling: of the loop; None for the best there is.
        record: a new file for every tick of the loop; None records nothing.
        device_options: command line of the process that simulates the device.
        device_descriptors: descriptors that these options name.
        takes_faults: whether `inject` may be called; for simulated devices only.

    Raises:
        UsageError: when a real device shall take faults.
        DeviceError: when this version has no driver for the device.
        InputError: when the record cannot be created.
        HapticsError: when a process cannot be started.
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
        self.device, self.health = device, Health.NONE
        self.scheduling = self.problem = self.notice = ""
        self._clock, self._wanted_scheduling = clock, scheduling
        self._tail, self._next_track_id = 0, 1
        self._release_s = self._rate = 0.0
        self._track_ids: dict[str, int] = {}
        self._is_loop_ready = False
        self._processes: dict[str, Process] = {}
        self._recording: LoopRecording | None = None
        self._line: MessageSocket | None = None
        self._open = contextlib.ExitStack()
        self._device_faults: Any = None
        descriptor = anonymous_memory("hapticplayer-loop", BLOCK_BYTES)
        with contextlib.ExitStack() as stack:
            stack.callback(os.close, descriptor)
            self.block = SharedBlock(descriptor)
            if device == NO_DEVICE:
                return
            entry = find_device(device)
            if takes_faults and not entry.server:
                raise UsageError(
                    "{device} is a real device and does not accept injected faults",
                    device=device,
                )
            self._patience_s, self._release_s = entry.patience_s, entry.release_s
            if record:
                make = load("hapticplayer.haptics.recorder:LoopRecording")
                self._recording = make(record, descriptor)
            if takes_faults:
                act, acted_on = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
                stack.enter_context(acted_on)
                device_options = [*device_options, "--control", str(acted_on.fileno())]
                device_descriptors = [*device_descriptors, acted_on.fileno()]
                self._device_faults = load(f"{FAULTS}.injected:DeviceFaults")(
                    act.detach()
                )
            self.health = Health.STARTING
            self.beat()
            try:
                lines = start_device(stack, entry, device_options, device_descriptors)
                self._start(stack, entry, descriptor, lines)
            except OSError as problem:
                self._wait_for_end()
                raise HapticsError(
                    "the haptics process could not be started: {reason}", reason=problem
                ) from problem

    def _start(
        self,
        stack: contextlib.ExitStack,
        entry: DeviceEntry,
        block: int,
        device: tuple[int, int, Process | None],
    ) -> None:
        for_loop, for_guard, simulator = device
        if simulator is not None:
            self._processes["device"] = simulator
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._line = MessageSocket(ours)
        stack.enter_context(theirs)
        self._end, held = os.pipe()  # which the loop holds open
        stack.callback(os.close, held)
        self._open.callback(os.close, self._end)
        descriptors = {
            "--block": block,
            "--handle": for_loop,
            "--held": held,
            "--line": theirs.fileno(),
            "--lifeline": hold_lifeline(),
            "--alarm": signal_alarm().read_end.fileno(),
        }
        options = ["--device", entry.name]
        if self.takes_faults:
            options += ["--faults"]
        if self._wanted_scheduling is not None:
            options += ["--scheduling", self._wanted_scheduling.value]
        loop = run_module("hapticplayer.haptics", descriptors, options)
        self._processes["loop"] = loop
        self._processes["guard"] = start_guard(entry, self._end, block, for_guard)

    @property
    def pids(self) -> dict[str, int]:
        """Process ids of "loop", "guard" and, where it is simulated, "device"."""
        return {name: process.pid for name, process in self._processes.items()}

    @property
    def record_problem(self) -> str:
        """Why the recording is incomplete, "" while all is well."""
        return self._recording.problem if self._recording else ""

    def wait_ready(self) -> None:
        """Wait for the device to be open."""
        if self.device == NO_DEVICE:
            return
        deadline_s = self._clock.now_s() + self._patience_s
        while self.health is Health.STARTING and self._clock.now_s() < deadline_s:
            self._read_line(timeout_ms=50)
            self._note_guard()
            self.beat()
        if self.health is Health.FAILED:
            raise DeviceError(self.problem)
        if self.health is not Health.READY:
            raise HapticsError(
                "the haptics process did not become ready in time; try again, and run "
                "'hapticplayer doctor' if it fails again"
            )

    def poll(self) -> Health:
        """Read the messages of the loop since, and return the health."""
        while self._read_line():
            pass
        self._note_guard()
        return self.health

    def _note_guard(self) -> None:
        """Wait until loop and guard have started."""
        if self.health is Health.STARTING and self._is_loop_ready:
            if self.block.guard_s() > 0.0:
                self.health = Health.READY
        elif (
            self.health is Health.READY
            and self._clock.now_s() > self.block.guard_s() + GUARD_LATE_S
            and self._processes["guard"].poll() is not None
        ):
            self.problem = Message(
                "the guard of the haptics process has ended, so the force is off; "
                "choose the device again"
            )
            self.health = Health.FAILED

    def beat(self) -> None:
        """Report that the main thread is alive; call it at least at 10 Hz."""
        self.block.beat(self._clock.now_s())

    def load(self, tracks: Mapping[str, Signal]) -> None:
        """Hand over tracks by name, in place of those before."""
        if self._line is None:
            return
        for track_id in self._track_ids.values():
            self._line.send(MessageKind.FORGET, str(track_id))
        self._track_ids.clear()
        for name, track in tracks.items():
            self._track_ids[name] = self._next_track_id
            self._next_track_id += 1
            self.replace(name, track)

    def replace(self, name: str, track: Signal) -> None:
        """Hand over another version of a track, also while it plays.

        The loop plays the old one until the new one is checked (10,000 numbers a tick,
        four a row) and then changes over by 0.05 N a tick; what it refuses leaves the
        old one in place. With further versions meanwhile, the newest is next.
        """
        if self._line is None:
            return
        descriptor = to_shared_memory(track)
        self._line.send(MessageKind.TRACK, str(self._track_ids[name]), descriptor)
        os.close(descriptor)

    def publish(self, clock: PlaybackClock, track: str) -> None:
        """Publish the media position and the name of the track; "" for no track.

        Nothing is published before the loop is ready: until then a simulated device has
        no priority, and would be late under the first force.
        """
        if self.health is Health.READY:
            self.block.write_clock(clock, self._track_ids.get(track, 0))
            if clock.rate and not self._rate:
                self._send(MessageKind.WAKE)
            self._rate = clock.rate

    def stop_force(self) -> None:
        """TRIP: zero at the next tick, until `rearm`."""
        self._insist(MessageKind.STOP)

    def rearm(self) -> None:
        """Let the force fade in again after a TRIP."""
        self._insist(MessageKind.REARM)

    @property
    def takes_faults(self) -> bool:
        """Whether `inject` may be called."""
        return self._device_faults is not None

    def inject(self, fault: str) -> float:
        """Make a fault happen, and return the monotonic time."""
        if self._device_faults is None:
            raise UsageError(
                "faults can only be injected into a simulated device that was opened "
                "for it"
            )
        now_s = self._clock.now_s()
        if not self._device_faults.inject(fault):
            self._send(MessageKind.FAULT, fault)
        return now_s

    def read_ticks(self) -> tuple[NDArray[Any], int]:
        """Return the ticks since the last call (see TICK) and how many were lost."""
        records, self._tail, lost = self.block.read_ticks(self._tail)
        return records, lost

    @property
    def levels(self) -> tuple[ChannelLevel, ...]:
        """How loud the channels of a sound card are; none without a running loop."""
        return self.block.levels() if self.health is Health.READY else ()

    def close(self) -> None:
        """Ramp the force to zero, release the device and end all processes."""
        self._send(MessageKind.QUIT)
        self._wait_for_end()
        if self._line is not None:
            while self._is_loop_ready and self._read_line():
                pass  # what was reported at the end
            self._line.close()
        if self._device_faults is not None:
            self._device_faults.close()
        if self.health not in (Health.FAILED, Health.NONE):
            self.health = Health.GONE

    def _wait_for_end(self) -> None:
        in_order = ("loop", "guard", "device")
        processes = (self._processes.get(name) for name in in_order)
        wait_for_end(processes, self._release_s)
        if self._recording:
            self._recording.finish()
        self._open.close()

    def _insist(self, word: MessageKind) -> None:
        if self._line is not None:
            self._line.insist(word)

    def _send(self, word: MessageKind, text: str = "") -> None:
        if self._line is not None:
            self._line.send(word, text)

    def _read_line(self, timeout_ms: int = 0) -> bool:
        if self._line is None:
            return False
        message = self._line.receive(timeout_ms)
        if message is None:
            if not self._line.is_open and self.health is not Health.FAILED:
                self.health = Health.GONE
            return False
        if message.word is MessageKind.READY:
            self._note_ready(message.text)
        elif message.word is MessageKind.FAILED:
            self.problem = message.text
            if self.health is Health.STARTING:
                self.health = Health.FAILED
        elif message.word is MessageKind.NOTICE:
            self.notice = message.text
        elif message.word is MessageKind.LOST:
            self.problem, self.health = message.text, Health.FAILED
        return True

    def _note_ready(self, scheduling: str) -> None:
        self._is_loop_ready, self.scheduling = True, scheduling
        if "device" in self._processes:
            # only now: while its modules are loaded it computes for 0.3 s, and the
            # window should have a core meanwhile
            device_pid = self._processes["device"].pid
            grant(device_pid, self._wanted_scheduling, DEVICE_PRIORITY)
        if self._recording:
            header = {"device": self.device, "scheduling": scheduling}
            self._recording.start(self._end, header)
