"""The quality report of a sequence: each figure with a mark, from its description.

The bounds are those that this project's own measurements give reason for: half a
frame (16.7 ms) of synchronisation, a leak that a hand feels as a steady pull
(`notes.LARGE_LEAK_MPS2`), the workspace of the device.
"""

import enum
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from hapticplayer.capture.sync.result import ENOUGH_CONFIDENCE
from hapticplayer.sequence.notes import LARGE_LEAK_MPS2


class Mark(enum.IntEnum):
    """How good something is; the worst of several is their largest."""

    GOOD = 0
    DOUBTFUL = 1
    BAD = 2


@dataclass(frozen=True, slots=True)
class Finding:
    """One figure.

    Attributes:
        name: of what: sync, drift, rate, leak, sensor, gaps, force, workspace, heat,
            cover.
        mark: how good it is.
        value: the figure; None where it could not be measured.
        more: further figures by name.
    """

    name: str
    mark: Mark
    value: float | None
    more: Mapping[str, Any]


_BOUNDS = {
    "residual_s": (0.0167, 0.05),
    "drift_ppm": (150.0, 500.0),
    "rate_hz": (99.0, 29.0),
    "leak_mps2": (LARGE_LEAK_MPS2, 4 * LARGE_LEAK_MPS2),
    "sensor_share": (0.0, 0.01),
    "invalid_share": (0.002, 0.02),
    "longest_gap_s": (0.1, 1.0),
    "force_share": (0.001, 0.02),
    "reach": (0.8, 1.0),
    "thermal": (0.8, 1.0),
    "uncovered_share": (0.02, 0.2),
}
"""Up to the first a figure is good, up to the second doubtful; of the rate, from."""


def quality_report(description: Mapping[str, Any]) -> list[Finding]:
    """Return the findings on a sequence, in the order in which they matter.

    Args:
        description: of `Sequence`; what an older version did not store is left out.
    """
    made_of = _table(description, "provenance")
    motion = _table(made_of, "motion_summary")
    realistic = _table(_table(description, "feedbacks"), "realistic")
    found = [
        _sync(_table(made_of, "synchronisation"), _table(description, "clock_map")),
        _drift(_table(made_of, "synchronisation")),
        _plain("rate", "rate_hz", _number(made_of, "imu_rate_hz"), is_low_bad=True),
        _leak(motion),
        _plain("sensor", "sensor_share", _number(motion, "saturated_share")),
        _gaps(made_of, motion),
        _plain("cover", "uncovered_share", _number(made_of, "uncovered_share")),
        _plain(
            "force",
            "force_share",
            _number(_table(realistic, "provenance"), "saturated_share"),
            peak_n=_number(realistic, "peak_n"),
        ),
        *_workspace(_table(realistic, "excursion")),
    ]
    return [one for one in found if one is not None]


def worst(findings: list[Finding]) -> Mark:
    """Return the mark of the whole."""
    return max((one.mark for one in findings), default=Mark.DOUBTFUL)


def marked(bound: str, value: float, *, is_low_bad: bool = False) -> Mark:
    """Return the mark of a figure."""
    good, doubtful = _BOUNDS[bound]
    sign = -1.0 if is_low_bad else 1.0
    if sign * value <= sign * good:
        return Mark.GOOD
    return Mark.DOUBTFUL if sign * value <= sign * doubtful else Mark.BAD


def _sync(found: Mapping[str, Any], clock: Mapping[str, Any]) -> Finding | None:
    residual_s, confidence = (
        _number(clock, "residual_s"),
        _number(clock, "confidence"),
    )
    if residual_s is None or confidence is None:
        return None
    method = str(found.get("method", ""))
    mark = marked("residual_s", residual_s)
    if confidence < ENOUGH_CONFIDENCE:
        mark = max(mark, Mark.DOUBTFUL if confidence > 0.0 else Mark.BAD)
    elif method == "offset":
        mark = max(mark, Mark.DOUBTFUL)  # nothing in the recording speaks for it
    more = {"method": method, "confidence": confidence}
    return Finding("sync", mark, residual_s, more)


def _drift(found: Mapping[str, Any]) -> Finding | None:
    ppm = _number(found, "drift_ppm")
    if ppm is None:
        return None
    if found.get("method") == "embedded":
        return Finding("drift", Mark.GOOD, 0.0, {"is_fitted": True})
    is_fitted = bool(found.get("drift_is_fitted"))
    mark = marked("drift_ppm", abs(ppm))
    return Finding("drift", mark, ppm if is_fitted else None, {"is_fitted": is_fitted})


def _leak(motion: Mapping[str, Any]) -> Finding | None:
    if "leak_at_rest_mps2" not in motion:
        return None
    leak_mps2 = _number(motion, "leak_at_rest_mps2")
    if leak_mps2 is None:  # it never stood still: nobody can tell
        return Finding("leak", Mark.DOUBTFUL, None, {})
    return Finding("leak", marked("leak_mps2", leak_mps2), leak_mps2, {})


def _gaps(made_of: Mapping[str, Any], motion: Mapping[str, Any]) -> Finding | None:
    share = _number(motion, "invalid_share")
    if share is None:
        return None
    count = _number(made_of, "gaps")
    longest_s = _number(made_of, "longest_gap_s")
    mark = max(
        marked("invalid_share", share), marked("longest_gap_s", longest_s or 0.0)
    )
    more = {"gaps": count, "longest_gap_s": longest_s}
    return Finding("gaps", mark, share, more)


def _workspace(excursion: Mapping[str, Any]) -> list[Finding]:
    hands = _table(excursion, "hands")
    reaches = {name: _number(_table(hands, name), "reach") for name in hands}
    known = {name: reach for name, reach in reaches.items() if reach is not None}
    if not known:
        return []
    reach = known.get("relaxed", max(known.values()))
    trips = [name for name in hands if _table(hands, name).get("trip") is not None]
    mark = Mark.BAD if trips else marked("reach", reach)
    found = [Finding("workspace", mark, reach, {"reaches": known, "trips": trips})]
    heat = _plain("heat", "thermal", _number(excursion, "thermal_share"))
    return found if heat is None else [*found, heat]


def _plain(
    name: str, bound: str, value: float | None, *, is_low_bad: bool = False, **more: Any
) -> Finding | None:
    if value is None:
        return None
    return Finding(name, marked(bound, value, is_low_bad=is_low_bad), value, more)


def _table(held: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    value = held.get(name)
    return value if isinstance(value, Mapping) else {}


def _number(held: Mapping[str, Any], name: str) -> float | None:
    value = held.get(name)
    if not isinstance(value, int | float) or isinstance(value, bool):
        return None
    return float(value) if math.isfinite(value) else None
