"""Several outputs: each gets its signal and its clock; what one does leaves the others."""

import threading

import numpy as np
import pytest

from hapticplayer.errors import DeviceError, UsageError
from hapticplayer.haptics.block import REFUSED
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.live import LiveForce, ScaledForce
from hapticplayer.haptics.processes import Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack, MotionTrack, PlaybackClock, RigTrack
from hapticplayer.model.device import ChannelLevel
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.output import LENT, LIVE, NO_MOTION, OutputContext
from hapticplayer.playback.outputs import Outputs
from hapticplayer.playback.player import Player
from hapticplayer.rendering.force import device_gain
from tests.needed_extras import needs

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

pytestmark = needs("rigs", "shakers", "toys")


class Processes:
    """Notes what an output would be given."""

    def __init__(self, _clock, device, **_options):
        self.device, self.health, self.problem = device, Health.READY, ""
        self.scheduling, self.pids = "normal", {"loop": 7}
        self.tracks, self.published, self.done = {}, [], []
        self.ticks, self.levels = np.empty(0, TICK), ()
        self.takes_faults, self.record_problem, self.notice = False, "", ""

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
def latch():
    return StopLatch()


@pytest.fixture
def outputs(manual_clock, reporter, latch):
    made = Outputs(OutputContext(manual_clock, reporter, latch, None, Processes))
    made.use([RIG, OTHER, "rumble"])
    made.load(TRACKS, MOTION)
    yield made
    made.close()


def poll(outputs, feedback):
    for one in outputs:
        one.poll()
    outputs.publish(CLOCK, feedback)


def processes_of(outputs, name):
    return outputs[name].processes


def test_each_output_gets_the_signal_that_it_takes(outputs):
    for name in (RIG, OTHER):
        given = processes_of(outputs, name).tracks
        assert list(given) == ["realistic"]
        assert isinstance(given["realistic"], RigTrack)
    assert list(processes_of(outputs, "rumble").tracks) == ["realistic", "random"]


def test_each_has_the_same_clock_ahead_by_its_own_latency(outputs):
    poll(outputs, "realistic")
    ahead, track = processes_of(outputs, RIG).published[-1]
    assert (ahead.media_s(1000.0), track) == (pytest.approx(0.040), "realistic")
    assert processes_of(outputs, OTHER).published[-1] == (CLOCK, "realistic")
    assert outputs.lead_s == pytest.approx(0.040)


def test_a_measured_latency_counts_where_none_was_entered(outputs):
    outputs.set_latencies(Latencies(device_s={RIG: 0.1, OTHER: 0.02}))
    assert outputs[RIG].latency_s == pytest.approx(0.040)
    assert outputs[OTHER].latency_s == pytest.approx(0.020)


def test_a_condition_without_motion_leaves_a_rig_in_neutral(outputs):
    poll(outputs, "random")
    assert processes_of(outputs, RIG).published[-1][1] == ""
    assert processes_of(outputs, "rumble").published[-1][1] == "random"
    states = {one.name: one for one in outputs.states("random")}
    assert states[RIG].note == NO_MOTION
    assert states["rumble"].note == ""


def test_without_motion_a_rig_gets_nothing(outputs):
    outputs.load(TRACKS, None)
    assert processes_of(outputs, RIG).tracks == {}
    poll(outputs, "realistic")
    assert processes_of(outputs, RIG).published[-1][1] == ""


def test_an_edited_force_reaches_outputs_and_those_that_come(outputs):
    edited = ForceTrack([0.0, 3.0], [[0, 2.0, 0]] * 2)
    outputs.replace("realistic", edited)
    assert processes_of(outputs, "rumble").tracks["realistic"] is edited
    assert isinstance(processes_of(outputs, RIG).tracks["realistic"], RigTrack)
    outputs.use(["rumble"])
    assert processes_of(outputs, "rumble").tracks["realistic"] is edited


def test_an_output_has_its_own_condition_or_is_mute(outputs):
    outputs["rumble"].feedback = "random"
    outputs[OTHER].is_muted = True
    poll(outputs, "realistic")
    played = {one.name: one.processes.published[-1][1] for one in outputs}
    assert played == {RIG: "realistic", OTHER: "", "rumble": "random"}
    poll(outputs, "")  # withheld: also from those with their own condition
    assert {one.processes.published[-1][1] for one in outputs} == {""}


def test_a_gain_multiplies_what_each_plays_from_then_on(outputs):
    def largest():
        rig, rumble = (processes_of(outputs, one).tracks for one in (RIG, "rumble"))
        force = {name: float(track.force_n.max()) for name, track in rumble.items()}
        return float(np.abs(rig["realistic"].motion).max()), force

    full, _ = largest()  # with the gain of 0.5 that its settings say
    for name in (RIG, "rumble"):
        outputs[name].set_gain(0.25)
    assert largest() == (pytest.approx(full / 2), {"realistic": 0.25, "random": 0.25})
    outputs.replace("realistic", ForceTrack([0.0, 3.0], [[0, 2.0, 0]] * 2))
    assert largest()[1]["realistic"] == 0.5
    outputs.load({"realistic": TRACKS["realistic"]}, MOTION)
    assert largest() == (pytest.approx(full / 2), {"realistic": 0.25})
    for wrong in (-0.1, 4.1, float("nan")):
        with pytest.raises(UsageError, match="between 0 and 4"):
            outputs[RIG].set_gain(wrong)
    assert outputs.states("")[0].device == "rig:outsim,latency_ms=40,gain=0.25"


def test_a_device_that_is_opened_again_keeps_its_choices(outputs):
    chosen = outputs["rumble"]
    chosen.feedback, chosen.is_muted = "random", True
    chosen.set_gain(0.5)
    lost = chosen.processes
    lost.health = Health.FAILED
    outputs.use([RIG, "rumble"])
    again = outputs["rumble"]
    assert again.processes is not lost
    assert (again.feedback, again.is_muted, again.gain) == ("random", True, 0.5)
    assert again.processes.tracks["realistic"].force_n.max() == 0.5


def test_levels_are_shown_and_the_loudest_reported(outputs, manual_clock):
    processes, quiet = processes_of(outputs, "rumble"), ChannelLevel(3, 0.1, False)
    for now in (quiet, ChannelLevel(3, 0.5, True), quiet):
        processes.levels = (now,)
        poll(outputs, "realistic")
        manual_clock.advance(0.05)
    states = {one.name: one for one in outputs.states("realistic")}
    assert states["rumble"].levels == (quiet,)
    assert states[RIG].levels == ()
    (channel,) = outputs.summary()["rumble"]["channels"]
    assert channel == {"channel": 3, "peak_db": -6.0, "is_limited": True}
    for one in outputs:
        one.restart_meters()
    assert outputs.summary()["rumble"]["channels"] == []


def test_a_report_counts_once_and_only_in_its_own_trial(outputs, reporter):
    def fault():
        poll(outputs, "realistic")
        return {one.name: one for one in outputs.states("realistic")}["rumble"].fault

    processes_of(outputs, "rumble").notice = "low battery; charge it"
    assert [fault(), fault()] == 2 * ["low battery; charge it"]
    assert reporter.notices == ["rumble: low battery; charge it"]
    outputs["rumble"].restart_meters()
    assert fault() == ""
    processes_of(outputs, "rumble").notice = "low battery; charge it"
    assert fault() == "low battery; charge it"


def test_a_report_with_the_last_stop_is_heard(outputs):
    processes = processes_of(outputs, "rumble")

    def close():
        processes.notice, processes.health = "the toy goes on", Health.GONE

    processes.close = close
    outputs.close()
    assert outputs.summary()["rumble"]["fault"] == "the toy goes on"


def test_stop_and_re_arm_reach_all(outputs):
    outputs.stop()
    outputs.rearm()
    for one in outputs:
        assert one.processes.done == ["stop_force", "rearm"]


def test_a_fault_of_one_is_its_own(outputs, reporter):
    lost = processes_of(outputs, OTHER)
    lost.health, lost.problem = Health.READY, "the network is down"
    poll(outputs, "realistic")
    lost.poll = lambda: setattr(lost, "health", Health.FAILED) or Health.FAILED
    poll(outputs, "realistic")
    states = {one.name: one for one in outputs.states("realistic")}
    assert states[OTHER].health is Health.FAILED
    assert states[OTHER].problem == "the network is down"
    assert {states[RIG].health, states["rumble"].health} == {Health.READY}
    assert reporter.notices == [f"{OTHER}: the network is down"]
    assert processes_of(outputs, RIG).published[-1] == (
        CLOCK.ahead(0.040),
        "realistic",
    )


def test_the_state_tells_mode_gain_and_that_nobody_listens(outputs):
    tick = np.zeros(1, TICK)
    tick["mode"], tick["buttons"] = Mode.FOLLOWING, REFUSED
    processes_of(outputs, RIG).ticks = tick
    poll(outputs, "realistic")
    state = outputs.states("realistic")[0]
    assert (state.name, state.gain, state.mode) == (RIG, 0.5, Mode.FOLLOWING)
    assert "nobody listens at 127.0.0.1:4123" in state.note
    assert state.loop_pid == 7


def test_an_output_that_is_dropped_is_released(outputs):
    kept, gone = processes_of(outputs, RIG), outputs[OTHER]
    outputs.use([RIG, "simulated"])
    assert processes_of(outputs, RIG) is kept
    gone.wait_released()
    assert "close" in gone.processes.done
    assert list(processes_of(outputs, "simulated").tracks) == ["realistic", "random"]
    with pytest.raises(UsageError, match="no output"):
        outputs[OTHER]


def test_a_new_output_waits_for_those_that_come_to_rest(outputs):
    at_rest = threading.Event()
    processes_of(outputs, RIG).close = at_rest.wait
    louder = "rig:outsim,gain=0.6"
    outputs.use([louder, OTHER])
    poll(outputs, "realistic")
    assert processes_of(outputs, louder).published[-1][1] == ""
    assert processes_of(outputs, OTHER).published[-1][1] == "realistic"
    released = outputs._released[0]
    at_rest.set()
    released.wait_released()
    poll(outputs, "realistic")
    assert processes_of(outputs, louder).published[-1][1] == "realistic"


def test_two_outputs_may_not_drive_one_rig(outputs):
    with pytest.raises(UsageError, match="two outputs send outsim to 127"):
        outputs.use([RIG, "rig:outsim,gain=0.6"])
    outputs.use([RIG, "rig:beamng,127.0.0.1:4123"])  # distinguished by their content


def test_shakers_play_beside_rigs_and_each_other(outputs):
    names = [RIG, "shaker:pulse", "shaker:pulse,channels=3+4"]
    outputs.use(names)
    assert [one.name for one in outputs] == names
    assert outputs["shaker:pulse"].latency_s == pytest.approx(0.080)


def test_modes_of_an_output_are_logged_with_its_name(outputs, reporter):
    lines = []
    reporter.line = lambda kind, **fields: lines.append({"kind": kind, **fields})
    ticks = np.zeros(2, TICK)
    ticks["mode"] = Mode.FOLLOWING, Mode.RAMPING
    processes_of(outputs, OTHER).ticks = ticks
    poll(outputs, "realistic")
    assert [(one["name"], one["output"]) for one in lines] == [
        ("force_following", OTHER),
        ("ramp", OTHER),
    ]


def test_settings_that_are_not_allowed_are_refused(outputs):
    with pytest.raises(DeviceError, match="rate must be between"):
        outputs.use(["rig:outsim,rate=5"])


def test_the_player_keeps_what_is_not_changed(manual_clock):
    player = Player(manual_clock, audio=None, haptics=Processes)
    player.set_outputs([RIG, "rumble"])
    player.set_output("rumble", feedback="random")
    player.set_output("rumble", is_muted=True)
    state = {one.name: one for one in player.snapshot().outputs}["rumble"]
    assert (state.feedback, state.is_muted) == ("random", True)
    player.set_output("rumble", is_muted=False)
    state = {one.name: one for one in player.snapshot().outputs}["rumble"]
    assert (state.feedback, state.is_muted) == ("random", False)
    player.close()


# --- lent to a test ------------------------------------------------------------


def test_an_output_is_lent_and_comes_back_with_its_tracks(outputs):
    before = processes_of(outputs, RIG)
    outputs.lend(RIG)
    outputs[RIG].wait_released()
    assert before.done[-1] == "close"
    assert processes_of(outputs, RIG).device == "none"
    assert outputs.are_free
    (state, *_) = outputs.states("realistic")
    assert (state.name, state.note) == (RIG, LENT)
    outputs.take_back(RIG)
    again = processes_of(outputs, RIG)
    assert (again.device, set(again.tracks)) == (RIG, {"realistic"})
    assert "stop_force" not in again.done
    outputs.lend("rumble")
    outputs.take_back("rumble")
    assert set(processes_of(outputs, "rumble").tracks) == set(TRACKS)


def test_an_output_stopped_while_it_is_lent_stays_stopped(outputs, latch):
    outputs.lend(RIG)
    latch.stop()
    outputs.take_back(RIG)
    assert processes_of(outputs, RIG).done == ["stop_force"]
    outputs.lend(OTHER)
    latch.rearm(0.0)
    outputs.take_back(OTHER)
    assert "stop_force" not in processes_of(outputs, OTHER).done


def test_all_that_is_lent_comes_back_after_the_last_borrower(outputs):
    outputs.lend()
    outputs.lend()
    assert {processes_of(outputs, n).device for n in (RIG, OTHER)} == {"none"}
    outputs.use([OTHER, "simulated", RIG])
    assert processes_of(outputs, "simulated").device == "none"
    outputs.take_back()
    assert processes_of(outputs, OTHER).device == "none"
    outputs.take_back()
    names = [OTHER, "simulated", RIG]
    assert [processes_of(outputs, name).device for name in names] == names
    assert [one.name for one in outputs] == names


def test_the_first_output_leads_and_others_keep_running(outputs):
    before = [processes_of(outputs, name) for name in (RIG, OTHER, "rumble")]
    outputs.use(["rumble", RIG, OTHER])
    assert outputs.leading.name == "rumble"
    after = [processes_of(outputs, name) for name in (RIG, OTHER, "rumble")]
    assert after == before


def test_a_dead_output_is_opened_again_when_it_is_chosen(outputs):
    dead = processes_of(outputs, OTHER)
    dead.health = Health.FAILED
    outputs.use([RIG, OTHER])
    assert processes_of(outputs, OTHER) is not dead


def test_one_that_is_lent_may_be_removed(outputs):
    outputs.lend(RIG)
    outputs.use([OTHER])
    assert [one.name for one in outputs] == [OTHER]


def test_a_live_force_is_scaled_for_each_output(outputs):
    force, found = LiveForce(), outputs["rumble"].capabilities
    outputs["rumble"].feedback = "random"  # of clips
    outputs["rumble"].set_gain(0.5)
    outputs.load({LIVE: force}, None)
    poll(outputs, LIVE)
    assert processes_of(outputs, "rumble").published[-1][1] == LIVE
    given = processes_of(outputs, "rumble").tracks[LIVE]
    assert given == ScaledForce(force, "rumble", given.scale)
    assert given.scale == tuple(0.5 * device_gain(found))
    outputs["rumble"].set_gain(1.0)
    assert processes_of(outputs, "rumble").tracks[LIVE].scale[0] == 2 * given.scale[0]
    assert processes_of(outputs, RIG).tracks == {}
    assert outputs.states(LIVE)[0].note == NO_MOTION
