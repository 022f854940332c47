"""The height of a wavelet block of hjif, from the head of its bit stream.

A block is coded by SPIHT behind an adaptive binary arithmetic coder; its first twelve
symbols, all of one context, are the number of bit planes (4) and the largest coefficient
(8: a mode, then 7 bits as multiples of 2^-7, or of 2^-3 above 1). As the published
reference decodes it (MPEGGroup, 2de9ff1); the coefficients themselves are not read.
"""

import base64
import binascii

from hapticplayer.errors import InputError
from hapticplayer.untrusted import ANOTHER

_RANGE, _DIGITS = 1024, 10
_BIT_PLANES, _HEIGHT = 4, 8


def block_height(stream: str, where: str = "") -> float:
    """Return the largest coefficient of a block, 0 for an empty one.

    Args:
        stream: base64 without padding; the reference ends it where its bits end, so a
            character that completes no byte is left out.
        where: file and place, for errors.
    """
    head = stream.rstrip("=")[:32]
    whole = head[: len(head) - (len(head) % 4 == 1)]
    try:
        content = base64.b64decode(whole + "=" * (-len(whole) % 4), validate=True)
    except (binascii.Error, ValueError) as problem:
        raise InputError(
            "the wavelet stream is not base64", where=where, remedy=ANOTHER
        ) from problem
    if not content:
        return 0.0
    symbols = _symbols(content, _BIT_PLANES + _HEIGHT)
    fraction = sum(bit << place for place, bit in enumerate(symbols[_BIT_PLANES + 1 :]))
    return fraction / 8.0 + 1.0 if symbols[_BIT_PLANES] else fraction / 128.0


def _symbols(content: bytes, count: int) -> list[int]:
    """Return the first symbols of an arithmetic code with one adaptive context."""
    bits = iter([byte >> place & 1 for byte in content for place in range(7, -1, -1)])
    code = 0
    for _ in range(_DIGITS):
        code = 2 * code + next(bits, 0)
    low, high, zeros, total = 0, _RANGE, 8, 16
    found = []
    for _ in range(count):
        width = high - low
        split = int(width * round(zeros / total * _RANGE) / _RANGE)
        split = min(max(split, 1), width - 1)
        symbol = int(code - low >= split)
        found.append(symbol)
        low, high = (low + split, high) if symbol else (low, low + split)
        zeros, total = zeros + 1 - symbol, total + 1
        while True:
            if high <= _RANGE // 2:
                shift = 0
            elif low >= _RANGE // 2:
                shift = _RANGE // 2
            elif low >= _RANGE // 4 and high <= 3 * _RANGE // 4:
                shift = _RANGE // 4
            else:
                break
            low, high = 2 * (low - shift), 2 * (high - shift)
            code = 2 * (code - shift) + next(bits, 0)
    return found
