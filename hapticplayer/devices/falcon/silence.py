"""The last word to a Falcon whose program has died: zero.

For a guard process. The system takes the device from a program that has died and
leaves its last force on the motors (for how long is not known), its line settings on
the chip; so one zero frame is enough. A program that stands still but lives keeps the
device: then nobody else can speak to it, and only its end helps.
"""

from collections.abc import Callable
from typing import Any

from hapticplayer.devices.falcon.protocol import encode_command
from hapticplayer.devices.falcon.transport import (
    FalconBusyError,
    FalconGoneError,
    PyUsbTransport,
    list_falcons,
    open_all,
)
from hapticplayer.errors import DeviceError

_ZERO_FRAME = encode_command((0, 0, 0))
_WRITE_S = 0.005


class Silencer:
    """Writes one zero frame to every Falcon that nobody uses, when it is called.

    Args:
        backend: of pyusb; None for the machine's libusb.

    Raises:
        DeviceError: when libusb is missing.
    """

    def __init__(self, backend: Any = None) -> None:
        self._backend = backend
        self._claimed: list[PyUsbTransport] = []
        list_falcons(backend)  # loads libusb now and not when time is short

    def __call__(self) -> bool:
        """Write; return False when there is no Falcon to write to any more."""
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
            self.close()  # to begin anew with the next call
        return True

    def close(self) -> None:
        """Let go of all."""
        for transport in self._claimed:
            transport.close()
        self._claimed = []


def silence(_handle: int) -> Callable[[], bool]:
    """Return what a guard calls; the Falcon is found by itself, not by a handle."""
    return Silencer()
