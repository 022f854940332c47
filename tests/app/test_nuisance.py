"""Normal use of the window, in any order: the loop reacts to nothing but what is done.

The script and its judge are those of `benchmarks/nuisance.py`, which goes on for half an
hour. Here a busy machine is no fault: what it can bring about is not counted.
"""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from app.player.video_surface import VideoSurface
from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import Measurements, Snapshot

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
from nuisance_script import Places, Script
from nuisance_watch import OF_LOAD, Watch

pytestmark = pytest.mark.skipif(
    not Path("/proc/self").exists(), reason="the haptics process needs Linux"
)
PATIENT_S = 15.0  # on a busy machine the window's thread reacts late
LONG_MS = 15_000


def imu_log(folder: Path) -> Path:
    """Write a motion log: two seconds of shaking."""
    time_s = np.arange(0.0, 2.0, 0.005)
    rows = np.zeros((len(time_s), 7))
    rows[:, 0], rows[:, 3] = time_s, 9.8 + np.sin(12.0 * time_s)
    path = folder / "imu.csv"
    header = "time_s,ax,ay,az,gx,gy,gz"
    np.savetxt(path, rows, "%.5f", delimiter=",", header=header, comments="")
    return path


def test_using_the_window_causes_no_unintended_reaction(
    make_window, source, sequence, clip, tmp_path, wait_for, qtbot
):
    window = make_window("simulated")
    wait_for(lambda: window.player.snapshot().tick is not None)
    window.session.show_source(source)
    window.player.play()
    watch = Watch(window.player, PATIENT_S)
    places = Places(sequence, clip, imu_log(tmp_path), tmp_path)
    script = Script(window, watch, SystemClock(), places, seed=4, haste=0.1)
    script.start()
    qtbot.wait(LONG_MS)
    wait_for(lambda: len(script.done) > 10 and watch.modes["ENTERING"] > 1000)
    script.stop()
    wrong = [r for r in watch.nuisances() if r.cause not in OF_LOAD]
    assert not wrong, wrong


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
        watch.look()

    return watch, show


def test_a_ramp_that_nobody_has_asked_for_is_a_nuisance(judge):
    watch, show = judge
    show((1.0, Mode.IDLE, Cause.NO_TRACK), (2.0, Mode.ENTERING, Cause.NONE))
    assert not watch.reactions
    show((3.0, Mode.FOLLOWING, Cause.NONE), (3.1, Mode.RAMPING, Cause.PAUSED))
    show((3.2, Mode.IDLE, Cause.PAUSED))
    (nuisance,) = watch.nuisances()
    assert (nuisance.cause, nuisance.monotonic_s) == (Cause.PAUSED, 3.1)
    assert nuisance.had_force
    assert not nuisance.is_trip


def test_an_action_explains_its_own_causes_for_a_while(judge):
    watch, show = judge
    watch.expect(3.0, "seek", Cause.SEEK)
    show((2.9, Mode.FOLLOWING, Cause.NONE), (3.2, Mode.RAMPING, Cause.SEEK))
    show((3.25, Mode.ENTERING, Cause.NONE), (3.28, Mode.RAMPING, Cause.PAUSED))
    show((3.29, Mode.ENTERING, Cause.NONE), (3.31, Mode.RAMPING, Cause.SEEK))
    assert [r.by for r in watch.reactions] == ["seek", "", ""]


def test_a_late_heartbeat_counts_without_force_too(judge):
    watch, show = judge
    show((1.0, Mode.IDLE, Cause.PAUSED), (1.1, Mode.IDLE, Cause.HEARTBEAT_LATE))
    show((1.2, Mode.IDLE, Cause.PAUSED), (1.3, Mode.TRIPPED, Cause.HEARTBEAT_LOST))
    show((1.4, Mode.TRIPPED, Cause.HEARTBEAT_LOST))
    late, lost = watch.nuisances()
    assert (late.cause, late.had_force) == (Cause.HEARTBEAT_LATE, False)
    assert (lost.cause, lost.is_trip) == (Cause.HEARTBEAT_LOST, True)


def test_a_fault_while_painting_leaves_no_painter_behind(qtbot, qtlog, monkeypatch):
    """Qt dies of one; what was raised keeps its frames, and with them the painter."""
    surface = VideoSurface()
    qtbot.addWidget(surface)
    surface.show()
    qtbot.waitExposed(surface)

    def fail(_self, _painter, _region):
        raise ValueError("a fault of ours")

    with qtbot.captureExceptions() as raised, monkeypatch.context() as patch:
        patch.setattr(VideoSurface, "_paint", fail)
        surface.update()
        qtbot.waitUntil(lambda: bool(raised))
    assert "a fault of ours" in str(raised[0][1])
    with qtbot.waitSignal(surface.target_changed):
        surface.resize(surface.width() + 100, surface.height() + 100)
    surface.repaint()
    qtbot.wait(50)
    assert not [r.message for r in qtlog.records if "painte" in r.message]
