"""The state of the hand, from the answers of the device."""

import math
from typing import NamedTuple

from hapticplayer.haptics.limiter import ZERO, Limits, is_finite
from hapticplayer.model.device import DeviceReading, Vector

# No hand is this fast (200 encoder counts in a millisecond): such a sample is a
# transmission error.
JUMP_MPS = 5.0
# Further out, in radii of the workspace, no grip can be.
FARTHEST = 5.0
# The damper needs a speed that is quieter than steps of the encoder (30 to 60 um).
SMOOTHING_S = 0.004


class HandState(NamedTuple):
    """The grip as last seen, frame D from the centre of the workspace."""

    position_m: Vector = ZERO
    velocity_mps: Vector = ZERO  # smoothed over 4 ms
    # monotonic time of the newest good answer; -inf before the first
    replied_s: float = -math.inf
    fast_samples: int = 0  # good answers in a row faster than the speed limit
    malformed: int = 0  # bad answers in a row
    is_homed: bool = False  # whether the position can be trusted
    buttons: int = 0
    pressed: int = 0  # mask of buttons that went down with this answer


def observe(
    hand: HandState, reading: DeviceReading | None, limits: Limits
) -> HandState:
    """The knowledge after one exchange.

    A repeated answer changes nothing; one that jumps, or lies far outside the
    workspace, counts as malformed and is dropped.
    """
    if reading is None or reading.replied_s <= hand.replied_s:
        bad = reading.malformed if reading is not None else 0
        return hand._replace(pressed=0, malformed=max(bad, hand.malformed))
    position_m, buttons, is_homed, replied_s, malformed, *_ = reading
    x, y, z = position_m
    if math.hypot(x, y, z) > FARTHEST * limits.workspace_m:
        return hand._replace(pressed=0, malformed=hand.malformed + 1)
    (old_x, old_y, old_z), velocity, last_s, fast_samples, _, _, held, _ = hand
    speed_mps = 0.0
    if last_s > -math.inf:
        elapsed_s = replied_s - last_s
        raw = (
            (x - old_x) / elapsed_s,
            (y - old_y) / elapsed_s,
            (z - old_z) / elapsed_s,
        )
        speed_mps = math.hypot(*raw)
        if speed_mps > JUMP_MPS:
            return hand._replace(pressed=0, malformed=hand.malformed + 1)
        velocity = _smoothed(velocity, raw, elapsed_s)
    else:
        velocity = ZERO
    return HandState(
        position_m,
        velocity,
        replied_s,
        fast_samples + 1 if speed_mps > limits.speed_mps else 0,
        malformed,
        is_homed,
        buttons,
        buttons & ~held,
    )


def _smoothed(old: Vector, new: Vector, elapsed_s: float) -> Vector:
    if not is_finite(new):
        return ZERO  # the contract checks the position itself
    share = elapsed_s / SMOOTHING_S
    if not share < 1.0:
        share = 1.0
    (x, y, z), (new_x, new_y, new_z) = old, new
    return (x + share * (new_x - x), y + share * (new_y - y), z + share * (new_z - z))
