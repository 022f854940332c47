"""Where a force track would push a hand, known before anybody is pushed.

A reduced model of the simulated Falcon and its hands: masses and frictions are those
in the middle of the workspace, nothing is late, and the force is what `haptics.step`
would send (fade, pull to the middle, cap). A hand forgets within a second, so all
seconds of a track are computed side by side, each with a run-up. It agrees with the
full physics and the real `step` within 1 % of the workspace for rides, and within 7 %
for full force that is switched to and fro along the device's axis (tests).
"""

import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import FIRM, NORMAL, RELAXED
from hapticplayer.errors import InputError, Message
from hapticplayer.haptics.centring import centring_of
from hapticplayer.haptics.limiter import limits_of
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence import files
from hapticplayer.sequence.excursion_model import RATE_HZ, Grip
from hapticplayer.sequence.store import DESCRIPTION

HANDS = {"relaxed": RELAXED, "normal": NORMAL, "firm": FIRM}
LIMITS = limits_of(FALCON)
FAR = LIMITS.fade_from
"""Share of the workspace from which on outward force is weakened."""

WARM = 0.8
"""Share of the continuous force from which on the motors' heat is worth a word."""

_LANE_S, _RUN_UP_S = 1.0, 1.2
_AFTER_S = 0.5  # the hand swings on when the force has gone
_LANES = 600  # computed at a time; ten minutes
_LOOK_STEPS = 100
_HEAT_STEP_S = 0.1


def predict(
    track: ForceTrack,
    duration_s: float,
    progress: Callable[[float], None] = lambda _share: None,
) -> dict[str, Any]:
    """Return how far a track would move three hands, and how warm the motors get.

    Args:
        track: in media time.
        duration_s: of the clip; what lies outside is not played.
        progress: told the done share; may raise to stop the work.

    Returns:
        `hands`: for each the `reach` (share of the workspace, the furthest),
        `reach_at_s`, `far_share` (of the time, beyond `far`), `trip` (what would stop
        the force: "runaway", "outside" or None) and `trip_at_s`; and `far`,
        `rms_10s_n` (the highest), `thermal_share` (of the continuous force).
    """
    grip = Grip(list(HANDS.values()), LIMITS, centring_of(LIMITS))
    force = _sampled(track, duration_s)
    starts = _starts(track, duration_s)
    found = {name: _Found() for name in HANDS}
    for first in range(0, len(starts), _LANES):
        part = starts[first : first + _LANES]

        def tell(share: float, done: int = first, size: int = len(part)) -> None:
            progress((done + share * size) / len(starts))

        _watch(grip, force, part, found, tell)
    return {
        "hands": {name: one.plain(duration_s) for name, one in found.items()},
        "far": FAR,
        **_heat(track, duration_s),
    }


def excursion_texts(prediction: Mapping[str, Any]) -> list[str]:
    """Return what a person should know of a prediction; nothing is the usual case."""
    texts: list[str] = [
        Message(
            "this track would move a {hand} hand so that the force stops ({trip}) "
            "at {at_s:.1f} s",
            hand=Message(name),
            trip=one["trip"],
            at_s=one["trip_at_s"],
        )
        for name, one in prediction["hands"].items()
        if one["trip"] is not None
    ]
    relaxed = prediction["hands"]["relaxed"]
    if not texts and relaxed["reach"] >= prediction["far"]:
        texts.append(
            Message(
                "this track would reach {reach:.0f} % of the workspace with a relaxed "
                "hand, at {at_s:.1f} s; beyond {far:.0f} % the force outward is "
                "weakened",
                reach=100.0 * relaxed["reach"],
                at_s=relaxed["reach_at_s"],
                far=100.0 * prediction["far"],
            )
        )
    if prediction["thermal_share"] >= WARM:
        texts.append(
            Message(
                "this track heats the motors to {heat:.0f} % of what they bear for "
                "ever; they may weaken it",
                heat=100.0 * prediction["thermal_share"],
            )
        )
    return texts


def stored_texts(folder: Path, feedback: str) -> list[str]:
    """Return the texts on a track of a sequence, as predicted when it was made.

    Args:
        folder: of a sequence; one of an older version, or anything else, gives [].
        feedback: name of the track.
    """
    if not (folder / DESCRIPTION).is_file():
        return []
    try:
        entry = files.read_json(folder / DESCRIPTION)["feedbacks"][feedback]
        return excursion_texts(entry["excursion"])
    except (InputError, LookupError, TypeError, ValueError, AttributeError):
        return []  # playing needs no prediction


class _Found:
    """What one hand did."""

    def __init__(self) -> None:
        self.reach, self.reach_at_s, self.far_s = 0.0, 0.0, 0.0
        self.trip: str | None = None
        self.trip_at_s = math.inf

    def see(self, reach: Floats, at_s: Floats, far_s: float) -> None:
        lane = int(np.argmax(reach))
        if reach[lane] > self.reach:
            self.reach, self.reach_at_s = float(reach[lane]), float(at_s[lane])
        self.far_s += far_s

    def see_trip(self, cause: str, is_there: NDArray[np.bool_], at_s: Floats) -> None:
        if is_there.any() and (first_s := float(at_s[is_there].min())) < self.trip_at_s:
            self.trip, self.trip_at_s = cause, first_s

    def plain(self, duration_s: float) -> dict[str, Any]:
        return {
            "reach": round(self.reach, 4),
            "reach_at_s": round(self.reach_at_s, 3),
            "far_share": round(self.far_s / max(duration_s, 1e-9), 5),
            "trip": self.trip,
            "trip_at_s": None if self.trip is None else round(self.trip_at_s, 3),
        }


def _watch(
    grip: Grip,
    force_n: Floats,
    starts: NDArray[np.int64],
    found: Mapping[str, _Found],
    tell: Callable[[float], None],
) -> None:
    """Compute some seconds side by side, and note what the hands did in them."""
    run_up, steps = round(_RUN_UP_S * RATE_HZ), round(_LANE_S * RATE_HZ)
    grip.rest(len(starts))
    shape = (len(found), len(starts))
    reach, reach_at = np.zeros(shape), np.zeros(shape, dtype=np.int64)
    far = np.zeros(shape, dtype=np.int64)
    for step in range(-run_up, steps):
        if step % _LOOK_STEPS == 0:
            tell((step + run_up) / (run_up + steps))
        at = starts + step
        radius = grip.advance(force_n[:, np.clip(at + run_up, 0, None)])
        if step < 0:
            continue
        further = radius > reach
        reach_at[further] = step
        np.maximum(reach, radius, out=reach)
        far += radius > FAR
        if grip.is_fast.any() or grip.is_outside.any():
            for row, one in enumerate(found.values()):
                one.see_trip("runaway", grip.is_fast[row], at / RATE_HZ)
                one.see_trip("outside", grip.is_outside[row], at / RATE_HZ)
    for row, one in enumerate(found.values()):
        at_s = (starts + reach_at[row]) / RATE_HZ
        one.see(reach[row], at_s, float(far[row].sum()) / RATE_HZ)


def _sampled(track: ForceTrack, duration_s: float) -> Floats:
    """Return the played force (3, n) at the model's rate, the run-up's zeros first."""
    run_up = round(_RUN_UP_S * RATE_HZ)
    count = math.ceil((duration_s + _LANE_S + _AFTER_S) * RATE_HZ) + 1
    time_s = np.arange(count) / RATE_HZ
    force = track.at(time_s)
    entry_s = LIMITS.entry_ticks / FALCON.rate_hz
    force *= np.minimum(1.0, time_s / entry_s)[:, None]
    force[time_s >= duration_s] = 0.0
    return np.concatenate([np.zeros((3, run_up)), force.T], axis=1)


def _starts(track: ForceTrack, duration_s: float) -> NDArray[np.int64]:
    """Return the first samples of the seconds in which anything happens."""
    busy = np.zeros(math.ceil((duration_s + _AFTER_S) / _LANE_S) + 1, dtype=bool)
    for begin_s, end_s in track.active_s:
        if begin_s < duration_s and end_s > 0.0:
            last_s = min(end_s, duration_s) + _AFTER_S
            busy[int(max(0.0, begin_s) / _LANE_S) : int(last_s / _LANE_S) + 1] = True
    return np.flatnonzero(busy).astype(np.int64) * round(_LANE_S * RATE_HZ)


def _heat(track: ForceTrack, duration_s: float) -> dict[str, float]:
    """Return the highest RMS over the motors' time constant, of the planned force."""
    time_s = np.arange(0.0, max(duration_s, _HEAT_STEP_S), 0.01)
    square = np.square(track.at(time_s)).sum(axis=1)
    size = round(_HEAT_STEP_S / 0.01)
    means = square[: len(square) // size * size].reshape(-1, size).mean(axis=1)
    share, heat, hottest = _HEAT_STEP_S / LIMITS.heat_time_s, 0.0, 0.0
    for mean in means.tolist():
        heat += share * (mean - heat)
        hottest = max(hottest, heat)
    rms_n = math.sqrt(hottest)
    return {
        "rms_10s_n": round(rms_n, 4),
        "thermal_share": round(rms_n / LIMITS.continuous_n, 4),
    }
