"""What the participant sees, small, on the operator's screen."""

from PySide6.QtCore import QCoreApplication, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.bridge.cadence import Cadence
from app.player.letterbox import letterbox
from app.player.video_surface import VideoSurface
from app.widgets import theme

RATE_HZ = 10.0  # enough to see where the clip is
_WIDTH_PX, _HEIGHT_PX = 320, 180


class Mirror(QWidget):
    """Draws the picture that was decoded for the participant once more, smaller.

    Nothing is decoded, copied or kept: a picture takes 0.3 ms, ten times a second. The
    pages are not mirrored: their answers are the participant's.

    Args:
        surface: the participant's.
    """

    def __init__(self, surface: VideoSurface) -> None:
        super().__init__()
        self._surface, self._is_clip = surface, False
        self._turn = Cadence(RATE_HZ)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self.setMinimumSize(_WIDTH_PX // 2, _HEIGHT_PX // 2)
        self.setAccessibleName(
            QCoreApplication.translate("Mirror", "The participant's picture")
        )

    def sizeHint(self) -> QSize:
        """Ask for a fourth of a usual picture."""
        return QSize(_WIDTH_PX, _HEIGHT_PX)

    def follow(self, now_s: float, *, is_clip: bool) -> None:
        """Draw anew if it is time; `is_clip` says whether the clip is on the screen."""
        is_due = self._turn.is_due(now_s)
        if is_clip != self._is_clip or (is_clip and is_due):
            self._is_clip = is_clip
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Scale the picture in the cheapest way."""
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), QColor("black"))
            image = self._surface.image if self._is_clip else None
            if image is not None:
                size = (image.width(), image.height())
                box = letterbox(size, (self.width(), self.height()))
                painter.drawImage(QRectF(*box), image)
            else:
                painter.setPen(QColor(theme.LOOKS[theme.DARK]["DIM"]))
                text = QCoreApplication.translate("Mirror", "A page is shown")
                painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, text)
            painter.setPen(QColor(theme.BORDER))  # black has no edge on black
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
