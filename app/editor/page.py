"""The editor of effects: clip, force, sound, events and effects on one time line."""

from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QKeyCombination, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QMessageBox,
    QScrollBar,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.bridge.jobs import Jobs, Progress, in_child
from app.bridge.settings import screen_name
from app.editor.comparison import Comparison
from app.editor.document import Document
from app.editor.editing import Editing
from app.editor.editing_lanes import EditingLanes
from app.editor.effect_panel import EffectPanel
from app.editor.kind_list import KindList
from app.editor.live_force import LiveForce
from app.editor.playing import Means, Playing
from app.editor.view import TimeView
from app.player.transport import fix_stop_width, offer_play, offer_stop
from app.widgets import theme
from app.widgets.buttons import text_button, tool_button
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    column_of,
    fill_page,
    framed,
    paragraph,
    resize_within_screen,
    row_of,
)
from app.widgets.messages import JobBar, MessageBar
from app.widgets.texts import position_text, titled
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.model import ForceTrack, rendered_feedback
from hapticplayer.playback.source import Source, open_source
from hapticplayer.rendering.effects import EffectList
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.editing import rendering_of, set_effects
from hapticplayer.sequence.presets import Rendering
from hapticplayer.sequence.time_line import TimeLine, time_line_of

WIDTH_PX, HEIGHT_PX = 1180, 860
POLL_MS = 20  # an edit is felt within 200 ms
_AROUND_S = 0.3  # of an effect, that is repeated with it
_VIDEO_PX = 130  # high, at least
_STAGE_PX, _LANES_PX = 330, 420  # only the proportion counts
_ZOOM = 1.6
_REARM = QKeyCombination(Qt.KeyboardModifier.ControlModifier, Qt.Key.Key_R)
_PER_S = 1000  # steps of the scroll bar


class Loaded(NamedTuple):
    """A sequence as the page shows it, and what renders it."""

    source: Source
    line: TimeLine
    rendering: Rendering
    force_limit_n: float


class EditorPage(QDialog):
    """Shows the time line of a sequence and plays it on a player of its own.

    The window has to let go of the device before. Escape stops the force at once; where
    nothing plays it closes the page.
    """

    ready = Signal()
    """The sequence is shown."""

    saved = Signal(object)
    """The sequence in this folder has other effects and tracks."""

    def __init__(
        self, folder: Path, means: Means, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.folder, self._means = folder, means
        self.loaded: Loaded | None = None
        self.live: LiveForce | None = None
        self.jobs = Jobs(self._on_failed)
        self.view = TimeView()
        self.document = Document()
        self.editing = Editing(self.document)
        self.lanes = EditingLanes(self.view, self.editing)
        self.kinds, self.panel = KindList(), EffectPanel(self.editing)
        self.messages, self.job_bar = MessageBar(), JobBar()
        self.playing = Playing(means, self.messages.show_text, self)
        self.comparison = Comparison()
        self._saved_effects = self.document.effects
        self._closes_when_saved = False
        self._make_parts()
        self._lay_out()
        self._poll_timer = QTimer(self)
        self._poll_timer.timeout.connect(self._poll)
        self._poll_timer.start(POLL_MS)
        self._load()

    # --- building ------------------------------------------------------------

    def _make_parts(self) -> None:
        self.play_button = tool_button("play", "", "")
        self.stop_button = text_button("", "", "stop")
        fix_stop_width(self.stop_button)
        offer_play(self.play_button, is_playing=False)
        offer_stop(self.stop_button, is_stopped=False)
        self.time = ElidedLabel()
        self.time.setAccessibleName(self.tr("Time"))
        self.closer = text_button("+", self.tr("Show less of the clip (+)"), "tool")
        self.wider = text_button(
            "\u2212", self.tr("Show more of the clip (\u2212)"), "tool"
        )
        self.whole = text_button(self.tr("&Whole clip"), self.tr("Show the whole clip"))
        self.closer.setAccessibleName(self.tr("Zoom in"))
        self.wider.setAccessibleName(self.tr("Zoom out"))
        for button in (self.closer, self.wider):
            button.setMinimumWidth(36)
        self.loop = QCheckBox(self.tr("&Loop"))
        self.loop.setToolTip(
            self.tr("Repeat the selected effect, or what is in view without one")
        )
        self.compare = QCheckBox(self.tr("&Before"))
        self.compare.setToolTip(self.tr("Show the force without effects behind it"))
        self.compare.setChecked(True)
        self.snap = QCheckBox(self.tr("S&nap"))
        self.snap.setToolTip(self.tr("Snap to frames, events and other effects"))
        self.snap.setChecked(True)
        self.undo_button = text_button(self.tr("&Undo"), "")
        self.redo_button = text_button(self.tr("&Redo"), "")
        self.save_button = text_button(
            self.tr("&Save"),
            self.tr("Save the effects and render the force with them (Ctrl+S)"),
            "primary",
        )
        self.close_button = text_button(self.tr("Close"), "")
        self.bar = QScrollBar(Qt.Orientation.Horizontal)
        self.bar.setEnabled(False)
        self.note = paragraph(colour=theme.DIM)
        self.note.setTextFormat(Qt.TextFormat.PlainText)
        self._connect_parts()
        self._set_usable(is_usable=False)

    def _connect_parts(self) -> None:
        self.play_button.clicked.connect(self.playing.toggle)
        self.stop_button.clicked.connect(self.playing.stop_or_rearm)
        self.playing.moved.connect(self._follow)
        self.playing.changed.connect(self._show_state)
        self.loop.toggled.connect(lambda _is_on: self._apply_loop())
        self.compare.toggled.connect(self.lanes.show_before)
        self.closer.clicked.connect(lambda: self._zoom(1.0 / _ZOOM))
        self.wider.clicked.connect(lambda: self._zoom(_ZOOM))
        self.whole.clicked.connect(self.view.show_whole)
        self.close_button.clicked.connect(self.close)
        self.snap.toggled.connect(self._on_snap)
        self.kinds.wanted.connect(self._add_at_cursor)
        stack = self.document.stack
        self.undo_button.clicked.connect(self.undo)
        self.redo_button.clicked.connect(self.redo)
        self.save_button.clicked.connect(self.save)
        self.document.changed.connect(self._on_document)
        stack.cleanChanged.connect(lambda _is_clean: self._show_document())
        keys = QKeySequence.StandardKey
        for key, slot in (
            (keys.Undo, self.undo),
            (keys.Redo, self.redo),
            (keys.Save, self.save),
        ):
            QShortcut(key, self).activated.connect(slot)
        self.bar.valueChanged.connect(self._on_scrolled)
        self.view.changed.connect(self._show_scroll)
        self.lanes.pointed.connect(self._on_pointed)
        self.job_bar.cancelled.connect(self._cancel)

    def _lay_out(self) -> None:
        self.setWindowTitle(f"{self.tr('Edit effects')}[*]")
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.playing.surface.setMinimumHeight(_VIDEO_PX)
        stage, below, split = QWidget(), QWidget(), QSplitter(Qt.Orientation.Vertical)
        row_of(
            self.kinds,
            (framed(self.playing.surface), 1),
            self.panel,
            spacing=8,
            of=stage,
        )
        controls = row_of(
            *(self.play_button, self.stop_button, self.time, STRETCH),
            *(self.loop, self.compare, self.snap, self.wider, self.closer, self.whole),
            spacing=8,
        )
        column_of(controls, (framed(self.lanes), 1), self.bar, spacing=6, of=below)
        for part in (stage, below):
            split.addWidget(part)
        split.setSizes([_STAGE_PX, _LANES_PX])
        split.setChildrenCollapsible(False)
        buttons = row_of(
            *(self.undo_button, self.redo_button, (self.note, 1)),
            *(self.save_button, self.close_button),
            spacing=8,
        )
        parts = (self.messages, self.job_bar, (split, 1), self.comparison, buttons)
        whole: QVBoxLayout = fill_page(self, *parts, spacing=8)
        whole.setContentsMargins(12, 10, 12, 10)

    def _set_usable(self, *, is_usable: bool) -> None:
        for widget in (
            *(self.play_button, self.stop_button, self.lanes),
            *(self.closer, self.wider, self.whole),
            *(self.snap, self.loop, self.compare),
            *(self.kinds, self.panel),
        ):
            widget.setEnabled(is_usable)
        self._show_document()

    # --- beginning and end ---------------------------------------------------

    def _load(self) -> None:
        folder = self.folder

        def work(progress: Progress) -> Loaded:
            line = in_child(time_line_of, folder, progress=progress)
            sequence = open_sequence(folder)
            rendering, limit_n = rendering_of(sequence), sequence.mapping.force_limit_n
            return Loaded(open_source(folder), line, rendering, limit_n)

        self.jobs.run(self.tr("Reading the sequence"), work, self._take)

    def _take(self, loaded: Loaded) -> None:
        self.loaded = loaded
        source, line = loaded.source, loaded.line
        self.setWindowTitle(titled(self.tr("Edit effects"), f"{source.title}[*]"))
        self.view.set_duration(source.clip.duration_s)
        track = source.tracks[rendered_feedback(source.tracks)]
        self.lanes.show_clip(track, line, source.clip.frame_rate_hz)
        self.editing.duration_s = source.clip.duration_s
        self.comparison.set_clip(source.clip.duration_s, loaded.force_limit_n)
        self._saved_effects = line.effects
        self.live = LiveForce(loaded.rendering, self)
        self.live.made.connect(self._on_made)
        self.live.failed.connect(self._on_failed)
        self.document.open(line.effects)
        self._show_scroll()
        self._show_time(0.0)
        if line.problem:
            self.messages.show_text(line.problem)
        self._set_usable(is_usable=True)
        if not self.playing.begin(source, screen_name(self)):
            self.play_button.setEnabled(False)
            self.stop_button.setEnabled(False)
        self.lanes.setFocus()
        self.ready.emit()

    def _on_failed(self, problem: BaseException) -> None:
        self._closes_when_saved = False
        if self.loaded is not None:
            self._set_usable(is_usable=True)
        if not isinstance(problem, HapticPlayerError):
            raise problem
        self.messages.show_text(message_of(problem))

    def reject(self) -> None:
        """Stop before anything else; ask about changes that are not saved."""
        self.playing.stop()
        if self.jobs.is_busy and self.loaded is not None:
            return  # it is being saved
        if not self.document.stack.isClean() and not self._may_close():
            return
        self._end()
        super().reject()

    def _cancel(self) -> None:
        """Stop saving, of which nothing is kept; or reading, and then close."""
        if self.loaded is None:
            self.reject()
        else:
            self._closes_when_saved = False
            self.jobs.cancel()

    def _may_close(self) -> bool:
        """Ask; where the changes are to be saved, the page closes after that."""
        buttons = QMessageBox.StandardButton
        box = QMessageBox(
            QMessageBox.Icon.Question,
            self.tr("Edit effects"),
            self.tr("Save the changes of the effects?"),
            buttons.Save | buttons.Discard | buttons.Cancel,
            self,
        )
        chosen = QMessageBox.StandardButton(box.exec())
        if chosen is buttons.Save:
            self._closes_when_saved = True
            self.save()
        return chosen is buttons.Discard

    def close_jobs(self) -> None:
        """End what runs; the window is about to close."""
        self._end()

    def _end(self) -> None:
        self._poll_timer.stop()
        self.playing.end()
        if self.live is not None:
            self.live.close()
        self.comparison.close_jobs()
        self.jobs.close()

    # --- what a person does --------------------------------------------------

    def undo(self) -> None:
        """Take the last change back."""
        if self.lanes.isEnabled():
            self.document.stack.undo()

    def redo(self) -> None:
        """Make the change again that was taken back."""
        if self.lanes.isEnabled():
            self.document.stack.redo()

    def save(self) -> None:
        """Write the effects, and render the force with them in a process of its own."""
        if self.loaded is None or self.jobs.is_busy or self.document.stack.isClean():
            return
        folder, effects = self.folder, self.document.effects

        def work(progress: Progress) -> Source:
            in_child(set_effects, folder, effects, progress=progress)
            return open_source(folder)

        self.playing.pause()
        self.jobs.run(self.tr("Rendering the force"), work, self._on_saved)
        self._set_usable(is_usable=False)

    def _on_saved(self, source: Source) -> None:
        self.document.stack.setClean()
        self._saved_effects = self.document.effects
        assert self.loaded is not None  # it was saved
        self.loaded = self.loaded._replace(source=source)
        self._set_usable(is_usable=True)
        self.lanes.setFocus()
        self._show_force(source.tracks[rendered_feedback(source.tracks)])
        self.saved.emit(self.folder)
        if self._closes_when_saved:
            self.reject()

    def _add_at_cursor(self, kind: str) -> None:
        self.editing.add_kind(kind, self.lanes.cursor_s)

    def _on_snap(self, is_on: bool) -> None:
        self.lanes.snaps = is_on

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Play and pause by the space bar; Escape that stopped something ends here."""
        is_rearm = event.keyCombination() == _REARM
        if event.key() == Qt.Key.Key_Space:
            self.playing.toggle()
        elif is_rearm:
            self.playing.rearm()
        elif event.key() == Qt.Key.Key_Escape and self.playing.stops():
            event.accept()
        else:
            super().keyPressEvent(event)

    def _zoom(self, factor: float) -> None:
        self.view.zoom(factor, self.lanes.cursor_s)

    def _on_pointed(self, media_s: float) -> None:
        self._show_time(media_s)
        self.playing.seek(media_s)

    def _on_scrolled(self, value: int) -> None:
        begin_s = value / _PER_S
        self.view.show_span(begin_s, begin_s + self.view.span_s)

    # --- what is shown -------------------------------------------------------

    def _poll(self) -> None:
        self.job_bar.show_state(self.jobs.state(), self._means.clock.now_s())
        self.jobs.poll()
        if not self.jobs.is_busy:
            self.job_bar.hide()
            if self.loaded is not None and not self.lanes.isEnabled():
                self._set_usable(is_usable=True)  # saving was cancelled
                self.lanes.setFocus()
        if self.live is not None:
            self.live.poll()
        self.comparison.poll()

    def _on_document(self) -> None:
        self._show_document()
        if self.live is not None:
            self.live.want(self.document.effects)
        if self.loop.isChecked():
            self._apply_loop()

    def _on_made(self, effects: EffectList, track: ForceTrack) -> None:
        """Show and play what has been rendered; what was saved stays as it is stored."""
        assert self.loaded is not None  # else nothing is rendered
        if effects == self._saved_effects:
            tracks = self.loaded.source.tracks
            track = tracks[rendered_feedback(tracks)]
        elif not len(effects) and len(self.document.effects):
            track = self.playing.track or track  # the force without effects came first
        self._show_force(track)

    def _show_force(self, track: ForceTrack) -> None:
        before = self.live.plain if self.live is not None else None
        self.playing.replace(track)
        self.lanes.show_force(track, before)
        if before is not None:
            self.comparison.compare(before, track)

    def _apply_loop(self) -> None:
        """Repeat the selected effect with a little around it, or what is in view."""
        effect, span_s = self.document.effect, None
        if self.loop.isChecked():
            span_s = self.view.begin_s, self.view.end_s
            if effect is not None:
                end_s = min(effect.end_s + _AROUND_S, self.view.duration_s)
                span_s = max(0.0, effect.start_s - _AROUND_S), end_s
        self.playing.set_loop(span_s)
        self.lanes.show_loop(span_s)

    def _follow(self, media_s: float) -> None:
        before_s = self.lanes.cursor_s
        self.lanes.set_cursor(media_s)
        if self.view.begin_s <= before_s <= self.view.end_s:
            self.view.reveal(media_s)  # else a person looks somewhere else
        self._show_time(media_s)

    def _show_state(self) -> None:
        offer_play(self.play_button, is_playing=self.playing.is_playing)
        offer_stop(self.stop_button, is_stopped=self.playing.is_stopped)

    def _show_time(self, media_s: float) -> None:
        text = position_text(media_s, self.view.duration_s)
        if len(text) != len(self.time.text()):
            widest = "".join("8" if c.isdigit() else c for c in text)
            self.time.fix_width(self.time.fontMetrics().horizontalAdvance(widest) + 4)
        self.time.set_text(text)

    def _show_document(self) -> None:
        """Show what can be undone, and whether there is anything to save."""
        stack, can_edit = self.document.stack, self.lanes.isEnabled()
        for button, text, can_do in (
            (self.undo_button, stack.undoText(), stack.canUndo()),
            (self.redo_button, stack.redoText(), stack.canRedo()),
        ):
            button.setEnabled(can_edit and can_do)
            name = button.text().replace("&", "")
            button.setToolTip(titled(name, text) if can_do else name)
        self.save_button.setEnabled(can_edit and not stack.isClean())
        self.setWindowModified(not stack.isClean())
        self.note.setText("" if stack.isClean() else self.tr("Not saved yet"))

    def _show_scroll(self) -> None:
        view, bar = self.view, self.bar
        bar.blockSignals(True)
        bar.setRange(0, round(_PER_S * (view.duration_s - view.span_s)))
        bar.setPageStep(max(1, round(_PER_S * view.span_s)))
        bar.setSingleStep(max(1, round(0.1 * _PER_S * view.span_s)))
        bar.setValue(round(_PER_S * view.begin_s))
        bar.setEnabled(bar.maximum() > 0)
        bar.blockSignals(False)
