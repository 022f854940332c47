"""Where rounding hurts: precisions, update forms, condition numbers, invariances.

    python benchmarks/numerics.py [--quick] [--long]

Update forms run in many small filters side by side over 30 s; the smoother is looked
at on the recordings, on simulated rides and in one undivided block of up to ten
hours. `--long` adds 10^7 samples (28 hours at 100 Hz) through the smoother, VQF and
offlineVQF: 5 GB and two minutes. Without `--quick` it writes
benchmarks/results/numerics.json and the marked tables of docs/numerics.md.
"""

import argparse
import sys
from typing import Any

import numpy as np
from common import ROOT, save
from motion import PAGE, on_one_thread, plain
from motion_data import FAMILIES, Family, load_families, missing_data
from motion_document import Document
from numerics_choice import report as report_choice
from numerics_filters import GRAVITY, UPDATES, Array, Assumptions, Run, motion, run
from numerics_invariance import report as report_invariance
from numerics_smoother import (
    by_family,
    by_length,
    collected,
    conditioning,
    last_problem,
    open_loop,
    where_it_breaks,
)

from hapticplayer.model import ImuLog
from hapticplayer.motion import EkfParameters, remove_gravity
from hapticplayer.simulation.rides.motion_scenes import simulate_motion

sys.path.insert(0, str(ROOT / "tests" / "faults"))
from motion_scoring import inclination_deg, vertical
from motion_signal import RATE_HZ, Scene, record

STEPS = 3000
# P g^2 / sigma^2 of the first update: by so much it has to shrink
RATIOS = 10.0 ** np.arange(2, 21)
WRONG_DEG = 0.1
PRECISIONS = {"float32": np.float32, "float64": np.float64}
# rides of each simulated scene that show what the choice does
CHOICE_SEEDS = 6
LENGTHS_S = (60.0, 600.0, 3600.0, 36000.0)
LONG = 10_000_000


def main() -> int:
    """Run what the options ask for."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true", help="a subset, writes nothing")
    parser.add_argument("--long", action="store_true", help="add 10^7 samples")
    options = parser.parse_args()
    missing = missing_data(FAMILIES)
    if missing:
        print(f"not on this machine: {', '.join(missing)}", file=sys.stderr)
        return 2
    on_one_thread()
    document = Document()
    families = load_families(FAMILIES, seeds=1, quick=options.quick)
    figures = {"updates": updates(document), **smoother(families, document, options)}
    if options.long:
        figures["long"] = long_run(document)
    if not options.quick:
        print(save("numerics", plain(figures)))
        print(f"{PAGE}: {', '.join(document.refresh(PAGE))}")
    return 0


def smoother(
    families: list[Family], document: Document, options: argparse.Namespace
) -> dict[str, Any]:
    """Look at the default method's equations and at what it does not depend on."""
    held = [(family.key, family.recordings) for family in families]
    seeds = 1 if options.quick else CHOICE_SEEDS
    more = load_families(FAMILIES, seeds=seeds, quick=options.quick)
    chosen_from = [(family.key, family.recordings) for family in more]
    lengths_s = LENGTHS_S[:2] if options.quick else LENGTHS_S
    longest = simulate_motion("handheld-brisk", 1, duration_s=lengths_s[-1]).imu
    return {
        "condition": by_family(held, document),
        "condition_by_length": by_length(longest, lengths_s, document),
        "band_breaks": where_it_breaks(last_problem(held[0][1][0].imu), document),
        "products": open_loop(document),
        "invariance": report_invariance(held, document),
        "choice": report_choice(chosen_from, document),
    }


def updates(document: Document) -> dict[str, Any]:
    """Find the ratio of prior to measurement at which each update form breaks."""
    data = motion(STEPS, len(RATIOS))
    sigma = RATIOS**-0.25
    believed = Assumptions(
        start_variance=sigma**2 * RATIOS / GRAVITY**2,
        force_sigma_mps2=sigma,
        rate_sigma_radps=np.full(len(RATIOS), 0.005),
        bias_step_radps=np.full(len(RATIOS), 1e-6),
    )
    exact = run(data, believed, UPDATES["sequential"], np.longdouble)
    rows, figures = [], {}
    for precision, dtype in PRECISIONS.items():
        for name, update in UPDATES.items():
            found = run(data, believed, update, dtype)
            broken = _broken(found, exact)
            rows.append([precision, name, *map(_from, broken.values())])
            rows[-1].append(f"{np.nanmax(found.asymmetry[RATIOS <= 1e4]):.0e}")
            figures[f"{precision} {name}"] = {
                key: _first(flags) for key, flags in broken.items()
            }
    document.table(
        "updates",
        f"Ratio of prior to measurement variance from which an update form is off by "
        f"more than {WRONG_DEG} deg, has lost a positive P, or is NaN within {STEPS} "
        "samples; and the asymmetry of P up to 1e4",
        [
            "precision",
            "update",
            "off from",
            "indefinite from",
            "NaN from",
            "|P - P'|/|P|",
        ],
        rows,
    )
    usual = EkfParameters()
    variance = usual.accelerometer_noise_mps2_rthz**2 * RATE_HZ
    ratio = (GRAVITY * usual.start_inclination_sigma_rad) ** 2 / variance
    print(f"the ekf (sequential, float64) starts at {ratio:.1g} at {RATE_HZ:g} Hz")
    return figures


def _broken(found: Run, exact: Run) -> dict[str, Array]:
    """Return what is wrong with each filter, (M,) flags by name."""
    late = slice(STEPS // 2, None)
    apart = np.stack(
        [
            inclination_deg(found.up[late, k], exact.up[late, k])
            for k in range(len(RATIOS))
        ],
        axis=1,
    )
    with np.errstate(invalid="ignore"):
        off = ~(np.sqrt(np.mean(apart**2, axis=0)) <= WRONG_DEG)
        # just below zero is the rounding of the eigenvalues themselves
        indefinite = found.least < -1e-15
    dead = ~np.isfinite(found.up[-1]).all(axis=1)
    return {"off": off, "indefinite": indefinite, "nan": dead}


def _first(flags: Array) -> float | None:
    return float(RATIOS[int(np.argmax(flags))]) if flags.any() else None


def _from(flags: Array) -> str:
    first = _first(flags)
    return f"> {RATIOS[-1]:.0e}" if first is None else f"{first:.0e}"


def long_run(document: Document) -> dict[str, Any]:
    """Process 10^7 samples; the error at the start, in the middle and at the end."""
    raw = record(
        Scene(time_s=np.arange(LONG) / RATE_HZ, gyro_bias_radps=(0.01, -0.006, 0.008))
    )
    log = ImuLog(raw.time_s, raw.force, raw.rate, source="28 hours")
    with collected() as problems:
        q = {"smoother": remove_gravity(log).quaternion_wxyz}
    # an odd stride, or it would meet only first solutions of blocks, or only last ones
    stride = max(1, len(problems) // 40) | 1
    conditions = [conditioning(one) for one in problems[::stride]]
    q |= _packaged(raw.rate, raw.force)
    ends = [slice(0, LONG // 100), slice(LONG // 2, LONG // 2 + LONG // 100)]
    ends.append(slice(LONG - LONG // 100, LONG))
    rows: list[list[str]] = []
    figures: dict[str, Any] = {}
    for name, found in q.items():
        errors = [
            float(np.sqrt(np.mean(inclination_deg(vertical(found[e]), raw.up[e]) ** 2)))
            for e in ends
        ]
        norm = float(np.abs(np.linalg.norm(found, axis=1) - 1.0).max())
        rows.append([name, *(f"{error:.3f}" for error in errors), f"{norm:.0e}"])
        figures[name] = {"inclination_deg": errors, "norm_error": norm}
    document.table(
        "long",
        f"{LONG:.0e} samples at {RATE_HZ:g} Hz: RMS inclination error of the first, "
        "middle and last hundredth, deg, and the largest error of a quaternion's norm",
        ["method", "first", "middle", "last", "norm"],
        rows,
    )
    scaled = [one.band_scaled for one in conditions]
    calibrations = [one.calibration for one in conditions]
    print(
        f"smoother, {len(problems)} solutions, every {stride}th looked at: "
        f"condition of the scaled band {min(scaled):.0e} to {max(scaled):.0e}, of the "
        f"calibration {min(calibrations):.0e} to {max(calibrations):.0e}"
    )
    figures["band_scaled"] = [min(scaled), max(scaled)]
    figures["calibration_scaled"] = [min(calibrations), max(calibrations)]
    return figures


def _packaged(rate: Array, force: Array) -> dict[str, Array]:
    import vqf

    causal = vqf.VQF(1.0 / RATE_HZ).updateBatch(rate, force)
    return {
        "VQF": np.asarray(causal["quat6D"]),
        "offlineVQF": np.asarray(
            vqf.offlineVQF(rate, force, None, 1.0 / RATE_HZ)["quat6D"]
        ),
    }


if __name__ == "__main__":
    sys.exit(main())
