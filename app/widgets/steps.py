"""A value that is edited, with undo and redo without limit."""

from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

Value = TypeVar("Value")
_NO_GESTURE = -1  # Qt's number of a command that is never merged


class Steps(QObject, Generic[Value]):
    """Holds a value that is replaced and never changed in itself.

    Changes of one gesture, such as a drag or typing in one field, become one step; a
    gesture that leads back to where it began leaves none.
    """

    changed = Signal()

    def __init__(self, value: Value) -> None:
        super().__init__()
        self.value = value
        self.stack = QUndoStack(self)
        self._gestures: dict[str, int] = {}

    def begin(self, value: Value) -> None:
        """Begin with another value; there is nothing to undo."""
        self.stack.clear()
        self.value = value
        self.changed.emit()

    def change(self, value: Value, text: str, gesture: str = "") -> None:
        """Put another value in its place.

        Args:
            value: the whole.
            text: says what was done, beside "Undo".
            gesture: names what is one step with the change before.
        """
        if value == self.value:
            return
        name = self._gestures.setdefault(gesture, len(self._gestures))
        number = name if gesture else _NO_GESTURE
        self.stack.push(_Change(self, value, text, number))

    def put(self, value: Value) -> None:
        """Show a value; for the steps themselves."""
        self.value = value
        self.changed.emit()


class _Change(QUndoCommand, Generic[Value]):
    """One step: what there was, and what there is."""

    def __init__(
        self, steps: Steps[Value], after: Value, text: str, gesture: int
    ) -> None:
        super().__init__(text)
        self._steps, self._gesture = steps, gesture
        self._before, self.after = steps.value, after

    def redo(self) -> None:
        """Do it."""
        self._steps.put(self.after)

    def undo(self) -> None:
        """Take it back."""
        self._steps.put(self._before)

    def id(self) -> int:
        return self._gesture

    def mergeWith(self, other: QUndoCommand) -> bool:  # noqa: N802 - Qt's name
        """Take in the next change of the same gesture."""
        assert isinstance(other, _Change)  # commands of one number are alike
        self.after = other.after
        self.setObsolete(self.after == self._before)
        return True
