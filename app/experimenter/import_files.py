"""First page of an import: the files, and what was recognised in them."""

from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QFrame,
    QGridLayout,
    QLabel,
    QLineEdit,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from app.bridge.languages import translated
from app.experimenter.import_columns import in_words, words_of
from app.experimenter.import_mounting import Triad
from app.experimenter.import_reading import ReadingPage
from app.experimenter.import_suggestion import SuggestionBox
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import FileDrops, file_dialog, video_filter
from app.widgets.layout import STRETCH, captioned, column_of, paragraph, row_of
from app.widgets.texts import local, time_text, titled
from hapticplayer.capture import formats
from hapticplayer.capture.choices import (
    LogChoices,
    LogQuestion,
    parse_choices,
    write_template,
)
from hapticplayer.capture.mounting import AS_RECORDED
from hapticplayer.capture.source import name_of
from hapticplayer.errors import HapticPlayerError, TelemetryError, message_of
from hapticplayer.sequence.import_batch import items_of
from hapticplayer.sequence.import_preview import ImportPreview

translate = QCoreApplication.translate
_MOST_NOTES = 6
_WORDS = "words"
_ALL_THE_ROOM = 100  # next to a stretch of 1
_BETWEEN_FILES = "; "  # of a log in several files


class FilesPage(QWidget):
    """Takes a video and perhaps a log, shows what they are, and puts questions."""

    changed = Signal()
    several_wanted = Signal(list)

    def __init__(self, folder: str) -> None:
        super().__init__()
        self.drops = FileDrops(self, self._on_dropped)
        self._folder = folder
        self._words: list[str] = []
        self._before: list[str] = []
        self._asked: LogQuestion | None = None
        self.video = self._field(self.tr("Video"))
        self.log = self._field(self.tr("Motion log"))
        self.log.setPlaceholderText(self.tr("embedded in the video"))
        self.format = QComboBox()
        self.format.setAccessibleName(self.tr("Format"))
        self.format.addItem(self.tr("Detect automatically"), "")
        for one in formats.recording_formats():
            self.format.addItem(translated(one.text), one.name)
        self.format.activated.connect(
            lambda _row: self._answer([f"format={self.format.currentData()}"])
        )
        self.facts, self.notes = paragraph(), paragraph("", theme.DIM)
        for label in (self.facts, self.notes):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.triad, self.place = Triad(), _drop_place(self.tr("Drop a recording here"))
        self.problem = paragraph("", theme.BAD)
        self.problem.setTextFormat(Qt.TextFormat.PlainText)
        self.suggestion = SuggestionBox()
        self.question = LogQuestionBox()
        self.question.answered.connect(self._answer)
        self.question.form_wanted.connect(self.open_form)
        self.how = text_button(
            self.tr("&How the log is read\u2026"),
            self.tr("Units, axes, signs and more, with a check against gravity"),
        )
        self.how.clicked.connect(lambda: self.open_form({}))
        self.keep = text_button(
            self.tr("&Save as template\u2026"),
            self.tr("Save these answers as a template for all logs of this logger"),
        )
        self.keep.clicked.connect(self._choose_kept)
        self._lay_out()
        for field in (self.video, self.log):
            field.editingFinished.connect(self._on_edited)
        self._seen = ("", "")
        self.forget()

    # --- building ------------------------------------------------------------

    @staticmethod
    def _field(name: str) -> QLineEdit:
        field = QLineEdit()
        field.setAccessibleName(name)
        field.setClearButtonEnabled(True)
        return field

    def _lay_out(self) -> None:
        intro = paragraph(
            self.tr(
                "Drop a video here, together with its motion log if the sensor "
                "was a separate device. GoPro cameras store their motion data "
                "in the video."
            ),
            theme.DIM,
        )
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        rows = (
            (self.tr("&Video"), self.video, self._choose_video),
            (self.tr("Motion &log"), self.log, self._choose_log),
        )
        for line, (text, field, slot) in enumerate(rows):
            browse = text_button(self.tr("Choose\u2026"), field.accessibleName())
            browse.setAccessibleName(titled(field.accessibleName(), browse.text()))
            browse.clicked.connect(slot)
            for place, widget in enumerate((*captioned(text, field), browse)):
                grid.addWidget(widget, line, place)
        several = text_button(
            self.tr("Se&veral clips\u2026"), self.tr("Import clips one after the other")
        )
        several.clicked.connect(lambda: self.several_wanted.emit([]))
        parts = (*captioned(self.tr("&Format"), self.format), several)
        for place, widget in enumerate(parts):
            grid.addWidget(widget, len(rows), place)
        keep = row_of(self.how, self.keep, STRETCH)
        texts = column_of(self.facts, self.notes, keep, STRETCH)
        found = row_of((texts, 1), column_of(self.triad, STRETCH))
        asked = (self.problem, self.question, self.suggestion)
        shown = (intro, grid, *asked, (found, 1))
        column_of(*shown, (self.place, _ALL_THE_ROOM), spacing=10, of=self)

    # --- what is chosen ------------------------------------------------------

    def chosen(self) -> tuple[Path, tuple[Path, ...] | None] | None:
        """Return video and log, None while there is no video."""
        video, log = self.video.text().strip(), self.log.text().strip()
        return (Path(video), _paths(log) if log else None) if video else None

    def choices(self) -> LogChoices | None:
        return parse_choices(self._words) if self._words else None

    def take(self, paths: list[Path]) -> None:
        """Take over files that were dropped; a log may follow its video, or precede it."""
        items = items_of(paths)
        if len(items) > 1:
            self.several_wanted.emit(paths)
            return
        video, logs = items[0] if items else (None, ())
        is_another = bool(video and self.video.text().strip())
        if video is not None:
            self.video.setText(str(video))
        if logs or is_another:
            self.log.setText(_BETWEEN_FILES.join(map(str, logs)))
        self._on_edited()

    def _on_edited(self) -> None:
        now = (self.video.text().strip(), self.log.text().strip())
        self.place.setVisible(not any(now))
        if now != self._seen:
            self._seen, self._words, self._before = now, [], []
            self.format.setCurrentIndex(0)
            self._asked = None
            self.changed.emit()
            self._ask_for_video()

    def _ask_for_video(self) -> None:
        """Say what is missing where there is only a log."""
        video, log = self._seen
        if log and not video:
            text = self.tr(
                "{log} is a motion log. Choose or drop the video of the ride."
            )
            self.facts.setText(text.format(log=name_of(_paths(log))))
            self.video.setFocus()

    def open_form(self, words: Mapping[str, str]) -> ReadingPage | None:
        """Let people say how the log is read."""
        chosen = self.chosen()
        if chosen is None:
            return None
        known = parse_choices(self._words).given() | dict(words)
        page = ReadingPage(chosen[1] or chosen[0], known, self.window())
        page.taken.connect(self._take_form)
        page.finished.connect(page.deleteLater)
        page.open()
        return page

    def _take_form(self, answers: dict[str, str]) -> None:
        self._before = self._words
        self._words = [f"{key}={value}" for key, value in answers.items()]
        self.changed.emit()

    def _answer(self, words: list[str]) -> None:
        keys = {word.partition("=")[0] for word in words}
        kept = [w for w in self._words if w.partition("=")[0] not in keys]
        given = [w for w in words if not w.endswith("=")]
        self._before, self._words = self._words, [*kept, *given]
        try:
            self.choices()
        except HapticPlayerError as problem:
            self._words = self._before
            self.question.show_problem(translated(message_of(problem)))
        else:
            self.changed.emit()

    # --- what is shown -------------------------------------------------------

    def forget(self) -> None:
        """Show nothing until something is recognised."""
        asked = (self.problem, self.question, self.suggestion)
        for widget in (*asked, self.triad, self.keep, self.how):
            widget.hide()
        self.facts.clear()
        self.notes.clear()

    def show_problem(self, problem: BaseException) -> None:
        """Say why the files cannot be used, or ask what is doubtful."""
        self.forget()
        if isinstance(problem, LogQuestion):
            self._asked = problem
            self.question.ask(problem)
            if any("columns=" in answer for answer in problem.answers):
                self.open_form({})
            return
        if self._asked is not None and self._words != self._before:
            self._words = self._before  # the answer is none: it is asked again
            self.question.ask(self._asked)
            self.question.show_problem(translated(message_of(problem)))
            return
        if isinstance(problem, TelemetryError) and not self.log.text().strip():
            self.suggestion.offer(Path(self.video.text().strip()), problem)
            return
        self.problem.setText(translated(message_of(problem)))
        self.problem.show()

    def show_found(self, found: ImportPreview) -> None:
        """Show what was recognised."""
        self.forget()
        self.facts.setText("\n".join(self._facts(found)))
        more = len(found.notes) - _MOST_NOTES
        lines = [f"\u2022 {translated(note)}" for note in found.notes[:_MOST_NOTES]]
        self.notes.setText("\n".join(lines) + (f"\n\u2026 +{more}" if more > 0 else ""))
        self.triad.show_axes(AS_RECORDED, found.up)
        self.triad.show()
        self.keep.setVisible(bool(self._words))
        self.how.show()

    def _facts(self, found: ImportPreview) -> list[str]:
        clip = found.clip
        sound = self.tr("with sound") if clip.has_audio else self.tr("without sound")
        video = self.tr(
            "Video: {camera}{width} \u00d7 {height}, {rate} fps, {duration}, {sound}"
        ).format(
            camera=f"{translated(found.clip.camera)}, " if found.clip.camera else "",
            width=clip.width,
            height=clip.height,
            rate=local(f"{clip.frame_rate_hz:.4g}"),
            duration=time_text(clip.duration_s),
            sound=sound,
        )
        motion = self.tr(
            "Motion: {recorder}, {rate} Hz, {duration}, gaps: {gaps}"
        ).format(
            recorder=translated(found.recorder),
            rate=local(f"{found.rate_hz:.4g}"),
            duration=time_text(found.duration_s),
            gaps=found.gaps,
        )
        return [video, motion, self._axes(found)]

    def _axes(self, found: ImportPreview) -> str:
        up = found.up
        if up is None:
            return self.tr("The sensor rotated too much to tell its axes from gravity.")
        axis = max(range(3), key=lambda k: abs(up[k]))
        name = ("-" if up[axis] < 0.0 else "") + "xyz"[axis]
        return self.tr(
            "Axes: x right, y forward, z up of the sensor; on average {up} pointed up"
        ).format(up=name)

    # --- choosing ------------------------------------------------------------

    def _choose_video(self) -> None:
        self._choose(self.video, self.tr("Choose a video"), video_filter())

    def _choose_log(self) -> None:
        kinds = self.tr(
            "Motion logs (*.csv *.txt *.log *.zip *.gcsv *.json *.bin *.gpmf);;"
            "All files (*)"
        )
        self._choose(self.log, self.tr("Choose a motion log"), kinds)

    def _choose(self, field: QLineEdit, title: str, kinds: str) -> None:
        text = field.text().strip() or self.video.text().strip()
        start = str(_paths(text)[0].parent) if text else self._folder
        dialog = file_dialog(self, title, start, kinds)
        dialog.setFileMode(dialog.FileMode.ExistingFiles)

        def take(paths: list[str]) -> None:
            if field is self.video and len(paths) > 1:
                self._on_dropped([Path(path) for path in paths])
                return
            field.setText(_BETWEEN_FILES.join(paths))
            self._on_edited()

        dialog.filesSelected.connect(take)
        dialog.open()

    def _choose_kept(self) -> None:
        kinds = self.tr("Templates (*.json)")
        title = self.tr("Save the template")
        dialog = file_dialog(self, title, self._folder, kinds)
        dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
        dialog.setFileMode(dialog.FileMode.AnyFile)
        dialog.setDefaultSuffix("json")
        dialog.fileSelected.connect(self._keep)
        dialog.open()

    def _keep(self, path: str) -> None:
        try:
            write_template(Path(path), parse_choices(self._words), overwrite=True)
        except HapticPlayerError as problem:
            self.problem.setText(translated(message_of(problem)))
            self.problem.show()

    def _on_dropped(self, paths: list[Path]) -> None:
        try:
            self.take(paths)
        except HapticPlayerError as problem:
            self.show_problem(problem)


class LogQuestionBox(QFrame):
    """What is doubtful about a log, with the answers that are likely, and a form."""

    answered = Signal(list)
    form_wanted = Signal(dict)

    def __init__(self, *, has_form: bool = True) -> None:
        super().__init__()
        self.setObjectName("question")
        self.setStyleSheet(
            f"QFrame#question {{ border: 1px solid {theme.WARN}; border-radius: 5px; }}"
        )
        self.text, self.problem = paragraph(), paragraph("", theme.BAD)
        for label in (self.text, self.problem):
            label.setTextFormat(Qt.TextFormat.PlainText)
        self.answers = QButtonGroup(self)
        self._choices = QVBoxLayout()
        self.take = text_button(
            self.tr("&Answer"), self.tr("Read the log with this answer"), "primary"
        )
        self.take.clicked.connect(self._answer)
        self.form = text_button(
            self.tr("Answer in a &form\u2026"),
            self.tr("Units, axes, signs and more, with a check against gravity"),
        )
        self.form.clicked.connect(lambda: self.form_wanted.emit(self._words()))
        self.form.setVisible(has_form)
        buttons = row_of(STRETCH, self.form, self.take)
        parts = (self.text, self._choices, self.problem, buttons)
        column_of(*parts, margins=(9, 9, 9, 9), of=self)
        self.hide()

    def ask(self, question: LogQuestion) -> None:
        """Put a question."""
        name = Path(question.where).name
        self.text.setText(titled(name, translated(question.what)))
        self.problem.clear()
        for button in self.answers.buttons():
            self.answers.removeButton(button)
            button.deleteLater()
        for answer in _each(question.answers):
            words = words_of(answer)
            if words and "columns" not in words:  # which the form shows
                radio = QRadioButton(in_words(answer))
                radio.setProperty(_WORDS, words)
                radio.toggled.connect(lambda _on: self.take.setEnabled(True))
                self.answers.addButton(radio)
                self._choices.addWidget(radio)
        self.take.setVisible(bool(self.answers.buttons()))
        self.take.setEnabled(False)
        self.show()

    def show_problem(self, text: str) -> None:
        """Say that an answer cannot be one."""
        self.problem.setText(text)

    def _words(self) -> dict[str, str]:
        """The answer that is chosen, by key."""
        chosen = self.answers.checkedButton()
        return dict(chosen.property(_WORDS)) if chosen else {}

    def _answer(self) -> None:
        self.answered.emit([f"{key}={value}" for key, value in self._words().items()])


def _paths(text: str) -> tuple[Path, ...]:
    """Return the files that a field names."""
    if Path(text).exists():
        return (Path(text),)
    return tuple(Path(part) for part in text.split(_BETWEEN_FILES) if part.strip())


def _drop_place(text: str) -> QLabel:
    """The sign where files may be dropped, while there are none."""
    made = QLabel(text)
    made.setObjectName("drop")
    made.setAlignment(Qt.AlignmentFlag.AlignCenter)
    made.setFont(theme.scaled(made.font(), 1.4))
    made.setStyleSheet(
        f"QLabel#drop {{ color: {theme.DIM}; border: 2px dashed {theme.BORDER}; "
        "border-radius: 10px; }"
    )
    return made


def _each(answers: tuple[str, ...]) -> list[str]:
    """Return the answers, one for each of `KEY=A|B|C`; others stay as they are."""
    shown = []
    for answer in answers:
        key, _, values = answer.partition("=")
        is_list = "|" in values and " " not in answer
        each = [f"{key}={value}" for value in values.split("|")]
        shown += each if is_list else [answer]
    return shown
