"""The Novint Falcon over USB, from the wire up.

`transport` moves bytes, `ftdi` is the serial chip, `firmware` starts the processor
behind it, `protocol` has the frames, `kinematics` the legs, and `driver` makes a
haptic device of all of them.
"""

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import DeviceError


def falcon_options(text: str) -> DeviceOptions:
    """Which Falcon, by its serial number; raises DeviceError."""
    if text and not text.isalnum():
        raise DeviceError(
            "{text!r} is not a serial number, which has letters and digits only, nor "
            "gain=; see 'hapticplayer device list'",
            text=text,
        )
    return DeviceOptions(FALCON, text)
