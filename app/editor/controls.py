"""The bars of the editor: what plays, what part of the clip is in view, what is changed."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QScrollBar, QWidget

from app.editor.document import Document
from app.editor.playing import Playing
from app.editor.view import TimeView
from app.player.transport import fix_stop_width, offer_play, offer_stop
from app.widgets import theme
from app.widgets.buttons import TickBox, text_button, tool_button
from app.widgets.layout import STRETCH, ElidedLabel, paragraph, row_of
from app.widgets.texts import position_text, titled

_ZOOM = 1.6
_PER_S = 1000  # steps of the scroll bar


class PlayBar(QWidget):
    """Plays and stops, shows the time, and chooses what is repeated and in view."""

    zoomed = Signal(float)
    """By this factor."""

    def __init__(self, playing: Playing, view: TimeView) -> None:
        super().__init__()
        self._playing, self._view = playing, view
        self.play_button = tool_button("play", "", "")
        self.stop_button = text_button("", "", "stop")
        fix_stop_width(self.stop_button)
        self.show_state()
        self.time = ElidedLabel()
        self.time.setAccessibleName(self.tr("Time"))
        self.closer = text_button("+", self.tr("Zoom in (+)"), "tool")
        self.wider = text_button("\u2212", self.tr("Zoom out (\u2212)"), "tool")
        self.whole = text_button(self.tr("&Whole clip"), self.tr("Show the whole clip"))
        self.closer.setAccessibleName(self.tr("Zoom in"))
        self.wider.setAccessibleName(self.tr("Zoom out"))
        for button in (self.closer, self.wider):
            button.setMinimumWidth(36)
        self.loop = TickBox(self.tr("&Loop"))
        self.loop.setToolTip(
            self.tr("Repeat the selected effects, or what is in view without any")
        )
        self.compare = TickBox(self.tr("&Before"))
        self.compare.setToolTip(self.tr("Show the force without effects behind it"))
        self.compare.setChecked(True)
        self.snap = TickBox(self.tr("S&nap"))
        self.snap.setToolTip(self.tr("Snap to frames, events and other effects"))
        self.snap.setChecked(True)
        row_of(
            *(self.play_button, self.stop_button, self.time, STRETCH),
            *(self.loop, self.compare, self.snap, self.wider, self.closer, self.whole),
            spacing=8,
            of=self,
        )
        self.play_button.clicked.connect(playing.toggle)
        self.stop_button.clicked.connect(playing.stop_or_rearm)
        playing.changed.connect(self.show_state)
        self.closer.clicked.connect(lambda: self.zoomed.emit(1.0 / _ZOOM))
        self.wider.clicked.connect(lambda: self.zoomed.emit(_ZOOM))
        self.whole.clicked.connect(view.show_whole)

    def show_state(self) -> None:
        offer_play(self.play_button, is_playing=self._playing.is_playing)
        offer_stop(self.stop_button, is_stopped=self._playing.is_stopped)

    def show_time(self, media_s: float) -> None:
        """Show where the clip is."""
        speed = self._playing.shuttle.speed
        text = position_text(media_s, self._view.duration_s)
        if speed != 1.0:
            text += f"  {speed:g}\u00d7".replace("-", "\u2212")
        if len(text) != len(self.time.text()):
            widest = "".join("8" if c.isdigit() else c for c in text)
            self.time.fix_width(self.time.fontMetrics().horizontalAdvance(widest) + 4)
        self.time.set_text(text)

    def set_usable(self, *, is_usable: bool) -> None:
        """Enable or disable everything but the time."""
        for widget in (
            *(self.play_button, self.stop_button, self.closer, self.wider, self.whole),
            *(self.snap, self.loop, self.compare),
        ):
            widget.setEnabled(is_usable)


class ViewBar(QScrollBar):
    """Scrolls the clip."""

    def __init__(self, view: TimeView) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._view = view
        self.setEnabled(False)
        self.valueChanged.connect(self._on_scrolled)
        view.changed.connect(self.show_view)

    def show_view(self) -> None:
        """Show which part of the clip is in view."""
        view = self._view
        self.blockSignals(True)
        self.setRange(0, round(_PER_S * (view.duration_s - view.span_s)))
        self.setPageStep(max(1, round(_PER_S * view.span_s)))
        self.setSingleStep(max(1, round(0.1 * _PER_S * view.span_s)))
        self.setValue(round(_PER_S * view.begin_s))
        self.setEnabled(self.maximum() > 0)
        self.blockSignals(False)

    def _on_scrolled(self, value: int) -> None:
        begin_s = value / _PER_S
        self._view.show_span(begin_s, begin_s + self._view.span_s)


class ChangeBar(QWidget):
    """Takes changes back, makes them again, saves them."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._stack = document.stack
        self.undo_button = text_button(self.tr("&Undo"), "")
        self.redo_button = text_button(self.tr("&Redo"), "")
        self.save_button = text_button(
            self.tr("&Save"),
            self.tr("Save the effects and render the force with them (Ctrl+S)"),
            "primary",
        )
        self.close_button = text_button(self.tr("Close"), "")
        self.note = paragraph(colour=theme.DIM)
        self.note.setTextFormat(Qt.TextFormat.PlainText)
        row_of(
            *(self.undo_button, self.redo_button, (self.note, 1)),
            *(self.save_button, self.close_button),
            spacing=8,
            of=self,
        )

    def show_changes(self, *, can_edit: bool) -> None:
        """Show what can be undone, and whether there is anything to save."""
        stack = self._stack
        for button, text, can_do in (
            (self.undo_button, stack.undoText(), stack.canUndo()),
            (self.redo_button, stack.redoText(), stack.canRedo()),
        ):
            button.setEnabled(can_edit and can_do)
            name = button.text().replace("&", "")
            button.setToolTip(titled(name, text) if can_do else name)
        self.save_button.setEnabled(can_edit and not stack.isClean())
        self.note.setText("" if stack.isClean() else self.tr("Not saved yet"))
