"""Force feedback of Linux: wheels and joysticks with a motor, pads that rumble."""

from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.capabilities import FULL_N, VIBRATION
from hapticplayer.errors import Message
from hapticplayer.model.device import DeviceCapabilities

_HERE = "hapticplayer.extras.wheels"
WHEEL = DeviceCapabilities(
    axes=1,
    peak_force_n=FULL_N,  # nominal: all that its motor can
    continuous_force_n=FULL_N,
    workspace_radius_m=0.04,  # nominal: it stays in the middle
    rate_hz=250.0,  # USB wheels take 100 to 500 updates a second
    latency_s=0.008,
    has_newtons=False,
)
RUMBLE = VIBRATION


def devices() -> tuple[DeviceEntry, ...]:
    """See `hapticplayer.extension`."""
    return (
        DeviceEntry(
            "wheel",
            Message("Wheel"),
            "wheel or joystick with a motor (Linux): one axis, no newtons",
            WHEEL,
            f"{_HERE}.driver:make_wheel",
            f"{_HERE}.driver:silence_wheel",
            options=f"{_HERE}.options:wheel_options",
            guide=f"{_HERE}.guide:WHEEL",
        ),
        DeviceEntry(
            "rumble",
            Message("Rumble"),
            "game pad or joystick that the kernel can rumble (Linux): vibration only",
            RUMBLE,
            f"{_HERE}.driver:make_rumble",
            f"{_HERE}.driver:silence_rumble",
            options=f"{_HERE}.options:rumble_options",
            guide=f"{_HERE}.guide:RUMBLE",
        ),
    )
