"""Hands under strong, long forces: kept inside, stable, passive, and predicted.

The real `step` with the physics of device and hand in virtual time; no clock, so the
figures are the same on every machine. Rides and hostile tracks for every hand, delay
and loss of packets; grips that are let go; free grips at the edge; the stability
boundary beside b / (T/2 + delay) and the eigenvalues of the sampled loop; the
prediction beside the full physics.
"""

import argparse

from benchmarks.campaign import Case, campaign
from benchmarks.common import Report

TESTS = "tests/faults/test_campaigns.py"


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--workers", type=int, default=2)


def run(options: argparse.Namespace, report: Report) -> None:
    """Run everything; the tests hold the limits."""
    quick = "(inside and relaxed and 0.003-0.1) or (let_go and 3-0.001) or boundary"
    only = quick if options.quick else "hands"
    cases = campaign(report, TESTS, only=only, workers=options.workers)
    kept = [case.figures for case in cases if "reach" in case.figures]
    rows, grouped = [], {}
    for one in kept:
        grouped.setdefault((one["track"], one["hand"]), []).append(one)
    for (track, hand), each in grouped.items():
        row = [track, hand, len(each), max(one["reach"] for one in each)]
        row += [min(one["energy_mj"] for one in each)]
        rows.append([*row, max(one["speed_mps"] for one in each)])
    header = ["track", "hand", "runs", "reach/R", "energy mJ", "m/s"]
    report.table("Hands, worst over delays and lost packets", header, rows)
    report.figures["hands"] = {"columns": header, "rows": rows}
    _worst(report, cases, "mass_kg", "speed_mps", "fastest grip let go, m/s")
    _worst(report, cases, "swing_mm", "swing_mm", "swing of a free grip at rest, mm")
    off = [abs(o["predicted"] - o["reach"]) for o in kept if "predicted" in o]
    if off:
        report.figures["prediction off by, of the workspace"] = max(off)
    rows = [
        list(case.figures.values())[:5] for case in cases if "formula" in case.figures
    ]
    rows.sort()
    header = ["delay ms", "found", "b/(T/2+d)", "look-ahead", "eigenvalues"]
    report.table("Largest stable stiffness of a free grip, N/m", header, rows)
    report.figures["boundary"] = {"columns": header, "rows": rows}


def _worst(report: Report, cases: list[Case], has: str, key: str, text: str) -> None:
    found = [case.figures[key] for case in cases if has in case.figures]
    if found:
        print(f"{text}: {max(found):.3g}, of {len(found)}")
        report.figures[text] = max(found)
