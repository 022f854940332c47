"""Numbers of whole rows, ten million a second, or nothing where any row is not plain.

`numpy.loadtxt` makes a Python object of each line. Here a block of text is looked at
as bytes: every row has to end in its newline after the same number of separators;
then all its numbers are read in one call.
"""

import warnings

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

_NEWLINE = ord("\n")
_MOST_DIGITS = 18  # of an integer that int64 surely holds


def whole_rows(block: bytes, width: int, separator: str = ",") -> Floats | None:
    """Return the numbers (rows, width) of a block; None where it is not plain.

    Args:
        block: lines in ASCII, each of them with its newline.
        width: cells of a row.
        separator: between them, one character.
    """
    mark = separator.encode()
    block = block.replace(mark + b" ", mark)
    # numpy reads a blank cell as -1
    if any(one in block for one in (b"_", b" ", b"\t" if mark != b"\t" else b" ")):
        return None
    ends = _ends(block, width, separator) if block.endswith(b"\n") else None
    if ends is None or (mark != b"," and b"," in block):
        return None
    plain = block.replace(b"\n", b",").replace(mark, b",")[:-1]
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # what is no number
        try:
            found = np.fromstring(plain, sep=",")
        except (DeprecationWarning, ValueError):
            return None
    return found.reshape(-1, width) if found.size == ends.size else None


def whole_integers(
    block: bytes, width: int, column: int, separator: str = ","
) -> NDArray[np.int64] | None:
    """Return the integers (rows,) of a column exactly; None where they are not plain.

    All have to have the same number of digits: times in nanoseconds since 1970 do.
    """
    mark = separator.encode()
    block = block.replace(mark + b" ", mark)
    ends = _ends(block, width, separator)
    if ends is None:
        return None
    starts = ends[:, column - 1] + 1
    if column == 0:
        starts = np.concatenate([[0], ends[:-1, -1] + 1])
    digits = int(ends[0, column] - starts[0])
    if not 0 < digits <= _MOST_DIGITS + 1:
        return None
    if (ends[:, column] - starts != digits).any():
        return None
    held = np.frombuffer(block, np.uint8)
    value = np.zeros(len(starts), dtype=np.int64)
    for place in range(digits):
        digit = held[starts + place].astype(np.int64) - ord("0")
        if ((digit < 0) | (digit > 9)).any():
            return None
        value = 10 * value + digit
    return None if digits > _MOST_DIGITS and value.min() < 0 else value


def _ends(block: bytes, width: int, separator: str) -> NDArray[np.intp] | None:
    """Return where each cell ends (rows, width), the last of a row at its newline."""
    held = np.frombuffer(block, np.uint8)
    is_end = held == ord(separator)
    is_end |= held == _NEWLINE
    ends = np.flatnonzero(is_end)
    if not len(ends) or len(ends) % width:
        return None
    rows = ends.reshape(-1, width)
    is_newline = held[rows] == _NEWLINE
    is_plain = is_newline[:, -1].all() and not is_newline[:, :-1].any()
    return rows if is_plain else None
