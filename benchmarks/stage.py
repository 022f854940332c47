"""A screen, a sound server, clips, and the CPU time and memory of processes."""

import contextlib
import mmap
import os
import shutil
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import tools.sound_server
from tools.sound_server import SoundServer

WIDTH, HEIGHT, RATE_HZ = 1280, 720, 30
ASIDE_PX = 100  # the mouse pointer in the middle of the screen comes and goes
_PACKAGES = {
    "Xvfb": "xvfb",
    "cyclictest": "rt-tests",
    "ffmpeg": "ffmpeg",
    "mpv": "mpv",
    "pulseaudio": "pulseaudio",
    "pactl": "pulseaudio-utils",
    "parec": "pulseaudio-utils",
}
_SAMPLE_S, _CPU_SAMPLES_PER_MEMORY_SAMPLE = 0.025, 8
_TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def need(*programs: str) -> None:
    missing = [_PACKAGES[name] for name in programs if shutil.which(name) is None]
    if missing:
        sys.exit(f"this benchmark needs: apt-get install {' '.join(missing)}")


@contextlib.contextmanager
def screen(
    memory: Path | None = None, size: tuple[int, int] = (WIDTH, HEIGHT)
) -> Iterator[dict[str, str]]:
    """Run an X server and yield the environment for it.

    Args:
        memory: folder in which its pixels are to be seen, as the file Xvfb_screen0.
        size: width and height, px.
    """
    need("Xvfb")
    reader, writer = os.pipe()
    command = ["Xvfb", "-displayfd", str(writer), "-nolisten", "tcp"]
    command += ["-screen", "0", f"{size[0]}x{size[1]}x24"]
    command += ["-fbdir", str(memory)] if memory else []
    server = subprocess.Popen(
        command, pass_fds=(writer,), stderr=subprocess.DEVNULL, start_new_session=True
    )
    os.close(writer)
    with os.fdopen(reader) as answer:
        display = answer.readline().strip()
    try:
        yield {"DISPLAY": f":{display}", "QT_QPA_PLATFORM": "xcb"}
    finally:
        server.terminate()
        server.wait()


def pixel_reader(framebuffer: Path) -> Callable[[], bytes]:
    """A reader of a pixel (blue, green, red) near the middle of a screen."""
    memory, (width, height), at = _pixels_of(framebuffer)
    begin = at(height // 2 - ASIDE_PX, width // 2 - ASIDE_PX)
    return lambda: memory[begin : begin + 3]


def rows_reader(framebuffer: Path) -> Callable[[], bytes]:
    """A reader of rows of pixels (4 bytes each) across the upper middle of a screen."""
    memory, (width, height), at = _pixels_of(framebuffer)
    begins = [at(row, width // 4) for row in range(height // 4, height // 2, 12)]
    return lambda: b"".join(memory[each : each + 2 * width] for each in begins)


def _pixels_of(
    framebuffer: Path,
) -> tuple[mmap.mmap, tuple[int, int], Callable[[int, int], int]]:
    """Memory of a screen, its width and height, and where a row and column is."""
    with framebuffer.open("rb") as file:
        memory = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
    # XWD header, big-endian: size, version, format, depth, width, height, ...
    header = struct.unpack(">25I", memory[:100])
    begin, line = header[0] + 12 * header[19], header[12]
    return memory, header[4:6], lambda row, column: begin + row * line + 4 * column


@contextlib.contextmanager
def sound_server(channels: int = 2) -> Iterator[SoundServer]:
    """Run a PulseAudio null sink of 2 or 4 channels."""
    need("pulseaudio", "pactl")
    with tools.sound_server.sound_server(channels) as server:
        yield server


# --- clips and forces --------------------------------------------------------------


def moving_clip(folder: Path, seconds: float) -> Path:
    """Write a 720p30 clip of grain in which everything moves, with sound."""
    from hapticplayer.media.encode import write_clip

    path = folder / f"moving-{seconds:.0f}s.mp4"
    if path.exists():
        return path
    x, y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    grain = np.random.default_rng(1).integers(0, 40, (HEIGHT, WIDTH), dtype=np.uint8)

    def frames() -> Iterator[Any]:
        for k in range(round(seconds * RATE_HZ)):
            waves = 90 + 80 * np.sin((x + 9 * k) / 60.0) * np.cos((y - 5 * k) / 45.0)
            luma = waves.astype(np.uint8) + np.roll(grain, (3 * k, 7 * k), (0, 1))
            yield np.stack([luma, np.roll(luma, 40, 1), 255 - luma], axis=2)

    t = np.arange(round(seconds * 48_000)) / 48_000
    tone = (0.1 * np.sin(2 * np.pi * 220 * t)).astype(np.float32)
    audio = np.stack([tone, tone], axis=1)
    write_clip(path, frames(), frame_rate_hz=RATE_HZ, audio=audio)
    return path


def generated_clip(path: Path, frames: str, seconds: float, rate_hz: int) -> Path:
    """Write a clip from one of FFmpeg's sources of frames, with sound."""
    need("ffmpeg")
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f", "lavfi"]
    command += ["-i", frames, "-f", "lavfi", "-i", "sine=220:sample_rate=48000"]
    command += ["-t", str(seconds), "-c:v", "libx264", "-preset", "veryfast"]
    command += ["-pix_fmt", "yuv420p", "-g", str(2 * rate_hz), "-ac", "2", str(path)]
    if not path.exists():
        subprocess.run(command, check=True)
    return path


def scrolling_clip(folder: Path, seconds: float, size: str, rate_hz: int) -> Path:
    """Write a clip of the usual bit rate that scrolls; size such as "1920x1080"."""
    frames = f"testsrc2=size={size}:rate={rate_hz},scroll=h=0.004:v=0.003"
    path = folder / f"scrolling-{size}-{rate_hz}-{seconds:.0f}s.mp4"
    return generated_clip(path, frames, seconds, rate_hz)


def waves_file(folder: Path, seconds: float) -> Path:
    """Write a force track that is never zero."""
    path = folder / "force.csv"
    t = np.arange(0, seconds, 0.005)
    rows = np.stack([t, 1.5 + np.sin(9 * t), np.sin(5 * t), 0 * t], axis=1)
    header = "time_s,fx_n,fy_n,fz_n"
    np.savetxt(path, rows, "%.4f", delimiter=",", header=header, comments="")
    return path


def player_command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "app", *arguments]


# --- what processes use ------------------------------------------------------------


class Usage:
    """CPU seconds and memory of a process tree, kept up to date while it lives.

    Attributes:
        peak_mb: the most memory that the tree had at once (PSS).
        parts_mb: of the processes at that time, by their command.
        by_pid: command and CPU seconds of each process so far.
    """

    def __init__(self, pid: int) -> None:
        self._pid = pid
        self.by_pid: dict[int, tuple[str, float]] = {}
        self.peak_mb = 0.0
        self.parts_mb: dict[str, float] = {}

    def sample(self) -> None:
        """Read what the tree has used so far."""
        self.sample_cpu()
        parts_mb: dict[str, float] = {}
        for pid in tree(self._pid):
            name = self.by_pid[pid][0] if pid in self.by_pid else ""
            parts_mb[name] = parts_mb.get(name, 0.0) + memory_mb(pid, "Pss:")
        if sum(parts_mb.values()) > self.peak_mb:
            self.peak_mb, self.parts_mb = sum(parts_mb.values()), parts_mb

    def sample_cpu(self) -> None:
        """Read the seconds only, which takes a tenth of the time."""
        for pid in tree(self._pid):
            with contextlib.suppress(OSError):
                text = Path(f"/proc/{pid}/stat").read_text()
                fields = text.rsplit(")", 1)[1].split()
                seconds = (int(fields[11]) + int(fields[12])) / _TICKS_PER_S
                command = Path(f"/proc/{pid}/cmdline").read_bytes()
                known = self.by_pid.get(pid, ("", 0.0))[0]  # a zombie has no command
                name = command.replace(b"\0", b" ").decode() or known
                self.by_pid[pid] = (name, seconds)

    def seconds_of(self, part: str) -> float:
        """Return the CPU seconds of the processes whose command holds `part`."""
        return sum(s for command, s in self.by_pid.values() if part in command)

    def memory_of(self, part: str) -> float:
        """Return the MB of these processes when the tree had the most."""
        return sum(mb for command, mb in self.parts_mb.items() if part in command)


def tree(pid: int) -> list[int]:
    """Return a process and all below it."""
    found = [pid]
    with contextlib.suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            for child in (task / "children").read_text().split():
                found += tree(int(child))
    return found


def memory_mb(pid: int, *kinds: str) -> float:
    """Return some kinds of a process's memory, such as "Pss:", MB; 0 once it ended."""
    with contextlib.suppress(OSError, IndexError):
        text = Path(f"/proc/{pid}/smaps_rollup").read_text()
        return sum(int(text.split(kind)[1].split()[0]) for kind in kinds) / 1024.0
    return 0.0


def run_measured(
    command: list[str], environment: dict[str, str], timeout_s: float
) -> tuple[Usage, float, str]:
    """Run to the end; return usage by process, CPU seconds of the tree, and output."""
    process = subprocess.Popen(
        command,
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    usage = Usage(process.pid)
    deadline_s, samples = time.monotonic() + timeout_s, 0
    while True:
        pid, status, resources = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        # often: what a process used between its last sample and its end counts as its
        # parent's
        with_memory = samples % _CPU_SAMPLES_PER_MEMORY_SAMPLE == 0
        (usage.sample if with_memory else usage.sample_cpu)()
        samples += 1
        if time.monotonic() > deadline_s:
            os.killpg(process.pid, signal.SIGKILL)
            sys.exit(f"timed out: {' '.join(command)}")
        time.sleep(_SAMPLE_S)
    assert process.stdout is not None
    assert process.stderr is not None
    printed, errors = process.stdout.read().decode(), process.stderr.read().decode()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(
            f"failed ({process.returncode}): {' '.join(command)}\n{errors[-2000:]}"
        )
    return usage, resources.ru_utime + resources.ru_stime, printed
