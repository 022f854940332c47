"""Many sites: sessions of 20 machines are merged, and nothing is lost."""

import argparse
import os
import shutil
import tempfile
import time
from pathlib import Path
from unittest.mock import patch

import numpy as np

from benchmarks.common import Report
from hapticplayer.clock import ManualClock
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.merging import merge_sessions
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.sites import site_of
from hapticplayer.study.study_folder import SESSIONS, Study, open_study

MOST_S = 30.0


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--sites", type=int, default=20)
    parser.add_argument("--participants", type=int, default=50, help="of each site")


def run(options: argparse.Namespace, report: Report) -> None:
    """Simulate the sessions of each site, then merge them all."""
    sites = 4 if options.quick else options.sites
    people = 10 if options.quick else options.participants
    with tempfile.TemporaryDirectory() as folder:
        home = create_study(Path(folder) / "home")
        copies = {
            f"site-{n:02}": simulated(home, Path(folder) / f"site-{n:02}", people, n)
            for n in range(sites)
        }
        begun_s, processor_s = time.monotonic(), time.process_time()
        merged = [merge_sessions(home, one, name) for name, one in copies.items()]
        took_s = time.monotonic() - begun_s
        processor_s = time.process_time() - processor_s
        lost = missing(home, copies)
        answers = read_answers(home.folder)
    given = sum(one.value is not None for one in answers.ratings)
    report.target("merge of all sites, s", took_s, ("<=", MOST_S))
    report.target("sessions or answers lost", lost, ("<=", 0))
    report.target("conflicts", sum(len(one.conflicts) for one in merged), ("<=", 0))
    rows = [
        ["sites", sites],
        ["participants", len(answers.participants)],
        ["sites of participants", len({one.site for one in answers.participants})],
        ["ratings", given],
        ["processor, s", round(processor_s, 1)],
    ]
    report.figures["merged"] = rows
    report.table("Merged", ["what", "number"], rows, "merged")


def simulated(home: Study, target: Path, people: int, seed: int) -> Study:
    """A copy of the study in which simulated people took part; nothing is synced."""
    answers = simulated_answers(people, "paper", seed=seed)
    shutil.copytree(home.folder, target)
    (target / SESSIONS).mkdir(exist_ok=True)
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory(dir=target.parent) as making, patch("os.fsync"):
        for number, person in enumerate(answers.participants):
            place = Path(making) / f"{number}"  # else orders are counted each time
            shutil.copytree(home.folder, place)
            one = answers.__class__(
                (person,),
                tuple(r for r in answers.ratings if r.participant == person.code),
                answers.sequences,
                answers.feedbacks,
                answers.factors,
            )
            origin = {"simulated": True, "seed": int(rng.integers(10**6))}
            (code,) = write_answers(
                open_study(place), one, ManualClock(), origin=origin
            )
            os.rename(place / SESSIONS / code, target / SESSIONS / code)  # noqa: PTH104
    return open_study(target)


def missing(home: Study, copies: dict[str, Study]) -> int:
    """The number of sessions that are not here byte for byte, with their site."""
    lost = 0
    for name, copy in copies.items():
        for code in copy.codes():
            here, there = home.session_folder(code), copy.session_folder(code)
            is_same = (here / ANSWERS).read_bytes() == (there / ANSWERS).read_bytes()
            lost += not is_same or site_of(here) != name
    return lost
