"""The built-in demo, made on first use in the cache of the user."""

import shutil
from pathlib import Path
from typing import NamedTuple

from hapticplayer import __version__, extension, storage
from hapticplayer.errors import InputError, Progress, SequenceError, no_progress
from hapticplayer.sequence.store import open_sequence


class Demo(NamedTuple):
    """A sequence that an extra makes.

    Attributes:
        name: of the scenario.
        home: "module:function", called with name, new folder and `progress`.
    """

    name: str
    home: str


def demo_folder(progress: Progress = no_progress) -> Path:
    """The folder of the demo."""
    target = storage.cache_root() / f"demo-{__version__}"
    try:
        open_sequence(target)
    except SequenceError:
        if target.exists():  # of an interrupted disk
            shutil.rmtree(target)
        demo = next(extension.rows("demos", Demo), None)
        if demo is None:
            raise SequenceError(
                "this installation has no demo; open a sequence or a video instead"
            ) from None
        try:
            extension.load(demo.home)(demo.name, target, progress=progress)
        except InputError:
            open_sequence(target)  # another process made it meanwhile
    return target
