"""Damaged files: no crash, no hang, bounded memory, and a mark on what lost pictures.

    python benchmarks/robust.py [--share 1.0] [--seed 0] [--containers mp4 ...] [--again]

1000 seeded mutations of an MP4 and 200 each of MKV, WebM, MOV and AVI are played from
beginning to end in processes of their own. Goes on where it was stopped, unless
`--again`; files that crash or hang are kept in `benchmarks/results/crashers`. Another
`--seed` damages the same clips in other places; its figures have a file of their own.
"""

import argparse
import contextlib
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from common import RESULTS, ROOT, save, table

sys.path.insert(0, str(ROOT / "tests" / "faults"))

import media_cases as cases

PROGRESS = Path(tempfile.gettempdir()) / "hapticplayer-robust.jsonl"
Key = tuple[int, str, int]
CRASHERS = RESULTS / "crashers"
LEAST_MARKED = 0.95


def earlier() -> dict[Key, dict[str, Any]]:
    """Return the outcomes of a run that was stopped."""
    if not PROGRESS.exists():
        return {}
    lines = [json.loads(line) for line in PROGRESS.read_text().splitlines()]
    return {(line["seed"], line["container"], line["number"]): line for line in lines}


def outcomes(
    containers: list[str], share: float, seed: int, known: dict[Key, dict[str, Any]]
) -> Iterator[dict[str, Any]]:
    """Yield what became of each file."""
    with tempfile.TemporaryDirectory() as name, PROGRESS.open("a") as progress:
        for container in containers:
            clip = cases.make_clip(Path(name), container)
            whole = cases.play(clip)[0]
            content, path = clip.read_bytes(), Path(name) / f"damaged.{container}"
            for number in range(round(share * cases.CONTAINERS[container][0])):
                if line := known.get((seed, container, number)):
                    yield line
                    continue
                path.write_bytes(cases.mutation(content, container, number, seed))
                outcome = cases.play_in_child(path)
                line = {"seed": seed, "container": container, "number": number}
                line |= {"whole": whole, **asdict(outcome)}
                progress.write(json.dumps(line) + "\n")
                progress.flush()
                if outcome.kind in ("crashed", "hung"):
                    CRASHERS.mkdir(exist_ok=True)
                    kept = CRASHERS / f"{seed}-{number}.{container}"
                    kept.write_bytes(path.read_bytes())
                yield line


def main() -> int:
    """Play all files and print what became of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--share", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--containers", nargs="+", default=[*cases.CONTAINERS], choices=cases.CONTAINERS
    )
    parser.add_argument("--again", action="store_true", help="forget an earlier run")
    options = parser.parse_args()
    RESULTS.mkdir(exist_ok=True)
    if options.again:
        with contextlib.suppress(FileNotFoundError):
            PROGRESS.unlink()
    rows, figures, is_good = [], {}, True
    known = earlier()
    lines = list(outcomes(options.containers, options.share, options.seed, known))
    for container in options.containers:
        mine = [line for line in lines if line["container"] == container]
        kinds = Counter(line["kind"] for line in mine)
        lossy = [
            line
            for line in mine
            if line["kind"] == "played" and line["pictures"] < line["whole"]
        ]
        marked = sum(line["is_marked"] for line in lossy)
        figures[container] = {
            "files": len(mine),
            **{kind: kinds[kind] for kind in ("played", "refused", "crashed", "hung")},
            "lost pictures": len(lossy),
            "of these marked": marked,
            "unmarked": [line["number"] for line in lossy if not line["is_marked"]],
            "most MB": max(line["extra_bytes"] for line in mine) / 1e6,
            "longest s": max(line["seconds"] for line in mine),
        }
        kept = {k: v for k, v in figures[container].items() if k != "unmarked"}
        rows.append([container, *kept.values()])
        is_good = is_good and not kinds["crashed"] and not kinds["hung"]
        is_good = is_good and figures[container]["most MB"] <= cases.EXTRA_BYTES / 1e6
    header = ["", *[key for key in figures[options.containers[0]] if key != "unmarked"]]
    print(table(header, rows))
    name = f"robust_seed{options.seed}" if options.seed else "robust"
    lost = sum(f["lost pictures"] for f in figures.values())
    told = sum(f["of these marked"] for f in figures.values())
    print(f"marked as damaged: {told} of {lost} files that lost pictures")
    print(f"saved {save(name, figures).name}")
    return 0 if is_good and told >= LEAST_MARKED * lost else 1


if __name__ == "__main__":
    sys.exit(main())
