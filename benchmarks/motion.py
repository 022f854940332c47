"""Gravity removal: error, run time, both against each other, and what is skipped.

    python benchmarks/motion.py [--quick] [--families broad,tumvi] [--seeds 3]

Everything stands beside offlineVQF in the same run, on one thread. `--quick` takes a
named subset (motion_data.py), leaves out the picture and writes nothing unless told
where. A whole run takes about fifteen minutes; it writes docs/motion-pareto.svg and .png,
benchmarks/results/motion.json and the marked tables of docs/numerics.md, or picture
and figures into `--output`.
"""

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import motion_accuracy as accuracy
import motion_pareto as pareto
import motion_picture as picture
import motion_sigma as sigma
import motion_skips as skips
import motion_time as timing
import numpy as np
from common import ROOT, save
from motion_data import (
    AVERAGED,
    FAMILIES,
    NATIVE,
    OPTICAL,
    load_families,
    missing_data,
)
from motion_document import Document

from hapticplayer.motion import DEFAULT_METHOD, METHODS

PAGE = ROOT / "docs" / "numerics.md"
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
_QUICK_ROUNDS = 3
_SMALL = [f"{name} {rate}" for rate in (NATIVE, AVERAGED) for name in OPTICAL]


def main() -> int:
    """Measure what the options ask for."""
    options = _options()
    missing = missing_data(options.families)
    if missing:
        print(
            "these recordings are not on this machine, so nothing is measured: "
            f"{', '.join(missing)} (--families sim-car,sim-people needs none)",
            file=sys.stderr,
        )
        return 2
    on_one_thread()
    families = load_families(options.families, options.seeds, quick=options.quick)
    rounds = _QUICK_ROUNDS if options.quick else timing.ROUNDS
    lengths_s = timing.LENGTHS_S[:2] if options.quick else timing.LENGTHS_S
    scores = accuracy.measure(families, list(METHODS))
    whole = not options.quick
    rides = sigma.many_rides(options.families, options.sigma_seeds) if whole else {}
    document = Document()
    figures: dict[str, Any] = {
        "default": DEFAULT_METHOD,
        "seeds": options.seeds,
        "accuracy": accuracy.report(families, scores, document, whole=whole),
        "sigma": sigma.report(scores, rides, document, whole=whole),
        "run_time": timing.by_family(families, rounds, document),
        "length": timing.by_length(lengths_s, rounds, document),
        "resident": timing.resident(lengths_s[-2]),
        "skips": skips.report(families, rounds, document, quick=options.quick),
    }
    chosen = pareto.settings(quick=options.quick)
    panels = pareto.measure(families, chosen, rounds)
    figures["pareto"] = pareto.report(panels, document)
    _write(options, panels, figures, document)
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true", help="a subset, half a minute")
    parser.add_argument("--seeds", type=int, default=3, help="rides of a scene")
    parser.add_argument(
        "--sigma-seeds", type=int, default=24, help="the same to judge sigma by"
    )
    parser.add_argument("--families", type=_families, default=list(FAMILIES))
    parser.add_argument("--no-picture", action="store_true", help="figures only")
    parser.add_argument("--output", type=Path, help="folder for all that is written")
    return parser.parse_args()


def _families(text: str) -> list[str]:
    names = text.split(",")
    unknown = set(names) - set(FAMILIES)
    if unknown:
        raise argparse.ArgumentTypeError(
            f"no family {', '.join(sorted(unknown))}; choose of {','.join(FAMILIES)}"
        )
    return names


def on_one_thread() -> None:
    """Start again where a library might use several threads: they read this once."""
    if any(os.environ.get(name) != "1" for name in _THREADS):
        environment = {**os.environ, **dict.fromkeys(_THREADS, "1")}
        sys.stdout.flush()
        os.execve(sys.executable, [sys.executable, *sys.argv], environment)  # noqa: S606


def _write(
    options: argparse.Namespace,
    panels: dict[str, list[pareto.Point]],
    figures: dict[str, Any],
    document: Document,
) -> None:
    """Write picture and figures, a part of the families only where it was asked for."""
    output: Path | None = options.output
    part = options.quick or set(options.families) != set(FAMILIES)
    if output is None and part:
        print("\nA part of the whole: nothing is written without --output.")
        return
    if output is not None:
        output.mkdir(parents=True, exist_ok=True)
    if not options.no_picture:
        for path in _draw(output or ROOT / "docs", panels):
            print(f"\ndrew {path}, {path.stat().st_size / 1000:.0f} kB")
    if output is None:
        print(save("motion", plain(figures)))
        print(f"{PAGE}: {', '.join(document.refresh(PAGE))}")
        return
    path = output / "motion.json"
    path.write_text(json.dumps(plain(figures), indent=2) + "\n")
    print(path)


def _draw(folder: Path, panels: dict[str, list[pareto.Point]]) -> list[Path]:
    small = [key for key in _SMALL if key in panels] or list(panels)
    large = small + [key for key in panels if key not in small]
    sheets = (
        picture.Sheet(folder / "motion-pareto.svg", large, 1200, detailed=True),
        picture.Sheet(folder / "motion-pareto.png", small, 900, detailed=False),
    )
    return [picture.draw(sheet, panels) for sheet in sheets]


def plain(value: Any) -> Any:
    """Return figures with four digits, and null for NaN, which JSON does not know."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [plain(item) for item in value]
    if isinstance(value, float):
        return None if np.isnan(value) else float(f"{value:.4g}")
    return value


if __name__ == "__main__":
    sys.exit(main())
