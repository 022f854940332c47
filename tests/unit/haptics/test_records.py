"""Records: what was written comes back, and damage is reported, never guessed over."""

import json
import os
import struct
import tracemalloc
import zlib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from hapticplayer.errors import InputError
from hapticplayer.haptics import record_reader
from hapticplayer.haptics.record_reader import RecordReader, read_record
from hapticplayer.haptics.records import (
    FRAME,
    MAGIC,
    MARKER,
    RecordWriter,
    encode_frame,
    encode_header,
    open_record,
)
from hapticplayer.haptics.shared import TICK

COUNTS = (4, 1, 7)


def random_ticks(count, seed=1):
    """Ticks of random bits, but for their numbers, so that all are different."""
    data = np.random.default_rng(seed).bytes(count * TICK.itemsize)
    ticks = np.frombuffer(bytearray(data), dtype=TICK)
    ticks["monotonic_s"] = np.arange(count)
    return ticks


def in_frames(ticks, counts=COUNTS):
    """The record as bytes, and where each of its parts begins."""
    parts, first = [encode_header({"device": "test"})], 0
    for count in counts:
        parts.append(encode_frame(first, 0, ticks[first : first + count]))
        first += count
    parts.append(encode_frame(first, 0, ticks[:0]))
    starts = np.cumsum([0] + [len(part) for part in parts])
    return b"".join(parts), starts.tolist()


@pytest.fixture
def ticks():
    return random_ticks(sum(COUNTS))


@pytest.fixture
def whole(ticks):
    return in_frames(ticks)[0]


@pytest.fixture
def read(tmp_path):
    path = tmp_path / "record"

    def read_bytes(data):
        path.write_bytes(data)
        return read_record(path)

    return read_bytes


def header_of(content):
    """A header with any content and a checksum that is right."""
    text = content if isinstance(content, bytes) else json.dumps(content).encode()
    head = struct.pack("<8sII", MAGIC, 1, len(text)) + text
    return head + struct.pack("<I", zlib.crc32(head))


def frame_head(count, first, lost, payload=b""):
    """The head of a frame that may lie, with checksums that are right."""
    head = FRAME.pack(MARKER, count, first, lost, zlib.crc32(payload))
    return head + struct.pack("<I", zlib.crc32(head))


# --- what is right ----------------------------------------------------------


def test_every_bit_comes_back(tmp_path, ticks):
    path = tmp_path / "record"
    descriptor = open_record(path)
    writer = RecordWriter(descriptor)
    writer.begin({"device": "simulated", "scheduling": "fifo"})
    writer.append(0, 0, ticks[:5])
    writer.append(5, 0, ticks[5:])
    writer.append(len(ticks), 0, ticks[:0])
    os.close(descriptor)
    record = read_record(path)
    assert record.ticks.tobytes() == ticks.tobytes()
    assert record.ticks.dtype == TICK
    assert record.is_complete
    assert record.lost == 0
    assert record.notice == ""
    assert record.header["device"] == "simulated"
    assert record.header["modes"]["4"] == "tripped"
    assert record.header["started_utc"].endswith("+00:00")


def test_lost_ticks_are_told(read, ticks):
    data = encode_header({}) + encode_frame(10, 10, ticks[:4])
    data += encode_frame(20, 6, ticks[4:6]) + encode_frame(25, 3, ticks[:0])
    record = read(data)
    assert record.lost == 10 + 6 + 3
    assert record.is_complete
    assert record.notice == ""


def test_a_record_with_other_fields_is_read_by_its_header(read):
    other = np.dtype([("monotonic_s", "<f8"), ("grip_n", "<f4", (2,)), ("flag", "u1")])
    rows = np.zeros(3, dtype=other)
    rows["grip_n"] = [[1, 2], [3, 4], [5, 6]]
    data = header_of({"dtype": other.descr}) + encode_frame(0, 0, rows)
    record = read(data + encode_frame(3, 0, rows[:0]))
    assert record.ticks.dtype == other
    assert record.ticks["grip_n"].tolist() == [[1, 2], [3, 4], [5, 6]]


def test_a_record_that_still_grows_is_read_as_far_as_it_is(tmp_path, ticks):
    path = tmp_path / "record"
    descriptor = open_record(path)
    writer = RecordWriter(descriptor)
    writer.begin({})
    writer.append(0, 0, ticks[:3])
    with RecordReader(path) as reader:
        writer.append(3, 0, ticks[3:])  # after the reader has looked
        numbers = [frame.first for frame in reader.frames()]
    os.close(descriptor)
    assert numbers == [0]
    assert not reader.is_complete
    assert "no end" in reader.notice


# --- what is cut off --------------------------------------------------------


def test_cut_off_anywhere_it_gives_what_is_whole_before(read, ticks):
    whole, starts = in_frames(ticks)
    ends = starts[2:-1]  # of the frames with ticks
    for length in range(len(whole)):
        if length < starts[1]:
            with pytest.raises(InputError):
                read(whole[:length])
            continue
        record = read(whole[:length])
        kept = sum(n for n, end in zip(COUNTS, ends, strict=True) if end <= length)
        assert record.ticks.tobytes() == ticks[:kept].tobytes()
        assert not record.is_complete
        assert "no end" in record.notice


def test_a_tail_of_zeros_after_a_loss_of_power_is_recognised(read, ticks):
    whole, starts = in_frames(ticks)
    record = read(whole[: starts[3] - 40] + bytes(10_000))
    assert record.ticks.tobytes() == ticks[: COUNTS[0]].tobytes()
    assert not record.is_complete


# --- what is damaged --------------------------------------------------------


def test_a_flipped_bit_costs_its_frame_and_is_told(read, ticks, rng):
    whole, starts = in_frames(ticks)
    edges = np.cumsum([0, *COUNTS])
    without = {
        k: np.delete(ticks, slice(edges[k], edges[k + 1])) for k in range(len(COUNTS))
    }
    for bit in rng.integers(0, 8 * len(whole), 1000):
        damaged = bytearray(whole)
        damaged[bit // 8] ^= 1 << (bit % 8)
        part = int(np.searchsorted(starts, bit // 8, side="right")) - 1
        if part == 0:
            with pytest.raises(InputError):
                read(bytes(damaged))
            continue
        record = read(bytes(damaged))
        expected = without.get(part - 1, ticks)  # the last part is the end
        assert record.ticks.tobytes() == expected.tobytes()
        assert not record.is_complete
        assert record.notice
        if part <= len(COUNTS):
            assert record.lost == COUNTS[part - 1]
            assert "damaged places: 1" in record.notice


def test_bytes_after_the_end_of_a_record_are_reported(read, whole):
    record = read(whole + b"x")
    assert len(record.ticks) == sum(COUNTS)
    assert not record.is_complete
    assert "after the end" in record.notice


def test_a_marker_across_the_border_of_two_chunks_is_found(read, ticks, monkeypatch):
    monkeypatch.setattr(record_reader, "CHUNK_BYTES", 64)
    whole, starts = in_frames(ticks)
    frame = whole[starts[1] :]
    for gap in range(1, 150):
        record = read(whole[: starts[1]] + b"\xf5" * gap + frame)
        assert record.ticks.tobytes() == ticks.tobytes()
        assert not record.is_complete


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
)
@given(st.binary(max_size=300), st.integers(0, 3))
def test_no_bytes_whatsoever_are_more_than_an_input_error(read, noise, kept):
    whole, starts = in_frames(random_ticks(sum(COUNTS)))
    try:
        record = read(whole[: starts[kept]] + noise)
    except InputError:
        assert kept == 0
    else:
        assert len(record.ticks) == sum(COUNTS[: kept - 1])
        assert not record.is_complete


# --- what lies --------------------------------------------------------------


@pytest.mark.parametrize(
    "head",
    [
        frame_head(0xFFFFFFFF, 0, 0),
        frame_head(32_768, 0, 0),
        frame_head(1, 0, 1, bytes(96)) + bytes(96),
        frame_head(1, 1 << 60, 0, bytes(96)) + bytes(96),
        frame_head(0, 1 << 63, 0),
    ],
    ids=["ticks", "beyond the file", "lost", "number", "end"],
)
def test_a_frame_that_lies_is_left_out_in_little_memory(read, ticks, head):
    data = encode_header({}) + head
    data += encode_frame(0, 0, ticks) + encode_frame(len(ticks), 0, ticks[:0])
    tracemalloc.start()
    record = read(data)
    _, peak_bytes = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert record.ticks.tobytes() == ticks.tobytes()
    assert not record.is_complete
    assert peak_bytes < 8 << 20


def test_ticks_that_go_back_in_time_are_left_out(read, ticks):
    data = encode_header({}) + encode_frame(0, 0, ticks[:6])
    data += encode_frame(2, 0, ticks[:2]) + encode_frame(6, 0, ticks[6:])
    record = read(data + encode_frame(len(ticks), 0, ticks[:0]))
    assert record.ticks.tobytes() == ticks.tobytes()
    assert not record.is_complete


def test_endless_false_frames_are_given_up(read):
    record = read(encode_header({}) + frame_head(1, 0, 0) * 20_000)
    assert len(record.ticks) == 0
    assert "damaged places: 1000" in record.notice


def test_endless_markers_are_given_up(read, monkeypatch):
    looks = []
    is_head = record_reader.is_frame_head
    monkeypatch.setattr(
        record_reader, "is_frame_head", lambda head: looks.append(1) or is_head(head)
    )
    record = read(encode_header({}) + MARKER * 500_000)
    assert len(record.ticks) == 0
    assert "no end" in record.notice
    assert len(looks) < 70_000


@pytest.mark.parametrize(
    "content",
    [
        b"[" * 60_000,
        b"{",
        b"\xff\xfe",
        b'{"dtype": [["a", "<f4"]], "x": NaN}',
        b'{"dtype": [["a", "<f4"]], "x": 1e999}',
        b'{"dtype": [["a", "<f4"]], "x": ' + b"9" * 5000 + b"}",
        [],
        {},
        {"dtype": []},
        {"dtype": "<f4"},
        {"dtype": [["a", "|O"]]},
        {"dtype": [["a", ">f4"]]},
        {"dtype": [["a", "<f4", [1000]]]},
        {"dtype": [["a", "<f4", [0]]]},
        {"dtype": [["a", "<f4", [2, 2]]]},
        {"dtype": [["a", [["b", "<f4"]]]]},
        {"dtype": [["a", "<f4"], ["a", "<f4"]]},
        {"dtype": [["=cmd()", "<f4"]]},
        {"dtype": [["a,b", "<f4"]]},
        {"dtype": [["a", "<f4"]] * 65},
    ],
)
def test_a_header_that_lies_is_refused(read, content):
    with pytest.raises(InputError, match="header"):
        read(header_of(content))


def test_a_header_longer_than_its_file_is_refused_cheaply(read):
    with pytest.raises(InputError, match="header"):
        read(struct.pack("<8sII", MAGIC, 1, 0xFFFFFFFF) + bytes(100))


def test_another_version_is_told_apart(read):
    with pytest.raises(InputError, match="version 7"):
        read(struct.pack("<8sII", MAGIC, 7, 0) + bytes(100))


@pytest.mark.parametrize("data", [b"", b"time_s,ax\n1,2\n", b"\x89PNG\r\n\x1a\n" * 9])
def test_other_files_are_refused(read, data):
    with pytest.raises(InputError, match=r"is empty|is not a recording"):
        read(data)


def test_a_record_that_is_not_a_plain_file_is_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", tmp_path, tmp_path / "none", tmp_path / "a\0b"):
        with pytest.raises(InputError):
            read_record(path)


def test_a_huge_sparse_file_takes_little_memory_and_time(tmp_path, ticks, monkeypatch):
    monkeypatch.setattr(record_reader, "MAX_SEARCH_BYTES", 8 << 20)
    path = tmp_path / "record"
    whole, starts = in_frames(ticks)
    path.write_bytes(whole[: starts[-2]])
    os.truncate(path, 1 << 42)
    with pytest.raises(InputError, match="too large"):
        read_record(path)
    with RecordReader(path) as reader:
        assert sum(len(frame.ticks) for frame in reader.frames()) == len(ticks)
    assert not reader.is_complete


# --- writing ----------------------------------------------------------------


def test_a_record_never_replaces_a_file(tmp_path):
    path = tmp_path / "record"
    path.write_text("dear")
    with pytest.raises(InputError, match="already exists"):
        open_record(path)
    assert path.read_text() == "dear"
    for wrong in (tmp_path / "no folder" / "record", tmp_path / "a\0b"):
        with pytest.raises(InputError, match="cannot be written"):
            open_record(wrong)
