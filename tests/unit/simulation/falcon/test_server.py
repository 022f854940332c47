"""Both ends of the device's socket in one thread, on a virtual clock."""

import os
import socket

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import DeviceError
from hapticplayer.simulation.falcon.packets import ForceCommand, command_bytes
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.process import RING_RECORDS, PlantRecorder
from hapticplayer.simulation.falcon.remote import Controls, RemoteFalcon, silence
from hapticplayer.simulation.falcon.server import COMMAND_AGE_S, Server
from hapticplayer.simulation.falcon.simulation import Simulation
from tests.material.plant_record import read_record

ZERO = (0.0, 0.0, 0.0)
PUSH = (2.0, 0.0, 0.0)
SOCKET_QUEUE = 1000  # more than fits


class Bench:
    """A server that gets its turn after every exchange."""

    def __init__(self, **electronics):
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.record = os.memfd_create("record")
        self.clock = ManualClock()
        self.simulation = Simulation(electronics=Electronics(**electronics))
        recorder = PlantRecorder(self.record)
        self.line = theirs
        self.server = Server(self.clock, theirs, self.simulation, recorder)
        self.raw = ours.dup()
        self.controls = Controls(ours.dup().detach())
        self.device = RemoteFalcon(ours.detach())
        self.device.open()

    def tick(self, force_n=PUSH, count=1):
        for _ in range(count):
            self.clock.advance(0.001)
            reading = self.device.exchange(force_n, self.clock.now_s())
            self.server.turn()
        return reading

    def hang_up(self):
        self.raw.close()
        self.controls.close()
        self.device.close()


@pytest.fixture
def bench():
    bench = Bench(hold_s=0.020)
    yield bench
    bench.hang_up()
    bench.server.turn()
    bench.line.close()
    os.close(bench.record)


def test_the_newest_answer_is_that_to_the_command_before(bench):
    bench.tick(count=100)
    reading = bench.tick()
    assert reading.replied_s == pytest.approx(bench.clock.now_s() - 0.001)
    twin = Simulation(electronics=Electronics(0.020))
    for tick in range(1, 101):
        twin.command(PUSH, 1000.0 + tick / 1000)
    np.testing.assert_allclose(reading.position_m, twin.reading(1e3 + 0.1).position_m)
    assert reading.is_homed


def test_a_slow_player_gets_the_newest_of_many_answers(bench):
    bench.tick()
    for _ in range(50):
        bench.clock.advance(0.001)
        bench.raw.send(command_bytes(*ForceCommand(0, bench.clock.now_s(), PUSH)))
        bench.server.turn()
    assert bench.tick().replied_s == pytest.approx(bench.clock.now_s() - 0.001)


def test_a_command_of_20_ms_ago_is_refused_and_counted(bench):
    bench.tick(ZERO)
    now_s = bench.clock.now_s()
    for age_s in (COMMAND_AGE_S + 1e-6, 1.0, -1.0):
        bench.raw.send(command_bytes(*ForceCommand(0, now_s - age_s, PUSH)))
    bench.server.turn()
    assert bench.simulation.refused == 3
    assert bench.simulation.commanded_n == ZERO
    bench.raw.send(command_bytes(*ForceCommand(0, now_s - COMMAND_AGE_S + 1e-6, PUSH)))
    bench.server.turn()
    assert bench.simulation.commanded_n == PUSH


def test_a_zero_is_never_too_old(bench):
    bench.tick(PUSH, 10)
    bench.raw.send(command_bytes(*ForceCommand(0, bench.clock.now_s() - 5.0, ZERO)))
    bench.server.turn()
    assert bench.simulation.applied_n == ZERO
    assert bench.simulation.refused == 0


def test_garbled_commands_are_refused_and_counted(bench):
    good = command_bytes(*ForceCommand(0, bench.clock.now_s(), PUSH))
    for data in (b"?", good[:-1], bytes(64), good[:-1] + bytes([good[-1] ^ 1])):
        bench.raw.send(data)
    bench.server.turn()
    assert bench.simulation.refused == 4
    assert bench.simulation.commanded_n == ZERO


def test_a_device_that_does_not_read_gets_no_old_command(bench):
    before = bench.tick(PUSH, 10)
    bench.controls.stall(1.5)
    bench.server.turn()
    for _ in range(SOCKET_QUEUE):
        reading = bench.tick((0.0, 3.0, 0.0))
    assert reading.replied_s <= before.replied_s + 0.002
    assert bench.simulation.applied_n == ZERO  # by the hold time
    bench.tick(ZERO, 600)
    assert not np.array_equal(bench.simulation.commanded_n, (0.0, 3.0, 0.0))
    assert bench.simulation.refused > 100
    assert bench.tick().replied_s == pytest.approx(bench.clock.now_s() - 0.001)


def test_falsified_replies_are_counted_by_the_player(bench):
    before = bench.tick(count=10)
    bench.controls.corrupt(3)
    found = [bench.tick().malformed for _ in range(6)]
    assert found == [0, 0, 1, 2, 3, 0] or found == [0, 1, 2, 3, 0, 0]
    assert bench.tick().replied_s > before.replied_s


def test_buttons_homing_and_hand_are_under_control(bench):
    bench.controls.press(0b1001)
    bench.tick()
    assert bench.tick().buttons == 0b1001
    bench.controls.lose_homing()
    bench.tick()
    assert not bench.tick().is_homed
    held_m = bench.tick(count=1000).position_m[0]
    bench.controls.let_go()
    assert bench.tick(count=300).position_m[0] > held_m + 0.02
    bench.controls.grasp()
    assert bench.tick(ZERO, 500).position_m[0] == pytest.approx(0.04, abs=2e-3)


def test_an_unplugged_device_ends_and_the_player_is_told(bench):
    bench.tick()
    bench.controls.unplug()
    bench.server.turn()
    assert bench.server.is_over
    with pytest.raises(DeviceError, match="unplugged"):
        bench.device.exchange(ZERO, bench.clock.now_s())
    with pytest.raises(DeviceError, match="unplugged"):
        bench.controls.let_go()
    with pytest.raises(DeviceError, match="unplugged"):
        bench.device.open()


def test_a_server_ends_when_the_last_holder_has_closed(bench):
    bench.tick(count=5)
    bench.device.close()
    bench.controls.close()
    bench.server.turn()
    assert not bench.server.is_over
    bench.raw.close()
    bench.server.turn()
    assert bench.server.is_over


def test_a_last_zero_counts_although_its_sender_has_left(bench):
    bench.tick(PUSH, 10)
    bench.raw.send(command_bytes(*ForceCommand(0, bench.clock.now_s(), ZERO)))
    bench.hang_up()  # with replies unread: the server's next recv reports a reset
    bench.server.turn()
    assert bench.simulation.applied_n == ZERO
    assert bench.server.is_over


def test_the_silencer_writes_a_zero_until_the_device_is_gone(bench):
    bench.tick(PUSH, 10)
    write_zero = silence(bench.raw.fileno())
    assert write_zero()
    bench.server.turn()
    assert bench.simulation.applied_n == ZERO
    for _ in range(SOCKET_QUEUE):  # never blocks, although nobody listens
        assert write_zero()
    bench.server.turn()
    bench.controls.unplug()
    bench.server.turn()
    assert not write_zero()


def test_the_record_tells_when_the_zero_came(bench):
    bench.tick(PUSH, 20)
    last_s = bench.clock.now_s()
    for _ in range(5):  # the player is silent; the server looks every 20 ms
        bench.clock.advance(0.020)
        bench.server.turn()
    found = read_record(bench.record)
    after = found[found["monotonic_s"] > last_s + 0.001]
    np.testing.assert_array_equal(after["commanded_n"][:, 0], 2.0)
    np.testing.assert_array_equal(after["applied_n"][:, 0], [2.0, 0.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(after["applied_since_s"][1:], last_s + 0.021, atol=1e-9)
    assert np.all(np.diff(found["monotonic_s"]) >= 0.0)


def test_every_tick_is_logged_once_with_its_refusals(bench):
    def records():
        bench.clock.advance(0.001)
        bench.server.turn()
        return len(read_record(bench.record))

    before = records()
    assert records() == before + 1  # nothing came
    command = command_bytes(*ForceCommand(0, bench.clock.now_s(), PUSH))
    bench.raw.send(command)
    assert records() == before + 2
    for data in (command, b"?"):
        bench.raw.send(data)
    assert records() == before + 4
    last = read_record(bench.record)[-1]
    assert last["refused"] == bench.simulation.refused == 1
    assert last["monotonic_s"] == bench.clock.now_s()


def test_the_record_is_a_ring_of_the_newest():
    descriptor = os.memfd_create("record")
    recorder, simulation = PlantRecorder(descriptor), Simulation()
    for count in range(RING_RECORDS + 10):
        recorder.write(float(count), simulation)
    found = read_record(descriptor)
    np.testing.assert_array_equal(
        found["monotonic_s"], np.arange(10, RING_RECORDS + 10)
    )
    os.ftruncate(descriptor, 0)
    with pytest.raises(ValueError, match="no record"):
        read_record(descriptor)
    os.close(descriptor)
