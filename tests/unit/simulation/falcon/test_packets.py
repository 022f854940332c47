"""Packets of the simulated device: what was packed comes back, or nothing."""

import math
import zlib

import pytest

from hapticplayer.model.device import DeviceReading
from hapticplayer.simulation.falcon.packets import (
    MAX_BYTES,
    Control,
    ForceCommand,
    ScriptedEvent,
    command_bytes,
    pack_control,
    pack_reply,
    read_reply,
    unpack,
)

COMMAND = ForceCommand(7, 1234.5, (1.25, -2.5, 0.125))
READING = DeviceReading((0.01, -0.02, 0.03), 0b1010, is_homed=True, replied_s=99.0)
CONTROL = Control(ScriptedEvent.STALL, 0.25)
PACKED = [command_bytes(*COMMAND), pack_reply(8, READING), pack_control(CONTROL)]


@pytest.mark.parametrize(
    ("packet", "data"), [(COMMAND, PACKED[0]), (CONTROL, PACKED[2])]
)
def test_a_packet_comes_back_as_it_was(packet, data):
    assert unpack(data) == packet
    assert len(data) <= MAX_BYTES


@pytest.mark.parametrize("data", PACKED)
def test_no_single_flipped_bit_goes_unnoticed(data):
    for bit in range(8 * len(data)):
        broken = bytearray(data)
        broken[bit // 8] ^= 1 << (bit % 8)
        assert unpack(bytes(broken)) is None
        assert read_reply(bytes(broken)) is None


@pytest.mark.parametrize("data", PACKED)
def test_no_other_length_is_taken(data):
    for length in range(len(data)):
        assert unpack(data[:length]) is None
        assert read_reply(data[:length]) is None
    for longer in (data + b"\0", data + data):
        assert unpack(longer) is None
        assert read_reply(longer) is None


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_numbers_that_are_none_are_not_taken(bad):
    for place in range(3):
        vector = tuple(bad if place == axis else 0.0 for axis in range(3))
        assert unpack(command_bytes(*COMMAND._replace(force_n=vector))) is None
        reply = pack_reply(8, READING._replace(position_m=vector))
        assert read_reply(reply) is None
    assert unpack(command_bytes(*COMMAND._replace(stamp_s=bad))) is None
    assert read_reply(pack_reply(8, READING._replace(replied_s=bad))) is None
    assert unpack(pack_control(Control(ScriptedEvent.STALL, bad))) is None


def test_serial_numbers_wrap_around():
    found = unpack(command_bytes(*COMMAND._replace(serial=(1 << 32) + 5)))
    assert isinstance(found, ForceCommand)
    assert found.serial == 5


def test_a_reply_is_read_as_a_reading_and_nothing_else_is():
    assert read_reply(PACKED[1]) == (8, READING)
    assert unpack(PACKED[1]) is None
    assert read_reply(PACKED[0]) is None
    assert read_reply(PACKED[2]) is None
    other_kind = b"HPx1" + PACKED[1][4:-4]
    assert read_reply(other_kind + zlib.crc32(other_kind).to_bytes(4, "little")) is None
