"""A sequence in one file: other programs, frames, time to the first force, seeks.

A 720p30 clip with force from its first second is packed as MKV and as MP4 with a side-car.
mpv, FFmpeg, mkvtoolnix, mediainfo and VLC (where installed, with its plugins) read the files;
FFmpeg's checksums of the decoded frames, and those of the frames that VLC shows, are compared
with those of the source. VLC refuses root: it is run as nobody then. Then folder and MKV are
opened in turn, once with the checksum of the video known from before and once without, up to
the first tick with a force on the simulated device, which is ready all the time; and the same
seeks are timed in both, paused.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.common import Report, interleaved
from benchmarks.playback.plots_and_seeks import PausedPlayer, shaken_sequence
from benchmarks.stage import need
from hapticplayer.clock import SystemClock
from hapticplayer.media.remux import video_payload
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.contents import contents_of
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import MANIFEST, read_packed

MOST_LATER_MS, MOST_SEEK_RATIO = 20.0, 1.1
_PATIENCE_S = 20.0
_VLC_S, _VLC_FRAMES = 4, 50
_TOOLS = {  # how each reads a file, and what it has to say
    "mpv": (["mpv", "--no-config", "--vo=null", "--ao=null", "--untimed"], ""),
    "ffmpeg": (["ffmpeg", "-v", "error", "-nostdin"], ""),
    "mkvtoolnix": (["mkvmerge", "-J"], MANIFEST),
    "mkvinfo": (["mkvinfo"], MANIFEST),
    "mediainfo": (["mediainfo"], MANIFEST),
}


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--rounds", type=int, help="(15)")
    parser.add_argument("--seconds", type=float, help="of the clip (40)")
    parser.add_argument("--seeks", type=int, help="(40)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Pack a ride, have it read by others, and compare it with its folder."""
    need("ffmpeg")
    seconds = options.seconds or (6.0 if options.quick else 40.0)
    with tempfile.TemporaryDirectory(prefix="hp-distribution-") as name:
        place = Path(name)
        os.environ["XDG_CACHE_HOME"] = str(place / "cache")
        folder = shaken_sequence(place, seconds)
        mkv, mp4 = place / "ride.mkv", place / "ride.mp4"
        begin_s = time.monotonic()
        payload = pack(folder, mkv)
        report.figures["pack_s"] = time.monotonic() - begin_s
        pack(folder, mp4)
        report.figures |= _sizes(mkv, payload.size_bytes, seconds)
        _accepted(mkv, mp4, report)
        _frames(folder / "clip.mp4", mkv, mp4, report)
        _shown_by_vlc(folder / "clip.mp4", mkv, mp4, report)
        _first_force(
            folder, mkv, options.rounds or (3 if options.quick else 15), report
        )
        _seeks(folder, mkv, options.seeks or (8 if options.quick else 40), report)


def _sizes(mkv: Path, payload_bytes: int, seconds: float) -> dict[str, Any]:
    """The size of the force beside the video."""
    packed = read_packed(mkv)
    assert packed is not None
    what = contents_of(packed)
    attached = sum(part.size_bytes for part in what.attached)
    return {
        "payload_mb": 1e-6 * payload_bytes,
        "attached_kb": 1e-3 * attached,
        "attached_kbit_per_s": 8e-3 * attached / seconds,
    }


# --- other programs ---------------------------------------------------------------


def _accepted(mkv: Path, mp4: Path, report: Report) -> None:
    """Let every program that is here read both files."""
    rows, refused, absent = [], 0, 0
    for name, (words, says) in _TOOLS.items():
        if shutil.which(words[0]) is None:
            rows.append([name, "not installed", ""])
            absent += 1
            continue
        answers = [_read_by(name, words, mkv, says)]
        if name != "mkvinfo":  # it reads no MP4
            answers.append(_read_by(name, words, mp4, ""))
        refused += sum(answer != "yes" for answer in answers)
        rows.append([name, *answers, "-"][:3])
    report.table("Accepted by", ["program", "MKV", "MP4"], rows)
    report.target("files that a program complains about", refused, ("<=", 0))
    report.target("programs that were not there", absent, ("<=", 0))
    report.figures["accepted"] = rows


def _read_by(name: str, words: list[str], path: Path, says: str) -> str:
    """Return "yes", or what is wrong."""
    if name == "ffmpeg":
        # of the streams that a player shows: attachments have no codec, which it warns of
        words = [
            *words,
            "-i",
            str(path),
            "-map",
            "0:v",
            "-map",
            "0:a",
            "-f",
            "null",
            "-",
        ]
    else:
        words = [*words, str(path)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode:
        return f"exit status {done.returncode}"
    if name == "mkvtoolnix":
        found = json.loads(done.stdout)
        if complaints := found["errors"] + found["warnings"]:
            return str(complaints[0])
    if says not in done.stdout:
        return f"does not name {says}"
    return "yes"


def _frames(clip: Path, mkv: Path, mp4: Path, report: Report) -> None:
    """Compare what FFmpeg decodes, frame by frame, and its checksum of the packets."""
    expected = _hashes(clip, "framehash")
    others = {path.suffix[1:]: _hashes(path, "framehash") for path in (mkv, mp4)}
    wrong = sum(
        sum(a != b for a, b in zip(expected, found, strict=False))
        + abs(len(expected) - len(found))
        for found in others.values()
    )
    report.target("decoded frames that differ from the source's", wrong, ("<=", 0))
    (packets,) = _hashes(mkv, "streamhash", "-c", "copy")
    is_same = packets == video_payload(mkv).sha256 == video_payload(clip).sha256
    report.target("checksum of the packets is FFmpeg's (1)", int(is_same), (">=", 1))
    report.figures |= {"frames": len(expected), "frames_that_differ": wrong}


def _shown_by_vlc(clip: Path, mkv: Path, mp4: Path, report: Report) -> None:
    """Compare the first frames that VLC shows with what FFmpeg decodes of the source."""
    if shutil.which("vlc") is None:
        report.figures["VLC"] = "not installed"
        report.target("VLC was not there", 1, ("<=", 0))
        return
    expected = _once(_hashes(clip, "framehash", "-pix_fmt", "yuv420p"))
    rows, wrong = [], 0
    shown, usual = _frames_of_vlc(clip, mkv.parent)
    if not shown:
        report.figures["VLC"] = "does not show the source"
        report.target("VLC shows no clip here", 1, ("<=", 0))
        print("VLC does not show the source: it may lack its plugins")
        return
    for path in (mkv, mp4):
        shown, complaints = _frames_of_vlc(path, mkv.parent)
        complaints -= usual
        rest = iter(expected)  # it leaves some out where the machine is busy
        is_same = len(shown) >= _VLC_FRAMES and all(one in rest for one in shown)
        wrong += len(complaints) + (not is_same)
        rows.append([path.suffix[1:], len(shown), is_same, "; ".join(complaints)[:60]])
    header = ["file", "frames shown", "those of the source", "complaints"]
    report.table("VLC, the first seconds", header, rows)
    report.target(
        "files that VLC shows otherwise, or complains about", wrong, ("<=", 0)
    )
    report.figures["VLC"] = rows


def _frames_of_vlc(path: Path, place: Path) -> tuple[list[str], set[str]]:
    """Return the checksums of the frames that VLC shows, and what it complains about."""
    is_root = os.geteuid() == 0
    home = place / "vlc"
    home.mkdir(exist_ok=True)
    if is_root:
        place.chmod(0o755)
        home.chmod(0o777)
    frames = home / "frames.y4m"
    words = ["vlc", "-v", "-I", "dummy", "--aout=adummy", "--vout=yuv"]
    words += ["--no-osd", "--no-spu", "--no-video-title-show", "--no-avcodec-hurry-up"]
    words += [f"--yuv-file={frames}", "--no-drop-late-frames", "--no-skip-frames"]
    words += ["--avcodec-hw=none", f"--stop-time={_VLC_S}", str(path), "vlc://quit"]
    nobody: dict[str, Any] = {"user": "nobody", "group": "nogroup", "extra_groups": ()}
    done = subprocess.run(
        words,
        capture_output=True,
        text=True,
        check=False,
        timeout=60.0,
        env={**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home)},
        **(nobody if is_root else {}),
    )
    about_file = {
        line.partition("] ")[2]
        for line in done.stderr.splitlines()
        if " error: " in line and not re.search("interface|libvlc", line)
    }
    if not frames.exists():
        return [], about_file
    found = list(_frames_in(frames))
    frames.unlink()
    return _once(found), about_file


def _frames_in(path: Path) -> Iterator[str]:
    """Yield the checksums of the frames of a file of YUV4MPEG2, 4:2:0."""
    with path.open("rb") as stream:
        size = {word[:1]: word[1:] for word in stream.readline().split()}
        count = int(size[b"W"]) * int(size[b"H"]) * 3 // 2
        while stream.readline().startswith(b"FRAME"):
            yield hashlib.sha256(stream.read(count)).hexdigest()


def _once(frames: list[str]) -> list[str]:
    """Return frames without those that equal the one before: players show some twice."""
    return [one for row, one in enumerate(frames) if row == 0 or one != frames[row - 1]]


def _hashes(path: Path, kind: str, *how: str) -> list[str]:
    words = ["ffmpeg", "-v", "error", "-nostdin", "-i", str(path), "-map", "0:v:0"]
    passed = how or ("-fps_mode", "passthrough")
    done = subprocess.run(
        [*words, *passed, "-f", kind, "-hash", "sha256", "-"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    lines = (one for one in done.stdout.splitlines() if not one.startswith("#"))
    return [line.replace("=", ",").split(",")[-1].strip() for line in lines]


# --- time to the first force ---------------------------------------------------------


def _first_force(folder: Path, mkv: Path, rounds: int, report: Report) -> None:
    """Open folder and file in turn, until a tick has a force."""
    clock = SystemClock()
    player = Player(clock, outputs=["simulated"], audio=None)
    player.wait_ready()
    known = Path(os.environ["XDG_CACHE_HOME"]) / "hapticplayer" / "checked-videos.json"
    contenders: dict[str, Callable[[], float]] = {
        "folder": partial(_opened_ms, player, clock, folder),
        "MKV": partial(_opened_ms, player, clock, mkv),
        "MKV, first time": partial(_opened_ms, player, clock, mkv, forget=known),
    }
    found = interleaved(contenders, rounds, warm_up=True)
    player.close()
    rows = []
    for name, each in found.items():
        later = [a - b for a, b in zip(each, found["folder"], strict=True)]
        rows.append([name, *spread(each), statistics.median(later)])
    header = ["opened", "median ms", "least", "largest", "later than the folder, ms"]
    report.table("From opening to the first force", header, rows)
    for name, *_, later_ms in rows[1:]:
        what = f"{name}: first force later than the folder's, median ms"
        report.target(what, later_ms, ("<=", MOST_LATER_MS))
    report.figures["first_force"] = {"columns": header, "rows": rows}


def _opened_ms(
    player: Player, clock: SystemClock, path: Path, forget: Path | None = None
) -> float:
    """Return how long it takes from opening to the first tick with a force."""
    if forget is not None:
        forget.unlink(missing_ok=True)
    until(player, clock, lambda: not felt_since(player, clock.now_s() - 0.2))
    begin_s = clock.now_s()
    player.open(open_source(path))
    player.play()
    until(player, clock, lambda: felt_since(player, begin_s))
    ticks = player.ticks_since(begin_s)
    active = np.linalg.norm(ticks["force_n"], axis=1) > 0.0
    first_s = float(ticks["monotonic_s"][active][0])
    player.pause()
    return 1e3 * (first_s - begin_s)


def felt_since(player: Player, since_s: float) -> bool:
    ticks = player.ticks_since(since_s)
    return bool(len(ticks)) and bool(ticks["force_n"].any())


def until(player: Player, clock: SystemClock, is_so: Callable[[], bool]) -> None:
    """Play until something holds; raises TimeoutError."""
    end_s = clock.now_s() + _PATIENCE_S
    while not is_so():
        if clock.now_s() > end_s:
            raise TimeoutError("no force has come")
        clock.sleep_until(min(player.poll(), clock.now_s() + 0.005))


def spread(values: Iterable[float]) -> tuple[float, float, float]:
    """Return median, least and largest."""
    ordered = sorted(values)
    return statistics.median(ordered), ordered[0], ordered[-1]


# --- seeks -------------------------------------------------------------------------


def _seeks(folder: Path, mkv: Path, count: int, report: Report) -> None:
    """Seek to the same places in both, paused, in turn."""
    players = {
        "folder": PausedPlayer(open_source(folder)),
        "MKV": PausedPlayer(open_source(mkv)),
    }
    rng, places = np.random.default_rng(1), iter(())
    duration_s = players["folder"].player.snapshot().duration_s
    took: dict[str, list[float]] = {name: [] for name in players}
    shown: dict[str, list[float]] = {name: [] for name in players}
    places = rng.uniform(0.0, duration_s - 0.1, count)
    for number, target_s in enumerate(places):
        for name in list(players)[:: 1 if number % 2 else -1]:
            begin_s = time.monotonic()
            players[name].seek(float(target_s))
            took[name].append(1e3 * (time.monotonic() - begin_s))
            shown[name].append(players[name].seen.pts_s)
    for one in players.values():
        one.player.close()
    rows = [[name, *np.percentile(each, [50.0, 95.0])] for name, each in took.items()]
    report.table("Seeks, paused", ["in", "p50 ms", "p95 ms"], rows)
    each_ratio = [a / b for a, b in zip(took["MKV"], took["folder"], strict=True)]
    ratio = statistics.median(each_ratio)
    report.target(
        "seek in the MKV over seek in the folder", ratio, ("<=", MOST_SEEK_RATIO)
    )
    apart_s = np.abs(np.subtract(shown["MKV"], shown["folder"])).max()
    report.target("frames shown after a seek, s apart", float(apart_s), ("<=", 0.001))
    report.figures["seeks"] = {"n": count, "rows": rows, "ratio": ratio}
