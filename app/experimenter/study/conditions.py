"""The conditions of a study: each with its parameters and a preview of its force."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QComboBox, QLineEdit, QMenu, QSizePolicy, QWidget

from app.bridge.jobs import Jobs, in_child
from app.bridge.languages import translated
from app.experimenter.study.document import Place, StudyDocument
from app.experimenter.study.lists import EntryList, Row
from app.experimenter.study.words import condition_words, text_in
from app.player.condition_form import ConditionForm
from app.plots.rendering_picture import RenderingPicture
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import captioned, column_of, paragraph, row_of
from app.widgets.texts import local
from hapticplayer.errors import HapticPlayerError, Progress, message_of
from hapticplayer.model import ranges
from hapticplayer.model.ranges import Range
from hapticplayer.rendering import FEEDBACKS, ChosenFeedback, condition_named
from hapticplayer.sequence.comparison import Curves
from hapticplayer.sequence.library import read_entry
from hapticplayer.study.condition_preview import condition_curves
from hapticplayer.study.creation import described
from hapticplayer.study.definition import MAX_CONDITIONS, StudyFeedback, TrialKind

_POLL_MS, _LATER_MS = 40, 300
_LEAST_PX = 200, 80
_NARROW = (QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)


class ConditionList(EntryList):
    """Lists the feedback conditions; of trials other than of ratings the levels, too.

    Args:
        document: of the study.
        study: its folder, which those of its sequences may be relative to.
    """

    def __init__(self, document: StudyDocument, study: Path) -> None:
        add = text_button(self.tr("Add"), self.tr("Choose a condition"))
        super().__init__(document, self.tr("Conditions"), add)
        add.setMenu(self._add_menu())
        self.preview = ConditionPreview(study)
        self.right.addWidget(self.preview)

    def _add_menu(self) -> QMenu:
        menu = QMenu(self)
        for one in FEEDBACKS:
            action = menu.addAction(translated(one.text))
            action.triggered.connect(lambda _on, name=one.name: self.add(name))
        if self._is_of_levels:
            menu.addSeparator()
            action = menu.addAction(self.tr("Level (delay and gain)"))
            action.triggered.connect(lambda _on: self.add_level())
        return menu

    @property
    def _is_of_levels(self) -> bool:
        content = self.document.value
        return content["trial"] != TrialKind.RATING and not content.get("staircase")

    def rows(self) -> list[Row]:
        content = self.document.value
        one_stays = len(content["feedbacks"]) > 1
        rows = [
            Row(condition_words(entry), ("feedbacks", number), may_go=one_stays)
            for number, entry in enumerate(content["feedbacks"])
        ]
        if content["trial"] == TrialKind.RATING:
            return rows
        rows = [Row(self.tr("Conditions")), *rows]
        if content.get("standard"):
            rows += [
                Row(self.tr("Each of them is compared with")),
                Row(self.tr("The standard"), ("standard",), may_go=False),
            ]
        if content.get("staircase"):
            return [*rows, Row(self.tr("Staircase"), ("staircase",), may_go=False)]
        return [
            *rows,
            Row(self.tr("Each of them at these levels")),
            *(
                Row(_level_words(level), ("levels", number))
                for number, level in enumerate(content.get("levels", []))
            ),
        ]

    # --- fields --------------------------------------------------------------------

    def shape(self, place: Place) -> object:
        keys = [one["key"] for one in self.document.value["sequences"]]
        is_feedback = place[:1] == ("feedbacks",)
        name = _chosen(self.document.at(place)).name if is_feedback else ""
        return place, tuple(keys), condition_named(name) is None

    def fill(self, place: Place) -> None:
        if place[0] in ("levels", "standard"):
            self._fill_level(place)
            return
        if place[0] == "staircase":
            self._fill_staircase(place)
            return
        if condition_named(_chosen(self.document.at(place)).name) is None:
            name = _chosen(self.document.at(place)).name
            text = self.tr("The track {name} that each sequence has").format(name=name)
            self.fields.whole(paragraph(text))
        else:
            self._add_form(place)
        self._add_key(place)
        self.fields.whole(
            paragraph(
                self.tr(
                    "Each sequence is played under each condition. Sessions that have "
                    "begun keep theirs."
                ),
                theme.DIM,
            )
        )

    def _fill_level(self, place: Place) -> None:
        delay, gain = ranges.FORCE_DELAY_S, ranges.FORCE_GAIN
        fields = self.fields
        if place[0] == "standard":
            names = [_name_of(one) for one in self.document.value["feedbacks"]]
            keys = [(name, name) for name in names]
            fields.choice(self.tr("Condition"), (*place, "feedback"), keys)
        fields.decimal(self.tr("Delay of the force"), (*place, "delay_s"), delay)
        fields.decimal(
            self.tr("Gain of the force"), (*place, "gain"), gain, usually=1.0
        )
        if place[0] == "levels":
            fields.number(self.tr("Repeats of each trial"), ("repeats",), 1, 100)

    def _fill_staircase(self, place: Place) -> None:
        fields, changed = self.fields, (*place, "changes")
        kinds = [(self.tr("delay"), "delay_s"), (self.tr("gain"), "gain")]
        fields.choice(self.tr("What changes"), changed, kinds)
        correct = [(self.tr("2-down 1-up"), 2), (self.tr("3-down 1-up"), 3)]
        fields.choice(self.tr("Rule"), (*place, "correct"), correct)
        least = Range(0.0, ranges.FORCE_GAIN.largest)
        fields.decimal(self.tr("First change"), (*place, "start"), least)
        fields.listed(self.tr("Steps"), (*place, "steps"))
        most = MAX_CONDITIONS
        fields.number(self.tr("Trials of each"), (*place, "trials"), 2, most)

    def _add_form(self, place: Place) -> None:
        keys = [one["key"] for one in self.document.value["sequences"]]
        form = ConditionForm([], keys)
        self.fields.whole(form)

        def show() -> None:
            form.show_chosen(_chosen(self.document.at(place)))

        def keep() -> None:
            chosen = form.chosen()
            made = StudyFeedback(chosen.name, dict(chosen.parameters), self._key(place))
            text = self.tr("another condition")
            self.document.set(place, described(made), text)

        form.changed.connect(keep)
        self.fields.bind(place, form.condition, show)

    def _add_key(self, place: Place) -> None:
        """The key belongs to an entry that may be a name alone."""
        line = QLineEdit()
        line.setAccessibleName(self.tr("Name in the data"))
        line.setToolTip(self.tr("In data and figures: a to z, 0 to 9, _ and -"))

        def show() -> None:
            key = self._key(place) or ""
            if line.text() != key:
                line.setText(key)
            line.setPlaceholderText(_chosen(self.document.at(place)).name)

        def keep(text: str) -> None:
            chosen = _chosen(self.document.at(place))
            made = StudyFeedback(chosen.name, dict(chosen.parameters), text or None)
            words = self.tr("another name in the data")
            self.document.set(place, described(made), words)

        line.textEdited.connect(keep)
        line.installEventFilter(self.fields)
        self.fields.row(self.tr("Name in the data"), line)
        self.fields.bind((*place, "key"), line, show)

    def _key(self, place: Place) -> str | None:
        entry = self.document.at(place)
        return entry.get("key") if isinstance(entry, dict) else None

    def refresh(self) -> None:
        super().refresh()
        is_condition = self.selected[:1] == ("feedbacks",)
        self.preview.setVisible(is_condition)
        if is_condition:
            self.preview.follow(self.document.value, self.document.at(self.selected))

    # --- what a person does --------------------------------------------------------

    def add(self, name: str) -> None:
        """Add a condition with its usual parameters."""
        entries = self.document.value["feedbacks"]
        taken = [_name_of(entry) for entry in entries]
        entry: Any = name
        if name in taken:
            numbered = (f"{name}-{n}" for n in range(2, 1000))
            key = next(one for one in numbered if one not in taken)
            entry = {"condition": name, "key": key}
        self.selected = ("feedbacks", len(entries))
        self.document.add(("feedbacks",), [entry], self.tr("another condition"))

    def add_level(self) -> None:
        """Add a level that is not there yet."""
        levels = self.document.value["levels"]
        latest_s = max((one.get("delay_s", 0.0) for one in levels), default=0.0)
        delay_s = min(round(latest_s + 0.1, 3), ranges.FORCE_DELAY_S.largest)
        self.selected = ("levels", len(levels))
        entry = {"delay_s": delay_s, "gain": 1.0}
        self.document.add(("levels",), [entry], self.tr("another level"))


def _chosen(entry: Any) -> ChosenFeedback:
    if isinstance(entry, dict):
        return ChosenFeedback(entry["condition"], entry.get("parameters") or {})
    return ChosenFeedback(entry or FEEDBACKS[0].name, {})


def _name_of(entry: Any) -> str:
    return str(
        entry.get("key") or entry["condition"] if isinstance(entry, dict) else entry
    )


def _level_words(level: Mapping[str, float]) -> str:
    delay_ms, gain = 1e3 * level.get("delay_s", 0.0), level.get("gain", 1.0)
    return local(f"{delay_ms:+.0f} ms, \u00d7 {gain:g}")


class ConditionPreview(QWidget):
    """Draws the force of a condition over the recorded one, for a sequence to choose."""

    def __init__(self, study: Path) -> None:
        super().__init__()
        self._study = study
        self._folders: dict[str, Path] = {}
        self._entry: Any = None
        self._shown: object = None
        self.jobs = Jobs(self._on_failed)
        self.sequence = QComboBox()
        self.picture = RenderingPicture((self.tr("Recorded force"), self.tr("Felt")))
        self.picture.setMinimumSize(*_LEAST_PX)
        self.sequence.activated.connect(lambda _row: self._look_later())
        self.sequence.setSizePolicy(*_NARROW)
        caption = captioned(self.tr("Preview of the force"), self.sequence)
        column_of(row_of(caption[0], (self.sequence, 1)), (self.picture, 1), of=self)
        self._later, self._timer = QTimer(self), QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(_LATER_MS)
        self._later.timeout.connect(self._begin)
        self._timer.setInterval(_POLL_MS)
        self._timer.timeout.connect(self._poll)

    def follow(self, content: Mapping[str, Any], entry: Any) -> None:
        """Show an entry, soon."""
        self._entry = entry
        folders = {
            one["key"]: self._study / one["folder"]
            for one in content["sequences"]
            if one["folder"] and not read_entry(self._study / one["folder"]).problem
        }
        if folders != self._folders or not self.sequence.count():
            self._folders = folders
            self._offer(content)
        self._look_later()

    def _offer(self, content: Mapping[str, Any]) -> None:
        held = self.sequence.currentData()
        self.sequence.clear()
        for one in content["sequences"]:
            if one["key"] in self._folders:
                title = text_in(one["title"], content["languages"])
                self.sequence.addItem(title or one["key"], one["key"])
        self.sequence.setCurrentIndex(max(0, self.sequence.findData(held)))

    def _look_later(self) -> None:
        wanted = (self.sequence.currentData(), str(self._entry), str(self._folders))
        if wanted != self._shown:
            self._shown = wanted
            self._later.start()

    def _begin(self) -> None:
        key = self.sequence.currentData()
        if key is None:
            text = self.tr("Choose a recording for a sequence to see the force")
            self.picture.show_curves(None, None, text)
            return
        if self.jobs.is_busy:
            self.jobs.cancel()
            self._later.start()
            return
        folders, chosen = dict(self._folders), _chosen(self._entry)
        feedback = StudyFeedback(chosen.name, dict(chosen.parameters))

        def work(progress: Progress) -> tuple[Curves, Curves]:
            return in_child(condition_curves, folders, key, feedback, progress=progress)

        self.picture.show_curves(None, None, self.tr("Computing the force\u2026"))
        self.jobs.run("", work, lambda made: self.picture.show_curves(*made))
        self._timer.start()

    def _poll(self) -> None:
        self.jobs.poll()
        if not self.jobs.is_busy:
            self._timer.stop()

    def _on_failed(self, problem: BaseException) -> None:
        if not isinstance(problem, HapticPlayerError):
            raise problem
        self.picture.show_curves(None, None, translated(message_of(problem)))

    def close_jobs(self) -> None:
        """Stop what runs and wait for it."""
        self._later.stop()
        self._timer.stop()
        self.jobs.close()
