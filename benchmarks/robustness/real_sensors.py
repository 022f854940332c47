"""Logs whose sensors contradict each other, or their units gravity.

One log with a known motion is changed as a recorder, a range or a person changes it. Right
is a question that names what would fit; its first answer is given and leads to the motion.
"""

import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.robustness.as_typed import CASES, Found, Row, hapticplayer, read_as

_LOG = CASES / "gcsv-header" / "thumb_rx.gcsv"
_RMS_MPS2 = 1.07
Table = NDArray[np.float64]
Keys = dict[str, float]


def rows() -> list[Row]:
    """All rows."""
    asked = [
        ("gyro at half its range", _key("gscale", 0.5), "rate-unit=2"),
        ("gyro at a quarter", _key("gscale", 0.25), "rate-unit=4"),
        ("gyro at double its range", _key("gscale", 2.0), "rate-unit=0.5"),
        ("gyro in deg/s", _key("gscale", 180.0 / np.pi), "rate-unit=deg/s"),
        (
            "gyro converted twice",
            _key("gscale", np.pi / 180.0),
            "rate-unit=57.2957795",
        ),
        ("gyro 0.3 s late", _late(0.3), "rate-delay=0.30"),
        ("gyro 0.3 s early", _late(-0.3), "rate-delay=-0.30"),
        ("accelerometer in cm/s2", _key("ascale", 980.665), "accel-unit=cm/s2"),
        ("accelerometer in m/s2", _key("ascale", 9.80665), "accel-unit=m/s2"),
    ]
    made = [
        Row("sensors", what, f"asks for {answer}, which mends it", _asked(how, answer))
        for what, how, answer in asked
    ]
    named = [
        ("gyro's x reads 0", _dead, "reads exactly 0 about x"),
        ("accelerometer of one bit", _flickering, "stuck"),
        ("times in ms as seconds", _key("tscale", 1e3), "divide tscale by 1000"),
    ]
    made += [
        Row("sensors", what, f"refused: {words}", _named(how, words))
        for what, how, words in named
    ]
    return made


Change = Callable[[Keys, Table], None]


def _key(name: str, times: float) -> Change:
    def change(keys: Keys, _table: Table) -> None:
        keys[name] *= times

    return change


def _late(late_s: float) -> Change:
    def change(keys: Keys, table: Table) -> None:
        time_s = keys["tscale"] * table[:, 0]
        for axis in (1, 2, 3):
            table[:, axis] = np.interp(time_s - late_s, time_s, table[:, axis])

    return change


def _dead(_keys: Keys, table: Table) -> None:
    table[:, 1] = 0.0


def _flickering(_keys: Keys, table: Table) -> None:
    bits = np.random.default_rng(1).integers(0, 2, (200, 3))
    table[450:650, 4:7] = table[450, 4:7] + bits


def _written(folder: Path, change: Change) -> Path:
    """The log, changed; keys with numbers and the table."""
    head, names, body = _LOG.read_text().partition("t,rx,ry,rz,ax,ay,az\n")
    lines = [line.split(",") for line in head.splitlines()]
    keys = {key: float(cells[0]) for key, *cells in lines if key.endswith("scale")}
    table = np.array([line.split(",") for line in body.splitlines()], dtype=float)
    change(keys, table)
    top = [",".join([key, *cells]) for key, *cells in lines if key not in keys]
    top += [f"{key},{value:.12g}" for key, value in keys.items()]
    cells = [",".join(f"{value:.0f}" for value in row) for row in table]
    path = folder / "sensors.gcsv"
    path.write_text("\n".join([*top, names.strip(), *cells]) + "\n")
    return path


def _asked(change: Change, answer: str) -> Callable[[Path], Found]:
    def run(folder: Path) -> Found:
        path = _written(folder, change)
        asked = hapticplayer("process", path)
        first = re.search(r"--read-as ([^\s,]+)", asked.said)
        if asked.status != 2 or first is None or first[1] != answer:
            return Found(asked.short, is_right=False)
        ran = hapticplayer("process", path, "--json", *read_as(answer))
        if ran.status:
            return Found(ran.short, is_right=False)
        rms_mps2 = json.loads(ran.out)["motion"]["rms_mps2"]
        is_right = abs(rms_mps2 / _RMS_MPS2 - 1.0) < 0.05
        return Found(f"{answer}, then RMS {rms_mps2:.2f} m/s2", is_right)

    return run


def _named(change: Change, words: str) -> Callable[[Path], Found]:
    def run(folder: Path) -> Found:
        ran = hapticplayer("process", _written(folder, change))
        return Found(ran.short, bool(ran.status) and words in ran.said)

    return run
