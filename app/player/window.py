"""The player's window: its parts, and what they do with the session."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent, QKeySequence
from PySide6.QtWidgets import (
    QMainWindow,
    QSplitter,
    QStackedWidget,
    QWidget,
)

from app.bridge.desktop import Desktop
from app.bridge.errors import IsOver
from app.bridge.pump import Cadence, Pump
from app.bridge.recovery import left_behind
from app.bridge.settings import Settings, choose_library, keep_outputs
from app.experimenter.study_menu import StudyMenu
from app.player import choices
from app.player.commands import Actions
from app.player.controls import Controls
from app.player.demo_end import DemoEnd
from app.player.dialogs import Dialogs
from app.player.display import Display, PlotArea
from app.player.dropping import Dropping
from app.player.empty_page import EmptyPage
from app.player.extras import Extras
from app.player.fullscreen import (
    EscapeFilter,
    FloatingControls,
    Fullscreen,
    close_beside,
)
from app.player.health_line import HealthLine
from app.player.menus import ThemeMenus
from app.player.playlist import Playlist, Repeat
from app.player.session import Session
from app.player.sync_plot import SyncPlot
from app.player.transport import Transport
from app.player.video_surface import VideoSurface
from app.player.viewing import Viewing
from app.widgets.files import FileDrops
from app.widgets.layout import column_of
from app.widgets.messages import JobBar, MessageBar, OfferBar, RecoveryBar
from app.widgets.theme import icon
from hapticplayer.clock import Clock
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source

if TYPE_CHECKING:
    from app.player.preferences import Chosen

WIDTH_PX, HEIGHT_PX = 1280, 800
LEAST_SCREEN_PX = 520  # on a lower screen the plots would push STOP out of it
LEAST_VIDEO_PX = 150  # high, also on a screen of 540 with all that can be shown
DRAW_HZ = 30.0  # what is shown beside the video needs no more
WATCH_HZ = 15.0
WHEEL_S = 5.0  # of the clip, for each notch with Shift
LONGEST_TITLE_PX = 600
PLOTS_PX, _STAGE_PX = 190, 600  # only the proportion counts
_HANDLE_PX = 3


class PlayerWindow(QMainWindow):
    """Shows one player, whose frames go to `surface`; closing it closes the player.

    With `waits` another window still has the player, until `begin`.
    """

    def __init__(
        self,
        player: Player,
        surface: VideoSurface,
        clock: Clock,
        settings: Settings,
        *,
        plots: bool = True,
        waits: bool = False,
    ) -> None:
        super().__init__()
        self.player, self.surface = player, surface
        self.clock, self.settings = clock, settings
        self.is_over = False
        self.session = Session(player, self.show_message)
        self.dialogs = Dialogs(self, self.session, settings)
        self.messages, self.job_bar, self.offer = MessageBar(), JobBar(), OfferBar()
        self.recovery = RecoveryBar()
        self.empty_page, self.plots = EmptyPage(), PlotArea()
        self.transport, self.health = Transport(), HealthLine()
        self.sync_plot = SyncPlot()
        self.commands = Actions(self, settings)
        self._lay_out()
        parts = (self.transport, self.plots, self.health)
        hidden = [self.menuBar(), *parts, self.sync_plot, self.offer, self.recovery]
        floating = FloatingControls(self.transport, surface, self._middle)
        self.fullscreen = Fullscreen(self, surface, hidden, floating)
        self._display = Display(self, self.session, clock, parts)
        self.extras = Extras(
            self.session,
            settings,
            self.commands,
            self.transport,
            surface,
            self.fullscreen,
        )
        self.viewing = Viewing(self.session, surface, self.commands, settings)
        self.pump = Pump(player.poll, clock, self._on_gap, self, rests=True)
        self.pump.rested.connect(lambda is_on: player.rest(is_wanted=is_on))
        self.desktop = Desktop(player, self, self.pump.wake)
        self.study_menu.running.connect(
            lambda is_on: self.desktop.set_study_mode(is_on=is_on)
        )
        self.study_menu.running.connect(self._on_study)
        self.themes = ThemeMenus(self.commands, settings)
        self._draw_cadence, self._watch_cadence = Cadence(DRAW_HZ), Cadence(WATCH_HZ)
        self._escape = EscapeFilter(self.stop, self, self.pump.wake)
        self._connect()
        self.settings.restore_geometry(self, WIDTH_PX, HEIGHT_PX)
        self._offer_devices()
        room_px = self.screen().availableGeometry().height()
        self.show_plots(are_wanted=plots and room_px >= LEAST_SCREEN_PX)
        if (source := player.snapshot().source) is not None:
            self._on_opening(source)
        self._on_opened()
        self._on_changed()
        self.stage.setFocus()
        if not waits:
            self.begin()

    def begin(self) -> None:
        self._escape.install()
        self.pump.start()
        self._offer_left()

    # --- building ------------------------------------------------------------

    def _lay_out(self) -> None:
        self.setWindowIcon(icon("hapticplayer"))
        self.commands.fill(self.menuBar())
        self.study_menu = StudyMenu(
            self,
            self.clock,
            self.session.report,
            (self.release_devices, self.take_back_devices),
            self.settings,
        )
        self.playlist = Playlist(self.session.open_path)
        self.dropping = Dropping(
            *(self, self.session, self.dialogs, self.playlist, self.offer),
            self.study_menu.open_folder,
        )
        self.drops = FileDrops(self, self.dropping.take)
        self.stage = QStackedWidget()
        self.surface.setMinimumHeight(LEAST_VIDEO_PX)
        self.stage.addWidget(self.empty_page)
        self.stage.addWidget(self.surface)
        splitter = QSplitter(Qt.Orientation.Vertical)
        for part in (self.stage, self.plots):  # a person may make the plots higher
            splitter.addWidget(part)
        splitter.setStretchFactor(0, 1)
        splitter.setChildrenCollapsible(False)
        splitter.setHandleWidth(_HANDLE_PX)
        splitter.setSizes([_STAGE_PX, PLOTS_PX])
        middle = QWidget()
        self.job_bar.lie_over(self.stage)
        above = (self.messages, self.recovery, self.offer)
        below = (self.sync_plot, self.health)
        self._middle = column_of(
            *(*above, (splitter, 1), self.transport, *below), spacing=0, of=middle
        )
        self.setCentralWidget(middle)

    def _connect(self) -> None:
        session, transport, page = self.session, self.transport, self.empty_page
        session.opening.connect(self._on_opening)
        session.chosen.connect(lambda _source: self.pump.wake())
        session.opened.connect(self._on_opened)
        session.changed.connect(self._on_changed)
        session.another_video.connect(self._on_another_video)
        session.ended.connect(self._on_ended)
        self.recovery.wanted.connect(
            lambda kept: self.dialogs.edit_effects(self.clock, kept.path, recovers=True)
        )
        self.surface.double_clicked.connect(self.toggle_fullscreen)
        self.surface.wheeled.connect(self._on_wheel)
        self.surface.menu_wanted.connect(lambda at: self.viewing.open_menu(at, self))
        self.viewing.message.connect(self.extras.toast.show_text)
        self.job_bar.cancelled.connect(session.jobs.cancel)
        transport.play_clicked.connect(self.player.toggle)
        transport.stop_clicked.connect(session.stop_or_rearm)
        transport.fullscreen_clicked.connect(self.toggle_fullscreen)
        transport.sought.connect(self.player.seek)
        self.plots.sought.connect(self.player.seek)
        transport.feedback_chosen.connect(session.choose_feedback)
        transport.device_chosen.connect(self._on_device_chosen)
        end = self._demo_end = DemoEnd(session, self.surface)
        end.import_clicked.connect(lambda: self._on_demo_end("import_recording"))
        end.device_clicked.connect(lambda: self._on_demo_end("set_up_device"))
        page.demo_clicked.connect(session.open_demo)
        page.open_clicked.connect(self.dialogs.open_sequence)
        page.import_clicked.connect(self.dialogs.import_recording)
        page.record_clicked.connect(self.commands.record.trigger)
        page.device_clicked.connect(self.commands.set_up_device.trigger)
        page.library_clicked.connect(self.commands.library.trigger)
        self._connect_commands()

    def _connect_commands(self) -> None:
        commands = self.commands
        commands.bind(self)
        for menu in commands.menus.values():
            menu.aboutToShow.connect(self.dialogs.prepare)
        self.dialogs.effects_left.connect(self._offer_left)
        self.dialogs.keys_changed.connect(commands.apply_keys)
        self.dialogs.settings_taken.connect(self._on_settings_taken)
        self.dialogs.plugged.changed.connect(self._offer_devices)
        self.transport.device_opening.connect(self.dialogs.plugged.refresh)

    # --- what a person does --------------------------------------------------

    def stop(self) -> None:
        """Take the force away, pause, and leave fullscreen; say how it comes back."""
        self.session.stop()
        self.fullscreen.leave()
        close_beside()
        keys = self.commands.rearm.shortcut().toString(
            QKeySequence.SequenceFormat.NativeText
        )
        text = self.tr("Force stopped. {keys} re-arms it.")
        self.extras.toast.show_text(text.format(keys=keys))

    def toggle_fullscreen(self) -> None:
        """Show the clip and nothing else, or everything again."""
        if self.fullscreen.is_on:
            self.fullscreen.leave()
        elif self.player.snapshot().source is not None:
            self.enter_fullscreen()

    def enter_fullscreen(self) -> None:
        """Show the clip and nothing else."""
        self.empty_page.give_way()
        self.stage.setCurrentWidget(self.surface)
        self.messages.hide()
        self.job_bar.hide()
        self._keep_geometry()
        self.fullscreen.enter()

    def show_plots(self, *, are_wanted: bool) -> None:
        """Show or hide the live plots."""
        self.commands.plots.setChecked(are_wanted)
        self.commands.grip.setEnabled(are_wanted)  # it is one of them
        self.fullscreen.will_show(self.plots, is_wanted=are_wanted)

    def show_grip(self, *, is_wanted: bool) -> None:
        self.plots.show_grip(is_wanted=is_wanted)

    def show_sync_plot(self, *, is_wanted: bool) -> None:
        """Show or hide the delay of the force."""
        self.fullscreen.will_show(self.sync_plot, is_wanted=is_wanted)

    def show_statistics(self, *, is_wanted: bool) -> None:
        """Show or hide the figures over the video."""
        self.extras.show_statistics(is_wanted=is_wanted)

    def _offer_left(self) -> None:
        self.recovery.offer(left_behind("effects"))

    def _on_wheel(self, notches: int, is_seek: bool) -> None:
        if is_seek:
            self.session.skip(WHEEL_S * notches)
        else:
            self.controls.turn(notches)

    def show_playlist(self) -> None:
        self.dialogs.show_playlist(self.playlist)

    def show_preferences(self) -> None:
        """Show on one page what the menus choose one by one."""
        from app.player.preferences import PreferencesPage

        page = PreferencesPage(self.settings, self.controls, self.viewing, self)
        page.chosen.connect(self._on_preferences)
        page.page_wanted.connect(lambda name: self.commands.by_name[name].trigger())
        page.open()

    def _on_preferences(self, chosen: "Chosen") -> None:
        if chosen.output != self.controls.output:
            self.controls.choose_output(chosen.output)
        self.extras.choose_screen(chosen.screen)
        choose_library(self.settings, chosen.library)
        if chosen.is_rebuilt:
            self.themes.changed.emit()

    def go_to_file(self, steps: int) -> None:
        """Open the next or the previous one of the list or folder."""
        if not self.playlist.go(steps):
            last, first = self.tr("No next file"), self.tr("No previous file")
            self.extras.toast.show_text(last if steps > 0 else first)

    def turn_repeat(self) -> None:
        """Choose what follows the end of a clip."""
        texts = {
            Repeat.OFF: self.tr("Repeat off"),
            Repeat.ONE: self.tr("Repeat this clip"),
            Repeat.ALL: self.tr("Repeat all"),
        }
        self.extras.toast.show_text(texts[self.playlist.turn_repeat()])

    def _on_ended(self) -> None:
        if not self.playlist.follow_end():
            self.player.seek(0.0)
            self.player.play()
        elif (
            self.player.snapshot().phase is Phase.ENDED
            and not self.session.jobs.is_busy
        ):
            self._demo_end.offer()

    def _on_demo_end(self, name: str) -> None:
        """Go on with a command after the demo; dialogs are not behind a full screen."""
        self.fullscreen.leave()
        self.commands.by_name[name].trigger()

    @property
    def controls(self) -> Controls:
        """Speed, loop, single frames, volume and sound output."""
        return self.extras.controls

    def show_message(self, text: str, is_over: IsOver | None = None) -> None:
        """Say what went wrong; not behind a video that fills the screen."""
        self.fullscreen.leave()
        self.messages.show_text(text, is_over)

    def _on_device_chosen(self, name: str) -> None:
        self.session.choose_leading(name)
        keep_outputs(self.settings, self.player.snapshot().outputs)

    def release_devices(self) -> list[str]:
        """Leave sound and devices to a session; return which devices these are."""
        self.player.latch.refuse()
        self.player.pause()
        self.player.lend_outputs()
        self.player.wait_released()
        return [one.device for one in self.player.snapshot().outputs]

    def _on_study(self, is_on: bool) -> None:
        """Begin stopped after a session: what was stopped there stays so here."""
        if not is_on:
            self.stop()

    def take_back_devices(self) -> None:
        self.player.take_back_outputs()
        self.session.changed.emit()

    def _on_settings_taken(self) -> None:
        self.commands.apply_keys()
        self.extras.apply_settings()

    def open_path(self, path: Path) -> None:
        """Play a clip, or edit a study."""
        if not (path.is_dir() and self.study_menu.open_folder(path)):
            self.session.open_path(path)

    # --- signals of the session ----------------------------------------------

    def _on_gap(self) -> None:
        now_s = self.clock.now_s()
        if self._watch_cadence.is_due(now_s):
            self.session.watch()
            if not self.fullscreen.is_on:
                self.job_bar.show_state(self.session.jobs.state(), now_s)
            self.extras.refresh(now_s)
            self.viewing.refresh()
        if self._draw_cadence.is_due(now_s):
            self._display.refresh()
            self.sync_plot.follow(now_s, self.player.sync_traces)

    def _on_opening(self, source: Source) -> None:
        self.messages.hide()
        self.offer.hide()
        self.empty_page.give_way()
        self.stage.setCurrentWidget(self.surface)
        self.surface.set_clip_size(source.clip.width, source.clip.height)

    def _on_opened(self) -> None:
        source = self.player.snapshot().source
        title = self.tr("hapticplayer")
        if source is not None:
            shown = self.fontMetrics().elidedText(
                source.title, Qt.TextElideMode.ElideMiddle, LONGEST_TITLE_PX
            )
            title = f"{shown} \u2013 {title}"
            if not source.clip.remote:
                self.playlist.note_opened(source.path)
        self.setWindowTitle(title)
        self.plots.set_source(source)
        self.transport.set_duration(source.clip.duration_s if source else 0.0)
        names = source.tracks if source else ()
        self.transport.set_feedbacks(choices.feedbacks(names))
        self.transport.select_feedback(self.player.snapshot().feedback)

    def _on_changed(self) -> None:
        now, is_busy = self.player.snapshot(), self.session.jobs.is_busy
        has_clip = now.source is not None
        self.empty_page.set_busy(is_busy=is_busy)
        for action in self.commands.opening:
            action.setEnabled(not is_busy)
        for action in self.commands.playing:
            action.setEnabled(has_clip)
        self.commands.rearm.setEnabled(self.session.is_stopped)
        self.transport.show_playing(is_playing=now.is_playing)
        self.transport.show_stopped(is_stopped=self.session.is_stopped)
        self.transport.select_feedback(now.feedback)
        self._show_device(now.leading.name)
        self.extras.show_force()
        self.desktop.follow()
        self._display.refresh_soon()

    def _on_another_video(self, source: Source) -> None:
        self.fullscreen.leave()
        self.dialogs.ask_about_video(source)

    def _show_device(self, name: str) -> None:
        if not self.transport.offers_device(name):
            self._offer_devices()
        self.transport.select_device(name)

    def _offer_devices(self) -> None:
        name, falcons = (
            self.player.snapshot().leading.name,
            self.dialogs.plugged.falcons(),
        )
        self.transport.set_devices(choices.devices(name, falcons))
        self.transport.select_device(name)

    # --- beginning and end ---------------------------------------------------

    def _keep_geometry(self) -> None:
        if not self.fullscreen.is_on:
            self.settings.keep_geometry(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        event.accept()
        if self.is_over:
            return
        self.study_menu.process.leave()  # a session continues
        self.hand_over()
        self.session.close()

    def freeze_painting(self, *, is_wanted: bool) -> None:
        """Paint only the video: another window will replace this one."""
        for part in (self.menuBar(), self.transport, self.plots, self.health):
            part.setUpdatesEnabled(not is_wanted)
        self._middle.setEnabled(not is_wanted)

    @property
    def is_working(self) -> bool:
        """Whether something runs beside, which `hand_over` would wait for."""
        is_looking = self.dialogs.plugged.is_busy or self.extras.is_busy
        return self.session.jobs.is_busy or is_looking

    def hand_over(self) -> None:
        """Let go of everything but the player, which another window may take over."""
        self.is_over = True
        self.fullscreen.leave()
        self.pump.stop()
        self._escape.remove()
        self._keep_geometry()
        self.extras.close()
        self.viewing.close()
        self.study_menu.close()
        self.dialogs.close()
        self.desktop.close()
        self.dialogs.plugged.close()
        self.settings.save()
        self.session.jobs.close()
