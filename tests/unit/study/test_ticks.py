"""Ticks that a record says, but no device had, are left out; all others stay."""

import numpy as np
import pytest

from hapticplayer.haptics.records import RecordWriter, open_record
from hapticplayer.haptics.shared import TICK
from hapticplayer.study.ticks import tick_chunks

COUNT, FRAME = 1000, 100


def read(tmp_path, lies):
    """The times (ms) that are read of a record of 1 s in frames of 0.1 s, with lies."""
    ticks = np.zeros(COUNT, TICK)
    ticks["monotonic_s"] = 5000.0 + np.arange(COUNT) / 1000.0
    for row, time_s in lies.items():
        ticks["monotonic_s"][row] = time_s
    path = tmp_path / "ticks-01.hprec"
    writer = RecordWriter(open_record(path))
    writer.begin({})
    for first in range(0, COUNT, FRAME):
        writer.append(first, 0, ticks[first : first + FRAME])
    writer.append(COUNT, 0, ticks[:0])
    notices: list[str] = []
    read_s = np.concatenate([one["monotonic_s"] for one in tick_chunks(path, notices)])
    return np.rint(1e3 * (read_s - 5000.0)).astype(int).tolist(), notices


@pytest.mark.parametrize(
    "lies",
    [
        {},
        {250: 5100.0},
        {299: 9e8},
        {300: 6000.0},
        {250: 6000.0, 251: 6000.1, 650: 5400.0},
        {250: 0.0, 700: 4000.0},
        {0: 1.0},
        {0: 9000.0},
        {COUNT - 1: 9000.0},
        {row: 7000.0 + row for row in range(120, 150)},
        {400: np.nan, 500: np.inf, 600: -np.inf},
    ],
)
def test_a_lying_time_costs_no_other_tick(tmp_path, lies):
    found, notices = read(tmp_path, lies)
    assert found == [row for row in range(COUNT) if row not in lies]
    said = f"{len(lies)} ticks have times or values"
    assert notices == [] if not lies else said in notices[0]


def test_a_loop_that_stood_still_loses_nothing(tmp_path):
    """As after SIGSTOP: the clock has gone on."""
    late = {row: 5500.0 + row / 1000.0 for row in range(400, COUNT)}
    found, notices = read(tmp_path, late)
    assert len(found) == COUNT
    assert notices == []
