"""What a hand got in a trial, beside what was planned: from the record of its ticks.

Planned is the force of the track, sent what went to the device: after entry, fade and
spring at the edge of the workspace, caps, stops. Errors are weighted by frequency
(`rendering.weighting`). A trial is marked where they exceed what goes unnoticed: 15 % of
the plan (twice the difference that is just noticed from 2.5 to 10 N; Pang, Tan and
Durlach 1991), or 0.04 N, the least force that is perceived, for weak plans.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import Limits, cap_when_warm
from hapticplayer.model.arrays import Floats
from hapticplayer.rendering.washout import magnitude_rms_n, weighted

MOST_ERROR = 0.15
LEAST_FORCE_N = 0.04
RATE_HZ = 1000.0
_FULL_N = 0.05  # as `step` takes two forces for equal
_LEAST_TICKS = 100
FIELDS = (
    *("monotonic_s", "media_s", "planned_n", "force_n", "position_m", "centring_n"),
    *("heat_n", "mode", "cause"),
)
"""Of a tick, see `haptics.shared.TICK`."""


@dataclass(frozen=True, slots=True)
class TrialForce:
    """A trial's force.

    Attributes:
        error_n: weighted RMS of sent less planned force, N.
        planned_n: weighted RMS of the planned force, N.
        reach_m: largest distance of the grip from the centre; None if not measured.
        faded_s: time in which less was sent than planned: entry, ramps, stops, and
            fades at the edge of the workspace.
        saturated_share: share of the time in which the force cap took something.
    """

    error_n: float
    planned_n: float
    reach_m: float | None
    faded_s: float
    saturated_share: float

    @property
    def error(self) -> float | None:
        """Error as a share of the plan; None where no force was planned."""
        return self.error_n / self.planned_n if self.planned_n > 0.0 else None

    @property
    def is_off(self) -> bool:
        """Whether the hand got noticeably something else than was planned."""
        return self.error_n > max(LEAST_FORCE_N, MOST_ERROR * self.planned_n)


def measure_trial_force(
    ticks: NDArray[Any], duration_s: float, limits: Limits
) -> TrialForce | None:
    """The measured force while a clip played.

    While the force is off the loop does not say what is planned; a straight line
    stands in for it.

    Args:
        ticks: with FIELDS, in order of time; those outside of the clip do not count.
        duration_s: of the clip.
        limits: of the device.

    Returns:
        None for fewer than 0.1 s.
    """
    media_s = ticks["media_s"]
    ticks = ticks[(media_s > 0.0) & (media_s < duration_s) & _is_finite(ticks)]
    ticks = ticks[np.diff(ticks["monotonic_s"], prepend=-np.inf) > 0.0]
    if len(ticks) < _LEAST_TICKS:
        return None
    is_acting = np.isin(ticks["mode"], (Mode.ENTERING, Mode.FOLLOWING))
    is_known = is_acting | (ticks["cause"] == Cause.TRACK_ENDED)
    if not is_known.any():
        return None
    time_s = ticks["monotonic_s"]
    known = ticks[is_known]
    planned = _even(time_s, known["monotonic_s"], known["planned_n"])
    sent = _even(time_s, time_s, ticks["force_n"])
    # what fade, caps and entry took of track and spring together
    wanted = ticks["planned_n"].astype(float) + ticks["centring_n"]
    is_short = np.linalg.norm(ticks["force_n"] - wanted, axis=1) > _FULL_N
    is_following = ticks["mode"] == Mode.FOLLOWING
    is_capped = _capped(ticks, is_short & is_following, limits)
    is_faded = (is_short & is_following & ~is_capped) | ~(
        is_following | _is_over(ticks)
    )
    step_s = np.minimum(np.diff(time_s, append=time_s[-1] + 1.0 / RATE_HZ), 0.1)
    return TrialForce(
        magnitude_rms_n(weighted(sent - planned, RATE_HZ)),
        magnitude_rms_n(weighted(planned, RATE_HZ)),
        _reach_m(ticks["position_m"]),
        float(step_s[is_faded].sum()),
        float(step_s[is_capped].sum() / step_s.sum()),
    )


def _is_finite(ticks: NDArray[Any]) -> NDArray[np.bool_]:
    """Return where all forces are numbers; records come from elsewhere."""
    forces = [ticks[name] for name in ("planned_n", "force_n", "centring_n")]
    return np.asarray(np.isfinite(np.concatenate(forces, axis=1)).all(axis=1))


def _is_over(ticks: NDArray[Any]) -> NDArray[np.bool_]:
    """Return where the track has ended before its clip."""
    return np.asarray(ticks["cause"] == Cause.TRACK_ENDED)


def _even(time_s: Floats, known_s: Floats, force_n: NDArray[np.float32]) -> Floats:
    """Return a force (3, N) at 1 kHz, from its values (M, 3) at times (M,)."""
    at_s = np.arange(time_s[0], time_s[-1], 1.0 / RATE_HZ)
    return np.stack([np.interp(at_s, known_s, axis) for axis in force_n.T])


def _capped(
    ticks: NDArray[Any], is_short: NDArray[np.bool_], limits: Limits
) -> NDArray[np.bool_]:
    """Return where the force is as large as the cap of that moment, and short of more."""
    rows = np.flatnonzero(is_short)
    heat_n2 = np.square(ticks["heat_n"][rows].astype(float)).tolist()
    caps_n = np.array([cap_when_warm(one, limits) for one in heat_n2])
    sizes_n = np.linalg.norm(ticks["force_n"][rows], axis=1)
    found = np.zeros(len(ticks), np.bool_)
    found[rows] = sizes_n > caps_n - _FULL_N
    return found


def _reach_m(position_m: NDArray[np.float32]) -> float | None:
    radius_m = np.linalg.norm(position_m.astype(float), axis=1)
    radius_m = radius_m[np.isfinite(radius_m)]
    return float(radius_m.max()) if len(radius_m) else None
