"""The texts of a study's pages, worded in each language and looked at."""

from pathlib import Path

from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row
from app.experimenter.study.preview import PagePreview, ShownPage
from app.experimenter.study.words import text_names, word_names
from app.widgets import theme
from app.widgets.layout import paragraph
from hapticplayer.study.pages import PageKind
from hapticplayer.study.steps import CONSENT, DEMONSTRATION, trial_step

_LINES = 6
_PAGES = {
    "consent": (PageKind.CONSENT, CONSENT),
    "demonstration": (PageKind.DEMONSTRATION, DEMONSTRATION),
    "ready": (PageKind.READY, trial_step(1)),
    "thanks": (PageKind.THANKS, "end"),
    "agree": (PageKind.CONSENT, CONSENT),
    "decline": (PageKind.CONSENT, CONSENT),
    "feel": (PageKind.DEMONSTRATION, DEMONSTRATION),
    "next": (PageKind.QUESTIONS, trial_step(1)),
    "start": (PageKind.READY, trial_step(1)),
    "paused": (PageKind.PAUSED, "pause"),
    "resume": (PageKind.PAUSED, "pause"),
    "leave": (PageKind.PAUSED, "pause"),
    "stopped": (PageKind.STOPPED, "end"),
    "problem": (PageKind.PROBLEM, "end"),
}
"""Where a text is seen."""


class TextList(EntryList):
    """Lists the texts of pages and buttons."""

    def __init__(self, document: StudyDocument, folder: Path) -> None:
        super().__init__(document, self.tr("Texts"), None)
        self.preview = PagePreview(folder)
        self.right.addWidget(self.preview)

    def rows(self) -> list[Row]:
        return [
            Row(self.tr("Texts")),
            *(
                Row(f"    {text}", ("texts", name))
                for name, text in text_names().items()
            ),
            Row(self.tr("Buttons and messages")),
            *(
                Row(f"    {text}", ("words", name))
                for name, text in word_names().items()
            ),
        ]

    def fill(self, place: Place) -> None:
        is_long = place[0] == "texts"
        self.fields.texts(self.tr("Text"), place, lines=_LINES if is_long else 1)
        if is_long:
            text = self.tr(
                "{code} stands for the participant's code, {minutes} for the expected "
                "duration, {trials} and {feedbacks} for their numbers, {feel} for the "
                "label of the button that plays the demonstration."
            )
            self.fields.whole(paragraph(text, theme.DIM))

    def refresh(self) -> None:
        super().refresh()
        name = str(self.selected[-1]) if self.selected else ""
        page = ShownPage(*_PAGES[name]) if name in _PAGES else None
        self.preview.follow(self.document.value, page)
