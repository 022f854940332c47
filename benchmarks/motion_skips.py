"""What is skipped where a scene does not need it: the saving, and what it changes."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from motion_data import AVERAGED, OPTICAL, Family
from motion_document import Document
from motion_time import SLOW_METHODS, SLOW_SAMPLES, Contender, head, time_rounds
from numpy.typing import NDArray
from recordings import load_simulated
from scipy.spatial.transform import Rotation

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog
from hapticplayer.motion import (
    DEFAULT_METHOD,
    SmootherParameters,
    estimate_orientation,
    remove_gravity,
)

Floats = NDArray[np.float64]
MAX_CHANGE_MPS2 = 0.01
HEADING_METHODS = ("vqf", "offline-vqf", "ekf")
_SECONDS, _RATE_HZ = 300.0, 200.0
# Samples of one measurement.
_AT_LEAST = 600_000
_WITH, _WITHOUT = "with", "without"


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """Logs in which something can be skipped, or nothing.

    Attributes:
        name: for people.
        logs: of the scene.
    """

    name: str
    logs: list[ImuLog]


def at_rest() -> ImuLog:
    """Five minutes on a tripod: bias, gain error and white noise."""
    return _held(np.zeros(round(_SECONDS * _RATE_HZ)), "on a tripod")


def without_rotation() -> ImuLog:
    """Five minutes on a slider: moving, but never turning."""
    time_s = np.arange(round(_SECONDS * _RATE_HZ)) / _RATE_HZ
    return _held(1.5 * np.sin(2.0 * np.pi * 0.8 * time_s), "on a slider")


def _held(sideways_mps2: Floats, name: str) -> ImuLog:
    rng = np.random.default_rng(7)
    shape = (len(sideways_mps2), 3)
    tilt = Rotation.from_rotvec([0.1, -0.2, 0.0])
    earth = np.tile([0.0, 0.0, STANDARD_GRAVITY_MPS2], (shape[0], 1))
    earth[:, 0] = sideways_mps2
    force = tilt.apply(earth)
    return ImuLog(
        np.arange(len(force)) / _RATE_HZ,
        1.02 * force + 0.035 * rng.standard_normal(shape),
        np.array([0.004, -0.003, 0.005]) + 0.003 * rng.standard_normal(shape),
        source=name,
    )


def scenes(families: Sequence[Family], *, quick: bool) -> list[Scene]:
    """Return the scenes: calm and still ones, and recordings in which all moves."""
    found = [
        Scene("on a tripod, 5 min", [at_rest()]),
        Scene("on a slider, 5 min", [without_rotation()]),
    ]
    found += [
        Scene(f"simulated {name}", [load_simulated(name).imu])
        for name in ("handheld-quiet", "car-motorway", "handheld-brisk")
    ]
    if quick:
        return found[:3]
    for family in families:
        if family.name in (*OPTICAL, "car"):
            logs = [recording.imu for recording in family.recordings]
            found.append(Scene(family.key, logs))
    return found


def switches() -> list[str]:
    """Return the parameters of the smoother that turn a skip on or off."""
    return [f.name for f in fields(SmootherParameters) if isinstance(f.default, bool)]


def report(
    families: Sequence[Family], rounds: int, document: Document, *, quick: bool = False
) -> dict[str, Any]:
    """Print and return what every skip saves and changes."""
    figures: dict[str, Any] = {"switches": {}, "heading": {}, "field": {}}
    chosen = scenes(families, quick=quick)
    for switch in switches():
        figures["switches"][switch] = _switch(switch, chosen, rounds, document)
    if not figures["switches"]:
        print("\nThe smoother has no switch for a shortcut.")
    with_field = [
        recording.imu
        for family in families
        for recording in family.recordings
        if recording.imu.magnetic_field_ut is not None and family.rate != AVERAGED
    ]
    if with_field:
        figures["heading"] = _heading(with_field, rounds, document)
        figures["field"] = _field(with_field, rounds)
    return figures


def _switch(
    switch: str, chosen: Sequence[Scene], rounds: int, document: Document
) -> dict[str, Any]:
    parameters = {
        name: SmootherParameters(**{switch: name == _WITH})
        for name in (_WITH, _WITHOUT)
    }
    rows, figures = [], {}
    for scene in chosen:
        timing = time_rounds(
            {name: _contender(scene.logs, given) for name, given in parameters.items()},
            rounds,
            _WITHOUT,
        )
        rms, largest = _change(
            [
                [_motion(log, given) for log in scene.logs]
                for given in parameters.values()
            ]
        )
        figures[scene.name] = {
            "us_with": timing[_WITH].us,
            "us_without": timing[_WITHOUT].us,
            "ratio": timing[_WITH].ratio,
            "rms_change_mps2": rms,
            "largest_change_mps2": largest,
        }
        saved = 1.0 - timing[_WITH].ratio
        us = [f"{timing[name].us:.3f}" for name in (_WITH, _WITHOUT)]
        holds = "holds" if largest < MAX_CHANGE_MPS2 else "MISSED"
        changes = [f"{rms:.5f}", f"{largest:.5f}"]
        rows.append([scene.name, *us, f"{saved:.0%}", *changes, holds])
    document.table(
        f"skip {switch}",
        f"{DEFAULT_METHOD} with and without {switch}: remove_gravity, us per sample, "
        "and by how much p[k] changes, m/s^2",
        ["scene", _WITH, _WITHOUT, "saved", "rms change", "at most", ""],
        rows,
    )
    return figures


def _contender(logs: Sequence[ImuLog], given: SmootherParameters | None) -> Contender:
    samples = sum(len(log) for log in logs)
    # what runs first after a pause is slow for some milliseconds, which would be more
    # than a shortcut saves
    times = -(-_AT_LEAST // samples)

    def run() -> None:
        for _ in range(times):
            for log in logs:
                remove_gravity(log, parameters=given)

    return Contender(run, times * samples)


def _motion(log: ImuLog, given: SmootherParameters) -> Floats:
    return remove_gravity(log, parameters=given).acceleration_mps2


def _change(motions: Sequence[Sequence[Floats]]) -> tuple[float, float]:
    """Return the RMS over all samples of the change of p[k], and the largest."""
    changes = [
        np.linalg.norm(one - other, axis=1) for one, other in zip(*motions, strict=True)
    ]
    every = np.concatenate(changes)
    return float(np.sqrt(np.mean(every**2))), float(every.max())


def _heading(logs: Sequence[ImuLog], rounds: int, document: Document) -> dict[str, Any]:
    """What the magnetometer costs where a heading is asked for."""
    rows, figures = [], {}
    for method in HEADING_METHODS:
        slow = method in SLOW_METHODS
        used = [head(logs[0], SLOW_SAMPLES)] if slow else logs
        contenders = {
            name: _oriented(used, method, heading=name == _WITH, slow=slow)
            for name in (_WITHOUT, _WITH)
        }
        timing = time_rounds(contenders, rounds, _WITH)
        saved = 1.0 - timing[_WITHOUT].ratio
        figures[method] = {name: timing[name].us for name in (_WITHOUT, _WITH)}
        us = [f"{timing[name].us:.3f}" for name in (_WITHOUT, _WITH)]
        rows.append([method, *us, f"{saved:.0%}"])
    document.table(
        "skip magnetometer",
        "No magnetometer work without heading=True: estimate_orientation, us per sample",
        ["method", "without heading", "with", "saved"],
        rows,
    )
    return figures


def _oriented(
    logs: Sequence[ImuLog], method: str, *, heading: bool, slow: bool
) -> Contender:
    def run() -> None:
        for log in logs:
            estimate_orientation(log, method, heading=heading)

    return Contender(run, sum(len(log) for log in logs), slow)


def _field(logs: Sequence[ImuLog], rounds: int) -> dict[str, Any]:
    """What a magnetometer in the log changes for the default: nothing."""
    without = [replace(log, magnetic_field_ut=None) for log in logs]
    timing = time_rounds(
        {_WITH: _contender(logs, None), _WITHOUT: _contender(without, None)},
        rounds,
        _WITHOUT,
    )
    usual = SmootherParameters()
    _, largest = _change(
        [[_motion(log, usual) for log in held] for held in (logs, without)]
    )
    print(
        f"A magnetometer in the log: {DEFAULT_METHOD} takes {timing[_WITH].us:.3f} us "
        f"with and {timing[_WITHOUT].us:.3f} without; p[k] changes by at most "
        f"{largest:g} m/s^2"
    )
    return {
        "us_with": timing[_WITH].us,
        "us_without": timing[_WITHOUT].us,
        "largest_change_mps2": largest,
    }
