"""The simulated device in the caller's process: exchange, and its faults."""

from dataclasses import replace

import pytest

from hapticplayer.devices import DEVICES, NO_DEVICE, device_names, find_device
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.options import with_gain
from hapticplayer.errors import DeviceError
from hapticplayer.simulation.falcon.parameters import Electronics
from tests.doubles import SimulatedFalcon

ZERO = (0.0, 0.0, 0.0)
PUSH = (2.0, 0.0, 0.0)


class Bench:
    """A device that is exchanged with every millisecond."""

    def __init__(self, **electronics):
        self.device = SimulatedFalcon(electronics=Electronics(**electronics))
        self.device.open()
        self.now_s = 1000.0

    def tick(self, force_n=PUSH, count=1):
        for _ in range(count):
            self.now_s += 0.001
            reading = self.device.exchange(force_n, self.now_s)
        return reading


def test_a_simulated_device_is_a_falcon_by_name():
    assert find_device("simulated").capabilities == replace(FALCON, latency_s=0.0)
    assert DEVICES["simulated"].server == "hapticplayer.simulation.falcon"
    assert (FALCON.axes, FALCON.peak_force_n, FALCON.continuous_force_n) == (
        3,
        9.0,
        3.0,
    )
    with pytest.raises(DeviceError, match="no driver"):
        find_device("a Falcon of wood")


def test_one_of_several_falcons_is_found_by_its_number_only():
    entry = find_device("falcon:12PZ657E")
    assert entry.name == "falcon:12PZ657E"
    assert entry.capabilities is DEVICES["falcon"].capabilities
    with pytest.raises(DeviceError, match="Falcon"):
        entry.make(-1).open()  # none is plugged in, or another one
    with pytest.raises(DeviceError, match="letters and digits only"):
        find_device("falcon:12 PZ")
    with pytest.raises(
        DeviceError, match="nothing but gain= can follow; use simulated"
    ):
        find_device("simulated:12PZ657E")


@pytest.mark.parametrize("name", [one for one in device_names() if one != NO_DEVICE])
def test_every_device_takes_a_gain(name):
    entry = find_device(f"{name}:gain=0.25")
    assert entry.settings.gain == 0.25
    assert entry.settings.address == find_device(name).settings.address
    assert (entry.chosen, entry.capabilities) == ("", find_device(name).capabilities)
    for wrong in ("-1", "nan", "4.5", ""):
        with pytest.raises(DeviceError, match="gain must be between 0 and 4"):
            find_device(f"{name}:gain={wrong}")
    with pytest.raises(DeviceError, match="say it once"):
        find_device(f"{name}:gain=1,gain=2")


def test_another_gain_leaves_the_other_settings():
    assert with_gain("simulated", 0.5) == "simulated:gain=0.5"
    assert with_gain("simulated:gain=0.5") == "simulated"
    assert with_gain("falcon:A1,gain=2", 0.25) == "falcon:A1,gain=0.25"
    assert with_gain("rig:outsim,gain=2,rate=90") == "rig:outsim,rate=90"


def test_a_force_acts_from_the_exchange_that_brought_it():
    bench = Bench()
    assert bench.tick(PUSH).position_m[0] == pytest.approx(0.0, abs=1e-12)
    bench.tick(ZERO)
    speed_mps = bench.device.simulation.velocity_mps[0]
    assert speed_mps == pytest.approx(2.0 * 0.001 / 0.49, rel=0.1)  # one millisecond
    bench.tick(ZERO, 1)
    assert bench.device.simulation.velocity_mps[0] < speed_mps


def test_an_answer_is_as_old_as_its_exchange():
    bench = Bench()
    reading = bench.tick(count=300)
    assert reading.replied_s == bench.now_s
    assert reading.is_homed
    assert reading.malformed == 0
    assert reading.position_m[0] > 0.01


def test_a_stalled_device_neither_answers_nor_obeys():
    bench = Bench(hold_s=0.020)
    before = bench.tick(count=50)
    bench.device.stall(0.0995)
    silent = bench.tick(count=100)
    assert silent == before
    assert bench.device.simulation.applied_n == ZERO  # the hold time is over
    after = bench.tick(count=1)
    assert after.replied_s == bench.now_s
    assert bench.device.simulation.applied_n == PUSH


def test_malformed_answers_are_counted_in_a_row():
    bench = Bench()
    before = bench.tick(count=50)
    bench.device.corrupt(3)
    broken = [bench.tick() for _ in range(3)]
    assert [reading.malformed for reading in broken] == [1, 2, 3]
    assert {reading.replied_s for reading in broken} == {before.replied_s}
    assert bench.tick().malformed == 0


def test_an_unplugged_device_says_so_at_every_exchange():
    bench = Bench()
    bench.tick()
    bench.device.unplug()
    for _ in range(2):
        with pytest.raises(DeviceError, match="unplugged"):
            bench.tick()


def test_buttons_homing_and_hand_are_under_control():
    bench = Bench()
    bench.device.press(0b0110)
    assert bench.tick().buttons == 0b0110
    bench.device.press(0)
    assert bench.tick().buttons == 0
    bench.device.lose_homing()
    assert not bench.tick().is_homed
    held_m = bench.tick(count=1000).position_m[0]
    bench.device.let_go()
    assert bench.tick(count=300).position_m[0] > held_m + 0.02
    bench.device.grasp()
    bench.device.press(0)
    resting_m = bench.tick(ZERO, 500).position_m[0]
    assert resting_m == pytest.approx(0.04, abs=2e-3)  # held where it was found
