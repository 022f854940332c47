"""The window and its desktop: the screen stays awake, media keys work."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMainWindow

from app.bridge.idle import IdleInhibitor
from app.bridge.mpris import Mpris
from hapticplayer.playback.player import Player


class Desktop(QObject):
    """Follows the player; the window calls it when something has changed.

    Args:
        player: what plays.
        window: raised and closed by the desktop's controls.
    """

    def __init__(self, player: Player, window: QMainWindow) -> None:
        super().__init__(window)
        self._player = player
        self.idle = IdleInhibitor()
        self.mpris = Mpris(player, window.raise_, window.close)

    def follow(self) -> None:
        """Inhibit idling while it plays, and tell the desktop the state."""
        is_playing = self._player.snapshot().is_playing
        self.idle.set_wanted(self.tr("plays a clip") if is_playing else "")
        self.mpris.tell()

    def begin(self) -> None:
        """Appear on the session's bus."""
        self.mpris.switch(is_on=True)

    def set_study_mode(self, *, is_on: bool) -> None:
        """Leave the media keys without effect while somebody takes part in a study."""
        self.mpris.switch(is_on=not is_on)

    def close(self) -> None:
        """Let the screen sleep, and leave the bus."""
        self.idle.release()
        self.mpris.switch(is_on=False)
