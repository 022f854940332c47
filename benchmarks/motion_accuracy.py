"""Gravity left in the motion, how sure the method is of it, and the leak at rest."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from motion_data import AVERAGED, NATIVE, Family
from motion_document import Document
from numpy.typing import NDArray
from recordings import TruthRecording, gravity_errors_mps2, offline_vqf_up

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion import DEFAULT_METHOD, METHODS, analyse

Floats = NDArray[np.float64]
REFERENCE = "offlineVQF"

# What is asked of the default method: m/s^2, or a multiple of offlineVQF's error.
LIMITS_MPS2 = {
    ("broad", NATIVE): 0.073,
    ("broad", AVERAGED): 0.097,
    ("car", NATIVE): 0.45,
}
LIMITS_RATIO = {
    ("tumvi", NATIVE): 0.65,
    ("tumvi", AVERAGED): 0.65,
    ("tyrex", NATIVE): 0.45,
    ("tyrex", AVERAGED): 0.5,
}
LEAK_LIMIT_MPS2 = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Score:
    """One method on one recording.

    Attributes:
        name: of the recording.
        scene: of a simulated one, else its family.
        errors_mps2: 9.81 ||u_est - u_true|| of each scored sample.
        sigma_mps2: what the method says of it, or None.
        leak_mps2: at rest, or None without a still span.
        still_s: time of the still spans.
        gain: of the accelerometer.
    """

    name: str
    scene: str
    errors_mps2: Floats
    sigma_mps2: Floats | None = None
    leak_mps2: float | None = None
    still_s: float = 0.0
    gain: float = 1.0

    @property
    def rms_mps2(self) -> float:
        """The gravity error of the recording."""
        return float(np.sqrt(np.mean(np.square(self.errors_mps2))))


def score(recording: TruthRecording, method: str) -> Score:
    """Return what one of METHODS makes of a recording."""
    done = analyse(recording.imu, method)
    track, summary = done.track, done.summary
    sigma = track.gravity_sigma_mps2
    return Score(
        recording.name,
        recording.family,
        gravity_errors_mps2(recording, track.gravity_mps2 / STANDARD_GRAVITY_MPS2),
        None if sigma is None else sigma[recording.scored],
        summary["leak_at_rest_mps2"],
        summary["still_s"],
        summary["accelerometer_gain"],
    )


def score_reference(recording: TruthRecording) -> Score:
    """Return what the package's offlineVQF makes of it."""
    errors = gravity_errors_mps2(recording, offline_vqf_up(recording.imu))
    return Score(recording.name, recording.family, errors)


def mean_error_mps2(scores: Iterable[Score]) -> float:
    """Return the mean over recordings of their gravity errors."""
    return float(np.mean([one.rms_mps2 for one in scores]))


@dataclass(frozen=True, slots=True)
class Calibration:
    """How well a method knows its own error.

    Attributes:
        within: share of the samples whose error is below 2 sigma.
        lowest: the same of the worst recording.
        sigma_over_rms: median sigma over the RMS error.
    """

    within: float
    lowest: float
    sigma_over_rms: float


def calibration(scores: Sequence[Score]) -> Calibration | None:
    """Return it over all samples of some recordings; None without sigmas."""
    if any(one.sigma_mps2 is None for one in scores):
        return None
    inside = [one.errors_mps2 <= 2.0 * np.asarray(one.sigma_mps2) for one in scores]
    errors = np.concatenate([one.errors_mps2 for one in scores])
    sigma = np.concatenate([np.asarray(one.sigma_mps2) for one in scores])
    rms = float(np.sqrt(np.mean(np.square(errors))))
    return Calibration(
        within=float(np.mean(np.concatenate(inside))),
        lowest=float(min(part.mean() for part in inside)),
        sigma_over_rms=float(np.median(sigma)) / rms,
    )


Scores = dict[str, dict[str, list[Score]]]
"""By family key and method; the reference is one of the methods."""


def measure(families: Sequence[Family], methods: Sequence[str]) -> Scores:
    """Run every method on every recording; those apart under `... apart`."""
    found: Scores = {}
    for family in families:
        for key, held in (
            (family.key, family.recordings),
            (_apart(family), family.apart),
        ):
            if held:
                found[key] = {name: [score(r, name) for r in held] for name in methods}
                found[key][REFERENCE] = [score_reference(r) for r in held]
    return found


def _apart(family: Family) -> str:
    return f"{family.key}, one with a hole"


def report(
    families: Sequence[Family],
    scores: Scores,
    document: Document,
    *,
    whole: bool = True,
) -> dict[str, Any]:
    """Print the tables and return their figures.

    Args:
        families: that were measured.
        scores: what was measured.
        document: takes the tables.
        whole: whether all recordings are there, so that the limits of means apply.
    """
    document.table(
        "error",
        "Mean gravity error, m/s^2 (limit of the default in m/s^2 or x offlineVQF)",
        ["recordings", "n", *METHODS, REFERENCE, "ratio", "limit", ""],
        _error_rows(families if whole else [], scores),
    )
    scenes = _scene_rows(families, scores)
    if scenes:
        document.table(
            "scenes",
            "Simulated rides, m/s^2, mean over seeds",
            ["scene", "rate", DEFAULT_METHOD, REFERENCE, "ratio"],
            scenes,
        )
    document.table(
        "leak",
        f"Leak at rest with {DEFAULT_METHOD}, m/s^2 (limit {LEAK_LIMIT_MPS2})",
        ["recording", "family", "still s", "gain", "leak", ""],
        _leak_rows(scores),
    )
    return {key: _figures(held) for key, held in scores.items()}


def _error_rows(families: Sequence[Family], scores: Scores) -> list[list[Any]]:
    rows: list[list[Any]] = []
    names = {family.key: family for family in families}
    for key, held in scores.items():
        means = {name: mean_error_mps2(held[name]) for name in held}
        ratio = means[DEFAULT_METHOD] / means[REFERENCE]
        limit = holds = ""
        if key in names:
            place = (names[key].name, names[key].rate)
            if place in LIMITS_MPS2:
                limit = f"{LIMITS_MPS2[place]:.3f}"
                holds = _verdict(means[DEFAULT_METHOD] <= LIMITS_MPS2[place])
            elif place in LIMITS_RATIO:
                limit = f"{LIMITS_RATIO[place]:.2f} x"
                holds = _verdict(ratio <= LIMITS_RATIO[place])
        errors = [f"{means[name]:.4f}" for name in (*METHODS, REFERENCE)]
        rows.append([key, len(held[REFERENCE]), *errors, f"{ratio:.2f}", limit, holds])
    return rows


def _verdict(holds: bool) -> str:
    return "holds" if holds else "MISSED"


def _scene_rows(families: Sequence[Family], scores: Scores) -> list[list[Any]]:
    rows = []
    for family in families:
        if not family.name.startswith("sim-"):
            continue
        held = scores[family.key]
        for scene in dict.fromkeys(one.scene for one in held[REFERENCE]):
            ours, theirs = (
                mean_error_mps2(one for one in held[name] if one.scene == scene)
                for name in (DEFAULT_METHOD, REFERENCE)
            )
            errors = [f"{ours:.3f}", f"{theirs:.3f}", f"{ours / theirs:.2f}"]
            rows.append([scene, family.rate, *errors])
    return rows


def _leak_rows(scores: Scores) -> list[list[Any]]:
    rows: list[list[Any]] = []
    for key, held in scores.items():
        for one in held[DEFAULT_METHOD]:
            if one.leak_mps2 is None:
                continue
            holds = _verdict(one.leak_mps2 <= LEAK_LIMIT_MPS2)
            known = [f"{one.still_s:.1f}", f"{one.gain:.4f}", f"{one.leak_mps2:.4f}"]
            rows.append([one.name, key, *known, holds])
    return rows


def _figures(held: dict[str, list[Score]]) -> dict[str, Any]:
    """Return the figures of one family for the JSON."""
    found: dict[str, Any] = {}
    for name, scores in held.items():
        known = calibration(scores)
        found[name] = {
            "mean_error_mps2": mean_error_mps2(scores),
            "error_mps2": {one.name: one.rms_mps2 for one in scores},
        }
        if known is not None:
            found[name]["within_2_sigma"] = known.within
            found[name]["median_sigma_over_rms"] = known.sigma_over_rms
        leaks = {one.name: one.leak_mps2 for one in scores if one.leak_mps2 is not None}
        if leaks:
            found[name]["leak_at_rest_mps2"] = leaks
    return found
