"""What the loop knows of the hand, from the answers of the device."""

import math
from typing import NamedTuple

from hapticplayer.haptics.limiter import ZERO, Limits, is_finite
from hapticplayer.model.device import DeviceReading, Vector

# Nobody's hand is this fast (200 counts of the encoder in a millisecond): such a
# sample is a fault of the transmission.
JUMP_MPS = 5.0
# Further out, in radii of the workspace, no grip can be.
NOWHERE = 5.0
# The damper needs a speed that is quieter than steps of the encoder (30 to 60 um).
SMOOTHING_S = 0.004


class Hand(NamedTuple):
    """The grip as last seen.

    Attributes:
        position_m: frame D, from the centre of the workspace.
        velocity_mps: smoothed over 4 ms.
        replied_s: monotonic time of the newest good answer; -inf before the first.
        fast_samples: good answers in a row faster than the speed limit.
        malformed: bad answers in a row.
        is_homed: whether the position can be trusted.
        buttons: mask of pressed buttons.
        pressed: mask of buttons that went down with this answer.
    """

    position_m: Vector = ZERO
    velocity_mps: Vector = ZERO
    replied_s: float = -math.inf
    fast_samples: int = 0
    malformed: int = 0
    is_homed: bool = False
    buttons: int = 0
    pressed: int = 0


def observe(hand: Hand, reading: DeviceReading | None, limits: Limits) -> Hand:
    """Return what is known after one exchange.

    An answer that repeats the last one (nothing new came) changes nothing; one that
    leaps, or comes from nowhere, counts as malformed and is dropped.
    """
    if reading is None or reading.replied_s <= hand.replied_s:
        bad = reading.malformed if reading is not None else 0
        return hand._replace(pressed=0, malformed=max(bad, hand.malformed))
    if math.hypot(*reading.position_m) > NOWHERE * limits.workspace_m:
        return hand._replace(pressed=0, malformed=hand.malformed + 1)
    velocity, speed_mps = ZERO, 0.0
    if hand.replied_s > -math.inf:
        elapsed_s = reading.replied_s - hand.replied_s
        raw = _velocity(hand.position_m, reading.position_m, elapsed_s)
        speed_mps = math.hypot(*raw)
        if speed_mps > JUMP_MPS:
            return hand._replace(pressed=0, malformed=hand.malformed + 1)
        velocity = _smoothed(hand.velocity_mps, raw, elapsed_s)
    is_fast = speed_mps > limits.speed_mps
    return Hand(
        reading.position_m,
        velocity,
        reading.replied_s,
        hand.fast_samples + 1 if is_fast else 0,
        reading.malformed,
        reading.is_homed,
        reading.buttons,
        reading.buttons & ~hand.buttons,
    )


def _velocity(from_m: Vector, to_m: Vector, elapsed_s: float) -> Vector:
    return (
        (to_m[0] - from_m[0]) / elapsed_s,
        (to_m[1] - from_m[1]) / elapsed_s,
        (to_m[2] - from_m[2]) / elapsed_s,
    )


def _smoothed(old: Vector, new: Vector, elapsed_s: float) -> Vector:
    if not is_finite(new):
        return ZERO  # the position itself is looked at by the contract
    share = min(1.0, elapsed_s / SMOOTHING_S)
    return (
        old[0] + share * (new[0] - old[0]),
        old[1] + share * (new[1] - old[1]),
        old[2] + share * (new[2] - old[2]),
    )
