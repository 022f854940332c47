"""Chooses a feedback condition and its parameters, as the registry lists them."""

from collections.abc import Callable, Iterable
from typing import Any

from PySide6.QtCore import QCoreApplication, Signal, SignalInstance
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QWidget,
)

from app.bridge.languages import translated
from app.player.choices import preset_name
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    fill_page,
    indent,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.texts import capitalised
from hapticplayer.model.ranges import Range
from hapticplayer.rendering import (
    FEEDBACKS,
    ChosenFeedback,
    FeedbackCondition,
    Parameter,
    ParameterKind,
    condition_named,
)
from hapticplayer.rendering.condition import Value

translate = QCoreApplication.translate

WIDTH_PX, HEIGHT_PX = 520, 300
_STEP = 0.1


class ConditionForm(QWidget):
    """A list of conditions, and a field for each parameter of the one chosen.

    `changed` means that a person has chosen something else.

    Args:
        tracks: further tracks that can be chosen by name.
        clips: names of the other sequences; None asks for a folder.
        offered: conditions to choose from.
    """

    changed = Signal()

    def __init__(
        self,
        tracks: Iterable[str],
        clips: Iterable[str] | None = None,
        offered: Iterable[FeedbackCondition] = FEEDBACKS,
    ) -> None:
        super().__init__()
        self._tracks, self._clips = list(tracks), clips and list(clips)
        self.condition = QComboBox()
        for one in offered:
            self.condition.addItem(translated(one.text), one.name)
        self.meaning = paragraph("")
        self._form = QFormLayout(self)
        self._form.addRow(translate("ConditionForm", "Feedback"), self.condition)
        self._form.addRow("", self.meaning)
        self._read: dict[str, Callable[[], Value]] = {}
        self._write: dict[str, Callable[[Any], object]] = {}
        self.condition.currentIndexChanged.connect(lambda _row: self._on_condition())
        self._show()

    def chosen(self) -> ChosenFeedback:
        """Return the condition; parameters that leave it open are left out."""
        values = {name: read() for name, read in self._read.items()}
        given = {name: value for name, value in values.items() if value != ""}
        return ChosenFeedback(self.condition.currentData(), given)

    def show_chosen(self, chosen: ChosenFeedback) -> None:
        """Show a condition with its parameters."""
        if chosen == self.chosen():
            return
        self.blockSignals(True)
        self.condition.setCurrentIndex(self.condition.findData(chosen.name))
        for name, value in chosen.parameters.items():
            if name in self._write:
                self._write[name](value)
        self.blockSignals(False)

    def _on_condition(self) -> None:
        self._show()
        self.changed.emit()

    def _show(self) -> None:
        while self._form.rowCount() > 2:
            self._form.removeRow(2)
        self._read, self._write = {}, {}
        condition = condition_named(self.condition.currentData())
        assert condition is not None
        text = capitalised(translated(condition.meaning))
        self.meaning.setText(f"{text}." if text else "")
        for parameter in condition.parameters:
            make = {
                ParameterKind.NUMBER: self._number,
                ParameterKind.WORD: self._word,
                ParameterKind.CLIP: self._clip,
                ParameterKind.TRACK: self._track,
            }[parameter.kind]
            make(parameter)

    def _add(
        self,
        parameter: Parameter,
        field: QWidget,
        read: Callable[[], Value],
        write: Callable[[Any], object],
        edited: SignalInstance,
    ) -> None:
        edited.connect(lambda *_: self.changed.emit())
        self._write[parameter.name] = write
        field.setObjectName(parameter.name)
        field.setAccessibleName(translated(parameter.text))
        self._read[parameter.name] = read
        self._form.addRow(translated(parameter.text), field)

    def _add_combo(self, parameter: Parameter, combo: QComboBox) -> None:
        def choose(value: Any) -> None:
            combo.setCurrentIndex(combo.findData(value))

        changed = combo.currentIndexChanged
        self._add(parameter, combo, combo.currentData, choose, changed)

    def _number(self, parameter: Parameter) -> None:
        limits, spin = parameter.range or Range(0.0, 0.0), QDoubleSpinBox()
        spin.setDecimals(3)
        spin.setRange(limits.least, limits.largest)
        spin.setSingleStep(_STEP)
        spin.setSuffix(f" {limits.unit}" if limits.unit else "")
        spin.setValue(float(parameter.default))
        indent(spin)
        self._add(parameter, spin, spin.value, spin.setValue, spin.valueChanged)

    def _word(self, parameter: Parameter) -> None:
        combo = QComboBox()
        combo.addItem(translate("ConditionForm", "As rendered"), "")
        for choice in parameter.choices:
            combo.addItem(preset_name(choice), choice)
        self._add_combo(parameter, combo)

    def _track(self, parameter: Parameter) -> None:
        if not self._tracks:  # of sequences that are not known here
            line = QLineEdit()
            line.setPlaceholderText(self._own_effects())
            self._add(parameter, line, line.text, line.setText, line.textEdited)
            return
        combo = QComboBox()
        combo.addItem(self._own_effects(), "")
        for name in self._tracks:
            combo.addItem(name, name)
        self._add_combo(parameter, combo)

    @staticmethod
    def _own_effects() -> str:
        return translate("ConditionForm", "With the effects of the sequence")

    def _clip(self, parameter: Parameter) -> None:
        if self._clips is None:
            self._folder(parameter)
            return
        combo = QComboBox()
        combo.addItem(translate("ConditionForm", "The next one"), "")
        for name in self._clips:
            combo.addItem(name, name)
        self._add_combo(parameter, combo)

    def _folder(self, parameter: Parameter) -> None:
        row, line = QWidget(), QLineEdit()
        line.setAccessibleName(translated(parameter.text))
        browse = text_button(
            translate("ConditionForm", "Browse\u2026"),
            translate("ConditionForm", "Choose a sequence folder"),
        )

        def choose() -> None:
            dialog = folder_dialog(self, translated(parameter.text), line.text())
            dialog.fileSelected.connect(line.setText)
            dialog.open()

        browse.clicked.connect(choose)
        both = QHBoxLayout(row)
        both.setContentsMargins(0, 0, 0, 0)
        both.addWidget(line, 1)
        both.addWidget(browse)
        self._add(parameter, row, line.text, line.setText, line.textChanged)


class ConditionDialog(QDialog):
    """Asks for a feedback to be felt; `wanted` has it."""

    wanted = Signal(object)

    def __init__(self, tracks: Iterable[str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Other feedback"))
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        offered = [one for one in FEEDBACKS if one.is_derived or one.parameters]
        self.form = ConditionForm(tracks, offered=offered)
        self.play_button = text_button(
            self.tr("&Play"), self.tr("Make this force and play it"), "primary"
        )
        self.play_button.setDefault(True)
        self.play_button.clicked.connect(self._play)
        cancel = text_button(self.tr("&Cancel"), "")
        cancel.clicked.connect(self.reject)
        fill_page(self, (self.form, 1), row_of(STRETCH, cancel, self.play_button))

    def _play(self) -> None:
        self.wanted.emit(self.form.chosen())
        self.accept()
