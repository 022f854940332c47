"""Whether numbers in memory are all finite, without numpy.

numpy brings OpenBLAS, whose buffer of 32 MB the locked processes would hold for good.
"""

from typing import Any

_CHUNK_BYTES = 1 << 14


class _Lanes:
    """Numbers of one size, many at a time within one long integer.

    Infinite and NaN are those with all bits of the exponent set (IEEE 754): one more
    there, and the bit of the sign is set.
    """

    def __init__(self, size: int, exponent: int, lowest: int) -> None:
        self._exponents = self._repeat(size, exponent)
        self._ones = self._repeat(size, lowest)
        self._signs = self._repeat(size, 1 << (8 * size - 1))

    @staticmethod
    def _repeat(size: int, lane: int) -> int:
        whole = lane.to_bytes(size, "little") * (_CHUNK_BYTES // size)
        return int.from_bytes(whole, "little")

    def are_finite(self, numbers: "memoryview[Any]") -> bool:
        """Look at little-endian numbers, as bytes."""
        return not any(
            (
                self._exponents
                & int.from_bytes(numbers[at : at + _CHUNK_BYTES], "little")
            )
            + self._ones
            & self._signs
            for at in range(0, len(numbers), _CHUNK_BYTES)
        )


_LANES = {
    "f": _Lanes(4, 0x7F80_0000, 0x0080_0000),
    "d": _Lanes(8, 0x7FF0_0000_0000_0000, 0x0010_0000_0000_0000),
}


def are_finite(numbers: "memoryview[Any]") -> bool:
    """Return whether all numbers of a view of "f" or "d" are finite; 4 ns for each."""
    return _LANES[numbers.format].are_finite(numbers.cast("B"))
