"""What a desktop player has beside playing, put into the window."""

from PySide6.QtCore import QObject

from app.bridge.cadence import Cadence
from app.bridge.settings import Settings
from app.player.actions import Actions
from app.player.choose_menus import ChooseMenus
from app.player.controls import Controls
from app.player.fullscreen import Fullscreen
from app.player.heat import heat_image, heat_of
from app.player.history import History
from app.player.latency_watch import LatencyWatch
from app.player.session import Session
from app.player.statistics import REFRESH_HZ, Statistics
from app.player.thumbnails import Thumbnails
from app.player.times import time_text
from app.player.transport import Transport
from app.player.video_surface import VideoSurface
from app.widgets.room import is_seen
from app.widgets.toast import Toast
from hapticplayer.playback.source import Source

FAR_S = 60.0
SCREEN = "fullscreen_screen"
"""Name in the settings."""

_TURNS = {"quieter": -1, "louder": 1}
_SPEEDS = {"slower": -1, "faster": 1, "normal_speed": 0}
_STEPS = {"step_back": -1, "step_forward": 1}
_SKIPS = {"far_back": -FAR_S, "far_forward": FAR_S}


class Extras(QObject):
    """Keys, menus and what lies on the picture; the window only calls it in time.

    Args:
        session: whose player is controlled.
        settings: what is remembered.
        actions: what a person triggers.
        transport: shows volume, speed, loop and force.
        surface: the texts lie on it.
        fullscreen: goes to the screen that was chosen.
    """

    def __init__(
        self,
        session: Session,
        settings: Settings,
        actions: Actions,
        transport: Transport,
        surface: VideoSurface,
        fullscreen: Fullscreen,
    ) -> None:
        super().__init__(surface)
        self._session, self._player = session, session.player
        self._settings, self._transport = settings, transport
        self._actions, self._fullscreen = actions, fullscreen
        self.controls = Controls(session.player, settings)
        self.history = History(settings)
        self.toast, self.statistics = Toast(surface), Statistics(surface)
        self.thumbnails = Thumbnails(transport.slider, transport.window(), self._player)
        self.latency_watch = LatencyWatch(session, settings, surface)
        self._statistics_turn = Cadence(REFRESH_HZ)
        self._heat_of: object = None
        fullscreen.screen_name = settings.text(SCREEN)
        self.menus = ChooseMenus(
            actions,
            self.history,
            self.controls,
            session.open_path,
            (lambda: fullscreen.screen_name, self._choose_screen),
        )
        self._connect()
        self._on_changed()

    def _connect(self) -> None:
        controls, actions = self.controls, self._actions
        for names, call in (
            (_TURNS, controls.turn),
            (_SPEEDS, controls.change_speed),
            (_STEPS, controls.step),
            (_SKIPS, self._session.skip),
        ):
            for name, value in names.items():
                action = actions.by_name[name]
                action.triggered.connect(lambda _=False, c=call, v=value: c(v))
        actions.loop.triggered.connect(controls.loop)
        actions.mute.toggled.connect(lambda on: controls.mute(is_wanted=on))
        actions.statistics.toggled.connect(self._on_statistics)
        self._transport.volume_chosen.connect(controls.set_volume)
        self._transport.mute_clicked.connect(actions.mute.toggle)
        controls.told.connect(self.toast.show_text)
        controls.changed.connect(self._on_changed)
        self._session.opening.connect(self._on_opening)
        self._session.chosen.connect(self._on_chosen)

    def refresh(self, now_s: float) -> None:
        """Look after what runs beside, and what the figures are."""
        self.thumbnails.poll()
        self.latency_watch.look(now_s)
        if is_seen(self.statistics) and self._statistics_turn.is_due(now_s):
            self.statistics.refresh(self._player)

    def show_force(self) -> None:
        """Show the force of the feedback that plays under the seek bar."""
        source = self._player.snapshot().source
        track = source.tracks.get(self._player.snapshot().feedback) if source else None
        if track is self._heat_of:
            return
        self._heat_of = track
        has_force = source is not None and track is not None and track.peak_n() > 0.0
        self._transport.slider.set_heat(
            heat_image(heat_of(track, source.clip.duration_s))
            if has_force and source is not None and track is not None
            else None
        )

    def take_settings(self) -> None:
        """Do as the settings say: they came from a file."""
        self.controls.take_settings()
        self.latency_watch.take()
        self._fullscreen.screen_name = self._settings.text(SCREEN)

    @property
    def is_busy(self) -> bool:
        """Whether something runs that `close` would wait for."""
        return self.thumbnails.is_busy or self.controls.present.is_busy

    def close(self) -> None:
        """Remember where the clip is; end what runs."""
        self.history.note_position(self._player)
        self.thumbnails.close()
        self.controls.present.close()

    def _choose_screen(self, name: str) -> None:
        self._fullscreen.screen_name = name
        self._settings.keep(SCREEN, name)

    def _on_statistics(self, is_wanted: bool) -> None:
        self.statistics.setVisible(is_wanted)
        if is_wanted:
            self.statistics.refresh(self._player)

    def _on_changed(self) -> None:
        controls = self.controls
        self._actions.mute.blockSignals(True)
        self._actions.mute.setChecked(controls.is_muted)
        self._actions.mute.blockSignals(False)
        self._transport.show_volume(controls.volume_percent, is_muted=controls.is_muted)
        self._transport.show_speed(self._player.snapshot().speed)
        self._transport.slider.set_marks(controls.marks_s)

    def _on_opening(self, _source: Source) -> None:
        self.history.note_position(self._player)
        self.controls.forget_loop()
        self.thumbnails.forget()

    def _on_chosen(self, source: Source) -> None:
        """Go on where the clip was left, and say so."""
        self.history.note_opened(source.path)
        at_s = self.history.position_s(source.path, source.clip.duration_s)
        if at_s > 0.0:
            self._player.seek(at_s)
            text = self.tr("Goes on at {time}; Home for the beginning")
            self.toast.show_text(text.format(time=time_text(at_s)))
