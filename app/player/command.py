"""A command of the window: a row with name, menu, keys and what it does."""

from collections.abc import Callable, Iterable
from typing import Any, Generic, NamedTuple, TypeVar

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

KEYS = "keys"
"""Name of the table in the settings."""

CONTEXT = "Actions"
"""Of the commands among the translations."""

TIMELINE = "time line"
"""In place of a menu: commands of the editor, whose keys the window may have, too."""

SHARED = {"play": ("Space",), "rearm": ("Ctrl+R",)}
"""Commands that window and editor have with the same keys."""

MOST_KEYS = 8

W = TypeVar("W")


class Command(NamedTuple, Generic[W]):
    """One thing that can be done; `W` is what it is done with, the window.

    Attributes:
        name: of the action and in the settings.
        text: in English; "&" marks the letter in the menu.
        menu: file, edit, playback, view, device or help; or `TIMELINE`.
        group: commands of one group lie together in the menu.
        does: what happens.
        keys: at first.
        toggles: in place of `does`, for what is on or off.
        needs_clip: it is off while no clip is open.
        is_work: it begins a piece of work, so it is off while another one runs.
        is_fixed: it keeps its keys.
    """

    name: str
    text: str
    menu: str
    group: int
    does: Callable[[W], object] | None
    keys: tuple[str, ...] = ()
    toggles: Callable[[W, bool], object] | None = None
    needs_clip: bool = False
    is_work: bool = False
    is_fixed: bool = False

    @property
    def title(self) -> str:
        """Its text in the window's language."""
        return QCoreApplication.translate(CONTEXT, self.text)

    @property
    def plain_title(self) -> str:
        """Its title where it is not in a menu."""
        return self.title.replace("&", "").rstrip("\u2026")

    def keys_in(self, chosen: dict[str, Any]) -> list[QKeySequence]:
        """Its keys; the table of the settings has texts by its name."""
        kept = chosen.get(self.name)
        is_list = isinstance(kept, list) and all(isinstance(key, str) for key in kept)
        texts = kept[:MOST_KEYS] if kept is not None and is_list else self.keys
        if self.is_fixed:
            texts = self.keys
        made = [QKeySequence(text) for text in texts]
        return [key for key in made if not key.isEmpty()]

    def add_action(
        self, chosen: dict[str, Any], target: W, *widgets: QWidget
    ) -> QAction:
        """An action that does it while one of these widgets has the keyboard."""
        action = QAction(self.title, widgets[0])
        action.setShortcuts(self.keys_in(chosen))
        if (does := self.does) is not None:
            action.triggered.connect(lambda: does(target))
        for widget in widgets:
            widget.addAction(action)
        return action

    def meets(self, other: "Command[Any]") -> bool:
        """Whether a key of both would ask for both at once."""
        is_apart = (self.menu == TIMELINE) != (other.menu == TIMELINE)
        return not is_apart or bool(SHARED.keys() & {self.name, other.name})


def owner_of(
    key: QKeySequence,
    wanted_by: Command[Any],
    commands: Iterable[Command[Any]],
    chosen: dict[str, Any],
) -> Command[Any] | None:
    """Another command that has the key where the one that wants it would use it."""
    rivals = (one for one in commands if one.name != wanted_by.name)
    return next(
        (one for one in rivals if one.meets(wanted_by) and key in one.keys_in(chosen)),
        None,
    )
