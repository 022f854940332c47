"""A joystick as Linux offers it: a file of events, such as /dev/input/js0."""

import contextlib
import os
import struct
from collections.abc import Mapping
from pathlib import Path

from hapticplayer.errors import DeviceError

_EVENT = struct.Struct("<IhBB")  # ms, value, type, number
_AXIS, _OF_START = 2, 0x80
_MOST = 32767.0
_READ_BYTES = 64 * _EVENT.size
NUMBERS: Mapping[str, int] = {"x": 0, "y": 1, "z": 2, "throttle": 3}
_UPWARDS = (1, 3)
"""Axes that count downwards: what is pushed away is to be large."""


def joysticks(folder: Path = Path("/dev/input")) -> list[Path]:
    return sorted(folder.glob("js[0-9]*"))


class Joystick:
    """Follows the axes of a joystick without waiting.

    Raises:
        DeviceError: when it cannot be opened.
    """

    def __init__(self, path: Path) -> None:
        self._shares: dict[int, float] = {}
        self._rest = b""
        try:
            self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        except OSError as problem:
            raise DeviceError(
                "the joystick cannot be opened ({reason})",
                where=str(path),
                remedy="plug it in, or add yourself to the group 'input'",
                reason=problem,
            ) from problem

    def share(self, axis: str) -> float | None:
        """Where an axis is now, from 0 to 1; None before it is known, or unplugged."""
        with contextlib.suppress(BlockingIOError):
            try:
                while read := os.read(self._file, _READ_BYTES):
                    self._take(read)
            except BlockingIOError:
                raise
            except OSError:  # unplugged: nothing is known any more
                self._shares.clear()
        return self._shares.get(NUMBERS[axis])

    def _take(self, read: bytes) -> None:
        events = self._rest + read
        whole = len(events) - len(events) % _EVENT.size
        self._rest = events[whole:]
        for _, value, kind, number in _EVENT.iter_unpack(events[:whole]):
            if kind & ~_OF_START == _AXIS:
                signed = -value if number in _UPWARDS else value
                share = 0.5 + 0.5 * signed / _MOST
                self._shares[number] = min(max(share, 0.0), 1.0)

    def close(self) -> None:
        os.close(self._file)
