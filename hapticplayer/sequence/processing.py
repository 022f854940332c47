"""What is done to a recording's motion: conditioning, gravity removal, low-pass.

The order is the one that loses least: spikes, clipping, averaging, gravity, low-pass.
`motion` is imported only where it is needed: it brings scipy.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ImuLog, MotionTrack

if TYPE_CHECKING:
    from hapticplayer.motion import SmootherParameters

DEFAULT_METHOD = "smoother"
"""That of hapticplayer.motion."""


@dataclass(frozen=True, slots=True)
class Processing:
    """What a person may choose about the motion.

    Attributes:
        method: of gravity removal, see hapticplayer.motion.METHODS.
        time_constant_s: of the smoother's levelling; None derives it from the motion.
        remove_spikes: whether isolated spikes are replaced.
        repair_clipping: whether short clipped peaks are reconstructed.
        average_hz: averages the samples to this rate before gravity is removed.
        lowpass_hz: low-passes what is left, zero phase, -3 dB there.

    Raises:
        UsageError: for a time constant of a method that has none.
    """

    method: str = DEFAULT_METHOD
    time_constant_s: float | None = None
    remove_spikes: bool = False
    repair_clipping: bool = False
    average_hz: float | None = None
    lowpass_hz: float | None = None

    def __post_init__(self) -> None:
        if self.time_constant_s is not None and self.method != "smoother":
            raise UsageError(
                "a time constant can only be set for the method smoother, not for "
                "{method}",
                method=self.method,
            )

    @property
    def parameters(self) -> "SmootherParameters | None":
        """Parameters of the method; None for its defaults."""
        if self.time_constant_s is None:
            return None
        from hapticplayer.motion import SmootherParameters

        return SmootherParameters(time_constant_s=self.time_constant_s)


@dataclass(frozen=True, slots=True, eq=False)
class Processed:
    """A recording's motion without gravity.

    Attributes:
        imu: the log that gravity was removed from, conditioned.
        track: the gravity-free motion at the log's times.
        summary: what gravity removal found; plain numbers, lists and texts.
        conditioning: what else was done, in order, in words.
    """

    imu: ImuLog
    track: MotionTrack
    summary: Mapping[str, Any]
    conditioning: tuple[str, ...]


def process_motion(imu: ImuLog, processing: Processing) -> Processed:
    """Condition a log and remove gravity from it.

    Args:
        imu: as it was recorded.
        processing: what was chosen.

    Raises:
        UsageError: for a method that does not exist.
        InputError: when the log is too short, or a rate or cutoff does not fit it.
    """
    imu, steps = _conditioned(imu, processing)
    from hapticplayer import motion

    done = motion.analyse(imu, processing.method, parameters=processing.parameters)
    track = lowpassed(done.track, processing)
    if processing.lowpass_hz is not None:
        steps.append(
            Message(
                "motion low-passed at {lowpass_hz:g} Hz, zero phase",
                lowpass_hz=processing.lowpass_hz,
            )
        )
    return Processed(imu, track, plain(done.summary), tuple(steps))


def lowpassed(track: MotionTrack, processing: Processing) -> MotionTrack:
    """Return the track low-passed, where that was chosen."""
    if processing.lowpass_hz is None:
        return track
    from hapticplayer.motion.conditioning import lowpass_motion

    return lowpass_motion(track, processing.lowpass_hz)


def _conditioned(imu: ImuLog, processing: Processing) -> tuple[ImuLog, list[str]]:
    steps: list[str] = []
    if processing.remove_spikes:
        from hapticplayer.motion.conditioning import remove_spikes

        imu, spikes = remove_spikes(imu)
        steps.append(str(spikes))
    if processing.repair_clipping:
        from hapticplayer.motion.conditioning import repair_clipping

        imu, clipping = repair_clipping(imu)
        steps.append(Message("clipped peaks: {clipping}", clipping=clipping))
    if processing.average_hz is not None:
        from hapticplayer.motion.conditioning import average

        rate_hz = imu.rate_hz
        imu = average(imu, processing.average_hz)
        steps.append(
            Message(
                "averaged from {rate_hz:.1f} to {average_hz:g} Hz",
                rate_hz=rate_hz,
                average_hz=processing.average_hz,
            )
        )
    return imu, steps


def plain(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return a summary as JSON holds it; a number that is not finite becomes None."""
    return {str(name): _plain(held) for name, held in values.items()}


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return plain(value)
    if isinstance(value, list | tuple | np.ndarray):
        return [_plain(held) for held in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, bool | int | float | None) else str(value)
