"""What the detectors of events look at, and effects that they offer."""

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import LEAST_MISSING_S, MISSING_ROW_STEPS
from hapticplayer.rendering.effects import Effect
from hapticplayer.rendering.effects.values import MAX_EFFECT_S
from hapticplayer.rendering.window_means import dense_motion
from hapticplayer.sequence.events import LEAST_EFFECT_S

GRID_HZ = 200.0
"""Of the even grid on which motion is looked at."""

_LONGEST_S = MAX_EFFECT_S - 10.0  # with room for fades

Flags = NDArray[np.bool_]

LOW_HZ = 1000
"""Samples per second: sound up to 400 Hz is left."""


@dataclass(frozen=True, slots=True, eq=False)
class LowSound:
    """Mono sound from media time 0.

    Attributes:
        samples: (n,) at LOW_HZ; 1 is full scale.
    """

    samples: NDArray[np.float32]

    def band(self, low_hz: float, high_hz: float) -> Floats:
        """The sound (n,) between two frequencies, zero phase."""
        from scipy.signal import butter, sosfiltfilt

        sections = butter(2, (low_hz, high_hz), "band", fs=LOW_HZ, output="sos")
        padding = min(len(self.samples) - 1, LOW_HZ)
        if padding < 1:
            return np.zeros(len(self.samples))
        return np.asarray(sosfiltfilt(sections, self.samples, padlen=padding), float)


def low_sound(samples: NDArray[np.floating], rate_hz: float) -> LowSound:
    """The low part of a sound.

    Args:
        samples: (n,) mono, from media time 0.
        rate_hz: of the samples, LOW_HZ or more.
    """
    from scipy.signal import resample_poly

    ratio = Fraction(LOW_HZ / rate_hz).limit_denominator(1000)
    low = resample_poly(samples, ratio.numerator, ratio.denominator)
    return LowSound(np.asarray(low, np.float32))


def effect_on(
    kind: str, span_s: tuple[float, float], fade_s: float = 0.0, **parameters: float
) -> Effect:
    """An effect on the force with its fades inside a span.

    It begins at 0 at the earliest and has a millisecond at least.
    """
    start_s = max(span_s[0], 0.0)
    least_s, most_s = start_s + LEAST_EFFECT_S, start_s + _LONGEST_S
    end_s = min(max(span_s[1], least_s), most_s)
    fade_s = min(fade_s, 0.5 * (end_s - start_s))
    return Effect(
        kind,
        start_s,
        end_s,
        fade_in_s=fade_s,
        fade_out_s=fade_s,
        parameters=parameters,
    )


def over(
    kind: str, span_s: tuple[float, float], fade_s: float, **parameters: float
) -> Effect:
    """An effect on a span, with the fades outside of it."""
    inside = effect_on(kind, span_s, **parameters)
    before_s = min(fade_s, inside.start_s)
    return replace(
        inside,
        start_s=inside.start_s - before_s,
        end_s=inside.end_s + fade_s,
        fade_in_s=before_s,
        fade_out_s=fade_s,
    )


class EventInputs:
    """What is known of a recording, in the forms that several detectors need."""

    def __init__(
        self, motion: MotionTrack, imu: ImuLog | None, sound: LowSound | None
    ) -> None:
        """Take a motion and its log in media time, and the sound of the clip.

        Args:
            motion: at least two samples.
            imu: the log, at least two samples; None takes its part from the motion.
            sound: or None.
        """
        self.motion = motion
        self.sound = sound
        self.imu = _as_log(motion) if imu is None else imu
        self.is_log_given = imu is not None

    @cached_property
    def grid_s(self) -> Floats:
        """Even times (N,) over the motion."""
        first_s, last_s = self.motion.time_s[0], self.motion.time_s[-1]
        count = int((last_s - first_s) * GRID_HZ) + 1
        return np.asarray(first_s + np.arange(count) / GRID_HZ)

    @cached_property
    def acceleration_mps2(self) -> Floats:
        """Linear acceleration (N, 3) on the grid, in frame A.

        0 where it is not valid; isolated spikes are bridged.
        """
        time_s, acceleration, valid = dense_motion(self.motion)
        known = np.where(valid[:, None], acceleration, 0.0)
        kept = ~self._is_spike(time_s)
        columns = [np.interp(self.grid_s, time_s[kept], axis) for axis in known[kept].T]
        return np.stack(columns, axis=1)

    @cached_property
    def upward_mps2(self) -> Floats:
        """Linear acceleration upwards, (N,) on the grid."""
        up = quat.vertical(self.motion.quaternion_wxyz)
        known = zip(up.T, self.acceleration_mps2.T, strict=True)
        time_s = self.motion.time_s
        parts = [np.interp(self.grid_s, time_s, axis) * a for axis, a in known]
        return np.asarray(np.sum(parts, axis=0))

    @cached_property
    def level(self) -> Floats:
        """Acceleration forwards and to the left (N, 2), level, and yaw rate (N,)."""
        time_s, turned = self.motion.time_s, self.motion.quaternion_wxyz
        front = quat.rotate(turned, np.tile([0.0, 1.0, 0.0], (len(time_s), 1)))
        yaw = np.unwrap(np.arctan2(front[:, 1], front[:, 0]))
        acceleration = quat.rotate(turned, self.motion.acceleration_mps2)
        acceleration[~self.motion.valid] = 0.0
        cosine, sine = np.cos(yaw), np.sin(yaw)
        ahead = cosine * acceleration[:, 0] + sine * acceleration[:, 1]
        left = cosine * acceleration[:, 1] - sine * acceleration[:, 0]
        rate = np.gradient(yaw, time_s)
        columns = [np.interp(self.grid_s, time_s, one) for one in (ahead, left, rate)]
        return np.stack(columns, axis=1)

    def _is_spike(self, time_s: Floats) -> Flags:
        """Return (M,) which times are those of spiky samples of the log."""
        spikes_s = self.imu.time_s[self.spiky]
        half_s = 0.5 * float(np.median(np.diff(self.imu.time_s)))
        first, last = np.searchsorted(spikes_s, [time_s - half_s, time_s + half_s])
        return np.asarray(first < last)

    @cached_property
    def unknown(self) -> Flags:
        """Samples of the log (M,) that were filled in, and those beside a gap."""
        imu = self.imu
        steps_s = np.diff(imu.time_s)
        usual_s = float(np.median(steps_s))
        is_gap = steps_s > max(MISSING_ROW_STEPS * usual_s, usual_s + LEAST_MISSING_S)
        unknown = np.append(is_gap, False) | np.insert(is_gap, 0, False)
        return np.asarray(unknown if imu.valid is None else unknown | ~imu.valid)

    @cached_property
    def spiky(self) -> Flags:
        """Samples of the log (M,) that are isolated spikes."""
        from hapticplayer.motion.conditioning import remove_spikes

        _, spikes = remove_spikes(self.imu)
        return np.asarray((spikes.force | spikes.rate).any(axis=1))


def _as_log(motion: MotionTrack) -> ImuLog:
    """The log of a motion: its specific force, and the rate of its orientation."""
    force = motion.acceleration_mps2 + motion.gravity_mps2
    q = motion.quaternion_wxyz
    steps = quat.multiply(quat.conjugate(q[:-1]), q[1:])
    steps = np.where(steps[:, :1] < 0.0, -steps, steps)
    rate = 2.0 * steps[:, 1:] / np.diff(motion.time_s)[:, None]
    return ImuLog(
        time_s=motion.time_s,
        specific_force_mps2=force / motion.accelerometer_gain,
        angular_rate_radps=np.concatenate([rate[:1], rate]),
        sampling=motion.sampling,
        valid=motion.valid,
    )
