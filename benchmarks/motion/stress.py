"""Flawed recordings through repair and every method, beside the raw packages.

The cases are those of `tests/faults/motion_cases.py`. Ours is `repair_samples` and
`remove_gravity`; `raw VQF` and `raw offlineVQF` are the package with the arrays as they
are, as its manual shows. A cell is the RMS inclination error in degrees from 10 s after
the fault on, over samples marked valid, with the share that is not, or the error raised.
"""

import argparse
from typing import Any

from benchmarks.campaign import campaign
from benchmarks.common import Report


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--only", default="", help="cases with this word")


def run(options: argparse.Namespace, report: Report) -> None:
    """Run every case."""
    only = options.only or ("NaN" if options.quick else "")
    test = "tests/faults/test_campaigns.py::test_flawed_motion"
    cases = campaign(report, test, only=only)
    methods = list(cases[0].figures["methods"])
    rows = [
        [case.name, case.figures["expected"]]
        + [_cell(case.figures["methods"][method]) for method in methods]
        for case in cases
    ]
    report.table("Flawed recordings", ["input", "expected", *methods], rows)
    report.figures["columns"] = ["input", "expected", *methods]
    report.figures["rows"] = rows


def _cell(answer: dict[str, Any]) -> str:
    if "error" in answer:
        return str(answer["error"])
    share = round(100.0 * (answer["invalid_share"] or 0.0))
    after = "-" if answer["after"] is None else f"{answer['after']:.2f}"
    return f"{after} ({share} %)" if share else after
