"""Push buttons for mouse, keyboard and screen reader alike."""

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from app.widgets import theme
from app.widgets.theme import control_icon

ICON_PX = 20
_PRESSING = (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter)


class Button(QPushButton):
    """A button whose Space and Enter press it, whatever the window's shortcuts are.

    A click leaves the focus where it is, so that Space still plays and pauses.
    """

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAutoDefault(False)

    def event(self, event: QEvent) -> bool:
        """Keep the keys that press the focused button from the shortcuts."""
        is_override = event.type() == QEvent.Type.ShortcutOverride
        if is_override and isinstance(event, QKeyEvent) and event.key() in _PRESSING:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _PRESSING[1:]:
            if not event.isAutoRepeat():  # held, it would press what comes next, too
                self.click()
        else:
            super().keyPressEvent(event)


class TickBox(QCheckBox):
    """A box that Space ticks once Tab has gone there; a click leaves the focus alone."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def event(self, event: QEvent) -> bool:
        """Keep Space from the shortcuts of the window."""
        is_override = event.type() == QEvent.Type.ShortcutOverride
        if is_override and isinstance(event, QKeyEvent) and event.key() == _PRESSING[0]:
            event.accept()
            return True
        return super().event(event)


def text_button(text: str, tip: str, role: str = "") -> Button:
    """Return a button with a text."""
    button = Button(text)
    set_role(button, role)
    button.setToolTip(tip)
    return button


def tool_button(drawing: str, name: str, tip: str) -> Button:
    """Return a button with a drawing; its name is for screen readers."""
    button = Button()
    set_role(button, "tool")
    button.setIcon(control_icon(drawing, ICON_PX, theme.TEXT))
    button.setIconSize(QSize(ICON_PX, ICON_PX))
    button.setFixedSize(QSize(ICON_PX + 20, ICON_PX + 14))
    button.setAccessibleName(name)
    button.setToolTip(tip)
    return button


def set_role(button: QPushButton, role: str) -> None:
    """Style a button by a role of the style sheet."""
    if button.property("role") != role:
        button.setProperty("role", role)
        button.style().unpolish(button)
        button.style().polish(button)
