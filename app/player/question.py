"""A question in a window of its own, which does not stop the event loop."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QDialog, QWidget

from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of

translate = QCoreApplication.translate

_WIDTH_PX = 460


class Question(QDialog):
    """A text with two answers."""

    def __init__(self, parent: QWidget, title: str, text: str, yes: str) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.text = paragraph(text)
        self.text.setMinimumWidth(_WIDTH_PX)
        self.yes = text_button(yes, "", "primary")
        self.no = text_button(translate("Question", "Cancel"), "")
        self.yes.clicked.connect(self.accept)
        self.no.clicked.connect(self.reject)
        fill_page(self, self.text, row_of(STRETCH, self.no, self.yes), spacing=14)


def ask(
    parent: QWidget, title: str, text: str, yes: str, agreed: Callable[[], None]
) -> Question:
    """Ask; `agreed` is called for the first answer."""
    question = Question(parent, title, text, yes)
    question.accepted.connect(agreed)
    question.open()
    return question
