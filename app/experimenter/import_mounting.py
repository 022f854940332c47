"""Third page of an import: how the recorder sat, and what becomes of it."""

from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from app.experimenter.triad import Triad
from app.player.files import folder_dialog
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.labels import ElidedLabel
from app.widgets.room import indent
from hapticplayer.capture.limits import UPRIGHT
from hapticplayer.capture.mounting import (
    MOUNTINGS,
    all_mountings,
    proposed_mounting,
    up_in_frame_a,
)
from hapticplayer.model import Mapping
from hapticplayer.model.mapping import DEFAULT_GAIN_N_PER_MPS2, M_AD
from hapticplayer.sequence.library import free_name
from hapticplayer.sequence.recognising import Recognised

_TURNS = {
    "ahead": np.eye(3),
    "right": np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
    "behind": np.diag([-1.0, 1.0, -1.0]),
    "left": np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]),
}
"""How the device stands, about its up axis, in frame D."""


class MountingPage(QWidget):
    """Asks for mounting, direction of the device, gain, title and place.

    Args:
        library: the folder in which sequences are kept.
    """

    def __init__(self, library: Path) -> None:
        super().__init__()
        self.library = library
        self._up: tuple[float, float, float] | None = None
        self.mounting, self.device = QComboBox(), QComboBox()
        self.mounting.setAccessibleName(self.tr("Mounting"))
        self.device.setAccessibleName(self.tr("The device stands"))
        self.triad = Triad()
        self.gravity = QLabel()
        self.gravity.setWordWrap(True)
        self.gain = QDoubleSpinBox()
        self.gain.setAccessibleName(self.tr("Gain"))
        self.gain.setRange(0.01, 5.0)
        self.gain.setDecimals(2)
        self.gain.setSingleStep(0.05)
        self.gain.setValue(DEFAULT_GAIN_N_PER_MPS2)
        self.gain.setSuffix(self.tr(" N per m/s\u00b2"))
        indent(self.gain)
        self.gain.setToolTip(
            self.tr("The same for all sequences that are to be compared")
        )
        self.title = QLineEdit()
        self.title.setAccessibleName(self.tr("Title"))
        self.title.setMaxLength(300)
        self.place = ElidedLabel(str(library), elide=Qt.TextElideMode.ElideMiddle)
        self._fill()
        self._lay_out()
        self.mounting.currentIndexChanged.connect(self._on_mounting)

    def _fill(self) -> None:
        names = {
            "forward": self.tr("Looks forward, upright"),
            "upside-down": self.tr("Looks forward, upside down"),
            "backward": self.tr("Looks backward, upright"),
            "to-the-right": self.tr("Looks to the right, upright"),
            "to-the-left": self.tr("Looks to the left, upright"),
            "left-side-up": self.tr("Looks forward, left side up"),
            "right-side-up": self.tr("Looks forward, right side up"),
            "to-the-sky": self.tr("Lies on its back, looks up"),
            "to-the-ground": self.tr("Looks down"),
        }
        for name, axes in MOUNTINGS.items():
            self.mounting.addItem(names[name], axes)
        text = self.tr("Right {right}, front {front}, up {up}")
        for axes in all_mountings()[len(MOUNTINGS) :]:
            right, front, up = axes.split(",")
            self.mounting.addItem(text.format(right=right, front=front, up=up), axes)
        stands = {
            "ahead": self.tr("before its user: forward pulls the hand away"),
            "right": self.tr("to the right of its user"),
            "behind": self.tr("behind its user"),
            "left": self.tr("to the left of its user"),
        }
        for name, text in stands.items():
            self.device.addItem(text, name)

    def _lay_out(self) -> None:
        change = text_button(
            self.tr("Change\u2026"), self.tr("Keep sequences in another folder")
        )
        change.clicked.connect(self._choose_library)
        place = QHBoxLayout()
        place.addWidget(self.place, 1)
        place.addWidget(change)
        form = QFormLayout()
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        form.setVerticalSpacing(10)
        form.addRow(self.tr("&Mounting"), self.mounting)
        form.addRow("", self.gravity)
        form.addRow(self.tr("The &device stands"), self.device)
        form.addRow(self.tr("&Gain"), self.gain)
        form.addRow(self.tr("&Title"), self.title)
        form.addRow(self.tr("Library"), place)
        hint = QLabel(
            self.tr(
                "The drawing shows the recorder on its actor, who looks to the front; "
                "the dashed line is where gravity says that up was."
            )
        )
        hint.setWordWrap(True)
        hint.setStyleSheet(f"color: {theme.DIM};")
        beside = QVBoxLayout()
        beside.addWidget(self.triad, 0, Qt.AlignmentFlag.AlignHCenter)
        beside.addWidget(hint)
        beside.addStretch(1)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(18)
        row.addLayout(form, 3)
        row.addLayout(beside, 2)

    def show_found(self, found: Recognised) -> None:
        """Propose the mounting in which up is up, and a title."""
        self._up = found.up
        at = self.mounting.findData(proposed_mounting(found.up))
        self.mounting.setCurrentIndex(at)
        self._on_mounting()
        self.title.setText(found.clip.path.stem)

    @property
    def axes(self) -> str:
        """Right, front and up in the recorder's axes."""
        return str(self.mounting.currentData())

    def mapping(self) -> Mapping:
        """Return what becomes of the motion."""
        turn = _TURNS[str(self.device.currentData())]
        return Mapping(turn @ M_AD, gain_n_per_mps2=self.gain.value())

    def target(self) -> Path:
        """Return the folder that will be made."""
        return free_name(self.library, self.title.text())

    def _on_mounting(self) -> None:
        self.triad.show_axes(self.axes, self._up)
        if self._up is None:
            text = self.tr(
                "It turned so much that gravity does not tell which is right."
            )
            colour = theme.WARN
        elif up_in_frame_a(self._up, self.axes)[2] >= UPRIGHT:
            text = self.tr(
                "Gravity agrees. Which side was the front only you can know."
            )
            colour = theme.GOOD
        else:
            text = self.tr("Gravity says that another side was up.")
            colour = theme.BAD
        self.gravity.setText(text)
        self.gravity.setStyleSheet(f"color: {colour};")

    def _choose_library(self) -> None:
        title = self.tr("Where shall sequences be kept?")
        dialog = folder_dialog(self, title, str(self.library))
        dialog.fileSelected.connect(self._take_library)
        dialog.open()

    def _take_library(self, path: str) -> None:
        self.library = Path(path)
        self.place.set_text(path)
