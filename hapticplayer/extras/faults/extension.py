"""The Falcon's own driver on a simulated USB chip, to which faults can happen."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.devices import DeviceEntry

_USB = "hapticplayer.extras.faults.usb"


def devices() -> "tuple[DeviceEntry, ...]":
    """A Falcon on simulated USB."""
    from hapticplayer.devices import DeviceEntry
    from hapticplayer.devices.capabilities import FALCON

    return (
        DeviceEntry(
            "falcon-simulated",
            Message("Falcon on simulated USB"),
            "the Falcon's own driver on simulated USB, for developers",
            FALCON,
            f"{_USB}.driver:make",
            f"{_USB}.remote:silence",
            server=_USB,
            direct=f"{_USB}.driver:simulated",
            is_for_developers=True,
            patience_s=45.0,
        ),
    )
