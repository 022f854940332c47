"""A stop holds whatever is opened afterwards, until a person re-arms."""

import threading

import numpy as np
import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import UsageError
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack
from hapticplayer.playback.device_test import DeviceTest
from hapticplayer.playback.forces import ForcePlayer
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.player import Player
from tests.needed_extras import needs
from tests.unit.playback.conftest import source_of

RIG, SECOND = "rig:outsim", "falcon-simulated"


class Noted(HapticsProcesses):
    """Starts nothing; notes what its loop is told, and says that it ticks."""

    made: list["Noted"]

    def __init__(self, clock, device, **_options):
        super().__init__(clock, NO_DEVICE)
        self.device, self.said, self.tracks = device, [], set()
        self.health = Health.NONE if device == NO_DEVICE else Health.READY
        self.tick = np.zeros(1, TICK)
        self.made.append(self)

    def poll(self):
        return self.health

    def stop_force(self):
        self.said.append("stop")
        self.show(Mode.TRIPPED, Cause.STOPPED)

    def rearm(self):
        self.said.append("rearm")
        self.show(Mode.IDLE)

    def publish(self, clock, track):
        self.tracks.add(track)

    def show(self, mode, cause=Cause.NONE, position_m=(0.0, 0.0, 0.0)):
        self.tick["mode"], self.tick["cause"] = mode, cause
        self.tick["position_m"] = position_m

    def read_ticks(self):
        self.tick["monotonic_s"] = self._clock.now_s()
        has_ticks = self.health is Health.READY
        return self.tick[: int(has_ticks)].copy(), 0

    def close(self):
        self.health = Health.GONE


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def player(clock, silent_clip):
    Noted.made = []
    made = Player(clock, outputs=["simulated"], audio=None, haptics=Noted)
    made.open(source_of(silent_clip))
    yield made
    made.close()


def pass_time(player, clock, seconds=0.3):
    for _ in range(round(seconds / 0.02)):
        clock.advance(0.02)
        player.poll()


def made():
    return [one for one in Noted.made if one.device != NO_DEVICE]


def newest():
    return made()[-1]


def edit(player):
    player.replace_track("realistic", ForceTrack([0.0, 1.0], [[1.0, 0, 0]] * 2))


CHANGES = {
    "device": lambda player: player.set_outputs(["simulated"]),
    "faults": lambda player: player.set_outputs(["simulated"], takes_faults=True),
    "none-and-back": lambda player: (
        player.set_outputs([NO_DEVICE]),
        player.set_outputs(["simulated"]),
    ),
    "another-output": lambda player: player.set_outputs(["simulated", RIG]),
    "another-order": lambda player: player.set_outputs([RIG, "simulated"]),
    "lent-and-back": lambda player: (
        player.lend_outputs(),
        player.take_back_outputs(),
    ),
    "clip": lambda player: player.open(player.snapshot().source),
    "feedback": lambda player: player.set_feedback("other"),
    "edit": edit,
    "play": lambda player: player.play(),
    "seek": lambda player: (player.play(), player.seek(1.0)),
}


@pytest.mark.parametrize("change", CHANGES)
@needs("rigs")
def test_whatever_is_opened_during_a_stop_is_stopped(player, clock, change):
    player.stop_force()
    before = len(Noted.made)
    CHANGES[change](player)
    player.play()
    pass_time(player, clock)
    opened = [one for one in Noted.made[before:] if one.device != NO_DEVICE]
    assert all(one.said[0] == "stop" for one in opened)
    assert all(one.tracks <= {""} for one in opened)
    assert not any("rearm" in one.said for one in Noted.made)
    now = player.snapshot()
    assert now.is_stopped
    assert now.leading.mode is Mode.TRIPPED
    player.rearm()
    pass_time(player, clock)
    now = player.snapshot()
    assert not now.is_stopped
    assert now.leading.mode is Mode.IDLE
    assert now.leading.name == NO_DEVICE or newest().said[-1] == "rearm"
    for _ in range(1000):
        if newest().device == RIG or newest().tracks - {""}:
            return
        threading.Event().wait(0.01)  # frames are decoded in real time
        player.poll()
    raise AssertionError("no track is published after the re-arm")


def test_a_grip_button_holds_the_next_device_too(player, clock):
    newest().show(Mode.TRIPPED, Cause.GRIP_BUTTON)
    pass_time(player, clock)
    assert player.snapshot().is_stopped
    player.set_outputs(["simulated"])
    assert newest().said == ["stop"]


@needs("rigs")
def test_a_trip_of_one_output_stops_all_of_them(player, clock):
    player.set_outputs(["simulated", SECOND])
    leading, second = made()
    second.show(Mode.TRIPPED, Cause.RUNAWAY)
    pass_time(player, clock)
    assert leading.said == ["stop"]
    assert player.snapshot().is_stopped


@needs("rigs")
def test_an_output_that_is_lost_leaves_the_others_alone(player, clock):
    player.set_outputs(["simulated", RIG])
    leading, rig = made()
    pass_time(player, clock)
    rig.show(Mode.TRIPPED, Cause.UNPLUGGED)
    rig.health = Health.FAILED
    pass_time(player, clock)
    assert not player.snapshot().is_stopped
    assert not leading.said


def test_a_lost_device_with_a_grip_has_to_be_rearmed(player, clock):
    pass_time(player, clock)
    newest().health = Health.FAILED
    pass_time(player, clock)
    assert player.snapshot().is_stopped
    player.set_outputs(["simulated"])
    assert newest().said == ["stop"]


def test_a_grip_at_the_edge_is_not_rearmed(player, clock):
    player.stop_force()
    newest().show(Mode.TRIPPED, Cause.STOPPED, (0.039, 0.0, 0.0))
    pass_time(player, clock)
    with pytest.raises(UsageError, match="centre"):
        player.rearm()
    assert player.snapshot().is_stopped
    assert "rearm" not in newest().said


def test_a_loop_that_refuses_to_rearm_stops_the_player_again(player, clock):
    player.stop_force()
    pass_time(player, clock)
    player.rearm()
    newest().show(Mode.TRIPPED, Cause.STOPPED)
    pass_time(player, clock)
    assert player.snapshot().is_stopped


def test_two_players_with_one_latch_stop_together(clock, silent_clip):
    Noted.made, latch = [], StopLatch()
    first, second = (
        Player(clock, outputs=["simulated"], audio=None, haptics=Noted, latch=latch)
        for _ in range(2)
    )
    second.stop_force()
    pass_time(first, clock)
    assert [one.said[0] for one in made()] == ["stop", "stop"]
    second.rearm()
    pass_time(first, clock)
    assert [one.said[-1] for one in made()] == ["rearm", "rearm"]
    for player in (first, second):
        player.close()


def test_demonstrations_and_tests_are_refused_in_a_stop():
    latch, track = StopLatch(), ForceTrack([0.0, 1.0], [[1.0, 0, 0]] * 2)
    latch.stop()
    with pytest.raises(UsageError, match="re-arm"):
        ForcePlayer(SystemClock(), "simulated", track, latch)
    with pytest.raises(UsageError, match="re-arm"):
        DeviceTest(SystemClock(), "simulated", latch=latch)


@needs("faults")
def test_a_grip_button_just_before_a_change_of_outputs_counts(player, clock):
    pass_time(player, clock)
    newest().show(Mode.TRIPPED, Cause.GRIP_BUTTON)
    player.set_outputs([SECOND])
    assert newest().said == ["stop"]
    assert player.snapshot().is_stopped


def test_a_grip_button_just_before_a_device_is_lent_counts(player, clock):
    pass_time(player, clock)
    newest().show(Mode.TRIPPED, Cause.GRIP_BUTTON)
    player.lend_outputs()
    player.take_back_outputs()
    assert newest().said == ["stop"]


def test_no_dialog_rearms_while_a_grip_is_at_the_edge(player, clock):
    player.stop_force()
    newest().show(Mode.TRIPPED, Cause.STOPPED, (0.039, 0.0, 0.0))
    pass_time(player, clock)
    with pytest.raises(UsageError, match="centre"):
        player.latch.rearm(clock.now_s())
    assert player.latch.is_set
    player.close()
    player.latch.rearm(clock.now_s())
    assert not player.latch.is_set


def test_a_text_is_not_taken_for_a_list_of_outputs(player):
    with pytest.raises(TypeError, match="not 'none'"):
        player.set_outputs(NO_DEVICE)
    assert [one.name for one in player.snapshot().outputs] == ["simulated"]
