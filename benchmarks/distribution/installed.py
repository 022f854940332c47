"""What an installation takes on disk, package by package, without and with each extra.

Counts the files that each distribution lists, with their bytecode, for the program's
own requirements and all that these ask for. Needs an environment that ./test has made.
"""

import argparse
import tomllib
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement

from benchmarks.common import Report
from hapticplayer.installation import EXTRAS, NAME
from hapticplayer.shipped import ROOT

MOST_MB = 600.0
_OWN = ("app", "hapticplayer", "resources", "docs")
_SHOWN_MB = 1.0


def options(parser: argparse.ArgumentParser) -> None:
    """There are none."""


def run(_options: argparse.Namespace, report: Report) -> None:
    """Add up the sizes."""
    sizes = {one: size_mb(one) for one in sorted(closure(NAME, ""))}
    sizes[NAME] = sum(map(_folder_mb, _OWN))
    rows = sorted(sizes.items(), key=lambda row: -row[1])
    small = [size for _, size in rows if size < _SHOWN_MB]
    shown = [[name, f"{size:.1f}"] for name, size in rows if size >= _SHOWN_MB]
    shown.append([f"{len(small)} others", f"{sum(small):.1f}"])
    report.table("Installed, MB", ["package", "MB"], shown, "installed")
    added = {
        extra: sum(size_mb(one) for one in closure(NAME, extra) - set(sizes))
        for extra in EXTRAS
        if all(map(_is_here, EXTRAS[extra].packages.values()))
    }
    texts = [[f"[{name}]", f"{size:.1f}"] for name, size in added.items()]
    report.table("Added by extras, MB", ["extra", "MB"], texts, "extras")
    report.figures |= {"packages_mb": sizes, "extras_mb": added}
    whole = sum(sizes.values())
    report.target("base installation, MB", whole, ("<=", MOST_MB))


def closure(name: str, extra: str) -> set[str]:
    """The distributions that one needs, itself among them."""
    found: set[str] = set()
    waiting = [(name, extra)]
    while waiting:
        name, extra = waiting.pop()
        found.add(_key(name))
        for wanted in map(Requirement, _required(name, extra)):
            marker = wanted.marker
            is_wanted = marker is None or marker.evaluate({"extra": extra})
            if is_wanted and _key(wanted.name) not in found:
                waiting += [(wanted.name, one) for one in (wanted.extras or {""})]
    return found


def _required(name: str, extra: str) -> list[str]:
    """As the source tree says it of the program itself, whatever was installed."""
    if name != NAME:
        return distribution(name).requires or []
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    added = project["optional-dependencies"].get(extra, [])
    return [*project["dependencies"], *added]


def _key(name: str) -> str:
    return name.lower().replace("_", "-")


def size_mb(name: str) -> float:
    one = distribution(name)
    return 1e-6 * sum(_file_bytes(one, str(path)) for path in one.files or ())


def _file_bytes(one: Distribution, path: str) -> int:
    place = Path(str(one.locate_file(path)))
    return place.stat().st_size if place.is_file() else 0


def _folder_mb(name: str) -> float:
    paths = (path for path in (ROOT / name).rglob("*") if path.suffix != ".ts")
    return 1e-6 * sum(path.stat().st_size for path in paths if path.is_file())


def _is_here(name: str) -> bool:
    try:
        distribution(name)
    except ModuleNotFoundError:
        return False
    return True
