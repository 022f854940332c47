"""Where no force is planned nothing is interpolated; the exchange goes on at 1 kHz."""

import numpy as np
import pytest

from hapticplayer.haptics import step as step_module
from hapticplayer.haptics.limiter import ZERO
from hapticplayer.haptics.track import LoadedTrack
from hapticplayer.model import ForceTrack
from tests.unit.haptics.test_loop import Rig

TICKS = 3000
WITHIN_S = (1.0, 2.0)


class CountedReads:
    """A view whose reads are counted."""

    def __init__(self, view):
        self._view, self.count = view, 0

    def __getitem__(self, key):
        self.count += 1
        return self._view[key]

    def __iter__(self):
        """The check at load reads everything, and is not counted."""
        return iter(self._view)


@pytest.fixture
def counted(monkeypatch):
    """Count reads of forces, calls of the limiter and exchanges."""
    counts = {"forces": [], "limit": 0, "exchange": 0}
    original, limit = LoadedTrack.__init__, step_module.limit

    def init(self, block, *more):
        original(self, block, *more)
        self._force_n = CountedReads(self._force_n)
        counts["forces"].append(self._force_n)

    def counted_limit(*args):
        counts["limit"] += 1
        return limit(*args)

    monkeypatch.setattr(LoadedTrack, "__init__", init)
    monkeypatch.setattr(step_module, "limit", counted_limit)
    return counts


def run(track, counts):
    """Play a track for 3 s and return the records of all ticks."""
    rig = Rig()
    exchange = rig.loop.device.exchange

    def counted_exchange(*args):
        counts["exchange"] += 1
        return exchange(*args)

    rig.loop.device.exchange = counted_exchange
    try:
        rig.give_track(track)
        rig.play()
        rig.tick(TICKS)
        return rig.block.read_ticks(0)[0]
    finally:
        rig.close()


def gentle():
    """1 s of force between two of nothing; small, so that the hand stays inside."""
    time_s = np.arange(0.0, 3.001, 0.01)
    force_n = np.zeros((len(time_s), 3))
    is_on = (time_s > WITHIN_S[0]) & (time_s < WITHIN_S[1])
    force_n[is_on, 1] = 0.5 * np.sin(np.pi * (time_s[is_on] - WITHIN_S[0])) ** 2
    return ForceTrack(time_s, force_n)


def test_spans_without_force_skip_interpolation_and_limits(counted):
    track = gentle()
    records = run(track, counted)
    media_s = records["media_s"]
    wanted = np.interp(media_s, track.time_s, track.force_n[:, 1])
    np.testing.assert_allclose(records["planned_n"][:, 1], wanted, atol=1e-6)
    is_inside = (media_s >= WITHIN_S[0]) & (media_s < WITHIN_S[1])
    assert is_inside.sum() == pytest.approx(1000, abs=2)
    reads_per_tick = 6
    (forces,) = counted["forces"]
    assert forces.count == pytest.approx(reads_per_tick * is_inside.sum(), abs=12)
    # in the span, and while the limiter lets the force in or out
    assert 900 <= counted["limit"] <= 1300
    assert counted["exchange"] == TICKS


def test_feedback_none_sends_exactly_zero(counted):
    time_s = np.arange(0.0, 3.001, 0.01)
    records = run(ForceTrack(time_s, np.zeros((len(time_s), 3))), counted)
    assert counted["forces"][0].count == 0
    assert counted["exchange"] == TICKS
    assert {tuple(force) for force in records["force_n"].tolist()} == {ZERO}


def test_without_skipping_the_commands_are_the_same(counted, monkeypatch):
    records = run(gentle(), counted)
    original = LoadedTrack.__init__

    def unskipped(self, block, *more):
        original(self, block, *more)
        self._span_edges_s = [-1.0]  # everything counts as active

    monkeypatch.setattr(LoadedTrack, "__init__", unskipped)
    whole = run(gentle(), counted)
    assert np.array_equal(whole["force_n"], records["force_n"])
    assert np.array_equal(whole["position_m"], records["position_m"])
    assert counted["forces"][1].count > 2.5 * counted["forces"][0].count
