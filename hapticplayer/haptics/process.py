"""The player's handle on the haptics process."""

import enum
import os
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.errors import DeviceError, HapticsError
from hapticplayer.haptics.messages import Line, Word
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.haptics.shared import BLOCK_BYTES, SharedBlock
from hapticplayer.haptics.track import anonymous_memory, to_shared_memory
from hapticplayer.model import ForceTrack, PlaybackClock

READY_TIMEOUT_S = 10.0
QUIT_TIMEOUT_S = 2.0


class Health(enum.StrEnum):
    """State of the process as the player sees it."""

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
        record: a file to hold the shared block; it outlives both processes and
            is readable after a crash. None keeps it in anonymous memory.

    Raises:
        HapticsError: when the process cannot be started.
    """

    def __init__(
        self,
        clock: Clock,
        device: str = "simulated",
        *,
        scheduling: Scheduling | None = None,
        record: Path | None = None,
    ) -> None:
        self.device = device
        self.health = Health.STARTING
        self.scheduling = Scheduling.NORMAL
        self.problem = ""
        self._clock = clock
        self._tail = 0
        self._next_track_id = 1
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        descriptor = _make_block(record)
        self._block = SharedBlock(descriptor)
        self.beat()
        command = [sys.executable, "-P", "-m", "hapticplayer.haptics"]
        command += ["--block", str(descriptor), "--line", str(theirs.fileno())]
        command += ["--device", device]
        if scheduling is not None:
            command += ["--scheduling", scheduling.value]
        try:
            self._process = subprocess.Popen(
                command,
                pass_fds=(descriptor, theirs.fileno()),
                stdin=subprocess.DEVNULL,
                # the loop needs no algebra, and threads of it would be locked memory
                env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            )
        except OSError as problem:
            raise HapticsError(
                f"the haptics process could not be started: {problem}"
            ) from problem
        finally:
            theirs.close()
            os.close(descriptor)
        self._line = Line(ours)

    @property
    def pid(self) -> int:
        """Process id, for supervision and measurements."""
        return self._process.pid

    def wait_ready(self) -> None:
        """Wait for the device to be open.

        Raises:
            DeviceError: with the device's own reason.
            HapticsError: when the process died or said nothing in time.
        """
        deadline_s = self._clock.now_s() + READY_TIMEOUT_S
        while self.health is Health.STARTING and self._clock.now_s() < deadline_s:
            self._read_line(timeout_ms=50)
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
        return self.health

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
        """Say where the media is and which track belongs to it."""
        self._block.write_clock(clock, track_id)

    def stop_force(self) -> None:
        """TRIP: zero at the next tick, until `rearm`."""
        self._line.send(Word.STOP)

    def rearm(self) -> None:
        """Let the force fade in again after a TRIP."""
        self._line.send(Word.REARM)

    def read_ticks(self) -> tuple[NDArray[Any], int]:
        """Return the ticks since the last call (see TICK) and how many were lost."""
        records, self._tail, lost = self._block.read_ticks(self._tail)
        return records, lost

    def close(self) -> None:
        """Bring the force to zero, let go of the device and end the process."""
        self._line.send(Word.QUIT)
        try:
            self._process.wait(QUIT_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._line.close()
        if self.health is not Health.FAILED:
            self.health = Health.GONE

    def _read_line(self, timeout_ms: int = 0) -> bool:
        message = self._line.receive(timeout_ms)
        if message is None:
            if not self._line.is_open and self.health is not Health.FAILED:
                self.health = Health.GONE
            return False
        if message.word is Word.READY:
            self.health = Health.READY
            self.scheduling = Scheduling(message.text)
        elif message.word is Word.FAILED:
            self.problem = message.text
            if self.health is Health.STARTING:
                self.health = Health.FAILED
        return True


def _make_block(record: Path | None) -> int:
    if record is None:
        return anonymous_memory("hapticplayer-loop", BLOCK_BYTES)
    flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
    descriptor = os.open(record, flags, 0o600)
    os.ftruncate(descriptor, BLOCK_BYTES)
    return descriptor
