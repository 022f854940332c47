"""Bytes of boards, worked out by hand from the published protocols."""

import math
import os
import struct

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.live.byte_stream import ByteSource, LineSplitter, SampleCount
from hapticplayer.capture.live.serial_imus import (
    CsvDecoder,
    RazorBinaryDecoder,
    RazorTextDecoder,
    UltimateImuDecoder,
    Wt901Decoder,
    wt901_rate_commands,
)
from hapticplayer.capture.live.source import SourceLost, open_source
from hapticplayer.clock import ManualClock
from hapticplayer.errors import Message, UsageError

G = 9.80665
# 1 g, -1 g, 2 g at 25 C; 1000, -1000, 0 deg/s; 12:30:15.500 on 27 November 2026
WT901_ACCEL = bytes.fromhex("55 51 00 08 00 F8 00 10 C4 09 83")
WT901_RATE = bytes.fromhex("55 52 00 40 00 C0 00 00 00 00 A7")
WT901_TIME = bytes.fromhex("55 50 1A 0B 1B 0C 1E 0F F4 01 13")
WT901_VALUES = [G, -G, 2 * G, math.radians(1000), -math.radians(1000), 0]
# acceleration 0, -128, 256 counts, field 1, 2, 3, rate 14.375, 0, -14.375
RAZOR_BYTES = bytes.fromhex(
    "00000000 000000C3 00008043 0000803F 00000040 00004040 00006641 00000000 000066C1"
)
RAZOR_TEXT = (
    b"#A-C=0.00,-128.00,256.00\r\n#M-C=1.00,2.00,3.00\r\n#G-C=14.38,0.00,-14.38\r\n"
)
RAZOR_VALUES = [0, G / 2, -G, math.radians(1), 0, -math.radians(1)]
ULTIMATE = b"012345,1.00,-2.00,3.00,0.00,0.50,-1.00,0.10,0.20,0.30\n\r"
CSV = b"time_s,ax,ay,az,gx,gy,gz\n12.345,0.1,-0.2,9.81,0.01,0.02,-0.03\n"

GOLDEN = {
    "wt901": (Wt901Decoder, WT901_ACCEL + WT901_RATE, math.nan, WT901_VALUES),
    "wt901 with its time": (
        Wt901Decoder,
        WT901_TIME + WT901_ACCEL + WT901_RATE,
        9827 * 86400 + 12.5 * 3600 + 15.5,
        WT901_VALUES,
    ),
    "razor": (RazorTextDecoder, b"1.0\n" + RAZOR_TEXT, math.nan, RAZOR_VALUES),
    "razor-binary": (
        RazorBinaryDecoder,
        b"\x43#SYNCH12\r\n" + RAZOR_BYTES,
        math.nan,
        RAZOR_VALUES,
    ),
    "ultimate-imu": (
        UltimateImuDecoder,
        b",0.10\n\r" + ULTIMATE,
        12.345,
        [0, G / 2, -G, math.radians(1), -math.radians(2), math.radians(3)],
    ),
    "csv": (CsvDecoder, CSV, 12.345, [0.1, -0.2, 9.81, 0.01, 0.02, -0.03]),
}
DECODERS = {name: row[0] for name, row in GOLDEN.items()}


@pytest.mark.parametrize("step", [1, 7, 1000])
@pytest.mark.parametrize("name", GOLDEN)
def test_golden_bytes_become_one_sample_in_si(name, step):
    make, data, stamp_s, values = GOLDEN[name]
    decoder, found = make(), []
    for at in range(0, len(data), step):
        part = data[at : at + step]
        found += [(len(data[:at]) + one.end, one) for one in decoder.feed(part)]
    ((end, reading),) = found
    assert reading.values == pytest.approx(values, abs=4e-4)
    assert reading.stamp_s == pytest.approx(stamp_s, nan_ok=True)
    assert end >= len(data) - 1
    assert reading.size <= len(data)


@pytest.mark.parametrize("name", GOLDEN)
def test_a_sample_is_found_behind_noise_and_half_a_sample(name):
    make, data, _, values = GOLDEN[name]
    decoder = make()
    decoder.feed(data)  # in step, or with its header read
    again = decoder.feed(b"\x55\x51\xff 4,\n" * 3 + data[len(data) // 2 :] + data * 3)
    assert again
    assert again[-1].values == pytest.approx(values, abs=4e-4)


@settings(max_examples=150, deadline=None)
@given(
    name=st.sampled_from(sorted(DECODERS)),
    parts=st.lists(
        st.one_of(
            st.binary(max_size=80),
            st.sampled_from([row[1] for row in GOLDEN.values()]),
            st.text("0123456789.,-+einfaA#G=\n\r", max_size=60).map(str.encode),
        ),
        max_size=12,
    ),
)
def test_no_bytes_break_a_decoder(name, parts):
    decoder = DECODERS[name]()
    for part in parts:
        for one in decoder.feed(part):
            assert len(one.values) == 6
            assert one.end <= len(part)
            assert one.size > 0


def test_a_line_without_end_takes_no_memory():
    lines = LineSplitter()
    for _ in range(100):
        assert lines.feed(b"1" * 1000) == []
    assert lines.feed(b"\n1,2\n") == [(5, 4, "1,2")]


def test_rates_that_the_ultimate_imu_scaled_twice_are_left_out():
    row = "{},{},0.00,0.00,0.00,0.00,1.00,0.1,0.2,0.3\n\r"
    lines = [
        row.format(ms, rate) for ms, rate in ((0, 0), (11, 60), (22, 4.17), (33, 61))
    ]
    found = UltimateImuDecoder().feed("".join(lines).encode())
    assert [math.isnan(one.values[3]) for one in found] == [False, True, False]


def test_the_rate_of_a_wt901_is_written_between_unlock_and_save():
    assert [one.hex(" ") for one in wt901_rate_commands("200")] == [
        "ff aa 69 88 b5",
        "ff aa 03 0b 00",
        "ff aa 00 00 00",
    ]


class Link:
    """Hands over what a test has sent."""

    byte_s = 1e-4

    def __init__(self, *parts):
        self.parts = list(parts)

    def read(self, timeout_s):
        return self.parts.pop(0) if self.parts else b""

    def close(self):
        """Nothing is held."""


@pytest.fixture
def clock():
    return ManualClock(100.0)


def source_of(decoder, clock, *parts, rate_hz=None):
    count = SampleCount(rate_hz)
    return ByteSource(Link(*parts), decoder, clock, count, "x", Message("do this"))


def test_arrivals_of_a_batch_are_apart_by_their_bytes(clock):
    data = (WT901_ACCEL + WT901_RATE) * 2 + b"\x55\x51"
    source = source_of(Wt901Decoder(), clock, data, rate_hz=100.0)
    clock.advance(0.02)
    samples = source.read(0.0)
    # 22 bytes each, and two of the next one, of 0.1 ms
    assert samples.arrival_s == pytest.approx([100.0154, 100.0176])
    assert np.diff(samples.stamp_s) == pytest.approx([0.01])


def test_bytes_faster_than_their_baud_came_after_the_last_read(clock):
    sample = WT901_ACCEL + WT901_RATE
    source = source_of(Wt901Decoder(), clock, sample, sample * 10, rate_hz=100.0)
    source.read(0.0)
    clock.advance(0.011)  # in which 5 samples would fit
    arrival_s = source.read(0.0).arrival_s
    assert arrival_s == pytest.approx(clock.now_s() - 0.0011 * np.arange(10, 0, -1))


def test_a_source_that_sends_something_else_is_given_up(clock):
    source = source_of(Wt901Decoder(), clock, *[b"hello" * 20] * 6)
    for _ in range(5):
        source.read(0.0)
    clock.advance(3.1)
    with pytest.raises(SourceLost, match="hold no sample; do this"):
        source.read(0.0)


def test_lost_samples_are_counted_and_late_ones_are_not():
    count = SampleCount(100.0)
    arrivals = [0.01 * k for k in range(100)]
    stamps = [count.stamps(1, at)[0] for at in arrivals]
    assert stamps == pytest.approx(arrivals)
    # a pause of 0.5 s, after which 51 samples come at once: nothing was lost
    assert count.stamps(51, 1.5)[-1] == pytest.approx(1.5)
    # a pause of 0.5 s, after which one sample comes: 50 were lost
    assert count.stamps(1, 2.01)[0] == pytest.approx(2.01, abs=0.011)


def test_a_period_is_measured_and_becomes_the_nearest_usual_one():
    count = SampleCount(None, (50, 100, 200))
    stamps = [count.stamps(1, k / 103.0)[0] for k in range(400)]
    known = np.array(stamps)[np.isfinite(stamps)]
    assert 200 < len(known) < 260
    assert np.diff(known) == pytest.approx(0.01)


@pytest.fixture
def port(tmp_path, monkeypatch):
    """The master's end of a pseudo-terminal and the name of the other end."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    master, slave = os.openpty()
    yield master, os.ttyname(slave)
    os.close(slave)


def read_one(source):
    """Read until there is a sample; a pseudo-terminal hands on in parts."""
    while not len((samples := source.read(1.0)).stamp_s):
        pass
    return samples


def test_a_port_gives_samples_until_it_is_unplugged(port, clock):
    master, name = port
    source = open_source(f"ultimate-imu:{name}", clock)
    os.write(master, ULTIMATE + ULTIMATE.replace(b"012345", b"012356"))
    samples = read_one(source)
    assert samples.stamp_s.tolist() == [12.356]  # the first line may be half of one
    assert samples.accel_mps2[0] == pytest.approx([0, G / 2, -G])
    assert not len(source.read(0.0).stamp_s)
    os.close(master)
    with pytest.raises(SourceLost, match=r"(unplugged|ended).*connect it again"):
        source.read(1.0)
    source.close()


def test_the_rate_of_a_wt901_is_set_only_when_that_is_allowed(port, clock):
    master, name = port
    text = f"wt901:{name},baud=115200,rate=200"
    with pytest.raises(UsageError, match=r"200 samples per second are set.*allow=yes"):
        open_source(text, clock)
    asked = []
    source = open_source(text, clock, ask=lambda question: not asked.append(question))
    source.close()
    assert len(asked) == 1
    commands, written = b"".join(wt901_rate_commands("200")), b""
    while len(written) < len(commands):
        written += os.read(master, 100)
    assert written == commands


def test_a_slow_line_is_refused_before_anything_is_written(port, clock):
    with pytest.raises(UsageError, match=r"cannot send 200 .* at 9600 baud"):
        open_source(f"wt901:{port[1]},rate=200,allow=yes", clock)


def test_units_of_named_columns_are_asked_once_and_kept(port, clock):
    master, name = port
    columns = {"columns": "-,az,ay,ax,gx,gy,gz"}
    with pytest.raises(
        LogQuestion, match="unit of its accelerometer and the unit of its"
    ):
        open_source(f"csv:{name}", clock, LogChoices(**columns))
    units = {"accel_unit": "g", "rate_unit": "deg/s", "rate_hz": "100"}
    open_source(f"csv:{name}", clock, LogChoices(**columns, **units)).close()
    kept = open_source(f"csv:{name},baud=9600", clock)
    os.write(master, b"cut off\n7;1,0;0;-2;90;0;0\n")
    samples = read_one(kept)
    assert samples.accel_mps2[0] == pytest.approx([-2 * G, 0, G])
    assert samples.rate_radps[0] == pytest.approx([math.pi / 2, 0, 0])


def test_struct_and_hand_agree_on_the_bytes_of_a_razor():
    """The golden bytes, by an encoder that is not ours."""
    assert struct.pack("<9f", 0, -128, 256, 1, 2, 3, 14.375, 0, -14.375) == RAZOR_BYTES
