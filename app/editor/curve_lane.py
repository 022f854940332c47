"""The control points of the leading effect, in a lane of their own, and its fades."""

from collections.abc import Iterator
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.bridge.languages import translated
from app.editor.document import Handle
from app.editor.edits import value_at
from app.editor.lane_painter import paint_name
from app.editor.parameter_fields import step_of, tidy
from app.editor.spans import Part
from app.editor.view import TimeView
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.model.ranges import Range
from hapticplayer.rendering.condition import Parameter
from hapticplayer.rendering.effects import Effect, kind_of

GRIP_PX = 6.0  # how near a handle is
_HANDLE_PX, _INSET_PX = 3.5, 7.0
_LEAST_WIDTH_PX, _LEAST_HEIGHT_PX = 24.0, 14.0  # of an effect whose fades can be held
_TOP_SHARE, _SNAP_PX = 1.25, 4.0
_NEUTRAL = {"gain": 1.0}


def curve_parameter(effect: Effect) -> Parameter | None:
    """What its control points stand for; None where it has none."""
    kind = kind_of(effect.kind)
    return next((one for one in kind.parameters if one.name == kind.curve), None)


def value_text(effect: Effect, value: float) -> str:
    """A value of the curve, with its name and unit."""
    parameter = curve_parameter(effect)
    assert parameter is not None  # else there are no points
    unit = effect.target.unit_of(parameter)
    return local(f"{translated(parameter.text)} {value:.4g} {unit}".strip())


class CurveScale(NamedTuple):
    """Where times and values of a curve are in its lane.

    Attributes:
        lane: in px.
        top: value at the upper edge; the lower one is 0.
        allowed: values that the parameter may have.
    """

    lane: QRectF
    top: float
    allowed: Range

    @property
    def _high_px(self) -> float:
        return self.lane.height() - 2.0 * _INSET_PX

    def y_of(self, value: float) -> float:
        return self.lane.bottom() - _INSET_PX - value / self.top * self._high_px

    def value_at(self, y: float) -> float:
        """The value at a place, also beyond the lane, as far as it is allowed."""
        value = (self.lane.bottom() - _INSET_PX - y) / self._high_px * self.top
        return min(max(tidy(value), self.allowed.least), self.allowed.largest)

    def snapped(self, value: float, effect: Effect, point: int) -> float:
        """A value, or one near it that another point or the effect itself has."""
        marks = {one for k, (_, one) in enumerate(effect.curve) if k != point}
        kind = kind_of(effect.kind)
        marks.add(effect.values()[kind.curve])
        marks.update(v for k, v in _NEUTRAL.items() if k == kind.curve)
        near = min(marks, key=lambda one: abs(one - value))
        is_near = abs(near - value) / self.top * self._high_px <= _SNAP_PX
        return near if is_near else value


def scale_of(effect: Effect, lane: QRectF) -> CurveScale | None:
    """The scale of an effect that may have control points."""
    parameter = curve_parameter(effect)
    if parameter is None or parameter.range is None:
        return None
    usual = 2.0 * float(parameter.default)
    highest = max((value for _, value in effect.curve), default=value_at(effect, 0.0))
    return CurveScale(lane, max(usual, _TOP_SHARE * highest), parameter.range)


def value_step(effect: Effect) -> float:
    """By how much a key changes a value."""
    parameter = curve_parameter(effect)
    return step_of(parameter.range) if parameter and parameter.range else 0.0


# --- handles -----------------------------------------------------------------------


def handles_of(effect: Effect) -> list[Handle]:
    """What of an effect can be selected, in the order in which keys go through it."""
    points = [Handle(Part.POINT, k) for k in range(len(effect.curve))]
    return [Handle(Part.FADE_IN), *points, Handle(Part.FADE_OUT)]


def handle_s(effect: Effect, handle: Handle) -> float:
    """The media time of a handle."""
    if handle.part is Part.FADE_IN:
        return effect.start_s + effect.fade_in_s
    if handle.part is Part.FADE_OUT:
        return effect.end_s - effect.fade_out_s
    return effect.start_s + effect.curve[handle.point][0]


def handle_text(effect: Effect, handle: Handle) -> str:
    """What a handle is and where, for people."""
    translate = QCoreApplication.translate
    if handle.part is Part.FADE_IN:
        text = translate("Lanes", "Fade in {seconds} s")
        return local(text.format(seconds=f"{effect.fade_in_s:.3f}"))
    if handle.part is Part.FADE_OUT:
        text = translate("Lanes", "Fade out {seconds} s")
        return local(text.format(seconds=f"{effect.fade_out_s:.3f}"))
    text = translate("Lanes", "Point {number} of {count}: {time} s, {value}")
    value = value_text(effect, effect.curve[handle.point][1])
    time = local(f"{handle_s(effect, handle):.3f}")
    return text.format(
        number=handle.point + 1, count=len(effect.curve), time=time, value=value
    )


class Grips(NamedTuple):
    """Where the handles of the leading effect are.

    Attributes:
        effect: that leads.
        box: of it among the effects, in px.
        scale: of its curve; None where it has none.
        view: that is shown.
        width: of the lanes.
    """

    effect: Effect
    box: QRectF
    scale: CurveScale | None
    view: TimeView
    width: int

    def places(self) -> Iterator[tuple[Handle, QPointF]]:
        """Each handle that can be held, and where."""
        is_wide = self.box.width() >= _LEAST_WIDTH_PX
        has_fades = is_wide and self.box.height() >= _LEAST_HEIGHT_PX
        for handle in handles_of(self.effect):
            x = self.view.x_of(handle_s(self.effect, handle), self.width)
            if handle.part is not Part.POINT:
                if has_fades:
                    yield handle, QPointF(x, self.box.top() + 4.0)
            elif self.scale is not None:
                value = self.effect.curve[handle.point][1]
                yield handle, QPointF(x, self.scale.y_of(value))

    def at(self, place: QPointF) -> Handle | None:
        """The handle that is nearest to a place, and near it."""
        found = [
            ((spot - place).manhattanLength(), handle)
            for handle, spot in self.places()
            if abs(spot.x() - place.x()) <= GRIP_PX
            and abs(spot.y() - place.y()) <= GRIP_PX
        ]
        return min(found, key=lambda one: one[0])[1] if found else None

    # --- painting ------------------------------------------------------------

    def paint_curve(self, painter: QPainter) -> None:
        """Draw the curve over the span of the effect, or the line that it would replace."""
        if (scale := self.scale) is None:
            return
        painter.fillRect(scale.lane, QColor(theme.PANEL))
        painter.setPen(QColor(theme.BORDER))
        painter.drawLine(scale.lane.topLeft(), scale.lane.topRight())
        first, last = self._x(self.effect.start_s), self._x(self.effect.end_s)
        ground = QColor(theme.PRIMARY)
        ground.setAlpha(45)
        lane = scale.lane.adjusted(0, 1, 0, 0)
        painter.fillRect(QRectF(first, lane.top(), last - first, lane.height()), ground)
        is_dashed = not self.effect.curve
        line = Qt.PenStyle.DashLine if is_dashed else Qt.PenStyle.SolidLine
        painter.setPen(QPen(QColor(theme.ACCENT), 2, line))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.drawPolyline(self._line(scale))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
        parameter = curve_parameter(self.effect)
        assert parameter is not None  # as it has a scale
        paint_name(painter, scale.lane, translated(parameter.text))
        top = local(f"{scale.top:.4g} {self.effect.target.unit_of(parameter)}".strip())
        paint_name(painter, scale.lane, top, Qt.AlignmentFlag.AlignRight)

    def _line(self, scale: CurveScale) -> QPolygonF:
        effect = self.effect
        inner = [time_s for time_s, _ in effect.curve if time_s < effect.duration_s]
        times_s = [0.0, *inner, effect.duration_s]
        return QPolygonF(
            [
                QPointF(self._x(effect.start_s + s), scale.y_of(value_at(effect, s)))
                for s in times_s
            ]
        )

    def _x(self, media_s: float) -> float:
        return self.view.x_of(media_s, self.width)

    def paint_handles(self, painter: QPainter, selected: Handle | None) -> None:
        """Draw what can be dragged; what is selected is filled and ringed."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for handle, spot in self.places():
            is_held = handle == selected
            painter.setBrush(QColor(theme.FOCUS if is_held else theme.TEXT))
            painter.setPen(QPen(QColor(theme.PANEL), 1.5))
            radius = _HANDLE_PX + (2.0 if is_held else 0.0)
            painter.drawEllipse(spot, radius, radius)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
