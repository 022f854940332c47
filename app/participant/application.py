"""Runs a participant: both windows, one player, and what joins them."""

import argparse
import contextlib
import os
import sys
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtWidgets import QApplication, QMainWindow

from app.bridge.collector import Collector
from app.bridge.errors import ErrorGateway
from app.bridge.idle import EVERYTHING, IdleInhibitor
from app.bridge.interrupts import closing_on_signals
from app.bridge.languages import translated
from app.bridge.pump import Cadence, Pump
from app.bridge.settings import Settings, default_path, latencies_of, screen_name
from app.experimenter.session_control import Mirror, SessionControl
from app.experimenter.start_panel import StartPanel
from app.participant.window import (
    WAY_BACK,
    ParticipantWindow,
    participant_screen,
)
from app.player.application import make_application
from app.player.controls import OUTPUT
from app.player.video_surface import SurfaceSink, VideoSurface
from app.widgets.job_dialog import JobDialog
from app.widgets.layout import is_seen
from app.widgets.texts import capitalised
from hapticplayer.clock import Clock, SystemClock
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound import AudioFactory
from hapticplayer.playback.sound_process import SoundProcess
from hapticplayer.playback.source import Source
from hapticplayer.study.pages import PageKind
from hapticplayer.study.preflight import (
    SessionCheck,
    checks_as_json,
    run_checks,
    volume_in_checks,
)
from hapticplayer.study.runner import SessionRunner
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.session_setup import (
    StudySources,
    check_unchanged,
    load_study_sources,
    make_stage,
)
from hapticplayer.study.streams import StudyStream, Wanted, open_stream
from hapticplayer.study.study_folder import Study, begin_session, open_study
from hapticplayer.study.ticks import next_record

if TYPE_CHECKING:
    from app.participant.rating_axes import RatingAxes
    from hapticplayer.capture.live.source import OpenedSource
    from hapticplayer.playback.chime import Chime

PRIVATE = 0o077  # umask: the records of the device belong to the participant too
WATCH_HZ, SLOW_HZ = 30.0, 2.0
SOUND_CHECK_S = 4.0
OPENED = "the session is open"  # for who has started it
_NATIVE = QKeySequence.SequenceFormat.NativeText


class StudySession:
    """Both windows of one participant's session."""

    def __init__(
        self,
        study: Study,
        study_sources: StudySources,
        outputs: Sequence[str],
        clock: Clock,
        *,
        audio: AudioFactory | None = SoundProcess,
        observer: StudyStream | None = None,
    ) -> None:
        self.study, self.study_sources, self.outputs = study, study_sources, outputs
        self.runner: SessionRunner | None = None
        self.sensor: OpenedSource | None = None
        self._clock, self._observer = clock, observer
        self._audio = audio
        self._axes: RatingAxes | None = None
        self._chime: Chime | None = None
        self.surface = VideoSurface()
        self.player = Player(clock, SurfaceSink(self.surface), audio=audio)
        sessions, _ = study.sessions()
        unfinished = [s.code for s in sessions if s.state is SessionState.UNFINISHED]
        self.start_panel = StartPanel(study.definition.languages, unfinished)
        self.start_panel.show_balance(study.balance())
        self.start_panel.volume_chosen.connect(self._set_volume)
        self.start_panel.volume.setValue(_last_volume(study))
        self.start_panel.outputs.show_names(outputs)
        self.start_panel.outputs.chosen.connect(self._choose_outputs)
        self.control = SessionControl(
            self.start_panel,
            Mirror(self.surface),
            shows_force=not study.definition.operator_is_blind,
        )
        self.participant = ParticipantWindow(self.surface)
        self.gateway = ErrorGateway(self.control.show_message, self._halt)
        self.participant.refused.connect(self.gateway.report)
        self.participant.operator_wanted.connect(self._show_operator)
        self.control.page_wanted.connect(self._return_to_page)
        self.control.results_wanted.connect(self._show_results)
        self._is_windowed = False
        self.undisturbed = IdleInhibitor(services=EVERYTHING)
        self._watch_cadence, self._slow_turn = Cadence(WATCH_HZ), Cadence(SLOW_HZ)
        self._reported_s = clock.now_s()
        self._is_over = False
        self.pump = Pump(self.player.poll, clock, self._on_gap)
        self.start_panel.started.connect(self.begin)
        self.start_panel.clip_wanted.connect(self._play_sound)
        self.control.closing.connect(self.close)

    def show(self, *, windowed: bool) -> None:
        """Open both windows, the participant's on a screen of its own if there is.

        On a single screen it would cover the operator's: it opens with the first page.
        """
        self._is_windowed = windowed
        self.player.set_outputs(self.outputs)
        self.control.show()
        mine = self.control.screen()
        self.participant.setScreen(participant_screen(mine))
        if self._shares_screen:
            self.start_panel.say_one_screen(QKeySequence(WAY_BACK).toString(_NATIVE))
        else:
            self._show_participant()
        measured = Settings(default_path())
        screen = screen_name(self.participant)
        self.player.set_latencies(latencies_of(measured, screen))
        self.undisturbed.set_wanted("an experiment is running")
        self.control.raise_()
        self.pump.start()

    @property
    def _shares_screen(self) -> bool:
        theirs = self.participant.screen()
        return not self._is_windowed and theirs is self.control.screen()

    def _show_participant(self) -> None:
        """Show the participant's page; over the operator's panel on a single screen."""
        theirs = self.participant.screen()
        if self._is_windowed:
            self.participant.resize(theirs.availableGeometry().size() / 2)
            self.participant.show()
        else:
            self.participant.setGeometry(theirs.geometry())
            self.participant.showFullScreen()
        self.control.buttons["page"].hide()

    def _return_to_page(self) -> None:
        self._show_participant()
        self.participant.activateWindow()

    def _show_operator(self) -> None:
        """Bring the operator's panel back from behind the participant's page."""
        if not self._shares_screen or self.runner is None:
            return
        if self.runner.page.kind is PageKind.PLAYING:
            self.runner.pause()
            self.participant.refresh()
        self.control.buttons["page"].show()
        self.participant.hide()
        self.control.refresh()
        self.control.sum_up()
        self.control.raise_()
        self.control.activateWindow()

    def _show_results(self) -> None:
        """Show the sessions of the study; beside a session nothing of it is loaded."""
        from app.experimenter.study.results import StudyResults

        results = StudyResults(self.study.folder, self.control)
        results.analysis_wanted.connect(self._analyse)
        results.finished.connect(results.deleteLater)
        results.show()

    def _analyse(self) -> None:
        from app.experimenter.analysis import AnalysisWindow

        AnalysisWindow(self.study, self._clock, self.control).begin()

    # --- before the session ------------------------------------------------------

    def current_checks(self) -> tuple[SessionCheck, ...]:
        """Return the state of everything that a session needs."""
        screen = self.participant.screen()
        size = screen.geometry().size() * screen.devicePixelRatio()
        return run_checks(
            self.player,
            self.study.definition.checks,
            self.study.folder,
            {
                "width_px": size.width(),
                "height_px": size.height(),
                "refresh_hz": screen.refreshRate(),
                "screens": len(QGuiApplication.screens()),
            },
            is_sound_heard=self.start_panel.sound.isChecked(),
            volume_percent=self.start_panel.volume.value(),
        )

    def _set_volume(self, percent: int) -> None:
        self.player.set_volume(percent / 100)

    def _choose_outputs(self, names: list[str]) -> None:
        """Play on other devices; what one of them refuses is shown."""
        self.outputs = names
        try:
            self.player.set_outputs(names)
        except HapticPlayerError as problem:
            self.gateway.report(problem)

    def _play_sound(self) -> None:
        source = next(iter(self.study_sources.sources.values()))
        self.player.open(source, "none")
        self.player.set_end(min(SOUND_CHECK_S, source.clip.duration_s))
        self.player.play()

    def begin(self) -> None:
        """Start or resume, as the panel says; problems are shown there."""
        panel = self.start_panel
        try:
            self.begin_session(panel.who.currentData(), panel.language.currentData())
        except HapticPlayerError as problem:
            self.gateway.report(problem)

    def begin_session(self, code: str, language: str) -> None:
        """Make or reopen a session and show its page.

        Raises:
            HapticPlayerError: why it cannot be; nothing is shown then.
        """
        checks = self.current_checks()
        self._prepare_ratings()
        self._open_sensor(self.start_panel.sensor.text().strip())
        if code:
            session = self.study.session(code)
            check_unchanged(session, self.study_sources)
        else:
            session = begin_session(
                self.study, language, self.study_sources.clips, self._clock
            )
        if self._observer is not None:
            self._observer.begin(session)
        record = next_record(session.folder) if self.outputs else None
        self.player.set_outputs(self.outputs, record)
        self.player.wait_ready()
        name = record.name if record else ""
        stage = make_stage(
            *(self.study, self.study_sources, self.player, self._clock, name),
            self.sensor,
        )
        stage.opening = self._on_opening
        self.runner = SessionRunner(
            self.study, session.code, stage, self._clock, self._observer
        )
        is_good = all(check.is_good for check in checks)
        self.runner.store_checks(checks_as_json(checks), overridden=not is_good)
        if self.sensor is not None:
            self.runner.note(f"demonstration by the sensor {self.sensor.text}")
        self.participant.follow(self.runner)
        if not self.participant.isVisible():
            self._show_participant()
        self.participant.activateWindow()
        self.control.follow(self.runner, self.participant.refresh)

    def _prepare_ratings(self) -> None:
        """Open what moves ratings while a clip plays, and what calls for them."""
        ratings = self.study.definition.while_watching
        if not ratings or self._axes is not None:
            return
        from app.participant.rating_axes import RatingAxes

        wanted = {name for one in ratings for name in one.by}
        self._axes = RatingAxes(self.player, wanted)
        self.participant.strip.axis = self._axes.share
        if self._audio and any(one.every_s for one in ratings):
            from hapticplayer.playback.chime import Chime

            with contextlib.suppress(OSError):  # it is shown, too
                self._chime = Chime(self._audio, self.start_panel.volume.value() / 100)
                self.participant.strip.asked.connect(self._chime.play)

    def _open_sensor(self, name: str) -> None:
        """Open the sensor of the demonstration; what it asks, `record` has to know."""
        if self.sensor is not None:
            self.sensor.close()
            self.sensor = None
        if name:
            from hapticplayer.capture.live.source import open_source

            self.sensor = open_source(name, self._clock)

    def _on_opening(self, source: Source) -> None:
        self.surface.set_clip_size(source.clip.width, source.clip.height)
        self.control.plots.set_source(source)

    # --- while it runs --------------------------------------------------------------

    def _on_gap(self) -> None:
        now_s = self._clock.now_s()
        if self.runner is not None:
            self.runner.poll()
        if self._watch_cadence.is_due(now_s):
            self.gateway.poll()
            self._tell_force()
            self.participant.refresh()
            self.control.refresh()
            self._say_of_sensor()
            page = self.runner.page.kind if self.runner is not None else None
            self.control.mirror.follow(now_s, is_clip=page is PageKind.PLAYING)
            if self.runner is not None and is_seen(self.control.plots):
                plots, player = self.control.plots, self.player
                plots.follow(player.snapshot(), player.ticks_since)
        if self._slow_turn.is_due(now_s) and is_seen(self.control):
            self.control.health.show_readings(
                self.player.snapshot(), self.player.measurements()
            )
            if self.runner is None:
                self.start_panel.show_checks(self.current_checks())

    def _say_of_sensor(self) -> None:
        """Show the operator what to do with it."""
        if self.sensor is not None and self.runner is not None:
            from hapticplayer.study.felt_demonstration import FeltStage

            stage = self.runner.stage
            if isinstance(stage, FeltStage) and stage.said:
                self.control.played.setText(capitalised(translated(stage.said)))

    def _tell_force(self) -> None:
        """Hand the forces since the last call to the observer."""
        if self._observer is None:
            return
        ticks = self.player.ticks_since(self._reported_s)
        ticks = ticks[ticks["monotonic_s"] > self._reported_s]
        if len(ticks):
            self._reported_s = float(ticks["monotonic_s"][-1])
            self._observer.force(ticks["monotonic_s"], ticks["force_n"])

    def _halt(self) -> None:
        if self.runner is not None:
            self.runner.halt("fault")
        else:
            self.player.stop_force()

    def close(self) -> None:
        """Bring the hand to rest and let go of everything; answers are on the disk."""
        if self._is_over:
            return
        self._is_over = True
        for dialog in self.control.findChildren(JobDialog):
            dialog.done(0)
        for report in self.control.findChildren(QMainWindow):
            report.close()
        self.pump.stop()
        if self.runner is not None:
            self.runner.stage.interrupt()
        self.player.close()
        if self.sensor is not None:
            self.sensor.close()
        self._tell_force()  # those since the last call
        if self.runner is not None:
            self.runner.close()
        for opened in (self._chime, self._axes):
            if opened is not None:
                opened.close()
        self.undisturbed.release()
        self.participant.close_for_good()
        self.control.close_for_good()


def run(options: argparse.Namespace) -> int:
    """Show the study's windows and return the exit status once they are closed."""
    before = os.umask(PRIVATE)
    try:
        study = open_study(options.study)
        study_sources = load_study_sources(study)
        of = study.definition
        wanted = Wanted(of.needed_streams, of.lab_recorder)
        streams = open_stream("lsl", wanted) if options.lsl or of.lsl else None
        settings = Settings(default_path())
        application = make_application(settings)
        session = StudySession(
            study,
            study_sources,
            options.outputs,
            SystemClock(),
            audio=partial(SoundProcess, device=settings.text(OUTPUT)),
            observer=streams,
        )
        session.start_panel.choose(options.resume or "", options.language or "")
        try:
            session.show(windowed=options.windowed)
            with contextlib.suppress(OSError):  # nobody may listen any more
                sys.stdout.write(f"{OPENED}\n")
                sys.stdout.flush()
            _run_until_closed(application, session)
        finally:
            session.close()
            if streams is not None:
                streams.close()
    finally:
        os.umask(before)
    return 0


def _run_until_closed(application: QApplication, session: StudySession) -> None:
    collector = Collector()
    session.gateway.install()
    collector.begin()

    def close() -> None:
        session.close()
        application.quit()

    later: Callable[[], None] = lambda: QTimer.singleShot(0, close)  # noqa: E731
    try:
        with closing_on_signals(later):
            session.control.closing.connect(application.quit)
            application.exec()
    finally:
        session.gateway.uninstall()
        collector.end()


def _last_volume(study: Study) -> int:
    """Return the volume of the session before: all participants hear the same."""
    sessions, _ = study.sessions()
    for session in reversed(sessions):
        for record in reversed(session.records.intact):
            if record.kind == "checks":
                found = volume_in_checks(record.content.get("checks"))
                if found is not None:
                    return found
    return 100
