"""Long forms of fault tests: `pytest -m campaign`, and the figures that they record.

The cases and what must hold for each belong to the tests; here they run in full, and
what they record (`record_property("figures", json)`) becomes a table and a result.
"""

import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.common import ROOT, Report


class Case(NamedTuple):
    """One test of a campaign: its parameters, figures, and how it failed, if so."""

    name: str
    figures: dict[str, Any]
    failure: str


def campaign(
    report: Report, test: str, *, share: float = 1.0, only: str = "", workers: int = 1
) -> list[Case]:
    """Run a campaign; return cases with figures. Failed ones are a missed target.

    Args:
        report: takes the target that no case fails.
        test: file and function, `tests/faults/test_x.py::test_y`.
        share: of the full number of mutations or cases.
        only: pattern of pytest's -k.
        workers: processes at once.
    """
    with tempfile.TemporaryDirectory(prefix="hp-campaign-") as folder:
        path = Path(folder) / "found.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-m", "campaign"]
        command += ["-p", "no:cacheprovider", "-o", "faulthandler_timeout=0"]
        command += ["-o", "junit_family=xunit1"]
        command += [f"--junitxml={path}", test]
        command += ["-k", only] if only else []
        command += ["-n", str(workers)] if workers > 1 else []
        environment = {**os.environ, "CAMPAIGN_SHARE": str(share)}
        environment |= {"QT_QPA_PLATFORM": "offscreen"}
        done = subprocess.run(
            command, cwd=ROOT, env=environment, stdout=sys.stderr, check=False
        )
        if done.returncode not in (0, 1):
            sys.exit(f"pytest ended with {done.returncode}: {' '.join(command)}")
        cases = [_case(element) for element in ET.parse(path).iter("testcase")]  # noqa: S314 - ours
    failed = [case for case in cases if case.failure]
    for case in failed:
        print(f"failed: {case.name}: {case.failure}")
    report.target(f"cases that fail, of {len(cases)}", len(failed), ("<=", 0))
    if not any(case.figures for case in cases):
        sys.exit("no case of the campaign has recorded anything")
    return [case for case in cases if case.figures]


def _case(element: ET.Element) -> Case:
    name = element.get("name", "").partition("[")[2].removesuffix("]")
    properties = {p.get("name"): p.get("value", "") for p in element.iter("property")}
    failures = [*element.iter("failure"), *element.iter("error")]
    text = (failures[0].get("message") or "failed").splitlines()[0] if failures else ""
    return Case(name, json.loads(properties.get("figures", "{}")), text)
