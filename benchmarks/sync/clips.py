"""Clips for `outside`: at the same moments a flash, a beep and a push."""

import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.stage import HEIGHT, RATE_HZ, WIDTH

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
