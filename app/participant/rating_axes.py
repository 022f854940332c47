"""The axes that can move a rating: the grip of the device, and a joystick."""

import math

from hapticplayer.devices.joystick import Joystick, joysticks
from hapticplayer.errors import DeviceError
from hapticplayer.playback.player import Player

GRIP_TRAVEL_M = 0.03
"""From the middle to the end of a scale; the workspace goes on a little."""
_GRIP = ("grip-x", "grip-y", "grip-z")


class RatingAxes:
    """Reads axes by the names that a definition has.

    Raises:
        DeviceError: when a joystick is wanted and there is none.
    """

    def __init__(self, player: Player, wanted: set[str]) -> None:
        self._player = player
        self._joystick: Joystick | None = None
        if any(name.startswith("joystick-") for name in wanted):
            found = joysticks()
            if not found:
                raise DeviceError(
                    "no joystick was found, but a rating is moved by one",
                    remedy="plug it in, then begin the session again",
                )
            self._joystick = Joystick(found[0])

    def share(self, name: str) -> float | None:
        """Where an axis is, from 0 to 1; None while it is not known."""
        if name in _GRIP:
            tick = self._player.snapshot().leading.tick
            if tick is None:
                return None
            at_m = float(tick["position_m"][_GRIP.index(name)])
            return None if math.isnan(at_m) else 0.5 + 0.5 * at_m / GRIP_TRAVEL_M
        joystick = self._joystick
        return joystick.share(name.partition("-")[2]) if joystick else None

    def close(self) -> None:
        if self._joystick is not None:
            self._joystick.close()
