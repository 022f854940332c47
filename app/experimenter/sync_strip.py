"""What clip and log tell over time, and the frames of the clip around it."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from app.bridge.jobs import Job
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import column_of, row_of
from app.widgets.texts import local, time_text
from hapticplayer.media.thumbnails import Thumbnail, thumbnails
from hapticplayer.model import ClockMap

HEIGHT_PX = 132


class ClipFrame(QWidget):
    """Decodes one frame at a time in a thread; of several requests the last counts."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.frame, self.time = QLabel(), QLabel()
        self.frame.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.frame.setFixedHeight(HEIGHT_PX)
        self.frame.setMinimumWidth(HEIGHT_PX * 16 // 9)
        self.frame.setStyleSheet(f"background: {theme.BACKGROUND};")
        self.frame.setAccessibleName(self.tr("Frame at the cursor"))
        self.time.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.time.setStyleSheet(f"color: {theme.DIM};")
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        column_of(self.frame, self.time, spacing=2, of=self)
        self.shown_s: float | None = None
        self._path: Path | None = None
        self._wanted_s: float | None = None
        self._job: Job[list[Thumbnail]] | None = None

    def use(self, path: Path | None) -> None:
        """Show frames of another clip from now on."""
        self._path, self._wanted_s, self.shown_s = path, None, None
        self.frame.clear()
        self.time.clear()

    def request(self, media_s: float) -> None:
        """Show the frame at a time as soon as it is decoded."""
        self._wanted_s = max(0.0, media_s)

    def poll(self) -> None:
        """Take over what is decoded, and begin with what is wanted."""
        job = self._job
        if job is not None and job.is_done:
            self._job = None
            self._show(job.result or [])
        if self._job is None and self._wanted_s is not None and self._path is not None:
            path, at_s, self._wanted_s = self._path, self._wanted_s, None
            height_px = round(HEIGHT_PX * self.devicePixelRatioF())
            self._job = Job(
                "",
                lambda progress: thumbnails(path, [at_s], height_px, progress=progress),
            )
            self._job.start()

    def close_jobs(self) -> None:
        """Wait for the frame that is being decoded."""
        if self._job is not None:
            self._job.cancel()
            self._job.join()
            self._job = None

    def _show(self, made: list[Thumbnail]) -> None:
        for one in made:
            kind = QImage.Format.Format_RGB888
            image = QImage(one.rgb, one.width, one.height, 3 * one.width, kind)
            shown = QPixmap.fromImage(image)
            shown.setDevicePixelRatio(self.devicePixelRatioF())
            self.frame.setPixmap(shown)
            self.time.setText(time_text(one.media_s, digits=3))
            self.shown_s = one.media_s


class Sides(QWidget):
    """A choice between taps and frames, shown where they disagree."""

    chosen = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        taps = self.tr("Synchronise by the tap marks alone")
        frames = self.tr("Synchronise by the frames alone")
        self.taps = text_button(self.tr("Use the taps"), taps)
        self.frames = text_button(self.tr("Use the frames"), frames)
        self.taps.clicked.connect(lambda _on=False: self.chosen.emit("pats"))
        self.frames.clicked.connect(lambda _on=False: self.chosen.emit("frames"))
        row_of(self.taps, self.frames, of=self)
        self.hide()


STEP_S = 0.001
FRAME_S = 1.0 / 30.0
_PEAK_SHARE, _MOST_PEAKS = 0.2, 12
_LEAST_SHARE = 0.1  # of a lane's largest value: less does not fill it, noise would
PAT, OF_LOG, OF_CLIP = range(3)  # indices of the axis colours
_CURVE_SHARE = 0.7  # of the height of a low lane, where its name covers the curve
_CLOSE_UP_S = 6.0
_SHORTEST_S = 0.05
_ZOOM = 1.25
_MARGIN_PX, _LABELS_PX = 6, 20
_TICKS = 8

Curve = tuple[NDArray[np.float64], NDArray[np.float64]]


class Lane(NamedTuple):
    """A curve of the clip over media time, or one of the log over its own clock.

    Attributes:
        name: for people.
        curve: times, s, and values of any unit, 0 or more.
        of: OF_CLIP or OF_LOG.
    """

    name: str
    curve: Curve
    of: int


class SyncStrip(QWidget):
    """Lanes over media time; those of the log are on its clock, shifted.

    Drag moves the log's lanes, the arrows move them by 1 ms (Shift: 10 ms, Ctrl: 100
    ms), the wheel zooms, drag with the right button moves the view. A cursor follows
    the pointer; comma and point move it by a frame. `shifted` and `pointed` are in s,
    the latter media time.
    """

    shifted = Signal(float)
    pointed = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Clip and log over time"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(320, 130)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.shift_s, self.rate = 0.0, 1.0
        self.view_s = (0.0, 1.0)
        self.lanes: tuple[Lane, ...] = ()
        self._pats_s: tuple[float, ...] = ()
        self._is_by_turns = False
        self._held_x: float | None = None
        self.cursor_s: float | None = None
        self.setMouseTracking(True)

    def show_lanes(
        self,
        lanes: Sequence[Lane],
        pats_s: tuple[float, ...],
        clock: ClockMap,
        *,
        is_by_turns: bool = False,
    ) -> None:
        """Show curves, and where pats are heard, with the log on a clock map.

        Close up are the pats, or else (`is_by_turns`) where the camera turned most.
        """
        self.lanes = tuple(lane for lane in lanes if len(lane.curve[0]))
        self._pats_s, self.rate = pats_s, clock.rate
        self._is_by_turns = is_by_turns or not pats_s
        self.setAccessibleDescription(", ".join(lane.name for lane in self.lanes))
        self.set_shift(clock.offset_s)
        self.show_whole()

    def set_shift(self, shift_s: float) -> None:
        """Move the log's lanes."""
        self.shift_s = shift_s
        self.update()

    def show_whole(self) -> None:
        ends_s = [lane.curve[0][-1] for lane in self.lanes if lane.of == OF_CLIP]
        self.show_span(0.0, float(max(ends_s, default=1.0)))

    def show_close_up(self) -> None:
        """Show the first three pats, or where the camera turned most."""
        if not self._is_by_turns:
            self.show_span(self._pats_s[0] - 0.4, self._pats_s[:3][-1] + 0.6)
            return
        for lane in reversed(self.lanes):
            if lane.of == OF_CLIP:
                at_s = busiest_s(lane.curve, _CLOSE_UP_S)
                self.show_span(at_s - 0.5 * _CLOSE_UP_S, at_s + 0.5 * _CLOSE_UP_S)
                return

    def point_at(self, media_s: float) -> None:
        """Put the cursor somewhere."""
        self.cursor_s = max(0.0, media_s)
        self.pointed.emit(self.cursor_s)
        self.update()

    def felt_s(self) -> list[float]:
        """Return the media times of the strongest of the log's peaks in the view."""
        felt = next((lane for lane in self.lanes if lane.of == OF_LOG), None)
        if felt is None:
            return []
        time_s, size = self._shown(felt)
        first, last = np.searchsorted(time_s, self.view_s)
        part = size[first:last]
        if len(part) < 3:
            return []
        inner = part[1:-1]
        is_peak = (inner >= part[:-2]) & (inner > part[2:])
        is_peak &= inner > _PEAK_SHARE * part.max()
        peaks = np.flatnonzero(is_peak)
        strongest = np.sort(peaks[np.argsort(-inner[peaks])][:_MOST_PEAKS])
        return [float(at) for at in time_s[first + 1 + strongest]]

    def show_span(self, begin_s: float, end_s: float) -> None:
        self.view_s = (begin_s, max(end_s, begin_s + _SHORTEST_S))
        self.update()

    # --- a person's hands ------------------------------------------------------

    def _s_per_px(self) -> float:
        return (self.view_s[1] - self.view_s[0]) / max(1, self.width())

    def _choose(self, shift_s: float) -> None:
        self.set_shift(round(shift_s / STEP_S) * STEP_S)
        self.shifted.emit(self.shift_s)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._held_x = event.position().x()
        self._held_shift_s, self._held_view_s = self.shift_s, self.view_s

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held_x is None:
            at_s = self.view_s[0] + event.position().x() * self._s_per_px()
            self.point_at(at_s)
            return
        moved_s = (event.position().x() - self._held_x) * self._s_per_px()
        if event.buttons() & Qt.MouseButton.RightButton:
            begin_s, end_s = self._held_view_s
            self.show_span(begin_s - moved_s, end_s - moved_s)
        else:
            self._choose(self._held_shift_s + moved_s)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held_x = None
        event.accept()

    def wheelEvent(self, event: QWheelEvent) -> None:
        begin_s, end_s = self.view_s
        at_s = begin_s + event.position().x() * self._s_per_px()
        factor = _ZOOM ** (-event.angleDelta().y() / 120.0)
        self.show_span(at_s - factor * (at_s - begin_s), at_s + factor * (end_s - at_s))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        frame = {Qt.Key.Key_Comma: -1, Qt.Key.Key_Period: 1}.get(Qt.Key(event.key()))
        if frame is not None:
            middle_s = 0.5 * (self.view_s[0] + self.view_s[1])
            at_s = middle_s if self.cursor_s is None else self.cursor_s
            self.point_at(at_s + frame * FRAME_S)
            return
        direction = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()))
        if direction is None:
            super().keyPressEvent(event)
            return
        steps = 1
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            steps = 10
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            steps = 100
        self._choose(self.shift_s + direction * steps * STEP_S)

    # --- painting --------------------------------------------------------------

    @property
    def lanes_px(self) -> float:
        """Height of all lanes, above the times."""
        return float(self.height() - _LABELS_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(theme.PANEL))
        bottom = self.lanes_px
        self._paint_pats(painter, bottom)
        height = bottom / max(1, len(self.lanes))
        for place, lane in enumerate(self.lanes):
            self._paint_lane(
                painter, QRectF(0, place * height, self.width(), height), lane
            )
        self._paint_times(painter)
        if self.cursor_s is not None:
            painter.setPen(QColor(theme.TEXT))
            x = (self.cursor_s - self.view_s[0]) / self._s_per_px()
            painter.drawLine(QPointF(x, 0), QPointF(x, bottom))
        if self.hasFocus():
            painter.setPen(QColor(theme.FOCUS))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()

    def _shown(self, lane: Lane) -> Curve:
        """Return a curve over media time."""
        time_s, value = lane.curve
        if lane.of == OF_LOG:
            time_s = self.rate * time_s + self.shift_s
        return time_s, value

    def _paint_lane(self, painter: QPainter, place: QRectF, lane: Lane) -> None:
        painter.setPen(QColor(theme.BORDER))
        painter.drawLine(place.bottomLeft(), place.bottomRight())
        x, y = columns(self._shown(lane), self.view_s, max(1, self.width()))
        if len(x):
            least = _LEAST_SHARE * float(lane.curve[1].max())
            top = max(float(y.max()), least, 1e-9)
            words = _MARGIN_PX + painter.fontMetrics().height()
            floor, high = place.bottom() - 2, place.height()
            space = max(high - 4 - words, _CURVE_SHARE * high)
            points = [QPointF(x[0], floor)]
            points += [
                QPointF(a, floor - space * b / top) for a, b in zip(x, y, strict=True)
            ]
            fill = QColor(theme.AXIS_COLOURS[lane.of])
            painter.setPen(fill)
            fill.setAlpha(90)
            painter.setBrush(fill)
            painter.drawPolygon(QPolygonF([*points, QPointF(x[-1], floor)]))
            painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QColor(theme.DIM))
        inner = place.adjusted(_MARGIN_PX, _MARGIN_PX, 0, 0)
        painter.drawText(inner, Qt.AlignmentFlag.AlignTop, lane.name)

    def _paint_pats(self, painter: QPainter, height: float) -> None:
        painter.setPen(QColor(theme.AXIS_COLOURS[PAT]))
        for at_s in self._pats_s:
            x = (at_s - self.view_s[0]) / self._s_per_px()
            painter.drawLine(QPointF(x, 0), QPointF(x, height))

    def _paint_times(self, painter: QPainter) -> None:
        begin_s, end_s = self.view_s
        step_s = tick_step_s((end_s - begin_s) / _TICKS)
        painter.setPen(QColor(theme.DIM))
        for tick in range(int(np.ceil(begin_s / step_s)), int(end_s / step_s) + 1):
            x = (tick * step_s - begin_s) / self._s_per_px()
            text = self.tr("{time} s").format(time=local(f"{tick * step_s:.6g}"))
            wide = self.fontMetrics().horizontalAdvance(text) + 2
            left = min(max(1.0, x - 0.5 * wide), self.width() - wide - 1.0)
            box = QRectF(left, self.height() - _LABELS_PX, wide, _LABELS_PX)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def columns(curve: Curve, view_s: tuple[float, float], width_px: int) -> Curve:
    """Return the largest value of each pixel column (x, value), no peak lost."""
    time_s, value = curve
    first, last = np.searchsorted(time_s, view_s)
    first, last = max(0, first - 1), min(len(time_s), last + 1)
    time_s, value = time_s[first:last], value[first:last]
    x = (time_s - view_s[0]) / (view_s[1] - view_s[0]) * width_px
    if len(x) <= 2 * width_px:
        return x, value
    starts = np.flatnonzero(np.diff(np.floor(x), prepend=-np.inf))
    return np.floor(x[starts]), np.maximum.reduceat(value, starts)


def busiest_s(curve: Curve, span_s: float) -> float:
    """Return the middle of the span in which a curve adds up to most, s."""
    time_s, value = curve
    ends = np.searchsorted(time_s, time_s + span_s)
    total = np.concatenate([[0.0], np.cumsum(value)])
    first = int(np.argmax(total[ends] - total[:-1]))
    return float(0.5 * (time_s[first] + time_s[ends[first] - 1]))


def tick_step_s(least_s: float) -> float:
    """Return the shortest step of 1, 2 or 5 times a power of ten, s."""
    power = 10.0 ** np.floor(np.log10(least_s))
    factor = next(f for f in (1, 2, 5, 10) if f * power >= least_s * (1 - 1e-9))
    return float(factor * power)
