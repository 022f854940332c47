"""Error and sigma of the smoother with each of its constants halved and doubled.

The constants are those of `hapticplayer.motion.smoother`: fields of SmootherParameters
and names in capitals. A column of counts is left alone.
"""

import argparse
import importlib
import pkgutil
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import fields, replace
from types import ModuleType
from typing import Any, NamedTuple
from unittest import mock

import numpy as np

from benchmarks.common import Report, on_one_thread
from benchmarks.motion.recordings import Family, add_options, chosen
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion import SmootherParameters, remove_gravity, smoother

FACTORS = (0.5, 2.0)
# What counts columns and samples in memory, and imported values.
LEFT_ALONE = ("COLUMNS", "ACCEL_SCALE", "CHUNK", "STANDARD_GRAVITY")


class Outcome(NamedTuple):
    """Mean error of each family, and share of the samples within 2 sigma."""

    error_mps2: dict[str, float]
    within: float


def options(parser: argparse.ArgumentParser) -> None:
    add_options(parser, seeds=1)


def run(options: argparse.Namespace, report: Report) -> None:
    """Change one constant after another."""
    on_one_thread()
    families = chosen(options)
    usual, rows = outcome(families, SmootherParameters()), []
    for name, value in constants().items():
        for factor in FACTORS:
            with changed(name, scaled(value, factor)) as parameters:
                found = outcome(families, parameters)
            ratios = {
                key: found.error_mps2[key] / usual.error_mps2[key]
                for key in usual.error_mps2
            }
            mean = float(np.exp(np.mean(np.log(list(ratios.values())))))
            worst = max(ratios, key=lambda key: ratios[key])
            shown = f"{mean:.3f}", f"{ratios[worst]:.2f}", worst, f"{found.within:.3f}"
            rows.append([name, f"x {factor:g}", *shown])
            figures = report.figures.setdefault("constants", {})
            figures[f"{name} x {factor:g}"] = " ".join([*shown[:2], shown[3]])
    report.figures["columns"] = "mean error ratio, worst family's, share within 2 sigma"
    report.figures["within_2_sigma"] = usual.within
    header = ["constant", "", "error ratio", "worst", "family", "within 2 sigma"]
    report.table(f"As they are: {usual.within:.3f} within 2 sigma", header, rows)


def outcome(families: Sequence[Family], parameters: SmootherParameters) -> Outcome:
    """Return errors and coverage."""
    errors, within = {}, []
    for family in families:
        rms = []
        for one in family.recordings:
            track = remove_gravity(one.imu, parameters=parameters)
            found = one.errors_mps2(track.gravity_mps2 / STANDARD_GRAVITY_MPS2)
            sigma = np.asarray(track.gravity_sigma_mps2)[one.scored]
            rms.append(np.sqrt(np.mean(np.square(found))))
            within.append(np.mean(found <= 2.0 * sigma))
        errors[family.key] = float(np.mean(rms))
    return Outcome(errors, float(np.mean(within)))


def modules() -> list[ModuleType]:
    found = pkgutil.iter_modules(smoother.__path__)
    return [importlib.import_module(f"{smoother.__name__}.{m.name}") for m in found]


def constants() -> dict[str, Any]:
    """Return numbers and pairs of numbers by name."""
    usual = SmootherParameters()
    held = {field.name: getattr(usual, field.name) for field in fields(usual)}
    for module in modules():
        held |= {n: v for n, v in vars(module).items() if n.isupper()}
    return {
        name: value
        for name, value in held.items()
        if not any(part in name for part in LEFT_ALONE) and _is_number(value)
    }


def scaled(value: Any, factor: float) -> Any:
    """Return a number or a pair times a factor; counts stay whole."""
    if isinstance(value, tuple):
        return tuple(scaled(one, factor) for one in value)
    return max(1, int(value * factor)) if isinstance(value, int) else value * factor


@contextmanager
def changed(name: str, value: Any) -> Iterator[SmootherParameters]:
    """Change a constant wherever it is used; give the parameters to be used."""
    usual = SmootherParameters()
    if hasattr(usual, name):
        yield replace(usual, **{name: value})
        return
    with ExitStack() as stack:
        for module in modules():
            if hasattr(module, name):
                stack.enter_context(mock.patch.object(module, name, value))
        yield usual


def _is_number(value: Any) -> bool:
    if isinstance(value, tuple):
        return all(map(_is_number, value))
    return isinstance(value, (int, float)) and not isinstance(value, bool)
