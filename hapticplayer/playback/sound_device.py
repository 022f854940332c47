"""The sound output itself: `python -m hapticplayer.playback.sound_device`.

Runs in a process of its own, so that neither a window that holds the interpreter nor
PortAudio, which hangs where its server does, stops anything else. PortAudio's time of
the DAC was measured to be exact within 0.1 ms, where counting what was handed to the
server is 16 ms off; only after the server has stopped for a moment is it wrong (see `DacClock`).
The stream always runs and plays silence while paused: restarting it costs up to 260 ms
and the first sound.
"""

import argparse
import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
from typing import Any

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import message_of
from hapticplayer.haptics.messages import MessageKind, MessageSocket
from hapticplayer.linux import Scheduling, grant, lock_memory
from hapticplayer.playback.sound_memory import CHANNELS, SoundBlock, SoundReader

NEAR_S = 0.002
"""So near, stated times move the line: clocks differ by up to some 100 ppm."""
FOLLOWS_WITHIN_S = 1.0
STEADY_S, STEADY_WITHIN_S = 2.0, 0.0015
"""Times that leave the line by the same for so long are true: another output."""
AGREED_S, LONGEST_HELD_S = 0.5, 12.0
"""Where times have not agreed with the line and each other for so long within so long,
the output is one whose times just jitter."""

LATENCY_S = 0.120
BLOCK_S = 0.040
"""How much is asked for at once. PortAudio's own choice, 25 ms, wakes this process and
the server's client a third more often, for nothing: what lies ahead is the latency."""
MAX_AHEAD_S = 1.0
SERVERS = ("default", "pulse", "pipewire")
"""What ALSA calls them: headphones and loudspeakers have the same name there."""
SERVER_ANSWERS_S = 0.5
LONGEST_NAME = 200
RETRY_S, SLOWEST_RETRY_S = 0.5, 5.0


class DacClock:
    """Tells when each block sounds: by the count of the samples, checked against the DAC.

    A sound server that stops for 30 to 100 ms states times that are off by 10 to 30 ms
    for some ten seconds afterwards, while not one sample is late (its client fits a
    line to few answers). The samples themselves tell the time without a break, except
    where the output ran dry, which it reports. So a stated time that leaves their line
    is used only once it is steady.
    """

    def __init__(self, rate_hz: int) -> None:
        self._rate_hz = rate_hz
        self._handed = 0  # samples, before this block
        self._line_s: float | None = None  # when sample 0 sounded
        self._agreed_s = 0.0  # when stated times were last on it
        self._since_s = self._least_s = self._most_s = 0.0  # of times that agree

    @property
    def is_known(self) -> bool:
        """Whether the samples have a line; else stated times are passed on."""
        return self._line_s is not None

    def place(
        self, now_s: float, stated_s: float, count: int, *, ran_dry: bool = False
    ) -> tuple[float, float]:
        """Take the next block of `count` samples, for which the output asks at `now_s`.

        The output says that it sounds at `stated_s`, and whether it had nothing left
        before.

        Returns:
            The monotonic time at which it sounds, and how much silence the output has
            put in before it, as far as that is known, s.
        """
        elapsed_s = self._handed / self._rate_hz
        offset_s = stated_s - elapsed_s
        if self._handed:
            self._follow_run(now_s, offset_s)
        else:
            self._begin_run(now_s, offset_s)
        self._handed += count
        if self._line_s is None:
            if self._have_agreed(now_s, STEADY_S):
                self._line_s, self._agreed_s = offset_s, now_s
            return stated_s, 0.0
        expected_s = self._line_s + elapsed_s
        if ran_dry:  # it restarts, and the first time that it states is right
            self._line_s, self._agreed_s = offset_s, now_s
            return stated_s, max(0.0, stated_s - expected_s)
        if now_s >= expected_s:
            self._line_s = None
            return stated_s, 0.0
        off_s = offset_s - self._line_s
        if abs(off_s) <= NEAR_S:
            share = count / self._rate_hz / FOLLOWS_WITHIN_S
            self._line_s += min(1.0, share) * off_s
            if self._have_agreed(now_s, AGREED_S):
                self._agreed_s = now_s
        elif self._have_agreed(now_s, STEADY_S):
            self._line_s = 0.5 * (self._least_s + self._most_s)
        if now_s > self._agreed_s + LONGEST_HELD_S:
            self._line_s = None
            return stated_s, 0.0
        return self._line_s + elapsed_s, 0.0

    def _follow_run(self, now_s: float, offset_s: float) -> None:
        """Note for how long the stated times have agreed with each other."""
        least_s, most_s = min(self._least_s, offset_s), max(self._most_s, offset_s)
        if most_s - least_s > STEADY_WITHIN_S:
            self._begin_run(now_s, offset_s)
        else:
            self._least_s, self._most_s = least_s, most_s

    def _begin_run(self, now_s: float, offset_s: float) -> None:
        self._since_s, self._least_s, self._most_s = now_s, offset_s, offset_s

    def _have_agreed(self, now_s: float, so_long_s: float) -> bool:
        return now_s - self._since_s >= so_long_s


class SoundStream:
    """A stream through PortAudio that empties a block; "" is the default device.

    Raises:
        OSError: when PortAudio is missing or there is no device.
    """

    def __init__(self, block: SoundBlock, clock: Clock, device: str = "") -> None:
        import sounddevice

        self._reader = SoundReader(block)
        self._dac = DacClock(block.rate_hz)
        self._clock = clock
        try:
            self._stream = sounddevice.RawOutputStream(
                device=device or None,
                samplerate=block.rate_hz,
                channels=CHANNELS,
                dtype="float32",
                blocksize=round(BLOCK_S * block.rate_hz),
                latency=LATENCY_S,
                callback=self._callback,
            )
            self._stream.start()
        except (sounddevice.PortAudioError, ValueError) as problem:
            # PortAudio lists the devices once; the next try shall see new ones
            sounddevice._terminate()  # noqa: SLF001 - no other way
            sounddevice._initialize()  # noqa: SLF001
            raise OSError(message_of(problem)) from problem
        name = str(sounddevice.query_devices(self._stream.device)["name"])
        self.name = f"{name} ({sink})" if (sink := _sink_behind(name)) else name

    def _callback(self, out: Any, frames: int, time_info: Any, status: Any) -> None:
        now_s = self._clock.now_s()
        # PortAudio's own clock is CLOCK_REALTIME on Linux, which a time server may
        # move: only the difference within one callback is used
        ahead_s = time_info.outputBufferDacTime - time_info.currentTime
        ahead_s = min(max(ahead_s, 0.0), MAX_AHEAD_S)  # some drivers say nonsense
        dac_s, silence_s = self._dac.place(
            now_s, now_s + ahead_s, frames, ran_dry=status.output_underflow
        )
        self._reader.render(memoryview(out), dac_s, silence_s)


def sound_outputs() -> list[str]:
    """Return the names of the outputs that there are, without the default's alias."""
    try:
        import sounddevice

        known = sounddevice.query_devices()
    except Exception:  # noqa: BLE001 - PortAudio is missing or broken: there are none
        return []
    names = [str(one["name"]) for one in known if one["max_output_channels"] > 0]
    return list(dict.fromkeys(names))


def _sink_behind(name: str) -> str:
    """Return which output of the sound server a name of no device leads to, or ""."""
    pactl = shutil.which("pactl")
    if name not in SERVERS or pactl is None:
        return ""
    try:
        asked = subprocess.run(
            [pactl, "get-default-sink"],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=SERVER_ANSWERS_S,
            check=True,
            text=True,
        )
    except (OSError, subprocess.SubprocessError):
        return ""  # the latency is kept by the server's name then
    return asked.stdout.strip()[:LONGEST_NAME]


def main(argv: list[str] | None = None) -> int:
    """Open the output, say READY, and play until the player hangs up."""
    parser = argparse.ArgumentParser(prog="hapticplayer.playback.sound_device")
    parser.add_argument("--block", type=int, required=True, help="descriptor")
    parser.add_argument("--line", type=int, required=True, help="descriptor")
    parser.add_argument("--device", default="")
    options = parser.parse_args(argv)
    # Ctrl-C and a hang-up reach the whole group: the player decides, and if it
    # dies of them, the closed line tells
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT):
        signal.signal(number, signal.SIG_IGN)
    _quieten()
    line = MessageSocket(socket.socket(fileno=options.line))
    grant(0, Scheduling.SLICE)  # its threads inherit it
    player = threading.Thread(target=_end_with_the_player, args=[line], daemon=True)
    player.start()
    stream = _open(SoundBlock(options.block), SystemClock(), options.device, line)
    lock_memory()
    line.send(MessageKind.READY, stream.name)
    player.join()
    return 0


def _end_with_the_player(line: MessageSocket) -> None:
    """End this process whatever it hangs in; the sound server drops what is buffered."""
    while line.is_open:
        line.receive(timeout_ms=-1)
    os._exit(0)


def _open(
    block: SoundBlock, clock: Clock, device: str, line: MessageSocket
) -> SoundStream:
    """Return the stream as soon as there is a device for it."""
    wait_s = RETRY_S
    while True:
        try:
            return SoundStream(block, clock, device)
        except OSError as problem:
            line.send(MessageKind.FAILED, message_of(problem))
        clock.sleep_until(clock.now_s() + wait_s)
        wait_s = min(1.5 * wait_s, SLOWEST_RETRY_S)


def _quieten() -> None:
    """Let only Python itself write to stderr: ALSA and PortAudio talk at each try."""
    with contextlib.suppress(OSError):
        sys.stderr = os.fdopen(os.dup(2), "w", buffering=1)
        silence = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 2)
        os.close(silence)


if __name__ == "__main__":
    sys.exit(main())
