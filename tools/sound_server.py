"""A PulseAudio server of its own with a null sink, and an ear at the sink's monitor."""

import contextlib
import os
import subprocess
import tempfile
import threading
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import SystemClock

PROGRAMS = ("pulseaudio", "pactl", "parec")
FOUR_CHANNELS = "front-left,front-right,rear-left,rear-right"
RATE_HZ = 48_000
MONITOR_MS = 2
"""The sink renders as far ahead as its listeners allow, and they hear it so early."""
_START_S, _ASK_S = 10.0, 0.05
_READ_FRAMES = 48
_QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


class SoundServer:
    """A server for this user alone.

    Attributes:
        environment: for the programs that shall use it.
        process: of the server.

    Raises:
        OSError: when there is no PulseAudio.
        TimeoutError: when it does not start.
    """

    def __init__(self, folder: str, channels: int = 2) -> None:
        private = dict.fromkeys(
            ("PULSE_RUNTIME_PATH", "PULSE_STATE_PATH", "XDG_RUNTIME_DIR"), folder
        )
        socket = f"{folder}/native"
        self.environment = {**private, "PULSE_SERVER": f"unix:{socket}"}
        self._private = {**private, "HOME": folder}
        self._command = ["pulseaudio", "-n", "--daemonize=no", "--use-pid-file=no"]
        self._command += ["--exit-idle-time=-1", "--disallow-exit=yes"]
        self._command += ["--realtime=no", "--high-priority=no", "-L"]
        self._command += [
            f"module-native-protocol-unix socket={socket} auth-anonymous=1"
        ]
        sink = f"module-null-sink sink_name=null rate={RATE_HZ} channels={channels}"
        if channels == 4:
            sink += f" channel_map={FOUR_CHANNELS}"
        self._command += ["-L", sink]
        self._clock = SystemClock()
        self.start()

    def start(self) -> None:
        """Start it, and wait until it answers."""
        self.process = subprocess.Popen(
            self._command,
            env={**os.environ, **self._private},
            start_new_session=True,
            **_QUIET,
        )
        environment, ask = {**os.environ, **self.environment}, ["pactl", "info"]
        end_s = self._clock.now_s() + _START_S
        while subprocess.run(ask, env=environment, check=False, **_QUIET).returncode:
            if self._clock.now_s() > end_s:
                self.stop()
                raise TimeoutError("the sound server did not start")
            self._clock.sleep_until(self._clock.now_s() + _ASK_S)

    def stop(self) -> None:
        """End it."""
        self.process.terminate()
        self.process.wait()

    def restart(self, after_s: float) -> None:
        """Kill it, and start it again after a while."""
        self.process.kill()
        self.process.wait()
        self._clock.sleep_until(self._clock.now_s() + after_s)
        self.start()


@contextlib.contextmanager
def sound_server(channels: int = 2) -> Iterator[SoundServer]:
    """Run a PulseAudio null sink of 2 or 4 channels."""
    with tempfile.TemporaryDirectory(prefix="hp-sound-") as folder:
        server = SoundServer(folder, channels)
        try:
            yield server
        finally:
            server.stop()


class Monitor:
    """What a sink of four channels plays, with the time at which it was heard.

    It stays for as long as the sink shall wake often: one that nobody listens to sleeps
    for up to 2 s, and what begins then waits.
    """

    def __init__(self, environment: dict[str, str]) -> None:
        self._width = len(FOUR_CHANNELS.split(","))
        command = ["parec", "-d", "null.monitor", "--format=float32le"]
        command += [f"--rate={RATE_HZ}", f"--channels={self._width}"]
        command += [f"--latency-msec={MONITOR_MS}", f"--channel-map={FOUR_CHANNELS}"]
        self._process = subprocess.Popen(
            command, stdout=subprocess.PIPE, env={**os.environ, **environment}
        )
        self._clock = SystemClock()
        self._pieces: list[tuple[float, bytes]] = []
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def _listen(self) -> None:
        pipe = self._process.stdout
        while pipe and (data := pipe.read(4 * self._width * _READ_FRAMES)):
            self._pieces.append((self._clock.now_s(), data))

    def peak(self) -> float:
        """Return the largest of the last millisecond's samples, 0 to 1."""
        if not self._pieces:
            return 0.0
        samples = np.frombuffer(self._pieces[-1][1], np.float32)
        return float(np.abs(samples).max())

    def forget(self) -> None:
        """Start again with what is heard from now on."""
        self._pieces = []

    def heard(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return times (n,), monotonic s, and samples (n, 4) so far.

        The pieces that came soonest tell the time of a sample: others waited.
        """
        pieces = list(self._pieces)
        heard_s = np.array([at_s for at_s, _ in pieces])
        samples = np.concatenate(
            [np.frombuffer(data, np.float32) for _, data in pieces]
        ).reshape(-1, self._width)
        count_s = _READ_FRAMES / RATE_HZ * np.arange(1, len(heard_s) + 1)
        start_s = np.percentile(heard_s - count_s, 2)
        return start_s + np.arange(len(samples)) / RATE_HZ, samples

    def close(self) -> None:
        """End."""
        self._process.kill()
        self._process.wait()
        self._listener.join()
        if self._process.stdout:
            self._process.stdout.close()
