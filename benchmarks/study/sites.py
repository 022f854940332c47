"""Many sites: sessions of 20 machines are merged, and nothing is lost."""

import argparse
import dataclasses
import functools
import shutil
import tempfile
import time
from pathlib import Path

import numpy as np

from benchmarks.common import Report
from benchmarks.study.sessions import write_apart
from hapticplayer.clock import ManualClock
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.answers import Participant, read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.merging import merge_sessions
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.sites import site_of
from hapticplayer.study.study_folder import Study, open_study

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
    """A copy of the study in which simulated people took part."""
    answers = simulated_answers(people, "paper", seed=seed)
    shutil.copytree(home.folder, target)
    rng = np.random.default_rng(seed)

    def take_part(copy: Study, person: Participant) -> None:
        ratings = tuple(r for r in answers.ratings if r.participant == person.code)
        one = dataclasses.replace(answers, participants=(person,), ratings=ratings)
        origin = {"simulated": True, "seed": int(rng.integers(10**6))}
        write_answers(copy, one, ManualClock(), origin=origin)

    writers = [functools.partial(take_part, person=p) for p in answers.participants]
    write_apart(open_study(target), writers, seed)
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
