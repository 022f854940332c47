"""Faults outside the table: the wall clock, and hands that let go of a real grip."""

import math
import time
from contextlib import closing

import pytest
from haptic_rig import Rig, swaying

from hapticplayer.clock import SystemClock
from hapticplayer.devices.dynamics import FIRM, Mechanism
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import ZERO
from hapticplayer.model import ForceTrack
from tests.doubles import SimulatedFalcon


def test_a_jump_of_the_wall_clock_changes_nothing(monkeypatch):
    first = Rig()
    expected = first.tick(400)
    first.close()

    def jumping():
        raise AssertionError("the wall clock was read")

    monkeypatch.setattr(time, "time", jumping)
    second = Rig()
    assert second.tick(400) == expected
    second.close()
    clock = SystemClock()
    before_s = clock.now_s()
    clock.sleep_until(before_s + 0.001)
    assert clock.now_s() >= before_s + 0.001


class Recorded(SimulatedFalcon):
    """The simulated Falcon, and what it was sent and where it was."""

    def __init__(self, *settings, **more):
        super().__init__(*settings, **more)
        self.sent, self.places, self.times_s = [], [], []

    def exchange(self, force_n, now_s):
        reading = super().exchange(force_n, now_s)
        self.sent.append(force_n)
        self.places.append(reading.position_m)
        self.times_s.append(now_s)
        return reading

    def speeds(self):
        pairs = zip(self.places[1:], self.places, strict=False)
        return [1000.0 * math.dist(a, b) for a, b in pairs]


@pytest.mark.parametrize("mass_kg", [0.05, 0.1, 0.15, 0.3])
@pytest.mark.parametrize("moment", range(5))
def test_a_grip_that_is_let_go_stays_below_1_5_metres_per_second(mass_kg, moment):
    device = Recorded(FIRM, mechanism=Mechanism().with_lateral_mass(mass_kg))
    strong = ForceTrack([0.0, 100.0], [[4.5, 0.0, 0.0], [0.0, 4.5, 0.0]])
    with closing(Rig(strong if moment % 2 else swaying(), device)) as rig:
        rig.tick(300 + 97 * moment)
        assert rig.mode is Mode.FOLLOWING
        device.let_go()
        rig.tick(400)
        mode, cause = rig.mode, rig.cause
    # a step of the encoder is 0.06 m/s at 1 kHz
    assert max(device.speeds()) <= 1.5
    if mode is Mode.TRIPPED:
        assert cause in (Cause.RUNAWAY, Cause.OUTSIDE)
        assert device.sent[-1] == ZERO
    else:  # caught by spring and fade before it was fast or far
        assert max(device.speeds()) <= 1.06
        assert max(math.hypot(*place) for place in device.places) <= 0.9 * 0.04
