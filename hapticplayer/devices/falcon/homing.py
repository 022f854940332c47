"""Finding the encoders' zero with the help of a person, without any force.

The Falcon homes when its grip is pulled out as far as it goes and then pushed in until
it locks. What the counts say before that is only a difference, which is enough to see
what the hand is doing.
"""

import enum
from collections.abc import Iterator
from typing import NamedTuple

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.driver import FalconDriver
from hapticplayer.devices.falcon.protocol import Reply
from hapticplayer.errors import DeviceError

LOOK_S = 0.01
_MOVED_COUNTS = 300  # 1 cm and more
_BACK_COUNTS = 100
_ZERO = (0.0, 0.0, 0.0)


class Advice(enum.Enum):
    """What the person should do next."""

    PULL = "pull the grip out as far as it goes"
    PUSH = "push the grip in until it locks"
    DONE = "homed"


class Guidance(NamedTuple):
    """How far the homing has come.

    Attributes:
        advice: for the person.
        homed: encoders (top, right, lower left) that have found their zero.
        out: mean way of the grip from where it began, counts; outwards is positive.
    """

    advice: Advice
    homed: tuple[bool, bool, bool]
    out: float


class Guide:
    """Looks at replies and knows what to say."""

    def __init__(self) -> None:
        self._start: float | None = None
        self._furthest = 0.0

    def look(self, reply: Reply) -> Guidance:
        """Return what to do after this reply."""
        mean = sum(reply.counts) / 3.0
        if self._start is None:
            self._start = mean
        out = mean - self._start
        self._furthest = max(self._furthest, out)
        bits = reply.homed
        homed = (bool(bits & 1), bool(bits & 2), bool(bits & 4))
        if reply.is_homed:
            return Guidance(Advice.DONE, homed, out)
        was_out = self._furthest > _MOVED_COUNTS
        is_on_its_way_in = out < self._furthest - _BACK_COUNTS
        advice = Advice.PUSH if was_out and is_on_its_way_in else Advice.PULL
        return Guidance(advice, homed, out)


def home(driver: FalconDriver, clock: Clock, limit_s: float) -> Iterator[Guidance]:
    """Yield guidance, 100 times a second, until an open Falcon is homed.

    Raises:
        DeviceError: when it is gone, or not homed after `limit_s`.
    """
    guide, end_s = Guide(), clock.now_s() + limit_s
    while clock.now_s() < end_s:
        driver.exchange(_ZERO, clock.now_s())
        if driver.reply is not None:
            guidance = guide.look(driver.reply)
            yield guidance
            if guidance.advice is Advice.DONE:
                return
        clock.sleep_until(clock.now_s() + LOOK_S)
    raise DeviceError(
        f"the Falcon was not homed within {limit_s:.0f} s; pull the grip all the way "
        "out, push it all the way in until it locks, and try again"
    )
