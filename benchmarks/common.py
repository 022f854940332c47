"""The command line, rounds, tables and results of every benchmark.

A folder of benchmarks has one command: `python -m benchmarks.FOLDER NAME [options]`
runs one, `python -m benchmarks.FOLDER --quick` the short form of all. A benchmark is a
module with a docstring, `options(parser)` and `run(options, report)`, or, of a module with
several, `NAME(options, report)` with a docstring and `NAME_options(parser)`.
"""

import argparse
import ast
import importlib
import json
import os
import platform
import shlex
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks" / "results"
DATA = ROOT.parent / "shared" / "data"
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
T = TypeVar("T")


def command(folder: str, text: str, places: Mapping[str, str]) -> int:
    """Run what the command line of a folder asks for; return the exit status.

    Args:
        folder: its name below `benchmarks`.
        text: what it is about.
        places: module below `benchmarks` of each benchmark, such as `motion.budget`, or
            `campaigns:stress` of a module with several.
    """
    package = f"benchmarks.{folder}"
    if len(sys.argv) > 1 and sys.argv[1] in places:
        return _run(package, sys.argv[1], places[sys.argv[1]], sys.argv[2:])
    summaries = {name: _summary(place) for name, place in places.items()}
    listed = "\n".join(f"  {name:12} {line}" for name, line in summaries.items())
    parser = argparse.ArgumentParser(
        prog=f"python -m {package}",
        usage=f"python -m {package} NAME [--help] [options]\n"
        f"       python -m {package} --quick",
        description=f"{text}\n\nbenchmarks:\n{listed}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--quick", action="store_true", help="short form of all")
    if len(sys.argv) == 1:
        parser.print_help()
        return 2
    parser.parse_args()
    failed = []
    for name, summary in summaries.items():
        print(f"\n== {name}: {summary}", flush=True)
        one = [sys.executable, "-m", package, name, "--quick"]
        if subprocess.run(one, cwd=ROOT, check=False).returncode:
            failed.append(name)
    done = len(places) - len(failed)
    print(f"\n{done} of {len(places)} done with all targets met")
    if failed:
        print(f"missed or failed: {', '.join(failed)}")
    return int(bool(failed))


def _summary(place: str) -> str:
    """Return the first line of a benchmark's docstring, without importing it."""
    module, _, name = place.partition(":")
    source = (ROOT / "benchmarks" / module.replace(".", "/")).with_suffix(".py")
    tree: ast.Module | ast.FunctionDef = ast.parse(source.read_text(encoding="utf-8"))
    if name:
        found = (n for n in tree.body if isinstance(n, ast.FunctionDef))
        tree = next(n for n in found if n.name == name)
    return (ast.get_docstring(tree) or "").partition("\n")[0]


def _run(package: str, name: str, place: str, arguments: list[str]) -> int:
    module_name, _, function = place.partition(":")
    module = importlib.import_module(f"benchmarks.{module_name}")
    run = getattr(module, function or "run")
    output = argparse.ArgumentParser(add_help=False)
    output.add_argument(
        "--output", type=Path, help="folder for the result (benchmarks/results)"
    )
    _, kept = output.parse_known_args(arguments)  # a path of this machine tells nobody
    parser = argparse.ArgumentParser(
        prog=f"python -m {package} {name}",
        description=run.__doc__ if function else module.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        parents=[output],
    )
    parser.add_argument("--quick", action="store_true", help="short form, not saved")
    getattr(module, f"{function}_options" if function else "options")(parser)
    options = parser.parse_args(arguments)
    report = Report(name, f"python -m {package} {shlex.join([name, *kept])}")
    run(options, report)
    folder = options.output or (None if options.quick else RESULTS)
    return report.finish(folder)


@dataclass
class Report:
    """What a benchmark has found.

    Attributes:
        name: of its result file.
        command: that was typed.
        figures: for the result file, next to the targets.
        targets: what was asked of which figure, and whether it was met.
        tables: those that documents show, by name: a header and rows.
    """

    name: str
    command: str = ""
    figures: dict[str, Any] = field(default_factory=dict)
    targets: list[dict[str, Any]] = field(default_factory=list)
    tables: dict[str, list[list[str]]] = field(default_factory=dict)

    def table(
        self,
        title: str,
        header: Sequence[str],
        rows: Sequence[Iterable[Any]],
        mark: str = "",
    ) -> None:
        """Print a table.

        Args:
            title: above it.
            header: names of the columns.
            rows: of cells.
            mark: its name in the result, for documents.
        """
        texts = [[_cell(cell) for cell in row] for row in rows]
        print(f"\n{title}\n{table(list(header), texts)}", flush=True)
        if mark:
            self.tables[mark] = [list(header), *texts]

    def target(self, what: str, value: float, bound: tuple[str, float]) -> None:
        """Note what is asked of a figure: `("<=", 0.9)` or `(">=", 3)`."""
        sign, limit = bound
        is_met = value <= limit if sign == "<=" else value >= limit
        entry = {"what": what, "measured": value, "target": f"{sign} {limit:g}"}
        self.targets.append({**entry, "met": bool(is_met)})

    def finish(self, folder: Path | None) -> int:
        """Print which targets are met and save the result; return the exit status."""
        missed = [one for one in self.targets if not one["met"]]
        shown = self.targets if len(self.targets) <= 20 else missed
        if shown:
            words = ("target missed", "target met")
            self.table(
                "Targets",
                ["what", "measured", "target", ""],
                [[*list(one.values())[:3], words[one["met"]]] for one in shown],
            )
        if self.targets:
            print(f"{len(self.targets) - len(missed)} of {len(self.targets)} met")
        if folder is not None:
            print(f"saved {self.save(folder)}")
        return int(bool(missed))

    def save(self, folder: Path) -> Path:
        """Write figures and targets with machine, date, command and commit."""
        folder.mkdir(parents=True, exist_ok=True)
        git = ["git", "rev-parse", "--short", "HEAD"]
        done = subprocess.run(
            git, cwd=ROOT, capture_output=True, text=True, check=False
        )
        content = {
            "command": self.command,
            "date": time.strftime("%Y-%m-%d"),
            "commit": done.stdout.strip(),
            "machine": machine(),
            "targets": self.targets,
            **self.figures,
            **({"tables": self.tables} if self.tables else {}),
        }
        path = folder / f"{self.name}.json"
        path.write_text(json.dumps(plain(content), indent=1) + "\n", encoding="utf-8")
        return path


def machine() -> dict[str, Any]:
    """The things that figures depend on."""
    lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    named = [line.partition(":")[2] for line in lines if line.startswith("model name")]
    return {
        "processor": named[0].strip() if named else platform.machine(),
        "cores": os.cpu_count(),
        "kernel": platform.release(),
        "python": platform.python_version(),
        "load": round(os.getloadavg()[1], 1),
    }


def saved(name: str) -> dict[str, Any]:
    """Return the result of an earlier run, empty without one."""
    path = RESULTS / f"{name}.json"
    return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else {}


def plain(value: Any) -> Any:
    """Return figures with four digits; null for NaN and infinity, which JSON lacks."""
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, Sequence | np.ndarray) and not isinstance(value, str):
        return [plain(item) for item in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.4g}") if np.isfinite(value) else None
    return int(value) if isinstance(value, np.integer) else value


def table(header: list[str], rows: list[list[Any]]) -> str:
    """Return a plain text table."""
    cells = [header, *[[_cell(value) for value in row] for row in rows]]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    lines = [
        "  ".join(c.rjust(w) for c, w in zip(row, widths, strict=True)) for row in cells
    ]
    return "\n".join([lines[0], "-" * len(lines[0]), *lines[1:]])


def _cell(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def interleaved(
    contenders: Mapping[str, Callable[[], T]], rounds: int, *, warm_up: bool = False
) -> dict[str, list[T]]:
    """Run all contenders in each round, each round beginning with another one.

    Args:
        contenders: by name.
        rounds: how many.
        warm_up: whether each also runs before, without a result.
    """
    names = list(contenders)
    found: dict[str, list[T]] = {name: [] for name in names}
    for name in names if warm_up else ():
        contenders[name]()
    for number in range(rounds):
        first = number % len(names)
        for name in names[first:] + names[:first]:
            found[name].append(contenders[name]())
        if sys.stderr.isatty():
            print(f"\rround {number + 1} of {rounds}", end="\n", file=sys.stderr)
    return found


class Ratio(NamedTuple):
    """Ratios of two contenders round by round: median, least and largest."""

    median: float
    least: float
    largest: float


def ratio(values: Sequence[float], reference: Sequence[float]) -> Ratio:
    """Return how a contender compares to another one in the same rounds."""
    each = [a / b if b else np.nan for a, b in zip(values, reference, strict=True)]
    return Ratio(statistics.median(each), min(each), max(each))


def medians(rounds: Sequence[Mapping[str, float]]) -> dict[str, float]:
    keys = [k for k in rounds[0] if all(k in one for one in rounds)]
    return {k: float(statistics.median(one[k] for one in rounds)) for k in keys}


def on_one_thread() -> None:
    """Start again where numpy might use several threads: it reads this once."""
    if any(os.environ.get(name) != "1" for name in _THREADS):
        environment = {**os.environ, **dict.fromkeys(_THREADS, "1")}
        sys.stdout.flush()
        arguments = [sys.executable, *sys.orig_argv[1:]]
        os.execve(sys.executable, arguments, environment)  # noqa: S606


def positive(text: str) -> int:
    """A number of repetitions, for `argparse`."""
    if (number := int(text)) < 1:
        raise ValueError(text)
    return number


def rms(values: Any) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
