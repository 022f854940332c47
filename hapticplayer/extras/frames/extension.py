"""What frames tell: rotation, synchronisation, mounting, suggested motion."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.capture.frames import FrameFunction
    from hapticplayer.capture.sync.methods import SyncMethod

_HERE = "hapticplayer.extras.frames"
_FUNCTIONS = {
    "watch": "synchronizing:watch",
    "why-broken": "watching:why_broken",
    "is-exact": "watching:is_available",
    "mounting": "synchronizing:mounting_of",
    "lag": "own_clock:with_lag_by_frames",
    "own-clock": "own_clock:clock_by_rotation",
    "turn-rates": "turn_rate:turn_rates",
    "compare": "reading:compared",
    "suggest": "suggesting:suggested",
}


def sync_methods() -> "tuple[SyncMethod, ...]":
    """By the rotation in frames."""
    from hapticplayer.capture.sync.methods import SyncMethod

    text = Message(
        "the camera's rotation in its frames against the gyro; coarse without the extra vision"
    )
    return (
        SyncMethod("frames", text, f"{_HERE}.own_clock:by_frames", Message("Frames")),
    )


def frame_functions() -> "tuple[FrameFunction, ...]":
    """What the core asks of frames."""
    from hapticplayer.capture.frames import FrameFunction

    return tuple(
        FrameFunction(name, f"{_HERE}.{home}") for name, home in _FUNCTIONS.items()
    )
