"""What a front end shows of the player: frozen values."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices import NO_DEVICE
from hapticplayer.devices.options import with_gain
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import LoopStats, SyncStats
from hapticplayer.model.device import ChannelLevel
from hapticplayer.playback.latency import Latency, LatencySource
from hapticplayer.playback.phases import PLAYING_PHASES, Phase
from hapticplayer.playback.source import Source


@dataclass(frozen=True, slots=True, eq=False)
class OutputSnapshot:
    """An output as front ends show it; without arguments: no device.

    Attributes:
        name: as it was chosen, with its settings; "none" without a device.
        health: of its processes.
        problem: what is wrong with it, "" for nothing.
        note: what a person may want to do about it, "" for nothing.
        feedback: the condition that it plays, "" for none.
        is_muted: whether a person has silenced it.
        gain: multiplies what it plays.
        latency_s: compensated.
        latency_source: how that is known.
        mode: what its loop does, and why.
        cause: of the mode.
        tick: the newest, see `TICK`; None before the first, and of a rig.
        loop_pid: of its process, None where there is none.
        levels: of the channels of a sound card, empty for other devices.
        takes_faults: whether they can be injected.
        scheduling: class of its loop, "" before it runs.
        record_problem: why the recording of its ticks is incomplete.
        fault: what kept it from playing though it is still there, "" for nothing.
        is_unheard: whether nobody listens to what it sends.
    """

    name: str = NO_DEVICE
    health: Health = Health.NONE
    problem: str = ""
    note: str = ""
    feedback: str = ""
    is_muted: bool = False
    gain: float = 1.0
    latency_s: float = 0.0
    latency_source: LatencySource = LatencySource.ASSUMED
    mode: Mode = Mode.IDLE
    cause: Cause = Cause.NONE
    tick: Any = None
    loop_pid: int | None = None
    levels: tuple[ChannelLevel, ...] = ()
    takes_faults: bool = False
    scheduling: str = ""
    record_problem: str = ""
    fault: str = ""
    is_unheard: bool = False

    @property
    def device(self) -> str:
        """Its name, with its gain: for others that open the same device."""
        return with_gain(self.name, self.gain)


NO_OUTPUT = OutputSnapshot()


@dataclass(frozen=True, slots=True, eq=False)
class Snapshot:
    """The player's state; without arguments: no clip and no device."""

    phase: Phase = Phase.EMPTY
    source: Source | None = None
    media_s: float = 0.0
    end_s: float = 0.0  # where the clip stops
    # begin and end of the part that is repeated, None without one
    loop_s: tuple[float, float] | None = None
    speed: float = 1.0  # media seconds per second
    epoch: int = 0  # of the playback clock; a new one interrupts the force
    feedback: str = ""
    clock: str = "monotonic"  # what leads, "audio" or "monotonic"
    audio: str = ""  # sound output, "lost" when it has gone, "" for none
    sound_output: str = ""  # name of the output that plays, "" for none
    # what the sound output says of itself; 0 before it does
    reported_latency_s: float = 0.0
    latency: Latency = field(default_factory=Latency)  # what is compensated
    is_stopped: bool = False  # the latch: no force until a person re-arms
    frames_shown: int = 0
    frames_dropped: int = 0
    frames_damaged: int = 0
    problem: str = ""  # what is wrong with the clip, "" for nothing
    notices: tuple[str, ...] = ()
    log_problem: str = ""  # why the log is incomplete, once it is closed
    outputs: tuple[OutputSnapshot, ...] = ()  # the first one leads

    @property
    def leading(self) -> OutputSnapshot:
        """The output whose position is shown and whose buttons count."""
        return self.outputs[0] if self.outputs else NO_OUTPUT

    @property
    def duration_s(self) -> float:
        return self.source.clip.duration_s if self.source else 0.0

    @property
    def is_playing(self) -> bool:
        return self.phase in PLAYING_PHASES


@dataclass(frozen=True, slots=True)
class Measurements:
    """Lateness and synchronisation.

    Attributes:
        loop: of the last 10 s.
        force_minus_video: how much later than its frame the force came, the last
            600 events.
        force_minus_audio: the same for the sound.
        force_minus_video_total, force_minus_audio_total: since `restart_meters`.
        ticks_lost: that were overwritten before they were read.
        audio_underrun_s: silence in place of sound that was not there in time.
    """

    loop: LoopStats | None = None
    force_minus_video: SyncStats | None = None
    force_minus_audio: SyncStats | None = None
    force_minus_video_total: SyncStats | None = None
    force_minus_audio_total: SyncStats | None = None
    ticks_lost: int = 0
    audio_underrun_s: float = 0.0


TicksSince = Callable[[float], NDArray[Any]]
"""`Player.ticks_since`."""


class SyncTraces(NamedTuple):
    """Rows of (monotonic s, ms by which the force came later), oldest first, (n, 2).

    The figures are those of `Measurements`.
    """

    video: NDArray[np.float64]
    audio: NDArray[np.float64]
    force_minus_video: SyncStats | None
    force_minus_audio: SyncStats | None
