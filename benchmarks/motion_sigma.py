"""How well the default method knows its own error, simulated rides with many seeds.

What a family of simulated rides gives hangs on the few that go wrong: with three seeds
of each scene, the share within 2 sigma changes by a tenth from one three to the next.
So the limits are asked of many, and what each three of them gives stands beside it.
"""

from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from typing import Any

from motion_accuracy import Calibration, Score, Scores, calibration, score
from motion_data import simulated_rides
from motion_document import Document
from recordings import load_simulated

from hapticplayer.motion import DEFAULT_METHOD

COVERAGE = (0.90, 0.99)
SIGMA_LIMIT = 1.5
_TOGETHER = 3
Rides = dict[str, dict[int, list[Score]]]
"""By family key and seed."""


def many_rides(wanted: Iterable[str], seeds: int) -> Rides:
    """Score the default method on simulated rides, on all cores: no time is taken.

    Args:
        wanted: of FAMILIES.
        seeds: rides of each scene.
    """
    rides = [
        (key, ride)
        for key, held in simulated_rides(wanted).items()
        for ride in ((*one, seed) for one in held for seed in range(1, seeds + 1))
    ]
    found: Rides = {}
    with ProcessPoolExecutor() as pool:
        scores = pool.map(_score, [ride for _, ride in rides], chunksize=4)
        for (key, (_, _, seed)), one in zip(rides, scores, strict=True):
            found.setdefault(key, {}).setdefault(seed, []).append(one)
    return found


def _score(ride: tuple[str, str, int]) -> Score:
    scene, sensor, seed = ride
    return score(load_simulated(scene, seed, sensor=sensor), DEFAULT_METHOD)


def report(
    scores: Scores, rides: Rides, document: Document, *, whole: bool = True
) -> dict[str, Any]:
    """Print the table and return its figures.

    Args:
        scores: of what was measured beside other methods.
        rides: of families that are judged by these instead.
        document: takes the table.
        whole: whether all recordings are there, so that the limits apply.
    """
    rows: list[list[Any]] = []
    figures: dict[str, Any] = {}
    for key, held in scores.items():
        for name in held:
            is_ours = name == DEFAULT_METHOD
            by_seed = rides.get(key, {}) if is_ours else {}
            judged = [one for seed in by_seed.values() for one in seed] or held[name]
            known = calibration(judged)
            if known is None:
                continue
            spread = _spread(by_seed)
            rows.append(
                [key, name, len(judged), *_cells(known, spread, is_ours and whole)]
            )
            if is_ours:
                figures[key] = {
                    "recordings": len(judged),
                    "within_2_sigma": known.within,
                    "by_threes": spread,
                    "median_sigma_over_rms": known.sigma_over_rms,
                }
    document.table(
        "sigma",
        f"How well sigma tells the error (asked: {COVERAGE[0]:.0%} to "
        f"{COVERAGE[1]:.0%}, at most {SIGMA_LIMIT})",
        [
            *("recordings", "method", "n", "within 2 sigma", "worst recording"),
            *("three seeds at a time", "median sigma / RMS", ""),
        ],
        rows,
    )
    return figures


def _cells(known: Calibration, spread: list[float], is_judged: bool) -> list[str]:
    is_good = COVERAGE[0] <= known.within <= COVERAGE[1]
    is_good &= known.sigma_over_rms <= SIGMA_LIMIT
    return [
        f"{known.within:.3f}",
        f"{known.lowest:.3f}",
        f"{min(spread):.3f} to {max(spread):.3f}" if spread else "",
        f"{known.sigma_over_rms:.2f}",
        ("holds" if is_good else "MISSED") if is_judged else "",
    ]


def _spread(by_seed: dict[int, list[Score]]) -> list[float]:
    """Return the share within 2 sigma of each three seeds in turn."""
    seeds = sorted(by_seed)
    found = []
    for at in range(0, len(seeds) - _TOGETHER + 1, _TOGETHER):
        some = [one for seed in seeds[at : at + _TOGETHER] for one in by_seed[seed]]
        known = calibration(some)
        if known is not None:
            found.append(known.within)
    return found
