"""Damaged clips: no crash, no hang, bounded memory, and lost frames are marked.

Seeded mutations of a clip (MP4 1000, MKV, WebM, MOV and AVI 200 each) are played from
beginning to end, each in a process with limits. The rules that mark a clip as damaged
were made with seed 0, so another seed judges them.
"""

import argparse
import os

from benchmarks.campaign import campaign
from benchmarks.common import Report

LEAST_MARKED = 0.95


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("--share", type=float, help="of all mutations (1.0)")
    parser.add_argument("--seed", type=int, default=0)


def run(options: argparse.Namespace, report: Report) -> None:
    """Play all files."""
    os.environ["CAMPAIGN_SEED"] = str(options.seed)
    share = options.share or (0.02 if options.quick else 1.0)
    test = "tests/faults/test_campaigns.py::test_damaged_clips"
    cases = campaign(report, test, share=share)
    report.table(
        "Damaged clips",
        ["container", *cases[0].figures],
        [[case.name, *case.figures.values()] for case in cases],
    )
    lossy, marked = (sum(c.figures[k] for c in cases) for k in ("lossy", "marked"))
    if lossy:
        what = f"share marked of {lossy} clips that lost frames"
        report.target(what, marked / lossy, (">=", LEAST_MARKED))
    report.figures |= {"seed": options.seed, "share": share}
    report.figures["clips"] = {case.name: case.figures for case in cases}
