"""J, K and L: back without force, stop, forward; again for faster."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from hapticplayer.clock import Clock
from hapticplayer.model.ranges import SPEED
from hapticplayer.playback.player import Player

FASTEST_BACK = 8.0
STEP_MS = 80  # a frame far from the last key frame takes a while to decode


class Shuttle(QObject):
    """Drives a player in both directions.

    Force is known for playing forward alone, so back means: paused, which has no force,
    and the frames go by from seek to seek.
    """

    moved = Signal(float)
    """Where the clip is while it goes back, s."""

    changed = Signal()
    """It goes back or not, or at another speed."""

    def __init__(self, clock: Clock, player: Callable[[], Player | None]) -> None:
        super().__init__()
        self.speed = 1.0  # below 0 it goes back
        self._clock, self._player = clock, player
        self._at_s = self._since_s = 0.0
        self._timer = QTimer(self)
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self._step)

    @property
    def is_back(self) -> bool:
        return self._timer.isActive()

    def back(self) -> None:
        """Go back; faster if it does already."""
        if (player := self._player()) is None:
            return
        if self.is_back:
            self._set(max(2.0 * self.speed, -FASTEST_BACK))
            return
        now = player.snapshot()
        player.pause()
        player.set_speed(1.0)
        self._at_s, self._since_s = now.media_s, self._clock.now_s()
        self._timer.start()
        self._set(-1.0)

    def forward(self) -> None:
        """Play; faster if it plays already."""
        if (player := self._player()) is None:
            return
        is_playing = player.snapshot().is_playing
        self._timer.stop()
        self._set(min(2.0 * self.speed, SPEED.largest) if is_playing else 1.0)
        player.set_speed(self.speed)
        player.play()

    def stop(self) -> None:
        """Pause, and be at the usual speed again."""
        self._timer.stop()
        if (player := self._player()) is not None:
            player.pause()
            player.set_speed(1.0)
        self._set(1.0)

    def _set(self, speed: float) -> None:
        self.speed = speed
        self.changed.emit()

    def _step(self) -> None:
        player, now_s = self._player(), self._clock.now_s()
        if player is None:
            self._timer.stop()
            return
        gone_s, self._since_s = now_s - self._since_s, now_s
        self._at_s = max(0.0, self._at_s + self.speed * gone_s)
        player.seek(self._at_s)
        self.moved.emit(self._at_s)
        if self._at_s == 0.0:
            self.stop()
