"""Time of `study analyse` with its report, and of the libraries that do parts of it.

The command runs as a process of its own, from its start to its last file; its processor time does not depend on what else runs.
The reference
runs in the same rounds on the same answers: intervals of the means by
`scipy.stats.bootstrap` and the analyses of variance by `statsmodels.stats.anova.AnovaRM`.
"""

import argparse
import functools
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import scipy
from statsmodels.stats.anova import AnovaRM

from benchmarks.common import ROOT, Report, interleaved, ratio
from benchmarks.study.sessions import write_apart
from hapticplayer.clock import SystemClock
from hapticplayer.model.ranges import SIMULATED_PARTICIPANTS
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import Resampling
from hapticplayer.study.analysis.aligned_ranks import EFFECTS, aligned_ranks, structure
from hapticplayer.study.analysis.scores import scores_of
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.study_folder import Study

_AT_ONCE = int(SIMULATED_PARTICIPANTS.largest)
TARGETS_S = {15: 5.0, 200: 8.0, 1000: 15.0}
_MOST_FOR_REFERENCE = 200  # 4 min of a core for one variance of 1000


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--participants", type=int, nargs="+", help="(15 80 200 1000)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Analyse simulated studies of several sizes."""
    sizes = options.participants or ([15] if options.quick else [15, 80, 200, 1000])
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for people in sizes:
            rows.append(one := _measure(Path(folder) / str(people), people))
            if limit := TARGETS_S.get(people):
                what = f"{people} participants, report, processor s"
                report.target(what, one["processor_s"], ("<=", limit))
    report.figures["participants"] = rows
    report.table("Analyses", list(rows[0]), [one.values() for one in rows])


def _measure(study: Path, people: int) -> dict[str, Any]:
    make_study(study, people)
    values = scores_of(read_answers(study))
    qoe, processor_s = values.of("qoe"), list[float]()
    contenders = {
        "report": lambda: _report(study, processor_s),
        "mean": lambda: _timed(lambda: _means(values.ratings)),
        "variance": lambda: _timed(lambda: structure(qoe, values.participants)),
    }
    if people <= _MOST_FOR_REFERENCE:
        contenders["scipy"] = lambda: _timed(lambda: _scipy_means(values.ratings))
        contenders["statsmodels"] = lambda: _timed(lambda: _library_variance(qoe))
    found = interleaved(contenders, 3)
    seconds = {name: float(np.median(each)) for name, each in found.items()}
    figures: dict[str, Any] = {"participants": people}
    figures["processor_s"] = float(np.median(processor_s))
    figures |= {f"{name}_s": value for name, value in seconds.items()}
    for ours, library in (("mean", "scipy"), ("variance", "statsmodels")):
        known = library in found
        each = ratio(found[ours], found[library]) if known else None
        figures[f"{library}_s"] = seconds.get(library)
        figures[f"{ours} / {library}"] = each.median if each else None
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3
    return {**figures, "memory_mb": peak}


def make_study(folder: Path, people: int) -> None:
    """Write a study of simulated participants, in parts that are then put together."""
    study, firsts = create_study(folder), range(0, people, _AT_ONCE)

    def take_part(copy: Study, first: int) -> None:
        count, seed = min(_AT_ONCE, people - first), first // _AT_ONCE
        answers = simulated_answers(count, "paper", seed=seed)
        write_answers(copy, answers, SystemClock(), origin={"simulated": True})

    write_apart(study, [functools.partial(take_part, first=f) for f in firsts], people)


def _report(study: Path, processor_s: list[float]) -> float:
    target = study.with_name("report")
    command = [sys.executable, "-m", "app", "study", "analyse", str(study)]

    def analyse() -> None:
        subprocess.run(
            [*command, "--output", str(target)],
            cwd=ROOT,
            check=True,
            capture_output=True,
        )

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = _timed(analyse)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    processor_s.append(used)
    shutil.rmtree(target)
    return seconds


def _timed(work: Callable[[], object]) -> float:
    begin_s = time.perf_counter()
    work()
    return time.perf_counter() - begin_s


def _means(ratings: np.ndarray) -> None:
    for column in ratings.reshape(len(ratings), -1).T:
        Resampling().mean_interval(column, "benchmark")


def _scipy_means(ratings: np.ndarray) -> None:
    for column in ratings.reshape(len(ratings), -1).T:
        scipy.stats.bootstrap((column,), np.mean, method="percentile", batch=1000)


def _library_variance(values: np.ndarray) -> None:
    for effect in EFFECTS:
        ranks = aligned_ranks(values, effect)
        person, sequence, feedback = (axis.ravel() for axis in np.indices(ranks.shape))
        columns = {"p": person, "s": sequence, "f": feedback}
        table = pd.DataFrame({"y": ranks.ravel(), **columns})
        AnovaRM(table, "y", "p", within=["s", "f"]).fit()
