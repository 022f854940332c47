"""The grip of the device in space, with the force on it: what would be felt."""

import math

from PySide6.QtCore import QEvent, QPointF, QSize, QSizeF, Qt
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.plots.grip_painter import GripPainter, excursion_text, force_text
from app.plots.grip_scene import Camera, Grip
from app.widgets import theme
from app.widgets.voice import tell_change

LEAST_PX = QSize(150, 80)
WANTED_PX = QSize(300, 200)
_RAD_PER_PX = math.radians(0.5)
_KEY_RAD = math.radians(10.0)
_ZOOM_PER_NOTCH = 1.15
_NOTCH = 120.0  # of a wheel, in Qt's eighths of a degree
_KEYS = Qt.Key
# Key to steps of yaw, of pitch and of the zoom.
_MOVES = {
    _KEYS.Key_Left: (-1, 0, 0),
    _KEYS.Key_Right: (1, 0, 0),
    _KEYS.Key_Up: (0, 1, 0),
    _KEYS.Key_Down: (0, -1, 0),
    _KEYS.Key_Plus: (0, 0, 1),
    _KEYS.Key_Equal: (0, 0, 1),
    _KEYS.Key_Minus: (0, 0, -1),
}
_RESET_KEY = _KEYS.Key_0


class GripView(QWidget):
    """Shows a grip; a drag or the arrow keys go round it.

    Repainted only when something visible has changed. A click leaves the keyboard focus
    where it is, so that the arrow keys still seek; Tab brings it here.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(LEAST_PX)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setCursor(Qt.CursorShape.OpenHandCursor)
        self.setToolTip(
            self.tr(
                "Thick arrow: force on the hand. Thin white arrow: planned "
                "force. Purple arrow: the share that keeps the grip in the "
                "workspace.\nDrag or use the arrow keys to rotate, the wheel or "
                "+ and \u2212 to zoom, double-click or 0 to reset."
            )
        )
        self._painter = GripPainter()
        self._drag_from: QPointF | None = None
        self.camera = Camera()
        self.grip = Grip(self.tr("Simulated grip"), self.tr("No device"))
        self.setAccessibleName(self.grip.title)

    def sizeHint(self) -> QSize:
        return WANTED_PX

    def show_grip(self, grip: Grip) -> None:
        """Show where the grip is and what acts on it."""
        if grip == self.grip:
            return
        is_news = (grip.title, grip.state) != (self.grip.title, self.grip.state)
        self.grip = grip
        if is_news:
            self.setAccessibleName(grip.title)
            tell_change(self)  # only then, else it never ends
        self.update()

    def spoken(self) -> str:
        """State and figures."""
        if self.grip.position_m is None:
            return self.grip.state
        figures = self.tr("force {force}, grip {out} from the centre").format(
            force=force_text(self.grip), out=excursion_text(self.grip)
        )
        return f"{self.grip.state}. {figures}"

    # --- looking from elsewhere ----------------------------------------------

    def look(self, camera: Camera) -> None:
        if camera != self.camera:
            self.camera = camera
            self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag_from = event.position()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._drag_from is None:
            return
        way = event.position() - self._drag_from
        self._drag_from = event.position()
        self.look(self.camera.turned(-_RAD_PER_PX * way.x(), _RAD_PER_PX * way.y()))

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        self._drag_from = None
        self.setCursor(Qt.CursorShape.OpenHandCursor)

    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        self.look(Camera())

    def wheelEvent(self, event: QWheelEvent) -> None:
        notches = event.angleDelta().y() / _NOTCH
        self.look(self.camera.zoomed(_ZOOM_PER_NOTCH**notches))
        event.accept()

    def event(self, event: QEvent) -> bool:
        """Keep the keys that turn the scene from the window's shortcuts."""
        is_override = event.type() == QEvent.Type.ShortcutOverride
        if is_override and isinstance(event, QKeyEvent) and _is_ours(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not _is_ours(event):
            super().keyPressEvent(event)
        elif event.key() == _RESET_KEY:
            self.look(Camera())
        else:
            yaw, pitch, nearer = _MOVES[Qt.Key(event.key())]
            turned = self.camera.turned(_KEY_RAD * yaw, _KEY_RAD * pitch)
            self.look(turned.zoomed(_ZOOM_PER_NOTCH**nearer))

    # --- painting ------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the scene, and a frame while the keyboard is here."""
        with QPainter(self) as painter:  # ends it whatever happens
            self._painter.paint(painter, QSizeF(self.size()), self.camera, self.grip)
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.FOCUS), 2.0))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRect(self.rect().adjusted(1, 1, -1, -1))


def _is_ours(event: QKeyEvent) -> bool:
    keypad = Qt.KeyboardModifier.KeypadModifier | Qt.KeyboardModifier.ShiftModifier
    has_other = event.modifiers() & ~keypad
    return not has_other and (event.key() in _MOVES or event.key() == _RESET_KEY)
