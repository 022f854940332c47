"""A recorder that is killed at random moments: what can be read, and how much is missing.

The recorder is the program itself, with a test camera, a test microphone and a board on a
pseudo-terminal. SIGKILL comes some time after the first frame; then the folder is imported.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

from benchmarks.common import Report, positive
from tests.material.recording import killed

EARLIEST_S, LATEST_S = 1.0, 4.0
MOST_LOST_S = 1.0


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--kills", type=positive, help="(50)")
    parser.add_argument("--seed", type=int, default=49)


def run(options: argparse.Namespace, report: Report) -> None:
    count = options.kills or (5 if options.quick else 50)
    rng = np.random.default_rng(options.seed)
    moments_s = rng.uniform(EARLIEST_S, LATEST_S, count)
    with tempfile.TemporaryDirectory(prefix="hp-record-") as folder:
        found = [
            killed(Path(folder) / f"{number}", float(at_s))
            for number, at_s in enumerate(moments_s)
        ]
    whole = [one for one in found if not one.problem]
    lost_s = np.array([(one.film_lost_s, one.motion_lost_s) for one in whole])
    rows = [
        [stream, f"{np.median(values):.2f}", f"{values.max():.2f}"]
        for stream, values in zip(("film", "motion"), lost_s.T, strict=True)
    ]
    report.table(
        f"Missing at the end after {count} kills",
        ["stream", "median s", "most s"],
        rows,
    )
    report.target("recordings that cannot be read", count - len(whole), ("<=", 0))
    report.target("missing at the end, s", float(lost_s.max()), ("<=", MOST_LOST_S))
    report.figures |= {
        "kills": count,
        "lost_s": lost_s.round(3).tolist(),
        "problems": [one.problem for one in found if one.problem],
    }
