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
from benchmarks.robustness import real_forces, real_sensors
from benchmarks.robustness.as_typed import (
    CASES,
    Found,
    Ran,
    Row,
    hapticplayer,
    read_as,
    says,
)

Rows = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

CLIP = CASES / "intiface" / "clip.mp4"
SAME_LOG = CASES / "gcsv-header" / "thumb_rx.gcsv"
TABLE = ("accel-unit=g", "rate-unit=rad/s", "time-unit=s")
SIX = "columns=time,ax,ay,az,gx,gy,gz"
RATE_HZ = 50.0
WHOLE, HALF = (1.07,), (0.59,)
"""RMS of the motion of the log of which all tables are spellings, m/s2; of its first 8 s."""


# --- logs --------------------------------------------------------------------------


def log_as(path: Path, *answers: str, rms: tuple[float, ...] = WHOLE) -> Found:
    """Whether a log is read at 50 Hz, with its RMS of motion within 3 %."""
    ran = hapticplayer("process", path, "--json", *read_as(*answers))
    if ran.status:
        return Found(ran.short, is_right=False)
    report = json.loads(ran.out)
    motion, rate_hz = report["motion"], report["recording"]["rate_hz"]
    got = motion["rms_per_axis_mps2"] if len(rms) == 3 else [motion["rms_mps2"]]
    is_right = np.allclose(got, rms, rtol=0.03) and abs(rate_hz - RATE_HZ) < 0.5
    shown = ", ".join(f"{one:.2f}" for one in got)
    return Found(f"RMS {shown} m/s2 at {rate_hz:.1f} Hz", bool(is_right))


def imported(folder: Path, clip: Path, *more: object) -> tuple[Ran, Path]:
    target = folder / "s"
    shutil.rmtree(target, ignore_errors=True)
    return hapticplayer("import", clip, "-o", target, *more), target


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


def upwards(folder: Path) -> Found:
    """A log with Apple's sign: the remedy that is named leads to the right motion."""
    path = CASES / "accel-sign" / "ios.csv"
    more = ("--imu", path, "--offset", 0)
    asked, _ = imported(folder, CLIP, *more)
    if not says(asked, "accel-sign=-").is_right:
        return Found(asked.short, is_right=False)
    ran, target = imported(folder, CLIP, *more, *read_as("accel-sign=-"))
    if ran.status:
        return Found(ran.short, is_right=False)
    other, right = imported(folder / "other", CLIP, "--imu", SAME_LOG, "--offset", 0)
    if other.status:
        return Found(other.short, is_right=False)
    motions = [
        np.load(one / "motion.npz")["acceleration_mps2"] for one in (target, right)
    ]
    off_mps2 = float(np.abs(motions[0] - motions[1]).max())
    return Found(
        f"asked; then {off_mps2:.3f} m/s2 off the log with +1 g", off_mps2 < 0.05
    )


def frozen(name: str) -> Callable[[Path], Found]:
    """400 of 1200 rows repeat: asked about, or not valid there."""

    def run(folder: Path) -> Found:
        log = CASES / "frozen-sensor" / f"{name}.csv"
        ran, target = imported(folder, CLIP, "--imu", log, "--offset", 0)
        if ran.status:
            return says(
                ran, "12(\\.\\d+)?", "(19|20)(\\.\\d+)?|33", "same|repeat|stuck"
            )
        with np.load(target / "motion.npz") as motion:
            time_s, is_valid = motion["time_s"], motion["valid"]
        inside = (time_s > 12.1) & (time_s < 19.9)
        share = float(np.mean(~is_valid[inside])) if inside.any() else 0.0
        return Found(f"{share:.0%} of the span not valid, nothing asked", share > 0.99)

    return run


def _spelt(
    how: Callable[[list[list[str]]], str], *answers: str
) -> Callable[[Path], Found]:
    """Whether the phone's log is read that is written in another way."""

    def run(folder: Path) -> Found:
        path = CASES / "text-columns" / "sensorlog_ios.csv"
        rows = [line.split(",")[1:8] for line in path.read_text().splitlines()[1:]]
        spelt = folder / "spelt.txt"
        spelt.write_text(how(rows), encoding="utf-8")
        return log_as(spelt, "accel-sign=-", *answers, rms=HALF)

    return run


def _spellings() -> list[Row]:
    """Ways to write a table that other programs have, made here."""

    def lines(rows: list[list[str]], head: str = "t,ax,ay,az,gx,gy,gz") -> str:
        return "\n".join([head, *map(",".join, rows)])

    def r_names(rows: list[list[str]]) -> str:
        return lines([[f'"{k}"', *row] for k, row in enumerate(rows, start=1)])

    def arduino(rows: list[list[str]]) -> str:
        return lines([[f"12:00:00.000 -> {row[0]}", *row[1:]] for row in rows])

    def in_whole_seconds(rows: list[list[str]]) -> str:
        return lines([[row[0].partition(".")[0], *row[1:]] for row in rows])

    def in_days(rows: list[list[str]]) -> str:
        return lines([[f"{float(row[0]) / 86_400:.12f}", *row[1:]] for row in rows])

    before = (SIX.replace("time", "-,time"), *TABLE)
    days = (SIX, "accel-unit=g", "rate-unit=rad/s", "time-unit=d")
    made: list[tuple[str, Callable[[Path], Found]]] = [
        ("rows with names, of R", _spelt(r_names, *before)),
        ("clock times and arrows, of Arduino", _spelt(arduino, *before)),
        ("the newest row first", _spelt(lambda r: lines(r[::-1]), SIX, *TABLE)),
        ("whole seconds", _spelt(in_whole_seconds, SIX, *TABLE)),
        ("days of a spreadsheet", _spelt(in_days, *days)),
    ]
    return [Row("number-spellings", what, "RMS 0.59 m/s2 at 50 Hz", run)
            for what, run in made]  # fmt: skip


def _logs() -> list[Row]:
    cases = CASES
    read, half = "RMS 1.07 m/s2 at 50 Hz", "RMS 0.59 m/s2 at 50 Hz"
    rows = [
        Row("accel-sign", "import --imu ios.csv", "asks for accel-sign=-", upwards),
        Row(
            "gcsv-swapped",
            "swapped.gcsv",
            "refused: the columns are swapped",
            lambda folder: says(
                imported(
                    folder, CLIP, "--imu", cases / "gcsv-swapped/swapped.gcsv",
                    "--offset", 0,
                )[0],
                "swapped",
            ),
        ),
        Row(
            "si-csv-answers",
            "phone.csv axes=y,-x,z",
            "RMS 0.77, 0.56, 0.49, or refused",
            lambda _: log_as(
                cases / "si-csv-answers/phone.csv", "axes=y,-x,z", rms=(0.77, 0.56, 0.49)
            ),
        ),
    ]  # fmt: skip
    rows += [
        Row(
            "frozen-sensor",
            f"{name}.csv",
            "12 to 20 s: asked, or not valid",
            frozen(name),
        )
        for name in ("both_frozen", "gyro_frozen")
    ]
    rows += [
        Row("gcsv-header", path.name, read, lambda _, path=path: log_as(path))
        for path in sorted((cases / "gcsv-header").glob("*.gcsv"))
    ]
    spelt = sorted(
        p
        for p in (cases / "number-spellings").iterdir()
        if p.suffix in (".csv", ".txt")
    )
    rows += [
        Row(
            "number-spellings",
            path.name,
            f"{half}, or the cause and a remedy",
            lambda _, path=path: _read_or_named(path, SIX, *TABLE),
        )
        for path in spelt
    ]
    iphone = (
        "columns=-,time,ax,ay,az,gx,gy,gz,-", "accel-sign=-", *TABLE,
    )  # fmt: skip
    gopro = "columns=time,-,az,ax,ay,-/time,-,gz,gx,gy,-"
    text = cases / "text-columns"
    rows += [
        Row("text-columns", "sensorlog_ios.csv", half,
            lambda _: log_as(text / "sensorlog_ios.csv", *iphone, rms=HALF)),
        Row("text-columns", "gopro_ACCL.csv + gopro_GYRO.csv", half,
            lambda folder: _two_files(folder, (text / "gopro_ACCL.csv", text / "gopro_GYRO.csv"),
                gopro, "time-unit=ms", "accel-unit=m/s2", "rate-unit=rad/s")),
        Row("text-columns", "metawear_acc.csv + metawear_gyro.csv", half,
            lambda folder: _two_files(folder, (text / "metawear_acc.csv", text / "metawear_gyro.csv"),
                "columns=-,-,time,ax,ay,az/-,-,time,gx,gy,gz", "time-unit=s", "accel-unit=g",
                "rate-unit=deg/s")),
        Row("text-columns", "witmotion.txt", f"{half}, or the text column is named",
            lambda _: _read_or_named(text / "witmotion.txt",
                "columns=time,-,ax,ay,az,gx,gy,gz", "accel-unit=g", "rate-unit=deg/s")),
        Row("text-columns", "blackbox_decode.csv", "the remedy leads to a file that is read",
            lambda _: _read_or_named(text / "blackbox_decode.csv")),
        Row("text-columns", "blackbox_explorer.csv", "read, or the cause and a remedy",
            lambda _: _read_or_named(text / "blackbox_explorer.csv")),
    ]  # fmt: skip
    return rows


def _two_files(folder: Path, files: tuple[Path, ...], *answers: str) -> Found:
    both = folder / "both"
    both.mkdir(exist_ok=True)
    for old in both.iterdir():
        old.unlink()
    for path in files:
        shutil.copy(path, both)
    return log_as(both, *answers, rms=HALF)


def _read_or_named(path: Path, *answers: str) -> Found:
    """Whether a log is read rightly, or a sentence names a column and a remedy."""
    found = log_as(path, *answers, rms=HALF)
    ran = hapticplayer("process", path, *read_as(*answers))
    if found.is_right or not ran.status:
        return found
    return says(ran, "line \\d|column|row \\d", "--read-as")


# --- clips -------------------------------------------------------------------------


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
        *_logs(),
        *_spellings(),
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
