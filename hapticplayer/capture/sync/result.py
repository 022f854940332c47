"""The inputs and the result of a synchronisation, with its evidence."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.capture.recording import OtherPlace
from hapticplayer.errors import Message
from hapticplayer.model import ClockMap, ImuLog

if TYPE_CHECKING:
    from hapticplayer.capture.frames import FrameRotation

SOUND_RATE_HZ = 16_000

ENOUGH_CONFIDENCE = 0.5
"""Below it a person has to check the result."""


CLEAR_RATIO = 1.2
"""Of the two best mountings; below it a person has to choose."""


COARSE = "vectors"
"""Kind of features (`capture.frames.FeatureKind`) that need no OpenCV."""

COARSE_NOTE = Message(
    "The frames were compared by the motion vectors of the codec, which is coarse; with "
    "hapticplayer[vision] installed they are followed more exactly, those of H.265 too."
)


@dataclass(frozen=True, slots=True, eq=False)
class ClipSound:
    """The sound of a clip, mono, from media time 0.

    Attributes:
        samples: (n,) float32.
        rate_hz: of the samples.
        late_s: how much later than its frame the camera's sound comes.
    """

    samples: NDArray[np.floating]
    rate_hz: float = SOUND_RATE_HZ
    late_s: float = 0.0


class SyncInput(NamedTuple):
    """The inputs of a method.

    Attributes:
        imu: the log, on its own clock.
        hear: reads the clip's sound; raises InputError where there is none.
        given: clock map given by a person.
        own: clock map known to the recording.
        look: tells the camera's rotation from the clip's frames; raises InputError
            where that is not possible. None without a clip.
        lag: of the recording's own clock, as far as it is known.
        contradiction: why the own clock cannot be believed by itself; "" if it can.
        others: places by other sources than the own clock.
        near_s: how far from the own clock the truth may be, for taps and for frames that
            fit several places; None: anywhere.
    """

    imu: ImuLog
    hear: Callable[[], ClipSound]
    given: ClockMap | None = None
    own: ClockMap | None = None
    look: "Callable[[], FrameRotation] | None" = None
    lag: ClockLag | None = None
    contradiction: Message | str = ""
    others: tuple[OtherPlace, ...] = ()
    near_s: float | None = None


@dataclass(frozen=True, slots=True)
class Pat:
    """One pat in both streams.

    Attributes:
        heard_s: media time of its onset in the sound.
        felt_s: log time of its strongest sample.
        heard_rarity_hz: events per second in the sound that are at least as strong.
        felt_rarity_hz: the same in the log.
    """

    heard_s: float
    felt_s: float
    heard_rarity_hz: float
    felt_rarity_hz: float


@dataclass(frozen=True, slots=True)
class Rival:
    """An alternative shift and its evidence (log likelihood ratio)."""

    shift_s: float
    evidence: float


@dataclass(frozen=True, slots=True)
class FrameEvidence:
    """How well the rotation from frames fits that of the gyro.

    Attributes:
        middle_s: media time of the middle of what was compared.
        explained: share of the frames' rotation that the gyro explains.
        margin: unexplained share of the best alternative shift over that of this one.
        second_axis: correlation about the axis with the second-most rotation.
        telling_s: length of all windows of 4 s that know the shift to 6 ms.
        spread_s: RMS of the windows about the line.
        read_out_s: from the first row of a frame to the last one, estimated.
        read_out_sigma_s: SD of its error.
        kind: of the features that were compared.
        doubt: why it is uncertain, for people; empty where it is not.
    """

    middle_s: float
    explained: float
    margin: float
    second_axis: float
    telling_s: float
    spread_s: float
    read_out_s: float
    read_out_sigma_s: float
    kind: str = "corners"
    doubt: Message | str = ""

    @property
    def is_coarse(self) -> bool:
        """Whether OpenCV would have followed the frames more exactly."""
        return self.kind == COARSE

    def described(self) -> dict[str, float | str]:
        """Return it as plain values."""
        values = {name: getattr(self, name) for name in self.__dataclass_fields__}
        return {
            name: one if isinstance(one, str) else round(one, 6)
            for name, one in values.items()
        }


@dataclass(frozen=True, slots=True)
class FoundMounting:
    """Which of the 24 mountings a log has to the camera, as the frames tell.

    Attributes:
        axes: right, front and up of the camera in the log's axes.
        ratio: unexplained rotation of the next best over that of the best.
        next_best: its axes.
    """

    axes: str
    ratio: float
    next_best: str

    @property
    def is_clear(self) -> bool:
        """Whether it can be used without being asked for."""
        return self.ratio >= CLEAR_RATIO

    def described(self) -> dict[str, Any]:
        """Return it as plain values."""
        ratio = round(self.ratio, 3)
        return {"axes": self.axes, "ratio": ratio, "next_best": self.next_best}


@dataclass(frozen=True, slots=True)
class Synchronisation:
    """The clock map of a log to a clip, and its evidence.

    Attributes:
        clock_map: log time to media time, with residual and confidence.
        method: name of the method.
        evidence: log likelihood ratio against chance; 0 for methods without one.
        margin: evidence over that of the best alternative.
        pats: that it is based on.
        rivals: alternative shifts, best first.
        has_drift: whether the clock rate was estimated.
        sound_late_s: skew of the camera, subtracted: how much later than its frames its
            sound comes.
        offset_sigma_s: SD of the error at the middle of what was compared; 0 if unknown.
        drift_sigma_ppm: SD of the error of the clock rate; 0 if unknown.
        frames: result of the frames.
        mounting: which mounting they tell.
        second: what another method found, which agrees, or does not.
        unused: why another method found nothing.
        lag: of the camera's own motion, if its clock is used.
        contradiction: why the recording's own clock was not believed by itself.
        others: places by other sources, where that remains undecided.
        middle_s: of the clip, at which the printed offset holds.
        seen: what the frames tell of the gyro's axes and unit.
        is_seen_otherwise: whether that speaks against the offset or the log.
    """

    clock_map: ClockMap
    method: str
    evidence: float = 0.0
    margin: float = 0.0
    pats: tuple[Pat, ...] = ()
    rivals: tuple[Rival, ...] = ()
    has_drift: bool = False
    sound_late_s: float = 0.0
    offset_sigma_s: float = 0.0
    drift_sigma_ppm: float = 0.0
    frames: FrameEvidence | None = None
    mounting: FoundMounting | None = None
    second: "Synchronisation | None" = None
    unused: Message | str = ""
    lag: ClockLag | None = None
    contradiction: Message | str = ""
    others: tuple[OtherPlace, ...] = ()
    middle_s: float = 0.0
    seen: Message | str = ""
    is_seen_otherwise: bool = False

    @property
    def offset_s(self) -> float:
        """Media less log time in the middle of the clip, as people give it."""
        return self.clock_map.offset_at(self.middle_s)

    @property
    def is_confident(self) -> bool:
        """Whether it can be used without being checked."""
        return self.clock_map.confidence >= ENOUGH_CONFIDENCE

    @property
    def is_torn(self) -> bool:
        """Whether another method is sure of another offset."""
        is_other_sure = self.second is not None and self.second.is_confident
        return is_other_sure and not self.is_confident

    @property
    def is_coarse(self) -> bool:
        """Whether frames count in it that were compared coarsely."""
        own = self.frames is not None and self.frames.is_coarse
        return own or (self.second is not None and self.second.is_coarse)

    @property
    def is_measured(self) -> bool:
        """Whether its method has a confidence of its own."""
        return self.method in ("pats", "frames")

    def media_s(self, log_s: float) -> float:
        """Return the media time of a time of the log."""
        return self.clock_map.rate * log_s + self.clock_map.offset_s

    @property
    def drift_ppm(self) -> float:
        """Clock rate minus 1, in ppm."""
        return 1e6 * (self.clock_map.rate - 1.0)

    def described(self) -> dict[str, Any]:
        """Return it as plain numbers, lists and texts."""
        clock = self.clock_map
        return {
            "method": self.method,
            "offset_s": round(self.offset_s, 6),
            "drift_ppm": round(self.drift_ppm, 3),
            "drift_is_fitted": self.has_drift,
            "residual_s": round(clock.residual_s, 6),
            "confidence": round(clock.confidence, 4),
            "is_confident": self.is_confident,
            "evidence": round(self.evidence, 2),
            "margin": round(self.margin, 2),
            "sound_late_s": self.sound_late_s,
            "offset_sigma_s": round(self.offset_sigma_s, 6),
            "drift_sigma_ppm": round(self.drift_sigma_ppm, 2),
            "frames": self.frames.described() if self.frames else None,
            "mounting": self.mounting.described() if self.mounting else None,
            "second": self.second.described() if self.second else None,
            "lag": self.lag.described() if self.lag else None,
            "contradiction": str(self.contradiction) or None,
            "seen": str(self.seen) or None,
            "pats": [
                {
                    "heard_s": round(pat.heard_s, 4),
                    "felt_s": round(pat.felt_s, 4),
                    "heard_rarity_hz": round(pat.heard_rarity_hz, 4),
                    "felt_rarity_hz": round(pat.felt_rarity_hz, 4),
                }
                for pat in self.pats
            ],
            "rivals": [
                {
                    "shift_s": round(rival.shift_s, 4),
                    "evidence": round(rival.evidence, 2),
                }
                for rival in self.rivals
            ],
        }
