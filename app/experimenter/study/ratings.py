"""What is rated while a clip plays: added, worded, removed."""

from functools import partial
from typing import Any

from PySide6.QtWidgets import QCheckBox, QGridLayout, QMenu, QWidget

from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row, free_key
from app.experimenter.study.words import text_in
from app.widgets.buttons import text_button
from hapticplayer.model.ranges import Range
from hapticplayer.study.definition import RatingKind
from hapticplayer.study.rating_rules import AXES, MOVERS, USES

_MOST, _COLUMNS = 999, 3
_NEW: dict[RatingKind, dict[str, Any]] = {
    RatingKind.SLIDER: {"least": 0, "most": 100, "by": ["mouse", "wheel", "keys"]},
    RatingKind.NUMBER: {"least": 0, "most": 20, "every_s": 60.0},
    RatingKind.HELD_KEY: {"hold": "v"},
}


class RatingList(EntryList):
    """Lists the ratings of a study."""

    def __init__(self, document: StudyDocument) -> None:
        add = text_button(self.tr("Add"), self.tr("Add a rating while a clip plays"))
        super().__init__(document, self.tr("Ratings while a clip plays"), add)
        menu = QMenu(self)
        for kind, text in self._kinds().items():
            menu.addAction(text).triggered.connect(partial(self.add, kind))
        add.setMenu(menu)

    def _kinds(self) -> dict[RatingKind, str]:
        return {
            RatingKind.SLIDER: self.tr("Slider"),
            RatingKind.NUMBER: self.tr("Number every so often"),
            RatingKind.HELD_KEY: self.tr("Key that is held"),
        }

    @property
    def _ratings(self) -> list[dict[str, Any]]:
        return list(self.document.value.get("while_watching") or [])

    def rows(self) -> list[Row]:
        texts = (text_in(one["text"], self.document.languages) for one in self._ratings)
        return [
            Row(text or self.tr("(no wording yet)"), ("while_watching", number))
            for number, text in enumerate(texts)
        ]

    def shape(self, place: Place) -> object:
        entry = self.document.at(place) or {}
        count = len(entry.get("labels") or [])
        return place, tuple(self.document.languages), entry.get("kind"), count

    def fill(self, place: Place) -> None:
        fields, uses = self.fields, USES[RatingKind(self.document.at((*place, "kind")))]
        fields.texts(self.tr("Wording"), (*place, "text"), lines=2)
        fields.choice(
            self.tr("Kind of rating"),
            (*place, "kind"),
            [(text, kind.value) for kind, text in self._kinds().items()],
            lambda chosen: self._change_kind(place, chosen),
        )
        if "least" in uses:
            for text, name in (
                (self.tr("Smallest"), "least"),
                (self.tr("Largest"), "most"),
            ):
                fields.number(text, (*place, name), -_MOST, _MOST)
        if "by" in uses:
            self._fill_movers((*place, "by"))
            self._fill_labels(place)
        if "every_s" in uses:
            text = self.tr("Asked for every")
            fields.decimal(text, (*place, "every_s"), Range(5.0, 3600.0, "s"))
            text = self.tr("Said aloud: the operator enters it")
            fields.check(text, (*place, "spoken"))
        if "hold" in uses:
            key = fields.line(
                self.tr("Key"),
                (*place, "hold"),
                tip=self.tr("A letter, enter, shift or control"),
            )
            key.setMaximumWidth(key.sizeHint().width())
        if "stop_at" in uses:
            self._fill_stop(place)
        fields.line(
            self.tr("Name in the data"),
            (*place, "key"),
            tip=self.tr("In data and figures: a to z, 0 to 9, _ and -"),
        )

    def _fill_stop(self, place: Place) -> None:
        self.fields.listed(
            self.tr("Ends clip and force from"),
            (*place, "stop_at"),
            tip=self.tr("A value from which the clip ends; empty for none"),
            is_optional=True,
            is_one=True,
        )
        text = self.tr("Text of the break after that")
        self.fields.texts(text, (*place, "rest"), is_optional=True)

    def _fill_movers(self, place: Place) -> None:
        """What moves a slider."""
        names = {
            "mouse": self.tr("mouse"),
            "wheel": self.tr("wheel"),
            "keys": self.tr("arrow keys"),
        }
        boxes = {one: QCheckBox(names.get(one, one)) for one in (*MOVERS, *AXES)}
        grid = QWidget()
        layout = QGridLayout(grid)
        layout.setContentsMargins(0, 0, 0, 0)
        text = self.tr("Moved by")

        def take() -> None:
            chosen = [name for name, box in boxes.items() if box.isChecked()]
            self.document.set(place, chosen, text)

        def show() -> None:
            held = self.document.at(place) or []
            for name, box in boxes.items():
                box.setChecked(name in held)

        for number, box in enumerate(boxes.values()):
            layout.addWidget(box, number // _COLUMNS, number % _COLUMNS)
            box.clicked.connect(take)
        self.fields.row(text, grid)
        self.fields.bind(place, grid, show)

    def _fill_labels(self, place: Place) -> None:
        labels = self.document.at((*place, "labels")) or []
        for number in range(len(labels)):
            self.label_row((*place, "labels", number), -_MOST, _MOST)
        add = text_button(self.tr("Add a label"), "")
        add.clicked.connect(lambda: self._add_label(place))
        self.fields.row("", add)

    # --- what a person does --------------------------------------------------------

    def _add_label(self, place: Place) -> None:
        rating = self.document.at(place)
        held = [one["at"] for one in rating.get("labels") or []]
        points = [rating.get("least", 0), rating.get("most", 100), 0]
        point = next((one for one in points if one not in held), 0)
        made = {"at": point, "text": self.no_text()}
        self.document.add((*place, "labels"), [made], self.tr("another label"))

    def add(self, kind: RatingKind, *_: object) -> None:
        """Add a rating, which is to be worded."""
        taken = [one["key"] for one in self._ratings]
        key = free_key("rating", taken)
        made = {"key": key, "kind": str(kind), "text": self.no_text(), **_NEW[kind]}
        self.selected = ("while_watching", len(taken))
        self.document.add(("while_watching",), [made], self.tr("another rating"))
        self.fields.focus((*self.selected, "text", self.document.languages[0]))

    def _change_kind(self, place: Place, kind: str) -> None:
        """Keep what the new kind has, too."""
        chosen = RatingKind(kind)
        kept = {"key", "text", *USES[chosen]}
        before = {n: v for n, v in self.document.at(place).items() if n in kept}
        made = {**_NEW[chosen], **before, "kind": kind}
        self.document.set(place, made, self.tr("another kind of rating"))
