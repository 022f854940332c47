"""The program is killed while a participant answers; see benchmarks/kill.py."""

import importlib.util
import sys
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
KILLS = 25


@pytest.fixture(scope="module")
def kill():
    spec = importlib.util.spec_from_file_location("kill", BENCHMARKS / "kill.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["kill"] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    yield module
    del sys.modules["kill"]


def test_no_answer_that_was_shown_as_kept_is_lost(kill):
    tally = kill.measure(kill.Tally(), KILLS, seed=25)
    assert tally.kills == KILLS
    assert tally.acknowledged > KILLS / 2, vars(tally)
    assert (tally.lost, tally.unreadable, tally.not_resumed) == (0, 0, 0), tally.told
