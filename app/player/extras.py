"""Volume, speed, thumbnails, statistics and latencies, put into the window."""

from PySide6.QtCore import QCoreApplication, QObject

from app.bridge.pump import Cadence
from app.bridge.settings import SOUND, Settings, is_known, latencies_of, screen_name
from app.player.commands import Actions
from app.player.controls import Controls
from app.player.fullscreen import Fullscreen
from app.player.menus import ChooseMenus, History
from app.player.seek_preview import Thumbnails, heat_image, heat_of
from app.player.session import Session
from app.player.statistics import REFRESH_HZ, Statistics
from app.player.transport import Transport
from app.player.video_surface import VideoSurface
from app.widgets.layout import is_seen
from app.widgets.messages import Toast
from app.widgets.texts import time_text
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.latency import LARGE_S, is_wireless
from hapticplayer.playback.source import Source

_LOOK_HZ = 1.0
translate = QCoreApplication.translate


class LatencyMonitor(QObject):
    """Looks once a second on which screen and through which output the clip plays."""

    def __init__(
        self, session: Session, settings: Settings, surface: VideoSurface
    ) -> None:
        super().__init__(surface)
        self._session, self._settings, self._surface = session, settings, surface
        self._cadence = Cadence(_LOOK_HZ)
        self._screen = ""
        self._warned: set[str] = set()
        self.take()

    def take(self) -> None:
        """Compensate what the settings say of this screen, and of all else."""
        self._screen = screen_name(self._surface)
        self._session.player.set_latencies(latencies_of(self._settings, self._screen))

    def look(self, now_s: float) -> None:
        """Follow the window to another screen; warn once of each late output."""
        if not self._cadence.is_due(now_s):
            return
        if screen_name(self._surface) != self._screen:
            self.take()
        now = self._session.player.snapshot()
        name, reported_s = now.sound_output, now.reported_latency_s
        is_late = reported_s > LARGE_S or is_wireless(name)
        if not (name and is_late) or name in self._warned:
            return
        if reported_s == 0.0 and now.is_playing:
            return  # the number comes with the first seconds of sound
        self._warned.add(name)
        if not is_known(self._settings, SOUND, name):
            problem = HapticPlayerError(warning(name, reported_s))
            self._session.report(problem, lambda: self._is_settled(name))

    def _is_settled(self, name: str) -> bool:
        """Whether another sound output plays, or this one was measured."""
        is_other = self._session.player.snapshot().sound_output != name
        return is_other or is_known(self._settings, SOUND, name)


def warning(name: str, reported_s: float) -> str:
    """The warning about an output that is slow or has no wire."""
    what = translate(
        "LatencyMonitor", "The sound output {name} reports a latency of {ms:.0f} ms"
    ).format(name=name, ms=1e3 * reported_s)
    if reported_s <= LARGE_S:
        what = translate(
            "LatencyMonitor", "The sound output {name} seems to be wireless"
        ).format(name=name)
    todo = translate(
        "LatencyMonitor",
        "the actual latency may be higher. Use wired headphones, or "
        "measure it: Device > Measure latencies",
    )
    return f"{what}; {todo}"


SCREEN, RESUMES = "fullscreen_screen", "resumes"
"""Names in the settings."""


class Extras(QObject):
    """Keys, menus and overlays of the video; the window calls it periodically."""

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
        self.latency_monitor = LatencyMonitor(session, settings, surface)
        self._statistics_cadence = Cadence(REFRESH_HZ)
        self._heat_of: object = None
        fullscreen.screen_name = settings.text(SCREEN)
        self.menus = ChooseMenus(
            actions,
            self.history,
            self.controls,
            session.open_path,
            (lambda: fullscreen.screen_name, self.choose_screen),
        )
        self._connect()
        self._on_changed()

    def _connect(self) -> None:
        controls, actions = self.controls, self._actions
        self._transport.volume_chosen.connect(controls.set_volume)
        self._transport.mute_clicked.connect(actions.mute.toggle)
        controls.message.connect(self.toast.show_text)
        controls.changed.connect(self._on_changed)
        self._session.opening.connect(self._on_opening)
        self._session.chosen.connect(self._on_chosen)

    def refresh(self, now_s: float) -> None:
        """Look after what runs beside, and what the figures are."""
        self.thumbnails.poll()
        self.latency_monitor.look(now_s)
        if is_seen(self.statistics) and self._statistics_cadence.is_due(now_s):
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

    def apply_settings(self) -> None:
        """Do as the settings say: they came from a file."""
        self.controls.apply_settings()
        self.latency_monitor.take()
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

    def choose_screen(self, name: str) -> None:
        self._fullscreen.screen_name = name
        self._settings.keep(SCREEN, name)

    def show_statistics(self, *, is_wanted: bool) -> None:
        """Show or hide the figures over the video."""
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
        """Go on where the clip was left, and say so; a remote clip is not remembered."""
        if source.clip.remote:
            return
        self.history.note_opened(source.path)
        if not self._settings.flag(RESUMES, default=True):
            return
        at_s = self.history.position_s(source.path, source.clip.duration_s)
        if at_s > 0.0:
            self._player.seek(at_s)
            text = self.tr("Resuming at {time} (Home: from the start)")
            self.toast.show_text(text.format(time=time_text(at_s)))
