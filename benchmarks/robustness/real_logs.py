"""Logs as people have them: those of other programs, and one written in many ways.

What is right, the program that wrote a log says, or the log of which it is a spelling.
"""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks.robustness.as_typed import (
    CASES,
    CLIP,
    Found,
    Row,
    hapticplayer,
    imported,
    read_as,
    says,
)

Rows = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

SAME_LOG = CASES / "gcsv-header" / "thumb_rx.gcsv"
TABLE = ("accel-unit=g", "rate-unit=rad/s", "time-unit=s")
SIX = "columns=time,ax,ay,az,gx,gy,gz"
RATE_HZ = 50.0
WHOLE, HALF = (1.07,), (0.59,)
"""RMS of the motion of the log of which all tables are spellings, m/s2; of its first 8 s."""


def rows() -> list[Row]:
    """All rows."""
    return [*_logs(), *_spellings()]


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
