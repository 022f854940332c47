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
WAY_COUNTS = 2400
"""From the inner end to the outer one, about."""
_MOVED_COUNTS = 300  # 1 cm and more
_BACK_COUNTS = 100
_FROM_OUTSIDE_COUNTS = 1500  # who comes in so far has been at the outer end
_STILL_COUNTS = 15
_AT_THE_END_LOOKS = 60  # a hand that rests there for so long waits for advice
_IN_VAIN_LOOKS = 300
_ZERO = (0.0, 0.0, 0.0)


class Advice(enum.Enum):
    """What the person should do next."""

    PULL = "pull the grip out as far as it goes"
    PUSH = "push the grip in until it locks"
    DONE = "homed"


class Guidance(NamedTuple):
    """How far the homing has come."""

    advice: Advice  # for the person
    # encoders (top, right, lower left) that have found their zero
    homed: tuple[bool, bool, bool]
    out: float  # mean way of the grip from where it began, counts; outwards is positive
    legs: tuple[int, int, int] = (0, 0, 0)  # the same for each encoder


class HomingGuide:
    """Looks at replies, every 10 ms, and knows what to say."""

    def __init__(self) -> None:
        self._start: tuple[int, int, int] | None = None
        self._advice = Advice.PULL
        self._from = self._highest = self._rests_at = 0.0
        self._still_looks = 0

    def look(self, reply: Reply) -> Guidance:
        """The next step after this reply."""
        start = self._start = self._start or reply.counts
        i, j, k = (now - then for now, then in zip(reply.counts, start, strict=True))
        out, bits = (i + j + k) / 3.0, reply.homed
        self._advice = Advice.DONE if reply.is_homed else self._next_advice(out)
        homed = (bool(bits & 1), bool(bits & 2), bool(bits & 4))
        return Guidance(self._advice, homed, out, (i, j, k))

    def _next_advice(self, out: float) -> Advice:
        if abs(out - self._rests_at) > _STILL_COUNTS:
            self._rests_at, self._still_looks = out, 0
        self._still_looks += 1
        self._highest = max(self._highest, out)
        in_again = self._highest - out
        if self._advice is Advice.PUSH:
            if in_again < _MOVED_COUNTS or self._still_looks < _IN_VAIN_LOOKS:
                return Advice.PUSH
            self._from = self._highest = out  # it was not far enough: repeat
            return Advice.PULL
        is_turning = in_again > _BACK_COUNTS or self._still_looks > _AT_THE_END_LOOKS
        was_out = self._highest - self._from > _MOVED_COUNTS
        if (was_out and is_turning) or in_again > _FROM_OUTSIDE_COUNTS:
            return Advice.PUSH
        return Advice.PULL


def home(driver: FalconDriver, clock: Clock, limit_s: float) -> Iterator[Guidance]:
    """Yield guidance, 100 times a second, until an open Falcon is homed."""
    guide, end_s = HomingGuide(), clock.now_s() + limit_s
    while clock.now_s() < end_s:
        driver.exchange(_ZERO, clock.now_s())
        if driver.reply is not None:
            guidance = guide.look(driver.reply)
            yield guidance
            if guidance.advice is Advice.DONE:
                return
        clock.sleep_until(clock.now_s() + LOOK_S)
    raise DeviceError(
        "the Falcon was not homed within {limit_s:.0f} s; pull the grip all "
        "the way out, push it all the way in until it locks, and try again",
        limit_s=limit_s,
    )
