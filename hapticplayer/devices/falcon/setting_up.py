"""Bringing a Falcon to where it can be used, for a front end that shows how far it is."""

import enum
import math
from collections.abc import Callable
from typing import NamedTuple

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.homing import LOOK_S, Guidance, home
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import Vector

SILENCE_S = 1.0

_ZERO: Vector = (0.0, 0.0, 0.0)


class Step(enum.Enum):
    """What comes one after the other."""

    CONNECTING = "connecting"
    LOADING = "loading the firmware"
    HOMING = "homing"
    READY = "ready"


class Progress(NamedTuple):
    """How far a Falcon has come.

    `loaded` is the part of the firmware, 0 to 1; the position is in frame D, from the
    middle, once ready.
    """

    step: Step
    loaded: float = 0.0
    guidance: Guidance | None = None
    position_m: Vector = _ZERO
    buttons: int = 0


def set_up(reach: Reach, clock: Clock, show: Callable[[Progress], None]) -> None:
    """Open a Falcon, load its firmware, guide its homing, then show its grip.

    The device exerts no force. It continues until `show`, which is called 100 times a
    second (less while the device is being opened), raises Cancelled.
    """
    driver = reach.driver(clock)
    show(Progress(Step.CONNECTING))
    driver.open(lambda part: show(Progress(Step.LOADING, part)))
    try:
        while True:
            for guidance in home(driver, clock, math.inf):
                show(Progress(Step.HOMING, 1.0, guidance))
            _follow(driver, clock, show)
    finally:
        driver.close()


def _follow(
    driver: FalconDriver, clock: Clock, show: Callable[[Progress], None]
) -> None:
    """Show the grip for as long as the Falcon knows where it is."""
    while (reading := driver.exchange(_ZERO, clock.now_s())).is_homed:
        if clock.now_s() - reading.replied_s > SILENCE_S:
            raise DeviceError(
                "the Falcon does not answer any more; unplug its power and USB, and "
                "plug both in"
            )
        show(Progress(Step.READY, 1.0, None, reading.position_m, reading.buttons))
        clock.sleep_until(clock.now_s() + LOOK_S)
