"""Events of a joystick, as the kernel writes them."""

import os
import struct

import pytest

from hapticplayer.devices.joystick import Joystick, joysticks
from hapticplayer.errors import DeviceError


def event(value, kind, number):
    return struct.pack("<IhBB", 1234, value, kind, number)


@pytest.fixture
def line(tmp_path):
    """A joystick, and the other end of its line."""
    path = tmp_path / "js0"
    os.mkfifo(path)
    stick = Joystick(path)
    writer = os.open(path, os.O_WRONLY)
    yield stick, writer
    os.close(writer)
    stick.close()


def test_axes_are_shares_of_their_range_with_away_as_large(line):
    stick, writer = line
    assert stick.share("x") is None
    os.write(writer, event(32767, 0x82, 0) + event(-32767, 0x02, 1))
    os.write(writer, event(1, 0x01, 0) + event(0, 0x02, 3))  # and a button
    assert [stick.share(axis) for axis in ("x", "y", "throttle", "z")] == [
        *(1.0, 1.0, 0.5, None)
    ]


def test_an_event_that_comes_in_parts_is_whole(line):
    stick, writer = line
    whole = event(-32768, 0x02, 0)
    os.write(writer, whole[:5])
    assert stick.share("x") is None
    os.write(writer, whole[5:])
    assert stick.share("x") == 0.0


def test_no_joystick_is_said(tmp_path):
    assert joysticks(tmp_path) == []
    with pytest.raises(DeviceError, match="cannot be opened"):
        Joystick(tmp_path / "js0")
