"""What holds for the whole study: title, languages, checks."""

from PySide6.QtWidgets import QCheckBox, QWidget

from app.bridge.languages import NAMES
from app.experimenter.study.document import StudyDocument
from app.experimenter.study.fields import Fields
from app.widgets.layout import STRETCH, row_of
from hapticplayer.study.creation import with_languages


class GeneralFields(Fields):
    """The first page of the editor."""

    def __init__(self, document: StudyDocument) -> None:
        super().__init__(document)
        self.languages: dict[str, QCheckBox] = {}

    def refresh(self) -> None:
        self.show_shape("general", self._fill)

    def _fill(self) -> None:
        self.line(self.tr("Title"), ("title",))
        self._language_row()
        self.check(
            self.tr("Hide the condition from the operator"), ("operator_is_blind",)
        )
        self.check(
            self.tr("Use the published wording of questions where there is one"),
            ("use_published",),
        )
        self.check(
            self.tr("Require a real device before a session starts"),
            ("checks", "device"),
            usually=True,
        )
        self.check(
            self.tr("Ask the operator whether the sound is audible"),
            ("checks", "sound"),
            usually=True,
        )
        self.check(
            self.tr(
                "Stream markers and force to other programs on this computer (LSL)"
            ),
            ("lsl",),
        )

    def _language_row(self) -> None:
        self.languages = {}
        known = dict.fromkeys([*NAMES, *self.document.languages])
        for language in known:
            box = self.languages[language] = QCheckBox(NAMES.get(language, language))
            box.clicked.connect(lambda *_: self._choose_languages())
        row = QWidget()
        row_of(*self.languages.values(), STRETCH, spacing=16, of=row)
        self.row(self.tr("Languages"), row)
        first = next(iter(self.languages.values()))
        self.bind(("languages",), first, self._show_languages)

    def _show_languages(self) -> None:
        spoken = self.document.languages
        for language, box in self.languages.items():
            box.setChecked(language in spoken)
            box.setEnabled(spoken != [language])  # one has to stay

    def _choose_languages(self) -> None:
        chosen = [one for one, box in self.languages.items() if box.isChecked()]
        made = with_languages(self.document.value, chosen)
        self.document.change(made, self.tr("other languages"))
