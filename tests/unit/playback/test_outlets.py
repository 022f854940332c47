"""Several outlets: each gets its signal and its clock; what one does leaves the others."""

import threading

import numpy as np
import pytest

from hapticplayer.errors import DeviceError, UsageError
from hapticplayer.haptics.block import REFUSED
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack, MotionTrack, PlaybackClock, RigTrack
from hapticplayer.model.device import ChannelLevel
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.outlets import LENT, NO_MOTION, Outlets
from hapticplayer.playback.player import Player

RIG, OTHER = "rig:outsim,gain=0.5,latency_ms=40", "rig:beamng"
TRACKS = {
    name: ForceTrack([0.0, 3.0], [[0, 1.0, 0]] * 2) for name in ("realistic", "random")
}
MOTION = MotionTrack(
    np.arange(3.0),
    np.ones((3, 3)),
    np.zeros((3, 3)),
    1.0,
    np.tile([1.0, 0, 0, 0], (3, 1)),
    None,
    np.ones(3, bool),
)
CLOCK = PlaybackClock(1, 1000.0, 0.0, 1.0, 1000.15)


class Processes:
    """Notes what an outlet would be given."""

    def __init__(self, _clock, device, **_options):
        self.device, self.health, self.problem = device, Health.READY, ""
        self.scheduling, self.pids = "normal", {"loop": 7}
        self.tracks, self.published, self.done = {}, [], []
        self.ticks, self.levels = np.empty(0, TICK), ()

    def load(self, tracks):
        self.tracks = dict(tracks)

    def replace(self, name, track):
        self.tracks[name] = track

    def publish(self, clock, track):
        self.published.append((clock, track))

    def poll(self):
        return self.health

    def read_ticks(self):
        ticks, self.ticks = self.ticks, np.empty(0, TICK)
        return ticks, 0

    def __getattr__(self, name):
        return lambda: self.done.append(name)


@pytest.fixture
def reporter(manual_clock):
    return Reporter(manual_clock)


@pytest.fixture
def outlets(manual_clock, reporter):
    made = Outlets(manual_clock, reporter, None, Processes)
    made.use([RIG, OTHER, "rumble"])
    made.load(TRACKS, MOTION)
    yield made
    made.close()


def processes_of(outlets, name):
    return outlets[name].output.processes


def test_each_outlet_gets_the_signal_that_it_takes(outlets):
    for name in (RIG, OTHER):
        given = processes_of(outlets, name).tracks
        assert list(given) == ["realistic"]
        assert isinstance(given["realistic"], RigTrack)
    assert list(processes_of(outlets, "rumble").tracks) == ["realistic", "random"]


def test_each_has_the_same_clock_ahead_by_its_own_latency(outlets):
    outlets.poll(CLOCK, "realistic")
    ahead, track = processes_of(outlets, RIG).published[-1]
    assert (ahead.media_s(1000.0), track) == (pytest.approx(0.040), "realistic")
    assert processes_of(outlets, OTHER).published[-1] == (CLOCK, "realistic")
    assert outlets.lead_s == pytest.approx(0.040)


def test_a_measured_latency_counts_where_none_was_entered(outlets):
    outlets.set_latencies(Latencies(device_s={RIG: 0.1, OTHER: 0.02}))
    assert outlets[RIG].latency_s == pytest.approx(0.040)
    assert outlets[OTHER].latency_s == pytest.approx(0.020)


def test_a_condition_without_motion_leaves_a_rig_in_neutral(outlets):
    outlets.poll(CLOCK, "random")
    assert processes_of(outlets, RIG).published[-1][1] == ""
    assert processes_of(outlets, "rumble").published[-1][1] == "random"
    states = {one.name: one for one in outlets.states("random")}
    assert states[RIG].note == NO_MOTION
    assert states["rumble"].note == ""


def test_without_motion_a_rig_gets_nothing(outlets):
    outlets.load(TRACKS, None)
    assert processes_of(outlets, RIG).tracks == {}
    outlets.poll(CLOCK, "realistic")
    assert processes_of(outlets, RIG).published[-1][1] == ""


def test_an_edited_force_reaches_outlets_and_those_that_come(outlets):
    edited = ForceTrack([0.0, 3.0], [[0, 2.0, 0]] * 2)
    outlets.replace("realistic", edited)
    assert processes_of(outlets, "rumble").tracks["realistic"] is edited
    assert isinstance(processes_of(outlets, RIG).tracks["realistic"], RigTrack)
    outlets.use(["rumble"])
    assert processes_of(outlets, "rumble").tracks["realistic"] is edited


def test_an_outlet_has_its_own_condition_or_is_mute(outlets):
    outlets["rumble"].feedback = "random"
    outlets[OTHER].is_muted = True
    outlets.poll(CLOCK, "realistic")
    played = {one.name: one.output.processes.published[-1][1] for one in outlets}
    assert played == {RIG: "realistic", OTHER: "", "rumble": "random"}
    outlets.poll(CLOCK, "")  # withheld: also from those with their own condition
    assert {one.output.processes.published[-1][1] for one in outlets} == {""}


def test_levels_are_shown_and_the_loudest_reported(outlets, manual_clock):
    processes, quiet = processes_of(outlets, "rumble"), ChannelLevel(3, 0.1, False)
    for now in (quiet, ChannelLevel(3, 0.5, True), quiet):
        processes.levels = (now,)
        outlets.poll(CLOCK, "realistic")
        manual_clock.advance(0.05)
    states = {one.name: one for one in outlets.states("realistic")}
    assert states["rumble"].levels == (quiet,)
    assert states[RIG].levels == ()
    (channel,) = outlets.summary()["rumble"]["channels"]
    assert channel == {"channel": 3, "peak_db": -6.0, "is_limited": True}
    outlets.restart_meters()
    assert outlets.summary()["rumble"]["channels"] == []


def test_stop_and_re_arm_reach_all(outlets):
    outlets.stop()
    outlets.rearm()
    for one in outlets:
        assert one.output.processes.done == ["stop_force", "rearm"]


def test_a_fault_of_one_is_its_own(outlets, reporter):
    lost = processes_of(outlets, OTHER)
    lost.health, lost.problem = Health.READY, "the network is down"
    outlets.poll(CLOCK, "realistic")
    lost.poll = lambda: setattr(lost, "health", Health.FAILED) or Health.FAILED
    outlets.poll(CLOCK, "realistic")
    states = {one.name: one for one in outlets.states("realistic")}
    assert states[OTHER].health is Health.FAILED
    assert states[OTHER].problem == "the network is down"
    assert {states[RIG].health, states["rumble"].health} == {Health.READY}
    assert reporter.notices == [f"{OTHER}: the network is down"]
    assert processes_of(outlets, RIG).published[-1] == (
        CLOCK.ahead(0.040),
        "realistic",
    )


def test_the_state_tells_mode_gain_and_that_nobody_listens(outlets):
    tick = np.zeros(1, TICK)
    tick["mode"], tick["buttons"] = Mode.FOLLOWING, REFUSED
    processes_of(outlets, RIG).ticks = tick
    outlets.poll(CLOCK, "realistic")
    state = outlets.states("realistic")[0]
    assert (state.name, state.gain, state.mode) == (RIG, 0.5, Mode.FOLLOWING)
    assert "nobody listens at 127.0.0.1:4123" in state.note
    assert state.loop_pid == 7


def test_an_output_that_is_dropped_is_released(outlets):
    kept, gone = processes_of(outlets, RIG), outlets[OTHER].output
    outlets.use([RIG, "simulated"])
    assert processes_of(outlets, RIG) is kept
    gone.wait_released()
    assert "close" in gone.processes.done
    assert list(processes_of(outlets, "simulated").tracks) == ["realistic", "random"]
    with pytest.raises(UsageError, match="no outlet"):
        outlets[OTHER]


def test_a_new_outlet_waits_for_those_that_come_to_rest(outlets):
    at_rest = threading.Event()
    processes_of(outlets, RIG).close = at_rest.wait
    louder = "rig:outsim,gain=0.6"
    outlets.use([louder, OTHER])
    outlets.poll(CLOCK, "realistic")
    assert processes_of(outlets, louder).published[-1][1] == ""
    assert processes_of(outlets, OTHER).published[-1][1] == "realistic"
    released = outlets._released[0]
    at_rest.set()
    released.wait_released()
    outlets.poll(CLOCK, "realistic")
    assert processes_of(outlets, louder).published[-1][1] == "realistic"


def test_two_outlets_may_not_drive_one_rig(outlets):
    with pytest.raises(UsageError, match="two outlets send outsim to 127"):
        outlets.use([RIG, "rig:outsim,gain=0.6"])
    outlets.use([RIG, "rig:beamng,127.0.0.1:4123"])  # distinguished by their content


def test_shakers_play_beside_rigs_and_each_other(outlets):
    names = [RIG, "shaker:pulse", "shaker:pulse,channels=3+4"]
    outlets.use(names)
    assert [one.name for one in outlets] == names
    assert outlets["shaker:pulse"].latency_s == pytest.approx(0.080)


def test_modes_of_an_outlet_are_logged_with_its_name(outlets, reporter):
    lines = []
    reporter.line = lambda kind, **fields: lines.append({"kind": kind, **fields})
    ticks = np.zeros(2, TICK)
    ticks["mode"] = Mode.FOLLOWING, Mode.RAMPING
    processes_of(outlets, OTHER).ticks = ticks
    outlets.poll(CLOCK, "realistic")
    assert [(one["name"], one["outlet"]) for one in lines] == [
        ("force_following", OTHER),
        ("ramp", OTHER),
    ]


def test_settings_that_are_not_allowed_are_refused(outlets):
    with pytest.raises(DeviceError, match="rate must be between"):
        outlets.use(["rig:outsim,rate=5"])


def test_the_player_keeps_what_is_not_changed(manual_clock):
    player = Player(manual_clock, audio=None, haptics=Processes)
    player.set_outlets([RIG, "rumble"])
    player.set_outlet("rumble", feedback="random")
    player.set_outlet("rumble", is_muted=True)
    state = {one.name: one for one in player.snapshot().outlets}["rumble"]
    assert (state.feedback, state.is_muted) == ("random", True)
    player.set_outlet("rumble", is_muted=False)
    state = {one.name: one for one in player.snapshot().outlets}["rumble"]
    assert (state.feedback, state.is_muted) == ("random", False)
    player.close()


# --- lent to a test ------------------------------------------------------------


def test_an_outlet_is_lent_and_comes_back_with_its_tracks(outlets):
    before = processes_of(outlets, RIG)
    outlets.lend(RIG)
    outlets[RIG].output.wait_released()
    assert before.done[-1] == "close"
    assert processes_of(outlets, RIG).device == "none"
    assert outlets.is_free(RIG)
    (state, *_) = outlets.states("realistic")
    assert (state.name, state.note) == (RIG, LENT)
    outlets.take_back(RIG)
    again = processes_of(outlets, RIG)
    assert (again.device, set(again.tracks)) == (RIG, {"realistic"})
    assert "stop_force" not in again.done
    outlets.lend("rumble")
    outlets.take_back("rumble")
    assert set(processes_of(outlets, "rumble").tracks) == set(TRACKS)


def test_an_output_stopped_while_it_is_lent_stays_stopped(outlets):
    outlets.lend(RIG)
    outlets.stop()
    outlets.take_back(RIG)
    assert processes_of(outlets, RIG).done == ["stop_force"]
    outlets.lend(OTHER)
    outlets.rearm()
    outlets.take_back(OTHER)
    assert "stop_force" not in processes_of(outlets, OTHER).done


def test_one_that_is_lent_may_be_removed(outlets):
    outlets.lend(RIG)
    outlets.use([OTHER])
    assert [one.name for one in outlets] == [OTHER]
