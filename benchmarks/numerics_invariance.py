"""What must not depend on how a recording is cut, turned, reversed or stamped."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from motion_document import Document
from numpy.typing import NDArray
from recordings import TruthRecording
from scipy.spatial.transform import Rotation

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion import SmootherParameters, remove_gravity

Floats = NDArray[np.float64]
OVERLAPS_S = (0.0, 10.0, 40.0)
ROTATIONS = 3
_SINCE_1970_S = 1.7e9
_SHORT_BLOCK_S = 60.0

Change = Callable[[ImuLog], Floats]
"""A log to the gravity that is found when it is processed the other way, (N, 3)."""


def gravity(log: ImuLog, parameters: SmootherParameters | None = None) -> Floats:
    """Return what is taken off, m/s^2 in the sensor frame."""
    return remove_gravity(log, parameters=parameters).gravity_mps2


def part(log: ImuLog, first: int, last: int) -> ImuLog:
    """Return the samples from first to before last."""
    return replace(
        log,
        time_s=log.time_s[first:last],
        specific_force_mps2=log.specific_force_mps2[first:last],
        angular_rate_radps=log.angular_rate_radps[first:last],
        magnetic_field_ut=None,
    )


def in_two_parts(overlap_s: float) -> Change:
    """Cut in the middle; each part reaches so far beyond the cut and is used up to it."""

    def found(log: ImuLog) -> Floats:
        middle, reach = len(log) // 2, round(overlap_s * log.rate_hz)
        first = gravity(part(log, 0, min(len(log), middle + reach)))
        start = max(0, middle - reach)
        second = gravity(part(log, start, len(log)))
        return np.concatenate([first[:middle], second[middle - start :]])

    return found


def in_blocks(log: ImuLog) -> Floats:
    """Let the smoother cut the recording itself, into blocks of a minute."""
    return gravity(log, SmootherParameters(block_s=_SHORT_BLOCK_S))


def backwards(log: ImuLog) -> Floats:
    """Run time backwards: rates change their sign, forces stay.

    A rate that holds up to its sample then holds up to the sample before, so without
    averaging the last sample has none and keeps what is found forwards.
    """
    count = len(log) if log.sampling is Sampling.AVERAGED else len(log) - 1
    rates = log.angular_rate_radps[len(log) - count :]
    time_s = log.time_s[count - 1] - log.time_s[:count]
    reversed_log = replace(
        log,
        time_s=time_s[::-1],
        specific_force_mps2=log.specific_force_mps2[:count][::-1],
        angular_rate_radps=-rates[::-1],
        magnetic_field_ut=None,
    )
    found = gravity(reversed_log)[::-1]
    return np.concatenate([found, gravity(log)[count:]])


def in_turned_frames(log: ImuLog) -> Floats:
    """Turn the sensor's frame at random, several times; return the worst, turned back."""
    usual = gravity(log)
    worst, largest = usual, -1.0
    for turn in Rotation.random(ROTATIONS, rng=np.random.default_rng(5)):
        turned = replace(
            log,
            specific_force_mps2=turn.apply(np.array(log.specific_force_mps2)),
            angular_rate_radps=turn.apply(np.array(log.angular_rate_radps)),
            magnetic_field_ut=None,
        )
        found = turn.inv().apply(np.array(gravity(turned)))
        change = float(np.abs(found - usual).max())
        if change > largest:
            worst, largest = found, change
    return worst


def since_1970(log: ImuLog) -> Floats:
    """Stamp the samples with the time of day, which has fewer digits left."""
    return gravity(replace(log, time_s=log.time_s + _SINCE_1970_S))


def stored_as_float32(log: ImuLog) -> Floats:
    """Keep the samples in half of the space, as the recordings of the data do."""
    force = log.specific_force_mps2.astype(np.float32)
    rate = log.angular_rate_radps.astype(np.float32)
    return gravity(
        replace(
            log,
            specific_force_mps2=force.astype(np.float64),
            angular_rate_radps=rate.astype(np.float64),
        )
    )


CHANGES: dict[str, Change] = {
    "again": gravity,
    "turned frame": in_turned_frames,
    "backwards": backwards,
    "time of day": since_1970,
    "float32 storage": stored_as_float32,
    "blocks of 60 s": in_blocks,
    **{f"two parts, {s:g} s over": in_two_parts(s) for s in OVERLAPS_S},
}


def report(
    families: Sequence[tuple[str, Sequence[TruthRecording]]], document: Document
) -> dict[str, Any]:
    """Print and return by how much gravity changes, by family."""
    figures: dict[str, dict[str, Any]] = {}
    for key, held in families:
        logs = [one.imu for one in held]
        figures[key] = {}
        for name, change in CHANGES.items():
            rms, largest = difference(change, logs)
            figures[key][name] = {"rms_mps2": rms, "largest_mps2": largest}
    for title, figure in (("RMS", "rms_mps2"), ("largest", "largest_mps2")):
        rows = [
            [key, *(_short(found[name][figure]) for name in CHANGES)]
            for key, found in figures.items()
        ]
        document.table(
            f"invariance {title}",
            f"By how much the gravity changes when it is processed so, {title}, m/s^2",
            ["recordings", *CHANGES],
            rows,
        )
    return figures


def _short(value: float) -> str:
    return "0" if value == 0.0 else f"{value:.0e}" if value < 1e-3 else f"{value:.3f}"


def difference(change: Change, logs: Sequence[ImuLog]) -> tuple[float, float]:
    """Return the RMS and the largest change over all samples of some logs."""
    apart = [np.linalg.norm(change(log) - gravity(log), axis=1) for log in logs]
    every = np.concatenate(apart)
    return float(np.sqrt(np.mean(every**2))), float(every.max())
