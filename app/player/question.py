"""A question in a window of its own, which does not stop the event loop."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QDialog, QWidget

from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, fill_page, paragraph, row_of

translate = QCoreApplication.translate

_WIDTH_PX = 460


class Question(QDialog):
    """A text with one answer or more, and Cancel."""

    def __init__(self, parent: QWidget, title: str, text: str, *answers: str) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.text = paragraph(text)
        self.text.setMinimumWidth(_WIDTH_PX)
        self.answers = [text_button(one, "", "primary") for one in answers]
        self.yes = self.answers[0]
        self.no = text_button(translate("Question", "Cancel"), "")
        for answer in self.answers:
            answer.clicked.connect(self.accept)
        self.no.clicked.connect(self.reject)
        fill_page(self, self.text, row_of(STRETCH, self.no, *self.answers), spacing=14)


def ask(
    parent: QWidget, title: str, text: str, yes: str, agreed: Callable[[], None]
) -> Question:
    """Ask; `agreed` is called for the first answer."""
    question = Question(parent, title, text, yes)
    question.accepted.connect(agreed)
    question.open()
    return question


def choose(
    parent: QWidget, title: str, text: str, answers: Mapping[str, Callable[[], None]]
) -> Question:
    """Ask which of several; what belongs to the answer is called."""
    question = Question(parent, title, text, *answers)
    for button, chosen in zip(question.answers, answers.values(), strict=True):
        button.clicked.connect(chosen)
    question.open()
    return question
