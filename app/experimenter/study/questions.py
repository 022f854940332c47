"""The questions of a study, on pages: added, worded, put in order, removed, looked at."""

from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import QComboBox, QMenu, QWidget

from app.bridge.languages import translated
from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row, free_key
from app.experimenter.study.preview import PagePreview, ShownPage
from app.experimenter.study.score_fields import fill_score, new_score
from app.experimenter.study.words import (
    group_names,
    page_words,
    text_in,
)
from app.widgets.buttons import text_button
from app.widgets.layout import paragraph
from hapticplayer.study.definition import (
    MAX_ANSWER,
    OF_TRIALS,
    QuestionKind,
    TrialKind,
    When,
)
from hapticplayer.study.pages import PageKind
from hapticplayer.study.questions import (
    ANSWER_KINDS,
    MAX_POINTS,
    OF_KINDS,
    VISUAL_RANGE,
)
from hapticplayer.study.scales import page_of_scale, read_scale, scale_names
from hapticplayer.study.steps import trial_step

_KEY_PX, _VALUE_PX = 130, 60
_MOST, _MOST_POINT = 1_000_000, 999
_PAGE_LETTERS = 30
_NEW: dict[QuestionKind, dict[str, Any]] = {
    QuestionKind.SCALE: {"least": 1, "most": 5},
    QuestionKind.NUMBER: {"least": 0, "most": 100},
    QuestionKind.PAIR: {"least": -3, "most": 3},
}
_ENDS = {
    QuestionKind.SCALE: (1, 5),
    QuestionKind.VISUAL: VISUAL_RANGE,
    QuestionKind.PAIR: (-3, 3),
}


class QuestionList(EntryList):
    """Lists pages and their questions, with the page of the selected one beside it."""

    def __init__(self, document: StudyDocument, folder: Path) -> None:
        add = text_button(self.tr("Add"), self.tr("Add a question or a page"))
        super().__init__(document, self.tr("Questions"), add)
        add.setMenu(self._add_menu())
        self.preview = PagePreview(folder)
        self.right.addWidget(self.preview)

    def _add_menu(self) -> QMenu:
        menu = QMenu(self)
        pages = menu.addMenu(self.tr("Page"))
        for when, text in group_names().items():
            pages.addAction(text).triggered.connect(partial(self.add_page, When(when)))
        scales = menu.addMenu(self.tr("Scale"))
        for name in scale_names():
            action = scales.addAction(read_scale(name).name)
            action.triggered.connect(partial(self.add_scale, name))
        menu.addAction(self.tr("Score")).triggered.connect(self.add_score)
        menu.addSeparator()
        for kind, row in ANSWER_KINDS.items():
            action = menu.addAction(translated(row.name))
            action.triggered.connect(partial(self.add, kind))
        return menu

    @property
    def _pages(self) -> list[dict[str, Any]]:
        return list(self.document.value.get("pages") or [])

    def rows(self) -> list[Row]:
        rows, content = [], self.document.value
        for when, name in group_names().items():
            rows.append(Row(name))
            for number, page in enumerate(self._pages):
                if page.get("when") == when:
                    at = ("pages", number)
                    rows.append(Row(f"  {page_words(content, number)}", at))
                    rows += [
                        Row(self._text(one), (*at, "questions", place))
                        for place, one in enumerate(page.get("questions") or [])
                    ]
                    score = self.tr("Score: {text}")
                    rows += [
                        Row(
                            f"      {score.format(text=one['text'])}",
                            (*at, "scores", n),
                        )
                        for n, one in enumerate(page.get("scores") or [])
                    ]
        return rows

    def _text(self, question: dict[str, Any]) -> str:
        text = text_in(question["text"], self.document.languages)
        return "      " + (text or self.tr("(no wording yet)"))

    def siblings(self, place: Place) -> list[Place]:
        """A page moves among those that are shown at the same time."""
        same = super().siblings(place)
        if len(place) > 2 or not place:
            return same
        when = self.document.at((*place, "when"))
        return [one for one in same if self.document.at((*one, "when")) == when]

    def shape(self, place: Place) -> object:
        entry = self.document.at(place) or {}
        counts = [len(entry.get(name) or []) for name in ("choices", "labels")]
        pages = [(one["key"], one["when"]) for one in self._pages]
        kinds = entry.get("kind"), entry.get("scale")
        return place, tuple(self.document.languages), kinds, counts, pages

    def fill(self, place: Place) -> None:
        if len(place) == 2:
            self._fill_page(place)
        elif place[2] == "scores":
            fill_score(self.fields, place)
        else:
            self._fill_question(place)

    def _fill_page(self, place: Place) -> None:
        fields = self.fields
        names = [(text, when) for when, text in group_names().items()]
        fields.choice(self.tr("Shown"), (*place, "when"), names)
        label = self.tr("Text above the questions")
        fields.texts(label, (*place, "text"), lines=2, is_optional=True)
        if self.document.at((*place, "when")) == When.AFTER:
            text = self.tr("All clips may be played again there")
            fields.check(text, (*place, "replays"))
        fields.check(
            self.tr("The questions are shown one after the other"),
            (*place, "one_by_one"),
        )
        self._key_line(place)
        fields.line(self.tr("Scale"), (*place, "scale"), is_optional=True)
        name = self.document.at((*place, "scale"))
        if name in scale_names():
            scale = read_scale(name)
            fields.row(self.tr("Source"), paragraph(f"{scale.name}: {scale.source}"))
            fields.row(self.tr("Licence"), paragraph(scale.licence))

    def _key_line(self, place: Place) -> None:
        key = self.fields.line(
            self.tr("Name in the data"),
            (*place, "key"),
            tip=self.tr("In data and figures: a to z, 0 to 9, _ and -"),
        )
        key.setMaximumWidth(2 * key.sizeHint().width())

    def _fill_question(self, place: Place) -> None:
        fields, when = self.fields, self.document.at((*place[:2], "when"))
        kind = self.document.at((*place, "kind"))
        fields.texts(self.tr("Wording"), (*place, "text"), lines=2)
        fields.texts(self.tr("Help line"), (*place, "help"), is_optional=True)
        fields.choice(
            self.tr("Kind of answer"),
            (*place, "kind"),
            [(translated(row.name), one.value) for one, row in ANSWER_KINDS.items()],
            lambda chosen: self._change_kind(place, chosen),
        )
        self._fill_kind(place, kind)
        fields.check(
            self.tr("An answer is required"), (*place, "required"), usually=True
        )
        is_rating = self.document.value["trial"] == TrialKind.RATING
        if kind == QuestionKind.SCALE and when == When.AFTER_CLIP and is_rating:
            text = self.tr("Part of the sum QoE, which is analysed first")
            fields.check(text, (*place, "in_qoe"))
        if when == When.AFTER:
            fields.check(
                self.tr("Ask once for each kind of feedback"),
                (*place, "for_each_feedback"),
            )
        self._page_row(place)
        self._key_line(place)
        fields.texts(
            self.tr("Published wording"), (*place, "published"), is_optional=True
        )

    def _page_row(self, place: Place) -> None:
        """On which page the question is."""
        box = QComboBox()
        short = QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        box.setSizeAdjustPolicy(short)  # the text above a page may be a long one
        box.setMinimumContentsLength(_PAGE_LETTERS)
        for number, page in enumerate(self._pages):
            words = page_words(self.document.value, number)
            box.addItem(f"{group_names()[page['when']]} \u203a {words}", number)
        box.setCurrentIndex(box.findData(place[1]))
        box.setAccessibleName(self.tr("Page"))
        box.activated.connect(lambda row: self.move_to_page(place, box.itemData(row)))
        self.fields.row(self.tr("Page"), box)

    def _fill_kind(self, place: Place, kind: str) -> None:
        fields = self.fields
        uses = ANSWER_KINDS[QuestionKind(kind)].uses
        if kind == QuestionKind.TEXT:
            label = self.tr("At most so many characters")
            fields.number(label, (*place, "most"), 1, MAX_ANSWER, usually=MAX_ANSWER)
        elif "least" in uses:
            for label, name in (
                (self.tr("Smallest"), "least"),
                (self.tr("Largest"), "most"),
            ):
                take = partial(self._set_end, (*place, name))
                fields.number(label, (*place, name), -_MOST, _MOST, take)
        if "unit" in uses:
            fields.line(
                self.tr("Unit in the data"), (*place, "unit"), is_optional=True
            ).setMaximumWidth(_KEY_PX)
        if "labels" in uses:
            self._fill_labels(place)
        if "choices" in uses:
            self._fill_choices(place)

    def _set_end(self, at: Place, value: int) -> None:
        """Change an end of a scale; its label goes with it."""
        asked, name = dict(self.document.at(at[:-1])), str(at[-1])
        labels = asked.get("labels") or []
        moved = [
            {**one, "at": value} if one["at"] == asked.get(name) else one
            for one in labels
        ]
        asked |= {name: value, **({"labels": moved} if labels else {})}
        self.document.set(at[:-1], asked, self.tr("another range"))

    def _fill_labels(self, place: Place) -> None:
        labels = self.document.at((*place, "labels")) or []
        for number in sorted(range(len(labels)), key=lambda n: labels[n].get("at", 0)):
            self.label_row((*place, "labels", number), *self._limits(place))
        if self.document.at((*place, "kind")) == QuestionKind.PAIR:
            return  # it has its two ends
        add = text_button(self.tr("Add a label"), "")
        add.clicked.connect(lambda: self._add_label(place))
        self.fields.row("", add)

    def _limits(self, place: Place) -> tuple[int, int]:
        asked = self.document.at(place)
        if asked["kind"] == QuestionKind.VISUAL:
            return VISUAL_RANGE
        return -_MOST_POINT, _MOST_POINT

    def _add_label(self, place: Place) -> None:
        asked, at = self.document.at(place), (*place, "labels")
        held = [one["at"] for one in asked.get("labels") or []]
        least, most = VISUAL_RANGE
        if asked["kind"] == QuestionKind.SCALE:
            least, most = asked.get("least", 1), asked.get("most", 5)
        points = [least, most, *range(least, min(most, least + MAX_POINTS))]
        point = next((one for one in points if one not in held), least)
        made = {"at": point, "text": self.no_text()}
        self.document.add(at, [made], self.tr("another label"))
        self.fields.focus((*at, len(held), "text", self.document.languages[0]))

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
        key = self.fields.lone_line(self.tr("Name in the data"), (*at, "key"))
        key.setToolTip(self.tr("Name in the data"))
        key.setFixedWidth(_KEY_PX)
        own: tuple[QWidget, ...] = (key,)
        if self.document.at((*at[:-2], "kind")) == QuestionKind.CHOICE:
            text = self.tr("Number that it counts as, if any")
            place = (*at, "value")
            value = self.fields.lone_listed(text, place, is_optional=True, is_one=True)
            value.setToolTip(text)
            value.setFixedWidth(_VALUE_PX)
            own = (key, value)
        remove = self.tr("Remove this answer")
        return self.text_row(at, label, *own, removal=remove, may_go=count > 2)

    def refresh(self) -> None:
        super().refresh()
        page = None
        if self.selected:
            shown = self._pages[int(self.selected[1])]
            is_trial = shown["when"] in OF_TRIALS
            step = trial_step(1) if is_trial else shown["key"]
            page = ShownPage(PageKind.QUESTIONS, step, shown["key"])
        self.preview.follow(self.document.value, page)

    # --- what a person does --------------------------------------------------------

    def add_page(self, when: When, *_: object) -> None:
        """Add a page with a question, which is to be worded."""
        pages = self._pages
        key = free_key("page", [one["key"] for one in pages])
        asked = self._new_question(QuestionKind.SCALE)
        page = {"key": key, "when": str(when), "questions": [asked]}
        self.selected = ("pages", len(pages), "questions", 0)
        self.document.add(("pages",), [page], self.tr("another page"))
        self.fields.focus((*self.selected, "text", self.document.languages[0]))

    def add_scale(self, name: str, *_: object) -> None:
        """Add a page that asks a scale, where the selected page is shown."""
        pages, selected = self._pages, self.selected
        when = pages[int(selected[1])]["when"] if selected else When.AFTER_CLIP
        taken = [one["key"] for one in pages]
        key = name if name not in taken else free_key(name, taken)
        page = page_of_scale(name, key, When(when), self.document.languages)
        self.selected = ("pages", len(pages))
        self.document.add(("pages",), [page], self.tr("another scale"))

    def add_score(self, *_: object) -> None:
        """Add a score to the selected page."""
        if self.selected:
            at = self.selected[:2]
            taken = [s["key"] for page in self._pages for s in page.get("scores") or []]
            made = new_score(free_key("score", taken), self.document.at(at))
            number = len(self.document.at((*at, "scores")) or [])
            self.selected = (*at, "scores", number)
            self.document.add((*at, "scores"), [made], self.tr("another score"))

    def add(self, kind: QuestionKind, *_: object) -> None:
        """Add a question to the selected page."""
        if not self.selected:
            self.add_page(When.AFTER_CLIP)
            return
        at = (*self.selected[:2], "questions")
        asked = self._new_question(kind)
        self.selected = (*at, len(self.document.at(at) or []))
        self.document.add(at, [asked], self.tr("another question"))
        self.fields.focus((*self.selected, "text", self.document.languages[0]))

    def move_to_page(self, place: Place, number: int) -> None:
        """Move a question to the end of another page."""
        pages = self._pages
        asked = self.document.at(place)
        if number == place[1]:
            return
        left = [one for one in pages[int(place[1])]["questions"] if one is not asked]
        there = [*pages[number]["questions"], asked]
        pages[number] = {**pages[number], "questions": there}
        pages[int(place[1])] = {**pages[int(place[1])], "questions": left}
        self.selected = ("pages", number, "questions", len(there) - 1)
        self.document.change_list(
            ("pages",), lambda _before: pages, self.tr("another page")
        )

    def _change_kind(self, place: Place, kind: str) -> None:
        made = self._of_kind(self.document.at(place), QuestionKind(kind))
        self.document.set(place, made, self.tr("another kind of answer"))

    def _new_question(self, kind: QuestionKind) -> dict[str, Any]:
        known = [q["key"] for page in self._pages for q in page["questions"]]
        asked = {"key": free_key("question", known), "text": self.no_text()}
        return self._of_kind(asked, kind)

    def _of_kind(self, asked: dict[str, Any], kind: QuestionKind) -> dict[str, Any]:
        """A question with what its kind needs, and without what another one had."""
        uses = ANSWER_KINDS[kind].uses
        kept = {n: one for n, one in asked.items() if n not in OF_KINDS or n in uses}
        made = {"kind": str(kind), **_NEW.get(kind, {}), **kept}
        made["kind"] = str(kind)
        if kind in (QuestionKind.TEXT, QuestionKind.VISUAL):
            made = {n: one for n, one in made.items() if n not in ("most", "labels")}
        if kind in _ENDS and not made.get("labels"):
            made["labels"] = self._labels_of(kind)
        if "choices" in uses and not made.get("choices"):
            keys = ("answer-1", "answer-2")
            made["choices"] = [{"key": key, "text": self.no_text()} for key in keys]
        return made

    def _labels_of(self, kind: QuestionKind) -> list[dict[str, Any]]:
        """Those of the last such question, at the ends of a new one."""
        found = [
            [one["text"] for one in (asked["labels"][0], asked["labels"][-1])]
            for page in self._pages
            for asked in page["questions"]
            if asked["kind"] == kind and len(asked.get("labels") or []) > 1
        ]
        texts = found[-1] if found else [self.no_text(), self.no_text()]
        ends = zip(_ENDS[kind], texts, strict=True)
        return [{"at": at, "text": dict(text)} for at, text in ends]

    def _add_choice(self, place: Place) -> None:
        at = (*place, "choices")
        known = [one["key"] for one in self.document.at(at) or []]
        made = {"key": free_key("answer", known), "text": self.no_text()}
        self.document.add(at, [made], self.tr("another answer"))
        self.fields.focus((*at, len(known), "text", self.document.languages[0]))
