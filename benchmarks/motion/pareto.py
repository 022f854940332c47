"""Error against run time: each method and each setting of it is a point.

`python -m tools.result_figures` draws the points of the saved result.
"""

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.common import Report, on_one_thread, rms
from benchmarks.motion.recordings import (
    AVERAGED,
    Family,
    TruthRecording,
    add_options,
    chosen,
    half_window,
    mid_window_vertical,
)
from benchmarks.motion.run_time import SLOW_SAMPLES, Contender, head, ours, time_rounds
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion import (
    DEFAULT_METHOD,
    EkfParameters,
    SmootherParameters,
    estimate_orientation,
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
    """One point of a panel.

    Attributes:
        method: which method it is a setting of.
        knob: the parameter that varies, "" for a method as it is.
        value: of that parameter, for people.
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


def settings(*, quick: bool) -> list[Setting]:
    """Return all points, the default of our method first."""
    found = [_smoother("", DEFAULT)]
    knobs: dict[str, tuple[float, ...]] = {
        "node_s": (0.1, 0.2, 0.5, 1.0, 2.0),
        "window_hz": (8.0, 16.0, 32.0, 64.0),
        "solutions": (1, 2, 3),
        "time_constant_s": (3.0, 10.0, 30.0),
    }
    taus_s: tuple[float, ...] = (1.0, 3.0, 5.0, 10.0, 20.0)
    gates: tuple[float, ...] = (0.5, 2.0, 1000.0)
    if quick:
        knobs, taus_s, gates = {"node_s": (0.2,)}, (3.0,), ()
    usual = SmootherParameters()
    for knob, values in knobs.items():
        others = [v for v in values if v != getattr(usual, knob, v)]
        if hasattr(usual, knob):
            found += [_smoother(knob, f"{value:g}", value) for value in others]
    found += [_vqf(name, tau) for name in ("offlineVQF", "VQF") for tau in taus_s]
    found.append(_corrected_vqf())
    found += [_ekf(gate) for gate in gates]
    found.append(_ours("lowpass", "", "", None))
    return found


def _smoother(knob: str, text: str, value: float | None = None) -> Setting:
    given = {knob: value} if knob else {}
    return _ours(DEFAULT_METHOD, knob, text, SmootherParameters(**given))


def _ekf(gate_mps2: float) -> Setting:
    text = "none" if gate_mps2 > 100.0 else f"{gate_mps2:g}"
    parameters = EkfParameters(accelerometer_gate_mps2=gate_mps2)
    return replace(_ours("ekf", "gate_mps2", text, parameters), slow=True)


def _ours(method: str, knob: str, text: str, parameters: Any) -> Setting:
    given = {} if parameters is None else {"parameters": parameters}

    def orientation(log: ImuLog) -> Floats:
        return estimate_orientation(log, method, **given)

    def vertical(log: ImuLog) -> Floats:
        gravity = remove_gravity(log, method, **given).gravity_mps2
        return np.asarray(gravity / STANDARD_GRAVITY_MPS2)

    return Setting(method, knob, text, orientation, vertical)


def _vqf(name: str, tau_s: float) -> Setting:
    def orientation(log: ImuLog) -> Floats:
        import vqf

        rate, force = (
            np.array(log.angular_rate_radps),
            np.array(log.specific_force_mps2),
        )
        interval_s = 1.0 / log.rate_hz
        if name == "VQF":
            runner = vqf.VQF(interval_s, tauAcc=tau_s)
            return np.asarray(runner.updateBatch(rate, force)["quat6D"])
        found = vqf.offlineVQF(rate, force, None, interval_s, {"tauAcc": tau_s})
        return np.asarray(found["quat6D"])

    def vertical(log: ImuLog) -> Floats:
        return mid_window_vertical(log, orientation(log))

    return Setting(name, "tauAcc_s", f"{tau_s:g}", orientation, vertical)


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
        force = half_window(log).inv().apply(np.array(log.specific_force_mps2))
        found = offlineVQF(rate, np.ascontiguousarray(force), None, 1.0 / log.rate_hz)
        return np.asarray(found["quat6D"])

    def vertical(log: ImuLog) -> Floats:
        return mid_window_vertical(log, orientation(log))

    name = "offlineVQF + averaging terms"
    return Setting(name, "", "", orientation, vertical, averaged_only=True)


@dataclass(frozen=True, slots=True)
class Point:
    """Where a setting lies: run time per sample, us, and mean gravity error."""

    setting: Setting
    us: float
    error_mps2: float


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    add_options(parser, seeds=3)
    parser.add_argument("--rounds", type=int, help="(5)")


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure all points, and whether the default is on the front of each panel."""
    on_one_thread()
    rounds = options.rounds or (3 if options.quick else 5)
    families, points = chosen(options), settings(quick=options.quick)
    panels = {f.key: measured(f, points, rounds) for f in families}
    rows = []
    for key, found in {**panels, "all, geometric mean": overall(panels)}.items():
        default = next(p for p in found if p.setting.value == DEFAULT)
        better = beating(found, default)
        verdict = "; ".join(_against(default, point) for point in better) or "on it"
        rows.append([key, f"{default.us:.3f}", f"{default.error_mps2:.4f}", verdict])
        report.figures[key] = [
            {**{k: getattr(p.setting, k) for k in ("method", "knob", "value")},
             "us": p.us, "error_mps2": p.error_mps2}
            for p in found
        ]  # fmt: skip
    title = (
        "Error against run time of the orientation; named are points that are better "
        f"by more than {SAME_ERROR:.0%} of the error and {SAME_TIME:.0%} of the time"
    )
    header = ["recordings", "default, us", "m/s^2", "front"]
    report.table(title, header, rows, mark="front")


def measured(family: Family, points: Sequence[Setting], rounds: int) -> list[Point]:
    """Return the points of a family; of simulated rides one of each scene is timed."""
    fitting = [p for p in points if family.rate == AVERAGED or not p.averaged_only]
    held = family.one_ride_each()
    ends = np.cumsum([len(recording.imu) for recording in held])
    count = int(np.searchsorted(ends, TIMED_SAMPLES)) + 1
    logs = [recording.imu for recording in held[:count]]
    contenders = {one.name: _contender(one, logs) for one in fitting}
    timings = time_rounds(contenders, rounds, fitting[0].name)
    return [
        Point(one, timings[one.name].us, _mean_error(one, family.recordings))
        for one in fitting
    ]


def _contender(one: Setting, logs: list[ImuLog]) -> Contender:
    held = [head(logs[0], SLOW_SAMPLES)] if one.slow else logs
    return replace(ours(one.orientation, held), slow=one.slow)


def _mean_error(one: Setting, held: Sequence[TruthRecording]) -> float:
    return float(np.mean([rms(r.errors_mps2(one.vertical(r.imu))) for r in held]))


def beating(points: Sequence[Point], default: Point) -> list[Point]:
    """Return the points that are faster and more accurate, by more than chance."""
    return [
        point
        for point in points
        if point.us < (1.0 - SAME_TIME) * default.us
        and point.error_mps2 < (1.0 - SAME_ERROR) * default.error_mps2
    ]


def _against(default: Point, point: Point) -> str:
    time, error = (
        point.us / default.us - 1.0,
        point.error_mps2 / default.error_mps2 - 1.0,
    )
    return f"{point.setting.name} (time {time:+.0%}, error {error:+.1%})"


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
