import contextlib
import struct

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.capture.gpmf import (
    GpmfEntry,
    first_number_of,
    numbers_of,
    parse,
    text_of,
)
from hapticplayer.errors import TelemetryError
from tests.unit.capture.conftest import device, klv, nested, sensor, shorts, text


def only(payload: bytes) -> GpmfEntry:
    (entry,) = parse(payload).children
    return entry


@pytest.mark.parametrize(
    ("kind", "code", "value"),
    [
        ("b", ">b", -7),
        ("B", ">B", 200),
        ("s", ">h", -3000),
        ("S", ">H", 60000),
        ("l", ">i", -70000),
        ("L", ">I", 4_000_000_000),
        ("j", ">q", -(2**40)),
        ("J", ">Q", 2**50),
        ("f", ">f", 1.5),
        ("d", ">d", -2.25),
    ],
)
def test_each_number_type_is_read(kind, code, value):
    raw = struct.pack(code, value) * 3
    entry = only(klv("DATA", kind, raw, len(raw) // 3))
    np.testing.assert_array_equal(numbers_of(entry), [[value]] * 3)


def test_fixed_point_numbers_are_scaled():
    entry = only(klv("DATA", "q", struct.pack(">i", 3 << 15), 4))
    assert numbers_of(entry).item() == 1.5
    entry = only(klv("DATA", "Q", struct.pack(">q", 5 << 31), 8))
    assert numbers_of(entry).item() == 2.5


def test_structures_of_several_numbers_are_rows():
    entry = only(shorts("ACCL", [[1, 2, 3], [4, 5, -6]]))
    np.testing.assert_array_equal(numbers_of(entry), [[1, 2, 3], [4, 5, -6]])


def test_complex_type_keeps_its_numbers_and_skips_text():
    raw = struct.pack(">I4s2fH", 7, b"SNOW", 0.5, 0.25, 9)
    entry = only(klv("SCEN", "?", raw * 2, len(raw)))
    np.testing.assert_array_equal(
        numbers_of(entry, "LFf[2]S"), [[7.0, 0.5, 0.25, 9.0]] * 2
    )


@pytest.mark.parametrize("complex_type", ["", "LLLLLLLLLL", "x", "L[999]", "[3]"])
def test_complex_type_that_does_not_fit_gives_no_columns(complex_type):
    entry = only(klv("SCEN", "?", bytes(8), 8))
    assert numbers_of(entry, complex_type).shape == (1, 0)


@pytest.mark.parametrize("kind", ["c", "F", "U", "G", "z", "\xff"])
def test_text_and_unknown_types_have_no_numbers(kind):
    entry = only(klv("DATA", kind, bytes(32), 16))
    assert numbers_of(entry).shape == (2, 0)


def test_padding_between_entries_is_skipped():
    root = parse(text("STNM", "abcde") + text("SIUN", "m/s\xb2"))
    assert [text_of(entry) for entry in root.children] == ["abcde", "m/s²"]
    assert not root.is_cut


def test_nesting_is_followed():
    root = parse(nested("DEVC", nested("STRM", shorts("ACCL", [[1, 2, 3]]))))
    stream = root.children[0].children[0]
    assert stream.key == "STRM"
    assert stream.find("ACCL") is not None
    assert stream.find("GYRO") is None


def test_zeros_at_the_end_are_padding():
    root = parse(shorts("ACCL", [[1, 2, 3]]) + bytes(64))
    assert len(root.children) == 1
    assert not root.is_cut


def test_length_beyond_the_parent_ends_it():
    long = klv("GYRO", "s", bytes(600), 6)[:20]
    root = parse(nested("DEVC", shorts("ACCL", [[1, 2, 3]]), long))
    (devc,) = root.children
    assert [entry.key for entry in devc.children] == ["ACCL"]
    assert devc.is_cut


def test_endless_nesting_is_refused():
    payload = b""
    for _ in range(50):
        payload = nested("DEVC", payload)
    with pytest.raises(TelemetryError, match="nested deeper"):
        parse(payload)


def walk(entry: GpmfEntry) -> None:
    """Touch everything that can be touched."""
    text_of(entry)
    for complex_type in ("", "Lf[3]", "ssS"):
        values = numbers_of(entry, complex_type)
        assert values.dtype == np.float64
        assert values.ndim == 2
    for child in entry.children:
        walk(child)


VALID = device(
    "HERO9 Black",
    sensor("ACCL", np.ones((5, 3)), total=5, stamp_us=1000),
    sensor("GYRO", np.zeros((5, 3)), scale=939.0),
)


@given(st.binary(max_size=400))
@settings(max_examples=300)
def test_random_bytes_are_read_or_refused(payload):
    with contextlib.suppress(TelemetryError):
        walk(parse(payload))


@given(
    st.lists(
        st.tuples(st.integers(0, len(VALID) - 1), st.integers(0, 255)),
        min_size=1,
        max_size=12,
    ),
    st.integers(0, len(VALID)),
)
@settings(max_examples=400)
def test_damaged_payloads_are_read_or_refused(changes, length):
    payload = bytearray(VALID)
    for position, value in changes:
        payload[position] = value
    for damaged in (bytes(payload), bytes(payload[:length])):
        with contextlib.suppress(TelemetryError):
            walk(parse(damaged))


@pytest.mark.parametrize(
    ("kind", "value", "expected"),
    [
        ("b", "ff", -1.0),
        ("B", "ff", 255.0),
        ("s", "fffe", -2.0),
        ("S", "fffe", 65534.0),
        ("l", "80000000", -(2.0**31)),
        ("L", "80000000", 2.0**31),
        ("j", "ffffffff00000000", -(2.0**32)),
        ("J", "0000000100000001", 2.0**32 + 1.0),
        ("f", "3fc00000", 1.5),
        ("d", "3ff8000000000000", 1.5),
        ("q", "00018000", 1.5),
        ("Q", "0000000180000000", 1.5),
        ("c", "41414141", float("nan")),
    ],
)
def test_first_number_is_that_of_its_type(kind, value, expected):
    content = bytes.fromhex(value)
    one = only(klv("STMP", kind, content * 2, len(content)))
    assert first_number_of(one) == pytest.approx(expected, nan_ok=True)
    assert np.isnan(first_number_of(only(klv("STMP", kind, b"", len(content)))))
