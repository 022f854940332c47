"""What plays next: a list that a person made, or what lies beside the clip."""

import re
from collections.abc import Callable, Iterable
from enum import Enum
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from hapticplayer.sequence.packed import is_video_name
from hapticplayer.sequence.store import DESCRIPTION

_MOST = 2000
_DIGITS = re.compile(r"(\d+)")


class Repeat(Enum):
    """What happens at the end of a clip."""

    OFF = "off"
    ONE = "one"
    ALL = "all"


def is_playable(path: Path) -> bool:
    """Whether it looks like a sequence or a video; nothing is opened."""
    if path.is_dir():
        return (path / DESCRIPTION).is_file()
    return is_video_name(path) and path.is_file()


def beside(path: Path) -> list[Path]:
    """What can be played in its folder, in the order of file managers."""
    try:
        found = [one for one in path.parent.iterdir() if is_playable(one)][:_MOST]
    except OSError:
        found = []
    return sorted({*found, path}, key=_natural)


def _natural(path: Path) -> list[tuple[int, str]]:
    """Parts of a name so that ride 9 comes before ride 10."""
    parts = _DIGITS.split(path.name.lower())
    return [(int(p), "") if p.isdigit() else (-1, p) for p in parts if p]


class Playlist(QObject):
    """Where in a list of clips the window is.

    Until a person makes a list, it is the folder of the clip that plays, and nothing
    of it follows by itself.
    """

    changed = Signal()

    def __init__(self, open_path: Callable[[Path], None]) -> None:
        super().__init__()
        self._open = open_path
        self.paths: list[Path] = []
        self.current: Path | None = None
        self.is_chosen = False
        self.repeat = Repeat.OFF

    def take(self, paths: Iterable[Path]) -> None:
        """Play these, one after the other."""
        self.set_paths(paths)
        if self.paths:
            self._open(self.paths[0])

    def set_paths(self, paths: Iterable[Path]) -> None:
        """Have another list; what plays plays on."""
        self.paths = list(dict.fromkeys(path.absolute() for path in paths))[:_MOST]
        self.is_chosen = bool(self.paths)
        self.changed.emit()

    def note_opened(self, path: Path) -> None:
        """Another clip plays."""
        self.current = path.absolute()
        if self.current not in self.paths:
            self.is_chosen, self.paths = False, []  # the folder is read when needed
        self.changed.emit()

    def play(self, path: Path) -> None:
        self._open(path)

    def neighbour(self, steps: int) -> Path | None:
        """What lies so many places further on; None beyond the ends."""
        if self.current is None:
            return None
        if not self.is_chosen:
            self.paths = beside(self.current)
        place = self.paths.index(self.current) + steps
        if self.repeat is Repeat.ALL and len(self.paths) > 1:
            place %= len(self.paths)
        return self.paths[place] if 0 <= place < len(self.paths) else None

    def go(self, steps: int) -> bool:
        """Open a neighbour; False where there is none."""
        found = self.neighbour(steps)
        if found is not None:
            self._open(found)
        return found is not None

    def follow_end(self) -> bool:
        """Go on after the end of a clip; False to play the same once more."""
        if self.repeat is Repeat.ONE:
            return False
        if self.is_chosen or self.repeat is Repeat.ALL:
            return self.go(1) or self.repeat is Repeat.OFF
        return True

    def turn_repeat(self) -> Repeat:
        """Off, this clip, all: one after the other."""
        kinds = list(Repeat)
        self.repeat = kinds[(kinds.index(self.repeat) + 1) % len(kinds)]
        self.changed.emit()
        return self.repeat
