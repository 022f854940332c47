"""The timeline of the editor: force, sound, events and effects below each other."""

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.bridge.languages import translated
from app.editor import lane_painter
from app.editor.curve_lane import CurveScale, Grips, curve_parameter, scale_of
from app.editor.document import Handle
from app.editor.lane_painter import Boxes, boxes, row_box
from app.editor.spans import rows_of
from app.editor.view import TimeView
from app.experimenter.sync_strip import Curve
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.model import ForceTrack
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList, kind_of
from hapticplayer.sequence.events import Event, TimeLine, event_detectors

LEAST_PX = QSize(320, 140)
USUAL_FRAME_S = 1.0 / 30.0  # where a clip does not say
_ZOOM = 1.25
_CURSOR_PX = 3
_LEAST_MARK_PX = 4.0  # of an event or effect that is shorter than a pixel
_PAN = 0.2  # of the view, for a turn of the wheel

_MARKS = {
    "impact": "BAD",
    "braking": "WARN",
    "turn": "ACCENT",
    "stillness": "GOOD",
    "saturation": "BAD",
    "artefact": "WARN",
}
"""Names of colours; the kind is written beside."""


class Lanes(QWidget):
    """Shows a timeline around a cursor that a person may move.

    Click moves the cursor. The wheel zooms around the pointer, with Shift it moves the
    view. `pointed` is media time in s.
    """

    pointed = Signal(float)

    def __init__(self, view: TimeView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Timeline"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(LEAST_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.view = view
        self.cursor_s, self.frame_s = 0.0, USUAL_FRAME_S
        self.track: ForceTrack | None = None
        self.before: ForceTrack | None = None
        self.loop_s: tuple[float, float] | None = None
        self._shows_before = True
        self.effects, self.events = NO_EFFECTS, tuple[Event, ...]()
        self._loudness: Curve | None = None
        self._rows: list[int] = []
        self.selection: tuple[int, ...] = ()  # of the effects; the last one leads
        self.handle: Handle | None = None  # of that one
        self.fixed_scale: CurveScale | None = None  # while a point is dragged
        self._still: QPixmap | None = None  # what editing does not change
        self._front: QPixmap | None = None  # the same with events and effects
        view.changed.connect(self._redraw)

    def show_clip(
        self, track: ForceTrack, line: TimeLine, frame_rate_hz: float
    ) -> None:
        """Show the force and the timeline of a sequence."""
        self.track, self.events = track, line.events
        self._loudness = line.loudness
        self.frame_s = 1.0 / frame_rate_hz if frame_rate_hz else USUAL_FRAME_S
        self._redraw()

    def show_force(self, track: ForceTrack, before: ForceTrack | None = None) -> None:
        """Show another force, and behind it the one without effects."""
        self.track, self.before = track, before
        self._redraw()

    def show_before(self, is_wanted: bool) -> None:
        """Show the force without effects, or not."""
        self._shows_before = is_wanted
        self._redraw()

    def show_loop(self, span_s: tuple[float, float] | None) -> None:
        """Mark what is repeated."""
        if span_s != self.loop_s:
            self.loop_s = span_s
            self._front = None
            self.update()

    def show_effects(
        self,
        effects: EffectList,
        selection: tuple[int, ...] = (),
        handle: Handle | None = None,
    ) -> None:
        """Show other effects, some of them as selected, and a part of the last one."""
        before = self.lanes
        self.effects, self.selection, self.handle = effects, selection, handle
        self._rows = rows_of([(one.start_s, one.end_s) for one in effects.effects])
        if self.lanes != before:
            self._still = None
        self._front = None
        self.update()

    def set_cursor(self, media_s: float) -> None:
        """Show where the clip is."""
        before, self.cursor_s = self.cursor_s, media_s
        for at_s in (before, media_s):
            x = round(self.view.x_of(at_s, self.width()))
            self.update(QRect(x - _CURSOR_PX, 0, 2 * _CURSOR_PX + 1, self.height()))

    def point_at(self, media_s: float) -> None:
        """Put the cursor somewhere because a person wants it there."""
        media_s = min(max(media_s, 0.0), self.view.duration_s)
        self.set_cursor(media_s)
        self.view.reveal(media_s)
        self.pointed.emit(media_s)

    @property
    def lanes(self) -> Boxes:
        effect = self.leading
        return boxes(
            self.width(),
            self.height(),
            self._count_rows(),
            has_markers=bool(self.effects.markers),
            has_curve=effect is not None and curve_parameter(effect) is not None,
        )

    @property
    def leading(self) -> Effect | None:
        """The effect whose handles are shown: one that is selected alone."""
        if len(self.selection) != 1:
            return None
        return self.effects.effects[self.selection[0]]

    @property
    def grips(self) -> Grips | None:
        """The handles of that effect."""
        if (effect := self.leading) is None:
            return None
        scale = self.fixed_scale or scale_of(effect, self.lanes.curve)
        box = self.effect_box(self.selection[0])
        return Grips(effect, box, scale, self.view, self.width())

    def time_of(self, x_px: float) -> float:
        """The media time at a place, also beyond what is shown."""
        return self.view.begin_s + x_px / max(1, self.width()) * self.view.span_s

    def effect_box(self, number: int) -> QRectF:
        effect = self.effects.effects[number]
        row = row_box(self.lanes.effects, self._rows[number], self._count_rows())
        return self._mark(row, effect.start_s, effect.end_s)

    def event_box(self, number: int) -> QRectF:
        event = self.events[number]
        lane = self.lanes.events.adjusted(0, 2, 0, -1)
        return self._mark(lane, event.start_s, event.end_s)

    def _count_rows(self) -> int:
        return max(self._rows, default=-1) + 1

    def _mark(self, lane: QRectF, start_s: float, end_s: float) -> QRectF:
        first = self.view.x_of(start_s, self.width())
        width = self.view.x_of(end_s, self.width()) - first
        return QRectF(first, lane.top(), max(_LEAST_MARK_PX, width), lane.height())

    # --- a person's hands ------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        self.point_at(self.view.time_at(event.position().x(), self.width()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.point_at(self.view.time_at(event.position().x(), self.width()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        turn = event.angleDelta()
        steps = (turn.y() or turn.x()) / 120.0
        if turn.x() or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.view.pan(-_PAN * steps * self.view.span_s)
        else:
            at_s = self.view.time_at(event.position().x(), self.width())
            self.view.zoom(_ZOOM**-steps, at_s)
        event.accept()

    def step(self, frames: int) -> None:
        """Move the cursor by frames."""
        self.point_at(self.cursor_s + frames * self.frame_s)

    def zoom(self, steps: float) -> None:
        """Show less (-) or more (+) around the cursor."""
        self.view.zoom(_ZOOM**steps, self.cursor_s)

    # --- painting --------------------------------------------------------------

    def resizeEvent(self, _event: QResizeEvent) -> None:
        self._still = self._front = None

    def _redraw(self) -> None:
        self._still = self._front = None
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        front = self._front
        if front is None or front.devicePixelRatio() != self.devicePixelRatioF():
            front = self._front = self._draw_front()
        with QPainter(self) as painter:
            painter.setClipRect(event.rect())
            painter.drawPixmap(0, 0, front)
            if self._loudness is None:
                return
            x = self.view.x_of(self.cursor_s, self.width())
            painter.setPen(QPen(QColor(theme.TEXT), 1.5))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
            if self.hasFocus():
                painter.setPen(QPen(QColor(theme.FOCUS), 2))
                painter.drawRect(self.rect().adjusted(1, 1, -1, -1))

    def _draw_front(self) -> QPixmap:
        still = self._still
        if still is None or still.devicePixelRatio() != self.devicePixelRatioF():
            still = self._still = self._draw_still()
        made, lanes = QPixmap(still), self.lanes
        if self._loudness is None:
            return made
        with QPainter(made) as painter:
            painter.setFont(theme.scaled(self.font(), 0.9))
            if self.loop_s is not None:
                lane_painter.paint_loop(painter, lanes, self.view, self.loop_s)
            self._paint_events(painter, lanes.events)
            self._paint_effects(painter, lanes.effects)
            if (grips := self.grips) is not None:
                grips.paint_curve(painter)
            lane_painter.paint_markers(painter, lanes, self.view, self.effects.markers)
            if grips is not None:
                grips.paint_handles(painter, self.handle)
        return made

    def _draw_still(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        made = QPixmap(self.size() * ratio)
        made.setDevicePixelRatio(ratio)
        made.fill(QColor(theme.PANEL))
        if self._loudness is None:
            return made  # nothing is loaded
        lanes = self.lanes
        with QPainter(made) as painter:
            painter.setFont(theme.scaled(self.font(), 0.9))
            lane_painter.paint_frame(painter, lanes, self.view)
            before = self.before if self._shows_before else None
            lane_painter.paint_force(painter, lanes, self.view, self.track, before)
            lane_painter.paint_sound(painter, lanes.sound, self.view, self._loudness)
        return made

    def _paint_events(self, painter: QPainter, lane: QRectF) -> None:
        if not self.events:
            lane_painter.paint_name(painter, lane, self.tr("No events found"))
        for number, event in enumerate(self.events):
            colour = QColor(getattr(theme, _MARKS.get(event.kind, "DIM")))
            box = self.event_box(number)
            painter.setPen(colour)
            ground = QColor(colour)
            ground.setAlpha(50)
            painter.fillRect(box, ground)
            painter.drawLine(box.topLeft(), box.bottomLeft())
            self._write(painter, box, event_title(event), theme.TEXT)

    def _paint_effects(self, painter: QPainter, lane: QRectF) -> None:
        if not len(self.effects):
            lane_painter.paint_name(painter, lane, self.tr("No effects"))
        for number, effect in enumerate(self.effects.effects):
            self._paint_effect(painter, number, effect)

    def _paint_effect(self, painter: QPainter, number: int, effect: Effect) -> None:
        box = self.effect_box(number)
        if box.right() < 0 or box.left() > self.width():
            return
        colour = QColor(theme.PRIMARY if effect.enabled else theme.RAISED)
        is_selected = number in self.selection
        edge = QColor(theme.TEXT if is_selected else theme.BORDER)
        painter.setPen(QPen(edge, 3 if is_selected else 1))
        painter.setBrush(colour)
        painter.drawRect(box.adjusted(1, 1, -1, -1) if is_selected else box)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        self._paint_fades(painter, box, effect)
        text = theme.PRIMARY_TEXT if effect.enabled else theme.DIM
        self._write(painter, box, effect_title(effect), text)

    def _paint_fades(self, painter: QPainter, box: QRectF, effect: Effect) -> None:
        """Draw a line that rises and one that falls."""
        px_per_s = box.width() / effect.duration_s
        rises_px, falls_px = (
            fade_s * px_per_s for fade_s in (effect.fade_in_s, effect.fade_out_s)
        )
        colour = QColor(theme.PRIMARY_TEXT if effect.enabled else theme.DIM)
        colour.setAlpha(130)
        painter.setPen(colour)
        if rises_px > 1.0:
            top = QPointF(box.left() + rises_px, box.top())
            painter.drawLine(box.bottomLeft(), top)
        if falls_px > 1.0:
            top = QPointF(box.right() - falls_px, box.top())
            painter.drawLine(top, box.bottomRight())

    def _write(self, painter: QPainter, box: QRectF, text: str, colour: str) -> None:
        """Write a text into a box, as much as there is room for."""
        inner = box.intersected(QRectF(self.rect())).adjusted(4, 0, -2, 0)
        shown = painter.fontMetrics().elidedText(
            text, Qt.TextElideMode.ElideRight, int(inner.width())
        )
        if len(shown) > 1 and inner.height() >= 0.7 * painter.fontMetrics().height():
            painter.setPen(QColor(colour))
            painter.drawText(inner, Qt.AlignmentFlag.AlignVCenter, shown)


def event_title(event: Event) -> str:
    row = event_detectors().get(event.kind)
    return translated(row.title if row else event.kind)


def effect_title(effect: Effect) -> str:
    return translated(kind_of(effect.kind).text)


def span_text(start_s: float, end_s: float) -> str:
    """Return a span of media time."""
    return local(f"{start_s:.3f} \u2013 {end_s:.3f} s")
