"""Starts the window: the command `hapticplayer` where there is a display."""

import argparse
import json
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication

from app.bridge.interrupts import closing_on_signals
from app.bridge.settings import KeptOutput, Settings, default_path, outputs_of
from app.player.controls import OUTPUT
from app.player.remake import OpenWindow, apply_appearance
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from app.widgets.theme import icon
from app.widgets.voice import give_voice
from hapticplayer.cli.common import complain, say
from hapticplayer.cli.play import (
    about,
    attach_log,
    opened,
    record_target,
    refuse_outputs,
    until_s,
    wanted_scheduling,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.haptics.processes import Health
from hapticplayer.linux import hasten_window, lock_memory
from hapticplayer.media.memory import keep_freed_memory
from hapticplayer.playback.conditions import with_feedback
from hapticplayer.playback.outputs import is_hardware
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import Source

# Python's own 5 ms, which the window's thread may have to wait many times in one round
# of painting, added up to silences of 190 ms while a recording was imported.
SWITCH_S = 0.001
AT_REST_MS = 150  # the log includes the force at rest after the end


def run(options: argparse.Namespace) -> int:
    """Show the window and return the exit status once it is closed."""
    study = study_in(options.source)
    source = opened(options) if options.source and not study else None
    feedback = None
    if source:
        source, feedback = with_feedback(source, options.feedback)
    end_s = until_s(options, source) if source else 0.0
    refuse_outputs(options)
    settings = Settings(default_path())
    application = make_application(settings)
    clock, surface = SystemClock(), VideoSurface()
    kept = outputs_of(settings)
    outputs = options.outputs if source else tuple(kept)
    record = record_target(options, outputs)
    sound = partial(SoundProcess, device=settings.text(OUTPUT))
    player = Player(
        clock,
        SurfaceSink(surface),
        audio=sound,
        scheduling=wanted_scheduling(options),
    )
    if source and source.clip.has_audio:
        player.prepare_sound()  # in parallel with the window
    window = PlayerWindow(player, surface, clock, settings, plots=options.plots)
    try:
        # only now: the haptics process wants to hear from us within a second
        if source:
            player.set_outputs(outputs, record)
        else:
            restore_outputs(window, kept, record)
        if source and any(is_hardware(one) for one in outputs):
            player.wait_ready()  # it may not be there: nothing is shown then
        _show(window, options, source, feedback)
        if source and feedback:
            _wait_ready(application, player)
            attach_log(player, options, about(source, feedback))
    except BaseException:
        window.close()
        raise
    _begin(window, options, source, study)
    if options.mute:
        window.extras.controls.begin_muted()
    if options.speed != 1.0:
        window.extras.controls.set_speed(options.speed)
    if source:
        player.set_end(min(player.snapshot().end_s, end_s))
    return _run_until_closed(application, window, options)


def make_application(settings: Settings | None = None) -> QApplication:
    """Return the one application of this process, with its theme and language."""
    sys.setswitchinterval(SWITCH_S)
    keep_freed_memory()
    hasten_window()
    lock_memory()
    application = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(application, QApplication)
    application.setApplicationName("hapticplayer")
    application.setDesktopFileName("hapticplayer")
    application.setWindowIcon(icon("hapticplayer"))
    give_voice()
    apply_appearance(application, settings or Settings(None))
    return application


def _show(
    window: PlayerWindow,
    options: argparse.Namespace,
    source: Source | None,
    feedback: str | None,
) -> None:
    """Show the window, and in it the first frame of the source."""
    if options.fullscreen and source:
        window.enter_fullscreen()
    else:
        window.show()
    window.activateWindow()
    window.player.poll()  # showing took a while
    if source is not None:
        window.session.show_source(source, feedback)


def _wait_ready(application: QApplication, player: Player) -> None:
    """Wait for the device; the window is painted, what a person does comes after it."""
    flags = QEventLoop.ProcessEventsFlag
    # the pump beats meanwhile
    while any(one.health is Health.STARTING for one in player.snapshot().outputs):
        application.processEvents(
            flags.WaitForMoreEvents | flags.ExcludeUserInputEvents
        )
    player.wait_ready()


def study_in(place: str) -> Path | None:
    """The folder of a study that was asked for, None for what plays."""
    path = Path(place)
    if not place or not (path.is_dir() or path.suffix == ".json"):
        return None
    from hapticplayer.study.definition_reader import DEFINITION

    folder = path.parent if path.name == DEFINITION else path
    return folder if (folder / DEFINITION).is_file() else None


def _begin(
    window: PlayerWindow,
    options: argparse.Namespace,
    source: Source | None,
    study: Path | None,
) -> None:
    """Play what was asked for."""
    player = window.player
    if source is None:
        if study:
            window.open_path(study)
        else:
            window.session.open_demo()
        return
    if options.more:
        window.playlist.set_paths([source.path, *map(Path, options.more)])
    if options.start > 0.0:
        player.seek(options.start)
    player.play()


def _run_until_closed(
    application: QApplication, window: PlayerWindow, options: argparse.Namespace
) -> int:
    def close() -> None:
        shown.window.close()
        application.quit()  # also out of dialogs that are still open

    def interrupt() -> None:
        if shown.window.session.jobs.is_busy:
            complain("interrupted; no file was left half written")
        close()

    def close_soon() -> None:
        QTimer.singleShot(AT_REST_MS, close)

    shown = OpenWindow(window, close_soon if options.close_at_end else None)
    shown.begin()
    try:
        with closing_on_signals(lambda: QTimer.singleShot(0, interrupt)):
            application.exec()
    finally:
        shown.end()
    window = shown.window
    if options.json:
        say(json.dumps(window.player.summary()))
    now = window.player.snapshot()
    problem = now.leading.record_problem or now.log_problem
    if options.close_at_end:
        problem = window.session.last_problem or problem
    if problem:
        complain(problem)
        return 1
    return 0


def restore_outputs(
    window: PlayerWindow, kept: Mapping[str, KeptOutput], record: Path | None = None
) -> None:
    """Play on what was chosen last; say why where that fails."""
    try:
        window.player.set_outputs(list(kept), record)
    except HapticPlayerError as problem:
        window.session.report_outputs(problem)
    for name in window.player.output_names:
        window.player.set_output(name, **kept[name]._asdict())
