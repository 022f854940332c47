"""Toys that vibrate: through Intiface, or a board that takes TCode."""

from dataclasses import replace

from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.capabilities import VIBRATION
from hapticplayer.errors import Message

_HERE = "hapticplayer.extras.toys"
TCODE = replace(VIBRATION, rate_hz=50.0, latency_s=0.030)
BUTTPLUG = replace(VIBRATION, rate_hz=20.0, latency_s=0.050)


def devices() -> tuple[DeviceEntry, ...]:
    """See `hapticplayer.extension`."""
    return (
        DeviceEntry(
            "buttplug",
            Message("Intiface"),
            "toys through Intiface (Buttplug): vibration only",
            BUTTPLUG,
            f"{_HERE}.buttplug:make",
            f"{_HERE}.buttplug:silence",
            options=f"{_HERE}.buttplug:buttplug_options",
            guide=f"{_HERE}.guide:BUTTPLUG",
        ),
        DeviceEntry(
            "tcode",
            Message("TCode"),
            "a board that takes TCode by UDP or a serial port: vibration only",
            TCODE,
            f"{_HERE}.tcode:make",
            f"{_HERE}.tcode:silence",
            options=f"{_HERE}.tcode:tcode_options",
            guide=f"{_HERE}.guide:TCODE",
        ),
    )
