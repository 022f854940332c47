"""The effects that are being edited, with undo and redo without limit."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from app.editor.edits import changed_number
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList

_NO_GESTURE = -1  # Qt's number of a command that is never merged


class Document(QObject):
    """A list of effects of which one may be selected.

    Changes of one gesture, such as a drag, become one step; a gesture that leads back to
    where it began leaves none.
    """

    changed = Signal()
    """The effects are others, or what is selected."""

    def __init__(self, effects: EffectList = NO_EFFECTS) -> None:
        super().__init__()
        self.effects, self.selected = effects, None
        self.stack = QUndoStack(self)
        self._gestures: dict[str, int] = {}

    selected: int | None
    """Number of the effect that is selected."""

    @property
    def effect(self) -> Effect | None:
        number = self.selected
        return None if number is None else self.effects.effects[number]

    def open(self, effects: EffectList) -> None:
        """Begin with other effects; there is nothing to undo."""
        self.stack.clear()
        self.effects, self.selected = effects, None
        self.changed.emit()

    def select(self, number: int | None) -> None:
        if number != self.selected:
            self.selected = number
            self.changed.emit()

    def change(self, effects: EffectList, text: str, gesture: str = "") -> None:
        """Put other effects in place of those that there are.

        Args:
            effects: all of them.
            text: says what was done, beside "Undo".
            gesture: names what is one step with the change before.
        """
        if effects == self.effects:
            return
        name = self._gestures.setdefault(gesture, len(self._gestures))
        number = name if gesture else _NO_GESTURE
        self.stack.push(_Change(self, effects, text, number))

    def put(self, effects: EffectList) -> None:
        """Show effects, and select what has changed; for the steps themselves."""
        number = changed_number(self.effects, effects)
        self.effects, self.selected = effects, number
        self.changed.emit()


class _Change(QUndoCommand):
    """One step: what there was, and what there is."""

    def __init__(
        self, document: Document, after: EffectList, text: str, gesture: int
    ) -> None:
        super().__init__(text)
        self._document, self._gesture = document, gesture
        self._before, self.after = document.effects, after

    def redo(self) -> None:
        """Do it."""
        self._document.put(self.after)

    def undo(self) -> None:
        """Take it back."""
        self._document.put(self._before)

    def id(self) -> int:
        return self._gesture

    def mergeWith(self, other: QUndoCommand) -> bool:  # noqa: N802 - Qt's name
        """Take in the next change of the same gesture."""
        assert isinstance(other, _Change)  # commands of one number are alike
        self.after = other.after
        self.setObsolete(self.after == self._before)
        return True
