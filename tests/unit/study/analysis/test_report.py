import csv
import json
import os
import re
import stat
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.clock import SystemClock
from hapticplayer.doctor import ROOT
from hapticplayer.errors import Cancelled, InputError
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, analyse
from hapticplayer.study.analysis.analysis import STATISTICS, summary
from hapticplayer.study.analysis.figures import factors_by_feedback
from hapticplayer.study.analysis.report import parts_of, write_report
from hapticplayer.study.analysis.scores import SCALE
from hapticplayer.study.analysis.statistic import Statistic, rounded
from hapticplayer.study.creation import create_study

NASTY = "<script>alert(1)</script> $x^2$ $ \\frac é"


@pytest.fixture(scope="module")
def analysis(make_answers, quick):
    answers = make_answers(5, 8, sequences=2, holes=0.01)
    return analyse(answers, AnalysisOptions(resampling=quick))


@pytest.fixture(scope="module")
def report(analysis, tmp_path_factory):
    target = tmp_path_factory.mktemp("report") / "out"
    write_report(parts_of(analysis), target, "Study of rides")
    return target


def test_everything_is_there(report):
    names = {"report.html", "report.pdf", "numbers.json"}
    names |= {"conditions.csv", "tests.csv", "scores.csv"}
    for figure in ("qoe-by-sequence", "factors-by-feedback", "effects-by-measure"):
        names |= {f"{figure}{suffix}" for suffix in (".svg", ".pdf", ".png")}
    assert {path.name for path in report.iterdir()} == names
    numbers = json.loads((report / "numbers.json").read_text())
    assert not {"levels", "factor_ranks"} & numbers.keys()  # no factors of sequences


def test_a_spread_beyond_the_scale_is_drawn_whole(make_answers, quick):
    lowest = make_answers(5, 8, sequences=1)
    ratings = [
        replace(r, value=2 if r.participant == lowest.participants[0].code else 1)
        for r in lowest.ratings
    ]
    found = analyse(
        replace(lowest, ratings=tuple(ratings)), AnalysisOptions(resampling=quick)
    )
    (panel,) = factors_by_feedback(found, list(found.scores.factors), SCALE).axes
    ends = np.concatenate([line.get_ydata() for line in panel.lines])
    assert ends.min() == pytest.approx(1.125 - np.sqrt(1 / 8))
    assert panel.get_ylim()[0] < ends.min()


def test_only_its_owner_can_read_it(report):
    assert stat.S_IMODE(report.stat().st_mode) == 0o700
    assert {stat.S_IMODE(path.stat().st_mode) for path in report.iterdir()} == {0o600}


def test_the_same_answers_give_the_same_bytes(analysis, report, tmp_path):
    write_report(parts_of(analysis), tmp_path / "again", "Study of rides")
    for path in report.iterdir():
        assert (tmp_path / "again" / path.name).read_bytes() == path.read_bytes(), path


def test_the_page_needs_nothing_from_elsewhere_and_runs_nothing(report):
    text = (report / "report.html").read_text(encoding="utf-8")
    assert "<script" not in text
    addresses = re.findall(r'(?:src|href)="([^"]{0,30})', text)
    assert len(addresses) == 3
    assert all(one.startswith("data:image/svg+xml;base64,") for one in addresses)


def test_the_page_is_well_formed(report):
    class Checker(HTMLParser):
        def __init__(self):
            super().__init__()
            self.open = []

        def handle_starttag(self, tag, attrs):
            if tag not in {"meta", "img"}:
                self.open.append(tag)

        def handle_endtag(self, tag):
            assert self.open.pop() == tag

    checker = Checker()
    checker.feed((report / "report.html").read_text(encoding="utf-8"))
    assert checker.open == []


def test_the_numbers_are_those_of_the_analysis(analysis, report):
    numbers = json.loads((report / "numbers.json").read_text(encoding="utf-8"))
    assert numbers == rounded({**summary(analysis), "over_time": {}})
    with (report / "tests.csv").open(encoding="utf-8") as lines:
        rows = {tuple(row[:4]): row[4] for row in csv.reader(lines)}
    chi2 = float(rows["friedman", "qoe", "", "chi2"])
    assert chi2 == pytest.approx(analysis.found["friedman"]["qoe"]["chi2"], 1e-11)
    with (report / "conditions.csv").open(encoding="utf-8") as lines:
        table = {
            (r["measure"], r["sequence"], r["feedback"]): r
            for r in csv.DictReader(lines)
        }
    mean = analysis.measures["comfort"].conditions["clip-1"]["none"].mean
    assert float(table["comfort", "clip-1", "none"]["mean"]) == pytest.approx(
        mean, 1e-11
    )


ANALYSE = """
import sys
from pathlib import Path
from hapticplayer.study.analysis import AnalysisOptions, Resampling
from hapticplayer.study.analysis.report import analyse_study, write_report
from hapticplayer.study.answers import read_answers

study, target = map(Path, sys.argv[1:])
options = AnalysisOptions(resampling=Resampling(1, 99))
write_report(analyse_study(read_answers(study), options), target, "Rides")
"""


def test_numbers_do_not_depend_on_threads_locale_or_zone(tmp_path, monkeypatch):
    study = create_study(tmp_path / "study")
    answers = simulated_answers(9, "paper", seed=1)
    write_answers(study, answers, SystemClock(), origin={"simulated": True})
    here, there = tmp_path / "here", tmp_path / "there"
    other = {"OPENBLAS_NUM_THREADS": "2", "LC_ALL": "C.UTF-8", "TZ": "Asia/Kolkata"}
    subprocess.run(
        [sys.executable, "-c", ANALYSE, study.folder, there],
        cwd=ROOT,
        env={**os.environ, **other},
        check=True,
        capture_output=True,
    )
    monkeypatch.setattr(sys, "argv", ["", study.folder, here])
    exec(ANALYSE, {})
    paths = list(here.iterdir())
    assert len(paths) > 10
    for path in paths:
        assert path.read_bytes() == (there / path.name).read_bytes(), path


def test_numbers_are_rounded_to_twelve_digits():
    assert rounded([1 / 3, {"p": 2e-20 / 3, "n": 5}]) == [
        0.333333333333,
        {"p": 6.66666666667e-21, "n": 5},
    ]


def test_who_is_missing_is_said_in_the_report(report, analysis):
    text = (report / "report.html").read_text(encoding="utf-8")
    assert analysis.scores.missing > 0
    assert f"{analysis.scores.missing} of 192 answers are missing" in text


def test_names_from_a_definition_are_only_shown(make_answers, quick, tmp_path):
    answers = make_answers(5, 4, sequences=1, feedbacks=("none", NASTY))
    named = tuple(replace(one, sequence=NASTY) for one in answers.ratings)
    odd = replace(answers, ratings=named, sequences=(NASTY,))
    found = analyse(odd, AnalysisOptions(resampling=quick))
    write_report(parts_of(found), tmp_path / "x", NASTY)
    text = (tmp_path / "x" / "report.html").read_text(encoding="utf-8")
    assert "<script" not in text
    assert "&lt;script&gt;alert(1)&lt;/script&gt; $x^2$" in text
    assert "$x^2$" in (tmp_path / "x" / "qoe-by-sequence.svg").read_text("utf-8")


def test_an_existing_folder_is_refused(analysis, report):
    with pytest.raises(InputError, match="already exists"):
        write_report(parts_of(analysis), report, "again")


def test_a_cancelled_report_leaves_nothing_behind(analysis, tmp_path):
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.6:
            raise Cancelled

    with pytest.raises(Cancelled):
        write_report(parts_of(analysis), tmp_path / "report", "x", stop)
    assert list(tmp_path.iterdir()) == []


def test_a_statistic_in_the_registry_is_in_every_output(
    make_answers, quick, tmp_path, monkeypatch, capsys
):
    def spread(sample, _resampling):
        return sample.each_feedback(
            lambda _name, column: {"ptp": float(np.ptp(column))}
        )

    entry = Statistic("dummy", "Spread of the participants", spread)
    monkeypatch.setitem(STATISTICS, "dummy", entry)
    found = analyse(make_answers(5, 6, sequences=1), AnalysisOptions(resampling=quick))
    write_report(parts_of(found), tmp_path / "x", "Study")
    numbers = json.loads((tmp_path / "x" / "numbers.json").read_text("utf-8"))
    expected = np.ptp(found.measures["qoe"].sample.values[:, 0])
    assert numbers["dummy"]["qoe"]["none"]["ptp"] == expected
    assert (
        f"dummy,qoe,none,ptp,{expected}" in (tmp_path / "x" / "tests.csv").read_text()
    )
    assert "Spread of the participants" in (tmp_path / "x" / "report.html").read_text()
    assert cli.main(["study", "analyse", "--help"]) == 0
    assert "Spread of the participants" in capsys.readouterr().out
