"""Opening a shaker gives a DualSense's coils to the sound, and leaves other pads alone."""

import pytest

from hapticplayer.devices.gamepad.ports import ConnectedPad
from hapticplayer.devices.gamepad.reports import DUALSENSE, DUALSHOCK4, motors_report
from hapticplayer.devices.transducer.coils import give_coils_to_sound
from hapticplayer.devices.transducer.settings import shaker_settings
from hapticplayer.errors import DeviceError

PADS = [ConnectedPad(DUALSHOCK4, b"a", "1"), ConnectedPad(DUALSENSE, b"b", "2")]


class Pad:
    def __init__(self, found, written, *, may_write=True):
        self.found, self.written, self.may_write = found, written, may_write

    def write(self, report):
        if not self.may_write:
            raise DeviceError("permission denied")
        self.written.append((self.found.layout, report))

    def close(self):
        self.written.append("closed")


def written(text, **more):
    found = []
    settings = shaker_settings(text)
    give_coils_to_sound(settings, lambda: PADS, lambda pad: Pad(pad, found, **more))
    return found


@pytest.mark.parametrize(
    "text",
    ["DualSense Wireless Controller,channels=1", "pulse,channels=3+4", ",channels=4"],
)
def test_a_dualsense_gets_a_report_with_both_flags_clear(text):
    (layout, report), closed = written(text)
    assert (layout, closed) == (DUALSENSE, "closed")
    assert len(report) == DUALSENSE.size
    assert report[0] == motors_report(DUALSENSE, 0, 0)[0]
    assert report[1:] == bytes(DUALSENSE.size - 1)
    assert (
        motors_report(DUALSENSE, 0, 0)[1] & 0x03 == 0x03
    )  # a game pad takes them back


@pytest.mark.parametrize("text", ["", "pulse,channels=1+2", "Shaker Amp,channels=3+4"])
def test_sound_that_is_not_its_leaves_it_alone(text):
    assert written(text) == []


def test_without_the_right_to_write_the_sound_is_tried():
    assert written("pulse,channels=3+4", may_write=False) == ["closed"]
