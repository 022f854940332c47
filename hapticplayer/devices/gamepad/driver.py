"""A game pad as a haptic device: it shakes, and knows no place."""

from collections.abc import Callable

from hapticplayer.devices.capabilities import GAMEPAD
from hapticplayer.devices.gamepad.ports import open_pad
from hapticplayer.devices.paced import PacedDriver, silencer

REFRESH_S = 0.5


def make(_line: int) -> PacedDriver:
    """Return the driver of the pad that is plugged in.

    Pads on USB report 250 times a second by themselves; that is the ear for buttons and
    for the cable.
    """
    return PacedDriver("gamepad", GAMEPAD, open_pad, REFRESH_S)


def silence(_line: int) -> Callable[[], bool]:
    """Return what switches a pad's motors off, for the guard."""
    return silencer(open_pad)
