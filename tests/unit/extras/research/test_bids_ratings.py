"""Ratings while clips play, as physio of BIDS."""

import gzip
import json

import pytest

from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.study_export import export_study
from tests.bids import errors_in
from tests.unit.study.conftest import VALUES
from tests.unit.study.test_runner import RunningSession
from tests.unit.study.test_watching import ALL, sampled

GAP_S = 5.0


@pytest.fixture
def dataset(tmp_path, manual_clock):
    """The dataset of two clips with a gap between."""
    made = create_study(tmp_path / "study")
    content = {**json.loads(made.content), "while_watching": ALL}
    running = RunningSession(change_definition(made, content), manual_clock)
    running.to_trials()
    running.runner.proceed()
    sampled(running, 1.0)
    running.runner.watching.change("match", 30.0)
    running.runner.watching.change("vection", 1.0)
    sampled(running, 60.0)
    running.runner.watching.give("fms", 3)
    sampled(running, 0.5)
    running.end_clip()
    running.clock.advance(GAP_S)
    running.runner.answer(VALUES)
    running.runner.proceed()
    sampled(running, 1.0)
    running.end_clip()
    running.runner.answer(VALUES)
    running.runner.close()
    export_study(running.study, tmp_path / "out", "bids")
    return tmp_path / "out"


def test_ratings_are_a_table_of_equal_steps_with_gaps(dataset):
    (path,) = dataset.glob("sub-*/beh/*_run-1_recording-rating_physio.tsv.gz")
    text = gzip.decompress(path.read_bytes()).decode()
    rows = [line.split("\t") for line in text.splitlines()]
    described = json.loads(path.with_name(path.name[:-6] + "json").read_text())
    columns = ["trial", "attempt", "media", "match", "fms", "vection"]
    assert (described["Columns"], described["SamplingFrequency"]) == (columns, 50.0)
    first, second = ([row for row in rows if row[0] == one] for one in "12")
    between = [row for row in rows if row[0] == "n/a"]
    assert (len(first), len(second)) == (round(61.5 * 50), 50)
    assert len(between) == pytest.approx(50 * GAP_S, abs=2)
    media_s = [float(row[2]) for row in first]
    assert media_s[0] == pytest.approx(0.008)
    assert media_s[-1] - media_s[0] == pytest.approx(61.48)
    assert [first[0][3], first[-1][3], second[0][3]] == ["0", "30", "0"]
    assert [first[0][4], first[-1][4], second[-1][4]] == ["n/a", "3", "n/a"]
    assert [first[0][5], first[-1][5], second[-1][5]] == ["0", "1", "0"]


def test_the_official_validator_finds_no_error(dataset):
    assert errors_in(dataset) == []
