"""Spoilt states of an Inverse3 are ignored, and named where there are no others."""

import itertools
import json
import math

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import DeviceError
from hapticplayer.extras.inverse3.driver import Inverse3Driver
from hapticplayer.extras.inverse3.protocol import state_of
from tests.unit.test_spoilt_documents import spoilt


def test_a_spoilt_state_of_an_inverse3_is_ignored():
    place = {"x": 0.0, "y": 0.0, "z": 0.0}
    device = {
        "device_id": "a",
        "state": {"cursor_position": place},
        "status": {"calibrated": True, "ready": True},
    }
    grip = {"state": {"buttons": {"a": True, "b": False}}}
    document = {"version": "3.5.0", "inverse3": [device], "wireless_verse_grip": [grip]}
    assert state_of(json.dumps(document)) is not None
    for what, text in spoilt(document):
        state = state_of(text)
        if state is not None:
            assert all(abs(one) < 1.0 for one in state.position_m), what


HOSTILE = ["1", None, [1], 10**400, math.inf, math.nan, {}, "n" * 70_000, 2.0]


@pytest.mark.parametrize("value", HOSTILE, ids=lambda value: str(value)[:9])
@pytest.mark.parametrize("field", ["x", "device_id", "calibrated", "inverse3"])
def test_a_service_that_says_strange_things_is_named(field, value):
    """Before anything is sent there is one sentence; the grip's id stays short."""
    if field == "device_id" and value == "1":
        return
    place = {"x": 0.0, "y": 0.0, "z": 0.0}
    status, device = {"calibrated": True}, {"device_id": "a"}
    message = {"inverse3": [device]}
    for part in (place, status, device, message):
        if field in part:
            part[field] = value
    device |= {"state": {"cursor_position": place}, "status": status}
    text = json.dumps(message)
    assert state_of(text) is None
    clock = ManualClock()

    class Link:
        said = itertools.chain([text], itertools.repeat(""))

        def receive(self, _timeout_s):
            clock.advance(1.0)
            return next(self.said)

        def close(self):
            self.is_closed = True

    with pytest.raises(DeviceError, match=r"^Haply's Inverse Service.*; ") as raised:
        Inverse3Driver(Link, clock=clock).open()
    assert len(str(raised.value)) < 300
    assert "update it" in str(raised.value)
