"""What a front end shows of the player: values, taken when asked for."""

import enum
from dataclasses import dataclass

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.model import LoopStats, SyncStats


class Phase(enum.StrEnum):
    """What the player is doing."""

    EMPTY = "empty"
    PAUSED = "paused"
    BUFFERING = "buffering"
    STARTING = "starting"
    PLAYING = "playing"
    ENDED = "ended"


@dataclass(frozen=True, slots=True)
class Snapshot:
    """What a front end shows; a value, taken when asked for."""

    phase: Phase
    media_s: float
    duration_s: float
    feedback: str
    clock: str
    audio: str
    device: str
    device_health: str
    scheduling: str
    mode: Mode
    cause: Cause
    loop: LoopStats | None
    force_minus_video: SyncStats | None
    force_minus_audio: SyncStats | None
    frames_shown: int
    frames_dropped: int
    frames_damaged: int
    problem: str
