"""Bass shakers and voice coils on a sound card."""

from dataclasses import replace

from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.capabilities import VIBRATION
from hapticplayer.errors import Message

_HERE = "hapticplayer.extras.shakers"
SHAKER = replace(VIBRATION, rate_hz=1000.0, latency_s=0.080, has_own_clock=True)


def devices() -> tuple[DeviceEntry, ...]:
    """See `hapticplayer.extension`."""
    return (
        DeviceEntry(
            "shaker",
            Message("Shaker"),
            "bass shakers and voice coils on a sound card",
            SHAKER,
            f"{_HERE}.driver:make",
            f"{_HERE}.silence:silence",
            options=f"{_HERE}.settings:shaker_settings",
            guide=f"{_HERE}.guide:SHAKER",
        ),
    )
