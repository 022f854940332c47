"""A force that is made while it is felt: in place of a track, the newest value.

The player writes it with the machine's time, each loop reads it at every tick. A value
holds for 100 ms: a source that is silent for longer ramps, and fades in when it is back.
Without numpy: the loop loads this.
"""

import math
import mmap
import struct
from typing import NamedTuple

from hapticplayer.haptics.limiter import ZERO
from hapticplayer.haptics.slots import Slots
from hapticplayer.model.device import Vector

LIVE_VALID_S = 0.100
BLEND_S = 0.005
"""A new value is reached within it: a source of 100 Hz would else be felt as steps."""

_LAYOUT = struct.Struct("<dd3f3f")  # time, blend, force before and after
_SLOTS_AT, _NEWEST_AT = (64, 192), 320
LIVE_BYTES = 328  # the first 8 are zero, where a track has its rows


class _Blend(NamedTuple):
    """A value and the way to it."""

    at_s: float = -math.inf
    over_s: float = BLEND_S
    before_n: Vector = ZERO
    force_n: Vector = ZERO

    def force_at(self, now_s: float) -> Vector:
        """The force at a time of the machine."""
        u = (now_s - self.at_s) / self.over_s
        if u >= 1.0:
            return self.force_n
        u = max(u, 0.0)
        (x, y, z), (tx, ty, tz) = self.before_n, self.force_n
        return (x + u * (tx - x), y + u * (ty - y), z + u * (tz - z))


class LiveTrack:
    """The newest value as the loop reads it, with the interface of a loaded track."""

    end_s = math.inf

    def __init__(self, block: mmap.mmap) -> None:
        self._slots = Slots(block, _LAYOUT, _SLOTS_AT, _NEWEST_AT)
        self._count, self._blend = 0, _Blend()

    def check(self, _count: int) -> bool:
        """Whether all numbers have been checked: `step` checks each value."""
        return True

    def force_at(self, media_s: float) -> Vector:
        """The force, N, frame D; the media clock of a live force is the machine's."""
        return self._newest().force_at(media_s)

    def is_silent(self, now_s: float) -> bool:
        """Whether the newest value is too old to be felt, or not of this time at all."""
        return not abs(now_s - self._newest().at_s) <= LIVE_VALID_S

    def _newest(self) -> _Blend:
        if (count := self._slots.count) != self._count:
            fields = self._slots.read()
            if fields is not None:  # else keep the last good one until it expires
                at_s, over_s, x, y, z, tx, ty, tz = fields
                self._blend = _Blend(at_s, over_s, (x, y, z), (tx, ty, tz))
                self._count = count
        return self._blend


class LiveForce:
    """The newest value as its one writer has it; any thread may be that."""

    def __init__(self) -> None:
        self._blend = _Blend()
        self._shared: dict[str, tuple[Slots, Vector]] = {}

    @property
    def has_begun(self) -> bool:
        """Whether anything was measured yet."""
        return self._blend.at_s > -math.inf

    def write(self, at_s: float, force_n: Vector) -> None:
        """Publish a force that was measured at a time of the machine, all finite."""
        before, over_s = self._blend, min(at_s - self._blend.at_s, BLEND_S)
        if not over_s > 0.0:
            return  # not measured after the newest one
        self._blend = _Blend(at_s, over_s, before.force_at(at_s), force_n)
        for slots, scale in tuple(self._shared.values()):
            self._publish(slots, scale)

    def scaled(self, output: str, scale: Vector) -> "ScaledForce":
        """The same force for one output, in place of what it had of it before."""
        return ScaledForce(self, output, scale)

    def attach(self, output: str, scale: Vector, block: mmap.mmap) -> None:
        """Also publish in a block of zeros that a loop reads, from the present value on."""
        slots = Slots(block, _LAYOUT, _SLOTS_AT, _NEWEST_AT)
        if self.has_begun:
            self._publish(slots, scale)
        self._shared[output] = slots, scale

    def _publish(self, slots: Slots, scale: Vector) -> None:
        at_s, over_s, before_n, force_n = self._blend
        (x, y, z), (tx, ty, tz), (sx, sy, sz) = before_n, force_n, scale
        slots.write(at_s, over_s, sx * x, sy * y, sz * z, sx * tx, sy * ty, sz * tz)


class ScaledForce(NamedTuple):
    """A live force for one output; handed over as a track is."""

    whole: LiveForce
    output: str
    scale: Vector

    def attach(self, block: mmap.mmap) -> None:
        """Publish it in a block of LIVE_BYTES zeros."""
        self.whole.attach(self.output, self.scale, block)
