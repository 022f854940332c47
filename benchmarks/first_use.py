"""What the smoother's compiled loops cost at their first use on a machine, and later.

    python benchmarks/first_use.py [--rounds 5]

Each start is a process of its own: numba is imported, then each kernel is compiled into
an empty folder, or loaded from it. s of CPU time, medians; on an idle machine it is what
a person waits.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

from common import ROOT, save, table

START = """
import json, time
import hapticplayer.motion  # numpy and scipy, which every method needs
start = time.process_time()
import numba
from numba.core.registry import cpu_target
cpu_target.typing_context.refresh()
cpu_target.target_context.refresh()
spent = {"numba": time.process_time() - start}
from hapticplayer.motion.smoother import compiled, jit
found = jit.compiled
def compiled_in(*types):
    decorate = found(*types)
    def timed(function):
        begin = time.process_time()
        kernel = decorate(function)
        spent[function.__name__] = time.process_time() - begin
        return kernel
    return timed
jit.compiled = compiled_in
if compiled.fast() is None:
    raise SystemExit("nothing was compiled")
spent["in all"] = time.process_time() - start
print(json.dumps(spent))
"""


def started(folder: str) -> dict[str, float]:
    """Return the seconds that each part of a start takes, with this cache."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", START],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise SystemExit(done.stderr)
    found: dict[str, float] = json.loads(done.stdout)
    return found


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    first, later = [], []
    for _ in range(options.rounds):
        with tempfile.TemporaryDirectory(prefix="hp-numba-") as folder:
            first.append(started(folder))
            later.append(started(folder))
    figures = {
        part: [statistics.median(one[part] for one in held) for held in (first, later)]
        for part in first[0]
    }
    rows = [
        [part, *(f"{seconds:.2f}" for seconds in figures[part])] for part in figures
    ]
    print(table(["s of CPU", "first use", "later"], rows))
    print(save("first_use", {"rounds": options.rounds, "cpu_s": figures}))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
