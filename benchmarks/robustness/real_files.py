"""Files and services as people have them: what the program says, beside the right value.

Each row is a command of the program as a person types it, with a file of another program
or one that was changed on purpose. Right is a value that another witness gave (the one
that made the file, or other software), or a refusal that names the cause and a remedy.
With `--quick` without the rows that play in real time.
"""

import argparse
import csv
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks.common import DATA, Report
from benchmarks.robustness import real_forces, real_logs, real_sensors
from benchmarks.robustness.as_typed import (
    CASES,
    CLIP,
    Found,
    Ran,
    Row,
    hapticplayer,
    imported,
    read_as,
    says,
)

Rows = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

# --- clips -------------------------------------------------------------------------


def burst(clip: Path, flash_s: float) -> Callable[[Path], Found]:
    """The burst of a whole or cut clip is at its flash, or the clip is doubted."""

    def run(folder: Path) -> Found:
        ran, target = imported(folder, clip)
        if ran.status:
            return says(ran, "telemetry|motion|clock|frames|offset")
        with np.load(target / "motion.npz") as motion:
            time_s, motion_mps2 = motion["time_s"], motion["acceleration_mps2"]
        size = np.linalg.norm(motion_mps2, axis=1)
        strong_s = time_s[size > 0.5 * size.max()]
        found_s = float(strong_s[0])
        is_right = abs(found_s - flash_s) < 0.05
        return Found(f"burst begins at {found_s:.3f} s", is_right)

    return run


def _clips() -> list[Row]:
    other, cut = CASES / "other-camera", CASES / "gopro-cut"
    flashes = {"whole": 6.0, "cut_input_seek": 3.7, "cut_lossless": 3.7}
    rows = [
        Row("gopro-cut", f"{name}.mp4", f"burst at {at_s} s, or doubted",
            burst(cut / f"{name}.mp4", at_s))
        for name, at_s in flashes.items()
    ]  # fmt: skip
    makers = {"camm.mp4": "camm", "insta.insv": "insta360", "rtmd.mp4": "sony"}
    rows += [
        Row("other-camera", name, f"names {maker} and what reads it",
            lambda folder, name=name, maker=maker: says(
                imported(folder, other / name)[0], maker))
        for name, maker in makers.items()
    ]  # fmt: skip
    karma = DATA / "capture" / "gopro" / "karma.mp4"
    rows += [
        Row("other-camera", "insta.insv with zeros behind its end", "names insta360 and what reads it",
            lambda folder: says(imported(folder, _changed(folder, other / "insta.insv",
                lambda content: content + bytes(70_000)))[0], "insta360")),
        Row("gopro", "karma.mp4 whose track was renamed", "its motion at 198.6 Hz",
            lambda folder: _rate_of(_changed(folder, karma,
                lambda content: content.replace(b"GoPro MET", b"Core Meta")), 198.6)),
        Row("mpeg-ts", "camcorder.mts cut within a packet", "names the remux command",
            lambda folder: says(imported(folder, _changed(folder, CASES / "mpeg-ts/camcorder.mts",
                lambda content: content[100:]))[0], "-c:v copy|-c copy")),
        Row("pace", "a GoPro's time lapse", "asks for --slow-motion",
            lambda folder: says(imported(folder, _changed(folder, karma, _as_lapse))[0],
                "2 frames per second", "--slow-motion")),
    ]  # fmt: skip
    rows += [
        Row("mpeg-ts", "play camcorder.mts", "plays, or names the remux command",
            lambda _: _plays_or(CASES / "mpeg-ts/camcorder.mts", "remux|-c copy"), plays=True),
        Row("reading", "a simulated ride, x and y of both sensors swapped",
            "asks for accel-axes=y,x,z rate-axes=y,x,z",
            lambda folder: _reads_otherwise(folder, _swapped, "accel-axes=y,x,z rate-axes=y,x,z"),
            plays=True),
        Row("reading", "a simulated ride, rates 57 times too small",
            "refused: times 57.3", lambda folder: _reads_otherwise(folder, _slowed, "57\\.29"),
            plays=True),
        Row("report", "import of a simulated ride with three taps",
            "the true offset, and no line against it", _report, plays=True),
        Row("vfr-called-damaged", "play lowlight_30_to_20.mp4", "says nothing of damage",
            lambda _: _plays_or(CASES / "vfr-called-damaged/lowlight_30_to_20.mp4"), plays=True),
    ]  # fmt: skip
    return rows


def _changed(folder: Path, clip: Path, change: Callable[[bytes], bytes]) -> Path:
    target = folder / clip.name
    target.write_bytes(change(clip.read_bytes()))
    return target


def _as_lapse(content: bytes) -> bytes:
    """A clip with the settings of a GoPro's time lapse in a box at its end."""
    settings = b"MTYPB\1\0\1\1\0\0\0RATEc\6\0\x010_5SEC\0\0"
    box = (8 + len(settings)).to_bytes(4, "big") + b"GPMF" + settings
    return content + box


def _rate_of(clip: Path, rate_hz: float) -> Found:
    ran = hapticplayer("process", clip, "--json")
    if ran.status:
        return Found(ran.short, is_right=False)
    got_hz = json.loads(ran.out)["recording"]["rate_hz"]
    return Found(f"{got_hz:.1f} Hz", abs(got_hz - rate_hz) < 0.2)


AGAINST = ("not synchronised", "give --offset", "three times", "bad:", "record again")


def _swapped(cells: Rows) -> Rows:
    return cells[:, [0, 2, 1, 3, 5, 4, *range(6, cells.shape[1])]]


def _slowed(cells: Rows) -> Rows:
    scale = np.ones(cells.shape[1])
    scale[4:7] = np.pi / 180.0
    return cells * scale


def _reads_otherwise(
    folder: Path, change: Callable[[Rows], Rows], answer: str
) -> Found:
    """Whether an import asks about the log of a simulated ride that was changed."""
    ride = folder / "bike"
    if not ride.exists():
        hapticplayer("simulate", "bike", "-o", ride, limit_s=300.0)
    head, *lines = (ride / "imu.csv").read_text("utf-8").splitlines()
    cells = np.array([[float(one) for one in line.split(",")] for line in lines])
    log = folder / "changed.csv"
    np.savetxt(log, change(cells), "%.9f", ",", header=head, comments="")
    words = ("import", ride / "clip.mp4", "-o", folder / "s", "--imu", log)
    return says(hapticplayer(*words, limit_s=300.0), answer)


def _report(folder: Path) -> Found:
    """Every line of the report of a ride whose offset is known."""
    ride = folder / "ride"
    made = hapticplayer("simulate", "car-braking", "-o", ride, limit_s=300.0)
    if made.status:
        return Found(made.short, is_right=False)
    ran, _ = imported(
        folder,
        ride / "clip.mp4",
        "--imu",
        ride / "imu.csv",
        *read_as("sampling=averaged"),
    )
    truth = json.loads((ride / "recording.json").read_text(encoding="utf-8"))
    found = re.search(
        r"offset (-?[\d.]+) s by \w+, confidence ([\d.]+)", ran.out + ran.said
    )
    if ran.status or found is None:
        return Found(ran.short, is_right=False)
    off_s = abs(float(found[1]) - truth["clock"]["offset_s"])
    lines = (ran.out + ran.said).lower().splitlines()
    against = [line for line in lines if any(words in line for words in AGAINST)]
    got = f"{1e3 * off_s:.1f} ms off, confidence {found[2]}, {len(against)} lines against it"
    return Found(got, off_s < 0.01 and float(found[2]) > 0.9 and not against)


def _plays_or(clip: Path, *words: str) -> Found:
    ran = hapticplayer("play", clip, "--headless", "--mute")
    if ran.status:
        return says(ran, *words) if words else Found(ran.short, is_right=False)
    return Found(ran.short, "damaged" not in ran.said)


# --- study and devices -------------------------------------------------------------


def _services() -> list[Row]:
    rows = [
        Row("xdf-header", "study export --format xdf", "uid, created_at, session_id, hostname", _xdf),
        Row("texts-csv", "study export --format csv", "no cell is a formula", _texts),
    ]  # fmt: skip
    rows += [
        Row("intiface", f"gap of {gap_ms} ms", f"about {6000 // gap_ms} commands, or said",
            lambda folder, gap_ms=gap_ms: _intiface(folder, gap_ms), plays=True)
        for gap_ms in (40, 70, 100)
    ]  # fmt: skip
    return rows


def _study(folder: Path, form: str) -> tuple[Ran, Path]:
    study, out = folder / "study", folder / form
    shutil.rmtree(out, ignore_errors=True)
    if not study.exists():
        made = hapticplayer("study", "simulate", study, "--participants", 2)
        if made.status:
            return made, out
    return hapticplayer("study", "export", study, "-o", out, "--format", form), out


def _xdf(folder: Path) -> Found:
    ran, out = _study(folder, "xdf")
    if ran.status:
        return Found(ran.short, is_right=False)
    missing = set()
    for path in out.rglob("*.xdf"):
        for header in re.findall(
            rb"<info>(?:(?!</info>).)*<name>.*?</info>", path.read_bytes(), re.DOTALL
        ):
            wanted = (b"uid", b"created_at", b"session_id", b"hostname")
            missing |= {
                name.decode() for name in wanted if b"<%b>" % name not in header
            }
    got = f"missing: {', '.join(sorted(missing)) or 'nothing'}"
    return Found(got, not missing and any(out.rglob("*.xdf")))


def _texts(folder: Path) -> Found:
    ran, out = _study(folder, "csv")
    if ran.status:
        return Found(ran.short, is_right=False)
    cells = [
        cell
        for path in out.rglob("*.csv")
        for row in csv.reader(path.open(encoding="utf-8-sig", newline=""))
        for cell in row
    ]
    formulas = [c for c in cells if re.match(r"[=+@\t\r]|-(?![\d.])", c)]
    return Found(
        f"{len(cells)} cells, {len(formulas)} formulas", cells != [] and not formulas
    )


def _intiface(folder: Path, gap_ms: int) -> Found:
    port, log = 12000 + gap_ms, folder / f"toy{gap_ms}"
    fake = [CASES / "intiface" / "fake_intiface.py", "ok", "4", port, log, gap_ms]
    with subprocess.Popen([sys.executable, *map(str, fake)], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as service:  # fmt: skip
        ran = hapticplayer(
            "play", CLIP, "--force", CASES / "intiface" / "vib.csv", "--headless", "--mute",
            "--duration", 6, "--device", f"buttplug:127.0.0.1:{port}",
        )  # fmt: skip
        service.terminate()
    text = log.read_text(encoding="utf-8") if log.exists() else ""
    count = len(re.findall("OutputCmd|ScalarCmd|LinearCmd|VibrateCmd", text))
    expected = 6000 / gap_ms
    # a strength that the toy has already is not sent again
    is_right = 0.7 * expected <= count <= 1.2 * expected and not ran.status
    is_said = ran.status == 1 and "gap" in ran.said
    return Found(f"{ran.status}: {count} commands", is_right or is_said)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--only", default="", help="rows whose case contains this")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run all rows; none may be wrong."""
    if not CASES.exists():
        sys.exit(f"the cases are not here: {CASES.name}")
    rows = [
        *real_logs.rows(),
        *real_sensors.rows(),
        *_clips(),
        *real_forces.rows(),
        *_services(),
    ]
    rows = [row for row in rows if options.only in row.case]
    rows = [row for row in rows if not (options.quick and row.plays)]
    found = []
    with tempfile.TemporaryDirectory(prefix="hp-real-") as folder:
        for row in rows:
            got = row.run(Path(folder))
            found.append((row, got))
    report.figures["rows"] = [
        {"case": row.case, "input": row.what, "right": row.right, "got": got.got,
         "is_right": got.is_right}
        for row, got in found
    ]  # fmt: skip
    report.table(
        "files and services as people have them",
        ("case", "input", "right", "got", ""),
        [
            (r.case, r.what, r.right, g.got, "" if g.is_right else "WRONG")
            for r, g in found
        ],
    )
    wrong = sum(not got.is_right for _, got in found)
    report.target(f"wrong, of {len(found)}", wrong, ("<=", 0))
