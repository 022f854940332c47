"""What is shown of a running clip beside the picture, and how often."""

from PySide6.QtWidgets import QMainWindow

from app.bridge.cadence import Cadence
from app.player.health_line import HealthLine
from app.player.plots_place import PlotsPlace
from app.player.session import Session
from app.player.transport import Transport
from app.widgets.room import is_seen
from hapticplayer.clock import Clock

PLOTS_HZ, STILL_PLOTS_HZ, TRANSPORT_HZ, HEALTH_HZ = 30.0, 4.0, 10.0, 2.0
GRIP_HZ = 15.0  # a hand is slower than what scrolls


class Display:
    """Refreshes position, plots and health; what is hidden costs nothing.

    Args:
        window: draws nothing while it is minimised or covered.
        session: whose player is shown.
        clock: of the machine.
    """

    def __init__(
        self,
        window: QMainWindow,
        session: Session,
        clock: Clock,
        parts: tuple[Transport, PlotsPlace, HealthLine],
    ) -> None:
        self._window = window
        self._session = session
        self._clock = clock
        self._transport, self._plots, self._health = parts
        self._transport_turn = Cadence(TRANSPORT_HZ)
        self._plots_turn = Cadence(PLOTS_HZ)
        self._still_plots_turn = Cadence(STILL_PLOTS_HZ)
        self._grip_turn = Cadence(GRIP_HZ)  # a hand moves on while the clip stands
        self._health_turn = Cadence(HEALTH_HZ)

    def refresh(self) -> None:
        """Draw what is due; called when the picture leaves time for it."""
        has_transport, has_plots = self._transport.isVisible(), self._plots.isVisible()
        has_health = self._health.isVisible()
        is_any = has_transport or has_plots or has_health
        if not is_any or not is_seen(self._window):
            return
        now_s = self._clock.now_s()
        player, now = self._session.player, self._session.player.snapshot()
        if has_transport and self._transport_turn.is_due(now_s):
            self._transport.follow(now.media_s)
        if has_plots and self._is_plots_turn(now_s, is_playing=now.is_playing):
            self._plots.follow(now, player.ticks_since)
        if has_plots and self._grip_turn.is_due(now_s):
            self._plots.follow_grip(now, player.ticks_since)
        if has_health and self._health_turn.is_due(now_s):
            self._health.show_readings(now, player.measurements())

    def refresh_soon(self) -> None:
        """Draw everything at the next opportunity: something has changed."""
        for turn in (self._transport_turn, self._still_plots_turn, self._health_turn):
            turn.reset()

    def _is_plots_turn(self, now_s: float, *, is_playing: bool) -> bool:
        if is_playing:
            return self._plots_turn.is_due(now_s)
        return self._still_plots_turn.is_due(now_s)
