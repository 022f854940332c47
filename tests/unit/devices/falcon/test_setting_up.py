"""Homing with a person who may be slow, timid or at the end already."""

import itertools
from dataclasses import dataclass

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.devices.falcon.homing import Advice, HomingGuide
from hapticplayer.devices.falcon.protocol import Reply
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.setting_up import Step, set_up
from hapticplayer.devices.falcon.transport import FalconGoneError, open_falcon
from hapticplayer.errors import Cancelled, DeviceError
from hapticplayer.extras.faults.usb.board import Stage
from hapticplayer.extras.faults.usb.driver import make_set
from hapticplayer.extras.faults.usb.mechanics import Homing
from hapticplayer.simulation.falcon.simulation import Simulation


def guidance(*ways, homed_at_end=False):
    """Return what is said along ways of the grip: (counts, looks) from 0 on."""
    guide, at, said = HomingGuide(), 0.0, []
    for to, looks in ways:
        for share in range(1, looks + 1):
            mean = round(at + (to - at) * share / looks)
            said.append(guide.look(Reply((mean, mean, mean), 0, 0)))
        at = to
    if homed_at_end:
        said.append(guide.look(Reply((0, 0, 0), 0, 7)))
    return said


def sayings(*ways, **more):
    """Return the same without repetitions."""
    return [
        advice
        for advice, _ in itertools.groupby(g.advice for g in guidance(*ways, **more))
    ]


PULL, PUSH, DONE = Advice.PULL, Advice.PUSH, Advice.DONE


def test_out_and_in_is_the_whole_of_it():
    ways = [(1200, 100), (-1200, 100)]
    assert sayings(*ways, homed_at_end=True) == [PULL, PUSH, DONE]


def test_who_rests_at_the_outer_end_is_told_to_push():
    assert sayings((1200, 100), (1200, 50)) == [PULL]
    assert sayings((1200, 100), (1200, 70)) == [PULL, PUSH]


def test_a_grip_that_begins_at_the_outer_end_needs_no_pulling():
    assert sayings((-1400, 100)) == [PULL]
    assert sayings((-1600, 100)) == [PULL, PUSH]


def test_a_little_way_in_and_out_is_not_enough():
    assert sayings((-800, 100), (0, 100), (200, 100), (-800, 50)) == [PULL]


def test_who_pushes_in_vain_is_asked_to_pull_once_more():
    ways = [(400, 50), (-900, 100), (-900, 310)]
    assert sayings(*ways) == [PULL, PUSH, PULL]
    assert sayings(*ways, (900, 100), (-1200, 100)) == [PULL, PUSH, PULL, PUSH]


def test_the_ways_of_the_legs_are_told_from_where_they_began():
    guide = HomingGuide()
    guide.look(Reply((100, -50, 7), 0, 0))
    found = guide.look(Reply((130, -50, 0), 0, 0b101))
    assert found.legs == (30, 0, -7)
    assert found.homed == (True, False, True)
    assert found.out == pytest.approx(23 / 3)


@dataclass
class World:
    """A Falcon just plugged in, its owner, and what a front end was shown."""

    def __post_init__(self):
        self.clock, self.shown = ManualClock(), []
        self.simulation = Simulation()
        self.set = make_set(
            self.simulation, clock=self.clock, stage=Stage.DARK, homing=Homing()
        )
        self.driver = self.set.driver

    def run(self, until):
        from hapticplayer.extras.faults.usb.board import synthetic_image

        def show(progress):
            self.shown.append(progress)
            if until(progress):
                raise Cancelled

        reach = Reach(lambda: open_falcon(backend=self.set.bus), synthetic_image)
        set_up(reach, self.clock, show)

    @property
    def steps(self):
        return [step for step, _ in itertools.groupby(p.step for p in self.shown)]


def test_a_falcon_is_set_up_from_power_up_to_a_shown_grip():
    world = World()
    with pytest.raises(Cancelled):
        world.run(lambda p: p.step is Step.READY and abs(p.position_m[2]) < 0.005)
    assert world.steps == [Step.CONNECTING, Step.LOADING, Step.HOMING, Step.READY]
    loaded = [p.loaded for p in world.shown if p.step is Step.LOADING]
    assert loaded == sorted(loaded)
    assert loaded[-1] == 1.0
    advice = [p.guidance.advice for p in world.shown if p.guidance]
    assert [a for a, _ in itertools.groupby(advice)] == [PULL, PUSH, DONE]
    assert world.simulation.commanded_n == (0.0, 0.0, 0.0)
    assert world.set.bus.ports[0].is_claimed is False


def test_lost_homing_begins_the_guidance_again():
    world = World()

    def lose(progress):
        if progress.step is Step.READY and Step.READY not in world.steps[:-1]:
            world.simulation.is_homed = False
        return world.steps[-2:] == [Step.READY, Step.HOMING]

    with pytest.raises(Cancelled):
        world.run(lose)


def test_unplugging_and_silence_end_it_with_what_to_do():
    world = World()

    def unplug(progress):
        if progress.step is Step.HOMING:
            world.set.chip.unplug()
        return False

    with pytest.raises(FalconGoneError, match="plug it in"):
        world.run(unplug)
    world = World()

    def stall(progress):
        if progress.step is Step.READY:
            world.set.chip.stalled_until_s = world.clock.now_s() + 60.0
        return False

    with pytest.raises(DeviceError, match="does not answer"):
        world.run(stall)
