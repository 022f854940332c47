"""Commands of the program as a person types them, and whether they are right."""

import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from benchmarks.common import DATA, ROOT

CASES = DATA / "cases"
CLIP = CASES / "intiface" / "clip.mp4"


class Ran(NamedTuple):
    """A command that has ended."""

    status: int
    out: str
    said: str

    @property
    def short(self) -> str:
        """Status and the last sentence, for a cell of a table."""
        lines = (self.said or self.out).strip().splitlines() or ["nothing said"]
        last = re.sub(r"/(?:[^\s/]+/)+", "", lines[-1].removeprefix("hapticplayer: "))
        return f"{self.status}: {last[:150]}"


class Found(NamedTuple):
    """What was got, and whether it is right."""

    got: str
    is_right: bool


class Row(NamedTuple):
    """An input with its right answer."""

    case: str
    what: str
    right: str
    run: Callable[[Path], Found]
    plays: bool = False


def hapticplayer(*arguments: object, limit_s: float = 120.0) -> Ran:
    """A command of the program, as a person runs it without answering questions."""
    command = [sys.executable, "-m", "app", *map(str, arguments)]
    try:
        done = subprocess.run(
            command,
            cwd=ROOT,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            timeout=limit_s,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Ran(124, "", f"not done within {limit_s:.0f} s")
    return Ran(done.returncode, done.stdout, done.stderr)


def read_as(*answers: str) -> list[str]:
    return [word for answer in answers for word in ("--read-as", answer)]


def says(ran: Ran, *words: str, status: tuple[int, ...] = (1, 2)) -> Found:
    """Whether a command ended with a status and a sentence in which words stand."""
    text = re.sub(r"\S*/\S+", "", ran.out + ran.said).lower()  # no names of files
    is_right = ran.status in status and all(re.search(w, text) for w in words)
    return Found(ran.short, is_right and "traceback" not in text)


def imported(folder: Path, clip: Path, *more: object) -> tuple[Ran, Path]:
    target = folder / "s"
    shutil.rmtree(target, ignore_errors=True)
    return hapticplayer("import", clip, "-o", target, *more), target
