"""The guard's last word: zero, as soon as nobody holds the device any more."""

from hapticplayer.devices import find_device
from hapticplayer.devices.falcon.ftdi import RUN_BAUD
from hapticplayer.devices.falcon.silence import Silencer
from hapticplayer.extras.faults.usb.board import Stage, synthetic_image
from hapticplayer.extras.faults.usb.driver import make_set

PUSH = (3.0, 0.0, 0.0)


def run_and_die(running):
    """Leave a force on the motors, as a killed program does."""
    device = running.driver()
    device.open()
    for _ in range(5):
        device.exchange(PUSH, running.clock.now_s())
        running.clock.advance(0.001)
    assert running.mechanics.commands[-1][1] != (0, 0, 0)
    return device


def test_while_the_program_lives_it_is_left_alone(running):
    device = run_and_die(running)
    assert Silencer(running.bus)()
    assert running.mechanics.commands[-1][1] != (0, 0, 0)
    device.close()


def test_when_the_program_has_died_the_motors_get_zero(running):
    silencer = Silencer(running.bus)
    run_and_die(running)
    assert silencer()
    running.port.is_claimed = False  # as the system does
    assert silencer()
    assert running.mechanics.commands[-1][1] == (0, 0, 0)
    count = len(running.mechanics.commands)
    assert silencer()
    assert len(running.mechanics.commands) == count + 1
    silencer.close()
    assert not running.port.is_claimed


def test_without_a_falcon_there_is_nothing_left_to_do(running):
    silencer = Silencer(running.bus)
    assert silencer()
    running.chip.unplug()
    assert not silencer()
    assert not silencer()


def test_trouble_on_the_bus_is_met_by_beginning_again(running):
    silencer = Silencer(running.bus)
    running.chip.control(3, *RUN_BAUD)
    running.port.refuses_with = 32
    assert silencer()
    assert running.mechanics.commands == []
    running.port.refuses_with = 0
    assert silencer()
    assert running.mechanics.commands[-1][1] == (0, 0, 0)


def test_a_real_falcon_is_made_by_name_alone():
    assert find_device("falcon").make(-1).name == "falcon"


def test_a_whole_simulated_falcon_is_loaded_and_pushes_its_hand(manual_clock):
    whole = make_set(clock=manual_clock, stage=Stage.DARK)
    whole.driver.open()
    assert whole.board.image == synthetic_image().data
    assert 7000 < len(whole.board.image) < 9000
    whole.chip.unplug()
    whole.driver.close()
