"""Intiface and TCode: the newest strength counts, and everything ends in a stop."""

import math
import os
import pty
import re
import socket
import threading
import tty

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.devices.paced import PacedDriver
from hapticplayer.errors import DeviceError, HapticPlayerError
from hapticplayer.extras.toys import buttplug, messages, tcode
from hapticplayer.extras.toys.extension import TCODE
from tests.doubles import DirectWriter
from tests.unit.extras.toys.fake_intiface import FakeIntiface

ZERO = (0.0, 0.0, 0.0)
HALF = (0.0, 2.25, 0.0)


def wait_until(condition, device=None, force_n=ZERO):
    clock = SystemClock()
    until_s = clock.now_s() + 60.0
    while not condition():
        assert clock.now_s() < until_s, "never"
        if device is not None:
            device.exchange(force_n, clock.now_s())
        clock.sleep_until(clock.now_s() + 0.001)


@pytest.fixture
def intiface(request):
    made = FakeIntiface(**getattr(request, "param", {}))
    yield made
    made.close()


@pytest.fixture
def toy(intiface):
    made = buttplug.make(-1, buttplug.buttplug_options(intiface.where))
    made.open()
    yield made
    made.close()


@pytest.mark.parametrize(
    "intiface", [{"version": 4}, {"version": 3}], ids=["v4", "v3"], indirect=True
)
def test_both_versions_shake_all_motors_and_nothing_else(intiface, toy):
    wait_until(lambda: len(intiface.strength) == 2, toy, HALF)
    wait_until(lambda: intiface.strength[2] == pytest.approx(0.5, abs=0.01), toy, HALF)
    assert intiface.strength[0] == pytest.approx(0.5, abs=0.03)
    assert 1 not in intiface.strength  # a motor that turns
    wait_until(lambda: not intiface.strength, toy)
    stops = {"StopCmd", "StopAllDevices"}
    assert {name for name, _ in intiface.heard} & stops


@pytest.mark.realtime
@pytest.mark.parametrize(
    "intiface",
    [{"gap_ms": 100}, {"gap_ms": 100, "version": 3}, {"gap_ms": 40}],
    ids=["100", "100-v3", "40"],
    indirect=True,
)
def test_a_toy_plays_at_its_own_rate_and_is_not_silent(intiface, toy):
    """Waiting for its turn is no silence; each answer is as fresh as without a gap."""
    clock, oldest_s = SystemClock(), 0.0
    wait_until(lambda: intiface.strength, toy, HALF)
    begun_s, count = clock.now_s(), len(intiface.arrived_s)
    while (now_s := clock.now_s()) < begun_s + 1.5:
        reading = toy.exchange((2.0 + math.sin(50.0 * now_s), 0.0, 0.0), now_s)
        oldest_s = max(oldest_s, now_s - reading.replied_s)
        clock.sleep_until(now_s + 0.001)
    firsts = intiface.arrived_s[count::2]  # two motors
    gap_s = 1e-3 * intiface.gap_ms
    assert oldest_s < 0.02
    assert len(firsts) <= 1.5 / gap_s + 2
    assert len(firsts) > 0.5 * 1.5 / gap_s
    assert not reading.notice


@pytest.mark.parametrize("intiface", [{"gap_ms": 60_000}], indirect=True)
def test_a_stop_does_not_wait_for_its_turn(intiface, toy):
    wait_until(lambda: intiface.strength, toy, HALF)
    wait_until(lambda: not intiface.strength, toy)


@pytest.mark.parametrize(
    "intiface", [{"version": 4}, {"version": 3}], ids=["v4", "v3"], indirect=True
)
def test_a_toy_that_leaves_is_named(intiface, toy):
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.leave()
    with pytest.raises(DeviceError, match=r"^Toy has left Intiface; connect it there"):
        wait_until(lambda: False, toy, HALF)


def test_errors_in_a_row_end_it_and_one_is_only_said(intiface, toy):
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.errors = 10**6
    said = r"Intiface at .* reports an error \(Device 3 not available\); see whether"
    with pytest.raises(DeviceError, match=said):
        wait_until(lambda: False, toy, HALF)


def test_one_error_among_answers_is_a_notice(intiface, toy):
    intiface.errors, said = 1, []
    wait_until(lambda: intiface.strength, toy, HALF)

    def is_said():
        said.append(toy.exchange(HALF, SystemClock().now_s()).notice)
        return said[-1]

    wait_until(is_said)
    assert "Device 3 not available" in said[-1]


def test_nonsense_among_answers_is_said(intiface, toy):
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.say("no list of messages", 30)
    said = []

    def is_said():
        said.append(str(toy.exchange(HALF, SystemClock().now_s()).notice))
        return "make no sense" in said[-1]

    wait_until(is_said)


def test_an_answer_to_a_stop_is_none_to_the_strength(intiface, toy):
    """A server that never answers a strength is silent, whatever else it answers."""
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.unanswered, oldest_s, said = ("OutputCmd",), 0.0, ""
    clock = SystemClock()
    until_s = clock.now_s() + 60.0
    while oldest_s < 0.3 and clock.now_s() < until_s:
        now_s = clock.now_s()
        is_on = int(now_s * 10) % 2  # stopped every 0.1 s
        reading = toy.exchange((1.0 + now_s % 1, 0.0, 0.0) if is_on else ZERO, now_s)
        oldest_s, said = now_s - reading.replied_s, reading.notice
        clock.sleep_until(now_s + 0.001)
    assert oldest_s >= 0.3
    assert re.match(r"Intiface at .* does not answer; see whether the toy", said)


BAD = [7, None, {}, [], {"DeviceIndex": "x"}, {"DeviceIndex": 1}]
BAD += [{"DeviceIndex": 1, "DeviceFeatures": [], "DeviceMessages": []}]


@pytest.mark.parametrize("bad", BAD, ids=str)
@pytest.mark.parametrize(
    "intiface", [{"version": 4}, {"version": 3}], ids=["v4", "v3"], indirect=True
)
def test_a_device_that_makes_no_sense_is_left_out(intiface, bad):
    intiface.more = {"0": bad}
    made = buttplug.make(-1, buttplug.buttplug_options(intiface.where))
    made.open()
    wait_until(lambda: len(intiface.strength) == 2, made, HALF)
    said = made.exchange(HALF, SystemClock().now_s()).notice
    assert re.match(r"a device is left out: Intiface at .*, Devices\.0", said)
    assert said.endswith("; update it")
    made.close()


@pytest.mark.parametrize("code", [2, 4, 3, None, "4", 10**400, [4], True])
def test_an_error_names_the_remedy_of_its_kind(intiface, toy, code):
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.say([{"Error": {"Id": 0, "ErrorMessage": "hm", "ErrorCode": code}}], 1)
    said = []

    def is_said():
        said.append(toy.exchange(HALF, SystemClock().now_s()).notice)
        return "reports an error (hm); " in said[-1]

    wait_until(is_said)
    remedies = {2: "more time in Intiface", 4: "connected and charged"}
    remedy = remedies.get(code, "restart it") if type(code) is int else "restart it"
    assert remedy in said[-1]


@pytest.mark.parametrize("intiface", [{"max_ping_ms": 200}], indirect=True)
def test_a_server_that_misses_a_ping_says_why_it_goes(intiface, toy):
    wait_until(lambda: intiface.pings and intiface.strength, toy, HALF)
    error = {"Id": 0, "ErrorMessage": "Ping timed out", "ErrorCode": 2}
    intiface.say([{"Error": error}], 1)
    intiface.hang_up()
    said = r"reports an error \(Ping timed out\); close other programs, or give pings"
    with pytest.raises(DeviceError, match=said):
        wait_until(lambda: False, toy, HALF)


HOSTILE = ["4", None, [4], 10**400, math.inf, -1, 2.5, {}, "n" * 70_000]


@pytest.mark.parametrize("value", HOSTILE, ids=lambda value: str(value)[:9])
@pytest.mark.parametrize(
    "field", ["MaxPingTime", "ProtocolVersionMajor", "MessageVersion"]
)
def test_a_strange_greeting_is_one_sentence(field, value):
    server = FakeIntiface(
        version=3 if field == "MessageVersion" else 4, info={field: value}
    )
    try:
        made = buttplug.make(-1, buttplug.buttplug_options(server.where))
        with pytest.raises(DeviceError, match=r"^Intiface at .*; ") as raised:
            made.open()
        assert len(str(raised.value)) < 300
    finally:
        server.close()


@pytest.mark.parametrize(
    "value", [v for v in HOSTILE if v != {}], ids=lambda value: str(value)[:9]
)
@pytest.mark.parametrize("kind", ["DeviceRemoved", "DeviceList", "Error", "Ok"])
def test_strange_messages_while_it_plays_are_counted(intiface, toy, kind, value):
    """As nonsense, which trips the loop, or as an error; never as an answer."""
    wait_until(lambda: intiface.strength, toy, HALF)
    readings = []
    inner = {"DeviceRemoved": "DeviceIndex", "DeviceList": "Devices"}
    content = {inner[kind]: value} if kind in inner else value
    intiface.say([{kind: content}], 30)

    def is_counted():
        readings.append(toy.exchange(HALF, SystemClock().now_s()))
        return readings[-1].malformed > 0

    wait_until(is_counted)


@pytest.mark.parametrize("value", [*HOSTILE, True], ids=lambda value: str(value)[:9])
@pytest.mark.parametrize("field", ["steps", "index", "gap", "name", "features"])
def test_a_strange_toy_is_refused_in_a_sentence_or_read(field, value):
    steps = value if field == "steps" else 20
    device = {
        "DeviceName": value if field == "name" else "Toy",
        "DeviceIndex": value if field == "index" else 0,
        "DeviceMessageTimingGap": value if field == "gap" else 10,
        "DeviceFeatures": value
        if field == "features"
        else {"0": {"Output": {"Vibrate": {"Value": [0, steps]}}}},
    }
    listed = {"Devices": {"0": device}}
    found, said = {}, "Intiface"
    try:
        found = messages.toys_of(listed, 4, "Intiface").found
    except DeviceError as problem:
        said = str(problem)
    assert said.startswith("Intiface")
    assert len(said) < 300
    for toy in found.values():
        assert len(toy.name) <= 80
        buttplug.ButtplugTranslator(list(toy.motors), 4).command(HALF, 0.0)


@pytest.mark.parametrize("intiface", [{"max_ping_ms": 200}], indirect=True)
def test_pings_come_from_the_loop_and_end_with_it(intiface, toy):
    wait_until(lambda: intiface.pings >= 4 and intiface.strength, toy, HALF)
    wait_until(lambda: not intiface.strength)  # the loop stands still


def test_a_server_without_answers_grows_old(intiface, toy):
    wait_until(lambda: intiface.strength, toy, HALF)
    intiface.answers = False

    def is_old():
        now_s = SystemClock().now_s()
        reading = toy.exchange((1.0 + now_s % 1.0, 0.0, 0.0), now_s)
        return now_s - reading.replied_s > 0.2

    wait_until(is_old)


@pytest.mark.parametrize("intiface", [{"toys": 0}], indirect=True)
def test_without_a_toy_it_says_what_to_do(intiface):
    with pytest.raises(DeviceError, match="connect one in Intiface"):
        buttplug.make(-1, buttplug.buttplug_options(intiface.where)).open()


def test_without_a_server_it_says_what_to_do():
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))
        where = f"127.0.0.1:{unused.getsockname()[1]}"
    with pytest.raises(DeviceError, match=r"Intiface does not answer at .*; start it"):
        buttplug.make(-1, buttplug.buttplug_options(where)).open()


@pytest.mark.parametrize(
    "devices",
    [{"0": 5}, {"0": {"DeviceIndex": 0}}, {"0": {"DeviceIndex": "x"}}, 7, "ab"],
)
def test_a_device_that_is_described_wrongly_is_refused(devices):
    with pytest.raises(DeviceError):
        messages.toys_of({"Devices": devices}, 4, "Intiface")


@given(st.text() | st.binary())
def test_whatever_a_server_says_is_no_button(text):
    heard = buttplug.ButtplugTranslator([], 4).buttons(text)
    assert heard in (0, None)


@given(st.tuples(*3 * [st.floats(-9.0, 9.0)]))
def test_a_line_of_tcode_is_what_the_specification_says(force_n):
    line = tcode.TcodeTranslator("V0").command(force_n, 0.0).decode()
    size = math.hypot(*force_n)
    if match := re.fullmatch(r"V0(\d{4})I(\d+)\n", line):
        assert int(match[1]) / 1e4 == pytest.approx(min(1.0, size / 4.5), abs=0.003)
    else:
        assert line == "V00000\nDSTOP\n"
        assert size < 0.01


def board_of(port, channel=""):
    def open_port():
        return tcode.open_board(tcode.tcode_options(f"127.0.0.1:{port}{channel}"))

    return PacedDriver("tcode", TCODE, open_port, tcode.REFRESH_S, DirectWriter)


@pytest.fixture
def receiver():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        end.settimeout(30)
        yield end


def test_by_udp_every_datagram_is_whole_lines_and_the_last_stops(receiver):
    clock = ManualClock()
    board = board_of(receiver.getsockname()[1], ",channel=A1")
    board.open()
    for k in range(200):
        board.exchange((2.0 + math.sin(k), 0.0, 0.0), clock.now_s())
        clock.advance(0.001)
    board.close()
    receiver.setblocking(False)
    lines = []
    while not lines or not lines[-1].endswith(b"DSTOP\n"):
        lines.append(receiver.recv(200))
    assert 9 <= len(lines) <= 11  # fifty a second, and the stop
    assert all(line.startswith(b"A1") and line.endswith(b"\n") for line in lines)


class Line:
    """A serial board that says what a test wants, on a virtual clock."""

    def __init__(self):
        self.ours, theirs = pty.openpty()
        tty.setraw(self.ours)
        options = tcode.tcode_options(os.ttyname(theirs))
        self.clock = ManualClock()

        def open_port():
            return tcode.open_board(options, self.clock)

        self.board = PacedDriver("tcode", TCODE, open_port, 0.5, DirectWriter)
        self.board.open()
        os.close(theirs)

    def said(self, text, after_s=0.0):
        """What a person reads once the board has said that."""
        self.clock.advance(after_s)
        os.write(self.ours, text)
        for _ in range(100):
            self.clock.advance(0.001)
            notice = self.board.exchange(HALF, self.clock.now_s()).notice
        return notice


@pytest.fixture
def line():
    made = Line()
    yield made
    made.board.close()
    os.close(made.ours)


ERRORS = [b"ERROR\r\n", b"err: channel\n", b"E: Invalid axis V0\n", b"Brownout!\n"]
ERRORS += [b"Guru Meditation: panic'ed\n", b"motor failed\n", b"\xffError 3\n"]
ERRORS += [b"ERR_CHANNEL\n", b"err3\n"]


@pytest.mark.parametrize("text", ERRORS)
def test_errors_of_a_board_are_said_and_three_in_a_row_end_it(line, text):
    said = line.said(text)
    assert re.match(r"the board at /dev/.* reports an error \(.+\); check its", said)
    for _ in range(5):  # one now and then is no end
        assert "reports an error" in line.said(text, after_s=2.0)
    with pytest.raises(DeviceError, match="reports an error"):
        line.said(3 * text)


@pytest.mark.parametrize(
    "text", [b"OSR2 TCode v0.3\n", b"rst:0x1 (POWERON)\r\n", b"Hello, board 7\r\n"]
)
def test_a_board_that_greets_in_the_middle_has_restarted(line, text):
    assert not line.said(text)  # opened just now
    said = line.said(text[:4], after_s=5.0)
    assert not said
    said = line.said(text[4:])
    assert re.match(
        r"the board at /dev/.* has restarted \(.+\); check its supply", said
    )


CHAT = [b"ok\n", b"V0 0.5\n", b"\n\r\n", b"x" * 3000, b"12", b"no error\n"]
CHAT += [b"0 errors\n", b"errand\n", b"ready.\n"]


@pytest.mark.parametrize("text", CHAT)
def test_chat_of_a_board_is_no_fault(line, text):
    assert not line.said(text)
    assert not line.said(text)
    assert not line.said(b"other" + text, after_s=5.0)
    assert not line.said(text)


def test_a_board_that_is_pulled_out_at_rest_is_named(line):
    ours, theirs = pty.openpty()
    made = tcode.open_board(tcode.tcode_options(os.ttyname(theirs)))
    os.close(theirs)
    assert made.read() == b""
    os.close(ours)
    with pytest.raises(DeviceError, match="nothing takes TCode at /dev/"):
        made.read()


@pytest.mark.parametrize("text", ["127.0.0.1", "a:b", "127.0.0.1:8000,channel=Z9"])
def test_a_board_that_cannot_be_is_named(text):
    with pytest.raises(HapticPlayerError):
        tcode.open_board(tcode.tcode_options(text))
    with pytest.raises(DeviceError, match=r"cannot be opened: .*; see whether"):
        tcode.open_board(tcode.tcode_options("/dev/not-there"))


def test_a_serial_board_gets_bytes_as_they_are():
    ours, theirs = pty.openpty()
    tty.setraw(ours)
    board = tcode.open_board(tcode.tcode_options(os.ttyname(theirs)))
    heard = bytearray()
    reader = threading.Thread(target=lambda: heard.extend(os.read(ours, 100)))
    board.write(b"V05000I20\n")
    reader.start()
    reader.join(30)
    assert bytes(heard) == b"V05000I20\n"
    os.write(ours, b"hello\n")
    wait_until(lambda: board.read() != b"")
    board.close()
    os.close(ours)
    os.close(theirs)
