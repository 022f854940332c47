"""Counts what a successor has to know: the chain, and the core.

    python -m tools.core [--files]

The chain is everything that player, building a sequence, study runner, gravity removal
and Falcon driver import at module level, directly or round a corner. The core is the
engine without `extras`.
"""

import argparse
import ast
from collections import Counter
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROOTS = (
    "hapticplayer.playback.player",
    "hapticplayer.sequence.build",
    "hapticplayer.study.runner",
    "hapticplayer.motion.gravity",
    "hapticplayer.devices.falcon.driver",
)
MOST = {"chain": (195, 32_000), "core": (330, 50_000)}  # files, lines
MOST_LINES = {"engine": 69_000, "window": 21_500, "tests": 61_000}
SHOWN = 12
"""Parts of the chain and of the core that are printed, the largest first."""


@cache
def file_of(module: str) -> Path | None:
    """The source of a module of the engine, None for anything else."""
    place = ROOT.joinpath(*module.split("."))
    for path in (place.with_suffix(".py"), place / "__init__.py"):
        if module.split(".", maxsplit=1)[0] == "hapticplayer" and path.is_file():
            return path
    return None


def imported(statements: Iterable[ast.stmt]) -> Iterator[str]:
    """The names that statements of a module import when they run, with packages."""
    for one in statements:
        if isinstance(one, ast.Import):
            yield from (alias.name for alias in one.names)
        elif isinstance(one, ast.ImportFrom) and one.module:
            yield from (f"{one.module}.{alias.name}" for alias in one.names)
            yield one.module
        elif isinstance(one, ast.If):
            is_for_types = "TYPE_CHECKING" in ast.unparse(one.test)
            yield from imported(one.orelse if is_for_types else one.body + one.orelse)
        elif isinstance(one, (ast.Try, ast.With, ast.ClassDef)):
            yield from imported(one.body)


def closure(roots: Iterable[str]) -> set[Path]:
    """The files that are loaded with some modules."""
    found: set[Path] = set()
    waiting = list(roots)
    while waiting:
        module = waiting.pop()
        path = file_of(module)
        if path is None or path in found:
            continue
        found.add(path)
        waiting += imported(ast.parse(path.read_text(encoding="utf-8")).body)
        waiting.append(module.rpartition(".")[0])  # its package
    return found


def lines_in(paths: Iterable[Path]) -> int:
    """All lines, also blank ones and comments."""
    return sum(path.read_bytes().count(b"\n") for path in paths)


def python_in(folder: str) -> set[Path]:
    return set((ROOT / folder).rglob("*.py"))


def _parts(paths: Iterable[Path]) -> list[tuple[str, int, int]]:
    """Name, files and lines of each room or part of a room."""
    lines: Counter[str] = Counter()
    files: Counter[str] = Counter()
    for path in paths:
        name = "/".join(path.relative_to(ROOT / "hapticplayer").parts[:-1][:2]) or "."
        lines[name] += lines_in([path])
        files[name] += 1
    return [(name, files[name], count) for name, count in lines.most_common()]


def _say_parts(name: str, paths: set[Path], with_files: bool) -> None:
    files, lines = MOST[name]
    print(
        f"{name:<8}{len(paths):4} files {lines_in(paths):7,} lines"
        f"  (at most {files} files, {lines:,} lines)"
    )
    for part, count, size in _parts(paths)[: None if with_files else SHOWN]:
        print(f"    {part:<24}{count:4}  {size:7,}")
    if with_files:
        for size, path in sorted((lines_in([one]), one) for one in paths):
            print(f"    {size:5}  {path.relative_to(ROOT)}")


def main() -> None:
    """Print all figures."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--files", action="store_true", help="list every file")
    options = parser.parse_args()
    engine = python_in("hapticplayer")
    extras = python_in("hapticplayer/extras")
    _say_parts("chain", closure(ROOTS), options.files)
    _say_parts("core", engine - extras, options.files)
    for part, count, size in _parts(extras):
        print(f"extra   {part:<28}{count:4}  {size:7,}")
    for name, folder in (("engine", "hapticplayer"), ("window", "app"), ("tests",) * 2):
        lines = lines_in(python_in(folder))
        print(f"{name:<8}{lines:22,} lines  (at most {MOST_LINES[name]:,})")


if __name__ == "__main__":
    main()
