"""Predicts the excursion of the hand under a force track, before it is played.

A reduced model of the Falcon and the hand: mass and friction are those at the centre of
the workspace, and there is no latency. Fade, centring, cap and trips are the code of the
loop, called for one hand at a time: a minute of force takes 0.3 s. A hand settles within
a second, so all seconds of a track are computed side by side, each with a run-up. It
agrees with the full physics and the real `step` within 1 % of the workspace for rides,
and within 7 % for full force switched along the device's axis (tests).
"""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import FIRM, NORMAL, RELAXED, Hand, Mechanism
from hapticplayer.devices.falcon.kinematics import FALCON_GEOMETRY, Kinematics
from hapticplayer.errors import Message
from hapticplayer.haptics.centring import Centring, centring_of, kept_inside
from hapticplayer.haptics.contract import is_pushed_outside
from hapticplayer.haptics.hand import HandState
from hapticplayer.haptics.limiter import ZERO, Limits, limit, limits_of
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.device import Vector
from hapticplayer.sequence.description import Description, ExcursionEntry, HandEntry

HANDS = {"relaxed": RELAXED, "normal": NORMAL, "firm": FIRM}
LIMITS = limits_of(FALCON)
FAR = LIMITS.fade_from
"""Share of the workspace beyond which outward force is reduced."""

WARM = 0.8
"""Share of the continuous force above which motor heating is reported."""

RATE_HZ = 500.0
TRAVEL_HZ = 50.0
_SECOND_S, _RUN_UP = 1.0, 600  # samples of 1.2 s
_AFTER_S = 0.5  # the hand keeps moving after the force has ended
_BATCH = 600  # seconds computed at a time
_PROGRESS_STEPS = 100
_HEAT_STEP_S = 0.1
_STICK_MPS = 0.002  # below it dry friction decreases with the speed


class _Response(NamedTuple):
    """What some hands do in some seconds of a track; each (hands, seconds).

    Trip times are infinite where nothing trips.
    """

    reach: Floats
    reach_at_s: Floats
    far_s: Floats
    runaway_s: Floats
    outside_s: Floats


def predict(
    track: ForceTrack,
    duration_s: float,
    progress: Callable[[float], None] = lambda _share: None,
) -> ExcursionEntry:
    """How far a track would move three hands, and the load of the motors.

    Args:
        track: in media time.
        duration_s: of the clip; force outside it is not played.
        progress: called with the done share; may raise to stop the work.
    """
    grip = Grip(list(HANDS.values()), LIMITS, centring_of(LIMITS))
    starts = _starts(track, duration_s)
    parts = [_Response(*np.zeros((5, len(HANDS), 0)))]
    for first in range(0, len(starts), _BATCH):
        batch = starts[first : first + _BATCH]

        def report(share: float, done: int = first, size: int = len(batch)) -> None:
            progress((done + share * size) / len(starts))

        force_n = _planned(track, duration_s, batch)
        parts.append(_respond(grip, force_n, batch, report))
    whole = _Response(
        *(np.concatenate(one, axis=1) for one in zip(*parts, strict=True))
    )
    hands = {
        name: _described(_Response(*(one[row] for one in whole)), duration_s)
        for row, name in enumerate(HANDS)
    }
    rms_n = _hottest_n(track, duration_s)
    share = round(rms_n / LIMITS.continuous_n, 4)
    return ExcursionEntry(hands, FAR, round(rms_n, 4), share)


def travel_m(
    track: ForceTrack, duration_s: float, hand: str = "normal"
) -> tuple[Floats, Floats]:
    """Return where a hand would be over time.

    Args:
        track: in media time.
        duration_s: of the clip; force outside it is not played.
        hand: one of HANDS.

    Returns:
        Times (n,) s, 50 a second, and positions (n, 3) m, frame D; zero where there
        is no force.
    """
    grip = Grip([HANDS[hand]], LIMITS, centring_of(LIMITS))
    starts = _starts(track, duration_s)
    count, every = math.ceil(duration_s * TRAVEL_HZ) + 1, round(RATE_HZ / TRAVEL_HZ)
    place_m = np.zeros((count + round(2 * TRAVEL_HZ), 3))
    for first in range(0, len(starts), _BATCH):
        batch = starts[first : first + _BATCH]
        grip.rest(len(batch))
        for step, force_n in enumerate(_planned(track, duration_s, batch), -_RUN_UP):
            grip.advance(force_n)
            if step >= 0 and step % every == 0:
                rows = (batch + step) // every
                inside = rows < len(place_m)
                place_m[rows[inside]] = grip.place_m[:, 0, inside].T
    return np.arange(count) / TRAVEL_HZ, place_m[:count]


def excursion_texts(prediction: ExcursionEntry) -> list[str]:
    """Return the warnings about a prediction; usually none."""
    texts: list[str] = [
        Message(
            "this track would move a {hand} hand so far that the device trips ({trip}) "
            "at {at_s:.1f} s",
            hand=Message(name),
            trip=one.trip,
            at_s=one.trip_at_s or 0.0,
        )
        for name, one in prediction.hands.items()
        if one.trip is not None
    ]
    relaxed = prediction.hands.get("relaxed")
    if not texts and relaxed and relaxed.reach >= prediction.far:
        texts.append(
            Message(
                "this track would reach {reach:.0f} % of the workspace with a relaxed "
                "hand, at {at_s:.1f} s; beyond {far:.0f} % outward force is reduced",
                reach=100.0 * relaxed.reach,
                at_s=relaxed.reach_at_s,
                far=100.0 * prediction.far,
            )
        )
    if prediction.thermal_share >= WARM:
        texts.append(
            Message(
                "this track loads the motors to {heat:.0f} % of their continuous force; "
                "it may be reduced",
                heat=100.0 * prediction.thermal_share,
            )
        )
    return texts


def stored_texts(description: Description | None, feedback: str) -> list[str]:
    """The warnings about a track that were predicted at import; of a plain clip none."""
    entry = description.feedbacks.get(feedback) if description else None
    return excursion_texts(entry.excursion) if entry and entry.excursion else []


def _described(hand: _Response, duration_s: float) -> HandEntry:
    """The response of one hand (seconds,)."""
    best = int(np.argmax(hand.reach)) if hand.reach.any() else None
    trips = {"runaway": hand.runaway_s, "outside": hand.outside_s}
    firsts = {cause: float(at_s.min(initial=np.inf)) for cause, at_s in trips.items()}
    cause = min(firsts, key=lambda cause: firsts[cause])
    is_trip = firsts[cause] < np.inf
    return HandEntry(
        reach=0.0 if best is None else round(float(hand.reach[best]), 4),
        reach_at_s=0.0 if best is None else round(float(hand.reach_at_s[best]), 3),
        far_share=round(float(hand.far_s.sum()) / max(duration_s, 1e-9), 5),
        trip=cause if is_trip else None,
        trip_at_s=round(firsts[cause], 3) if is_trip else None,
    )


def _respond(
    grip: "Grip",
    force_n: Floats,
    starts: NDArray[np.int64],
    report: Callable[[float], None],
) -> _Response:
    """Compute some seconds side by side, from their first samples on."""
    grip.rest(len(starts))
    shape = (len(HANDS), len(starts))
    found = _Response(*np.zeros((3, *shape)), *np.full((2, *shape), np.inf))
    for step, planned_n in enumerate(force_n, -_RUN_UP):
        if step % _PROGRESS_STEPS == 0:
            report((step + _RUN_UP) / len(force_n))
        at = starts + step
        radius = grip.advance(planned_n)
        if step < 0:
            continue
        at_s = np.broadcast_to(at / RATE_HZ, shape)
        further = radius > found.reach
        np.copyto(found.reach, radius, where=further)
        np.copyto(found.reach_at_s, at_s, where=further)
        found.far_s[radius > FAR] += 1.0 / RATE_HZ
        for trip_s, is_now in (
            (found.runaway_s, grip.is_fast),
            (found.outside_s, grip.is_outside),
        ):
            if is_now.any():
                np.minimum(trip_s, at_s, out=trip_s, where=is_now)
    return found


def _planned(track: ForceTrack, duration_s: float, starts: NDArray[np.int64]) -> Floats:
    """Return the force (steps, 3, seconds) at RATE_HZ in some seconds and run-ups."""
    steps = np.arange(-_RUN_UP, round(_SECOND_S * RATE_HZ))
    time_s = (starts[:, None] + steps).ravel() / RATE_HZ
    entry_s = LIMITS.entry_ticks / FALCON.rate_hz
    force_n = track.at(time_s)
    force_n *= np.clip(time_s / entry_s, 0.0, 1.0)[:, None]
    force_n[time_s >= duration_s] = 0.0
    return force_n.reshape(len(starts), len(steps), 3).transpose(1, 2, 0)


def _starts(track: ForceTrack, duration_s: float) -> NDArray[np.int64]:
    """Return the first samples of the seconds with force."""
    busy = np.zeros(math.ceil((duration_s + _AFTER_S) / _SECOND_S) + 1, dtype=bool)
    for begin_s, end_s in track.active_s:
        if begin_s < duration_s and end_s > 0.0:
            last_s = min(end_s, duration_s) + _AFTER_S
            busy[int(max(0.0, begin_s) / _SECOND_S) : int(last_s / _SECOND_S) + 1] = (
                True
            )
    return np.flatnonzero(busy).astype(np.int64) * round(_SECOND_S * RATE_HZ)


def _hottest_n(track: ForceTrack, duration_s: float) -> float:
    """The highest RMS of the planned force over the motors' time constant."""
    time_s = np.arange(0.0, max(duration_s, _HEAT_STEP_S), 0.01)
    square = np.square(track.at(time_s)).sum(axis=1)
    size = round(_HEAT_STEP_S / 0.01)
    means = square[: len(square) // size * size].reshape(-1, size).mean(axis=1)
    share, heat, hottest = _HEAT_STEP_S / LIMITS.heat_time_s, 0.0, 0.0
    for mean in means.tolist():
        heat += share * (mean - heat)
        hottest = max(hottest, heat)
    return math.sqrt(hottest)


class Grip:
    """Several hands at several moments: point masses on springs and dampers.

    Arrays are (3 axes, hands, moments).

    Attributes:
        cap_n: force cap, a number or (hands, moments); a warm device has a lower one.
        sent_n: what `haptics.step` has sent in the last step.

    Args:
        hands: one row each.
        limits: of force, position and speed.
        centring: spring and look-ahead.
    """

    def __init__(
        self, hands: Sequence[Hand], limits: Limits, centring: Centring
    ) -> None:
        self._limits, self._centring = limits, centring
        mass, viscous, self._dry_n = mechanism_at_grip(Mechanism())
        self._step_per_kg = (1.0 / RATE_HZ) / np.stack(
            [mass + hand.mass_kg for hand in hands], axis=1
        )[:, :, None]
        self._viscous = np.stack(
            [viscous + hand.damping_n_s_per_m for hand in hands], axis=1
        )[:, :, None]
        self._stiffness = np.array([hand.stiffness_n_per_m for hand in hands])[:, None]
        self._give, self._back = (
            -np.expm1([[-1.0 / (RATE_HZ * time_s)] for time_s in times_s])
            for times_s in zip(*((h.yield_s, h.return_s) for h in hands), strict=True)
        )
        self.cap_n: float | Floats = limits.force_cap_n
        self.rest(1)

    def rest(self, moments: int) -> None:
        """Put all hands at rest at the centre."""
        shape = (3, len(self._stiffness), moments)
        self._place_m, self._speed_mps = np.zeros(shape), np.zeros(shape)
        self._held_m, self.sent_n = np.zeros(shape), np.zeros(shape)
        self.is_fast = self.is_outside = np.zeros(shape[1:], dtype=bool)

    @property
    def place_m(self) -> Floats:
        """Return where the hands are (3, hands, moments) m."""
        return self._place_m

    def advance(self, planned_n: Floats) -> Floats:
        """Advance one step and return the radii as shares of the workspace.

        Args:
            planned_n: (3, moments) of the track.
        """
        planned = np.broadcast_to(planned_n[:, None, :], self._place_m.shape)
        self.sent_n = force = self._sent(planned)
        place, speed, step = self._place_m, self._speed_mps, self._step_per_kg
        drag = self._viscous + self._dry_n / np.maximum(np.abs(speed), _STICK_MPS)
        speed += step * (force - self._stiffness * (place - self._held_m))
        speed /= 1.0 + step * drag
        place += speed / RATE_HZ
        if self._give.any():
            self._held_m *= 1.0 - self._back
            self._held_m += self._give * (place - self._held_m)
        self._judge(planned)
        return np.asarray(_size(place) / self._limits.workspace_m)

    def _sent(self, planned: Floats) -> Floats:
        """The force that `haptics.step` sends: faded, centred, capped."""
        limits, centring = self._limits, self._centring
        sent = []
        for planned_n, place_m, speed_mps, cap_n in zip(
            _vectors(planned),
            _vectors(self._place_m),
            _vectors(self._speed_mps),
            np.broadcast_to(self.cap_n, self.is_fast.shape).ravel().tolist(),
            strict=True,
        ):
            hand = HandState(place_m, speed_mps)
            wanted_n, _pull_n = kept_inside(planned_n, hand, limits, centring)
            sent.append(limit(wanted_n, ZERO, math.inf, cap_n))
        return np.array(sent).T.reshape(self._place_m.shape)

    def _judge(self, planned: Floats) -> None:
        """Apply the two trips that a moving hand can cause."""
        self.is_fast = _size(self._speed_mps) > self._limits.speed_mps
        outside = [
            is_pushed_outside(planned_n, place_m, self._limits)
            for planned_n, place_m in zip(
                _vectors(planned), _vectors(self._place_m), strict=True
            )
        ]
        self.is_outside = np.reshape(outside, self.is_fast.shape)


def mechanism_at_grip(
    mechanism: Mechanism,
) -> tuple[Floats, Floats, NDArray[np.float64]]:
    """Return mass, viscous and dry friction at the grip, per axis, in the centre."""
    centre = (0.0, 0.0, FALCON_GEOMETRY.centre_z_m)
    rows = np.linalg.inv(np.array(Kinematics().jacobian(centre)))  # dtheta/dp, 1/m
    square = np.square(rows).sum(axis=0)
    dry = mechanism.coulomb_nm * np.abs(rows).sum(axis=0)
    return (
        mechanism.joint_inertia_kg_m2 * square + mechanism.grip_mass_kg,
        mechanism.viscous_nm_s * square,
        dry[:, None, None],
    )


def _size(vectors: Floats) -> Floats:
    return np.asarray(np.sqrt(np.einsum("i...,i...->...", vectors, vectors)))


def _vectors(values: Floats) -> Iterator[Vector]:
    """Return the vectors of an array (3 axes, hands, moments) one by one."""
    return zip(*values.reshape(3, -1).tolist(), strict=True)
