"""Trials of thresholds: what simulated observers recover of their true values.

Observers of one sensitivity sit through whole sessions of each kind, as files on the
disk, and `analyse` has to find their threshold, criteria or exponent again.
"""

import argparse
import json
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy import stats

from benchmarks.common import Report
from benchmarks.study.sessions import write_apart
from hapticplayer.clock import ManualClock
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.analysis import AnalysisOptions, Resampling
from hapticplayer.study.analysis.report import analyse_study
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study, definition_text
from hapticplayer.study.definition import Condition
from hapticplayer.study.study_folder import Study, open_study

MOST_ERROR = 0.05
JND = float(stats.norm.ppf(0.75))
SPREAD_S, SPREAD, EXPONENT, LAPSE = 0.2, 0.3, 0.8, 0.02
LOWER_S, UPPER_S = -0.15, 0.25
Values = Mapping[str, Any]
Numbers = Mapping[str, Any]


class Observers(NamedTuple):
    """A template with changes, how an observer answers, and what is to be found."""

    name: str
    template: str
    changes: Mapping[str, Any]
    answer: Callable[[np.random.Generator], Callable[..., Values]]
    truth: Mapping[str, float]
    found: Callable[[Numbers], Mapping[str, Any]]


def chooser(
    key: str, felt: Callable[[Condition], float]
) -> Callable[[np.random.Generator], Callable[..., Values]]:
    """Choose the clip of which more is felt, with noise in the difference."""

    def observer(rng: np.random.Generator) -> Callable[..., Values]:
        def answer(first: Condition, second: Condition) -> Values:
            is_second = felt(second) - felt(first) + rng.normal() > 0.0
            if rng.random() < LAPSE:
                is_second = rng.random() < 0.5
            return {key: "second" if is_second else "first"}

        return answer

    return observer


def judge(rng: np.random.Generator) -> Callable[..., Values]:
    """Yes while the perceived delay lies between two criteria."""

    def answer(one: Condition) -> Values:
        felt = one.delay_s + SPREAD_S / 2 * rng.normal()
        return {"consistent": bool(LOWER_S < felt < UPPER_S)}

    return answer


def estimator(rng: np.random.Generator) -> Callable[..., Values]:
    """Numbers on a scale of one's own, by a power law."""
    scale = np.exp(rng.normal(3.0, 0.5))

    def answer(one: Condition) -> Values:
        felt = scale * one.gain**EXPONENT * np.exp(0.15 * rng.normal())
        return {"strength": max(1, round(float(felt)))}

    return answer


def threshold_of(axis: str) -> Callable[[Numbers], Mapping[str, Any]]:
    return lambda numbers: numbers["levels"][axis]["curves"]["all"]


def staircase(correct: int) -> Observers:
    rule = {"changes": "delay_s", "correct": correct, "start": 0.6}
    rule |= {"steps": [0.1, 0.05], "trials": 40}
    return Observers(
        f"staircase, {correct}-down 1-up",
        "staircase",
        {"staircase": rule},
        chooser("later", lambda one: one.delay_s / SPREAD_S),
        {"threshold": JND * SPREAD_S},
        threshold_of("delay_s"),
    )


ALL = (
    staircase(2),
    staircase(3),
    Observers(
        "two intervals, constant levels",
        "two-interval",
        {"repeats": 3},
        chooser("stronger", lambda one: np.log(one.gain) / SPREAD),
        {"threshold": float(np.exp(JND * SPREAD)), "equal": 1.0},
        threshold_of("gain"),
    ),
    Observers(
        "yes or no",
        "consistency",
        {"repeats": 2},
        judge,
        {"window": UPPER_S - LOWER_S},
        threshold_of("delay_s"),
    ),
    Observers(
        "magnitudes",
        "magnitude",
        {},
        estimator,
        {"mean": EXPONENT},
        lambda numbers: numbers["exponents"]["all"],
    ),
)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--observers", type=int, help="of each kind (400)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Let observers of each kind take part."""
    count = options.observers or (60 if options.quick else 400)
    rows = []
    for number, kind in enumerate(ALL):
        numbers = simulated(kind, count, number)
        found = kind.found(numbers)
        for name, true in kind.truth.items():
            error = abs(found[name] / true - 1.0)
            slack = 2.0 if options.quick else 1.0
            report.target(
                f"{kind.name}: {name}, error", error, ("<=", slack * MOST_ERROR)
            )
            low, high = found.get("intervals", {}).get(name) or found["interval"]
            between = f"{low:.3f} to {high:.3f}"
            rows.append([kind.name, name, true, round(found[name], 4), between])
        for one in numbers.get("staircases", ()):
            mean = round(one["mean"], 4)
            rows.append([kind.name, "mean of reversals", "", mean, one["sequence"]])
    report.figures["found"] = rows
    header = ["trials", "value", "true", "found", "95 %"]
    report.table(f"What {count} observers recover", header, rows, "found")


def simulated(kind: Observers, count: int, seed: int) -> Numbers:
    """The numbers of the report of a study in which observers took part."""
    rng = np.random.default_rng([2012, seed])
    with tempfile.TemporaryDirectory() as folder:
        study = create_study(Path(folder) / "study", kind.template)
        content = {**json.loads(study.content), **kind.changes}
        content["sequences"] = content["sequences"][:1]
        path = study.folder / "study.json"
        path.write_bytes(definition_text(content))
        study = open_study(study.folder)
        clock, origin = ManualClock(), {"simulated": True}

        def take_part(copy: Study) -> None:
            answer = kind.answer(rng)
            write_scripted_session(copy, {}, answer, clock, origin=origin)

        write_apart(study, [take_part] * count, seed)
        options = AnalysisOptions(resampling=Resampling(1, 499))
        return analyse_study(read_answers(study.folder), options).numbers
