"""USB under the Falcon: the only module that knows pyusb.

Tests and simulators give another `Transport` to the layers above, or a pyusb backend
of their own to this one.
"""

import errno
import math
from array import array
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Protocol

from hapticplayer.errors import DeviceError, Message
from hapticplayer.shipped import UDEV_RULE

VENDOR_ID = 0x0403
PRODUCT_ID = 0xCB48
PACKET_BYTES = 64

_INTERFACE = 0
ENDPOINT_OUT = 0x02
_ENDPOINT_IN = 0x81
_VENDOR_OUT = 0x40
_CONTROL_TIMEOUT_MS = 1000


class FalconGoneError(DeviceError):
    """No Falcon is plugged in, or no longer."""


class FalconBusyError(DeviceError):
    """Another program, or another part of this one, uses the Falcon."""


class FalconForbiddenError(DeviceError):
    """The right to use the Falcon is missing."""


class FalconDriverError(DeviceError):
    """Another driver keeps libusb away from the Falcon."""


class Transport(Protocol):
    """Bytes to and from one FT232R; all methods raise DeviceError."""

    def control(self, request: int, value: int, index: int = 0) -> None:
        """Make a vendor request without data."""

    def write(self, data: bytes, timeout_s: float) -> int:
        """Send bytes; return how many were taken before the time was over."""

    def read(self, timeout_s: float) -> bytes:
        """Return the next packet, at most 64 bytes, status bytes first; or nothing."""

    def close(self) -> None:
        """Let go of the device; may be called again."""


OpenTransport = Callable[[], Transport]


@dataclass(frozen=True, slots=True)
class FalconAddress:
    """A Falcon on the bus; the serial is "" without the right to ask for it."""

    serial: str
    bus: int
    address: int


class PyUsbTransport:
    """A Falcon that was found with pyusb and is claimed for this process.

    Reading and writing may be done by two threads at the same time.

    Raises:
        DeviceError: when it cannot be claimed; says what to do.
    """

    def __init__(self, device: Any) -> None:
        self._device = device
        self.bus, self.address = device.bus or 0, device.address or 0
        self._packet = array("B", bytes(PACKET_BYTES))
        self._is_open = True
        with _explained(Message("opened")):
            _detach_kernel_driver(device)
            _configure(device)
            _usb_util().claim_interface(device, _INTERFACE)

    def control(self, request: int, value: int, index: int = 0) -> None:
        """Make a vendor request without data."""
        with _explained(Message("set up")):
            self._device.ctrl_transfer(
                _VENDOR_OUT, request, value, index, None, _CONTROL_TIMEOUT_MS
            )

    def write(self, data: bytes, timeout_s: float) -> int:
        """Send bytes; return how many were taken before the time was over."""
        try:
            return int(self._device.write(ENDPOINT_OUT, data, _milliseconds(timeout_s)))
        except OSError as problem:
            if _is_timeout(problem):
                return 0
            raise _error_for(problem, Message("written to")) from problem

    def read(self, timeout_s: float) -> bytes:
        """Return the next packet, at most 64 bytes, status bytes first; or nothing."""
        packet = self._packet
        try:
            count = self._device.read(_ENDPOINT_IN, packet, _milliseconds(timeout_s))
        except OSError as problem:
            if _is_timeout(problem):
                return b""
            raise _error_for(problem, Message("read from")) from problem
        return packet[:count].tobytes()

    def close(self) -> None:
        """Let go of the device; may be called again."""
        if self._is_open:
            self._is_open = False
            _usb_util().dispose_resources(self._device)


def list_falcons(backend: Any = None) -> list[FalconAddress]:
    """Return all Falcons by address; raises DeviceError where libusb fails."""
    return [_address_of(device) for device in _find_all(backend)]


def open_all(backend: Any = None) -> list[PyUsbTransport]:
    """Return all Falcons that are not in use.

    Raises:
        FalconGoneError: when none is plugged in.
        FalconBusyError: when all are in use.
        DeviceError: when one cannot be claimed for another reason.
    """
    opened: list[PyUsbTransport] = []
    problem: DeviceError = FalconGoneError("no Falcon is plugged in")
    for device in _find_all(backend):
        try:
            opened.append(PyUsbTransport(device))
        except FalconBusyError as busy:
            problem = busy
    if not opened:
        raise problem
    return opened


def open_falcon(serial: str = "", backend: Any = None) -> PyUsbTransport:
    """Return the Falcon with this serial number, or the only; raises DeviceError."""
    devices = _find_all(backend)
    if not devices:
        raise FalconGoneError(
            "no Falcon is plugged in; connect its USB cable and its power supply"
        )
    if len(devices) == 1 and not serial:
        return PyUsbTransport(devices[0])
    found = {_address_of(device).serial: device for device in devices}
    if serial in found:
        return PyUsbTransport(found[serial])
    if "" in found and serial:  # its number cannot be read without permission
        return PyUsbTransport(found[""])
    known = ", ".join(sorted(filter(None, found))) or Message(
        "without a readable number"
    )
    if serial:
        raise FalconGoneError(
            "no Falcon {serial!r} is plugged in; choose one of {known}",
            serial=serial,
            known=known,
        )
    raise DeviceError(
        "{count} Falcons are plugged in: {known}; choose one, such as falcon:{serial}",
        count=len(devices),
        known=known,
        serial=min(filter(None, found), default="SERIAL"),
    )


def _find_all(backend: Any) -> list[Any]:
    import usb.core

    try:
        found = usb.core.find(
            find_all=True, idVendor=VENDOR_ID, idProduct=PRODUCT_ID, backend=backend
        )
        return sorted(found, key=lambda device: (device.bus or 0, device.address or 0))
    except usb.core.NoBackendError as problem:
        raise DeviceError(
            "libusb is missing; install the package libusb-1.0-0 (Windows: put "
            "libusb-1.0.dll on the path)"
        ) from problem
    except OSError as problem:
        raise _error_for(problem, Message("looked for")) from problem


def _address_of(device: Any) -> FalconAddress:
    try:
        serial = str(_usb_util().get_string(device, device.iSerialNumber) or "")
    except (OSError, ValueError, NotImplementedError):
        serial = ""  # no permission, no languages listed for it, another driver
    return FalconAddress(serial, device.bus or 0, device.address or 0)


def _detach_kernel_driver(device: Any) -> None:
    try:
        if device.is_kernel_driver_active(_INTERFACE):
            device.detach_kernel_driver(_INTERFACE)
    except NotImplementedError:
        return  # a system where programs cannot do that, and need not
    except OSError as problem:
        if problem.errno not in (errno.ENOSYS, errno.ENOENT):
            raise


def _configure(device: Any) -> None:
    """Choose the only configuration, unless it is: choosing again would reset."""
    try:
        device.get_active_configuration()
    except OSError as problem:
        if problem.errno is not None:
            raise
        device.set_configuration()


def _usb_util() -> Any:
    import usb.util

    return usb.util


def _milliseconds(timeout_s: float) -> int:
    return max(1, math.ceil(1000.0 * timeout_s))  # to libusb, 0 means for ever


def _is_timeout(problem: OSError) -> bool:
    return problem.errno == errno.ETIMEDOUT


@contextmanager
def _explained(doing: str) -> Iterator[None]:
    try:
        yield
    except NotImplementedError as problem:  # LIBUSB_ERROR_NOT_SUPPORTED, in pyusb
        raise _error_for(OSError(errno.ENOSYS, str(problem)), doing) from problem
    except OSError as problem:
        raise _error_for(problem, doing) from problem


def _error_for(problem: OSError, doing: str) -> DeviceError:
    """Return the error for a person: what is wrong and what to do."""
    code = problem.errno
    if code in (errno.ENODEV, errno.EIO, errno.ENOENT):
        return FalconGoneError(
            "the Falcon was unplugged, or its cable is loose; plug it in and choose "
            "the device again"
        )
    if code in (errno.EACCES, errno.EPERM):
        return FalconForbiddenError(
            "permission denied for the Falcon; copy the udev rule {rule} to "
            "/etc/udev/rules.d, then unplug the Falcon and plug it in",
            rule=UDEV_RULE,
        )
    if code == errno.EBUSY:
        return FalconBusyError(
            "the Falcon is in use by another program; close that one and try again"
        )
    if code == errno.ENOSYS:
        return FalconDriverError(
            "the Falcon has a driver that keeps libusb out; give it the driver WinUSB "
            "(with the program Zadig) in place of FTDI's or Force Dimension's"
        )
    if code == errno.ETIMEDOUT:
        return DeviceError(
            "the Falcon does not answer; unplug its power and USB, and plug both in"
        )
    return DeviceError(
        "the Falcon could not be {done} ({reason}); unplug it and plug it in again",
        done=doing,
        reason=problem,
    )
