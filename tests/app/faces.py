"""Every page and dialog, made one after the other."""

import importlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import help_faces
from PySide6.QtCore import QEventLoop
from PySide6.QtWidgets import (
    QWidget,
)
from still_recorder import StillRecorder, overview, silent_source, take

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

WORKING = (EditorPage, JobDialog, SetupPage, StudyEditor)


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
