"""Processes a recording's motion: conditioning, gravity removal, low-pass.

The order that loses least is spikes, clipping, averaging, gravity removal, low-pass.
`motion` is imported where it is needed, because it brings scipy.
"""

import dataclasses
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.model.motion import DEFAULT_METHOD

if TYPE_CHECKING:
    from hapticplayer.motion import SmootherParameters
    from hapticplayer.sequence.calibration import StoredCalibration


@dataclass(frozen=True, slots=True)
class Processing:
    """Options of the processing.

    Attributes:
        method: of gravity removal, see hapticplayer.motion.METHODS.
        time_constant_s: of the smoother's levelling; None derives it from the motion.
        remove_spikes: replace isolated outliers.
        repair_clipping: reconstruct short clipped peaks.
        average_hz: average the samples to this rate before gravity removal.
        lowpass_hz: -3 dB of a zero-phase low-pass of the result.
        calibration: of the sensor, in its own axes; the smoother's prior.

    Raises:
        UsageError: for a time constant or calibration with a method that has none.
    """

    method: str = DEFAULT_METHOD
    time_constant_s: float | None = None
    remove_spikes: bool = False
    repair_clipping: bool = False
    average_hz: float | None = None
    lowpass_hz: float | None = None
    calibration: "StoredCalibration | None" = None

    def __post_init__(self) -> None:
        if self.time_constant_s is not None and self.method != "smoother":
            raise UsageError(
                "a time constant is for the method smoother, not for {method}",
                method=self.method,
            )

        if self.calibration is not None and self.method != "smoother":
            raise UsageError(
                "a calibration is for the method smoother, not for {method}",
                method=self.method,
            )

    def mounted(self, axes: str) -> "Processing":
        """Return the options with the calibration in frame A, see `mounted` of that."""
        if self.calibration is None:
            return self
        return dataclasses.replace(self, calibration=self.calibration.mounted(axes))

    def parameters(
        self, elsewhere: SensorCalibration | None = None
    ) -> "SmootherParameters | None":
        """Return parameters of the method; None for its defaults.

        Args:
            elsewhere: what other parts of the log tell of the sensor.
        """
        if self.method != "smoother":
            return None
        known = elsewhere
        if self.calibration is not None:
            known = self.calibration.values.for_another_recording()
            if elsewhere is not None:
                known = known.with_other(elsewhere)
        if self.time_constant_s is None and known is None:
            return None
        from hapticplayer.motion import SmootherParameters

        return SmootherParameters(
            time_constant_s=self.time_constant_s, calibration=known
        )


@dataclass(frozen=True, slots=True, eq=False)
class Processed:
    """A recording's motion without gravity.

    Attributes:
        imu: the log that gravity was removed from, conditioned.
        track: the gravity-free motion at the log's times.
        summary: of gravity removal; plain numbers, lists and texts.
        conditioning: the other steps, in order, in words.
        calibration: of the sensor, in frame A, or None where the method has none.
    """

    imu: ImuLog
    track: MotionTrack
    summary: Mapping[str, Any]
    conditioning: tuple[str, ...]
    calibration: SensorCalibration | None = None

    def part(self, chosen: slice) -> "Processed":
        """Return some of the samples, as estimated from all of them."""
        track = self.track.part(chosen)
        if track is self.track:
            return self
        of_part = {
            "gravity_sigma_mps2": median_of(track.gravity_sigma_mps2),
            "invalid_share": 1.0 - float(np.mean(track.valid)),
        }
        return dataclasses.replace(
            self,
            imu=self.imu.part(chosen),
            track=track,
            summary={**self.summary, **of_part},
        )


def process_motion(
    imu: ImuLog,
    processing: Processing,
    elsewhere: SensorCalibration | None = None,
) -> Processed:
    """Condition a log and remove gravity from it.

    Args:
        imu: as recorded.
        processing: options.
        elsewhere: what other parts of the log tell of the sensor, see `surroundings`.
    """
    imu, steps = _conditioned(imu, processing)
    from hapticplayer import motion

    parameters = processing.parameters(elsewhere)
    done = motion.analyse(imu, processing.method, parameters=parameters)
    track = lowpassed(done.track, processing)
    if processing.lowpass_hz is not None:
        steps.append(
            Message(
                "motion low-passed at {lowpass_hz:g} Hz, zero phase",
                lowpass_hz=processing.lowpass_hz,
            )
        )
    summary = plain(done.summary)
    if processing.calibration is None:  # what was overruled is stillness elsewhere
        summary.pop("calibration_overruled", None)
    return Processed(imu, track, summary, tuple(steps), done.calibration)


def lowpassed(track: MotionTrack, processing: Processing) -> MotionTrack:
    """Return the track low-passed, if chosen."""
    if processing.lowpass_hz is None:
        return track
    from hapticplayer.motion.conditioning import lowpass_motion

    return lowpass_motion(track, processing.lowpass_hz)


def _conditioned(imu: ImuLog, processing: Processing) -> tuple[ImuLog, list[str]]:
    steps: list[str] = []
    if processing.remove_spikes:
        from hapticplayer.motion.conditioning import remove_spikes

        imu, spikes = remove_spikes(imu)
        steps.append(spikes.message)
    if processing.repair_clipping:
        from hapticplayer.motion.conditioning import repair_clipping

        imu, clipping = repair_clipping(imu)
        steps.append(clipping.message)
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


def describe_motion(track: MotionTrack) -> dict[str, Any]:
    """Return RMS and peak of p[k] over the valid samples; None without any."""
    valid = np.flatnonzero(track.valid)
    if not len(valid):
        return {"rms_mps2": None, "peak_mps2": None, "peak_at_s": None}
    p = track.acceleration_mps2
    p = p if len(valid) == len(p) else p[valid]
    square = np.einsum("ij,ij->i", p, p)
    peak = int(np.argmax(square))
    return {
        "rms_mps2": float(np.sqrt(square.mean())),
        "rms_per_axis_mps2": [float(np.sqrt(np.square(axis).mean())) for axis in p.T],
        "peak_mps2": float(np.sqrt(square[peak])),
        "peak_at_s": float(track.time_s[valid[peak]]),
    }


def median_of(values: Floats | None) -> float | None:
    return None if values is None else float(np.median(values))


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
