"""The chip's settings as control requests, and packets without their status."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.devices.falcon.ftdi import (
    HELLO_BAUD,
    LOADER_BAUD,
    RUN_BAUD,
    Divisor,
    Ftdi,
    strip_status,
)


class Recorder:
    """A transport that writes down requests and gives prepared packets."""

    def __init__(self, packets=()):
        self.requests, self.packets = [], list(packets)

    def control(self, request, value, index=0):
        self.requests.append((request, value, index))

    def read(self, timeout_s):
        return self.packets.pop(0) if self.packets else b""


def test_settings_are_the_requests_of_the_reference_table():
    recorder = Recorder()
    chip = Ftdi(recorder)
    chip.purge()
    chip.set_latency(16)
    chip.set_latency(1)
    for divisor in (HELLO_BAUD, LOADER_BAUD, RUN_BAUD):
        chip.set_baud(divisor)
    chip.set_format()
    for is_high in (False, True):
        chip.set_dtr(is_high=is_high)
        chip.set_rts(is_high=is_high)
    chip.set_event_character(b">")
    chip.set_event_character(b"")
    assert recorder.requests == [
        (0x00, 0x0001, 0),
        (0x00, 0x0002, 0),
        (0x09, 0x0010, 0),
        (0x09, 0x0001, 0),
        (0x03, 0x4138, 0),
        (0x03, 0x0015, 0),
        (0x03, 0x0002, 0),
        (0x04, 0x0008, 0),
        (0x02, 0x0000, 0),
        (0x01, 0x0100, 0),
        (0x02 - 1, 0x0200, 0),
        (0x01, 0x0101, 0),
        (0x01, 0x0202, 0),
        (0x06, 0x013E, 0),
        (0x06, 0x0000, 0),
    ]


@pytest.mark.parametrize(
    ("value", "index", "baud"),
    [
        (0x4138, 0, 9600.0),
        (0x0015, 0, 3e6 / 21),
        (0x0015, 1, 3e6 / 21.375),
        (0x0002, 0, 1.5e6),
        (0x0001, 0, 2e6),
        (0x0000, 0, 3e6),
        (0xC00A, 1, 3e6 / 10.875),
        (0x8002, 0, 3e6 / 2.25),
    ],
)
def test_divisors_have_the_chips_fractions(value, index, baud):
    assert Divisor(value, index).baud == pytest.approx(baud, rel=1e-12)


@given(st.binary(max_size=400))
def test_every_packet_of_64_bytes_loses_two(payload):
    packets = [payload[i : i + 62] for i in range(0, len(payload), 62)]
    assert strip_status(b"".join(b"\x01\x60" + packet for packet in packets)) == payload


def test_status_bytes_alone_are_no_payload_and_tell_cts():
    chip = Ftdi(Recorder([b"\x01\x60", b"\x11\x60abc", b"", b"\x01\x60"]))
    assert not chip.is_clear_to_send
    assert chip.read(0.01) == b""
    assert not chip.is_clear_to_send
    assert chip.read(0.01) == b"abc"
    assert chip.is_clear_to_send
    assert chip.read(0.01) == b""  # nothing came: the line is as it was
    assert chip.is_clear_to_send
    chip.read(0.01)
    assert not chip.is_clear_to_send
