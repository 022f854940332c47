"""Send zero to a Falcon whose program stalls or has died.

For a guard process. The loop hands it the open USB file (`usbfs`), through which it
can write at any time. Where that is not possible (not Linux, or the loop had not come
so far) the guard looks for the device itself, and gets it as soon as its program has
died: the system leaves the last force on the motors (for how long is not known) and
the line settings on the chip, so one zero frame is enough. A program that stalls
then keeps the device, and only its end helps.
"""

import errno
import os
from collections.abc import Callable
from typing import Any

from hapticplayer.devices.descriptor_passing import take_over
from hapticplayer.devices.falcon import usbfs
from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.devices.falcon.transport import (
    ENDPOINT_OUT,
    FalconBusyError,
    FalconGoneError,
    PyUsbTransport,
    list_falcons,
    open_all,
)
from hapticplayer.errors import DeviceError

NO_LINE = -1
_ZERO_FRAME = encode_command((0, 0, 0))
_WRITE_S = 0.005


class Silencer:
    """Writes one zero frame to the Falcon of a loop, when it is called.

    `line` is the descriptor along which the loop hands over its open USB file; it stays
    the caller's. Without it: every Falcon that is not in use.

    Raises:
        DeviceError: when libusb is missing.
    """

    def __init__(self, backend: Any = None, line: int = NO_LINE) -> None:
        self._backend, self._line = backend, line
        self._file: int | None = None
        self._claimed: list[PyUsbTransport] = []
        list_falcons(backend)  # loads libusb now and not when time is short

    def __call__(self) -> bool:
        """Write; return False when there is no Falcon to write to any more."""
        self._listen()
        if self._file is not None:
            return self._write_to_file(self._file)
        try:
            if not self._claimed:
                self._claimed = open_all(self._backend)
            for transport in self._claimed:
                transport.write(_ZERO_FRAME, _WRITE_S)
        except FalconBusyError:
            return True  # its program lives; the guard calls again
        except FalconGoneError:
            self.close()
            return False
        except DeviceError:
            self.close()  # to start over with the next call
        return True

    def close(self) -> None:
        """Let go of all."""
        for transport in self._claimed:
            transport.close()
        self._claimed = []
        if self._file is not None:
            os.close(self._file)
            self._file = None

    def _listen(self) -> None:
        newest = take_over(self._line) if self._line != NO_LINE else None
        if newest is not None:
            self.close()
            self._file = newest[0]

    def _write_to_file(self, file: int) -> bool:
        try:
            usbfs.bulk_write(file, ENDPOINT_OUT, _ZERO_FRAME, _WRITE_S)
        except OSError as problem:
            if problem.errno in (errno.ENODEV, errno.EBADF):
                self.close()
                return False
        return True


def silence(line: int, _options: object = None) -> Callable[[], bool]:
    """The guard's silencer; the loop hands over the one of that serial number."""
    return Silencer(line=line)
