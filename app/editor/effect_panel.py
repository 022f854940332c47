"""The effect that is selected: its span, its numbers, and whether it is switched on."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import (
    QComboBox,
    QLabel,
    QLineEdit,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.bridge.languages import translated
from app.editor.editing import Editing
from app.editor.edits import with_curve, with_parameter
from app.editor.lanes import effect_title, span_text
from app.editor.parameter_fields import NumberField, leaves_to_page
from app.editor.spans import Part
from app.experimenter.numbers import ThreeNumbers
from app.widgets import theme
from app.widgets.buttons import TickBox, text_button
from app.widgets.layout import (
    STRETCH,
    captioned,
    column_of,
    paragraph,
    read_in_order,
    row_of,
)
from hapticplayer.errors import UsageError, message_of
from hapticplayer.model.ranges import Range
from hapticplayer.rendering.condition import Parameter
from hapticplayer.rendering.effects import Effect, Target, kind_of

WIDTH_PX = 300
_NO_RANGE = Range(-1e6, 1e6)
_DIRECTION = Range(-1.0, 1.0)


class EffectPanel(QWidget):
    """Shows the selected effect of a document, and changes it."""

    def __init__(self, editing: Editing, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.editing = editing
        self.fields: dict[str, NumberField] = {}
        self._shown: tuple[object, ...] | None = None
        self._gesture = ""
        self._make_parts()
        self._lay_out()
        editing.document.changed.connect(self.refresh)
        self.refresh()

    def _make_parts(self) -> None:
        self.setFixedWidth(WIDTH_PX)
        self.title, self.span = QLabel(), QLabel()
        self.title.setFont(theme.scaled(self.font(), 1.1, bold=True))
        self.span.setStyleSheet(f"color: {theme.DIM};")
        for label in (self.title, self.span):
            label.setTextFormat(Qt.TextFormat.PlainText)
        self.hint = paragraph(
            self.tr(
                "Drag a kind of effect onto the timeline, or click an event there. "
                "The recorded motion never changes."
            ),
            theme.DIM,
        )
        self.problem = paragraph("", theme.BAD)
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        self.enabled = TickBox(self.tr("Switched &on"))
        self.duplicate = text_button(
            self.tr("Dupl&icate"), self.tr("Add a copy after it (Ctrl+D)")
        )
        self.delete = text_button(self.tr("Dele&te"), self.tr("Delete it (Del)"))
        self.order = QLabel()
        self.order.setStyleSheet(f"color: {theme.DIM};")
        self.earlier = text_button("\u2191", self.tr("Apply it earlier"))
        self.later = text_button("\u2193", self.tr("Apply it later"))
        for button, by in ((self.earlier, -1), (self.later, 1)):
            button.setAccessibleName(button.toolTip())
            button.clicked.connect(lambda _=False, by=by: self.editing.reorder(by))
        self.enabled.clicked.connect(lambda is_on: self.editing.switch(is_on=is_on))
        self.duplicate.clicked.connect(self.editing.duplicate)
        self.delete.clicked.connect(self.editing.delete)

    def _lay_out(self) -> None:
        self.area = QScrollArea()
        self.area.setFrameShape(QScrollArea.Shape.NoFrame)
        self.area.setWidgetResizable(True)
        self.area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        column_of(
            *(self.title, row_of((self.span, 1), self.enabled), self.hint),
            *((self.area, 1), self.problem),
            row_of(
                *(self.duplicate, self.delete, STRETCH),
                *(self.order, self.earlier, self.later),
                spacing=6,
            ),
            spacing=4,
            of=self,
        )

    # --- what is shown -------------------------------------------------------

    def refresh(self) -> None:
        """Show what is selected now."""
        document = self.editing.document
        effect, chosen = document.effect, document.chosen
        for widget in (self.enabled, self.duplicate, self.delete, self.span):
            widget.setVisible(effect is not None)
        for widget in (self.order, self.earlier, self.later):
            widget.setVisible(len(chosen) == 1)
        self.hint.setVisible(effect is None)
        self._show_problem("")
        self.title.setText(self.tr("No effect is selected"))
        if effect is None:
            self._shown = None
            self._put_into_area(QWidget())
            return
        first_s = min(one.start_s for one in chosen.values())
        last_s = max(one.end_s for one in chosen.values())
        self.span.setText(span_text(first_s, last_s))
        self.enabled.setChecked(effect.enabled)
        self.duplicate.setEnabled(self.editing.can_add)
        if len(chosen) > 1:
            text = self.tr("{count} effects are selected")
            self.title.setText(text.format(count=len(chosen)))
            self._shown = None
            self._put_into_area(QWidget())
            return
        self.title.setText(effect_title(effect))
        place, count = (document.selected or 0) + 1, len(document.effects)
        self.order.setText(f"{place}/{count}")
        self.order.setToolTip(self.tr("Place in the order in which they are applied"))
        self.earlier.setEnabled(place > 1)
        self.later.setEnabled(place < count)
        shown = (document.selected, effect.kind, effect.target, bool(effect.curve))
        if shown != self._shown:
            self._shown = shown
            self._make_fields(effect)
        self._show_numbers(effect)

    def _show_numbers(self, effect: Effect) -> None:
        values = {
            **effect.values(),
            "start_s": effect.start_s,
            "end_s": effect.end_s,
            "fade_in_s": effect.fade_in_s,
            "fade_out_s": effect.fade_out_s,
        }
        for name, field in self.fields.items():
            if name.startswith("fade_"):
                field.set_largest(effect.duration_s)
            field.show_number(values[name])
        self.target.setCurrentIndex(self.target.findData(effect.target.value))
        self.direction.blockSignals(True)
        self.direction.set_numbers(effect.direction)
        self.direction.blockSignals(False)
        if not self.curve.hasFocus():
            self.curve.setText(curve_text(effect))

    def _make_fields(self, effect: Effect) -> None:
        """Make the fields of another effect."""
        kind, inner = kind_of(effect.kind), QWidget()
        self.fields = {}
        column = column_of(spacing=6, margins=(0, 0, 10, 0), of=inner)
        for parameter in kind.parameters:
            if not (effect.curve and parameter.name == kind.curve):
                self._add_parameter(column, effect, parameter)
        self._add_curve(column, kind.curve)
        clip = Range(0.0, max(self.editing.duration_s, effect.end_s), "s")
        texts = {
            "fade_in_s": (self.tr("Fade in"), True),
            "fade_out_s": (self.tr("Fade out"), True),
            "start_s": (self.tr("Start"), False),
            "end_s": (self.tr("End"), False),
        }
        for name, (text, has_slider) in texts.items():
            field = self._add_field(column, name, (text, clip, " s"))
            field.slider.setVisible(has_slider)
        self._add_choices(column, effect)
        column.addStretch(1)
        self._put_into_area(inner)

    def _put_into_area(self, inner: QWidget) -> None:
        before = self.area.takeWidget()
        self.area.setWidget(inner)
        if before is not None:
            before.deleteLater()  # it may be what has just been used
        read_in_order(self.window())

    def _add_parameter(
        self, column: QVBoxLayout, effect: Effect, parameter: Parameter
    ) -> None:
        unit = effect.target.unit_of(parameter).replace("^2", "\u00b2")
        suffix = f" {unit}" if unit else ""
        allowed = parameter.range or _NO_RANGE
        text = translated(parameter.text)
        self._add_field(column, parameter.name, (text, allowed, suffix))

    def _add_field(
        self,
        column: QVBoxLayout,
        name: str,
        look: tuple[str, Range, str],
    ) -> NumberField:
        field = NumberField(*look)
        field.changed.connect(partial(self._on_number, name))
        self.fields[name] = field
        column.addWidget(field)
        return field

    def _add_curve(self, column: QVBoxLayout, name: str) -> None:
        self.curve = edit = QLineEdit()
        self.curve.setPlaceholderText("0 1; 0.5 2; 1 1")
        text = self.tr("Control &points: s after the start, value")
        self.curve.setAccessibleName(text.replace("&", ""))
        self.curve.setToolTip(
            self.tr("Such as 0 1; 0.5 2; 1 1 \u2013 empty for one value")
        )
        edit.editingFinished.connect(lambda: self._on_curve(edit))
        caption, field = captioned(text, self.curve)
        caption.setStyleSheet(f"color: {theme.DIM};")
        for widget in (caption, field):
            column.addWidget(widget)
            widget.setVisible(bool(name))

    def _add_choices(self, column: QVBoxLayout, effect: Effect) -> None:
        self.target = QComboBox()
        self.target.addItem(self.tr("Force"), Target.FORCE.value)
        self.target.addItem(self.tr("Motion before the rendering"), Target.MOTION.value)
        self.target.activated.connect(lambda _row: self._on_target())
        caption, field = captioned(self.tr("Applies &to"), self.target)
        self.target.setAccessibleName(caption.text().replace("&", ""))
        caption.setStyleSheet(f"color: {theme.DIM};")
        column.addWidget(caption)
        column.addWidget(field)
        is_force = effect.target is Target.FORCE
        names = (
            (self.tr("right"), self.tr("up"), self.tr("towards you"))
            if is_force
            else (self.tr("right"), self.tr("front"), self.tr("up"))
        )
        self.direction = ThreeNumbers(self.tr("Direction"), names, _DIRECTION, 2, 0.1)
        self.direction.changed.connect(self._on_direction)
        for box in self.direction.boxes:
            box.installEventFilter(self)
        self.direction.setVisible(kind_of(effect.kind).wave is not None)
        column.addWidget(self.direction)

    # --- what a person does --------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Leave Space to the page."""
        return leaves_to_page(event) or super().eventFilter(watched, event)

    def _on_number(self, name: str, value: float, goes_on: bool) -> None:
        effect = self.editing.document.effect
        if effect is None:
            return
        if not goes_on or not self._gesture.startswith(f"{name} "):
            self._gesture = f"{name} {self.editing.begin_gesture()}"
        parts = {"start_s": Part.START, "end_s": Part.END}
        if name in parts:
            self.editing.stretch(effect, parts[name], value, self._gesture)
        elif name.startswith("fade_"):
            part = Part.FADE_IN if name == "fade_in_s" else Part.FADE_OUT
            self.editing.fade(effect, part, value, self._gesture)
        else:
            text = self.tr("Change the numbers")
            self._put(lambda: with_parameter(effect, name, value), text)

    def _on_target(self) -> None:
        effect = self.editing.document.effect
        if effect is not None:
            target = Target(self.target.currentData())
            self._gesture = ""
            self._put(lambda: replace(effect, target=target), self.tr("Change"))

    def _on_direction(self) -> None:
        effect = self.editing.document.effect
        if effect is not None:
            direction = self.direction.numbers()
            self._gesture = "direction"
            text = self.tr("Change the direction")
            self._put(lambda: replace(effect, direction=direction), text)

    def _on_curve(self, edit: QLineEdit) -> None:
        effect = self.editing.document.effect
        is_old = edit is not self.curve  # and loses the focus, as it goes
        if effect is not None and not is_old and edit.text() != curve_text(effect):
            text, self._gesture = edit.text(), ""
            name = self.tr("Change the control points")
            self._put(lambda: with_curve(effect, text), name)

    def _put(self, make: Callable[[], Effect], text: str) -> None:
        """Change the effect, or say why not."""
        try:
            effect = make()
        except UsageError as problem:
            self._show_problem(translated(message_of(problem)))
            return
        self._show_problem("")
        self.editing.put(effect, text, self._gesture)

    def _show_problem(self, text: str) -> None:
        self.problem.setText(text)
        self.problem.setVisible(bool(text))


def curve_text(effect: Effect) -> str:
    """Return control points as they are entered."""
    return "; ".join(f"{time_s:g} {value:g}" for time_s, value in effect.curve)
