"""Every page and dialog, made one after the other, and what to look at in each."""

import importlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import help_faces
import numpy as np
from PySide6.QtCore import QEventLoop, QPoint, QRect, Qt
from PySide6.QtGui import QAccessible, QImage, QTextDocument
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QScrollBar,
    QSpinBox,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QTextEdit,
    QWidget,
)
from still_recorder import StillRecorder, overview, silent_source, take

from app.editor.lanes import Lanes
from app.editor.page import EditorPage
from app.editor.playing import PlayerSetup
from app.experimenter.analysis import AnalysisPage
from app.experimenter.import_queue import QueuePage, State
from app.experimenter.import_reading import ReadingPage
from app.experimenter.import_wizard import MOUNTING, REPORT, SYNC, ImportWizard
from app.experimenter.library_page import LibraryPage
from app.experimenter.record_feel import FeelSetup
from app.experimenter.record_page import TAKE, Opened, RecordPage
from app.experimenter.rendering_page import RenderingPage
from app.experimenter.session_control import Mirror, SessionControl
from app.experimenter.start_panel import StartPanel
from app.experimenter.study.editor import StudyEditor
from app.experimenter.study.merge_page import MergePage
from app.experimenter.study.new_study import NewStudyDialog
from app.experimenter.study.place_dialogs import export_dialog, pack_dialog
from app.experimenter.study.results import StudyResults
from app.experimenter.study.sequences import LibraryChoice
from app.player import setup_texts
from app.player.choices import PluggedFalcons
from app.player.commands import COMMANDS
from app.player.condition_form import ConditionDialog
from app.player.device_page import DevicePage
from app.player.dialogs import about_dialog
from app.player.keys_dialog import KeysDialog
from app.player.latency_page import LatencyPage
from app.player.outputs_page import OutputsPage
from app.player.question import Question
from app.player.setup_page import SetupPage
from app.player.window import PlayerWindow
from app.plots.grip_view import GripView
from app.plots.playhead_plot import PlayheadPlot
from app.widgets.job_dialog import JobDialog
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.devices.falcon.firmware import find_image
from hapticplayer.devices.falcon.reach import Reach
from hapticplayer.devices.falcon.transport import FalconForbiddenError, Transport
from hapticplayer.errors import DeviceError, Message, UsageError
from hapticplayer.model import Mapping
from hapticplayer.playback.player import Player
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.study.creation import create_study
from hapticplayer.study.merging import Merged
from hapticplayer.study.overview import (
    InvalidTrial,
    SessionSummary,
    UnreviewedText,
    study_overview,
)
from hapticplayer.study.preflight import SessionCheck
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.sites import site_summary

CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QTextEdit,
    QPlainTextEdit,
    GripView,
    Lanes,
    PlayheadPlot,
)
WORKING = (EditorPage, JobDialog, SetupPage, StudyEditor)
EVERY_PLACE = 80  # more stops of the Tab key than any page has
SEEN = 40  # of 255: a change of colour that is no rounding
MARGIN_PX = 4
ONE_ROWS_FRAME_PX = 2


def dialogs(window: PlayerWindow, folder) -> dict[str, Callable[[], QWidget]]:
    """Return what makes each page that belongs to a window."""
    study = create_study(folder / "study")
    return {
        "import": lambda: ImportWizard("", folder, window),
        "import-sync": lambda: _import_at(SYNC, window, folder),
        "import-mounting": lambda: _import_at(MOUNTING, window, folder),
        "import-report": lambda: _import_at(REPORT, window, folder),
        "import-queue": lambda: _queue(window, folder),
        "import-reading": lambda: ReadingPage(_table(folder), {}, window),
        "record": lambda: _record(window),
        "record-live": lambda: _record_live(window),
        "record-asked": lambda: _record_asked(window),
        "record-take": lambda: _record_take(window),
        "library-empty": lambda: LibraryPage(folder, window),
        "library": lambda: LibraryPage(_library(window), window),
        "effects": lambda: _editor(window),
        "effects-chosen": lambda: _editor_with_effect(window),
        "rendering": lambda: RenderingPage(
            window.player.snapshot().source.path, "A ride", folder, window
        ),
        "keyboard": lambda: KeysDialog(COMMANDS, window.settings, window),
        "about": lambda: about_dialog(window),
        "set-up": lambda: SetupPage(
            window.clock,
            "simulated",
            PluggedFalcons(list, window),
            window.settings,
            window,
        ),
        "set-up-falcon": lambda: SetupPage(
            window.clock,
            "falcon",
            PluggedFalcons(list, window),
            window.settings,
            window,
            _no_reach,
        ),
        "licence": lambda: Question(window, "Firmware", setup_texts.licence(), "OK"),
        "unknown-image": lambda: Question(
            window, "Firmware", setup_texts.unknown_image(), "OK"
        ),
        "feedback": lambda: ConditionDialog(["mine"], window),
        "outputs": lambda: OutputsPage(window.clock, window.session, window),
        "outputs-test": lambda: _outputs_in_test(window),
        "forces": lambda: DevicePage(window.clock, "simulated", window),
        "latencies": lambda: LatencyPage(
            *(window.clock, "simulated", window.settings, _no_player),
            *(window.player.latch, window),
        ),
        "study-results": lambda: _results(study.folder, window),
        "study-export": lambda: export_dialog(study.folder, window),
        "study-pack": lambda: pack_dialog(study.folder, window),
        "study-merge": lambda: _merge(study.folder, window),
        "new-study": lambda: NewStudyDialog(folder, window),
        "choose-recording": lambda: LibraryChoice(_library(window), window),
        **{
            f"study-{tab}": lambda tab=tab: _study_editor(study.folder, tab, window)
            for tab in range(6)
        },
        "analysis": lambda: AnalysisPage(
            "Rides", lambda _progress: [], print, window.clock
        ),
        "session": lambda: _operator(window.surface),
        **help_faces.dialogs(window, folder),
        **_dialogs_of_extras(window),
    }


def _dialogs_of_extras(window: PlayerWindow) -> dict[str, Callable[[], QWidget]]:
    found = {}
    for file in sorted((Path(__file__).parent / "extras").glob("*/faces.py")):
        faces = importlib.import_module(f"tests.app.extras.{file.parent.name}.faces")
        found |= faces.dialogs(window)
    return found


def _outputs_in_test(window: PlayerWindow) -> OutputsPage:
    """Return the page as it is while an output is tested."""
    page = OutputsPage(window.clock, window.session, window)
    page._tested = "falcon:0123456789ABCDEF0123456789ABCDEF"
    page.panel.set_device(page._tested)
    page._show_panel(is_wanted=True)
    page.panel.state.setText("an answer that did not come, and what to do about it")
    return page


def close(face: QWidget) -> None:
    """Close a page, which goes with its next event."""
    if isinstance(face, RecordPage):
        face.close_jobs()  # it would ask
    face.close()
    if isinstance(face, WORKING):
        face.close_jobs()
    face.deleteLater()


def _import_at(step: int, window: PlayerWindow, folder) -> ImportWizard:
    """Return the wizard at a step that a person has come to."""
    wizard = ImportWizard("", folder, window)
    if step == REPORT:
        wizard.on_made(window.player.snapshot().source.path)
    else:
        wizard.go_to(step)
    return wizard


def _queue(window: PlayerWindow, folder: Path) -> QueuePage:
    """Return a queue with a clip that needs an answer."""
    clips = [folder / f"ride {number}.mp4" for number in range(3)]
    for clip in clips:
        clip.write_bytes(b"")
    page = QueuePage(clips, folder, window)
    page.rows[0].state = State.RUNNING
    page.on_failed(UsageError("the taps are uncertain; enter the offset"))
    return page


def _table(folder: Path) -> Path:
    """Return a log whose columns nobody has named."""
    log = folder / "table.txt"
    rows = (f"{0.01 * k:.2f}\tabc\t0.1\t0.2\t9.8\t0\t0\t0.1" for k in range(40))
    log.write_text("\n".join(["t\tdevice\tacc x\ty\tz\tgyro x\ty\tz", *rows, ""]))
    return log


def _editor(window: PlayerWindow) -> EditorPage:
    """Return the editor of the clip that is open, once it is loaded."""
    setup = PlayerSetup(window.clock, "none", window.settings, make_player)
    page = EditorPage(window.player.snapshot().source.path, setup, window)
    loop = QEventLoop()
    page.ready.connect(loop.quit)
    loop.exec()
    return page


def _editor_with_effect(window: PlayerWindow) -> EditorPage:
    """Return the editor with the numbers of an effect that has many."""
    page = _editor(window)
    effects = (Effect("ramp", 0.2, 1.2), Effect("knock", 0.5, 0.7))
    page.document.open(EffectList(effects))
    page.document.select(1)
    return page


def make_player(clock, sink, device) -> Player:
    return Player(clock, sink, outputs=[device], audio=None)


def _record(window: PlayerWindow) -> RecordPage:
    setup = FeelSetup(window.clock, "none", Mapping(), make_player, window.player.latch)
    return RecordPage(window.settings, setup, window)


def _record_live(window: PlayerWindow) -> RecordPage:
    """Return the recorder while it records, and is asked about a sensor at once."""
    page = _record(window)
    page.on_started(Opened(StillRecorder(), silent_source()))
    return page


def _record_asked(window: PlayerWindow) -> RecordPage:
    """Return the recorder that has a question about its sensor."""
    page = _record(window)
    page.on_failed(
        LogQuestion(
            "does not declare its sign", ("accel-sign=+", "accel-sign=-"), "csv:-"
        )
    )
    return page


def _record_take(window: PlayerWindow) -> RecordPage:
    page = _record(window)
    page.take.show_take(take(), window.player.snapshot().source.clip.path)
    page.take.show_overview(overview())
    page.stack.setCurrentIndex(TAKE)
    page.show_buttons()
    return page


def _library(window: PlayerWindow):
    return window.player.snapshot().source.path.parent


def _operator(surface) -> SessionControl:
    """Return the operator's window while everything is wrong."""
    start = StartPanel(["en", "de"], ["P01"])
    found = {
        "device": "falcon-simulated, starting",
        "homed": "no data from the device yet",
        "scheduling": "normal",
        "sound": "not confirmed",
        "screen": "3840 x 2160, 60 Hz, screens: 2",
        "disk": "120 MB free",
    }
    start.show_checks(
        tuple(SessionCheck(name, False, what) for name, what in found.items())
    )
    return SessionControl(start, Mirror(surface), shows_force=True)


def _results(folder: Path, window: PlayerWindow) -> StudyResults:
    """Return the sessions of a study with one that has everything."""
    page = StudyResults(folder, window)
    page.close_jobs()
    invalid = InvalidTrial(3, "car-turning/realistic", ("frames_dropped", "sync:video"))
    one = SessionSummary(
        *("CDFGHJ", "2026-11-27T08:00:00.000Z", SessionState.UNFINISHED, True),
        *(("falcon", "rig:outsim,gain=0.25"), 7, 12, (invalid,), 2, 1),
    )
    text = UnreviewedText("CDFGHJ", "label@realistic", "as if I had been there " * 9)
    found = study_overview(folder)
    page.show_overview(replace(found, sessions=(one,), unreviewed=(text,)))
    page.sessions.selectRow(0)
    return page


def _merge(folder: Path, window: PlayerWindow) -> MergePage:
    """Return the page of copies with one that was merged."""
    page = MergePage(folder, window)
    page.add([folder])
    conflict = Message("two sessions of one code")
    summary = site_summary("", [])
    page.copies[0].found = Merged(("CDFGHJ",), (), (conflict,), (), summary)
    page.show_copies(0)
    return page


def _study_editor(folder: Path, tab: int, window: PlayerWindow) -> StudyEditor:
    """Return the editor of a study on one of its pages."""
    editor = StudyEditor(folder, lambda: _library(window), window)
    editor.tabs.setCurrentIndex(tab)
    return editor


def _no_reach(_name: str) -> Reach:
    def refuse() -> Transport:
        raise FalconForbiddenError("not allowed")

    return Reach(refuse, find_image)


def _no_player(*_arguments: object) -> Player:
    raise DeviceError("there is no device here")


# --- the keyboard --------------------------------------------------------------


def controls(face: QWidget) -> list[QWidget]:
    """Return what a person can use now, as far as the page has made it itself."""
    return [
        w
        for w in face.findChildren(QWidget)
        if isinstance(w, CONTROLS)
        and not isinstance(w, QScrollBar)
        and w.isVisibleTo(face)
        and w.isEnabled()
        and w.window() is face.window()
        and not w.objectName().startswith("qt_")
        and not isinstance(w.parent(), QAbstractSpinBox | QAbstractItemView | QComboBox)
    ]


def reached_by_tab(face: QWidget) -> list[QWidget]:
    """Press Tab until it comes round; return where it has stopped."""
    stops: list[QWidget] = []
    for _ in range(EVERY_PLACE):
        at = face.focusWidget() or face
        QTest.keyClick(at, Qt.Key.Key_Tab)
        now = face.focusWidget()
        if now is not None and stops and now is stops[-1]:
            continue  # to the next link of a text
        if now is None or now in stops:
            break
        stops.append(now)
    return stops


def focus_shows(widget: QWidget) -> int:
    """Return how many pixels in and around a widget tell that it has the focus."""
    window = widget.window()
    QApplication.setCursorFlashTime(0)
    above: QWidget | None = widget
    while above is not None and not isinstance(above, QScrollArea):
        above = above.parentWidget()
    if above is not None:
        above.ensureWidgetVisible(widget)
    widget.setFocus(Qt.FocusReason.TabFocusReason)  # which may scroll
    at = QRect(widget.mapTo(window, QPoint()), widget.size())
    at = at.adjusted(-MARGIN_PX, -MARGIN_PX, MARGIN_PX, MARGIN_PX)
    at = at.intersected(window.rect())
    with_focus = _pixels(window, at)
    widget.clearFocus()
    changed = np.abs(with_focus - _pixels(window, at)).max(axis=2) > SEEN
    return int(np.count_nonzero(changed))


def _pixels(window: QWidget, at: QRect) -> np.ndarray:
    image = window.grab(at).toImage().convertToFormat(QImage.Format.Format_RGB32)
    flat = np.frombuffer(image.constBits(), np.uint8)
    rows = flat.reshape(image.height(), image.bytesPerLine() // 4, 4)
    return rows[:, : image.width(), :3].astype(int)


def spoken_name(widget: QWidget) -> str:
    """Return what a screen reader says."""
    face = QAccessible.queryAccessibleInterface(widget)
    return face.text(QAccessible.Text.Name) if face else ""


# --- the texts -----------------------------------------------------------------


def cut_off(face: QWidget) -> Iterator[str]:
    """Yield each text that has less room than it needs."""
    for widget in face.findChildren(QWidget):
        if not widget.isVisibleTo(face) or not widget.width():
            continue
        for kind, look in _LOOKS.items():
            if isinstance(widget, kind):
                yield from look(widget)
                break
        if not isinstance(widget.parent(), QAbstractScrollArea | QAbstractItemView):
            yield from _outside(widget)


def _cut_button(button: QAbstractButton) -> Iterator[str]:
    needed, has = button.sizeHint(), button.size()
    is_whole = has.width() >= needed.width() and has.height() >= needed.height()
    if button.text() and not is_whole:
        yield f"button {button.text()!r}: {has} of {needed}"


def _cut_tabs(tabs: QTabBar) -> Iterator[str]:
    for k in range(tabs.count()):
        if tabs.tabRect(k).width() < _wide(tabs, tabs.tabText(k)):
            yield f"tab {tabs.tabText(k)!r}"


def _cut_items(combo: QComboBox) -> Iterator[str]:
    """Yield the choices that would be cut off once they are chosen."""
    option = QStyleOptionComboBox()
    combo.initStyleOption(option)
    part = QStyle.SubControl.SC_ComboBoxEditField
    kind = QStyle.ComplexControl.CC_ComboBox
    room_px = combo.style().subControlRect(kind, option, part, combo).width()
    for k in range(combo.count()):
        needed_px = combo.fontMetrics().horizontalAdvance(combo.itemText(k))
        if needed_px > room_px:
            yield f"choice {combo.itemText(k)!r}: {room_px} of {needed_px}"


def _cut_number(box: QAbstractSpinBox) -> Iterator[str]:
    """Yield a number whose field has no room for it."""
    field = box.lineEdit()
    margins = field.textMargins()
    room_px = field.width() - margins.left() - margins.right()
    texts = [box.text()]
    if isinstance(box, QSpinBox):
        texts += [f"{n}{box.suffix()}" for n in (box.minimum(), box.maximum())]
    for text in texts:
        if _wide(field, text) > room_px:
            yield f"number {text!r}: {room_px} of {_wide(field, text)}"


def short_lists(face: QWidget) -> Iterator[str]:
    """Open each choice that has the keyboard; yield the lists that are cut off."""
    for combo in face.findChildren(QComboBox):
        if not (combo.isVisibleTo(face) and combo.isEnabled() and combo.count()):
            continue
        combo.setFocus(Qt.FocusReason.TabFocusReason)
        QApplication.processEvents()
        combo.showPopup()
        QApplication.processEvents()
        view = combo.view()
        rows = min(combo.count(), combo.maxVisibleItems())
        needed_px = sum(view.sizeHintForRow(row) for row in range(rows))
        room_px = view.viewport().height()
        is_whole_screen = view.window().height() >= face.screen().size().height() - 60
        if room_px < needed_px - ONE_ROWS_FRAME_PX and not is_whole_screen:
            yield f"list {combo.accessibleName()!r}: {room_px} of {needed_px} px"
        combo.hidePopup()


def _cut_sections(header: QHeaderView) -> Iterator[str]:
    for k in range(header.count()):
        along = header.orientation() == Qt.Orientation.Horizontal
        size = header.sectionSizeFromContents(k)
        needed_px = size.width() if along else size.height()
        if not header.isSectionHidden(k) and header.sectionSize(k) < needed_px:
            text = header.model().headerData(k, header.orientation())
            yield f"header {text!r}: {header.sectionSize(k)} of {needed_px}"


def _cut_label(label: QLabel) -> Iterator[str]:
    if not label.text():
        return
    room = label.contentsRect()
    if label.wordWrap():
        wide, high = 0.0, float(label.heightForWidth(label.width()))
    elif "<" in label.text():
        document = QTextDocument()
        document.setDocumentMargin(0)
        document.setDefaultFont(label.font())
        document.setHtml(label.text())
        high, wide = document.size().height(), document.idealWidth()
    else:
        lines = label.text().split("\n")
        high = label.fontMetrics().height() * len(lines)
        wide = max(_wide(label, line) for line in lines)
    if high > room.height() + 2 or wide > room.width() + 2:
        needed = f"{wide:.0f} x {high:.0f}"
        yield f"label {label.text()!r}: {room.width()} x {room.height()} of {needed}"


_LOOKS: dict[type[QWidget], Callable[..., Iterator[str]]] = {
    QLabel: _cut_label,
    QAbstractButton: _cut_button,
    QComboBox: _cut_items,
    QAbstractSpinBox: _cut_number,
    QHeaderView: _cut_sections,
    QTabBar: _cut_tabs,
}


def _wide(widget: QWidget, text: str) -> int:
    plain = text.replace("&&", "\0").replace("&", "").replace("\0", "&")
    return widget.fontMetrics().horizontalAdvance(plain)


def _outside(widget: QWidget) -> Iterator[str]:
    parent = widget.parentWidget()
    if parent is None or widget.isWindow() or not isinstance(widget, CONTROLS):
        return
    if not parent.rect().contains(widget.geometry()):
        yield f"{type(widget).__name__} {spoken_name(widget)!r} reaches out of its place"
