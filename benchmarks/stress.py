"""Every fault of `tests/faults/motion_cases.py`, ours beside the packages.

    python benchmarks/stress.py [--long] [--methods smoother,ekf] [--only WORD]

Ours is `repair_samples` and `remove_gravity` with each method; `raw VQF` and
`raw offlineVQF` are the package with the raw arrays, as its manual shows. A cell is
the RMS inclination error in degrees from 10 s after the fault on, over the samples
that are marked valid, with the share of the recording that is not (NaN for the
packages, which mark nothing), or the error. `--long` adds 10^7 samples (5 GB, and
a minute and a half). Writes benchmarks/results/stress.json and stress.md.
"""

import argparse
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from common import RESULTS, ROOT, save, table

from hapticplayer.errors import HapticPlayerError
from hapticplayer.motion import DEFAULT_METHOD, METHODS, remove_gravity
from hapticplayer.motion.repair import repair_samples

sys.path.insert(0, str(ROOT / "tests" / "faults"))
from motion_cases import Case, Outcome, all_cases, case
from motion_scoring import inclination_deg, score, true_up_at, vertical
from motion_signal import RATE_HZ, Scene

LONG = 10_000_000
RATE_0 = "rate 0"

Answer = dict[str, Any]


def ours(method: str) -> Callable[[Case], Answer]:
    """Return the runner of one of our methods."""

    def run(case: Case) -> Answer:
        raw = case.raw
        try:
            imu = repair_samples(raw.time_s, raw.force, raw.rate, raw.field).imu
            track = remove_gravity(imu, method)
        except HapticPlayerError as error:
            return {"error": type(error).__name__, "says": str(error)}
        up = vertical(track.quaternion_wxyz)
        error_deg = inclination_deg(up, true_up_at(case, track.time_s))
        valid = track.valid & np.isfinite(error_deg)
        return asdict(score(case, track.time_s, error_deg, valid))

    return run


def package(name: str) -> Callable[[Case], Answer]:
    """Return the runner of VQF or offlineVQF with the arrays as they are."""
    import vqf

    def run(case: Case) -> Answer:
        raw, interval_s = case.raw, 1.0 / RATE_HZ
        if case.name == RATE_0:
            return _rate_0(name)
        try:
            if name == "offlineVQF":
                result = vqf.offlineVQF(raw.rate, raw.force, raw.field, interval_s)
            else:
                result = vqf.VQF(interval_s).updateBatch(raw.rate, raw.force, raw.field)
        except Exception as error:  # noqa: BLE001 - whatever it raises is the answer
            return {"error": type(error).__name__, "says": str(error)}
        q = result["quat6D" if raw.field is None else "quat9D"]
        error_deg = inclination_deg(vertical(q), raw.up)
        return asdict(score(case, raw.true_s, error_deg, np.isfinite(error_deg)))

    return run


def _rate_0(name: str) -> Answer:
    """Return what an interval of 0 does, in a process that may die of it."""
    call = {
        "VQF": "vqf.VQF(0.0).updateBatch(a, a)",
        "offlineVQF": "vqf.offlineVQF(a, a, None, 0.0)",
    }[name]
    code = f"import numpy, vqf; a = numpy.ones((10, 3)); {call}"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False
    )
    says = done.stderr.strip().splitlines()[-1] if done.stderr else ""
    if done.returncode < 0:
        return {"error": signal.Signals(-done.returncode).name, "says": says}
    return {"error": says.split(":")[0] or "no error", "says": says}


def cell(answer: Answer) -> str:
    """Return one cell of the table."""
    if "error" in answer:
        return str(answer["error"])
    share = round(100.0 * np.nan_to_num(answer["invalid_share"]))
    after = "-" if np.isnan(answer["after"]) else f"{answer['after']:.2f}"
    return f"{after} ({share} %)" if share else after


def long_case() -> Case:
    """Return 28 hours."""
    return case(f"{LONG:.0e} samples", scene=Scene(time_s=np.arange(LONG) / RATE_HZ))


def write_markdown(header: list[str], rows: list[list[str]]) -> Path:
    """Write the table for the documentation."""
    lines = ["| " + " | ".join(row) + " |" for row in [header, *rows]]
    lines.insert(1, "|" + "---|" * len(header))
    path = RESULTS / "stress.md"
    path.write_text("\n".join(lines) + "\n")
    return path


def main() -> None:
    """Run and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--long", action="store_true", help="add 10^7 samples")
    parser.add_argument("--methods", default=",".join(METHODS), help="of ours")
    parser.add_argument("--only", default="", help="cases that hold this word")
    options = parser.parse_args()
    cases = [c for c in all_cases() if options.only in c.name]
    runners = {name: ours(name) for name in options.methods.split(",")}
    runners |= {f"raw {name}": package(name) for name in ("VQF", "offlineVQF")}
    if options.long:
        cases.append(long_case())
    answers: dict[str, dict[str, Answer]] = {}
    for one in cases:
        answers[one.name] = {}
        for name, run in runners.items():
            begin_s = time.perf_counter()
            answers[one.name][name] = run(one)
            answers[one.name][name]["seconds"] = time.perf_counter() - begin_s
    header = ["input", "expected", *runners]
    rows = [
        [one.name, expected(one), *map(cell, answers[one.name].values())]
        for one in cases
    ]
    print(table(header, rows))
    if not options.only:
        print(write_markdown(header, rows))
        figures = {"default": DEFAULT_METHOD, "cases": _plain(answers)}
        print(save("stress", figures))


def expected(one: Case) -> str:
    """Return what the tests demand."""
    if one.outcome is Outcome.DEGRADED:
        return f"<= {one.bound_deg:g}"
    return one.outcome.value


def _plain(value: Any) -> Any:
    """Return the figures with NaN as null, which JSON knows."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, float):
        return None if np.isnan(value) else round(value, 6)
    return value


if __name__ == "__main__":
    main()
