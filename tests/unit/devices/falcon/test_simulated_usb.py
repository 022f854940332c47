"""The simulated chip and board themselves, against the rules of their data sheets."""

import errno

import pytest
import usb.core

from hapticplayer.devices.falcon import kinematics
from hapticplayer.devices.falcon.ftdi import LOADER_BAUD, RUN_BAUD
from hapticplayer.devices.falcon.protocol import Lights, MotorCommand
from hapticplayer.extras.faults.usb.board import Stage
from hapticplayer.extras.faults.usb.mechanics import Homing, SimulatedMechanics
from hapticplayer.simulation.falcon.simulation import Simulation

ZERO_FRAME = b"<AAAAAAAAAAAAAA>"
BYTE_S = 10 / 1.5e6


def ready(bench, latency_ms=1, event=0):
    """Set the run-time line, and let the latency timer begin now."""
    chip = bench.chip
    chip.control(9, latency_ms, 0)
    chip.control(3, RUN_BAUD.request_value, 0)
    chip.control(6, event, 0)
    chip.read(1.0)
    return chip


def test_a_reply_waits_for_the_latency_timer(running):
    chip, clock = ready(running), running.clock
    began_s = clock.now_s()
    chip.write(ZERO_FRAME, 0.1)
    packet = chip.read(0.1)
    assert packet[:3] == b"\x01\x60<"
    assert len(packet) == 18
    assert clock.now_s() - began_s == pytest.approx(0.001, abs=1e-6)


def test_an_event_character_brings_the_reply_at_once(running):
    chip, clock = ready(running, event=0x100 | ord(">")), running.clock
    began_s = clock.now_s()
    chip.write(ZERO_FRAME, 0.1)
    assert len(chip.read(0.1)) == 18
    # 16 bytes there, 16 back, and the resolution of the wait
    assert clock.now_s() - began_s == pytest.approx(32 * BYTE_S, abs=1.1e-4)


def test_an_event_character_in_the_first_place_does_not_count(running):
    chip, clock = ready(running, latency_ms=16, event=0x100 | ord("<")), running.clock
    began_s = clock.now_s()
    chip.write(ZERO_FRAME, 0.1)
    assert len(chip.read(0.1)) == 18
    assert clock.now_s() - began_s == pytest.approx(0.016, abs=1e-4)


def test_62_bytes_are_sent_without_waiting_and_in_full_packets(running):
    chip, clock = ready(running, latency_ms=16), running.clock
    began_s = clock.now_s()
    for _ in range(5):
        chip.write(ZERO_FRAME, 0.1)
    packet = chip.read(0.1)
    assert len(packet) == 64
    assert clock.now_s() - began_s < 0.001
    assert len(chip.read(0.1)) == 2 + 5 * 16 - 62


def test_a_change_of_cts_is_sent_at_once(bench):
    chip, clock = bench.chip, bench.clock
    chip.control(9, 255, 0)
    chip.control(1, 0x0101, 0)
    bench.board.stage = Stage.GREETED
    chip.read(1.0)
    began_s = clock.now_s()
    chip.control(1, 0x0100, 0)
    assert chip.read(1.0) == b"\x11\x60"
    assert clock.now_s() - began_s == pytest.approx(0.005, abs=1e-6)


def test_a_purge_forgets_what_was_not_yet_read(running):
    chip = ready(running)
    chip.write(ZERO_FRAME, 0.1)
    chip.control(0, 1, 0)
    assert chip.read(0.1) == b"\x01\x60"


@pytest.mark.parametrize("baud", [LOADER_BAUD, (0x4138, 0), (0x0001, 0)])
def test_at_a_wrong_rate_nothing_is_understood(running, baud):
    chip = ready(running)
    chip.control(3, *baud)
    chip.write(ZERO_FRAME, 0.1)
    for _ in range(20):
        assert len(chip.read(0.1)) == 2
    assert running.mechanics.commands == []


def test_a_rise_of_dtr_resets_the_board(running):
    running.chip.control(1, 0x0101, 0)
    assert running.board.stage is Stage.BOOT


def test_a_stall_delays_what_was_on_its_way(running):
    chip, clock = ready(running), running.clock
    chip.write(ZERO_FRAME, 0.1)
    chip.stalled_until_s = clock.now_s() + 0.1
    assert chip.read(0.05) is None
    assert len(chip.read(0.2)) == 18


def test_pyusb_reads_the_descriptors(bench):
    device = usb.core.find(idVendor=0x0403, idProduct=0xCB48, backend=bench.bus)
    assert (device.product, device.serial_number) == ("FALCON HAPTIC", "SIM00001")
    interface = device[0][(0, 0)]
    endpoints = {e.bEndpointAddress: e.wMaxPacketSize for e in interface}
    assert endpoints == {0x81: 64, 0x02: 64}
    bench.chip.unplug()
    assert usb.core.find(idVendor=0x0403, backend=bench.bus) is None


def test_a_read_that_is_too_short_overflows_as_on_a_real_bus(running):
    device = usb.core.find(idVendor=0x0403, backend=running.bus)
    ready(running).write(ZERO_FRAME, 0.1)
    with pytest.raises(usb.core.USBError) as caught:
        device.read(0x81, 8, 100)
    assert caught.value.errno == errno.EOVERFLOW


def test_the_motors_of_the_simulated_hand_push_as_they_are_told(rng):
    """Words from J^T of one place are the same force there."""
    simulation = Simulation()
    mechanics = SimulatedMechanics(simulation)
    for _ in range(20):
        place = tuple((rng.uniform(-0.02, 0.02, 3)).tolist())
        simulation.place(place)
        x, y, z = place
        jacobian = kinematics.jacobian((x, y, z + 0.12))
        force = tuple(rng.uniform(-2.0, 2.0, 3).tolist())
        words = kinematics.motor_words(jacobian, force)
        mechanics.command(MotorCommand(tuple(round(w) for w in words), 0), 1.0)
        assert simulation.commanded_n == pytest.approx(force, abs=0.005)
        counts = mechanics.reply(1.0).counts
        seen = kinematics.forward(kinematics.angles(counts))
        assert (seen[0], seen[1], seen[2] - 0.12) == pytest.approx(place, abs=6e-5)


def test_a_simulated_hand_that_is_not_homed_says_so():
    simulation = Simulation()
    simulation.is_homed = False
    simulation.buttons = 9
    reply = SimulatedMechanics(simulation).reply(1.0)
    assert (reply.is_homed, reply.buttons) == (False, 9)


def test_an_owner_homes_the_grip_only_when_asked():
    simulation = Simulation()
    mechanics = SimulatedMechanics(simulation)
    mechanics.homing = Homing()
    places = []

    def run(lights, seconds):
        for _ in range(round(1000 * seconds)):
            run.now_s += 0.001
            mechanics.command(MotorCommand((0, 0, 0), lights), run.now_s)
            places.append(simulation.position_m[2])
        return mechanics.reply(run.now_s).is_homed

    run.now_s = 1.0
    assert not run(Lights.RED, 2.0)
    assert max(map(abs, places)) < 1e-3  # nobody moved it
    assert run(Lights.RED | Lights.HOMING, 8.0)
    assert max(places) > 0.03
    assert min(places) < -0.03
    assert places.index(max(places)) < places.index(min(places))
    assert abs(places[-1]) < 0.005
