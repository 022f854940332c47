"""Renders the force of a sequence in another way, after a look at what that changes."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QWidget,
)

from app.bridge.jobs import in_child
from app.bridge.languages import translated
from app.experimenter.rendering_fields import Chosen, RenderingFields
from app.plots.rendering_picture import RenderingPicture
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import (
    ElidedLabel,
    ask_text,
    column_of,
    fill_page,
    paragraph,
    row_of,
    scrolling,
)
from app.widgets.messages import JobRow, StatusLine
from app.widgets.texts import local
from hapticplayer.errors import HapticPlayerError, Progress
from hapticplayer.model import PresetName
from hapticplayer.sequence.comparison import (
    RenderingResult,
    previewed_rendering,
    stored_rendering,
)
from hapticplayer.sequence.editing import MAX_TITLE, copy_changed, set_mapping
from hapticplayer.sequence.excursion import excursion_texts
from hapticplayer.sequence.figures import ForceFigures
from hapticplayer.sequence.library import free_name

WIDTH_PX, HEIGHT_PX = 1080, 680
_SETTLE_POLLS = 8
_DASH = "\u2013"


class RenderingPage(JobDialog):
    """Fields on the left, before and after on the right.

    `changed` has the folder of the sequence that was rendered again, `made` that of a
    new one.
    """

    changed = Signal(object)
    made = Signal(object)

    def __init__(
        self, folder: Path, title: str, library: Path, parent: QWidget | None = None
    ) -> None:
        super().__init__((WIDTH_PX, HEIGHT_PX), parent)
        self.setWindowTitle(self.tr("Rendering"))
        self._folder, self._title, self._library = folder, title, library
        self.before: RenderingResult | None = None
        self.after: RenderingResult | None = None
        self._is_writing = self._is_due = False
        self._wait = 0  # polls until what was chosen is looked at
        self._wanted: tuple[Callable[[Progress], None], Callable[[None], None]] | None
        self._wanted = None
        self.fields = RenderingFields(self)
        self.picture = RenderingPicture()
        self.status, self.warning = StatusLine(), paragraph("", theme.WARN)
        self._lay_out()
        self.fields.changed.connect(self._on_changed)
        self.begin()
        self._read()

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        name = ElidedLabel(self._title, theme.DIM)
        name.setToolTip(self._title)
        self.warning.setTextFormat(Qt.TextFormat.PlainText)
        self.warning.hide()
        right = column_of(
            (self.picture, 1), self._figure_grid(), self.warning, spacing=8
        )
        fill_page(
            self,
            name,
            (row_of(self._form_area(), (right, 1), spacing=14), 1),
            self.status,
            self._button_row(),
            spacing=10,
        )

    def _form_area(self) -> QScrollArea:
        """Return the fields, which scroll where the screen is low."""
        form = QFormLayout()
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapAllRows)
        self.fields.add_rows(form)
        self.area = scrolling(form)
        return self.area

    def _figure_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(18)
        grid.setVerticalSpacing(3)
        for column, text in ((1, self.tr("Before")), (2, self.tr("After"))):
            grid.addWidget(_figure(text, theme.DIM), 0, column)
        self.figures: dict[str, tuple[QLabel, QLabel]] = {}
        for row, (key, text) in enumerate(self._figure_names().items(), start=1):
            grid.addWidget(QLabel(text), row, 0)
            pair = (_figure(_DASH), _figure(_DASH))
            for column, label in enumerate(pair, start=1):
                label.setAccessibleName(text)
                grid.addWidget(label, row, column)
            self.figures[key] = pair
        grid.setColumnStretch(3, 1)
        return grid

    def _figure_names(self) -> dict[str, str]:
        reach = self.tr("Workspace, {hand} hand")
        hands = {
            "relaxed": self.tr("relaxed"),
            "normal": self.tr("normal"),
            "firm": self.tr("firm"),
        }
        return {
            "rms": self.tr("Force, RMS"),
            "peak": self.tr("Force, peak"),
            "limit": self.tr("Time at the force limit"),
            **{name: reach.format(hand=word) for name, word in hands.items()},
        }

    def _make_progress(self) -> None:
        self.progress = JobRow(
            text_button(self.tr("S&top"), self.tr("Cancel; nothing is kept"))
        )
        self.progress.stop.clicked.connect(self.jobs.cancel)
        policy = self.progress.sizePolicy()
        policy.setRetainSizeWhenHidden(True)  # else all moves with each prediction
        self.progress.setSizePolicy(policy)

    def _button_row(self) -> QHBoxLayout:
        self.leave = text_button(self.tr("&Close"), "")
        self.leave.clicked.connect(self.reject)
        self.copy = text_button(
            self.tr("&New sequence\u2026"),
            self.tr("Keep this sequence, and make another one in the library"),
        )
        self.copy.clicked.connect(self._ask_title)
        self.replace = text_button(
            self.tr("Change this se&quence"),
            self.tr("Render the realistic and the random track again"),
            "primary",
        )
        self.replace.clicked.connect(self.render_in_place)
        self._make_progress()
        return row_of(
            *(self.leave, (self.progress, 1), self.copy, self.replace), spacing=8
        )

    # --- looking -------------------------------------------------------------

    def _read(self) -> None:
        folder = self._folder
        self.jobs.run(
            self.tr("Reading"),
            lambda progress: in_child(stored_rendering, folder, progress=progress),
            self._take_before,
        )
        self._show()

    def _take_before(self, found: RenderingResult) -> None:
        self.before = self.after = found
        chosen = Chosen(found.mapping, False, PresetName(found.preset))
        self.fields.show_chosen(chosen)
        self.fields.offer_fit(found.fitted_gain_n_per_mps2)

    def _on_changed(self) -> None:
        self.after, self._is_due = None, True
        self._wait = _SETTLE_POLLS
        self.jobs.cancel()  # of what nobody wants any more
        self.status.show_text("")
        self._show()

    def _look(self) -> None:
        """Predict what the fields would give."""
        folder = self._folder
        try:
            chosen = self.fields.chosen()
        except HapticPlayerError as problem:
            self.status.show_problem(problem)
            return

        def work(progress: Progress) -> RenderingResult:
            return in_child(
                previewed_rendering,
                folder,
                chosen.mapping,
                fits_gain=chosen.fits_gain,
                preset=chosen.preset,
                progress=progress,
            )

        self.jobs.run(self.tr("Predicting the excursion"), work, self._take_after)
        self._show()

    def _take_after(self, found: RenderingResult) -> None:
        if self._is_due:  # something else was chosen meanwhile
            return
        self.after = found
        self.fields.offer_fit(found.fitted_gain_n_per_mps2)

    # --- writing -------------------------------------------------------------

    def render_in_place(self) -> None:
        """Render the sequence itself again."""
        folder, change = self._folder, self._change()
        if change is None:
            return

        def done(_none: None) -> None:
            self.changed.emit(folder)
            self.status.show_text(
                self.tr("The sequence was rendered again"), theme.GOOD
            )
            self._read()

        self._write(lambda progress: in_child(change, folder, progress=progress), done)

    def _ask_title(self) -> None:
        text = self.tr("{title} ({rendering})").format(
            title=self._title, rendering=self.fields.preset.currentText()
        )
        label = self.tr("Title")
        title = ask_text(self, self.tr("New sequence"), label, text[:MAX_TITLE])
        if title is not None:
            self.render_copy(title)

    def render_copy(self, title: str) -> None:
        """Render a copy of the sequence, which gets a place in the library."""
        folder, change = self._folder, self._change()
        if change is None:
            return
        target = free_name(self._library, title)

        def work(progress: Progress) -> None:
            in_child(
                copy_changed, folder, target, change, title=title, progress=progress
            )

        def done(_none: None) -> None:
            self.made.emit(target)
            text = self.tr("New sequence: {folder}")
            self.status.show_text(text.format(folder=target), theme.GOOD)

        self._write(work, done)

    def _change(self) -> Callable[..., None] | None:
        """The rendering of a sequence as chosen; None where the fields are wrong."""
        try:
            chosen = self.fields.chosen()
        except HapticPlayerError as problem:
            self.status.show_problem(problem)
            return None
        return partial(
            set_mapping,
            mapping=chosen.mapping,
            fits_gain=chosen.fits_gain,
            preset=chosen.preset,
        )

    def _write(
        self, work: Callable[[Progress], None], done: Callable[[None], None]
    ) -> None:
        """Begin to write as soon as nothing is looked at any more."""
        self.jobs.cancel()
        self._wanted = (work, done)
        self.status.show_text("")
        self._show()

    # --- what is shown -------------------------------------------------------

    def _show(self) -> None:
        """Show what is known, and what can be done now."""
        is_writing = self._is_writing or self._wanted is not None
        can_choose = self.before is not None and not is_writing
        was_enabled = self.area.isEnabled()
        self.area.setEnabled(can_choose)
        if can_choose and not was_enabled:  # the focus left with the fields
            self.fields.preset.setFocus()
        self.copy.setEnabled(can_choose)
        self.replace.setEnabled(can_choose)
        self.progress.show_state(self.jobs.state())
        before, after = self.before, self.after
        notice = "" if self.status.text() else self.tr("Reading")
        self.picture.show_curves(
            before.curves if before else None, after.curves if after else None, notice
        )
        for column, one in enumerate((before, after)):
            texts = _texts(one.figures) if one else {}
            for key, pair in self.figures.items():
                pair[column].setText(texts.get(key, _DASH))
        notes = excursion_texts(after.excursion) if after else []
        self.warning.setText("\n".join(translated(note) for note in notes))
        self.warning.setVisible(bool(notes))

    # --- what happens by itself ----------------------------------------------

    def show_buttons(self) -> None:
        """Show what came of the work."""
        self._is_writing = False
        self._show()

    def poll(self) -> None:
        """Show how far the work is, and what came of it."""
        super().poll()
        self._wait = max(0, self._wait - 1)
        if self.jobs.is_busy or self.is_leaving:
            return
        if self._wanted is not None:
            self._is_writing, (work, done) = True, self._wanted
            self._wanted = None
            self.jobs.run(self.tr("Rendering the force"), work, done)
            self._show()
        elif self._is_due and not self._wait:
            self._is_due = False
            self._look()


def _figure(text: str, colour: str = "") -> QLabel:
    label = QLabel(text)
    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    if colour:
        label.setStyleSheet(f"color: {colour};")
    return label


def _texts(figures: ForceFigures) -> dict[str, str]:
    """Return figures as the language writes them."""
    return {
        "rms": local(f"{figures.rms_n:.2f} N"),
        "peak": local(f"{figures.peak_n:.2f} N"),
        "limit": local(f"{100.0 * figures.saturated_share:.2g} %"),
        **{name: f"{100.0 * reach:.0f} %" for name, reach in figures.reaches.items()},
    }
