"""The player's end of the line: which answers it takes, and when it stops asking."""

import socket
from types import SimpleNamespace

import pytest

from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceReading
from hapticplayer.simulation.falcon import remote
from hapticplayer.simulation.falcon.packets import (
    MAX_BYTES,
    pack_reply,
    unpack,
)
from hapticplayer.simulation.falcon.remote import RemoteFalcon

PUSH = (2.0, 0.0, 0.0)


class WatchedSocket(socket.socket):
    """Counts how often it is asked for something."""

    asked, after_sending = 0, None

    def recv(self, *arguments):
        self.asked += 1
        return super().recv(*arguments)

    def send(self, *arguments):
        sent = super().send(*arguments)
        if self.after_sending is not None:
            self.after_sending()
        return sent


class Bench:
    """A device that answers what and when the test says."""

    def __init__(self):
        ours, self.end = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.now_s = 1000.0
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(remote, "socket", SimpleNamespace(socket=self.watched))
            self.device = RemoteFalcon(ours.detach())
        self.answer(0)
        self.device.open()

    def watched(self, **given):
        self.ours = WatchedSocket(**given)
        return self.ours

    def answer(self, serial, age_s=0.0, x_m=0.0, spoil=False):
        data = pack_reply(
            serial, DeviceReading((x_m, 0.0, 0.0), 0, True, self.now_s - age_s)
        )
        self.end.send(data[:-1] + bytes([data[-1] ^ spoil]))

    def tick(self, period_s=0.001):
        """Return the reading and the serial number of the command."""
        self.now_s += period_s
        self.ours.asked = 0
        reading = self.device.exchange(PUSH, self.now_s)
        found = None
        while found is None:  # there is a HELLO before the first command
            found = getattr(unpack(self.end.recv(MAX_BYTES)), "serial", None)
        return reading, found

    def close(self):
        self.device.close()
        self.end.close()


@pytest.fixture
def bench():
    made = Bench()
    yield made
    made.close()


def test_after_a_fresh_answer_nothing_more_is_requested(bench):
    _, serial = bench.tick()
    for tick in range(10):
        bench.answer(serial, x_m=0.001 * tick)
        reading, serial = bench.tick()
        assert reading.position_m[0] == 0.001 * tick
        assert bench.ours.asked == 1


def test_of_many_waiting_answers_the_newest_counts(bench):
    serials = [bench.tick()[1] for _ in range(5)]
    for number, serial in enumerate(serials):
        bench.answer(serial, age_s=0.0001 * (5 - number), x_m=0.001 * number)
    reading, _ = bench.tick()
    assert reading.position_m[0] == 0.004
    assert bench.ours.asked == 5


@pytest.mark.parametrize("others", [0, 1, 7])
def test_other_answers_do_not_hide_that_to_the_last_command(bench, others):
    _, serial = bench.tick()
    bench.answer(others, x_m=0.01)
    bench.answer(serial, x_m=0.02)
    assert bench.tick()[0].position_m[0] == 0.02


def test_after_a_standstill_the_answers_to_the_guard_are_newer(bench):
    _, serial = bench.tick()
    bench.answer(serial, x_m=0.01)
    bench.now_s += 0.030
    bench.answer(0, x_m=0.02)
    assert bench.tick()[0].position_m[0] == 0.02


def test_no_greeting_passes_for_the_answer_to_a_first_command(bench):
    bench.answer(0, x_m=0.01)
    bench.answer(0, x_m=0.02)
    assert bench.tick()[0].position_m[0] == 0.02


def test_a_falsified_answer_is_counted_and_the_next_one_taken(bench):
    _, serial = bench.tick()
    bench.answer(serial, x_m=0.01, spoil=True)
    reading, serial = bench.tick()
    assert (reading.malformed, reading.position_m[0]) == (1, 0.0)
    bench.answer(serial, x_m=0.01, spoil=True)
    bench.answer(serial, x_m=0.02)
    reading, _ = bench.tick()
    assert (reading.malformed, reading.position_m[0]) == (0, 0.02)


def test_serial_numbers_restart_and_leave_out_zero(bench, monkeypatch):
    monkeypatch.setattr(remote, "SERIAL_MASK", 5)
    assert [bench.tick()[1] for _ in range(3)] == [2, 3, 4]
    serials = []
    for tick in range(4):
        reading, serial = bench.tick()
        serials.append(serial)
        bench.answer(serial, x_m=0.001 * tick)
        bench.answer(0, x_m=0.01)
    assert serials == [5, 1, 2, 3]
    assert bench.ours.asked <= 2  # the zero of the tick before, then what was awaited
    assert reading.position_m[0] == 0.002


def test_a_hang_up_is_noticed_although_an_answer_is_left(bench):
    _, serial = bench.tick()
    bench.answer(serial)
    bench.end.close()
    with pytest.raises(DeviceError, match="unplugged"):
        bench.device.exchange(PUSH, bench.now_s)


def test_a_hang_up_after_an_answer_is_noticed_a_tick_later(bench):
    _, serial = bench.tick()
    bench.answer(serial)

    def hang_up():
        bench.end.recv(
            MAX_BYTES
        )  # closed with this unread, it would be reported at once
        bench.end.close()
        bench.ours.after_sending = None

    bench.ours.after_sending = hang_up
    bench.device.exchange(PUSH, bench.now_s)
    with pytest.raises(DeviceError, match="unplugged"):
        bench.device.exchange(PUSH, bench.now_s)
