"""Simulated sessions of many people: each is written where the study has no others.

A session looks at all others for its order, which takes long beside a thousand of them.
Codes follow from the seed, so that a result can be had again; no file is synced.
"""

import random
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from unittest.mock import patch

from hapticplayer.study.study_folder import SESSIONS, Study, open_study


def write_apart(
    study: Study, writers: Iterable[Callable[[Study], object]], seed: int
) -> None:
    """Add what each writer writes into a copy of the study without sessions."""
    (study.folder / SESSIONS).mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=study.folder.parent) as place, _codes(seed):
        for number, write in enumerate(writers):
            copy = Path(place) / f"{number}"
            without = shutil.ignore_patterns(SESSIONS)
            shutil.copytree(study.folder, copy, ignore=without)
            write(open_study(copy))
            for session in (copy / SESSIONS).iterdir():
                session.rename(study.folder / SESSIONS / session.name)
            shutil.rmtree(copy)


@contextmanager
def _codes(seed: int) -> Iterator[None]:
    chosen = random.Random(seed).choice  # noqa: S311
    with patch("secrets.choice", chosen), patch("os.fsync"):
        yield
