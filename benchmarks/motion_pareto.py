"""Error against run time: each method and each setting of it is a point."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from motion_data import AVERAGED, Family, one_ride_each
from motion_document import Document
from motion_time import SLOW_SAMPLES, Contender, head, time_rounds
from numpy.typing import NDArray
from recordings import TruthRecording, gravity_error_mps2
from scipy.spatial.transform import Rotation

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, Sampling
from hapticplayer.model import quaternions as quat
from hapticplayer.motion import (
    DEFAULT_METHOD,
    EkfParameters,
    SmootherParameters,
    estimate_orientation,
    grid,
    lowpass,
    remove_gravity,
)

Floats = NDArray[np.float64]
DEFAULT = "default"
# Recordings of a family are timed until they have so many samples.
TIMED_SAMPLES = 120_000
# Two points this near to each other cannot be told apart.
SAME_ERROR, SAME_TIME = 0.02, 0.1


@dataclass(frozen=True, slots=True)
class Setting:
    """One point of the picture.

    Attributes:
        method: which method it is a setting of; several share a line per `knob`.
        knob: what is turned, "" for a method as it is.
        value: where it is turned to, for people.
        orientation: what is timed: a log to its orientations.
        vertical: a log to the vertical that would be taken off, (N, 3).
        slow: timed on a few samples only.
        averaged_only: only for averaged samples.
    """

    method: str
    knob: str
    value: str
    orientation: Callable[[ImuLog], Floats]
    vertical: Callable[[ImuLog], Floats]
    slow: bool = False
    averaged_only: bool = False

    @property
    def name(self) -> str:
        """For people and the JSON."""
        return " ".join(part for part in (self.method, self.knob, self.value) if part)


def settings(*, quick: bool = False) -> list[Setting]:
    """Return all points, the default of our method first."""
    found = [_smoother("", DEFAULT)]
    knobs: dict[str, tuple[float, ...]] = {
        "node_s": (0.1, 0.2, 0.5, 1.0, 2.0),
        "window_hz": (8.0, 16.0, 32.0, 64.0),
        "solutions": (1, 2, 3),
        "time_constant_s": (3.0, 10.0, 30.0),
    }
    usual = SmootherParameters()
    constants: tuple[float, ...] = (1.0, 3.0, 5.0, 10.0, 20.0)
    gates: tuple[float, ...] = (0.5, 2.0, 1000.0)
    cutoffs: tuple[float, ...] = (0.1, 0.3, 1.0, 3.0)
    if quick:
        knobs = {"node_s": (0.2,), "time_constant_s": (10.0,)}
        constants, gates, cutoffs = (3.0,), (), (1.0,)  # the ekf alone takes as long
    for knob, values in knobs.items():
        turned = [value for value in values if value != getattr(usual, knob)]
        found += [_smoother(knob, f"{value:g}", value) for value in turned]
    for name in ("offlineVQF", "VQF"):
        found += [_vqf(name, constant) for constant in constants]
    found.append(_corrected_vqf())
    found += [_ekf(gate) for gate in gates]
    found += [_lowpass(cutoff) for cutoff in cutoffs]
    return found


def _smoother(knob: str, text: str, value: float | None = None) -> Setting:
    given = {knob: value} if knob else {}
    return _ours(DEFAULT_METHOD, knob, text, SmootherParameters(**given))


def _ekf(gate_mps2: float) -> Setting:
    text = "none" if gate_mps2 > 100.0 else f"{gate_mps2:g}"
    parameters = EkfParameters(accelerometer_gate_mps2=gate_mps2)
    return _ours("ekf", "gate_mps2", text, parameters, slow=True)


def _ours(
    method: str,
    knob: str,
    text: str,
    parameters: SmootherParameters | EkfParameters,
    *,
    slow: bool = False,
) -> Setting:
    def orientation(log: ImuLog) -> Floats:
        return estimate_orientation(log, method, parameters=parameters)

    def vertical(log: ImuLog) -> Floats:
        track = remove_gravity(log, method, parameters=parameters)
        return np.asarray(track.gravity_mps2 / STANDARD_GRAVITY_MPS2)

    return Setting(method, knob, text, orientation, vertical, slow)


def _vqf(name: str, tau_s: float) -> Setting:
    def orientation(log: ImuLog) -> Floats:
        return _packaged(name, log, tau_s)

    def vertical(log: ImuLog) -> Floats:
        return _mid_window_vertical(log, orientation(log))

    return Setting(name, "tauAcc_s", f"{tau_s:g}", orientation, vertical)


def _packaged(name: str, log: ImuLog, tau_s: float) -> Floats:
    import vqf

    rate, force = np.array(log.angular_rate_radps), np.array(log.specific_force_mps2)
    interval_s = 1.0 / log.rate_hz
    if name == "VQF":
        runner = vqf.VQF(interval_s, tauAcc=tau_s)
        return np.asarray(runner.updateBatch(rate, force)["quat6D"])
    found = vqf.offlineVQF(rate, force, None, interval_s, {"tauAcc": tau_s})
    return np.asarray(found["quat6D"])


def _mid_window_vertical(log: ImuLog, q: Floats) -> Floats:
    """Return the vertical; half a window back for averaged samples."""
    turned = Rotation.from_quat(q, scalar_first=True)
    if log.sampling is Sampling.AVERAGED:
        turned = turned * _half_window(log).inv()
    return np.asarray(turned.inv().apply([0.0, 0.0, 1.0]))


def _half_window(log: ImuLog) -> Rotation:
    return Rotation.from_rotvec(0.5 / log.rate_hz * log.angular_rate_radps)


def _corrected_vqf() -> Setting:
    """Give offlineVQF inputs that say at the end of a window what was averaged over it.

    The specific force is turned by half the window's rotation, the rotation gains its
    coning term. So much of the gain at 30 Hz is due to the inputs alone.
    """

    def orientation(log: ImuLog) -> Floats:
        from vqf import offlineVQF

        turn = log.angular_rate_radps / log.rate_hz
        change = np.zeros_like(turn)
        change[1:-1] = turn[2:] - turn[:-2]
        rate = (turn + np.cross(turn, change) / 24.0) * log.rate_hz
        force = _half_window(log).inv().apply(np.array(log.specific_force_mps2))
        found = offlineVQF(rate, np.ascontiguousarray(force), None, 1.0 / log.rate_hz)
        return np.asarray(found["quat6D"])

    def vertical(log: ImuLog) -> Floats:
        return _mid_window_vertical(log, orientation(log))

    name = "offlineVQF + averaging terms"
    return Setting(name, "", "", orientation, vertical, averaged_only=True)


def _lowpass(cutoff_hz: float) -> Setting:
    def up(log: ImuLog) -> tuple[grid.EvenLog, Floats]:
        even = grid.even(log, log.specific_force_mps2)
        force, interval_s = even.specific_force_mps2, even.interval_s
        return even, lowpass.lowpass_vertical(force, interval_s, cutoff_hz)

    def orientation(log: ImuLog) -> Floats:
        return lowpass.orientation_from_vertical(up(log)[1])

    def vertical(log: ImuLog) -> Floats:
        even, found = up(log)
        if even.time_s is log.time_s:
            return found
        return quat.normalized(grid.columns(log.time_s, even.time_s, found))

    return Setting("lowpass", "cutoff_hz", f"{cutoff_hz:g}", orientation, vertical)


@dataclass(frozen=True, slots=True)
class Point:
    """Where a setting lies in a panel.

    Attributes:
        setting: which one.
        us: run time per sample.
        error_mps2: mean gravity error.
    """

    setting: Setting
    us: float
    error_mps2: float


def measure(
    families: Sequence[Family], chosen: Sequence[Setting], rounds: int
) -> dict[str, list[Point]]:
    """Return the points of each family's panel.

    Errors are those of all recordings, as in the other tables; the time of simulated
    rides is that of one of each scene.
    """
    panels = {}
    for family in families:
        fitting = [
            one for one in chosen if family.rate == AVERAGED or not one.averaged_only
        ]
        logs = _timed_logs(one_ride_each(family))
        timings = time_rounds({s.name: _contender(s, logs) for s in fitting}, rounds)
        panels[family.key] = [
            Point(one, timings[one.name].us, _mean_error(one, family.recordings))
            for one in fitting
        ]
    return panels


def _timed_logs(held: Sequence[TruthRecording]) -> list[ImuLog]:
    ends = np.cumsum([len(recording.imu) for recording in held])
    count = int(np.searchsorted(ends, TIMED_SAMPLES)) + 1
    return [recording.imu for recording in held[:count]]


def _contender(one: Setting, logs: list[ImuLog]) -> Contender:
    if one.slow:
        logs = [head(logs[0], SLOW_SAMPLES)]

    def run() -> None:
        for log in logs:
            one.orientation(log)

    return Contender(run, sum(len(log) for log in logs), one.slow)


def _mean_error(one: Setting, held: Sequence[TruthRecording]) -> float:
    errors = [gravity_error_mps2(r, one.vertical(r.imu)) for r in held]
    return float(np.mean(errors))


def front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other one beats in both, fastest first."""
    best: list[Point] = []
    for point in sorted(points, key=lambda p: (p.us, p.error_mps2)):
        if not best or point.error_mps2 < best[-1].error_mps2:
            best.append(point)
    return best


def beating(points: Sequence[Point], default: Point) -> list[Point]:
    """Return the points that are faster and more accurate, by more than chance."""
    return [
        point
        for point in points
        if point.us < (1.0 - SAME_TIME) * default.us
        and point.error_mps2 < (1.0 - SAME_ERROR) * default.error_mps2
    ]


def report(panels: Mapping[str, Sequence[Point]], document: Document) -> dict[str, Any]:
    """Print whether the default is on the front of each panel; return the figures."""
    rows, figures = [], {}
    for key, points in {**panels, "all, geometric mean": overall(panels)}.items():
        default = next(p for p in points if p.setting.value == DEFAULT)
        others = beating(points, default)
        edge = front(points)
        verdict = "yes, strictly" if default in edge else "yes"
        if others:
            verdict = "NO: " + "; ".join(map(_beats(default), others))
        place = [f"{default.us:.3f}", f"{default.error_mps2:.4f}"]
        rows.append([key, *place, verdict])
        figures[key] = {
            "default_on_front": not others,
            "beaten_by": [p.setting.name for p in others],
            "front": [p.setting.name for p in edge],
            "points": [_plain(point) for point in points],
        }
    document.table(
        "front",
        "Error against run time of the orientation: is the default on the front? (NO: "
        f"another point is better by more than {SAME_ERROR:.0%} of the error and "
        f"{SAME_TIME:.0%} of the time at once)",
        ["panel", "default, us", "m/s^2", "on the front"],
        rows,
    )
    return figures


def _plain(point: Point) -> dict[str, Any]:
    return {
        "method": point.setting.method,
        "knob": point.setting.knob,
        "value": point.setting.value,
        "us_per_sample": point.us,
        "error_mps2": point.error_mps2,
    }


def _beats(default: Point) -> Callable[[Point], str]:
    def text(point: Point) -> str:
        time, error = (
            point.us / default.us - 1,
            point.error_mps2 / default.error_mps2 - 1,
        )
        return f"{point.setting.name} (time {time:+.0%}, error {error:+.1%})"

    return text


def overall(panels: Mapping[str, Sequence[Point]]) -> list[Point]:
    """Return the geometric means over the panels of the settings that are in all."""
    by_name: dict[str, list[Point]] = {}
    for points in panels.values():
        for point in points:
            by_name.setdefault(point.setting.name, []).append(point)
    return [
        Point(
            held[0].setting,
            float(np.exp(np.mean(np.log([p.us for p in held])))),
            float(np.exp(np.mean(np.log([p.error_mps2 for p in held])))),
        )
        for held in by_name.values()
        if len(held) == len(panels)
    ]
