"""The timeline as a person edits it, by mouse and by keys."""

from typing import NamedTuple

from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QColor,
    QContextMenuEvent,
    QDragEnterEvent,
    QDragLeaveEvent,
    QDragMoveEvent,
    QDropEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QMenu, QWidget

from app.bridge.languages import translated
from app.editor.editing import Editing
from app.editor.edits import new_effect
from app.editor.kind_list import kind_in
from app.editor.lanes import Lanes, effect_title, event_title, span_text
from app.editor.spans import Hit, Part, Snap, hit, marks_of
from app.editor.view import TimeView
from app.widgets import theme
from app.widgets.texts import titled
from hapticplayer.rendering.effects import Effect
from hapticplayer.sequence.events import Event

_EDGE_PX, _SNAP_PX = 5.0, 7.0
_SHAPES = {
    Part.START: Qt.CursorShape.SizeHorCursor,
    Part.BODY: Qt.CursorShape.OpenHandCursor,
    Part.END: Qt.CursorShape.SizeHorCursor,
}


class _Drag(NamedTuple):
    """What is held: an effect as it was, where the pointer was, the name of the step."""

    held: Hit
    effect: Effect
    from_s: float
    gesture: str


class EditingLanes(Lanes):
    """Effects are moved by their middle and stretched by their ends.

    Tab goes from effect to effect; `app.editor.commands` has the other keys.
    """

    def __init__(
        self, view: TimeView, editing: Editing, parent: QWidget | None = None
    ) -> None:
        super().__init__(view, parent)
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.editing, self.snaps = editing, True
        self.menu: QMenu | None = None
        self._drag: _Drag | None = None
        self._ghost: Effect | None = None  # that would be dropped
        editing.document.changed.connect(self._follow)

    def _follow(self) -> None:
        document = self.editing.document
        self.show_effects(document.effects, document.selected)
        effect = document.effect
        name = self.tr("Time line")
        if effect is not None:
            if effect.end_s < self.view.begin_s or self.view.end_s < effect.start_s:
                self.view.reveal(effect.start_s)
            name = titled(name, self._described(effect))
        if name != self.accessibleName():
            self.setAccessibleName(name)
            changed = QAccessible.Event.NameChanged
            QAccessible.updateAccessibility(QAccessibleEvent(self, changed))

    def _described(self, effect: Effect) -> str:
        span = span_text(effect.start_s, effect.end_s)
        text = f"{effect_title(effect)}, {span}"
        return text if effect.enabled else ", ".join((text, self.tr("off")))

    # --- snapping --------------------------------------------------------------

    def snap(self, apart_from: int | None = None) -> Snap | None:
        """The snapping of times; None while there is none."""
        if not self.snaps:
            return None
        others = (
            (effect.start_s, effect.end_s)
            for number, effect in enumerate(self.effects.effects)
            if number != apart_from
        )
        events = ((event.start_s, event.end_s) for event in self.events)
        ends = [(0.0, self.view.duration_s), (self.cursor_s, self.cursor_s)]
        tolerance_s = _SNAP_PX / max(1, self.width()) * self.view.span_s
        return Snap(marks_of(others, events, ends), tolerance_s, self.frame_s)

    def _snapped(self, time_s: float, apart_from: int | None = None) -> float:
        snap = self.snap(apart_from)
        return snap.at(time_s) if snap else time_s

    # --- the mouse -------------------------------------------------------------

    def effect_at(self, at: QPointF) -> Hit | None:
        """Return which effect the pointer is on, and which part of it."""
        spans = []
        for number in range(len(self.effects)):
            box = self.effect_box(number)
            is_there = box.top() <= at.y() <= box.bottom()
            spans.append((box.left(), box.right()) if is_there else None)
        return hit(spans, at.x(), _EDGE_PX)

    def event_at(self, at: QPointF) -> int | None:
        """Return which event the pointer is on."""
        if not self.lanes.events.contains(at):
            return None
        boxes = map(self.event_box, range(len(self.events)))
        spans = [(box.left(), box.right()) for box in boxes]
        found = hit(spans, at.x(), 1.0)
        return found.number if found else None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        at, document = event.position(), self.editing.document
        held, number = self.effect_at(at), self.event_at(at)
        if held is not None:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            document.select(held.number)
            at_s = self.view.begin_s + at.x() / self.width() * self.view.span_s
            effect = self.effects.effects[held.number]
            self._drag = _Drag(held, effect, at_s, self.editing.begin_gesture())
        elif number is not None:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            self.offer(number, event.globalPosition().toPoint())
        else:
            if self.lanes.effects.contains(at):
                document.select(None)
            super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move what is held; show what can be."""
        at = event.position()
        if self._drag is not None:
            self._drag_to(at.x())
        elif event.buttons():
            super().mouseMoveEvent(event)
        else:
            held = self.effect_at(at)
            shape = _SHAPES[held.part] if held else Qt.CursorShape.ArrowCursor
            if self.event_at(at) is not None:
                shape = Qt.CursorShape.PointingHandCursor
            self.setCursor(shape)
            self.setToolTip(self._tip(at, held))

    def _tip(self, at: QPointF, held: Hit | None) -> str:
        if held is not None:
            return self._described(self.effects.effects[held.number])
        number = self.event_at(at)
        return "" if number is None else event_text(self.events[number])

    def _drag_to(self, x_px: float) -> None:
        drag = self._drag
        assert drag is not None  # the caller has seen it
        to_s = self.view.begin_s + x_px / self.width() * self.view.span_s
        by_s, number = to_s - drag.from_s, drag.held.number
        snap = self.snap(number)
        if drag.held.part is Part.BODY:
            if snap:
                by_s = snap.shift((drag.effect.start_s, drag.effect.end_s), by_s)
            self.editing.move(drag.effect, by_s, drag.gesture)
            return
        is_start = drag.held.part is Part.START
        end_s = (drag.effect.start_s if is_start else drag.effect.end_s) + by_s
        end_s = snap.at(end_s) if snap else end_s
        self.editing.stretch(drag.effect, drag.held.part, end_s, drag.gesture)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._drag = None
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        at = QPointF(event.pos())
        held, number = self.effect_at(at), self.event_at(at)
        if held is not None:
            self.editing.document.select(held.number)
            self._offer_changes(event.globalPos())
        elif number is not None:
            self.offer(number, event.globalPos())

    def _offer_changes(self, at: QPoint) -> None:
        self.menu = menu = self._new_menu()
        effect = self.editing.document.effect
        is_on = effect is not None and effect.enabled
        switch = self.tr("Switch off") if is_on else self.tr("Switch on")
        for text, action in (
            (switch, self.editing.toggle),
            (self.tr("Duplicate"), self.editing.duplicate),
            (self.tr("Delete"), self.editing.delete),
        ):
            menu.addAction(text).triggered.connect(action)
        menu.popup(at)

    def _new_menu(self) -> QMenu:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        return menu

    # --- events ----------------------------------------------------------------

    def offer(self, number: int, at: QPoint) -> None:
        """Ask whether an effect is to be made of an event; by itself none is."""
        event = self.events[number]
        self.point_at(event.start_s)
        self.menu = menu = self._new_menu()
        menu.addAction(event_text(event)).setEnabled(False)
        menu.addSeparator()
        effect = event.effect
        text = self.tr("Add the effect: {name}, {span}").format(
            name=effect_title(effect), span=span_text(effect.start_s, effect.end_s)
        )
        take = menu.addAction(text)
        take.setEnabled(self.editing.can_add)
        take.triggered.connect(lambda: self.editing.add(effect, self.tr("Add")))
        menu.setActiveAction(take)
        menu.popup(at)

    def offer_at_cursor(self) -> None:
        """Offer the effect of the event that is there."""
        at_s = self.cursor_s
        around = [
            number
            for number, event in enumerate(self.events)
            if event.start_s - self.frame_s <= at_s <= event.end_s
        ]
        if around:
            box = self.event_box(around[-1])
            self.offer(around[-1], self.mapToGlobal(box.bottomLeft().toPoint()))

    def go_to_event(self, step: int) -> None:
        """Move the cursor to the next event (1) or the previous one (-1)."""
        starts = [event.start_s for event in self.events]
        ahead = [s for s in starts if (s - self.cursor_s) * step > 1e-6]
        if ahead:
            self.point_at(min(ahead) if step > 0 else max(ahead))

    # --- the keyboard ----------------------------------------------------------

    def focusNextPrevChild(self, next: bool) -> bool:  # noqa: N802, A002
        """Go to the next effect in time before leaving the timeline."""
        effects = self.effects.effects
        order = sorted(range(len(effects)), key=lambda k: (effects[k].start_s, k))
        now = self.editing.document.selected
        if not order:
            return super().focusNextPrevChild(next)
        if now is None:
            to = 0 if next else len(order) - 1
        else:
            to = order.index(now) + (1 if next else -1)
        if not 0 <= to < len(order):
            return super().focusNextPrevChild(next)
        self.editing.document.select(order[to])
        return True

    def go(self, frames: int) -> None:
        """Move the selected effect by frames, or the cursor without one."""
        effect = self.editing.document.effect
        if effect is None:
            self.step(frames)
        else:
            self.editing.move(effect, frames * self.frame_s, "keys")

    def go_far(self, steps: int) -> None:
        """Move the selected effect by tens of frames, or the cursor by seconds."""
        if self.editing.document.effect is None:
            self.point_at(self.cursor_s + steps)
        else:
            self.go(10 * steps)

    def move_edge(self, part: Part, frames: int) -> None:
        """Let the selected effect begin or end some frames later."""
        effect = self.editing.document.effect
        if effect is not None:
            at_s = effect.start_s if part is Part.START else effect.end_s
            to_s = at_s + frames * self.frame_s
            self.editing.stretch(effect, part, to_s, f"keys {part.name}")

    # --- what is dropped -------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if kind_in(event.mimeData()) and self.editing.can_add:
            event.acceptProposedAction()

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        self._ghost = self._dropped(event)
        event.acceptProposedAction()
        self.update()

    def dragLeaveEvent(self, _event: QDragLeaveEvent) -> None:
        self._ghost = None
        self.update()

    def dropEvent(self, event: QDropEvent) -> None:
        self._ghost = None
        self.editing.add(self._dropped(event), self.tr("Add"))
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        event.acceptProposedAction()

    def _dropped(self, event: QDropEvent) -> Effect:
        at_s = self.view.time_at(event.position().x(), self.width())
        kind = kind_in(event.mimeData())
        return new_effect(kind, self._snapped(at_s), self.view.duration_s)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._ghost is None:
            return
        lane = self.lanes.effects
        first, last = (
            self.view.x_of(at_s, self.width())
            for at_s in (self._ghost.start_s, self._ghost.end_s)
        )
        with QPainter(self) as painter:
            painter.setPen(QPen(QColor(theme.FOCUS), 2, Qt.PenStyle.DashLine))
            painter.drawRect(
                QRectF(first, lane.top() + 2, last - first, lane.height() - 4)
            )


def event_text(event: Event) -> str:
    """Return an event as people read it."""
    span = span_text(event.start_s, event.end_s)
    percent = f"{100.0 * event.confidence:.0f} %"
    return f"{event_title(event)}, {span}, {percent}: {translated(event.text)}"
