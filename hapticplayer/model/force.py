"""The force that is to be felt, known in advance."""

import enum
from collections.abc import Mapping as Dict
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model.arrays import Floats, frozen, frozen_times, same_length


class Reconstruction(enum.StrEnum):
    """How the force between two entries of a track is found."""

    HOLD = "hold"
    """Each value from its own time until the next one's (zero-order hold)."""
    LINEAR = "linear"
    """Straight lines between the entries."""


@dataclass(frozen=True, slots=True, eq=False)
class ForceTrack:
    """Force over media time, in frame D (x right, y up, z towards the user).

    Before its first entry a track is zero. A LINEAR track is zero after its last
    entry; a HOLD track holds its last value until the clip ends.

    Attributes:
        time_s: (N,) media time, strictly increasing, N >= 1.
        force_n: (N, 3) float32.
        reconstruction: how to upsample.
        active_s: (K, 2) spans in which the force is not zero, found here.
        provenance: what it was made of.

    Raises:
        InputError: on wrong shapes, values that are not finite, times that do not
            increase, or an empty track.
    """

    time_s: Floats
    force_n: NDArray[np.float32]
    reconstruction: Reconstruction = Reconstruction.LINEAR
    provenance: Dict[str, Any] = field(default_factory=dict)
    active_s: Floats = field(init=False)

    def __post_init__(self) -> None:
        put = object.__setattr__
        put(self, "time_s", frozen_times(self.time_s, "time_s"))
        put(self, "force_n", frozen(self.force_n, (None, 3), "force_n", np.float32))
        same_length(self.time_s, force_n=self.force_n)
        if not len(self.time_s):
            raise InputError("a force track needs at least one row")
        put(self, "active_s", self._find_active())

    def _find_active(self) -> Floats:
        """Return the spans (K, 2) outside which the upsampled force is zero."""
        nonzero = np.any(self.force_n != 0.0, axis=1)
        starts, ends = self.time_s, np.append(self.time_s[1:], self.end_s)
        if self.reconstruction is Reconstruction.LINEAR:
            # a line leaves zero at the entry before and is back at the one after
            busy = nonzero[:-1] | nonzero[1:]
            starts, ends = starts[:-1], ends[:-1]
        else:
            busy = nonzero
        edges = np.flatnonzero(
            np.diff(np.concatenate(([0], busy.astype(np.int8), [0])))
        )
        spans = np.stack([starts[edges[::2]], ends[edges[1::2] - 1]], axis=1)
        spans.setflags(write=False)
        return spans

    @property
    def end_s(self) -> float:
        """Media time from which the track is zero for good."""
        is_line = self.reconstruction is Reconstruction.LINEAR
        return float(self.time_s[-1]) if is_line else float("inf")

    def at(self, media_s: NDArray[np.float64]) -> Floats:
        """Return the force (M, 3) in N at media times (M,).

        The plain version of what the 1 kHz loop does one value at a time; plots,
        statistics and tests use it.
        """
        times = np.atleast_1d(np.asarray(media_s, dtype=np.float64))
        inside = (times >= self.time_s[0]) & (times < self.end_s)
        force = np.zeros((len(times), 3))
        if self.reconstruction is Reconstruction.HOLD:
            rows = np.searchsorted(self.time_s, times[inside], side="right") - 1
            force[inside] = self.force_n[rows]
        elif inside.any():
            # only the entries around: numpy converts all that it is given, each time
            asked = times[inside]
            ends = asked.min(), asked.max()
            first, last = np.searchsorted(self.time_s, ends, side="right")
            rows = slice(first - 1, last + 1)
            for axis in range(3):
                force[inside, axis] = np.interp(
                    asked, self.time_s[rows], self.force_n[rows, axis]
                )
        return force

    @property
    def is_estimated(self) -> bool:
        """Whether it is of a motion that was estimated from the picture."""
        return self.provenance.get("feedback") == "estimated"

    def rms_n(self) -> Floats:
        """Return the RMS of the entries per axis, (3,) in N."""
        squares = np.square(self.force_n, dtype=np.float64)
        return np.asarray(np.sqrt(np.mean(squares, axis=0)))

    def peak_n(self) -> float:
        """Return the largest magnitude of the force vector, N."""
        return float(np.max(np.linalg.norm(self.force_n.astype(np.float64), axis=1)))
