"""What is being recorded: picture, level, acceleration, angular rate, and figures."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.bridge.languages import translated
from app.player.video_surface import letterbox
from app.plots.panel import titled_plot
from app.plots.playhead_plot import PlayheadPlot
from app.plots.series import Page, ViewSpan, cut, half_range, thin
from app.widgets import theme
from app.widgets.layout import column_of, framed, paragraph, row_of
from app.widgets.level_meter import LevelMeter
from app.widgets.texts import local, time_text
from hapticplayer.capture.live.recorder_state import RecorderState
from hapticplayer.errors import Message
from hapticplayer.model.device import ChannelLevel

LEAST_ACCEL_MPS2, LEAST_RATE_RADPS = 12.0, 1.0
FULL_DB = -1.0
"""Sound above it is nearly distorted."""

MOST_NOTICES = 3
_LEAST_PLOT_PX = 56
_LEAST_PICTURE_PX = (160, 90)


class TrailingSpan(ViewSpan):
    """The seconds before now, in place of those around it."""

    def around(self, media_s: float) -> tuple[float, float]:
        last_s = media_s + self.offset_s
        return last_s - 2.0 * self.half_s, last_s


class LivePlot(PlayheadPlot):
    """Three lines that scroll; the scale follows what is in view."""

    def __init__(self, name: str, least: float, span: TrailingSpan) -> None:
        super().__init__(name, (1.0,), span)
        self.setMinimumHeight(_LEAST_PLOT_PX)
        self.setToolTip(
            self.tr("Wheel or + and \u2212: zoom. Double-click or Enter: reset")
        )
        self._least, self._half = least, 0.0
        self.show_samples(Page(np.empty(0), np.empty((0, 3))), 0.0)

    def show_samples(self, samples: Page, now_s: float) -> None:
        """Draw the latest samples, over the seconds since the start."""
        shown = thin(cut(*samples, *self.span.around(now_s)))
        peak = float(np.abs(shown.values).max(initial=0.0))
        if (half := half_range(peak, self._least)) != self._half:
            self._half = half
            self.set_half_range(half)
        self.set_lines(0, shown)
        self.set_playhead(now_s)


class LivePicture(QWidget):
    """The latest frame of the camera, as large as fits; a text where there is none."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(self.tr("Live picture"))
        self.text = ""
        self._image: QImage | None = None

    def minimumSizeHint(self) -> QSize:
        return QSize(*_LEAST_PICTURE_PX)

    def show_frame(self, rgb: NDArray[np.uint8] | None, text: str = "") -> None:
        """Show a frame (height, width, 3), or a text in its place."""
        self._image, self.text = None, text
        if rgb is not None:
            high, wide, _ = rgb.shape
            kind = QImage.Format.Format_RGB888
            pixels = np.ascontiguousarray(rgb)
            self._image = QImage(pixels.tobytes(), wide, high, 3 * wide, kind).copy()
        self.setAccessibleDescription(text)
        self.update()

    @property
    def has_frame(self) -> bool:
        return self._image is not None

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), QColor(theme.FLOOR))
            if self._image is None:
                painter.setPen(QColor(theme.DIM))
                words = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignCenter
                painter.drawText(self.rect(), int(words), self.text)
                return
            size = self._image.size()
            box = letterbox((size.width(), size.height()), self.size().toTuple())
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(QRectF(*box), self._image)


class LivePane(QWidget):
    """Shows the state of a recorder; empty while there is none."""

    def __init__(self) -> None:
        super().__init__()
        span, axes = TrailingSpan(), ("x", "y", "z")
        self.picture, self.level = LivePicture(), LevelMeter(self.tr("Microphone"))
        self.accel = LivePlot(
            self.tr("Acceleration of the last seconds"), LEAST_ACCEL_MPS2, span
        )
        self.rate = LivePlot(
            self.tr("Angular rate of the last seconds"), LEAST_RATE_RADPS, span
        )
        title = self.tr("Acceleration with gravity, m/s\u00b2")
        above = titled_plot(title, axes, "", self.accel)
        below = titled_plot(self.tr("Angular rate, rad/s"), axes, "", self.rate)
        self.figures, self.notices = paragraph(lines=1), paragraph("", theme.WARN)
        self.felt = paragraph("", theme.ACCENT)
        self.felt.hide()
        for label in (self.figures, self.felt, self.notices):
            label.setTextFormat(Qt.TextFormat.PlainText)
        seen = column_of((framed(self.picture), 1), self.level, spacing=4)
        plots = column_of((above, 1), (below, 1), spacing=4)
        row = row_of((seen, 1), (plots, 1), spacing=10)
        column_of((row, 1), self.figures, self.felt, self.notices, spacing=6, of=self)

    def say(self, text: str) -> None:
        """Say how it is felt."""
        self.felt.setText(text)
        self.felt.setVisible(bool(text))

    def clear(self) -> None:
        """Show nothing."""
        self.picture.show_frame(None)
        self.level.show_levels(())
        empty = Page(np.empty(0), np.empty((0, 3)))
        for plot in (self.accel, self.rate):
            plot.show_samples(empty, 0.0)
        self.say("")
        self.figures.clear()
        self.notices.clear()

    def show_state(self, now: RecorderState, how: Message) -> None:
        """Show a recording as it is now, and how its sensor is started until it is."""
        is_camera = now.frame is not None
        self.picture.show_frame(now.frame, "" if is_camera else self.tr("No camera"))
        levels: tuple[ChannelLevel, ...] = ()
        if now.level_db is not None:
            peak = 10.0 ** (now.level_db / 20.0)
            levels = (ChannelLevel(1, peak, now.level_db > FULL_DB),)
        self.level.show_levels(levels)
        for plot, values in ((self.accel, now.accel_mps2), (self.rate, now.rate_radps)):
            plot.show_samples(Page(now.time_s, values), now.elapsed_s)
        self.figures.setText(self._figures(now))
        said = [*([how] if how and not now.samples else []), *now.notices]
        self.notices.setText("\n".join(map(translated, said[-MOST_NOTICES:])))

    def _figures(self, now: RecorderState) -> str:
        parts = [time_text(now.elapsed_s)]
        if now.frames:
            text = self.tr("camera {rate} fps, dropped {lost}")
            rate = local(f"{now.camera_hz:.1f}")
            parts.append(text.format(rate=rate, lost=now.dropped_frames))
        if now.samples:
            text = self.tr("sensor {rate} Hz, lost {lost}")
            rate = local(f"{now.imu_hz:.1f}")
            parts.append(text.format(rate=rate, lost=now.dropped_samples))
        parts.append(self.tr("gaps {count}").format(count=len(now.gaps)))
        if now.marks_s:
            parts.append(self.tr("marks {count}").format(count=len(now.marks_s)))
        free = local(f"{now.free_bytes / 1e9:.1f}")
        parts.append(self.tr("{free} GB free").format(free=free))
        return "  \u00b7  ".join(parts)
