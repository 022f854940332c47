"""What the benchmarks share: a screen, a sound server, a clip, CPU and results."""

import contextlib
import json
import os
import platform
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
RESULTS = Path(__file__).resolve().parent / "results"
WIDTH, HEIGHT, RATE_HZ = 1280, 720, 30
SAMPLE_S, MEMORY_TURNS = 0.025, 8
_TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def need(*programs: str) -> None:
    """Stop with the names of the Debian packages that are missing."""
    packages = {
        "Xvfb": "xvfb",
        "cyclictest": "rt-tests",
        "ffmpeg": "ffmpeg",
        "mpv": "mpv",
        "pulseaudio": "pulseaudio",
        "pactl": "pulseaudio-utils",
    }
    missing = [packages[name] for name in programs if shutil.which(name) is None]
    if missing:
        sys.exit(f"this benchmark needs: apt-get install {' '.join(missing)}")


@contextlib.contextmanager
def screen(
    memory: Path | None = None, size: tuple[int, int] = (WIDTH, HEIGHT)
) -> Iterator[dict[str, str]]:
    """Run an X server of the clip's size and yield the environment for it.

    Args:
        memory: folder in which its pixels are to be seen, as the file Xvfb_screen0.
        size: width and height, px.
    """
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


class SoundServer:
    """A PulseAudio null sink of its own.

    Attributes:
        environment: for the programs that shall use it.
    """

    def __init__(self, folder: str) -> None:
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
        self._command += ["-L", "module-null-sink sink_name=null rate=48000 channels=2"]
        self.start()

    def start(self) -> None:
        """Start it, and wait until it answers."""
        self._process = subprocess.Popen(
            self._command,
            env={**os.environ, **self._private},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        _wait_for_sound(self.environment)

    @property
    def pid(self) -> int:
        """Process id."""
        return self._process.pid

    def stop(self) -> None:
        """End it."""
        self._process.terminate()
        self._process.wait()

    def restart(self, after_s: float) -> None:
        """Kill it, and start it again after a while."""
        self._process.kill()
        self._process.wait()
        time.sleep(after_s)
        self.start()


@contextlib.contextmanager
def mortal_sound_server() -> Iterator[SoundServer]:
    """Run a PulseAudio null sink that can be killed and started again."""
    with tempfile.TemporaryDirectory(prefix="hp-sound-") as folder:
        server = SoundServer(folder)
        try:
            yield server
        finally:
            server.stop()


@contextlib.contextmanager
def sound_server() -> Iterator[dict[str, str]]:
    """Run a PulseAudio null sink and yield the environment for it."""
    with mortal_sound_server() as server:
        yield server.environment


def _wait_for_sound(environment: dict[str, str]) -> None:
    for _ in range(100):
        answer = subprocess.run(
            ["pactl", "info"],
            env={**os.environ, **environment},
            capture_output=True,
            check=False,
        )
        if answer.returncode == 0:
            return
        time.sleep(0.1)
    sys.exit("the sound server did not start")


def moving_clip(folder: Path, seconds: float) -> Path:
    """Write a 720p30 clip in which everything moves, with sound."""
    from hapticplayer.media import write_clip

    path = folder / f"moving-{seconds:.0f}s.mp4"
    if path.exists():
        return path
    x, y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    grain = np.random.default_rng(1).integers(0, 40, (HEIGHT, WIDTH), dtype=np.uint8)

    def pictures() -> Iterator[Any]:
        for k in range(round(seconds * RATE_HZ)):
            waves = 90 + 80 * np.sin((x + 9 * k) / 60.0) * np.cos((y - 5 * k) / 45.0)
            luma = waves.astype(np.uint8) + np.roll(grain, (3 * k, 7 * k), (0, 1))
            yield np.stack([luma, np.roll(luma, 40, 1), 255 - luma], axis=2)

    t = np.arange(round(seconds * 48_000)) / 48_000
    tone = (0.1 * np.sin(2 * np.pi * 220 * t)).astype(np.float32)
    write_clip(
        path,
        pictures(),
        frame_rate_hz=RATE_HZ,
        audio=np.stack([tone, tone], axis=1),
    )
    return path


def scrolling_clip(folder: Path, seconds: float, size: str, rate_hz: int) -> Path:
    """Write a clip of the usual bit rate that scrolls, with sound; e.g. "1920x1080"."""
    path = folder / f"scrolling-{size}-{rate_hz}.mp4"
    pictures = f"testsrc2=size={size}:rate={rate_hz},scroll=h=0.004:v=0.003"
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f", "lavfi"]
    command += ["-i", pictures, "-f", "lavfi", "-i", "sine=220:sample_rate=48000"]
    command += ["-t", str(seconds), "-c:v", "libx264", "-preset", "veryfast"]
    command += ["-pix_fmt", "yuv420p", "-g", str(2 * rate_hz), "-ac", "2", str(path)]
    if not path.exists():
        subprocess.run(command, check=True)
    return path


class Usage:
    """CPU seconds and memory of a process tree, kept up to date while it lives.

    Attributes:
        peak_mb: the most that the tree had of its own at once (PSS).
        parts_mb: of the processes at that time, by their command.
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
        for pid in self._tree(self._pid):
            with contextlib.suppress(OSError):
                rollup = Path(f"/proc/{pid}/smaps_rollup").read_text()
                part_mb = int(rollup.split("Pss:")[1].split()[0]) / 1024.0
                name = self.by_pid[pid][0] if pid in self.by_pid else ""
                parts_mb[name] = parts_mb.get(name, 0.0) + part_mb
        if sum(parts_mb.values()) > self.peak_mb:
            self.peak_mb, self.parts_mb = sum(parts_mb.values()), parts_mb

    def sample_cpu(self) -> None:
        """Read the seconds only, which takes a tenth of the time."""
        for pid in self._tree(self._pid):
            with contextlib.suppress(OSError):
                text = Path(f"/proc/{pid}/stat").read_text()
                fields = text.rsplit(")", 1)[1].split()
                seconds = (int(fields[11]) + int(fields[12])) / _TICKS_PER_S
                command = Path(f"/proc/{pid}/cmdline").read_bytes()
                name = command.replace(b"\0", b" ").decode() or self._name_of(pid)
                self.by_pid[pid] = (name, seconds)

    def _name_of(self, pid: int) -> str:
        """Return what a process was called before it ended and nobody had waited."""
        return self.by_pid[pid][0] if pid in self.by_pid else ""

    def written_mb(self) -> float:
        """Return what the tree has now that is no file: only that can grow.

        Its share of the libraries depends on who else has them loaded.
        """
        total_kb = 0
        for pid in self._tree(self._pid):
            with contextlib.suppress(OSError):
                rollup = Path(f"/proc/{pid}/smaps_rollup").read_text()
                for kind in ("Pss_Anon:", "Pss_Shmem:"):
                    total_kb += int(rollup.split(kind)[1].split()[0])
        return total_kb / 1024.0

    def of(self, part: str) -> float:
        """Return the seconds of the processes whose command holds `part`."""
        return sum(s for command, s in self.by_pid.values() if part in command)

    def memory_of(self, part: str) -> float:
        """Return the MB of these processes when the tree had the most."""
        return sum(mb for command, mb in self.parts_mb.items() if part in command)

    def _tree(self, pid: int) -> list[int]:
        found = [pid]
        with contextlib.suppress(OSError):
            for task in Path(f"/proc/{pid}/task").iterdir():
                for child in (task / "children").read_text().split():
                    found += self._tree(int(child))
        return found


def run_measured(
    command: list[str], environment: dict[str, str], timeout_s: float
) -> tuple[Usage, float, str]:
    """Run to the end; return the usage of the parts, of the whole tree, s, and output."""
    process = subprocess.Popen(
        command,
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    usage = Usage(process.pid)
    deadline, turn = time.monotonic() + timeout_s, 0
    while True:
        pid, status, resources = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        # often: what a process that has ended used since its last sample is taken for
        # that of its parent
        if turn % MEMORY_TURNS == 0:
            usage.sample()
        else:
            usage.sample_cpu()
        turn += 1
        if time.monotonic() > deadline:
            os.killpg(process.pid, signal.SIGKILL)
            sys.exit(f"timed out: {' '.join(command)}")
        time.sleep(SAMPLE_S)
    errors = process.stderr.read().decode() if process.stderr else ""
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(
            f"failed ({process.returncode}): {' '.join(command)}\n{errors[-2000:]}"
        )
    printed = process.stdout.read().decode() if process.stdout else ""
    return usage, resources.ru_utime + resources.ru_stime, printed


def player_command(*arguments: str) -> list[str]:
    """Return the command of the player in this checkout."""
    return [sys.executable, "-m", "app", *arguments]


def as_installed(folder: str) -> dict[str, str]:
    """Return the environment in which modules are compiled once, as an installer does."""
    return {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": folder}


def save(name: str, figures: dict[str, Any]) -> Path:
    """Write the figures with the machine they come from."""
    RESULTS.mkdir(exist_ok=True)
    commit = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    ).stdout.strip()
    machine = {
        "cores": os.cpu_count(),
        "kernel": platform.release(),
        "python": platform.python_version(),
        "commit": commit,
    }
    path = RESULTS / f"{name}.json"
    path.write_text(json.dumps({"machine": machine, **figures}, indent=2) + "\n")
    return path


def table(header: list[str], rows: list[list[Any]]) -> str:
    """Return a plain text table."""
    cells = [header, *[[_cell(value) for value in row] for row in rows]]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    lines = [
        "  ".join(c.rjust(w) for c, w in zip(row, widths, strict=True)) for row in cells
    ]
    return "\n".join([lines[0], "-" * len(lines[0]), *lines[1:]])


def _cell(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
