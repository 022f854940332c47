"""What a screen reader hears of a widget that is painted by hand.

Such a widget tells in words what it shows, by a method `spoken() -> str`; what its
accessible name says is not in it.
"""

from functools import cache
from typing import Any

from PySide6.QtCore import QObject
from PySide6.QtGui import QAccessible, QAccessibleEvent, QAccessibleInterface
from PySide6.QtWidgets import QAccessibleWidget, QWidget


class _Voice(QAccessibleWidget):
    """Asks the widget when it is read: nothing is composed while nobody listens."""

    def __init__(self, widget: QWidget) -> None:
        self._is_named = bool(widget.accessibleName())
        role = QAccessible.Role
        super().__init__(widget, role.Graphic if self._is_named else role.StaticText)

    def _said(self) -> str:
        """Asked of the widget each time: to hold it here would keep it for ever."""
        widget: Any = self.widget()
        return str(widget.spoken())

    def text(self, kind: QAccessible.Text) -> str:
        text = super().text(kind)
        if kind == QAccessible.Text.Value:
            return self._said()
        if kind == QAccessible.Text.Name and not self._is_named:
            return self._said()
        if kind == QAccessible.Text.Description and self._is_named:
            return ". ".join(part for part in (self._said(), text) if part)
        return text


@cache
def give_voice() -> None:
    """Let all widgets that can tell what they show be heard."""
    QAccessible.installFactory(_voice_of)


def _voice_of(_kind: str, thing: QObject) -> QAccessibleInterface | None:
    if isinstance(thing, QWidget) and hasattr(thing, "spoken"):
        return _Voice(thing)
    return None


def tell_change(widget: QWidget) -> None:
    """Let a reader who is at a widget hear its state again."""
    changed = QAccessible.Event.DescriptionChanged
    QAccessible.updateAccessibility(QAccessibleEvent(widget, changed))
