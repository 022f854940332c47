"""Compiled loops and plain numpy give one result; without the one the other works."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.model import ImuLog
from hapticplayer.motion import SmootherParameters, analyse, estimate_orientation
from hapticplayer.motion.smoother import compiled
from hapticplayer.simulation.rides.motion_scenes import simulate_motion
from tests.unit.motion.smoother.conftest import TIME_S, UP_1_G, WOBBLE, Motion

pytest.importorskip("numba")

# Sums in another order; the worst of all recordings differs by 4e-10 m/s^2.
SAME = 5e-9
# The uncertainty comes from the difference of two solutions.
SIGMA_SAME_MPS2 = 1e-6


@pytest.fixture
def both(monkeypatch):
    """Return a function that gives what a call returns compiled, and in numpy."""

    def run(call):
        found = []
        for state in ("on", "off"):
            monkeypatch.setenv(compiled.SWITCH, state)
            compiled.fast.cache_clear()
            assert (compiled.fast() is not None) == (state == "on")
            found.append(call())
        return found

    yield run
    monkeypatch.undo()
    compiled.fast.cache_clear()


def assert_same(both, log: ImuLog, parameters: SmootherParameters | None = None):
    one, other = both(lambda: analyse(log, parameters=parameters))
    for name, limit in (
        ("acceleration_mps2", SAME),
        ("gravity_mps2", SAME),
        ("quaternion_wxyz", SAME),
        ("gravity_sigma_mps2", SIGMA_SAME_MPS2),
    ):
        apart = np.abs(getattr(one.track, name) - getattr(other.track, name)).max()
        assert apart < limit, name
    assert (one.track.valid == other.track.valid).all()
    for name, value in one.summary.items():
        if value is not None and not isinstance(value, str):
            apart = np.abs(np.subtract(value, other.summary[name])).max()
            assert apart < 1e-4, name
        else:
            assert value == other.summary[name], name


def spin(rate_radps: float) -> Motion:
    """Return a steady turn about an axis that leans."""
    axis = np.array([0.6, 0.0, 0.8])
    return Motion(lambda t: Rotation.from_rotvec(rate_radps * np.outer(t, axis)))


def resting(log: ImuLog, stop: int) -> ImuLog:
    """Return the log with a still start, its gyro and accelerometer off a little."""
    force, rate = log.specific_force_mps2.copy(), log.angular_rate_radps.copy()
    force[:stop], rate[:stop] = 1.02 * force[stop], 0.0
    rate += np.array([0.01, -0.03, 0.02])
    return replace(log, specific_force_mps2=force, angular_rate_radps=rate)


def without(log: ImuLog, start: int, stop: int) -> ImuLog:
    keep = np.r_[:start, stop : len(log)]
    return ImuLog(
        log.time_s[keep],
        log.specific_force_mps2[keep],
        log.angular_rate_radps[keep],
        sampling=log.sampling,
    )


def clipped(log: ImuLog) -> ImuLog:
    rate = np.clip(log.angular_rate_radps, -np.radians(125.0), np.radians(125.0))
    return replace(log, angular_rate_radps=rate)


CASES = {
    "instant": lambda: WOBBLE.instant(TIME_S),
    "averaged": lambda: WOBBLE.averaged(1201, 1.0 / 30.0),
    "a handful of samples": lambda: WOBBLE.instant(TIME_S[:37]),
    "two samples": lambda: WOBBLE.instant(TIME_S[:2]),
    "a hole of two seconds": lambda: without(WOBBLE.instant(TIME_S), 2000, 2200),
    "a hole, averaged": lambda: without(WOBBLE.averaged(1201, 1 / 30), 400, 460),
    "lost samples": lambda: without(WOBBLE.instant(TIME_S), 3000, 3003),
    "clipped": lambda: clipped(WOBBLE.instant(TIME_S)),
    "a still start": lambda: resting(WOBBLE.instant(TIME_S), 1500),
    "turns of more than a radian to a window": lambda: spin(25.0).instant(TIME_S),
    "the same, averaged": lambda: spin(25.0).averaged(1000, 1.0 / 30.0),
    "hardly a turn": lambda: spin(0.003).instant(TIME_S),
    "upside down": lambda: ImuLog(
        TIME_S, np.tile(-UP_1_G, (len(TIME_S), 1)), np.zeros((len(TIME_S), 3))
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_both_ways_give_the_same(both, case):
    assert_same(both, CASES[case]())


@pytest.mark.parametrize("sensor", ["camera", "paper-board"])
@pytest.mark.parametrize("scene", ["car-brisk", "handheld-brisk"])
def test_both_ways_give_the_same_on_simulated_rides(both, scene, sensor):
    assert_same(both, simulate_motion(scene, 1, duration_s=90.0, sensor=sensor).imu)


def test_compiled_and_numpy_agree_in_blocks(both):
    parameters = SmootherParameters(block_s=30.0, margin_s=8.0, time_constant_s=12.0)
    assert_same(both, WOBBLE.instant(TIME_S), parameters)


@pytest.mark.parametrize("name", ["broad_15", "tumvi_room4", "tyrex_Guillaume"])
def test_both_ways_give_the_same_on_recordings(both, shared_data, name):
    folder = shared_data / "orientation" / "native"
    with np.load(min(folder.glob(f"{name}*.npz"))) as held:
        count = min(len(held["acc"]), 20000)
        time_s = held["t"] if "t" in held else np.arange(count) / held["rate"]
        log = ImuLog(
            np.asarray(time_s[:count], float) - time_s[0],
            held["acc"][:count].astype(float),
            held["gyr"][:count].astype(float),
        )
    assert_same(both, log)


def test_the_orientation_alone_is_the_same_too(both):
    one, other = both(lambda: estimate_orientation(WOBBLE.instant(TIME_S)))
    assert np.abs(one - other).max() < SAME


# --- where numba may be, and where it is missing ------------------------------

REMOVE = """
import sys, json, numpy as np
import hapticplayer.motion as motion
from hapticplayer.model import ImuLog
with_the_room = sorted({"numba", "llvmlite"} & set(sys.modules))
t = np.arange(400) / 100.0
log = ImuLog(t, np.tile([0.0, 0.1, 9.8], (400, 1)), np.tile([0.0, 0.2, 0.0], (400, 1)))
track = motion.remove_gravity(log, sys.argv[1])
assert np.isfinite(track.acceleration_mps2).all()
from hapticplayer.motion.smoother import compiled
fast = compiled.fast() if "numba" in sys.modules else None
stats = [] if fast is None else [
    one.stats.cache_misses
    for module in (fast.kernels, fast.solver_kernel)
    for one in vars(module).values()
    if hasattr(one, "stats")
]
print(json.dumps({
    "with_the_room": with_the_room,
    "numba": sys.modules.get("numba") is not None,
    "compiled": fast is not None,
    "kernels": len(stats),
    "misses": sum(map(len, stats)),
    "sum": float(track.acceleration_mps2.sum()),
}))
"""


def started(before: str = "", method: str = "smoother", **environment: str) -> dict:
    """Return what a fresh process that removes gravity says."""
    code = f"{before}\n{REMOVE}"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code, method],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, compiled.SWITCH: "on", **environment},
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_the_first_use_imports_numba_and_the_room_alone_does_not():
    found = started()
    assert found["compiled"]
    assert found["with_the_room"] == []


def test_other_methods_do_without_numba():
    assert not started(method="lowpass")["numba"]


def test_a_person_can_switch_it_off():
    assert not started(**{compiled.SWITCH: "off"})["numba"]


@pytest.mark.parametrize(
    "missing",
    [
        "import sys; sys.modules['numba'] = None",
        "from numba.core import caching; caching.CacheImpl._locator_classes = []",
    ],
    ids=["no numba", "nowhere to keep what was compiled"],
)
def test_without_it_numpy_does_the_same(missing):
    found = started(missing)
    assert not found["compiled"]
    assert found["sum"] == pytest.approx(started()["sum"], abs=1e-6)


def test_the_compiler_spares_what_no_kernel_needs():
    """That is the first use on a machine; what it spares must be known to numba."""
    import numba

    from hapticplayer.motion.smoother import jit

    def passes(kernel):
        kernel.compile((numba.float64,))
        (done,) = kernel.overloads.values()
        return done.metadata["pipeline_times"]["nopython"]

    def twice(x):
        return 2.0 * x

    usual, ours = passes(numba.njit(twice)), passes(jit.inner(twice))
    assert len(usual) - len(ours) >= len(jit._SPARED)


def test_the_second_start_compiles_nothing(tmp_path):
    first = started(NUMBA_CACHE_DIR=str(tmp_path))
    assert first["compiled"]
    assert first["misses"] == first["kernels"] > 5
    assert started(NUMBA_CACHE_DIR=str(tmp_path))["misses"] == 0
    for path in tmp_path.rglob("*.nbi"):
        path.write_bytes(b"broken")
    broken = started(NUMBA_CACHE_DIR=str(tmp_path))
    assert broken["sum"] == pytest.approx(first["sum"], abs=1e-6)
