"""Real-time playback without a window: the same engine without a display."""

from hapticplayer.clock import Clock
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player


def run(player: Player, clock: Clock, *, start_s: float, until_s: float) -> None:
    """Play from `start_s` to `until_s` of media time, or to the end of the clip.

    Raises:
        KeyboardInterrupt: from the user; the caller closes the player.
    """
    player.set_end(min(until_s, player.snapshot().end_s))
    if start_s > 0.0:
        player.seek(start_s)
    player.play()
    while player.snapshot().phase is not Phase.ENDED:
        clock.sleep_until(player.poll())
    # a little longer, so that the record shows the force at rest
    deadline_s = clock.now_s() + 0.1
    while clock.now_s() < deadline_s:
        clock.sleep_until(player.poll())
