"""The motion of a recording, as every reader hands it over."""

from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.errors import InputError, Message
from hapticplayer.model import ClockMap, ImuLog
from hapticplayer.model.limits import are_gaps


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """The motion of a recording and its clock map.

    Attributes:
        imu: samples on the sensor's own clock.
        clock_map: that clock to media time; confidence 0 if unknown.
        camera: that recorded it.
        notes: format, units, axes and warnings.
        provenance: the same in figures.
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
