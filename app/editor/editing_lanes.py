"""The timeline as a person edits it, by mouse and by keys."""

from collections.abc import Callable, Iterable

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
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QMenu, QWidget

from app.bridge.languages import translated
from app.editor.curve_lane import handle_text
from app.editor.document import Handle
from app.editor.dragging import BandDrag, Drag, EdgeDrag, HandleDrag, MoveDrag
from app.editor.editing import Editing
from app.editor.edits import new_effect
from app.editor.kind_list import kind_in
from app.editor.lanes import Lanes, effect_title, event_title, span_text
from app.editor.spans import Hit, Part, Snap, hit, marks_of
from app.editor.view import TimeView
from app.widgets import theme
from app.widgets.messages import OnPicture
from app.widgets.texts import local, titled
from hapticplayer.rendering.effects import Effect, TimeMarker
from hapticplayer.sequence.events import Event

_EDGE_PX, _SNAP_PX = 5.0, 7.0
_STILL_PX = 3.0  # a click may tremble so far
_BESIDE_PX = 14  # from the pointer to what it says
_MORE = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
_SIDEWAYS, _FREE = Qt.CursorShape.SizeHorCursor, Qt.CursorShape.SizeAllCursor
_SHAPES = {
    Part.START: _SIDEWAYS,
    Part.BODY: Qt.CursorShape.OpenHandCursor,
    Part.END: _SIDEWAYS,
}


class EditingLanes(Lanes):
    """Effects are moved by their middle, stretched by their ends, faded by their corners.

    Control points are dragged in the lane of the curve, where a double click adds one. A
    drag over empty room selects. Escape takes a drag back. Tab goes from effect to
    effect; `app.editor.commands` has the other keys.
    """

    def __init__(
        self, view: TimeView, editing: Editing, parent: QWidget | None = None
    ) -> None:
        super().__init__(view, parent)
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.editing, self.snaps = editing, True
        self.menu: QMenu | None = None
        self._drag: Drag | None = None
        self._has_moved = False
        self.readout = OnPicture(self)
        self._ghost: Effect | None = None  # that would be dropped
        editing.document.changed.connect(self._follow)

    def _follow(self) -> None:
        document = self.editing.document
        self.show_effects(document.effects, document.selection, document.handle)
        effect, handle = document.effect, document.handle
        name = self.tr("Timeline")
        if effect is not None:
            if effect.end_s < self.view.begin_s or self.view.end_s < effect.start_s:
                self.view.reveal(effect.start_s)
            name = titled(name, self._selection_text(effect))
            if handle is not None:
                name = titled(name, handle_text(effect, handle))
        self._show_handle()
        if name != self.accessibleName():
            self.setAccessibleName(name)
            changed = QAccessible.Event.NameChanged
            QAccessible.updateAccessibility(QAccessibleEvent(self, changed))

    def _selection_text(self, effect: Effect) -> str:
        count = len(self.editing.document.selection)
        text = self._described(effect)
        if count > 1:
            others = self.tr("{count} effects are selected").format(count=count)
            text = f"{others}; {text}"
        return text

    def _show_handle(self) -> None:
        """Say where the selected handle is, beside it."""
        places = dict(self.grips.places()) if self.grips else {}
        handle, effect = self.handle, self.leading
        if handle is not None and effect is not None and handle in places:
            self._say(handle_text(effect, handle), places[handle])
        elif self._drag is None:
            self.readout.hide()

    def _say(self, text: str, at: QPointF) -> None:
        """Write beside a place, within the lanes."""
        self.readout.show_text(text)
        room = self.rect().size() - self.readout.size()
        x = min(int(at.x()) + _BESIDE_PX, room.width())
        above = int(at.y()) - self.readout.height() - _BESIDE_PX // 2
        y = above if above >= 0 else int(at.y()) + _BESIDE_PX
        self.readout.move(max(0, x), max(0, min(y, room.height())))

    def _described(self, effect: Effect) -> str:
        span = span_text(effect.start_s, effect.end_s)
        text = f"{effect_title(effect)}, {span}"
        return text if effect.enabled else ", ".join((text, self.tr("off")))

    # --- snapping --------------------------------------------------------------

    def snap(self, apart_from: tuple[int, ...] = ()) -> Snap | None:
        """The snapping of times; None while there is none."""
        if not self.snaps:
            return None
        others = (
            (effect.start_s, effect.end_s)
            for number, effect in enumerate(self.effects.effects)
            if number not in apart_from
        )
        events = ((event.start_s, event.end_s) for event in self.events)
        markers = ((one.time_s, one.time_s) for one in self.effects.markers)
        ends = [(0.0, self.view.duration_s), (self.cursor_s, self.cursor_s)]
        marks_s = marks_of(others, events, markers, ends)
        tolerance_s = _SNAP_PX / max(1, self.width()) * self.view.span_s
        return Snap(marks_s, tolerance_s, self.frame_s)

    def _snapped(self, time_s: float) -> float:
        snap = self.snap()
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

    def marker_at(self, at: QPointF) -> TimeMarker | None:
        """Return which marker the pointer is on, or next to."""
        if not self.lanes.markers.contains(at):
            return None
        tolerance_s = _SNAP_PX / max(1, self.width()) * self.view.span_s
        here_s = self.time_of(at.x())
        near = min(self.effects.markers, key=lambda one: abs(one.time_s - here_s))
        return near if abs(near.time_s - here_s) <= tolerance_s else None

    def effects_in(self, area: QRectF) -> list[int]:
        """The effects that lie at least partly within a rectangle."""
        every = range(len(self.effects))
        return [k for k in every if self.effect_box(k).intersects(area)]

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        at, is_more = event.position(), bool(event.modifiers() & _MORE)
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        self._drag, self._has_moved = None, False
        handle = self.grips.at(at) if self.grips and not is_more else None
        held, number = self.effect_at(at), self.event_at(at)
        if handle is not None:
            self._begin(self._held_by(handle, at))
        elif held is not None:
            self._press_effect(held, event)
        elif number is not None:
            self.offer(number, event.globalPosition().toPoint())
        elif (marker := self.marker_at(at)) is not None:
            self.point_at(marker.time_s)
        elif self.lanes.effects.contains(at):
            self._press_empty(at, is_more=is_more)
        else:
            super().mousePressEvent(event)

    def _begin(self, drag: Drag) -> None:
        self._drag = drag

    def _held_by(self, handle: Handle, at: QPointF) -> Drag:
        self.editing.document.hold(handle)
        self.fixed_scale = self.grips.scale if self.grips else None
        return HandleDrag(self, at, handle, self.fixed_scale)

    def _press_effect(self, held: Hit, event: QMouseEvent) -> None:
        """Select as the keys beside the click say; without any, hold it."""
        document, number = self.editing.document, held.number
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            document.toggle(number)
            return
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._select_up_to(number)
            return
        if held.part is not Part.BODY or number not in document.selection:
            document.select(number)
            if held.part is not Part.BODY:
                self._begin(EdgeDrag(self, event.position(), held))
                return
        else:
            document.add_to_selection(number)
        self._begin(MoveDrag(self, event.position(), number))

    def _select_up_to(self, number: int) -> None:
        """Select what lies between the leading effect and another, as Tab goes."""
        order, document = self._order(), self.editing.document
        lead = document.selected
        first = order.index(number if lead is None else lead)
        last = order.index(number)
        step = 1 if last >= first else -1
        document.select(
            *order[first : last + step if last + step >= 0 else None : step]
        )

    def _press_empty(self, at: QPointF, *, is_more: bool) -> None:
        document = self.editing.document
        if not is_more:
            document.select()
            self.point_at(self.view.time_at(at.x(), self.width()))
        self._begin(BandDrag(self, at, document.selection))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Add a control point, which the pointer then holds."""
        at, grips, effect = event.position(), self.grips, self.leading
        if (
            grips is None
            or grips.scale is None
            or effect is None
            or not self.lanes.curve.contains(at)
            or grips.at(at) is not None
        ):
            super().mouseDoubleClickEvent(event)
        elif effect.start_s <= self.time_of(at.x()) <= effect.end_s:
            value = grips.scale.value_at(at.y())
            self.editing.add_point(self._snapped(self.time_of(at.x())), value)
            handle = self.editing.document.handle
            if handle is not None:
                self._begin(self._held_by(handle, at))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move what is held; show what can be."""
        at, drag = event.position(), self._drag
        if drag is not None:
            way_px = (at - drag.begin).manhattanLength()
            self._has_moved = self._has_moved or way_px > _STILL_PX
            if self._has_moved:
                drag.to(at)
                if drag.text:
                    self._say(drag.text, at)
                self.update()
        elif event.buttons():
            super().mouseMoveEvent(event)
        else:
            self._hover(at)

    def _hover(self, at: QPointF) -> None:
        held, handle = self.effect_at(at), self.grips.at(at) if self.grips else None
        shape = _SHAPES[held.part] if held else Qt.CursorShape.ArrowCursor
        if self.event_at(at) is not None:
            shape = Qt.CursorShape.PointingHandCursor
        if handle is not None:
            is_point = handle.part is Part.POINT
            shape = _FREE if is_point else _SIDEWAYS
        self.setCursor(shape)
        self.setToolTip(self._tip(at, held))

    def _tip(self, at: QPointF, held: Hit | None) -> str:
        if held is not None:
            return self._described(self.effects.effects[held.number])
        if (marker := self.marker_at(at)) is not None:
            return titled(local(f"{marker.time_s:.3f} s"), marker.name)
        number = self.event_at(at)
        return "" if number is None else event_text(self.events[number])

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag = self._let_go()
        if drag is not None:
            drag.end(has_moved=self._has_moved)
        event.accept()

    def _let_go(self) -> Drag | None:
        drag, self._drag = self._drag, None
        self.fixed_scale = None
        if drag is not None:
            self._redraw()
            self._show_handle()
        return drag

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape takes back what is being dragged, after it has stopped the force."""
        if event.key() == Qt.Key.Key_Escape and self._drag is not None:
            drag = self._drag
            drag.cancel()
            self._let_go()
            event.accept()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        at, document = QPointF(event.pos()), self.editing.document
        held, number = self.effect_at(at), self.event_at(at)
        handle = self.grips.at(at) if self.grips else None
        if handle is not None and handle.part is Part.POINT:
            document.hold(handle)
            self._offer([(self.tr("Delete the point"), self.editing.delete)], event)
        elif held is not None:
            if held.number not in document.selection:
                document.select(held.number)
            self._offer_changes(event)
        elif number is not None:
            self.offer(number, event.globalPos())

    def _offer_changes(self, event: QContextMenuEvent) -> None:
        effect = self.editing.document.effect
        is_on = effect is not None and effect.enabled
        switch = self.tr("Switch off") if is_on else self.tr("Switch on")
        changes = (
            (switch, self.editing.toggle),
            (self.tr("Duplicate"), self.editing.duplicate),
            (self.tr("Delete"), self.editing.delete),
        )
        self._offer(changes, event)

    def _offer(
        self,
        changes: Iterable[tuple[str, Callable[[], None]]],
        event: QContextMenuEvent,
    ) -> None:
        self.menu = menu = self._new_menu()
        for text, action in changes:
            menu.addAction(text).triggered.connect(lambda _=False, do=action: do())
        menu.popup(event.globalPos())

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
        self._go_to_one([event.start_s for event in self.events], step)

    def go_to_marker(self, step: int) -> None:
        """Move the cursor to the next marker (1) or the previous one (-1)."""
        self._go_to_one([marker.time_s for marker in self.effects.markers], step)

    def _go_to_one(self, times_s: list[float], step: int) -> None:
        ahead = [s for s in times_s if (s - self.cursor_s) * step > 1e-6]
        if ahead:
            self.point_at(min(ahead) if step > 0 else max(ahead))

    # --- the keyboard ----------------------------------------------------------

    def _order(self) -> list[int]:
        """The effects as Tab goes through them."""
        effects = self.effects.effects
        return sorted(range(len(effects)), key=lambda k: (effects[k].start_s, k))

    def beside(self, step: int) -> int | None:
        """The effect after the leading one (1) or before it (-1)."""
        order, now = self._order(), self.editing.document.selected
        if not order:
            return None
        first = 0 if step > 0 else len(order) - 1
        to = first if now is None else order.index(now) + step
        return order[to] if 0 <= to < len(order) else None

    def focusNextPrevChild(self, next: bool) -> bool:  # noqa: N802, A002
        """Go to the next effect in time before leaving the timeline."""
        to = self.beside(1 if next else -1)
        if to is None:
            return super().focusNextPrevChild(next)
        self.editing.document.select(to)
        return True

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
        drag = self._drag
        with QPainter(self) as painter:
            painter.setPen(QPen(QColor(theme.FOCUS), 2, Qt.PenStyle.DashLine))
            if isinstance(drag, BandDrag) and self._has_moved:
                painter.drawRect(drag.area)
            if self._ghost is not None:
                painter.drawRect(self._ghost_box(self._ghost))

    def _ghost_box(self, ghost: Effect) -> QRectF:
        lane = self.lanes.effects
        first, last = (
            self.view.x_of(at_s, self.width()) for at_s in (ghost.start_s, ghost.end_s)
        )
        return QRectF(first, lane.top() + 2, last - first, lane.height() - 4)


def event_text(event: Event) -> str:
    """Return an event as people read it."""
    span = span_text(event.start_s, event.end_s)
    percent = f"{100.0 * event.confidence:.0f} %"
    return f"{event_title(event)}, {span}, {percent}: {translated(event.text)}"
