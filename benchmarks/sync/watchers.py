"""What can be seen and heard of a player from outside, on CLOCK_MONOTONIC.

Run by `outside`, each as a process of its own until its input closes. `pixel` reads a
pixel near the middle of Xvfb's memory at 1 kHz and notes when it changes between black
and white. `sound` records the monitor of the null sink with the time of each read.
`beeps` plays beeps through libpulse and writes when PulseAudio says that they sound:
what the recorder hears earlier or later than that is its own constant (a monitor hands
samples out a block before they are played).
"""

import array
import contextlib
import ctypes
import os
import select
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import ROOT
from benchmarks.stage import pixel_reader
from benchmarks.sync.clips import SOUND_HZ, beep

Floats = NDArray[np.float64]

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
        [sys.executable, "-m", "benchmarks.sync.watchers", *arguments],
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


if __name__ == "__main__":
    {"pixel": watch_pixel, "sound": watch_sound, "beeps": play_beeps}[sys.argv[1]](
        *map(Path, sys.argv[2:])
    )
