"""What is done to a recording's motion: conditioning, gravity removal, low-pass.

The order is the one that loses least: spikes, clipping, averaging, gravity, low-pass.
`motion` is imported only where it is needed: a cached result needs none of scipy.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hapticplayer.errors import UsageError
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.sequence.motion_cache import MotionCache, plain

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
                "a time constant can only be set for the method smoother, "
                f"not for {self.method}"
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
        is_cached: whether the result was known already.
    """

    imu: ImuLog
    track: MotionTrack
    summary: Mapping[str, Any]
    conditioning: tuple[str, ...]
    is_cached: bool = False


def process_motion(
    imu: ImuLog, processing: Processing, cache: MotionCache | None = None
) -> Processed:
    """Condition a log and remove gravity from it.

    Args:
        imu: as it was recorded.
        processing: what was chosen.
        cache: of earlier results; None for none.

    Raises:
        UsageError: for a method that does not exist.
        InputError: when the log is too short, or a rate or cutoff does not fit it.
    """
    imu, steps = _conditioned(imu, processing)
    track, summary, is_cached = _without_gravity(imu, processing, cache)
    track = lowpassed(track, processing)
    if processing.lowpass_hz is not None:
        steps.append(f"motion low-passed at {processing.lowpass_hz:g} Hz, zero phase")
    return Processed(imu, track, summary, tuple(steps), is_cached)


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
        steps.append(f"clipped peaks: {clipping}")
    if processing.average_hz is not None:
        from hapticplayer.motion.conditioning import average

        rate_hz = imu.rate_hz
        imu = average(imu, processing.average_hz)
        steps.append(f"averaged from {rate_hz:.1f} to {processing.average_hz:g} Hz")
    return imu, steps


def _without_gravity(
    imu: ImuLog, processing: Processing, cache: MotionCache | None
) -> tuple[MotionTrack, dict[str, Any], bool]:
    method, parameters = processing.method, processing.parameters
    key = cache.key(imu, method, parameters) if cache else ""
    known = cache.load(key, imu) if cache else None
    if known is not None:
        return *known, True
    from hapticplayer import motion

    done = motion.analyse(imu, method, parameters=parameters)
    summary = plain(done.summary)
    if cache:
        cache.store(key, done.track, summary)
    return done.track, summary, False
