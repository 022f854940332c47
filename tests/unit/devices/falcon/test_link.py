"""The two threads of a link: nothing waits, nothing old is sent, no error is lost."""

import queue
import threading

import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices.falcon.driver import DriverState, FalconDriver
from hapticplayer.devices.falcon.link import NO_ANSWER, OLD_S, ThreadedLink
from hapticplayer.devices.falcon.protocol import Reply, encode_reply
from hapticplayer.devices.falcon.transport import FalconGoneError
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.board import Stage
from tests.unit.devices.falcon.bench import Bench

LONG_S = 20.0  # for what happens at once unless it is broken
REPLY = Reply((1, -2, 3), 4, 7)
OLD = Reply((100, 100, 100), 0, 7)


class Gate:
    """A chip whose calls wait until the test lets them go on."""

    def __init__(self):
        self.to_read, self.written = queue.Queue(), queue.Queue()
        self.may_write = threading.Semaphore(0)
        self.is_writing = threading.Semaphore(0)
        self.has_taken = False

    def read(self, timeout_s):
        if self.has_taken:
            self.to_read.task_done()  # only now is the reader through with it
        item, self.has_taken = self.to_read.get(), True
        if isinstance(item, Exception):
            raise item
        return item

    def is_idle(self):
        return not self.to_read.unfinished_tasks

    def write(self, data, timeout_s):
        self.is_writing.release()
        assert self.may_write.acquire(timeout=LONG_S)
        self.written.put(data)
        return len(data)


@pytest.fixture
def gate():
    return Gate()


@pytest.fixture
def link(gate):
    gate.clock, before = ManualClock(50.0), set(threading.enumerate())
    link = ThreadedLink(gate, gate.clock)
    yield link
    gate.to_read.put(b"")
    gate.may_write.release(10)
    link.stop()
    gate.to_read.put(b"")
    for thread in set(threading.enumerate()) - before:
        thread.join(LONG_S)
        assert not thread.is_alive()


def wait_for(condition):
    """Return when the condition holds, at most after a long time."""
    waiting = threading.Event()
    for _ in range(int(LONG_S * 1000)):
        if condition():
            return
        waiting.wait(0.001)
    raise AssertionError("it never happened")


def raises(problem, call):
    try:
        call()
    except problem:
        return True
    return False


def test_after_a_stalled_write_only_the_last_frame_is_sent(link, gate):
    link.post(b"first")
    assert gate.is_writing.acquire(timeout=LONG_S)
    for number in range(20):
        link.post(b"%d" % number)
    gate.may_write.release(2)
    assert gate.written.get(timeout=LONG_S) == b"first"
    assert gate.written.get(timeout=LONG_S) == b"19"
    assert gate.written.empty()


def test_the_newest_answer_is_there_without_waiting(link, gate):
    assert link.newest() == NO_ANSWER
    gate.may_write.release(2)
    link.post(b"x")
    gate.to_read.put(encode_reply(OLD))
    gate.to_read.put(encode_reply(Reply((9, 9, 9), 0, 7)) + encode_reply(REPLY))
    wait_for(lambda: link.newest().reply == REPLY)
    assert link.newest().at_s == 50.0
    link.post(b"y")
    gate.to_read.put(b"<AAA!AAAAAAAAAAA")
    wait_for(lambda: link.newest().malformed == 1)
    assert link.newest().reply == REPLY


def test_bytes_held_in_the_chip_during_a_stall_are_no_answer(link, gate):
    """The bus goes on after a second: a place of the hand that is a second old."""
    gate.to_read.put(encode_reply(OLD))  # of what happened before the link
    gate.to_read.put(encode_reply(REPLY))
    wait_for(lambda: link.newest().reply == REPLY)
    wait_for(gate.is_idle)
    gate.clock.advance(1.0)
    gate.to_read.put(encode_reply(OLD))
    wait_for(gate.is_idle)
    gate.clock.advance(0.001)
    gate.to_read.put(encode_reply(REPLY))
    wait_for(lambda: link.newest().at_s == 51.001)
    assert link.newest().reply == REPLY
    # neither is anything lost where packets without an answer have come meanwhile
    for _ in range(30):
        wait_for(gate.is_idle)
        gate.clock.advance(0.9 * OLD_S)
        gate.to_read.put(b"")
    wait_for(gate.is_idle)
    gate.to_read.put(encode_reply(OLD))
    wait_for(lambda: link.newest().reply == OLD)


def test_the_chip_is_read_while_nobody_posts(link, gate):
    """Else the answer to the last frame before a silence is the first after it."""
    for _ in range(3):
        gate.to_read.put(b"")
    wait_for(gate.to_read.empty)
    assert gate.written.empty()


class PacketTimer:
    """A chip whose latency timer runs from packet to packet, in virtual time."""

    def __init__(self, clock, first_s):
        self.clock, self.ready_s = clock, first_s
        self.asked, self.may_answer = threading.Semaphore(0), threading.Semaphore(0)
        self.wrote = threading.Semaphore(0)

    def write(self, data, timeout_s):
        self.wrote.release()
        return len(data)

    def read(self, timeout_s):
        self.asked.release()
        assert self.may_answer.acquire(timeout=LONG_S)
        return encode_reply(REPLY)


def test_answers_are_read_early_whatever_the_latency_timer():
    """The phase in which a read returns; a tick is due at 0 and 1 ms."""
    clock = ManualClock(49.9999)
    chip = PacketTimer(clock, 50.00095)
    link = ThreadedLink(chip, clock, idle_s=LONG_S)
    link.post(b"x")
    chip.may_answer.release()
    assert chip.asked.acquire(timeout=LONG_S)  # the first packet is of no known age
    assert chip.wrote.acquire(timeout=LONG_S)
    phases_ms, is_reading = [], False
    for tick in range(200):
        tick_s = 50.0 + tick / 1000.0
        clock.advance(tick_s - clock.now_s())
        link.post(b"x")
        assert chip.wrote.acquire(timeout=LONG_S)
        is_reading = is_reading or chip.asked.acquire(timeout=0.05)
        if not is_reading:
            continue  # a tick without a read: the timer waits for it
        ends_s = max(chip.ready_s, tick_s + 0.0001)
        if ends_s >= tick_s + 0.001:
            continue
        clock.advance(ends_s - clock.now_s())
        reply_before = link.newest().at_s
        chip.may_answer.release()
        wait_for(lambda before=reply_before: link.newest().at_s > before)
        phases_ms.append(1e3 * (ends_s - tick_s))
        # the crystal of the chip and the bus: 3 % more than a period
        chip.ready_s, is_reading = ends_s + 0.00103, False
    chip.may_answer.release(10)
    link.stop()
    assert len(phases_ms) > 180
    assert phases_ms[0] == pytest.approx(0.95)
    assert max(phases_ms[1:]) < 0.75
    assert min(phases_ms) >= 0.099


@pytest.mark.parametrize("call", ["post", "newest"])
def test_an_error_of_the_reader_is_raised_by_the_next_call(link, gate, call):
    gate.to_read.put(FalconGoneError("unplugged"))
    gate.may_write.release()
    link.post(b"x")
    again = {"post": lambda: link.post(b"x"), "newest": link.newest}[call]
    wait_for(lambda: raises(FalconGoneError, again))


def test_an_error_of_the_writer_is_raised_by_the_next_call(gate):
    def write(data, timeout_s):
        raise FalconGoneError("unplugged")

    gate.write = write
    link = ThreadedLink(gate, ManualClock())
    link.post(b"x")
    wait_for(lambda: raises(FalconGoneError, link.newest))
    gate.to_read.put(FalconGoneError("unplugged"))
    link.stop()


@pytest.fixture
def running_now(image):
    """A Falcon whose firmware runs, on the machine's clock."""
    return Bench(image, Stage.RUNNING, SystemClock())


@pytest.mark.realtime
def test_the_whole_chain_runs_on_threads_and_the_machines_clock(running_now):
    """pyusb, chip, board: answers come, unplugging is reported, closing ends it all."""
    running, clock = running_now, running_now.clock
    device = FalconDriver(running.open, clock=clock, image=lambda: running.image)
    before = threading.active_count()
    device.open()
    for _ in range(10_000):
        now_s = clock.now_s()
        reading = device.exchange((1.0, 0.0, 0.0), now_s)
        clock.sleep_until(now_s + 0.001)
        if running.mechanics.commands[-1][1] != (0, 0, 0):
            break
    assert device.state is DriverState.READY
    assert reading.is_homed
    running.chip.unplug()

    push = lambda: device.exchange((1.0, 0.0, 0.0), clock.now_s())  # noqa: E731
    wait_for(lambda: raises(DeviceError, push))
    device.close()
    assert threading.active_count() == before
    assert running.board.stage is Stage.RUNNING


@pytest.mark.realtime
def test_closing_ends_both_threads_and_zero_has_the_last_word(running_now):
    running, clock = running_now, running_now.clock
    device = FalconDriver(running.open, clock=clock, image=lambda: running.image)
    before = threading.active_count()
    device.open()

    def pushes():
        device.exchange((1.0, 0.0, 0.0), clock.now_s())
        return running.mechanics.commands[-1][1] != (0, 0, 0)

    wait_for(pushes)
    for _ in range(50):
        device.exchange((1.0, 0.0, 0.0), clock.now_s())
    assert threading.active_count() == before + 2
    device.close()
    assert threading.active_count() == before
    assert running.mechanics.commands[-1][1] == (0, 0, 0)
