"""Cumulative-link mixed models: coverage of their intervals in simulated studies.

Answers are drawn from the model itself (people and clips differ, five steps), so that the
true effects are known; the share of 95 % intervals that hold them is the coverage.
"""

import argparse
import time
from typing import NamedTuple

import numpy as np
import scipy

from benchmarks.common import Report
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.cumulative_link import LinkFunction, fit
from hapticplayer.study.analysis.model_power import LatentPopulation
from hapticplayer.study.analysis.ordinal_mixed import ordered_answers

LIMITS = (0.93, 0.97)
CUTS = (-2.0, -0.7, 0.7, 2.0)


class Setting(NamedTuple):
    """A design with its true effects against the first feedback."""

    link: LinkFunction
    people: int
    clips: int
    effects: tuple[float, ...]
    of_people: float
    of_clips: float
    of_cells: float = 0.0

    def drawn(self, rng: np.random.Generator) -> Floats:
        deviations = self.of_people, self.of_clips, self.of_cells
        truth = np.array(self.effects), *deviations
        population = LatentPopulation(self.link, np.array(CUTS), *truth)
        return population.drawn(self.people, self.clips, rng)


SETTINGS = (
    Setting(LinkFunction.LOGIT, 15, 4, (0.3, 1.0), 1.0, 0.5),
    Setting(LinkFunction.LOGIT, 15, 4, (0.0, 0.0), 1.0, 0.5),
    Setting(LinkFunction.PROBIT, 15, 4, (0.0, 0.8), 0.7, 0.3),
    Setting(LinkFunction.PROBIT, 40, 4, (0.2, 0.6), 0.7, 0.3),
    Setting(LinkFunction.LOGIT, 15, 4, (0.0, 1.0), 1.0, 0.5, 0.8),
)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--studies", type=int, help="of each setting (500)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Fit simulated studies of each setting."""
    studies = options.studies or (60 if options.quick else 500)
    rows = []
    for number, setting in enumerate(SETTINGS[: 1 if options.quick else None]):
        rng = np.random.default_rng([2012, number])
        found, held, processor_s = [], [], time.process_time()
        for _ in range(studies):
            answers = ordered_answers(setting.drawn(rng))
            model = fit(answers, setting.link) if answers else None
            if model is not None:
                apart = (model.effects - setting.effects) / model.errors
                found.append(apart)
                held.append(np.abs(apart) <= scipy.stats.t.isf(0.025, model.degrees))
        each_ms = 1e3 * (time.process_time() - processor_s) / studies
        z = np.array(found)
        coverage = float(np.mean(held))
        name = f"{setting.link.value}, {setting.people} people, {setting.effects}"
        name += ", people prefer different feedbacks" if setting.of_cells else ""
        slack = 0.04 if options.quick else 0.0
        report.target(f"{name}: coverage", coverage, (">=", LIMITS[0] - slack))
        report.target(f"{name}: coverage", coverage, ("<=", LIMITS[1] + slack))
        rows.append(
            [name, len(z), round(coverage, 3), round(float(np.nanmean(z)), 3), each_ms]
        )
    report.figures["settings"] = rows
    header = ["model", "studies", "coverage", "mean error / SE", "fit, processor ms"]
    report.table("Coverage of 95 % intervals", header, rows, "coverage")
