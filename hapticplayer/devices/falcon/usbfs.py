"""Linux's device files for USB: one open file, held by two processes.

An interface belongs to the open file through which it was claimed, not to a process
(Linux, drivers/usb/core/devio.c). So a guard that holds the loop's own descriptor can
write to the device while the loop stalls, and after it has died.
"""

import contextlib
import ctypes
import fcntl
from pathlib import Path

NODE = "/dev/bus/usb/{:03}/{:03}"
_OPEN_FILES = Path("/proc/self/fd")


class _Bulk(ctypes.Structure):
    """struct usbdevfs_bulktransfer."""

    _fields_ = (
        ("endpoint", ctypes.c_uint),
        ("length", ctypes.c_uint),
        ("timeout_ms", ctypes.c_uint),
        ("data", ctypes.c_void_p),
    )


# _IOWR('U', 2, struct usbdevfs_bulktransfer), as most machines number requests
BULK = 3 << 30 | ctypes.sizeof(_Bulk) << 16 | ord("U") << 8 | 2


def open_descriptor(bus: int, address: int) -> int | None:
    """Return this process's descriptor of a device that libusb has opened, if any."""
    node = NODE.format(bus, address)
    with contextlib.suppress(OSError):
        for entry in _OPEN_FILES.iterdir():
            with contextlib.suppress(OSError):  # listing made one that is closed again
                if str(entry.readlink()) == node:
                    return int(entry.name)
    return None


def bulk_write(descriptor: int, endpoint: int, data: bytes, timeout_s: float) -> int:
    """Send bytes through a descriptor; return how many were taken.

    Raises:
        OSError: ENODEV when the device is gone, ETIMEDOUT when it takes nothing.
    """
    buffer = ctypes.create_string_buffer(data, len(data))
    timeout_ms = max(1, round(1000.0 * timeout_s))
    bulk = _Bulk(endpoint, len(data), timeout_ms, ctypes.addressof(buffer))
    return int(fcntl.ioctl(descriptor, BULK, bulk, True))
