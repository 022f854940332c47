"""The motion of a recording, as every reader hands it over."""

from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.errors import InputError, Message
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.limits import are_gaps


class OtherPlace(NamedTuple):
    """Where another source places a log: the media time of its time zero, and by what."""

    by: Message
    offset_s: float


class Placing(NamedTuple):
    """What is known of the place of a log in the clip that its clock belongs to.

    Attributes:
        span_s: media time of what the clip has to show, by the log's own clock.
        slack_s: by so much a clip may end before or after it.
        others: places by other sources, which differ by more than a frame.
        is_cut: parts were taken out of it, or its times changed.
    """

    span_s: tuple[float, float]
    slack_s: float
    others: tuple[OtherPlace, ...] = ()
    is_cut: bool = False

    def contradiction(self, duration_s: float) -> Message | None:
        """Why the clock cannot be believed for a clip of a length, or None."""
        if self.others:
            return Message(
                "the times of its packets and the camera's own place the motion {apart_s:.2f} "
                "s apart: the clip was cut",
                apart_s=abs(self.others[0].offset_s),
            )
        if self.is_cut:
            return Message("the clip was cut and joined, or its times were changed")
        first_s, last_s = self.span_s
        if abs(first_s) <= self.slack_s and abs(last_s - duration_s) <= self.slack_s:
            return None
        return Message(
            "what was recorded lasts from {first_s:.2f} to {last_s:.2f} s, the clip from 0 "
            "to {duration_s:.2f} s: it was cut, or plays at another speed",
            first_s=first_s,
            last_s=last_s,
            duration_s=duration_s,
        )


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """The motion of a recording and its clock map.

    Attributes:
        imu: samples on the sensor's own clock.
        clock_map: that clock to media time; confidence 0 if unknown.
        camera: that recorded it.
        notes: format, units, axes and warnings.
        provenance: the same in figures.
        placing: in the clip whose clock it has; None where nothing else tells of it.
        lag: of the motion against the frames of the same camera; None if unknown.
        is_gravity_free: the recorder removed gravity: `imu` holds p[k] itself, without
            angular rate.
    """

    imu: ImuLog
    clock_map: ClockMap
    camera: str
    notes: tuple[str, ...] = ()
    provenance: Dict[str, Any] = field(default_factory=dict)
    lag: ClockLag | None = None
    placing: Placing | None = None
    is_gravity_free: bool = False


def refuse_gravity_free(recording: Recording) -> None:
    """Reject motion from which the recorder has removed gravity.

    Raises:
        InputError: with what to record instead.
    """
    if recording.is_gravity_free:
        raise InputError(
            "holds acceleration from which the recorder has removed gravity, so it "
            "cannot be checked or levelled",
            where=recording.imu.source,
            remedy="export the acceleration with gravity, and the gyroscope",
        )


def find_gaps(imu: ImuLog) -> NDArray[np.intp]:
    """Return the samples (G,) that are followed by a gap."""
    return np.flatnonzero(are_gaps(np.diff(imu.time_s)))


def gap_notes(imu: ImuLog) -> tuple[str, ...]:
    """Return the number and the longest of the gaps, in words."""
    steps_s, wide = np.diff(imu.time_s), find_gaps(imu)
    if not wide.size:
        return ()
    longest = int(wide[np.argmax(steps_s[wide])])
    count = (
        Message("one gap")
        if wide.size == 1
        else Message("{count} gaps", count=wide.size)
    )
    length_s, at_s = steps_s[longest], imu.time_s[longest]
    return (
        Message(
            "The log has {count}, the longest of {length_s:.2f} s at {at_s:.2f} s.",
            count=count,
            length_s=length_s,
            at_s=at_s,
        ),
    )
