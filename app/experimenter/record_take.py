"""A take shown back: picture, sound and motion without gravity on one time line."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QWidget

from app.bridge.languages import translated
from app.bridge.pump import Pump
from app.experimenter.record_feel import MakePlayer
from app.experimenter.sync_strip import OF_CLIP, OF_LOG, Lane, SyncStrip
from app.player.video_surface import SurfaceSink, VideoSurface
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, column_of, framed, paragraph, row_of
from app.widgets.texts import capitalised, local, position_text
from hapticplayer.capture.recorded import Take
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.model import ClockMap
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.take_overview import TakeOverview

_STEP_S, _FAR_S = 1.0, 5.0
_NEAR_PX, _FLAG_PX = 7, 6
_FRAME_S = 0.1  # of a slow camera: a mark is shown by the frame before it
_MOST_NOTICES = 4


class TakeStrip(SyncStrip):
    """The time line of a take with its marks, in which a click or the arrows seek."""

    sought = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.marks_s: list[float] = []
        self.setAccessibleName(self.tr("The take over time"))
        self.setToolTip(
            self.tr(
                "Click: seek, beside a mark exactly to it. Left and Right: 1 s, with "
                "Shift 5 s. Up and Down: previous and next mark. Wheel: zoom"
            )
        )
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def show_marks(self, marks_s: Sequence[float]) -> None:
        """Show what a person marked while it was recorded."""
        self.marks_s = sorted(marks_s)
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at_s = self._time_at(event)
        nearest_s = min(self.marks_s, key=lambda one: abs(one - at_s), default=at_s)
        is_near = abs(nearest_s - at_s) <= _NEAR_PX * self._s_per_px()
        self.sought.emit(nearest_s if is_near else at_s)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons():
            self.sought.emit(self._time_at(event))

    def _time_at(self, event: QMouseEvent) -> float:
        return max(0.0, self.view_s[0] + event.position().x() * self._s_per_px())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, at_s = Qt.Key(event.key()), self.cursor_s or 0.0
        if way := {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(key):
            is_far = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
            self.sought.emit(max(0.0, at_s + way * (_FAR_S if is_far else _STEP_S)))
        elif key == Qt.Key.Key_Down:
            self._seek_first(one for one in self.marks_s if one > at_s + _FRAME_S)
        elif key == Qt.Key.Key_Up:
            self._seek_first(one for one in self.marks_s[::-1] if one < at_s - _FRAME_S)
        else:
            event.ignore()

    def _seek_first(self, marks_s: Iterator[float]) -> None:
        if (mark_s := next(marks_s, None)) is not None:
            self.sought.emit(mark_s)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        colour, high_px = QColor(theme.WARN), self.fontMetrics().height()
        with QPainter(self) as painter:
            for number, mark_s in enumerate(self.marks_s, 1):
                x = (mark_s - self.view_s[0]) / self._s_per_px()
                painter.setPen(QPen(colour, 1.0, Qt.PenStyle.DashLine))
                painter.drawLine(QPointF(x, 0.0), QPointF(x, self.lanes_px))
                wide_px = self.fontMetrics().horizontalAdvance(str(number)) + _FLAG_PX
                flag = QRectF(x, self.lanes_px - high_px, wide_px, high_px)
                painter.fillRect(flag, colour)
                painter.setPen(QColor(theme.PANEL))
                painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, str(number))


class TakeView(QWidget):
    """Plays a take without force; `end` lets go of the player."""

    def __init__(self, clock: Clock, make_player: MakePlayer) -> None:
        super().__init__()
        self._clock, self._make_player = clock, make_player
        self.player: Player | None = None
        self._pump: Pump | None = None
        self._duration_s = 0.0
        self.surface, self.strip = VideoSurface(), TakeStrip()
        self.said = paragraph(lines=2)
        self.said.setTextFormat(Qt.TextFormat.PlainText)
        self.position = paragraph("", theme.DIM)
        self.play = text_button(
            self.tr("&Play"), self.tr("Play the take with its sound")
        )
        self.play.clicked.connect(self.toggle)
        self.strip.sought.connect(self.seek)
        self._picture = framed(self.surface)
        controls = row_of(self.play, self.position, STRETCH, spacing=10)
        aside = column_of(self.said, STRETCH, controls)
        above = row_of((self._picture, 1), (aside, 1), spacing=12)
        column_of((above, 3), (self.strip, 2), spacing=8, of=self)

    def show_take(self, take: Take, clip: Path | None) -> None:
        """Show another take from its beginning, without its curves."""
        self.end()
        self.said.setText(self._said(take))
        self.strip.show_lanes([], (), ClockMap(0.0, 1.0))
        self.strip.show_marks(take.marks_s)
        self._picture.setVisible(clip is not None)
        self.play.setVisible(clip is not None)
        self._duration_s = 0.0
        if clip is not None:
            self._open(clip)
        self.strip.show_span(0.0, self._duration_s)
        self.strip.point_at(0.0)
        self._follow()

    @property
    def has_clip(self) -> bool:
        return self.player is not None

    def _open(self, path: Path) -> None:
        source = open_source(path)
        self._duration_s = source.clip.duration_s
        self.player = self._make_player(
            self._clock, SurfaceSink(self.surface), NO_DEVICE
        )
        self.surface.set_clip_size(source.clip.width, source.clip.height)
        self.player.open(source)
        self._pump = Pump(self.player.poll, self._clock, self._follow, self)
        self._pump.start()

    def show_overview(self, found: TakeOverview) -> None:
        """Show what the take holds over time."""
        self._duration_s = max(self._duration_s, found.duration_s)
        lanes = [Lane(self.tr("sound"), found.sound, OF_CLIP)]
        if found.motion is not None:
            size = np.linalg.norm(found.motion.acceleration_mps2, axis=1)
            name = self.tr("acceleration without gravity, p")
            lanes.append(Lane(name, (found.motion.time_s, size), OF_LOG))
        self.strip.show_lanes(lanes, found.taps_s, ClockMap(0.0, 1.0))
        self.strip.show_span(0.0, self._duration_s)
        more = self._said_of_motion(found)
        self.said.setText("\n".join(filter(None, (more, self._said(found.take)))))
        self._follow()

    def end(self) -> None:
        """Stop playing, and close the player."""
        if self._pump is not None:
            self._pump.stop()
        player, self.player, self._pump = self.player, None, None
        if player is not None:
            player.close()
            self.surface.clear()

    def toggle(self) -> None:
        if self.player is not None:
            self.player.toggle()

    def seek(self, media_s: float) -> None:
        media_s = min(media_s, self._duration_s)
        self.strip.point_at(media_s)
        if self.player is not None:
            self.player.seek(media_s)

    def _follow(self) -> None:
        """Move the cursor with the picture, and name what the button does."""
        if self.player is not None:
            now = self.player.snapshot()
            if now.media_s != self.strip.cursor_s:
                self.strip.point_at(now.media_s)
            self.play.setText(self.tr("&Pause") if now.is_playing else self.tr("&Play"))
        at_s = self.strip.cursor_s or 0.0
        self.position.setText(position_text(at_s, self._duration_s))

    def _said(self, take: Take) -> str:
        """What was lost, and how far the clocks may be apart."""
        parts = []
        if take.camera:
            text = self.tr("dropped frames: {count}")
            parts.append(text.format(count=take.camera.dropped))
        if take.imu:
            text = self.tr("lost samples: {count}")
            parts.append(text.format(count=take.imu.dropped))
        if take.marks_s:
            parts.append(self.tr("marks: {count}").format(count=len(take.marks_s)))
        if take.clock:
            text = self.tr("residual of the sensor's clock: {ms} ms")
            ms = local(f"{1e3 * take.clock.residual_s:.1f}")
            parts.append(text.format(ms=ms))
        return "\n".join([capitalised(", ".join(parts)), *take.notices[:_MOST_NOTICES]])

    def _said_of_motion(self, found: TakeOverview) -> str:
        if found.problem:
            return translated(found.problem)
        if found.motion is None:
            return self.tr(
                "No motion was recorded; the import can suggest some from the frames."
            )
        if not found.taps_s:
            return self.tr("No three taps were found: the clocks decide.")
        text = self.tr(
            "Taps found: {count}. By them the clocks are {ms} ms apart, which the "
            "import corrects."
        )
        ms = local(f"{1e3 * found.taps_late_s:+.1f}")
        return text.format(count=len(found.taps_s), ms=ms)
