"""A small editor of a study: what most people change; the rest is in study.json."""

import copy
import json
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QScrollArea,
    QSpinBox,
    QTabWidget,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.feedback_list import FeedbackList
from app.widgets import theme
from app.widgets.buttons import set_role, text_button
from app.widgets.layout import fill_page, indent, paragraph, resize_within_screen
from hapticplayer.errors import InputError, message_of
from hapticplayer.study.creation import change_definition
from hapticplayer.study.definition import OrderMethod
from hapticplayer.study.study_folder import Study

WIDTH_PX, HEIGHT_PX = 960, 640
_MOST = 2**31 - 1


class StudyEditor(QDialog):
    """Edits the definition of a study; sessions keep the one they began with."""

    def __init__(self, study: Study, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.study = study
        self._content: dict[str, Any] = json.loads(study.content)
        self.setWindowTitle(
            self.tr("Study \u2013 {name}").format(name=study.folder.name)
        )
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.texts: dict[tuple[str, ...], QLineEdit] = {}
        self.folders: dict[str, QLineEdit] = {}
        self.problem = paragraph("", theme.BAD)
        self.problem.hide()
        tabs = QTabWidget()
        tabs.addTab(self._general(), self.tr("General"))
        tabs.addTab(self._sequences(), self.tr("Sequences"))
        keys = [entry["key"] for entry in self._content["sequences"]]
        self.feedbacks = FeedbackList(self._content["feedbacks"], keys)
        tabs.addTab(self.feedbacks, self.tr("Feedbacks"))
        tabs.addTab(self._questions(), self.tr("Questions"))
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Save
            | QDialogButtonBox.StandardButton.Cancel
        )
        save = buttons.button(QDialogButtonBox.StandardButton.Save)
        set_role(save, "primary")
        buttons.accepted.connect(self.save)
        buttons.rejected.connect(self.reject)
        fill_page(self, tabs, self.problem, buttons)

    def _general(self) -> QWidget:
        content, page = self._content, QWidget()
        form = QFormLayout(page)
        self.title = QLineEdit(content["title"])
        self.method = QComboBox()
        for method, text in self._methods().items():
            self.method.addItem(text, method.value)
        self.method.setCurrentIndex(self.method.findData(content["order"]["method"]))
        self.seed = QSpinBox()
        self.seed.setRange(0, _MOST)
        indent(self.seed)
        self.seed.setValue(min(_MOST, content["order"]["seed"]))
        self.apart = QCheckBox(self.tr("Never the same sequence twice in a row"))
        self.apart.setChecked(content["order"]["no_sequence_twice_in_a_row"])
        self.blind = QCheckBox(self.tr("Hide the condition from the operator"))
        self.blind.setChecked(content["operator_is_blind"])
        self.published = QCheckBox(self.tr("Use the published wording where available"))
        self.published.setChecked(content["use_published"])
        self.lsl = QCheckBox(
            self.tr("Stream markers and force to other programs on this computer (LSL)")
        )
        self.lsl.setChecked(content.get("lsl", False))
        form.addRow(self.tr("Title"), self.title)
        form.addRow(self.tr("Order"), self.method)
        form.addRow(self.tr("Seed"), self.seed)
        for box in (self.apart, self.blind, self.published, self.lsl):
            form.addRow("", box)
        return page

    def _methods(self) -> dict[OrderMethod, str]:
        return {
            OrderMethod.RANDOM: self.tr("Random for each participant"),
            OrderMethod.LATIN_SQUARE: self.tr("Latin square"),
            OrderMethod.WILLIAMS: self.tr("Williams: balanced for carry-over"),
            OrderMethod.LIST: self.tr("From orders.csv"),
        }

    def _sequences(self) -> QWidget:
        page = QWidget()
        form = QFormLayout(page)
        for entry in self._content["sequences"]:
            line = self.folders[entry["key"]] = QLineEdit(entry["folder"])
            browse = text_button(
                self.tr("Browse\u2026"), self.tr("Choose a sequence folder")
            )
            browse.clicked.connect(lambda _on, line=line: self._browse(line))
            row = QHBoxLayout()
            form.addRow(entry["key"], row)  # first, else Python frees what is in it
            row.addWidget(line, 1)
            row.addWidget(browse)
        return page

    def _browse(self, line: QLineEdit) -> None:
        folder = QFileDialog.getExistingDirectory(
            self, self.tr("Sequence folder"), line.text()
        )
        if folder:
            line.setText(str(Path(folder)))

    def _questions(self) -> QWidget:
        page = QWidget()
        form = QFormLayout(page)
        for number, factor in enumerate(self._content["factors"]):
            for language in self._content["languages"]:
                for kind in ("text", "published"):
                    texts = factor.get(kind) or {}
                    line = QLineEdit(texts.get(language, ""))
                    line.setCursorPosition(0)
                    self.texts[str(number), kind, language] = line
                    name = f"{factor['key']}, {language}"
                    if kind == "published":
                        name += self.tr(" (published)")
                    form.addRow(name, line)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setWidget(page)
        return area

    def edited(self) -> dict[str, Any]:
        """Return the definition as it is filled in now."""
        content = copy.deepcopy(self._content)
        content["title"] = self.title.text()
        content["order"] = {
            "method": self.method.currentData(),
            "seed": self.seed.value(),
            "no_sequence_twice_in_a_row": self.apart.isChecked(),
        }
        content["operator_is_blind"] = self.blind.isChecked()
        content["use_published"] = self.published.isChecked()
        content["lsl"] = self.lsl.isChecked()
        content["feedbacks"] = copy.deepcopy(self.feedbacks.entries)
        for entry in content["sequences"]:
            entry["folder"] = self.folders[entry["key"]].text()
        for (number, kind, language), line in self.texts.items():
            factor = content["factors"][int(number)]
            if kind == "text":
                factor["text"][language] = line.text()
            elif line.text().strip():
                factor["published"] = {
                    **(factor["published"] or {}),
                    language: line.text(),
                }
            elif factor.get("published"):
                factor["published"].pop(language, None)
        return content

    def save(self) -> None:
        """Keep what is filled in, unless something is wrong with it."""
        try:
            self.study = change_definition(self.study, self.edited())
        except InputError as problem:
            self.problem.setText(translated(message_of(problem)))
            self.problem.show()
        else:
            self.accept()
