"""Haply's messages, whatever a service says, and the guard's frame."""

import json
import socket
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st
from websockets.sync.server import serve

from hapticplayer.clock import SystemClock
from hapticplayer.devices.descriptor_passing import hand_over
from hapticplayer.devices.websocket import Connection, text_frame
from hapticplayer.errors import DeviceError
from hapticplayer.extras.inverse3.driver import Inverse3Driver, silence
from hapticplayer.extras.inverse3.protocol import command, state_of
from hapticplayer.extras.inverse3.simulated.service import (
    NONSENSE,
    Service,
    simulation_of,
)

ZERO = (0.0, 0.0, 0.0)
JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=8,
)


def test_the_command_is_the_one_of_the_vendors_pages():
    sent = json.loads(command("0423", "vector", (1.0, 2.0, -3.0)))
    vector = {"vector": {"x": 1.0, "y": 3.0, "z": 2.0}}
    one = {"device_id": "0423", "commands": {"set_cursor_force": vector}}
    assert sent == {"inverse3": [one]}


@given(JSON, st.sampled_from(["state", "status", "device_id", "cursor_position"]))
def test_no_message_of_a_service_breaks_the_reader(part, where):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    device = message["inverse3"][0]
    (device["state"] if where == "cursor_position" else device)[where] = part
    state = state_of(json.dumps(message))
    assert state is None or all(abs(x) < 1.0 for x in state.position_m)


@pytest.mark.parametrize("text", ["", "[]", "7", NONSENSE, '{"inverse3":[]}', b"\xff"])
def test_nonsense_is_no_state(text):
    assert state_of(text) is None


@pytest.mark.parametrize(
    ("version", "field"), [("3.5.0", "vector"), ("3.1.2", "values"), ("4.0", "vector")]
)
def test_the_field_goes_by_the_version(version, field):
    service = Service(simulation_of(), version)
    assert state_of(service.inventory(0.0)).field == field


def test_without_a_device_it_says_what_to_do():
    class Empty:
        def receive(self, _timeout_s=0.0):
            return '{"session_id":1,"inverse3":[]}'

        def close(self):
            self.is_closed = True

    class Impatient(SystemClock):
        passed_s = 0.0

        def now_s(self):
            self.passed_s += 1.0
            return self.passed_s

    link = Empty()
    with pytest.raises(DeviceError, match="has no Inverse3; connect"):
        Inverse3Driver(lambda: link, clock=Impatient()).open()
    assert link.is_closed


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda message: message["inverse3"].append(message["inverse3"][0]), "has 2"),
        (lambda message: message["inverse3"][0]["status"].update(error=7), "error 7"),
    ],
)
def test_a_device_that_cannot_be_meant_is_refused(spoil, says):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    spoil(message)

    class Link:
        def receive(self, _timeout_s=0.0):
            return json.dumps(message)

        def close(self):
            pass

    with pytest.raises(DeviceError, match=says):
        Inverse3Driver(Link).open()


def opened(message):
    class Link:
        def receive(self, _timeout_s=0.0):
            return json.dumps(message)

        def send(self, text):
            self.sent = text

        def fileno(self):
            return -1

        def close(self):
            pass

    driver = Inverse3Driver(Link)
    driver.open()
    return driver


ERRORS = [
    ("overheated", "error overheated"),
    ({"code": 3, "message": "overheated"}, "error overheated"),
    ({"code": 3}, 'error {"code": 3}'),
    ([7, "hot"], r'error \[7, "hot"\]'),
    ("a\nb" * 90, "error a ba b"),
    (7.5, "error 7.5"),
    (True, "error true"),
]
NO_ERRORS = [None, 0, "", "none", "OK", False, [], {}, [None]]


@pytest.mark.parametrize(("error", "says"), ERRORS)
def test_an_error_is_said_in_the_words_of_the_service(error, says):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    message["inverse3"][0]["status"]["error"] = error
    with pytest.raises(DeviceError, match=says) as raised:
        opened(message)
    assert str(raised.value).startswith("the Inverse3 reports")
    assert len(str(raised.value)) < 200
    for alone in ({"error": error}, {"inverse3": None, "errors": [error]}):
        with pytest.raises(DeviceError, match=rf"^Haply's .* reports the {says}"):
            opened(alone)


@pytest.mark.parametrize("error", NO_ERRORS)
def test_a_service_without_an_error_is_not_refused(error):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    message["inverse3"][0]["status"]["error"] = error
    opened(message)


GRIPS = [None, [None], [{}], [{"state": None}], [{"state": {"buttons": None}}], []]
GRIPS += [[{"state": {"buttons": {"a": None}}}]]
STRANGE = [7, "no grip", {"0": {}}, [7], [{"state": {"buttons": {"a": "yes"}}}]]


@pytest.mark.parametrize("grips", [*GRIPS, *STRANGE, "missing"])
def test_a_grip_that_is_off_or_strange_refuses_no_device(grips):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    message["wireless_verse_grip"] = grips
    if grips == "missing":
        del message["wireless_verse_grip"]
    reading = opened(message).exchange(ZERO, 0.001)
    assert reading.is_homed
    assert reading.buttons == reading.malformed == 0
    is_strange = grips in STRANGE
    assert ("wireless grip cannot be read; stop with Esc" in reading.notice) is (
        is_strange
    )


@pytest.mark.parametrize("other", [None, 7, {}, {"device_id": "9", "state": None}])
def test_another_device_that_makes_no_sense_is_left_alone(other):
    message = json.loads(Service(simulation_of()).inventory(0.0))
    assert state_of(json.dumps(message), "0423") is not None
    message["inverse3"].insert(0, other)
    assert state_of(json.dumps(message), "0423").device == "0423"


def test_the_guard_never_waits_for_a_service_that_stalls():
    """A blocking connection whose other side reads nothing fills up."""
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    link, service = socket.socketpair()
    with ours, theirs, link, service:
        write_zero = silence(theirs.fileno())
        frame = text_frame("x" * 900)
        hand_over(ours.fileno(), link.fileno(), frame)
        assert all(write_zero() for _ in range(5_000))
        assert link.getblocking()
        service.close()
        assert not write_zero()


@pytest.mark.parametrize("size", [1, 125, 126, 900])
def test_the_guards_frame_is_one_of_the_protocol(size):
    """A server that is not ours (websockets) takes what the guard writes."""
    heard = []
    with serve(lambda one: heard.append(one.recv()), "127.0.0.1", 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        link = Connection(f"ws://127.0.0.1:{server.socket.getsockname()[1]}", "it")
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with ours, theirs:
            text = "x" * size
            write_zero = silence(theirs.fileno())
            assert write_zero()
            hand_over(ours.fileno(), link.fileno(), text_frame(text))
            assert write_zero()
        clock = SystemClock()
        until_s = clock.now_s() + 60.0
        while not heard and clock.now_s() < until_s:
            clock.sleep_until(clock.now_s() + 0.001)
        link.close()
        server.shutdown()
    assert heard == [text]
