# ruff: noqa: ARG002 - the signatures are those of pyusb
"""A bus with simulated Falcons for an unmodified pyusb.

    backend = SimulatedBus([SimulatedPort(chip)])
    usb.core.find(idVendor=0x0403, idProduct=0xCB48, backend=backend)

Descriptors: vendor, product, strings and endpoints as read from real Falcons by
others; what else an FT232R says is from memory.
"""

import errno
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import usb.core
from usb.backend import IBackend

from hapticplayer.devices.falcon.transport import PRODUCT_ID, VENDOR_ID
from hapticplayer.extras.faults.usb.chip import Chip, UsbFault
from hapticplayer.extras.faults.usb.remote import RemoteChip

_GET_DESCRIPTOR, _STRING = 6, 3
_STANDARD_IN, _VENDOR_OUT = 0x80, 0x40
_ENGLISH = b"\x09\x04"


@dataclass
class SimulatedPort:
    """A Falcon in a socket, and what the operating system makes of it."""

    chip: Chip | RemoteChip
    serial: str = "SIM00001"
    has_kernel_driver: bool = False  # whether a driver of the system sits on it
    refuses_with: int = 0  # errno with which opening fails; 0 for none
    is_claimed: bool = False  # whether a program, perhaps another one, uses it


class SimulatedBus(IBackend):  # type: ignore[misc]
    """A pyusb backend; hand it to `usb.core.find`."""

    def __init__(self, ports: list[SimulatedPort]) -> None:
        self.ports = ports

    def enumerate_devices(self) -> list[SimulatedPort]:
        return [port for port in self.ports if port.chip.is_plugged]

    def get_device_descriptor(self, port: SimulatedPort) -> SimpleNamespace:
        """Return the device's descriptor."""
        address = self.ports.index(port) + 2
        return _descriptor(
            "bLength bDescriptorType bcdUSB bDeviceClass bDeviceSubClass "
            "bDeviceProtocol bMaxPacketSize0 idVendor idProduct bcdDevice "
            "iManufacturer iProduct iSerialNumber bNumConfigurations",
            (18, 1, 0x0200, 0, 0, 0, 8, VENDOR_ID, PRODUCT_ID, 0x0600, 1, 2, 3, 1),
            bus=1,
            address=address,
            port_number=address,
            port_numbers=(address,),
            speed=2,
        )

    def get_configuration_descriptor(
        self, port: SimulatedPort, config: int
    ) -> SimpleNamespace:
        """Return the only configuration."""
        if config:
            raise IndexError("one configuration only")
        return _descriptor(
            "bLength bDescriptorType wTotalLength bNumInterfaces bConfigurationValue "
            "iConfiguration bmAttributes bMaxPower",
            (9, 2, 32, 1, 1, 0, 0xA0, 45),
        )

    def get_interface_descriptor(
        self, port: SimulatedPort, intf: int, alt: int, config: int
    ) -> SimpleNamespace:
        """Return the only interface."""
        if intf or alt or config:
            raise IndexError("one interface only")
        return _descriptor(
            "bLength bDescriptorType bInterfaceNumber bAlternateSetting bNumEndpoints "
            "bInterfaceClass bInterfaceSubClass bInterfaceProtocol iInterface",
            (9, 4, 0, 0, 2, 0xFF, 0xFF, 0xFF, 2),
        )

    def get_endpoint_descriptor(
        self, port: SimulatedPort, ep: int, intf: int, alt: int, config: int
    ) -> SimpleNamespace:
        """Return bulk in, bulk out."""
        return _descriptor(
            "bLength bDescriptorType bEndpointAddress bmAttributes wMaxPacketSize "
            "bInterval bRefresh bSynchAddress",
            (7, 5, (0x81, 0x02)[ep], 2, 64, 0, 0, 0),
        )

    def open_device(self, port: SimulatedPort) -> SimulatedPort:
        """Return the port, unless the system refuses."""
        if not port.chip.is_plugged:
            raise _usb_error(errno.ENODEV)
        if port.refuses_with == errno.ENOSYS:
            raise NotImplementedError("Operation not supported")  # as pyusb does
        if port.refuses_with:
            raise _usb_error(port.refuses_with)
        return port

    def close_device(self, port: SimulatedPort) -> None:
        """Nothing is kept per handle."""

    def get_configuration(self, port: SimulatedPort) -> int:
        """Return the only configuration's value."""
        return 1

    def set_configuration(self, port: SimulatedPort, config_value: int) -> None:
        """Accept the only configuration."""

    def claim_interface(self, port: SimulatedPort, intf: int) -> None:
        """Claim the interface, unless it is claimed."""
        if port.is_claimed or port.has_kernel_driver:
            raise _usb_error(errno.EBUSY)
        port.is_claimed = True

    def release_interface(self, port: SimulatedPort, intf: int) -> None:
        """Give it back."""
        port.is_claimed = False

    def is_kernel_driver_active(self, port: SimulatedPort, intf: int) -> bool:
        return port.has_kernel_driver

    def detach_kernel_driver(self, port: SimulatedPort, intf: int) -> None:
        """Take the system's driver away."""
        port.has_kernel_driver = False

    def bulk_write(
        self, port: SimulatedPort, ep: int, intf: int, data: Any, timeout: int
    ) -> int:
        """Send a packet's bytes."""
        with _as_usb():
            taken = port.chip.write(bytes(data), timeout / 1000.0)
        if not taken:
            raise _timeout()
        return taken

    def bulk_read(
        self, port: SimulatedPort, ep: int, intf: int, buff: Any, timeout: int
    ) -> int:
        """Fill the buffer with a packet."""
        with _as_usb():
            packet = port.chip.read(timeout / 1000.0)
        if packet is None:
            raise _timeout()
        if len(packet) > len(buff):
            raise _usb_error(errno.EOVERFLOW)
        buff[: len(packet)] = array("B", packet)
        return len(packet)

    def ctrl_transfer(  # noqa: PLR0913 - as the interface has it
        self,
        port: SimulatedPort,
        request_type: int,
        request: int,
        value: int,
        index: int,
        data: Any,
        timeout: int,
    ) -> int:
        """Answer a request for a string, or hand it to the chip."""
        if (request_type, request) == (_STANDARD_IN, _GET_DESCRIPTOR):
            text = _string_descriptor(port, value)
            buff_length = min(len(text), len(data))
            data[:buff_length] = array("B", text[:buff_length])
            return buff_length
        if request_type != _VENDOR_OUT:
            raise _usb_error(errno.EPIPE)
        with _as_usb():
            port.chip.control(request, value, index)
        return 0


@contextmanager
def _as_usb() -> Iterator[None]:
    """Turn the chip's trouble into the library's error."""
    try:
        yield
    except UsbFault as problem:
        raise _usb_error(problem.errno or errno.EIO) from problem


def _descriptor(fields: str, values: tuple[int, ...], **more: Any) -> SimpleNamespace:
    """Return a descriptor (USB 2.0, section 9.6) with what libusb adds to it."""
    described = dict(zip(fields.split(), values, strict=True))
    return SimpleNamespace(**described, **{"extra_descriptors": b"", **more})


def _string_descriptor(port: SimulatedPort, value: int) -> bytes:
    if value >> 8 != _STRING:
        raise _usb_error(errno.EPIPE)
    texts = {1: "Novint", 2: "FALCON HAPTIC", 3: port.serial}
    which = value & 0xFF
    body = texts[which].encode("utf-16-le") if which else _ENGLISH
    return bytes((len(body) + 2, _STRING)) + body


def _usb_error(code: int) -> Exception:
    error: Exception = usb.core.USBError(errno.errorcode[code], None, code)
    return error


def _timeout() -> Exception:
    error: Exception = usb.core.USBTimeoutError("timeout", None, errno.ETIMEDOUT)
    return error
