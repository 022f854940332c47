"""What a press on the lanes has begun: each gesture is one step, or taken back."""

from abc import ABC, abstractmethod
from typing import Protocol

from PySide6.QtCore import QPointF, QRectF

from app.editor.curve_lane import CurveScale, handle_s, handle_text
from app.editor.document import Handle
from app.editor.editing import Editing
from app.editor.spans import Hit, Part, Snap
from app.widgets.texts import local
from hapticplayer.rendering.effects import Effect


class Timeline(Protocol):
    """What a gesture needs of the lanes."""

    editing: Editing

    def time_of(self, x_px: float) -> float: ...
    def snap(self, apart_from: tuple[int, ...] = ()) -> Snap | None: ...
    def effects_in(self, area: QRectF) -> list[int]: ...


class Drag(ABC):
    """A gesture that goes on; `text` says what it has come to."""

    text = ""

    def __init__(self, lanes: Timeline, at: QPointF) -> None:
        self.lanes, self.editing = lanes, lanes.editing
        self.begin, self.gesture = at, lanes.editing.begin_gesture()
        self.before = self._seen = lanes.editing.document.value

    @property
    def is_over(self) -> bool:
        """Whether something else has changed the effects meanwhile."""
        return self.editing.document.value is not self._seen

    def to(self, at: QPointF) -> None:
        """Follow the pointer."""
        if not self.is_over:
            self.follow(at)
            self._seen = self.editing.document.value

    @abstractmethod
    def follow(self, at: QPointF) -> None: ...

    def cancel(self) -> None:
        """Leave everything as it was."""
        if not self.is_over:
            self.editing.take_back(self.before, self.gesture)

    def end(self, *, has_moved: bool) -> None:  # noqa: B027, which most leave empty
        """Let go."""

    def _by_s(self, at: QPointF) -> float:
        return self.lanes.time_of(at.x()) - self.lanes.time_of(self.begin.x())


class MoveDrag(Drag):
    """Moves all that are selected; the ends of the one that is held snap."""

    def __init__(self, lanes: Timeline, at: QPointF, held: int) -> None:
        super().__init__(lanes, at)
        document = self.editing.document
        self._held, self._effects = held, document.chosen

    def follow(self, at: QPointF) -> None:
        held = self._effects[self._held]
        by_s = self._by_s(at)
        if snap := self.lanes.snap(tuple(self._effects)):
            by_s = snap.shift((held.start_s, held.end_s), by_s)
        self.editing.move(by_s, self.gesture, self._effects)
        now = self.editing.document.effects.effects[self._held]
        self.text = _span(now, now.start_s - held.start_s)

    def end(self, *, has_moved: bool) -> None:
        """A click on one of several leaves it alone selected."""
        if not has_moved and not self.is_over:
            self.editing.document.select(self._held)


class EdgeDrag(Drag):
    """Stretches the effect by an end."""

    def __init__(self, lanes: Timeline, at: QPointF, hit: Hit) -> None:
        super().__init__(lanes, at)
        effect = self.editing.document.effect
        assert effect is not None  # it was selected by the press
        self._hit, self._effect = hit, effect

    def follow(self, at: QPointF) -> None:
        is_start = self._hit.part is Part.START
        effect = self._effect
        to_s = (effect.start_s if is_start else effect.end_s) + self._by_s(at)
        if snap := self.lanes.snap((self._hit.number,)):
            to_s = snap.at(to_s)
        self.editing.stretch(effect, self._hit.part, to_s, self.gesture)
        now = self.editing.document.effect
        if now is not None:
            self.text = _span(now, now.duration_s - effect.duration_s)


class HandleDrag(Drag):
    """Moves a fade or a control point; the scale of the curve stays meanwhile."""

    def __init__(
        self, lanes: Timeline, at: QPointF, handle: Handle, scale: CurveScale | None
    ) -> None:
        super().__init__(lanes, at)
        effect = self.editing.document.effect
        assert effect is not None  # its handles are shown
        self._effect, self._handle, self.scale = effect, handle, scale
        self._y_off = 0.0
        if scale is not None and handle.part is Part.POINT:
            value = effect.curve[handle.point][1]
            self._y_off = scale.y_of(value) - at.y()

    def follow(self, at: QPointF) -> None:
        effect, handle = self._effect, self._handle
        to_s = handle_s(effect, handle) + self._by_s(at)
        if snap := self.lanes.snap():
            to_s = snap.at(to_s)
        if handle.part is Part.POINT and self.scale is not None:
            value = self.scale.value_at(at.y() + self._y_off)
            if snap:
                value = self.scale.snapped(value, effect, handle.point)
            place = to_s - effect.start_s, value
            self.editing.move_point(effect, handle.point, place, self.gesture)
        elif handle.part is Part.FADE_IN:
            fade_s = to_s - effect.start_s
            self.editing.fade(effect, handle.part, fade_s, self.gesture)
        else:
            fade_s = effect.end_s - to_s
            self.editing.fade(effect, handle.part, fade_s, self.gesture)
        now = self.editing.document.effect
        if now is not None:
            self.text = handle_text(now, handle)


class BandDrag(Drag):
    """Selects what lies within a rectangle, beside what was selected before."""

    area = QRectF()

    def __init__(self, lanes: Timeline, at: QPointF, kept: tuple[int, ...]) -> None:
        super().__init__(lanes, at)
        self._kept = kept

    def follow(self, at: QPointF) -> None:
        self.area = QRectF(self.begin, at).normalized()
        found = [k for k in self.lanes.effects_in(self.area) if k not in self._kept]
        self.editing.document.select(*self._kept, *found)

    def cancel(self) -> None:
        self.editing.document.select(*self._kept)


def _span(effect: Effect, by_s: float) -> str:
    """An effect's span, and what has been added to its time or length."""
    return local(f"{effect.start_s:.3f} \u2013 {effect.end_s:.3f} s ({by_s:+.3f} s)")
