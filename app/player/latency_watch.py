"""Keeps the player's latencies those of the outputs in use, and warns of late ones."""

from PySide6.QtCore import QCoreApplication, QObject

from app.bridge.cadence import Cadence
from app.bridge.latencies import SOUND, is_known, latencies_of, screen_name
from app.bridge.settings import Settings
from app.player.session import Session
from app.player.video_surface import VideoSurface
from hapticplayer.errors import HapticPlayerError
from hapticplayer.playback.latency import LARGE_S, is_wireless

_LOOK_HZ = 1.0
translate = QCoreApplication.translate


class LatencyWatch(QObject):
    """Looks once a second on which screen and through which output the clip plays.

    Args:
        session: whose player is told.
        settings: hold what was measured.
        surface: is on the screen.
    """

    def __init__(
        self, session: Session, settings: Settings, surface: VideoSurface
    ) -> None:
        super().__init__(surface)
        self._session, self._settings, self._surface = session, settings, surface
        self._turn = Cadence(_LOOK_HZ)
        self._screen = ""
        self._warned: set[str] = set()
        self.take()

    def take(self) -> None:
        """Compensate what the settings say of this screen, and of all else."""
        self._screen = screen_name(self._surface)
        self._session.player.set_latencies(latencies_of(self._settings, self._screen))

    def look(self, now_s: float) -> None:
        """Follow the window to another screen; warn once of each late output."""
        if not self._turn.is_due(now_s):
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
            self._session.gateway.report(HapticPlayerError(warning(name, reported_s)))


def warning(name: str, reported_s: float) -> str:
    """Return what a person should know of an output that is slow or has no wire."""
    what = translate(
        "LatencyWatch", "The sound output {name} is {ms:.0f} ms behind"
    ).format(name=name, ms=1e3 * reported_s)
    if reported_s <= LARGE_S:
        what = translate(
            "LatencyWatch", "The sound output {name} seems to be wireless"
        ).format(name=name)
    todo = translate(
        "LatencyWatch",
        "it may be later still than it says. Use headphones with a cable, or measure it: "
        "Playback, Measure latencies",
    )
    return f"{what}; {todo}"
