"""Pads on USB through hidapi: the only place that knows it."""

import importlib
import sys
from dataclasses import dataclass
from typing import Any

from hapticplayer.devices import UDEV_RULE
from hapticplayer.devices.gamepad.reports import (
    VENDOR_ID,
    Layout,
    PadRumble,
    layout_of,
)
from hapticplayer.devices.paced import Port
from hapticplayer.errors import DeviceError

_BLUETOOTH = 2  # of hidapi's bus types
_INPUT_BYTES = 64


@dataclass(frozen=True, slots=True)
class ConnectedPad:
    """A pad that is plugged in."""

    layout: Layout
    path: bytes
    serial: str


class HidPort:
    """A pad that hidapi has opened; raises DeviceError when it cannot be opened."""

    is_quiet = False

    def __init__(self, found: ConnectedPad) -> None:
        self.layout = found.layout
        self.translator = PadRumble(found.layout)
        self._device = _hidapi().device()
        try:
            self._device.open_path(found.path)
        except OSError as problem:
            raise DeviceError(
                "permission denied for the {title}, or it is gone; copy the udev rule "
                "{rule} to /etc/udev/rules.d, then unplug it and plug it in",
                title=found.layout.title,
                rule=UDEV_RULE,
            ) from problem
        self._device.set_nonblocking(1)

    def write(self, report: bytes) -> None:
        """Send a report."""
        try:
            count = self._device.write(report)
        except (OSError, ValueError) as problem:
            raise self._gone() from problem
        if count < 0:
            raise self._gone()

    def read(self) -> bytes:
        """Return the next report."""
        try:
            return bytes(self._device.read(_INPUT_BYTES))
        except (OSError, ValueError) as problem:
            raise self._gone() from problem

    def close(self) -> None:
        """Let go of the pad."""
        self._device.close()

    def _gone(self) -> DeviceError:
        return DeviceError(
            "the {title} was unplugged; plug it in and choose the device again",
            title=self.layout.title,
        )


def list_pads() -> list[ConnectedPad]:
    """Return the pads on USB that can be driven; raises DeviceError without hidapi."""
    found = []
    for info in _hidapi().enumerate(VENDOR_ID, 0):
        layout = layout_of(info["product_id"])
        if layout is not None and info.get("bus_type") != _BLUETOOTH:
            serial = str(info.get("serial_number") or "")
            found.append(ConnectedPad(layout, bytes(info["path"]), serial))
    return found


def open_pad() -> Port:
    """Return the first pad, open; raises DeviceError when there is none that opens."""
    found = list_pads()
    if not found:
        raise DeviceError(
            "no game pad is plugged in; connect a DualSense or DualShock 4 by USB cable"
        )
    return HidPort(found[0])


def _hidapi() -> Any:
    # on Linux the flavour that goes by the kernel's driver, which may stay where it is
    name = "hidraw" if sys.platform == "linux" else "hid"
    try:
        return importlib.import_module(name)
    except ImportError as problem:
        raise DeviceError(
            "the Python package hidapi is missing; ./run sets it up in .venv"
        ) from problem
