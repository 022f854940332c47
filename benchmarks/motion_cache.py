"""What the cache of gravity removal saves, and what it costs: without, miss, hit.

    python benchmarks/motion_cache.py [--minutes 5]

us per sample, medians over interleaved rounds, in a folder of its own.
"""

import argparse
import statistics
import tempfile
import time
from pathlib import Path

import numpy as np
from common import save, table

from hapticplayer.model import ImuLog
from hapticplayer.sequence.motion_cache import MotionCache
from hapticplayer.sequence.processing import Processed, Processing, process_motion
from hapticplayer.simulation.rides.motion_scenes import simulate_motion

ROUNDS = 5


def timed(
    imu: ImuLog, processing: Processing, cache: MotionCache | None
) -> tuple[float, Processed]:
    """Return how long it takes, s, and what it returns."""
    start = time.perf_counter()
    done = process_motion(imu, processing, cache)
    return time.perf_counter() - start, done


def measured(imu: ImuLog, method: str) -> dict[str, float]:
    """Return us per sample for each case; the three tracks must be the same."""
    rounds: dict[str, list[float]] = {"without": [], "miss": [], "hit": []}
    for _ in range(ROUNDS):
        with tempfile.TemporaryDirectory(prefix="hp-cache-") as folder:
            cache = MotionCache(Path(folder))
            tracks = []
            for case, spent in rounds.items():
                used = None if case == "without" else cache
                seconds, done = timed(imu, Processing(method=method), used)
                if done.is_cached is not (case == "hit"):
                    raise SystemExit(f"the cache did not answer as it should: {case}")
                spent.append(1e6 * seconds / len(imu))
                tracks.append(done.track.acceleration_mps2)
        if not all(np.array_equal(tracks[0], track) for track in tracks):
            raise SystemExit("the cache changes the result")
    return {case: statistics.median(values) for case, values in rounds.items()}


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=5.0)
    options = parser.parse_args()
    imu = simulate_motion("walk", 1, duration_s=60.0 * options.minutes).imu
    found = {method: measured(imu, method) for method in ("smoother", "ekf")}
    rows = [[method, *cases.values()] for method, cases in found.items()]
    print(table(["us/sample", "without", "miss", "hit"], rows))
    print(save("motion_cache", {"samples": len(imu), "us_per_sample": found}))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
