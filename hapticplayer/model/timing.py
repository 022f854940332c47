"""Maps between the clocks of a recording, of the media and of the machine."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from hapticplayer.errors import InputError, Message

TIME = "time_s"
"""The column of our own tables; a reader of others puts their names in its place."""

_UNIT_REMEDIES = (
    (1e3, Message("it looks like milliseconds: divide {scale} by 1000", scale=TIME)),
    (1e6, Message("it looks like microseconds: divide {scale} by 1000000", scale=TIME)),
    (
        1e9,
        Message("it looks like nanoseconds: divide {scale} by 1000000000", scale=TIME),
    ),
)


def time_unit_remedy(fits: Callable[[float], bool]) -> Message | None:
    """The remedy for times that are not in seconds; None for no known unit.

    Args:
        fits: whether the times are plausible with so many of their unit in a second.
    """
    return next((remedy for per_s, remedy in _UNIT_REMEDIES if fits(per_s)), None)


_MAX_OFFSET_S, _MAX_RATE = 1e12, 1e6
"""Beyond any clock, and any time lapse."""


@dataclass(frozen=True, slots=True)
class ClockMap:
    """t_media = rate * t_imu + offset.

    Attributes:
        offset_s: media time of the IMU's time zero.
        rate: seconds of media per second of the IMU's clock.
        residual_s: RMS of what the line leaves, where it was fitted.
        confidence: 0 to 1; 1 where the clocks are the same by construction.
    """

    offset_s: float = 0.0
    rate: float = 1.0
    residual_s: float = 0.0
    confidence: float = 1.0

    def __post_init__(self) -> None:
        is_far = not abs(self.offset_s) <= _MAX_OFFSET_S
        if is_far or not 0.0 < self.rate <= _MAX_RATE:
            raise InputError(
                "offset {offset_s} s with rate {rate} is not a valid clock map; give finite "
                "numbers and a positive rate",
                offset_s=self.offset_s,
                rate=self.rate,
            )

    @classmethod
    def at(cls, media_s: float, offset_s: float, rate: float = 1.0) -> "ClockMap":
        """The clock with an offset (media less IMU time) that holds at a media time.

        At the IMU's zero, which may be years away, a rate would count for hours.
        """
        return cls(media_s - rate * (media_s - offset_s), rate)

    def offset_at(self, media_s: float) -> float:
        """Media less IMU time, at a media time."""
        return media_s - (media_s - self.offset_s) / self.rate


@dataclass(frozen=True, slots=True)
class PlaybackClock:
    """Media time as a line over the monotonic clock, valid for a while.

    Attributes:
        epoch: grows with every seek or change of speed.
        monotonic0_s: monotonic time of `media0_s`; may lie ahead (start pending).
        media0_s: media position at `monotonic0_s`.
        rate: media seconds per second; 0 while paused.
        valid_until_s: monotonic time after which it is invalid.
    """

    epoch: int
    monotonic0_s: float
    media0_s: float
    rate: float
    valid_until_s: float

    def media_s(self, monotonic_s: float) -> float:
        """Return the media position; before the start it stands at `media0_s`."""
        elapsed_s = monotonic_s - self.monotonic0_s
        return self.media0_s + self.rate * elapsed_s if elapsed_s > 0 else self.media0_s

    def monotonic_s(self, media_s: float) -> float:
        """Return when `media_s` is due; infinity while paused."""
        if self.rate == 0.0:
            return math.inf
        return self.monotonic0_s + (media_s - self.media0_s) / self.rate

    def ahead(self, latency_s: float) -> "PlaybackClock":
        """Return the clock of an output whose doing is met so much later."""
        if not latency_s:
            return self
        return replace(self, monotonic0_s=self.monotonic0_s - latency_s)

    def is_running(self, monotonic_s: float) -> bool:
        """Whether the media moves at this time and the clock may be trusted."""
        return (
            self.rate > 0.0 and self.monotonic0_s <= monotonic_s <= self.valid_until_s
        )
