"""An owner's measurements, on a Falcon whose truth is known, in virtual time."""

import math
from dataclasses import replace

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.devices.dynamics import RELAXED, Mechanism
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.firmware import open_running
from hapticplayer.devices.falcon.link import DirectLink
from hapticplayer.devices.falcon.transport import open_falcon
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.board import Stage, synthetic_image
from hapticplayer.extras.faults.usb.driver import make_set
from hapticplayer.extras.measuring import measuring
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.simulation import Simulation


class Lab:
    """A Falcon of known making."""

    def __init__(self, hand=RELAXED, **parts):
        self.clock = ManualClock()
        self.simulation = Simulation(hand, **parts)
        self.set = make_set(self.simulation, clock=self.clock, stage=Stage.RUNNING)
        self.driver = FalconDriver(
            self.open_transport, clock=self.clock, make_link=DirectLink
        )

    def open_transport(self):
        return open_falcon(backend=self.set.bus)

    def __enter__(self):
        self.driver.open()
        return self

    def __exit__(self, *_):
        self.driver.close()


def test_the_event_character_shortens_the_round_trip():
    lab = Lab()
    ftdi = open_running(lab.open_transport, synthetic_image, lab.clock)
    slow = measuring.round_trips(ftdi, lab.clock, 200, event_character=False)
    fast = measuring.round_trips(ftdi, lab.clock, 200, event_character=True)
    ftdi.close()
    # two frames of 107 us; the timer fires each millisecond, but an answer that just
    # misses it waits for the next one
    assert 0.21 < fast["p50_ms"] < 0.45
    assert 0.9 < slow["p50_ms"] <= 2.1
    assert fast["rate_hz"] > 2 * slow["rate_hz"]
    assert fast["lost"] == slow["lost"] == 0
    assert lab.set.chip.requests[-1][:2] == (6, 0)  # switched off again


@pytest.mark.parametrize(
    ("hold_s", "at_least_s", "within_s"),
    [(0.0, 0.0, 0.1), (0.25, 0.2, 0.5), (math.inf, 2.0, math.inf)],
)
def test_the_time_until_the_motors_let_go_is_bracketed(hold_s, at_least_s, within_s):
    with Lab(electronics=Electronics(hold_s=hold_s)) as lab:
        found = measuring.force_after_silence(lab.driver, lab.clock)
    assert found["pushes_at_least_s"] >= at_least_s
    assert found["lets_go_within_s"] <= within_s or math.isinf(within_s)
    assert (found["lets_go_within_s"] == math.inf) is math.isinf(hold_s)
    assert lab.simulation.commanded_n == (0.0, 0.0, 0.0)


def test_a_silence_broken_by_other_traffic_is_measured_again(monkeypatch):
    monkeypatch.setattr(measuring, "SILENCES_S", (0.01, 0.1))
    monkeypatch.setattr(measuring, "TRIES", 3)
    answers = iter([False, True] + [False] * 100)
    with Lab() as lab:
        began_s = lab.clock.now_s()
        measuring.force_after_silence(lab.driver, lab.clock, lambda: next(answers))
        once_more_s = lab.clock.now_s() - began_s
        measuring.force_after_silence(lab.driver, lab.clock)
        took_s = lab.clock.now_s() - began_s - once_more_s
        assert once_more_s - took_s == pytest.approx(2.0 + 0.01, abs=0.1)
        with pytest.raises(DeviceError, match="stalled repeatedly"):
            measuring.force_after_silence(lab.driver, lab.clock, lambda: True)
    assert lab.simulation.commanded_n == (0.0, 0.0, 0.0)


def test_only_what_happens_under_force_disturbs_a_silence(monkeypatch):
    """On a busy computer each second without a disturbance is dear."""
    monkeypatch.setattr(measuring, "SILENCES_S", (0.01, 0.1, 0.5))
    asked_s = []
    with Lab() as lab:
        measuring.force_after_silence(
            lab.driver, lab.clock, lambda: asked_s.append(lab.clock.now_s())
        )
    spans = [
        after - before
        for before, after in zip(asked_s[::2], asked_s[1::2], strict=True)
    ]
    expected = [1.0 + silence_s for silence_s in measuring.SILENCES_S]
    assert spans == pytest.approx(expected, abs=0.02)


def test_more_friction_is_found_in_every_direction():
    found = []
    for factor in (1.0, 2.0):
        mechanism = Mechanism()
        mechanism = replace(mechanism, coulomb_nm=factor * mechanism.coulomb_nm)
        with Lab(None, mechanism=mechanism) as lab:
            found.append(measuring.friction(lab.driver, lab.clock))
            assert lab.simulation.commanded_n == (0.0, 0.0, 0.0)
    assert set(found[0]) == {"right", "left", "up", "down", "towards", "away"}
    for name, little_n in found[0].items():
        assert 0.0 < little_n < measuring.MOST_N
        assert found[1][name] > 1.5 * little_n, name


def test_a_button_and_a_fast_grip_end_it_without_force():
    with Lab() as lab:
        lab.simulation.buttons = 1
        with pytest.raises(DeviceError, match="button"):
            measuring.friction(lab.driver, lab.clock)
        with pytest.raises(DeviceError, match="button"):  # no force, none follows
            measuring.stops(lab.driver, lab.clock, 4.0)
        lab.simulation.buttons = 0
        bench = measuring.Bench(lab.driver, lab.clock)
        lab.simulation.let_go()
        with pytest.raises(DeviceError, match=r"0\.5 m/s|30 mm"):
            for _ in bench.run(lambda _: (3.0, 0.0, 0.0), 1.0):
                pass
        assert lab.simulation.commanded_n == (0.0, 0.0, 0.0)
        assert math.hypot(*lab.simulation.velocity_mps) < 1.0


def test_the_ends_that_a_hand_reaches_are_noted():
    with Lab() as lab:
        lab.simulation.aim((0.0, 0.0, 0.02))
        found = measuring.stops(lab.driver, lab.clock, 4.0)
    assert found["position_max_m"][2] == pytest.approx(0.02, abs=2e-3)
    assert found["position_min_m"][2] == pytest.approx(0.0, abs=1e-3)
    low, high = found["counts_min"], found["counts_max"]
    assert all(b - a > 300 for a, b in zip(low, high, strict=True))
