"""The editor of effects: clip, force, sound, events and effects on one timeline."""

from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QDialog,
    QMessageBox,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.bridge.errors import Attempts
from app.bridge.jobs import Jobs, in_child
from app.bridge.settings import screen_name
from app.editor import commands
from app.editor.comparison import Comparison
from app.editor.controls import ChangeBar, PlayBar, ViewBar
from app.editor.document import Document
from app.editor.editing import Editing
from app.editor.editing_lanes import EditingLanes
from app.editor.effect_panel import EffectPanel
from app.editor.kind_list import KindList
from app.editor.live_force import LiveForce
from app.editor.markers import MarkerList
from app.editor.playing import PlayerSetup, Playing
from app.editor.selection_keys import SelectionKeys
from app.editor.unsaved import Unsaved
from app.editor.view import TimeView
from app.player.command import KEYS
from app.widgets.layout import (
    column_of,
    fill_page,
    framed,
    resize_within_screen,
    row_of,
)
from app.widgets.messages import JobBar, MessageBar
from app.widgets.texts import titled
from hapticplayer.errors import (
    HapticPlayerError,
    Progress,
    UsageError,
    message_of,
)
from hapticplayer.model import ForceTrack, rendered_feedback
from hapticplayer.playback.source import Source, open_source
from hapticplayer.rendering.effects import EffectList, TimeMarker
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.editing import rendering_of, set_effects
from hapticplayer.sequence.events import TimeLine, time_line_of
from hapticplayer.sequence.presets import Rendering

WIDTH_PX, HEIGHT_PX = 1180, 860
POLL_MS = 20  # an edit is felt within 200 ms
_AROUND_S = 0.3  # of an effect, that is repeated with it
_VIDEO_PX = 130  # high, at least
_STAGE_PX, _LANES_PX = 330, 420  # only the proportion counts


class Loaded(NamedTuple):
    """A sequence as the page shows it, and what renders it."""

    source: Source
    line: TimeLine
    rendering: Rendering
    force_limit_n: float


class EditorPage(QDialog):
    """Shows the timeline of a sequence and plays it on a player of its own.

    The window has to let go of the device before. Escape stops the force at once; where
    nothing plays it closes the page.
    """

    ready = Signal()
    """The sequence is shown."""

    saved = Signal(object)
    """The sequence in this folder has other effects and tracks."""

    def __init__(
        self,
        folder: Path,
        setup: PlayerSetup,
        parent: QWidget | None = None,
        *,
        recovers: bool = False,
    ) -> None:
        super().__init__(parent)
        self.folder, self._setup, self._recovers = folder, setup, recovers
        self.loaded: Loaded | None = None
        self.live: LiveForce | None = None
        self.jobs = Jobs(self._on_failed)
        self.view = TimeView()
        self.document = Document()
        self.editing = Editing(self.document)
        self.lanes = EditingLanes(self.view, self.editing)
        self.keys = SelectionKeys(self.lanes)
        self.kinds, self.panel = KindList(), EffectPanel(self.editing)
        self.markers, self.left = MarkerList(), QTabWidget()
        self.messages, self.job_bar = MessageBar(), JobBar()
        self._attempts = Attempts()
        self.unsaved = Unsaved(folder, self.document, self.messages.show_text)
        self.playing = Playing(setup, self.messages.show_text, self)
        self.comparison = Comparison()
        self.play_bar = PlayBar(self.playing, self.view)
        self.view_bar, self.change_bar = ViewBar(self.view), ChangeBar(self.document)
        self._saved_effects = self.document.effects
        self._closes_when_saved = False
        self._connect_parts()
        self._set_usable(is_usable=False)
        self._lay_out()
        self._poll_timer = QTimer(self)
        self._poll_timer.timeout.connect(self._poll)
        self._poll_timer.start(POLL_MS)
        self._load()

    # --- building ------------------------------------------------------------

    def _connect_parts(self) -> None:
        self.playing.moved.connect(self._follow)
        play, change = self.play_bar, self.change_bar
        play.loop.toggled.connect(lambda _is_on: self._apply_loop())
        play.compare.toggled.connect(self.lanes.show_before)
        play.zoomed.connect(self._zoom)
        play.snap.toggled.connect(self._on_snap)
        self.kinds.wanted.connect(self._add_at_cursor)
        self.markers.wanted.connect(self.lanes.point_at)
        self.markers.renamed.connect(self._rename_marker)
        self.markers.removed.connect(self.editing.remove_marker)
        change.undo_button.clicked.connect(self.undo)
        change.redo_button.clicked.connect(self.redo)
        change.save_button.clicked.connect(self.save)
        change.close_button.clicked.connect(self.close)
        self.document.changed.connect(self._on_document)
        self.document.stack.cleanChanged.connect(
            lambda _is_clean: self._show_document()
        )
        commands.bind(self, self, self._setup.settings.table(KEYS))
        self.lanes.pointed.connect(self._on_pointed)
        self.unsaved.settled.connect(self._on_settled)
        self.job_bar.cancelled.connect(self._cancel)

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Edit effects") + "[*]")
        resize_within_screen(self, WIDTH_PX, HEIGHT_PX)
        self.playing.surface.setMinimumHeight(_VIDEO_PX)
        self.left.addTab(self.kinds, self.tr("Effects"))
        self.left.addTab(self.markers, self.tr("Markers"))
        self.left.setFixedWidth(self.left.minimumSizeHint().width())
        stage, below, split = QWidget(), QWidget(), QSplitter(Qt.Orientation.Vertical)
        row_of(
            self.left,
            (framed(self.playing.surface), 1),
            self.panel,
            spacing=8,
            of=stage,
        )
        lanes = (framed(self.lanes), 1)
        column_of(self.play_bar, lanes, self.view_bar, spacing=6, of=below)
        for part in (stage, below):
            split.addWidget(part)
        split.setSizes([_STAGE_PX, _LANES_PX])
        split.setChildrenCollapsible(False)
        bars = (self.messages, self.unsaved.bar)
        self.job_bar.lie_over(below)
        ends = (self.comparison, self.change_bar)
        whole: QVBoxLayout = fill_page(self, *bars, (split, 1), *ends, spacing=8)
        whole.setContentsMargins(12, 10, 12, 10)

    def _set_usable(self, *, is_usable: bool) -> None:
        self.play_bar.set_usable(is_usable=is_usable)
        can_edit = is_usable and not self.unsaved.is_asking
        for widget in (self.lanes, self.kinds, self.markers, self.panel):
            widget.setEnabled(can_edit)
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
        self.view_bar.show_view()
        self.play_bar.show_time(0.0)
        if line.problem:
            is_over = lambda: self._saved_effects is not line.effects  # noqa: E731
            self.messages.show_text(line.problem, is_over)
        self.unsaved.begin(source.title, line.effects)
        if self._recovers:
            self.unsaved.recover()
        self._set_usable(is_usable=True)
        if not self.playing.begin(source, screen_name(self)):
            self.play_bar.play_button.setEnabled(False)
            self.play_bar.stop_button.setEnabled(False)
        self._set_focus()
        self.ready.emit()

    def _on_settled(self) -> None:
        self._set_usable(is_usable=True)
        self._set_focus()

    def _set_focus(self) -> None:
        """Let the keyboard begin on the timeline, or where a person is asked first."""
        is_asking = self.unsaved.is_asking
        (self.unsaved.bar.accept_button if is_asking else self.lanes).setFocus()

    def _on_failed(self, problem: BaseException) -> None:
        self._closes_when_saved = False
        if self.loaded is not None:
            self._set_usable(is_usable=True)
        if not isinstance(problem, HapticPlayerError):
            raise problem
        self.messages.show_text(message_of(problem), self._attempts.begin())

    def reject(self) -> None:
        """Stop before anything else; ask about changes that are not saved."""
        self.playing.stop()
        if self.jobs.is_busy and self.loaded is not None:
            return  # it is being saved
        if not self.document.stack.isClean() and not self._may_close():
            return
        self._end(is_discarded=True)
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
            self.tr("Save your changes to the effects?"),
            buttons.Save | buttons.Discard | buttons.Cancel,
            self,
        )
        chosen = QMessageBox.StandardButton(box.exec())
        if chosen is buttons.Save:
            self._closes_when_saved = True
            self.save()
        return chosen is buttons.Discard

    def close_jobs(self) -> None:
        """End what runs; the window is about to close, and nobody has been asked."""
        self._end(is_discarded=False)

    def _end(self, *, is_discarded: bool) -> None:
        self._poll_timer.stop()
        self.unsaved.end(is_discarded=is_discarded)
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
        self._attempts.begin()
        self.document.stack.setClean()
        self._saved_effects = self.document.effects
        self.unsaved.saved()
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

    def mark(self) -> None:
        """Set a marker at the cursor, and show it in the list."""
        if self.lanes.isEnabled():
            at_s = self.lanes.cursor_s
            self.editing.mark(at_s)
            self.left.setCurrentWidget(self.markers)
            markers = self.document.effects.markers
            times_s = [abs(one.time_s - at_s) for one in markers]
            self.markers.choose(times_s.index(min(times_s)))

    def _rename_marker(self, marker: TimeMarker, name: str) -> None:
        try:
            self.editing.rename_marker(marker, name)
        except UsageError as problem:
            self.messages.show_text(message_of(problem), self._attempts.begin())
            self.markers.show_markers(self.document.effects.markers)

    def _on_snap(self, is_on: bool) -> None:
        self.lanes.snaps = is_on

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape that stopped something does not close the page."""
        if event.key() == Qt.Key.Key_Escape and self.playing.stops():
            event.accept()
        else:
            super().keyPressEvent(event)

    def _zoom(self, factor: float) -> None:
        self.view.zoom(factor, self.lanes.cursor_s)

    def _on_pointed(self, media_s: float) -> None:
        self.play_bar.show_time(media_s)
        self.playing.seek(media_s)

    # --- what is shown -------------------------------------------------------

    def _poll(self) -> None:
        self.job_bar.show_state(self.jobs.state(), self._setup.clock.now_s())
        self.jobs.poll()
        if not self.jobs.is_busy:
            self.job_bar.hide()
            is_idle = self.loaded is None or self.unsaved.is_asking
            if not is_idle and not self.lanes.isEnabled():
                self._set_usable(is_usable=True)  # saving was cancelled
                self.lanes.setFocus()
        if self.live is not None:
            self.live.poll()
        self.comparison.poll()

    def _on_document(self) -> None:
        self._show_document()
        self.markers.show_markers(self.document.effects.markers)
        if self.live is not None:
            self.live.want(self.document.effects)
        if self.play_bar.loop.isChecked():
            self._apply_loop()

    def _on_made(self, effects: EffectList, track: ForceTrack) -> None:
        """Show and play what has been rendered; what was saved stays as it is stored."""
        assert self.loaded is not None  # else nothing is rendered
        self._attempts.begin()
        if effects.effects == self._saved_effects.effects:
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
        """Repeat the selected effects with a little around them, or what is in view."""
        chosen, span_s = self.document.chosen.values(), None
        if self.play_bar.loop.isChecked():
            span_s = self.view.begin_s, self.view.end_s
            if chosen:
                end_s = max(one.end_s for one in chosen) + _AROUND_S
                begin_s = min(one.start_s for one in chosen) - _AROUND_S
                span_s = max(0.0, begin_s), min(end_s, self.view.duration_s)
        self.playing.set_loop(span_s)
        self.lanes.show_loop(span_s)

    def _follow(self, media_s: float) -> None:
        before_s = self.lanes.cursor_s
        self.lanes.set_cursor(media_s)
        if self.view.begin_s <= before_s <= self.view.end_s:
            self.view.reveal(media_s)  # else a person looks somewhere else
        self.play_bar.show_time(media_s)

    def _show_document(self) -> None:
        self.change_bar.show_changes(can_edit=self.lanes.isEnabled())
        self.setWindowModified(not self.document.stack.isClean())
