"""The judge of `benchmarks.robustness nuisance`: which reactions nothing explains."""

from types import SimpleNamespace

import numpy as np
import pytest

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Measurements, Snapshot
from tools.reactions import Watch


@pytest.fixture
def judge():
    """Return a judge and a way to show it ticks: (time, mode, cause)."""
    history = TickHistory()
    player = SimpleNamespace(
        ticks_since=history.since, snapshot=Snapshot, measurements=Measurements
    )
    watch = Watch(player, grace_s=0.3)

    def show(*rows) -> None:
        ticks = np.zeros(len(rows), dtype=TICK)
        for tick, (at_s, mode, cause) in zip(ticks, rows, strict=True):
            tick["monotonic_s"], tick["mode"], tick["cause"] = at_s, mode, cause
        history.add(ticks, 0)
        watch.read()

    return watch, show


def test_an_unexplained_ramp_is_a_nuisance(judge):
    """A RAMP without an action."""
    watch, show = judge
    show((1.0, Mode.IDLE, Cause.NO_TRACK), (2.0, Mode.ENTERING, Cause.NONE))
    assert not watch.reactions
    show((3.0, Mode.FOLLOWING, Cause.NONE), (3.1, Mode.RAMPING, Cause.PAUSED))
    show((3.2, Mode.IDLE, Cause.PAUSED))
    (nuisance,) = watch.reactions
    assert (nuisance.cause, nuisance.monotonic_s) == (Cause.PAUSED, 3.1)
    assert (nuisance.by, nuisance.had_force, nuisance.is_trip) == ("", True, False)


def test_an_action_explains_its_own_causes_for_a_while(judge):
    """Other causes, and later ones, are nuisances."""
    watch, show = judge
    watch.expect(3.0, "seek", Cause.SEEK)
    show((2.9, Mode.FOLLOWING, Cause.NONE), (3.2, Mode.RAMPING, Cause.SEEK))
    show((3.25, Mode.ENTERING, Cause.NONE), (3.28, Mode.RAMPING, Cause.PAUSED))
    show((3.29, Mode.ENTERING, Cause.NONE), (3.31, Mode.RAMPING, Cause.SEEK))
    assert [r.by for r in watch.reactions] == ["seek", "", ""]


def test_a_late_heartbeat_counts_without_force_too(judge):
    """And a trip always."""
    watch, show = judge
    show((1.0, Mode.IDLE, Cause.PAUSED), (1.1, Mode.IDLE, Cause.HEARTBEAT_LATE))
    show((1.2, Mode.IDLE, Cause.PAUSED), (1.3, Mode.TRIPPED, Cause.HEARTBEAT_LOST))
    show((1.4, Mode.TRIPPED, Cause.HEARTBEAT_LOST))
    late, lost = watch.reactions
    assert (late.cause, late.had_force) == (Cause.HEARTBEAT_LATE, False)
    assert (lost.cause, lost.is_trip) == (Cause.HEARTBEAT_LOST, True)
