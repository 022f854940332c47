"""Spoilt lists of toys are refused in one sentence that names Intiface."""

import json
from functools import partial

import pytest

from hapticplayer.errors import DeviceError
from hapticplayer.extras.toys.messages import toys_of
from tests.unit.test_spoilt_documents import refusal, spoilt

DEVICES = {
    "Devices": {
        "0": {
            "DeviceIndex": 0,
            "DeviceMessageTimingGap": 10,
            "DeviceFeatures": {"0": {"Output": {"Vibrate": {"Value": [0, 20]}}}},
        }
    }
}
OLDER = {
    "Devices": [
        {
            "DeviceIndex": 0,
            "DeviceMessages": {
                "ScalarCmd": [{"StepCount": 20, "ActuatorType": "Vibrate"}]
            },
        }
    ]
}


@pytest.mark.parametrize(("version", "document"), [(4, DEVICES), (3, OLDER)])
def test_a_spoilt_list_of_toys_is_refused(version, document):
    assert toys_of(document, version, "Intiface").found[0].motors
    for what, text in spoilt(document):
        try:
            listed = json.loads(text)
        except (ValueError, RecursionError):
            continue
        if isinstance(listed, dict):
            said = refusal(
                partial(toys_of, listed, version, "Intiface"), what, DeviceError
            )
            assert not said or "Intiface" in said, what
