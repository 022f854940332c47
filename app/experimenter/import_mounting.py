"""Import, step 3: how the recorder was mounted, rendering and name."""

import math
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QLineEdit,
    QSizePolicy,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.import_processing import ProcessingFields
from app.experimenter.rendering_fields import RenderingFields
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    column_of,
    paragraph,
    row_of,
    scrolling,
)
from app.widgets.texts import local
from hapticplayer.capture.mounting import (
    AS_RECORDED,
    BY_FRAMES,
    MOUNTINGS,
    all_mountings,
    axes_matrix,
    gravity_agrees,
    proposed_mounting,
)
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.import_batch import title_of
from hapticplayer.sequence.import_preview import ImportPreview
from hapticplayer.sequence.library import free_name

_SIDE_PX = 210
_HEAD = 0.16
_BOX = np.array([0.42, 0.3, 0.3])  # half sides of the recorder
_TURN, _TILT = np.radians(-32.0), np.radians(22.0)


class Triad(QWidget):
    """The recorder's x, y and z as arrows, seen from behind the actor's left.

    The words right, front and up stay where they are; the recorder turns.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setFixedSize(QSize(_SIDE_PX + 30, _SIDE_PX))
        self.axes = AS_RECORDED
        self._up: tuple[float, float, float] | None = None
        self.show_axes(AS_RECORDED, None)

    def show_axes(self, axes: str, up: tuple[float, float, float] | None) -> None:
        """Show right, front and up of the actor, and where gravity says that up was.

        Both are in the recorder's axes.
        """
        self.axes, self._up = axes, up
        right, front, top = axes.split(",")
        text = self.tr("Right is {right}, front is {front}, up is {up}")
        self.setAccessibleName(text.format(right=right, front=front, up=top))
        self.setToolTip(self.accessibleName())
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        turn = axes_matrix(self.axes)
        self._paint_words(painter)
        self._paint_box(painter, turn)
        arrows = [(turn[:, k], "xyz"[k], theme.AXIS_COLOURS[k]) for k in range(3)]
        for way, name, colour in sorted(arrows, key=lambda arrow: -seen(arrow[0])[2]):
            self._paint_arrow(painter, way, name, QColor(colour))
        if self._up is not None:
            self._paint_gravity(painter, turn @ np.array(self._up))
        painter.end()

    def _at(self, place: Floats) -> QPointF:
        x, y, _ = seen(place)
        scale = 0.29 * self.height()
        return QPointF(0.5 * self.width() + scale * x, 0.55 * self.height() - scale * y)

    def _paint_words(self, painter: QPainter) -> None:
        painter.setPen(QPen(QColor(theme.BORDER), 1, Qt.PenStyle.DotLine))
        for way in np.eye(3):
            painter.drawLine(self._at(-1.2 * way), self._at(1.2 * way))
        painter.setPen(QColor(theme.DIM))
        names = (self.tr("right"), self.tr("front"), self.tr("up"))
        for way, name in zip(np.eye(3), names, strict=True):
            at, wide = self._at(1.8 * way), self.fontMetrics().horizontalAdvance(name)
            beside = at.x() - 0.5 * self.width()
            if abs(beside) > 1.0:  # away from the letter at the arrow
                at += QPointF(math.copysign(0.5 * wide, beside), 0.0)
            self._paint_text(painter, at, name)

    def _paint_text(self, painter: QPainter, at: QPointF, text: str) -> None:
        metrics = self.fontMetrics()
        wide = metrics.horizontalAdvance(text)
        left = min(max(0.0, at.x() - 0.5 * wide), self.width() - wide)
        base = at.y() + 0.35 * metrics.height()
        low = self.height() - metrics.descent()
        painter.drawText(QPointF(left, min(max(metrics.ascent(), base), low)), text)

    def _paint_box(self, painter: QPainter, turn: Floats) -> None:
        """Draw the recorder, its lens on the side where its y is."""
        painter.setPen(QPen(QColor(theme.DIM), 1.2))
        fill = QColor(theme.RAISED)
        fill.setAlpha(190)
        painter.setBrush(fill)
        sides = [(axis, sign) for axis in range(3) for sign in (-1.0, 1.0)]
        for axis, sign in sorted(sides, key=lambda s: -seen(turn[:, s[0]] * s[1])[2]):
            painter.drawPolygon(
                QPolygonF([self._at(turn @ c) for c in _side(axis, sign)])
            )
            if (axis, sign) == (1, 1.0):
                angles = np.linspace(0.0, 2 * np.pi, 25)
                ring = np.stack(
                    [0.2 * np.cos(angles), 0 * angles + _BOX[1], 0.2 * np.sin(angles)]
                )
                painter.drawPolygon(QPolygonF([self._at(turn @ c) for c in ring.T]))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_arrow(
        self, painter: QPainter, way: Floats, name: str, colour: QColor
    ) -> None:
        painter.setPen(QPen(colour, 2.6))
        painter.setBrush(colour)
        tip, foot = self._at(way), self._at(0.0 * way)
        painter.drawLine(foot, self._at((1.0 - _HEAD) * way))
        along = tip - foot
        length = max(1e-6, float(np.hypot(along.x(), along.y())))
        across = QPointF(-along.y(), along.x()) / length * 5.0
        base = self._at((1.0 - _HEAD) * way)
        if length > 12.0:
            painter.drawPolygon(QPolygonF([tip, base + across, base - across]))
        else:  # it points to or from who looks
            painter.drawEllipse(tip, 5.0, 5.0)
        self._paint_text(painter, self._at(1.2 * way) + QPointF(0.0, -3.0), name)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_gravity(self, painter: QPainter, up: Floats) -> None:
        """Draw where gravity says that up was: a dashed line from the middle."""
        painter.setPen(QPen(QColor(theme.TEXT), 1.6, Qt.PenStyle.DashLine))
        painter.drawLine(self._at(0.0 * up), self._at(1.15 * up))


def _side(axis: int, sign: float) -> list[Floats]:
    """Return the corners of one side of the recorder."""
    first, second = (k for k in range(3) if k != axis)
    corners = []
    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        corner = np.zeros(3)
        corner[axis], corner[first], corner[second] = sign, a, b
        corners.append(corner * _BOX)
    return corners


def seen(place: Floats) -> Floats:
    """Return right, up and depth on the screen of a place in frame A."""
    x, y, z = place
    right = np.cos(_TURN) * x + np.sin(_TURN) * y
    deep = -np.sin(_TURN) * x + np.cos(_TURN) * y
    up = np.cos(_TILT) * z + np.sin(_TILT) * deep
    return np.array([right, up, np.cos(_TILT) * deep - np.sin(_TILT) * z])


class MountingPage(QWidget):
    """Asks for mounting, rendering, calibration, title and place."""

    def __init__(self, library: Path) -> None:
        super().__init__()
        self.library = library
        self._up: tuple[float, float, float] | None = None
        self._by_frames: FoundMounting | None = None
        self.mounting = QComboBox()
        self.mounting.setAccessibleName(self.tr("Mounting"))
        self.triad = Triad()
        self.gravity = paragraph()
        self.rendering = RenderingFields(self)
        self.motion = ProcessingFields(self, library)
        self.title = QLineEdit()
        self.title.setAccessibleName(self.tr("Title"))
        self.title.setMaxLength(300)
        self.place = ElidedLabel(str(library), elide=Qt.TextElideMode.ElideMiddle)
        self._fill()
        self._lay_out()
        self.mounting.currentIndexChanged.connect(self._on_mounting)

    def _fill(self) -> None:
        for one in MOUNTINGS.values():
            self.mounting.addItem(translated(one.text), one.axes)
        text = self.tr("Right {right}, front {front}, up {up}")
        for axes in all_mountings()[len(MOUNTINGS) :]:
            right, front, up = axes.split(",")
            self.mounting.addItem(text.format(right=right, front=front, up=up), axes)
        self.mounting.addItem(
            self.tr("As the frames show, when it is imported"), BY_FRAMES
        )

    def _lay_out(self) -> None:
        change = text_button(
            self.tr("Change\u2026"), self.tr("Choose another library folder")
        )
        change.clicked.connect(self._choose_library)
        form = self._form = QFormLayout()
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
        form.addRow(self.tr("&Mounting"), self.mounting)
        form.addRow("", self.gravity)
        self.rendering.add_rows(form)
        self.motion.add_rows(form)
        of_recording = (self.mounting, self.gravity, self.rendering.lever_arm)
        self._of_recording = (*of_recording, *self.motion.rows)
        form.addRow(self.tr("&Title"), self.title)
        form.addRow(self.tr("Library"), row_of((self.place, 1), change))
        hint = paragraph(
            self.tr(
                "The drawing shows the recorder on the wearer, who faces "
                "forward; the dashed line shows which way was up, from gravity."
            ),
            theme.DIM,
        )
        self._drawing = QWidget()
        column_of(row_of(STRETCH, self.triad, STRETCH), hint, STRETCH, of=self._drawing)
        row_of((scrolling(form), 3), (self._drawing, 2), spacing=18, of=self)

    def show_found(self, found: ImportPreview) -> None:
        """Propose the mounting that the frames show, or in which up is up, and a title."""
        self._show_recording(is_recorded=True)
        self._up = found.up
        shown = found.found.mounting if found.found else None
        is_right = shown and shown.is_clear and gravity_agrees(found.up, shown.axes)
        self._by_frames = shown if is_right else None
        axes = shown.axes if shown and is_right else proposed_mounting(found.up)
        said = found.provenance.get("recording", {}).get("mounting", "")
        at = self.mounting.findData(said)
        self.mounting.setCurrentIndex(at if at >= 0 else self.mounting.findData(axes))
        self._on_mounting()
        self.title.setText(title_of(found.clip.path))

    def show_suggested(self, video: Path) -> None:
        """Ask for rendering, title and place alone: nothing was mounted anywhere."""
        self._show_recording(is_recorded=False)
        self.rendering.lever_arm.setCurrentIndex(0)  # the recorder itself
        self.title.setText(title_of(video))

    def _show_recording(self, *, is_recorded: bool) -> None:
        for row in self._of_recording:
            self._form.setRowVisible(row, is_recorded)
        self._drawing.setVisible(is_recorded)

    @property
    def axes(self) -> str:
        """Right, front and up in the recorder's axes."""
        return str(self.mounting.currentData())

    def target(self) -> Path:
        """Return the folder that will be made."""
        return free_name(self.library, self.title.text())

    def _on_mounting(self) -> None:
        shown = self._by_frames.axes if self._by_frames else AS_RECORDED
        is_later = self.axes == BY_FRAMES
        self.triad.show_axes(shown if is_later else self.axes, self._up)
        if is_later:
            text = self.tr(
                "Taken from the frames if they show it clearly; else you are asked."
            )
            colour = theme.DIM
        elif self._by_frames is not None and self._by_frames.axes == self.axes:
            text = self.tr(
                "The frames show this mounting (ratio {ratio} to the next best); "
                "gravity does not contradict it."
            )
            text = text.format(ratio=local(f"{self._by_frames.ratio:.2f}"))
            colour = theme.GOOD
        elif self._up is None:
            text = self.tr(
                "The sensor rotated too much to determine the mounting from gravity."
            )
            colour = theme.WARN
        elif gravity_agrees(self._up, self.axes):
            text = self.tr(
                "Consistent with gravity. Only you know which side faced forward."
            )
            colour = theme.GOOD
        else:
            text = self.tr("Not consistent with gravity: another side was up.")
            colour = theme.BAD
        self.gravity.setText(text)
        self.gravity.setStyleSheet(f"color: {colour};")

    def _choose_library(self) -> None:
        title = self.tr("Choose the library folder")
        dialog = folder_dialog(self, title, str(self.library))
        dialog.fileSelected.connect(self._take_library)
        dialog.open()

    def _take_library(self, path: str) -> None:
        self.library = Path(path)
        self.place.set_text(path)
