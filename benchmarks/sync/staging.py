"""What `outside` plays and watches with: clips, the player, and the watchers.

Clips flash, beep and push at the same moments. The rest are processes of their own. The
player is the real window with the real player; it does what the case says, and prints the
player's own summary as JSON. The watchers run until their input closes, on
CLOCK_MONOTONIC: `pixel` reads a pixel near the middle of Xvfb's memory at 1 kHz and notes
when it changes between black and white; `sound` records the monitor of the null sink with
the time of each read; `beeps` plays beeps through libpulse and writes when PulseAudio says
that they sound: what the recorder hears earlier or later than that is its own constant (a
monitor hands samples out a block before they are played).
"""

import array
import contextlib
import ctypes
import os
import select
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import ROOT
from benchmarks.stage import HEIGHT, RATE_HZ, WIDTH, pixel_reader

Floats = NDArray[np.float64]
PERIOD_S = 0.5
FLASH_FRAMES, PATCH_PX = 3, 300
SOUND_HZ, BEEP_HZ, BEEP_S, BEEP_LEVEL = 48_000, 1000.0, 0.1, 0.5
FORCE_N = 1.0  # the limiter lets that much through in one tick
LATE_SOUND_S = 1.75
LOOP_S, LOOPS = 64.0, 19  # whole packets of sound, and 20 minutes


def base_clip(folder: Path, seconds: float) -> Path:
    """Write a 720p30 clip with a flash and a beep every half second."""
    from hapticplayer.media.encode import write_clip

    path = folder / "sync.mp4"
    if not path.exists():
        sound = np.zeros((round(seconds * SOUND_HZ), 2), dtype=np.float32)
        tone = beep()[:, None]
        for at_s in _moments(seconds):
            first = round(at_s * SOUND_HZ)
            sound[first : first + len(tone)] = tone
        write_clip(path, _frames(seconds), frame_rate_hz=RATE_HZ, audio=sound)
    return path


def beep() -> Floats:
    """Return a beep, at its full level at once."""
    t = np.arange(round(BEEP_S * SOUND_HZ)) / SOUND_HZ
    return np.asarray(BEEP_LEVEL * np.sin(2.0 * np.pi * BEEP_HZ * t))


def force_file(folder: Path, seconds: float) -> Path:
    """Write the pushes that belong to it, upwards."""
    rows = ["time_s,fx_n,fy_n,fz_n", "0,0,0,0"]
    for at_s in _moments(seconds):
        rows += [f"{at_s:.4f},0,{FORCE_N},0", f"{at_s + BEEP_S:.4f},0,0,0"]
    path = folder / "force.csv"
    path.write_text("\n".join(rows) + "\n")
    return path


def variant(kind: str, clip: Path) -> Path:
    """Return a relative of the base clip: silent, vfr, late or long."""
    options = {
        "long": ["-stream_loop", str(LOOPS - 1), "-i", str(clip), "-c", "copy"],
        "silent": ["-i", str(clip), "-c", "copy", "-an"],
        # frames are left out here and there, never one that begins a flash
        "vfr": [
            *("-i", str(clip), "-vf", "select=not(mod(n\\,15))+gt(random(1)\\,0.4)"),
            *("-fps_mode", "vfr", "-preset", "veryfast", "-c:a", "copy"),
        ],
        "late": [
            *("-i", str(clip), "-ss", str(LATE_SOUND_S), "-itsoffset"),
            *(str(LATE_SOUND_S), "-i", str(clip), "-map", "0:v", "-map", "1:a"),
            *("-c:v", "copy", "-c:a", "aac"),
        ],
    }[kind]
    path = clip.with_stem(kind)
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", *options, str(path)]
    subprocess.run(command, check=True)
    return path


def _moments(seconds: float) -> Floats:
    return np.arange(PERIOD_S, seconds - BEEP_S, PERIOD_S)


def _frames(seconds: float) -> Iterator[NDArray[Any]]:
    """Yield textures that move around a patch that flashes."""
    texture = np.random.default_rng(1).integers(40, 200, (HEIGHT // 8, WIDTH // 8, 3))
    texture = np.kron(texture, np.ones((8, 8, 1))).astype(np.uint8)
    top, left = (HEIGHT - PATCH_PX) // 2, (WIDTH - PATCH_PX) // 2
    per_period = round(PERIOD_S * RATE_HZ)
    for number in range(round(seconds * RATE_HZ)):
        frame = np.roll(texture, (2 * number, 5 * number), (0, 1))
        is_white = number >= per_period and number % per_period < FLASH_FRAMES
        frame[top : top + PATCH_PX, left : left + PATCH_PX] = 255 if is_white else 0
        yield frame


# --- the player -------------------------------------------------------------------

SEEKS = 50
FREEZE_S = 2.0
HELD_S = 0.5
Steps = Iterator[float]


class Case:
    """What a case does: each is a generator of the seconds until its next step."""

    def __init__(self, window: Any, seconds: float) -> None:
        self._window, self._player, self._seconds = window, window.player, seconds
        self.hung: list[tuple[float, float]] = []  # spans in which nothing is in time

    def of(self, case: str) -> Steps:
        if case.startswith("speed-"):
            return self._speed(float(case.removeprefix("speed-")))
        return getattr(self, f"_{case}", lambda: iter(()))()

    def _pause(self) -> Steps:
        while True:
            yield 2.2
            self._player.pause()
            yield 0.7
            self._player.play()

    def _seek(self) -> Steps:
        for number in range(SEEKS):
            yield 1.0
            moment = (7 * number) % round((self._seconds - 4.0) / PERIOD_S)
            self._player.seek((moment + 0.5) * PERIOD_S)

    def _speed(self, rate: float) -> Steps:
        yield 0.0
        self._player.set_speed(rate)

    def _freeze(self) -> Steps:
        yield from self._hang(lambda: time.sleep(FREEZE_S))

    def _hold(self) -> Steps:
        """Sleep without letting any other thread of the interpreter run meanwhile."""
        usleep = ctypes.PyDLL(None).usleep
        yield from self._hang(lambda: usleep(round(1e6 * FREEZE_S)))

    def _hang(self, hang: Callable[[], object]) -> Steps:
        """Hang, then let a person re-arm."""
        while True:
            yield 4.0
            begin_s = time.monotonic()
            hang()
            yield 0.5
            self._window.session.rearm()
            yield 0.3
            self.hung.append((begin_s, time.monotonic()))


def play_case(clip: str, force: str, record: str, name: str, seconds: str) -> None:
    """Play to the end."""
    from PySide6.QtCore import QTimer

    from benchmarks.window import open_window, say, with_device_options
    from hapticplayer.playback.source import open_source

    device = ("--hand", "firm", "--record", record)
    haptics = with_device_options(*device, descriptors=[int(record)])
    settings, shown = Path(clip).parent / "settings.json", {"fullscreen": True}
    opened = open_window(settings, sound=True, plots=False, haptics=haptics, **shown)
    window, player = opened.window, opened.player
    player.poll()
    window.session.show_source(open_source(clip, force))
    player.play()
    case = Case(window, float(seconds))
    steps, timer = case.of(name), QTimer(singleShot=True)

    def go_on() -> None:
        wait_s = next(steps, None)
        if wait_s is not None:
            timer.start(round(1e3 * wait_s))

    def end() -> None:
        window.close()
        opened.application.quit()

    timer.timeout.connect(go_on)
    timer.start(1500)
    QTimer.singleShot(round(1e3 * (float(seconds) + HELD_S)), end)
    opened.application.exec()
    notices = player.snapshot().notices
    say(**{**player.summary(), "notices": notices, "hung": case.hung})


# --- the watchers -----------------------------------------------------------------

POLL_S, BLIND_S = 0.001, 0.004
PRIORITY = 70  # above the loop's guard: the watcher must not be what is late
ONSET_LEVEL = 0.12  # of full scale: a quarter of the beep, after 0.04 ms of a sine
SHORTEST_FLASH_S, LONGEST_FLASH_S = 0.04, 0.45
QUIET_S = 0.05  # before an onset
MONITOR_LATENCY_MS = 4


@contextlib.contextmanager
def watcher(
    *arguments: str, environment: dict[str, str] | None = None
) -> Iterator[None]:
    """Run one of the watchers inside the block; its output is whole at the end."""
    process = subprocess.Popen(
        [sys.executable, "-m", "benchmarks.sync.staging", *arguments],
        stdin=subprocess.PIPE,
        env={**os.environ, **(environment or {}), "OPENBLAS_NUM_THREADS": "1"},
        cwd=ROOT,
    )
    assert process.stdin
    try:
        yield
    finally:
        process.stdin.close()
        if process.wait(20.0):
            raise RuntimeError(f"the watcher failed: {' '.join(arguments)}")


def _is_asked_to_end() -> bool:
    return bool(select.select([0], [], [], 0.0)[0])


def _be_punctual() -> None:
    with contextlib.suppress(OSError):
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(PRIORITY))


# --- the screen --------------------------------------------------------------------


def watch_pixel(output: Path, framebuffer: Path) -> None:
    """Note when a pixel near the middle of the screen turns white or black."""
    pixel = pixel_reader(framebuffer)
    changes, stalls = array.array("d"), array.array("d")
    _be_punctual()
    was_white, before_s, polls = pixel()[1] > 127, time.monotonic(), 0
    due_s = before_s
    while polls % 100 or not _is_asked_to_end():
        due_s = max(due_s + POLL_S, before_s)
        time.sleep(max(0.0, due_s - time.monotonic()))
        is_white, now_s = pixel()[1] > 127, time.monotonic()
        if is_white is not was_white:
            changes.extend((0.5 * (before_s + now_s), float(is_white)))
        if now_s - before_s > BLIND_S:
            stalls.extend((before_s, now_s))
        was_white, before_s, polls = is_white, now_s, polls + 1
    changed, stalled = (np.array(values).reshape(-1, 2) for values in (changes, stalls))
    np.savez(output, changes=changed, stalls=stalled)


def flashes(output: Path) -> tuple[Floats, int]:
    """Return when the pixel turned white for some frames, s, and how many went unseen.

    What stays white for longer is a window or the end; a flash that began while the
    watcher itself did not run has no time.
    """
    seen = np.load(output)
    time_s, is_white = seen["changes"].T
    lasted_s = np.diff(time_s, append=np.inf)
    is_flash = (lasted_s > SHORTEST_FLASH_S) & (lasted_s < LONGEST_FLASH_S)
    found = time_s[(is_white > 0.5) & is_flash]
    begin_s, end_s = seen["stalls"].T
    is_unseen = ((found[:, None] > begin_s) & (found[:, None] < end_s)).any(axis=1)
    return np.asarray(found[~is_unseen]), int(is_unseen.sum())


# --- the sound ---------------------------------------------------------------------


def watch_sound(output: Path) -> None:
    """Record the monitor; where the server goes, begin again when it is back."""
    found = [np.empty(0)]
    _be_punctual()
    while not _is_asked_to_end():
        sound, reads = _record_until_it_breaks()
        if len(reads) > 1:
            found.append(_onsets(np.frombuffer(sound, np.int16), np.array(reads)))
        time.sleep(0.02)
    np.savez(output, onsets=np.concatenate(found))


def _record_until_it_breaks() -> tuple[bytes, list[tuple[float, int]]]:
    command = ["parec", "--raw", "--device=null.monitor", "--format=s16le"]
    command += [f"--rate={SOUND_HZ}", "--channels=1"]
    command += [f"--latency-msec={MONITOR_LATENCY_MS}"]
    sound, reads = bytearray(), []
    recorder = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    )
    assert recorder.stdout
    try:
        pipe = recorder.stdout.fileno()
        while not _is_asked_to_end():
            if not select.select([pipe], [], [], 0.1)[0]:
                continue
            piece = os.read(pipe, 1 << 16)
            now_s = time.monotonic()
            if not piece:
                break
            sound += piece
            reads.append((now_s, len(sound) // 2))
    finally:
        recorder.kill()
        recorder.wait()
    return bytes(sound[: len(sound) // 2 * 2]), reads


def _onsets(samples: NDArray[np.int16], reads: Floats) -> Floats:
    """Return when beeps began, from the samples and (time, count) of the reads.

    A read may come late but never early, so the earliest of the reads around a
    sample tells its time.
    """
    loud = np.flatnonzero(np.abs(samples) > ONSET_LEVEL * 32768)
    first = loud[np.diff(loud, prepend=-SOUND_HZ) > QUIET_S * SOUND_HZ]
    begin_s = reads[:, 0] - reads[:, 1] / SOUND_HZ  # of sample 0, were this read prompt
    found = []
    for sample in first:
        near = np.abs(reads[:, 1] - sample) < 0.5 * SOUND_HZ
        found.append(begin_s[near].min() + sample / SOUND_HZ)
    return np.array(found)


def onsets(output: Path) -> Floats:
    """Return when beeps came to the recorder, s."""
    return np.asarray(np.load(output)["onsets"])


class _SampleSpec(ctypes.Structure):
    _fields_ = (
        ("format", ctypes.c_int),
        ("rate", ctypes.c_uint32),
        ("channels", ctypes.c_uint8),
    )


def play_beeps(output: Path) -> None:
    """Play two beeps a second and note when the server says that they sound."""
    pulse = ctypes.CDLL("libpulse-simple.so.0")
    pulse.pa_simple_new.restype = ctypes.c_void_p
    pulse.pa_simple_get_latency.restype = ctypes.c_uint64
    spec, error = _SampleSpec(3, SOUND_HZ, 1), ctypes.c_int()  # 3: s16le
    stream = pulse.pa_simple_new(
        None, b"beeps", 1, None, b"beeps", ctypes.byref(spec), None, None, None
    )
    if not stream:
        raise OSError("no sound server answers")
    handle = ctypes.c_void_p(stream)
    silence = np.zeros(SOUND_HZ // 100, np.int16)
    tone = (32767 * beep()).astype(np.int16).reshape(-1, len(silence))
    said: list[float] = []
    count = 0
    while not _is_asked_to_end():
        block = count % 50
        if block == 0 and count > 100:
            latency_s = 1e-6 * pulse.pa_simple_get_latency(handle, ctypes.byref(error))
            said.append(time.monotonic() + latency_s)
        raw = (tone[block] if block < len(tone) and count > 100 else silence).tobytes()
        pulse.pa_simple_write(handle, raw, ctypes.c_size_t(len(raw)), None)
        count += 1
    np.savez(output, said=np.array(said))


WATCHERS = {"pixel": watch_pixel, "sound": watch_sound, "beeps": play_beeps}

if __name__ == "__main__":
    if sys.argv[1] == "player":
        play_case(*sys.argv[2:])
    else:
        WATCHERS[sys.argv[1]](*map(Path, sys.argv[2:]))
