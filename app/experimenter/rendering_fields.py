"""The fields of a rendering: preset, gain, axes, lever arm, knee.

The import wizard and the rendering dialog show the same ones.
"""

from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFormLayout,
    QLineEdit,
    QSizePolicy,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.numbers import NumberBox, ThreeNumbers
from app.player.choices import preset_name
from app.widgets import theme
from app.widgets.layout import STRETCH, captioned, paragraph, row_of
from app.widgets.texts import local
from hapticplayer.capture.mounting import axes_text, device_axes
from hapticplayer.model import Mapping, PresetName, ranges
from hapticplayer.model.arrays import Floats
from hapticplayer.model.mapping import M_AD, SOFT_KNEE_N
from hapticplayer.rendering import LEVER_ARMS_M
from hapticplayer.sequence.presets import DEFAULT_PRESET, PRESETS

translate = QCoreApplication.translate

ONE, EACH, FIT = "one", "each", "fit"
"""Kinds of gain."""

OTHER = "other"
_RECORDER = "recorder"
_HERE = (0.0, 0.0, 0.0)

_DEVICE_TURNS = {
    "ahead": np.eye(3),
    "right": np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
    "behind": np.diag([-1.0, 1.0, -1.0]),
    "left": np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]),
}
"""Rotations of the device about its up axis, in frame D."""


class Chosen(NamedTuple):
    """What the fields say.

    Attributes:
        mapping: its gain is not used where it is fitted.
        fits_gain: whether the gain is to be fitted to the clip.
        preset: how the force is rendered.
    """

    mapping: Mapping
    fits_gain: bool
    preset: PresetName


class RenderingFields(QObject):
    """Fields for the rows of a form, and what they say."""

    changed = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._axes: Floats = M_AD
        self._limit_n = Mapping().force_limit_n
        self._knee_n = SOFT_KNEE_N
        self._is_showing = False
        self._make_preset()
        self._make_gain()
        self._make_axes()
        self._make_lever_arm()
        self.knee = QCheckBox(
            self.tr("S&often strong forces (soft knee at {knee} N)").format(
                knee=local(f"{SOFT_KNEE_N:g}")
            )
        )
        self.knee.setToolTip(
            self.tr("Compresses what is above instead of cutting it at the limit")
        )
        self.form: QFormLayout | None = None
        self.show_chosen(Chosen(Mapping(), False, DEFAULT_PRESET))
        for combo in (self.preset, self.gain_kind, self.device, self.lever_arm):
            combo.currentIndexChanged.connect(lambda _row: self._on_changed())
        self.gain.valueChanged.connect(lambda _value: self._on_changed())
        self.gains.changed.connect(self._on_changed)
        self.axes.textChanged.connect(lambda _text: self._on_changed())
        self.point.changed.connect(self._on_changed)
        self.knee.toggled.connect(lambda _is_on: self._on_changed())

    # --- building ------------------------------------------------------------

    def _make_preset(self) -> None:
        self.preset = _combo(self.tr("Rendering"))
        for one in PRESETS:
            self.preset.addItem(preset_name(one.name), one.name)
        self.preset_text = paragraph(colour=theme.DIM, lines=2)
        self.preset_text.setAlignment(Qt.AlignmentFlag.AlignTop)

    def _make_gain(self) -> None:
        self.gain_kind = _combo(self.tr("Kind of gain"))
        self.gain_kind.addItem(self.tr("One for all axes"), ONE)
        self.gain_kind.addItem(self.tr("One for each axis"), EACH)
        self.gain_kind.addItem(self.tr("Fitted to this clip"), FIT)
        within, unit = ranges.GAIN_N_PER_MPS2, self.tr(" N per m/s\u00b2")
        self.gain = NumberBox(self.tr("Gain"), within, 4, 0.05, unit)
        self.gain.setToolTip(
            self.tr("Use the same gain for all sequences that you compare")
        )
        self.gains = ThreeNumbers(
            self.tr("Gain"), device_names(), ranges.GAIN_N_PER_MPS2, 4, 0.05
        )
        self.gain_text = paragraph(colour=theme.DIM)

    def _make_axes(self) -> None:
        self.device = _combo(self.tr("Device position"))
        places = {
            "ahead": self.tr("in front of the user: forward pulls the hand away"),
            "right": self.tr("to the right of the user"),
            "behind": self.tr("behind the user"),
            "left": self.tr("to the left of the user"),
            OTHER: self.tr("other axes"),
        }
        for name, text in places.items():
            self.device.addItem(text, name)
        self.axes = QLineEdit()
        self.axes.setAccessibleName(self.tr("Axes"))
        self.axes.setMaxLength(200)
        self.axes_text = paragraph(
            self.tr(
                "The device\u2019s right, up and towards the user in the wearer\u2019s axes "
                "(x right, y front, z up), such as x,z,-y, or the nine numbers of a "
                "rotation, row by row"
            ),
            theme.DIM,
        )

    def _make_lever_arm(self) -> None:
        names = {
            "handlebar": self.tr("Handlebar"),
            "seat": self.tr("Seat"),
            "head": self.tr("Head"),
        }
        self.lever_arm = _combo(self.tr("Felt point"))
        self.lever_arm.addItem(self.tr("the recorder itself"), _RECORDER)
        for name in LEVER_ARMS_M:
            text = self.tr("{point}, from a recorder on the chest")
            self.lever_arm.addItem(text.format(point=names.get(name, name)), name)
        self.lever_arm.addItem(self.tr("another point"), OTHER)
        title, ways = (
            self.tr("From the recorder"),
            (
                self.tr("right"),
                self.tr("front"),
                self.tr("up"),
            ),
        )
        self.point = ThreeNumbers(
            title, ways, ranges.LEVER_ARM_M, 3, 0.05, self.tr(" m")
        )

    def add_rows(self, form: QFormLayout) -> None:
        """Put the fields into a form."""
        self.form = form
        form.addRow(self.tr("&Rendering"), self.preset)
        form.addRow("", self.preset_text)
        caption, kind = captioned(self.tr("&Gain"), self.gain_kind)
        form.addRow(caption, row_of((kind, 1), self.gain, spacing=6))
        form.addRow("", self.gains)
        form.addRow("", self.gain_text)
        form.addRow(self.tr("&Device position"), self.device)
        form.addRow("", self.axes)
        form.addRow("", self.axes_text)
        form.addRow(self.tr("&Felt point"), self.lever_arm)
        form.addRow("", self.point)
        form.addRow("", row_of(self.knee, STRETCH))
        self._show_needed()

    # --- what is chosen ------------------------------------------------------

    def show_chosen(self, chosen: Chosen) -> None:
        """Show a rendering."""
        mapping = chosen.mapping
        self._is_showing = True
        self._axes, self._limit_n = mapping.axes, mapping.force_limit_n
        self._knee_n = mapping.soft_knee_n or SOFT_KNEE_N
        self.preset.setCurrentIndex(self.preset.findData(chosen.preset))
        gains = mapping.gains_n_per_mps2.tolist()
        kind = EACH if isinstance(mapping.gain_n_per_mps2, tuple) else ONE
        self.gain_kind.setCurrentIndex(
            self.gain_kind.findData(FIT if chosen.fits_gain else kind)
        )
        self.gain.set_number(gains[0])
        self.gains.set_numbers(gains)
        self.device.setCurrentIndex(self.device.findData(_place_of(mapping.axes)))
        self.axes.setText(axes_text(mapping.axes))
        self.lever_arm.setCurrentIndex(
            self.lever_arm.findData(_arm_of(mapping.lever_arm_m))
        )
        self.point.set_numbers(mapping.lever_arm_m)
        self.knee.setChecked(mapping.soft_knee_n is not None)
        self._is_showing = False
        self._show_needed()

    def chosen(self) -> Chosen:
        """The choices in the fields."""
        kind = self.gain_kind.currentData()
        mapping = Mapping(
            self._chosen_axes(),
            self.gains.numbers() if kind == EACH else self.gain.number(),
            self._limit_n,
            self._knee_n if self.knee.isChecked() else None,
            self._chosen_arm(),
        )
        preset = PresetName(self.preset.currentData())
        return Chosen(mapping, kind == FIT, preset)

    def offer_fit(self, gain_n_per_mps2: float | None) -> None:
        """Say which gain would be fitted; None where there is no motion."""
        if gain_n_per_mps2 is None:
            self.gain_text.clear()
        else:
            text = self.tr(
                "Fitted to this clip: {gain} N per m/s\u00b2. Sequences with different "
                "gains cannot be compared"
            )
            self.gain_text.setText(text.format(gain=local(f"{gain_n_per_mps2:.3g}")))
        self._show_needed()

    def _chosen_axes(self) -> Floats:
        place = self.device.currentData()
        if place != OTHER:
            return np.asarray(_DEVICE_TURNS[place] @ M_AD)
        typed = self.axes.text()
        return self._axes if typed == axes_text(self._axes) else device_axes(typed)

    def _chosen_arm(self) -> tuple[float, float, float]:
        point = self.lever_arm.currentData()
        if point == OTHER:
            return self.point.numbers()
        return LEVER_ARMS_M.get(point, _HERE)

    # --- showing -------------------------------------------------------------

    def _on_changed(self) -> None:
        if not self._is_showing:
            self._begin_others_here()
            self._show_needed()
            self.changed.emit()

    def _begin_others_here(self) -> None:
        """Let fields that are hidden begin with what is chosen, once they are shown."""
        self._is_showing = True
        if self.lever_arm.currentData() != OTHER:
            self.point.set_numbers(self._chosen_arm())
        if self.device.currentData() != OTHER:
            self._axes = self._chosen_axes()
            self.axes.setText(axes_text(self._axes))
        if self.gain_kind.currentData() == ONE:
            self.gains.set_numbers([self.gain.number()] * 3)
        self._is_showing = False

    def _show_needed(self) -> None:
        """Show the fields that the choices need."""
        preset = next(one for one in PRESETS if one.name == self.preset.currentData())
        self.preset_text.setText(translated(preset.text))
        kind = self.gain_kind.currentData()
        self.gain.setVisible(kind == ONE)
        needed = {
            self.gains: kind == EACH,
            self.gain_text: bool(self.gain_text.text()),
            self.axes: self.device.currentData() == OTHER,
            self.axes_text: self.device.currentData() == OTHER,
            self.point: self.lever_arm.currentData() == OTHER,
        }
        if self.form is not None:
            for widget, is_needed in needed.items():
                self.form.setRowVisible(widget, is_needed)


def device_names() -> tuple[str, str, str]:
    """The names of a device's axes."""
    return (
        translate("RenderingFields", "right"),
        translate("RenderingFields", "up"),
        translate("RenderingFields", "towards the user"),
    )


def _combo(name: str) -> QComboBox:
    made = QComboBox()
    made.setAccessibleName(name)
    # long choices must not make the window wider than a screen
    made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return made


def _place_of(axes: Floats) -> str:
    for place, turn in _DEVICE_TURNS.items():
        if np.array_equal(turn @ M_AD, axes):
            return place
    return OTHER


def _arm_of(arm_m: tuple[float, float, float]) -> str:
    if arm_m == _HERE:
        return _RECORDER
    return next((name for name, at_m in LEVER_ARMS_M.items() if at_m == arm_m), OTHER)
