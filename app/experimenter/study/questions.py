"""The questions of a study: added, worded, put in order, removed, and looked at."""

from typing import Any

from PySide6.QtWidgets import QMenu, QWidget

from app.bridge.languages import translated
from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row
from app.experimenter.study.preview import PagePreview
from app.experimenter.study.words import group_names, text_in
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import paragraph, row_of
from hapticplayer.study.definition import (
    MAX_ANSWER,
    QUESTION_KINDS,
    QuestionKind,
    TrialKind,
)
from hapticplayer.study.pages import PageKind
from hapticplayer.study.steps import POST_TEST, SHEET, trial_step

_KEY_PX = 130
_MOST = 1_000_000
_STEPS = {
    "sheet": SHEET,
    "factors": trial_step(1),
    "consistency": trial_step(1),
    "post_test": POST_TEST,
}
_OF_KINDS = ("least", "most", "choices")


class QuestionList(EntryList):
    """Lists the questions of all pages, with the page of the selected one beside it."""

    def __init__(self, document: StudyDocument) -> None:
        add = text_button(self.tr("Add"), self.tr("Add a question to a page"))
        super().__init__(document, self.tr("Questions"), add)
        add.setMenu(self._add_menu())
        self.preview = PagePreview()
        self.right.addWidget(self.preview)

    @property
    def _groups(self) -> tuple[str, ...]:
        is_rating = self.document.value["trial"] == TrialKind.RATING
        return ("sheet", "factors" if is_rating else "consistency", "post_test")

    def _add_menu(self) -> QMenu:
        menu = QMenu(self)
        for group in self._groups:
            if kinds := kinds_in(group):
                inner = menu.addMenu(group_names()[group])
                for kind in kinds:
                    action = inner.addAction(translated(QUESTION_KINDS[kind]))
                    action.triggered.connect(
                        lambda _on, group=group, kind=kind: self.add(group, kind)
                    )
        return menu

    def rows(self) -> list[Row]:
        content, names = self.document.value, group_names()
        rows = []
        for group in self._groups:
            rows.append(Row(names[group]))
            held = content.get(group)
            if isinstance(held, dict):
                rows.append(Row(self._text(held), (group,), may_go=False))
            else:
                rows += [
                    Row(self._text(one), (group, number))
                    for number, one in enumerate(held or [])
                ]
        return rows

    def _text(self, question: dict[str, Any]) -> str:
        text = text_in(question["text"], self.document.languages)
        return "    " + (text or self.tr("(no wording yet)"))

    def shape(self, place: Place) -> object:
        question = self.document.at(place) or {}
        choices = len(question.get("choices") or [])
        return place, tuple(self.document.languages), question.get("kind"), choices

    def fill(self, place: Place) -> None:
        fields, group = self.fields, str(place[0])
        kind = self.document.at((*place, "kind"))
        fields.texts(self.tr("Wording"), (*place, "text"), lines=2)
        names = [
            (translated(QUESTION_KINDS[one]), one.value) for one in kinds_in(group)
        ]
        if len(names) > 1:
            fields.choice(
                self.tr("Kind of answer"),
                (*place, "kind"),
                names,
                lambda chosen: self._change_kind(place, chosen),
            )
        self._fill_kind(place, kind)
        fields.check(
            self.tr("An answer is required"), (*place, "required"), usually=True
        )
        if group == "post_test":
            fields.check(
                self.tr("Ask once for each kind of feedback"),
                (*place, "for_each_feedback"),
            )
        key = fields.line(
            self.tr("Name in the data"),
            (*place, "key"),
            tip=self.tr("In data and figures: a to z, 0 to 9, _ and -"),
        )
        key.setMaximumWidth(2 * key.sizeHint().width())
        fields.texts(
            self.tr("Published wording"), (*place, "published"), is_optional=True
        )

    def _fill_kind(self, place: Place, kind: str) -> None:
        fields = self.fields
        if kind == QuestionKind.NUMBER:
            fields.number(self.tr("Smallest"), (*place, "least"), -_MOST, _MOST)
            fields.number(self.tr("Largest"), (*place, "most"), -_MOST, _MOST)
        elif kind == QuestionKind.TEXT:
            label = self.tr("At most so many characters")
            box = fields.number(label, (*place, "most"), 1, MAX_ANSWER)
            if self.document.at((*place, "most")) is None:
                fields.bind((*place, "most"), box, lambda: self._show_most(place))
        elif kind == QuestionKind.LIKERT:
            fields.texts(self.tr("Label of 1"), ("scale", "lowest"))
            fields.texts(self.tr("Label of 5"), ("scale", "highest"))
            text = self.tr("All five-point scales of a study have the same labels.")
            fields.whole(paragraph(text, theme.DIM))
        elif kind == QuestionKind.CHOICE:
            self._fill_choices(place)

    def _show_most(self, place: Place) -> None:
        if self.document.at((*place, "most")) is None:
            box = self.fields.by_place[(*place, "most")]
            box.blockSignals(True)
            box.setValue(MAX_ANSWER)  # type: ignore[attr-defined]
            box.blockSignals(False)

    def _fill_choices(self, place: Place) -> None:
        choices = self.document.at((*place, "choices")) or []
        for number in range(len(choices)):
            at = (*place, "choices", number)
            label = self.tr("Answer {n}").format(n=number + 1)
            self.fields.row(label, self._choice_row(at, label, len(choices)))
        add = text_button(self.tr("Add an answer"), "")
        add.clicked.connect(lambda: self._add_choice(place))
        self.fields.row("", add)

    def _choice_row(self, at: Place, label: str, count: int) -> QWidget:
        lines = []
        for language in self.document.languages:
            own = self.fields.in_language(label, language)
            line = self.fields.lone_line(own, (*at, "text", language))
            line.setPlaceholderText(own)
            lines.append((line, 2))
        key = self.fields.lone_line(self.tr("Name in the data"), (*at, "key"))
        key.setToolTip(self.tr("Name in the data"))
        key.setFixedWidth(_KEY_PX)
        remove = text_button("\u2715", self.tr("Remove this answer"))
        remove.setAccessibleName(self.tr("Remove this answer"))
        remove.setEnabled(count > 2)
        remove.clicked.connect(
            lambda: self.document.remove(at, self.tr("removal of an answer"))
        )
        row = QWidget()
        row_of(*lines, key, remove, spacing=6, of=row)
        return row

    def refresh(self) -> None:
        super().refresh()
        group = str(self.selected[0]) if self.selected else ""
        kind = PageKind.QUESTIONS if group in _STEPS else None
        self.preview.follow(self.document.value, kind, _STEPS.get(group, ""))

    # --- what a person does --------------------------------------------------------

    def add(self, group: str, kind: str) -> None:
        """Add a question without wording."""
        held = self.document.at((group,)) or []
        key = _free_key("question", [one["key"] for one in held])
        question = {"key": key, "kind": str(kind), "text": self._no_text()}
        self.selected = (group, len(held))
        made = _of_kind(question, kind, self._no_text())
        self.document.add((group,), [made], self.tr("another question"))
        self.fields.focus((*self.selected, "text", self.document.languages[0]))

    def _change_kind(self, place: Place, kind: str) -> None:
        made = _of_kind(self.document.at(place), kind, self._no_text())
        self.document.set(place, made, self.tr("another kind of answer"))

    def _add_choice(self, place: Place) -> None:
        at = (*place, "choices")
        known = [one["key"] for one in self.document.at(at) or []]
        made = {"key": _free_key("answer", known), "text": self._no_text()}
        self.document.add(at, [made], self.tr("another answer"))
        self.fields.focus((*at, len(known), "text", self.document.languages[0]))

    def _no_text(self) -> dict[str, str]:
        return dict.fromkeys(self.document.languages, "")


def kinds_in(group: str) -> tuple[QuestionKind, ...]:
    """The kinds of questions that a page may have."""
    if group == "factors":
        return (QuestionKind.LIKERT,)
    return () if group == "consistency" else tuple(QuestionKind)


def _of_kind(
    question: dict[str, Any], kind: str, no_text: dict[str, str]
) -> dict[str, Any]:
    """A question with what its kind needs, and without what another one had."""
    made = {name: one for name, one in question.items() if name not in _OF_KINDS}
    made["kind"] = str(kind)
    if kind == QuestionKind.NUMBER:
        made |= {"least": 0, "most": 100}
    elif kind == QuestionKind.CHOICE:
        keys = ("answer-1", "answer-2")
        made["choices"] = [{"key": key, "text": dict(no_text)} for key in keys]
    return made


def _free_key(word: str, taken: list[str]) -> str:
    numbered = (f"{word}-{n}" for n in range(len(taken) + 1, 10_000))
    return next(one for one in numbered if one not in taken)
