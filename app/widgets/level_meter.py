"""A level meter: one bar for each channel of a sound card that plays forces."""

from PySide6.QtCore import QCoreApplication, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.widgets import theme
from app.widgets.texts import local, titled
from hapticplayer.model.device import ChannelLevel

translate = QCoreApplication.translate

LEAST_DB = -48.0
_STEP_DB = 3.0
"""A reader of the screen hears of changes as large as this."""
_WIDEST_PX, _NARROWEST_PX = 140.0, 20.0
_GAP_PX, _BETWEEN_PX = 4.0, 12.0
_AT_LEFT = int(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)


class LevelMeter(QWidget):
    """Bars from -48 to 0 dB of full scale; hidden while there is nothing to show.

    The square behind a bar is filled while the soft limiter works.

    Args:
        title: of what plays; first word of the accessible name.
        is_narrow: without numbers of channels, for a line with little room.
    """

    def __init__(self, title: str, *, is_narrow: bool = False) -> None:
        super().__init__()
        self.title = title
        self.levels: tuple[ChannelLevel, ...] = ()
        self._is_narrow = is_narrow
        wide = QSizePolicy.Policy.Fixed if is_narrow else QSizePolicy.Policy.Expanding
        self.setSizePolicy(wide, QSizePolicy.Policy.Fixed)
        self.hide()

    def show_levels(self, levels: tuple[ChannelLevel, ...]) -> None:
        """Show these channels; none hides the meter."""
        if len(levels) != len(self.levels):
            self.updateGeometry()
        if levels == self.levels:
            return
        self.levels = levels
        self.setVisible(bool(levels))
        said = titled(self.title, levels_text(levels, _STEP_DB))
        if said != self.accessibleName():
            self.setAccessibleName(said)
        self.setToolTip(levels_text(levels))
        self.update()

    def sizeHint(self) -> QSize:
        return self._size(_NARROWEST_PX if self._is_narrow else _WIDEST_PX)

    def minimumSizeHint(self) -> QSize:
        return self._size(_NARROWEST_PX)

    def _size(self, bar_px: float) -> QSize:
        each_px = self._around_px() + bar_px + _BETWEEN_PX
        height_px = self.fontMetrics().height()
        return QSize(round(max(1, len(self.levels)) * each_px), height_px)

    def paintEvent(self, _event: QPaintEvent) -> None:
        if not self.levels:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        each = self.width() / len(self.levels) - _BETWEEN_PX
        bar = min(_WIDEST_PX, each - self._around_px())
        for place, level in enumerate(self.levels):
            left = place * (self._around_px() + bar + _BETWEEN_PX)
            self._paint_channel(painter, left, bar, level)

    def _paint_channel(
        self, painter: QPainter, left: float, bar: float, level: ChannelLevel
    ) -> None:
        height, number = float(self.height()), self._number_px()
        thick = self._mark_px()
        top = round((height - thick) / 2.0)
        if number:
            painter.setPen(QColor(theme.DIM))
            painter.drawText(
                QRectF(left, 0.0, number, height), _AT_LEFT, str(level.channel)
            )
        groove = QRectF(left + number + 0.5, top, bar - 1.0, thick)
        painter.fillRect(groove, QColor(theme.FLOOR))
        share = min(1.0, max(0.0, 1.0 - level.peak_db / LEAST_DB))
        filled = QRectF(groove.left(), top, groove.width() * share, thick)
        painter.fillRect(filled, QColor(theme.GOOD))
        painter.setPen(QPen(QColor(theme.BORDER), 1.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(groove)
        mark = QRectF(groove.right() + _GAP_PX, top, thick, thick)
        painter.setBrush(QColor(theme.BAD if level.is_limited else theme.FLOOR))
        painter.drawRect(mark)

    def _number_px(self) -> float:
        if self._is_narrow:
            return 0.0
        return self.fontMetrics().horizontalAdvance("8") + _GAP_PX

    def _mark_px(self) -> float:
        return round(0.5 * self.fontMetrics().height())

    def _around_px(self) -> float:
        """Return the room of what is beside a bar."""
        return self._number_px() + _GAP_PX + self._mark_px()


def levels_text(levels: tuple[ChannelLevel, ...], step_db: float = 1.0) -> str:
    """The levels in words, in steps of so many dB."""
    return ", ".join(_level_text(one, step_db) for one in levels)


def _level_text(level: ChannelLevel, step_db: float) -> str:
    if level.peak_db < LEAST_DB:
        text = translate("LevelMeter", "channel {channel} silent")
    elif level.is_limited:
        text = translate("LevelMeter", "channel {channel} {db} dB, limited")
    else:
        text = translate("LevelMeter", "channel {channel} {db} dB")
    db = f"{step_db * round(level.peak_db / step_db) + 0.0:.0f}"
    return text.format(channel=level.channel, db=local(db))
