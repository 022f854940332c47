"""Units are recognised from how gravity looks and turns."""

import re

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion.repair.timestamps import repair_times
from hapticplayer.motion.repair.units import (
    calm_norm,
    check_force_unit,
)

T = np.arange(0, 20, 0.01)


def named_factor(refused) -> float:
    """The number that a remedy says to multiply or divide by."""
    how, number = re.search(
        r"(multiply|divide) \S+ by ([\d.]*\d)", str(refused.value)
    ).groups()
    return float(number) if how == "multiply" else 1.0 / float(number)


def still(rng):
    return [0.0, 3.0, 9.3] + 0.02 * rng.standard_normal((len(T), 3))


@pytest.mark.parametrize(
    ("factor", "remedy"),
    [
        (1 / STANDARD_GRAVITY_MPS2, r"in g: multiply it by 9\.80665"),
        (1000 / STANDARD_GRAVITY_MPS2, r"milli-g: multiply it by 0\.00980665"),
        (0.2, "if it is in g.*removed already"),
        (0.02, "gravity seems to be removed already"),
        (5.0, r"give the specific force in m/s\^2"),
    ],
)
def test_a_force_in_another_unit_is_refused_with_the_factor(swing, factor, remedy):
    log, _ = swing
    check_force_unit(log.time_s, log.specific_force_mps2)
    given = factor * log.specific_force_mps2
    with pytest.raises(InputError, match=remedy) as refused:
        check_force_unit(log.time_s, given)
    if "multiply" in remedy and "removed" not in remedy:
        check_force_unit(log.time_s, named_factor(refused) * given)


def test_gravity_of_981_is_not_taken_for_milli_g(rng):
    force = still(rng)
    with pytest.raises(InputError, match=r"in cm/s\^2: multiply it by 0\.01"):
        check_force_unit(T, 100.0 * force)


def test_the_calm_norm_looks_past_free_fall_and_shaking(rng):
    force = still(rng)
    force[300:900] = 0.02 * rng.standard_normal((600, 3))
    force[1000:1400] += 30.0 * rng.standard_normal((400, 3))
    true = np.hypot(3.0, 9.3)
    assert calm_norm(T, force) == pytest.approx(true, abs=0.01)


@pytest.mark.parametrize("per_s", [1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9])
def test_the_number_that_is_named_makes_seconds_of_times(swing, per_s):
    log, _ = swing
    given = per_s * log.time_s
    with pytest.raises(InputError, match=r"(divide|multiply) time_s") as refused:
        repair_times(given.copy(), [])
    line = repair_times(named_factor(refused) * given, [])
    np.testing.assert_allclose(line.time_s, log.time_s, atol=1e-6)


def test_real_recordings_pass_and_are_refused_in_g(shared_data):
    paths = sorted((shared_data / "orientation" / "native").glob("*.npz"))
    assert len(paths) >= 10
    for path in paths:
        with np.load(path) as data:
            force = data["acc"].astype(float)
            time_s = np.arange(len(force)) / float(data["rate"])
        check_force_unit(time_s, force, path.stem)
        with pytest.raises(InputError, match="in g"):
            check_force_unit(time_s, force / STANDARD_GRAVITY_MPS2, path.stem)
