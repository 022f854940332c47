"""What recording costs beside FFmpeg, and the time from stop to a playing sequence.

Both film the same test source (720p at 30 frames a second, x264 ultrafast, PCM sound) at the
same time, so that the machine is as busy for either; the recorder also takes 200 samples a
second. A test source costs both of them the same. On a machine that is too busy it gives
fewer frames to one than to the other: the CPU is compared for each frame that was written.
"""

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import ROOT, Report
from hapticplayer.capture import read_recording
from hapticplayer.capture.recorded import CLIP, read_take
from hapticplayer.clock import SystemClock
from hapticplayer.sequence import open_sequence
from tests.material.recording import MICROPHONE, Board, camera, clock_error_s

SIZE, TAKE_S = "1280x720", 30.0
MOST_OFF_MS, MOST_TO_PLAY_S, MOST_RATIO, MOST_MB_PER_HOUR = 3.0, 10.0, 2.0, 10.0
_SAMPLE_S, _SETTLING_S, _OPENING_S = 5.0, 60.0, 5.0
_FILM = (
    f"testsrc2=size={SIZE}:rate=30,settb=1/1000000,realtime,setpts=RTCTIME/1000000/TB"
)
_TICKS_HZ = os.sysconf("SC_CLK_TCK")


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, help="(600)")


def run(options: argparse.Namespace, report: Report) -> None:
    seconds = options.seconds or (20.0 if options.quick else 600.0)
    with tempfile.TemporaryDirectory(prefix="hp-record-") as name:
        folder = Path(name)
        _cost(folder, seconds, report)
        _to_play(folder, report)


def _cost(folder: Path, seconds: float, report: Report) -> None:
    """CPU and memory of both over the same time."""
    board = Board()
    words = ["record", "-o", folder / "take", "--camera", f"lavfi:{_FILM}"]
    words += ["--audio", MICROPHONE, "--imu", board.source]
    sound = MICROPHONE.partition(":")[2]
    ffmpeg = ["ffmpeg", "-v", "error", "-f", "lavfi", "-i", _FILM, "-f", "lavfi", "-i"]
    # every frame at its own time, as the recorder keeps it; else half of them are dropped
    ffmpeg += [sound, "-fps_mode", "passthrough", "-enc_time_base:v", "1:1000"]
    ffmpeg += ["-c:v", "libx264", "-preset", "ultrafast", "-tune", "zerolatency"]
    ffmpeg += ["-crf", "23", "-pix_fmt", "yuv420p", "-c:a", "pcm_s16le"]
    running = {
        "hapticplayer record": _started(*map(str, words)),
        "ffmpeg": subprocess.Popen(
            [*ffmpeg, str(folder / "ffmpeg.mkv")], stdin=subprocess.DEVNULL
        ),
    }
    seen = _watched(running, seconds)
    for process in running.values():
        process.send_signal(signal.SIGTERM)  # may not be ignored, as SIGINT is by some
        process.wait()
    board.unplug()
    clips = folder / "take" / CLIP, folder / "ffmpeg.mkv"
    for one, clip in zip(seen.values(), clips, strict=True):
        frames = _frames(clip)
        one |= {"frames": frames, "file_mb": clip.stat().st_size / 1e6}
        one["cpu_ms_per_frame"] = (
            1e3 * one["cpu_share"] * (seconds + _OPENING_S) / frames
        )
    take = read_take(folder / "take")
    assert take.camera is not None
    assert take.imu is not None
    rows = [
        [
            name,
            f"{100 * one['cpu_share']:.0f}",
            f"{one['cpu_ms_per_frame']:.1f}",
            f"{one['rss_mb']:.0f}",
            f"{one['mb_per_hour']:+.1f}",
            f"{one['frames']:.0f}",
            f"{one['file_mb']:.0f}",
        ]
        for name, one in seen.items()
    ]
    report.table(
        f"{seconds:.0f} s of {SIZE} at 30 frames/s",
        [
            "recorder",
            "CPU % of a core",
            "ms per frame",
            "MB",
            "MB per hour",
            "frames",
            "file MB",
        ],
        rows,
        mark="record_load",
    )
    ours, theirs = seen.values()
    ratio = ours["cpu_ms_per_frame"] / theirs["cpu_ms_per_frame"]
    report.target("CPU per frame beside FFmpeg", ratio, ("<=", MOST_RATIO))
    if seconds > 4 * _SETTLING_S:
        grown = ours["mb_per_hour"]
        report.target("memory, MB per hour", grown, ("<=", MOST_MB_PER_HOUR))
    report.figures |= {
        "seconds": seconds,
        "processes": seen,
        "frames": take.camera.count,
        "dropped_frames": take.camera.dropped,
        "samples": take.imu.count,
        "dropped_samples": take.imu.dropped,
    }


def _started(*words: str) -> "subprocess.Popen[bytes]":
    line = [sys.executable, "-m", "app", *words]
    return subprocess.Popen(
        line, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, cwd=ROOT
    )


def _watched(
    running: dict[str, "subprocess.Popen[bytes]"], seconds: float
) -> dict[str, dict[str, float]]:
    """CPU share and memory of processes that run for some time."""
    clock = SystemClock()
    clock.sleep_until(clock.now_s() + _OPENING_S)
    begin_s, before = clock.now_s(), {n: _cpu_s(p.pid) for n, p in running.items()}
    sizes: dict[str, list[tuple[float, float]]] = {name: [] for name in running}
    while (since_s := clock.now_s() - begin_s) < seconds:
        for name, process in running.items():
            sizes[name].append((since_s, _rss_mb(process.pid)))
        clock.sleep_until(begin_s + since_s + _SAMPLE_S)
    found = {}
    for name, process in running.items():
        at_s, mb = np.array(sizes[name]).T
        late = at_s >= min(_SETTLING_S, 0.5 * seconds)
        found[name] = {
            "cpu_share": (_cpu_s(process.pid) - before[name]) / since_s,
            "rss_mb": float(mb[-1]),
            "mb_per_hour": 3600.0 * float(np.polyfit(at_s[late], mb[late], 1)[0]),
        }
    return found


def _frames(clip: Path) -> int:
    line = ["ffprobe", "-v", "error", "-select_streams", "v", "-count_packets"]
    line += ["-show_entries", "stream=nb_read_packets", "-of", "csv=p=0", str(clip)]
    return int(subprocess.run(line, capture_output=True, check=True).stdout)


def _cpu_s(pid: int) -> float:
    fields = (
        Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    )
    return (int(fields[11]) + int(fields[12])) / _TICKS_HZ


def _rss_mb(pid: int) -> float:
    pages = Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1]
    return int(pages) * os.sysconf("SC_PAGE_SIZE") / 1e6


def _to_play(folder: Path, report: Report) -> None:
    """From stopping a take to the first frame and force of its sequence."""
    board, clock = Board(), SystemClock()
    take, ride, log = folder / "short", folder / "ride", folder / "log.jsonl"
    words = ["record", "-o", take, "--camera", camera(SIZE), "--audio", MICROPHONE]
    words += ["--imu", board.source, "--duration", TAKE_S]
    recorder = _started(*map(str, words))
    recorder.wait()
    stopped_s = read_take(take).zero_s + TAKE_S
    board.unplug()
    before_s = _children_cpu_s()
    _started("import", str(take), "-o", str(ride)).wait()
    imported_s = clock.now_s()
    play = ["play", str(ride), "--headless", "--duration", "1", "--log", str(log)]
    _started(*play).wait()
    cpu_s = _children_cpu_s() - before_s
    error_s = _clock_error_s(take, ride)
    lines = [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines()]
    shown_s = next(one["monotonic_s"] for one in lines if one["kind"] == "frame")
    found: dict[str, Any] = {
        "to_import_s": imported_s - stopped_s,
        "to_play_s": shown_s - stopped_s,
        "cpu_s": cpu_s,
        "clock_error_before_ms": 1e3 * error_s[0],
        "clock_error_after_ms": 1e3 * error_s[1],
    }
    report.table(
        f"From stop to a playing sequence of {TAKE_S:.0f} s",
        ["imported s", "first frame s", "CPU s", "clock off ms", "after frames"],
        [[f"{value:.1f}" for value in found.values()]],
    )
    report.target(
        "from stop to a playing sequence, s", found["to_play_s"], ("<=", MOST_TO_PLAY_S)
    )
    report.target(
        "clock after frames, ms",
        abs(found["clock_error_after_ms"]),
        ("<=", MOST_OFF_MS),
    )
    report.figures["to_play"] = found


def _clock_error_s(take: Path, ride: Path) -> tuple[float, float]:
    """How late the log is by the recorder's clock, and by that of the import."""
    described, imu = read_take(take), read_recording(take).imu
    clock = open_sequence(ride).description.clock_map
    return clock_error_s(imu, described), clock_error_s(imu, described, clock)


def _children_cpu_s() -> float:
    times = os.times()
    return times.children_user + times.children_system
