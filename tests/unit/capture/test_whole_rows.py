"""Text is read as numbers only where float() would read the same."""

import numpy as np
import pytest

from hapticplayer.capture.whole_rows import whole_integers, whole_rows


def by_hand(block: bytes, separator: str) -> np.ndarray:
    lines = block.decode().splitlines()
    return np.array([[float(c) for c in line.split(separator)] for line in lines])


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_numbers_are_those_of_float(separator):
    rng = np.random.default_rng(4)
    values = rng.standard_normal((500, 7)) * 10.0 ** rng.integers(-300, 300, (500, 7))
    lines = (separator.join(repr(float(v)) for v in row) for row in values)
    block = "".join(line + "\n" for line in lines).encode()
    np.testing.assert_array_equal(whole_rows(block, 7, separator), values)
    np.testing.assert_array_equal(by_hand(block, separator), values)


@pytest.mark.parametrize(
    "block",
    [
        b"1,2,3\n4,,6\n",
        b"1,2,3\n4, ,6\n",  # numpy alone reads -1
        b"1,2,3\n,5,6\n",
        b"1,2,3\n4,5,\n",
        b"1,2,3\n4,5\n",
        b"1,2,3\n4,5,6,7\n",
        b"1,2\n3,4,5,6\n",
        b"1,2,3\n4,5,6",
        b"1,2,3\n4,5,six\n",
        b"1,2,3\n4,5,0x6\n",
        b"1,2,3\n4,5,6_0\n",
        b"1,2,3\n4,5 5,6\n",
        b"1,2,3\n\n4,5,6\n",
        b"1,2,3\n4,5\t5,6\n",
        b"",
        b"\n",
    ],
)
def test_what_is_not_plain_is_left_to_somebody_else(block):
    assert whole_rows(block, 3) is None


def test_empty_cells_between_tabs_are_not_skipped():
    assert whole_rows(b"1\t\t3\n4\t5\t6\n", 3, "\t") is None


def test_blanks_after_separators_and_nan_are_numbers():
    found = whole_rows(b"1, 2, nan\n-4, 5e3, inf\n", 3)
    np.testing.assert_array_equal(found, [[1, 2, np.nan], [-4, 5000, np.inf]])


def test_nanoseconds_are_exact():
    first = 1_700_000_000_123_456_789
    times = [first + 10_000_001 * k for k in range(1000)]
    block = "".join(f"0.5,{t},{k}\n" for k, t in enumerate(times)).encode()
    assert whole_integers(block, 3, 1).tolist() == times
    assert whole_integers(block, 3, 2) is None  # of different lengths
    assert whole_integers(block, 3, 0) is None  # no integers
    too_long = b"9999999999999999999,1\n"
    assert whole_integers(too_long, 2, 0) is None
