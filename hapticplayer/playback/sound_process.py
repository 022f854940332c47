"""The player's handle on the process that plays the sound."""

import enum
import socket
import subprocess
from typing import Protocol

from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.haptics.spawn import run_module
from hapticplayer.playback.sound_ring import AudioRing

QUIT_TIMEOUT_S = 0.3


class OutputState(enum.StrEnum):
    """State of an output as the player sees it."""

    OPENING = "opening"
    OPEN = "open"
    FAILED = "failed"  # there is none, but it retries
    GONE = "gone"


class AudioOut(Protocol):
    """Something that empties a ring at its own pace; `problem` is why there is none."""

    name: str
    problem: str

    def poll(self) -> OutputState:
        """Return the state now."""

    def close(self) -> None:
        """Stop and release the device."""


class SoundProcess:
    """A process that plays the ring through PortAudio, from now until `close`.

    It ends with the player however that ends: the line between them closes.

    Raises:
        OSError: when the process cannot be started.
    """

    def __init__(self, ring: AudioRing, device: str = "") -> None:
        self.name = self.problem = ""
        self._state = OutputState.OPENING
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with theirs:
            passed = {"--block": ring.descriptor, "--line": theirs.fileno()}
            module = "hapticplayer.playback.sound_device"
            self._process = run_module(module, passed, [f"--device={device}"])
        self._line = MessageSocket(ours)

    @property
    def pid(self) -> int:
        """Process id, for supervision and measurements."""
        return self._process.pid

    def poll(self) -> OutputState:
        while (message := self._line.receive()) is not None:
            if message.word is MessageKind.READY:
                self.name, self.problem = message.text, ""
                self._state = OutputState.OPEN
            elif message.word is MessageKind.FAILED:
                self.problem, self._state = message.text, OutputState.FAILED
        if not self._line.is_open:
            self._state = OutputState.GONE
        return self._state

    def close(self) -> None:
        """End the process; one that hangs with its sound server is killed."""
        self._line.close()
        self._state = OutputState.GONE
        try:
            self._process.wait(QUIT_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
