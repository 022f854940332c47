"""Spoilt states of an Inverse3 are ignored."""

import json

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
