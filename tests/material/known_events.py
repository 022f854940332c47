"""The events that a simulated ride is known to hold, and a comparison with found ones.

Impacts and saturation are known from how the ride was made; braking, turns and stillness
from its exact motion. What is near a detector's limit is not `clear`: it may be found.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d
from scipy.signal import butter, sosfiltfilt

from hapticplayer.extras.events.detectors import BRAKING_MPS2, TURN_MPS2
from hapticplayer.extras.rides.scenes import Scene
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.events import Event

_RATE_HZ = 200.0
_BELOW_HZ = 2.0
_CLEAR, _PERHAPS = 1.15, 0.85
_LEAST_S = {True: 0.6, False: 0.3}
_LEAST_CHANGE_MPS = {True: 2.0, False: 1.0}
_TRAVELS_MPS = 1.0
_STILL_MPS2, _STILL_S = {True: 0.05, False: 0.35}, {True: 1.5, False: 0.75}
_STILL_RADPS = 0.01  # at rest; who holds a camera turns more, and feels nothing of it
_JOLT_MPS2 = 2.0 * STANDARD_GRAVITY_MPS2
_NEAR_S = 0.15
_TAP_S = 0.1
_REAR_WHEEL = 0.6  # strength; it follows the front one closely


@dataclass(frozen=True, slots=True)
class KnownEvent:
    """An event that happens; it has to be found where it is clear."""

    kind: str
    start_s: float
    end_s: float
    is_clear: bool = True


def known_events(trajectory: Trajectory, duration_s: float) -> list[KnownEvent]:
    """Return impacts, braking, turns and stillness of a ride."""
    time_s = np.arange(round(duration_s * _RATE_HZ)) / _RATE_HZ
    ahead, aside, speed = _manoeuvres(trajectory, time_s)
    found = [
        KnownEvent("impact", begin, end)
        for begin, end in trajectory.impacts_s
        if 0.0 <= begin < duration_s
    ]
    truth = trajectory.at(time_s)
    size = np.linalg.norm(truth.acceleration_mps2, axis=1)
    found += [
        _known("impact", first, last, False) for first, last in _runs(size > _JOLT_MPS2)
    ]
    shaking = _rms_over_a_second(truth.acceleration_mps2)
    turning = _rms_over_a_second(truth.angular_rate_radps)
    for is_clear in (True, False):
        factor = _CLEAR if is_clear else _PERHAPS
        for kind, level, limit in (
            ("braking", -ahead, BRAKING_MPS2),
            ("turn", aside, TURN_MPS2),
            ("turn", -aside, TURN_MPS2),
        ):
            for first, last in _runs((level > factor * limit) & (speed > _TRAVELS_MPS)):
                change = float(level[first:last].sum()) / _RATE_HZ
                is_long = last - first >= _LEAST_S[is_clear] * _RATE_HZ
                if is_long and change >= _LEAST_CHANGE_MPS[is_clear]:
                    found.append(_known(kind, first, last, is_clear))
        found += [
            _known("stillness", first, last, is_clear)
            for first, last in _runs(
                (shaking < _STILL_MPS2[is_clear])
                & (turning < (_STILL_RADPS if is_clear else np.inf))
            )
            if last - first >= _STILL_S[is_clear] * _RATE_HZ
        ]
    return found


def known_taps(scene: Scene) -> list[KnownEvent]:
    """Return the impacts of a scene that its trajectory does not name."""
    taps = [KnownEvent("impact", one.time_s, one.time_s + _TAP_S) for one in scene.pats]
    hits = [
        KnownEvent("impact", at_s, at_s + _TAP_S, strength > _REAR_WHEEL)
        for at_s, strength in scene.wheel_hits
    ]
    return taps + hits


def spans_of(kind: str, mask: NDArray[np.bool_], time_s: Floats) -> list[KnownEvent]:
    """Return the runs of samples (N,) as events, those within 0.25 s as one."""
    found: list[KnownEvent] = []
    for first, last in _runs(mask):
        begin_s, end_s = float(time_s[first]), float(time_s[last - 1])
        if found and begin_s - found[-1].end_s < 0.25:
            begin_s = found.pop().start_s
        found.append(KnownEvent(kind, begin_s, end_s))
    return found


@dataclass(frozen=True, slots=True)
class Score:
    """Counts of one kind; found ones of events that are not clear count as right."""

    found: int
    right: int
    known: int
    hit: int

    def plus(self, other: "Score") -> "Score":
        """Return both together."""
        return Score(
            self.found + other.found,
            self.right + other.right,
            self.known + other.known,
            self.hit + other.hit,
        )

    @property
    def precision(self) -> float:
        """Share of found events that are right; 1 when nothing was found."""
        return self.right / self.found if self.found else 1.0

    @property
    def recall(self) -> float:
        """Share of clear events that were found; 1 when there are none."""
        return self.hit / self.known if self.known else 1.0


def score(kind: str, found: Iterable[Event], known: Sequence[KnownEvent]) -> Score:
    """Compare found events of a kind with known ones; they match where they overlap."""
    own = [one for one in found if one.kind == kind]
    true = [one for one in known if one.kind == kind]
    clear = [one for one in true if one.is_clear]
    return Score(
        len(own),
        sum(any(_overlap(one, other) for other in true) for one in own),
        len(clear),
        sum(any(_overlap(other, one) for other in own) for one in clear),
    )


def _overlap(one: Event | KnownEvent, other: Event | KnownEvent) -> bool:
    return one.start_s <= other.end_s + _NEAR_S and other.start_s <= one.end_s + _NEAR_S


def _known(kind: str, first: int, last: int, is_clear: bool) -> KnownEvent:
    return KnownEvent(kind, first / _RATE_HZ, (last - 1) / _RATE_HZ, is_clear)


def _manoeuvres(
    trajectory: Trajectory, time_s: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return acceleration along and to the left of the way, and the speed, (N,)."""
    velocity = trajectory.at(time_s).velocity_mps[:, :2]
    low_pass = butter(2, _BELOW_HZ, fs=_RATE_HZ, output="sos")
    velocity = sosfiltfilt(low_pass, velocity, axis=0)
    speed = np.maximum(np.linalg.norm(velocity, axis=1), 1e-3)
    along = velocity / speed[:, None]
    change = np.gradient(velocity, time_s, axis=0)
    ahead = np.einsum("ij,ij->i", change, along)
    aside = along[:, 0] * change[:, 1] - along[:, 1] * change[:, 0]
    return ahead, aside, speed


def _rms_over_a_second(vectors: Floats) -> Floats:
    square = np.square(vectors).sum(axis=1)
    mean = uniform_filter1d(square, round(_RATE_HZ))
    return np.asarray(np.sqrt(np.maximum(mean, 0.0)))


def _runs(mask: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(mask, prepend=False, append=False))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
