"""What a haptic device can do, and snapshots that a front end polls."""

import enum
import math
from dataclasses import dataclass
from typing import NamedTuple

Vector = tuple[float, float, float]


class Signal(enum.StrEnum):
    """The kind of signal that a device takes."""

    FORCE = "force"
    MOTION = "motion"


@dataclass(frozen=True, slots=True)
class DeviceCapabilities:
    """Limits of a device, SI.

    Attributes:
        axes: number of axes with force, of x, y, z from `first_axis` on.
        peak_force_n: largest force for a short time.
        continuous_force_n: largest force for ever.
        workspace_radius_m: radius of the usable sphere around its centre.
        rate_hz: rate of the exchange.
        latency_s: from command to force, typical.
        signal: a force in newtons, or a `RigMotion`; forces are 0 for the latter.
        first_axis: 0, 1, 2 for x, y, z.
        has_newtons: whether a force of 1 N is 1 N; else it is a share of what the
            device can do.
        has_own_clock: whether it plays what it is sent at stated times, by a clock of
            its own: its driver keeps the latency of its options, and it falls silent by
            itself when its loop stands still.
    """

    axes: int
    peak_force_n: float
    continuous_force_n: float
    workspace_radius_m: float
    rate_hz: float
    latency_s: float
    signal: Signal = Signal.FORCE
    first_axis: int = 0
    has_newtons: bool = True
    has_own_clock: bool = False


MOST_CHANNELS = 8
"""Of a sound card that shakers hang on."""
FLOOR_DB = -80.0


class ChannelLevel(NamedTuple):
    """How loud one channel of a sound card plays; see `devices.transducer.meter`.

    Attributes:
        channel: counted from 1.
        peak: 0 to 1 of full scale, with a slow fall-off.
        is_limited: whether the soft limiter has worked in the last second.
    """

    channel: int
    peak: float
    is_limited: bool

    @property
    def peak_db(self) -> float:
        """The peak in dB of full scale, `FLOOR_DB` for less."""
        return max(FLOOR_DB, 20.0 * math.log10(max(self.peak, 1e-9)))


class DeviceReading(NamedTuple):
    """Answer of a device to one exchange; a tuple because it is made at 1 kHz.

    Attributes:
        position_m: grip position in frame D, from the centre of the workspace.
        buttons: bit mask of pressed grip buttons.
        is_homed: whether the position can be trusted.
        replied_s: monotonic time at which the device gave this answer; it stands
            still while nothing (well-formed) comes back.
        malformed: answers in a row, up to now, that made no sense.
        levels: of the channels of a sound card; the same object until they change.
        notice: what the device has reported last and a person should read, "" for
            nothing.
    """

    position_m: Vector
    buttons: int
    is_homed: bool
    replied_s: float
    malformed: int = 0
    levels: tuple[ChannelLevel, ...] = ()
    notice: str = ""


@dataclass(frozen=True, slots=True)
class LoopStats:
    """Health of the 1 kHz loop over a stated window.

    Attributes:
        ticks: exchanges in the window.
        missed: periods that were skipped.
        lateness_p50_us: wake-up after the deadline, microseconds, and so on.
    """

    ticks: int
    missed: int
    lateness_p50_us: float
    lateness_p99_us: float
    lateness_p999_us: float
    lateness_max_us: float


@dataclass(frozen=True, slots=True)
class SyncStats:
    """Force against video or sound: positive is force later.

    Attributes:
        count: pairs that were compared.
        p50_ms: median difference, milliseconds, and so on.
    """

    count: int
    p05_ms: float
    p50_ms: float
    p95_ms: float
