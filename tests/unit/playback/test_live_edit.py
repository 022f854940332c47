"""An edit of the effects is felt while the clip plays, through the real processes."""

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.limiter import Limits
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.rendering.effects import Effect, EffectList
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.editing import rendering_of

PATIENCE_S = 60.0


class Session:
    """Polls a player in real time; `ticks` are all that its loop has done."""

    def __init__(self, folder):
        self.clock = SystemClock()
        self.player = Player(self.clock, outputs=["simulated"], audio=None)
        self.ticks = self.player.ticks_since(0.0)
        self.player.open(open_source(folder))
        self.player.wait_ready()

    def poll_until(self, is_done):
        end_s = self.clock.now_s() + PATIENCE_S
        while not is_done():
            now_s = self.clock.now_s()
            assert now_s < end_s
            next_s = self.player.poll()
            last_s = self.ticks["monotonic_s"][-1] if len(self.ticks) else 0.0
            new = self.player.ticks_since(float(last_s))
            self.ticks = np.concatenate([self.ticks, new])
            self.clock.sleep_until(min(next_s, now_s + 0.02))

    def planned_n(self):
        return self.ticks["planned_n"][-1] if len(self.ticks) else np.zeros(3)


@pytest.mark.realtime
def test_effects_are_felt_while_the_clip_plays(sequence_folder):
    rendering = rendering_of(open_sequence(sequence_folder), "faithful")
    session = Session(sequence_folder)
    player = session.player
    try:
        player.play()
        session.poll_until(lambda: player.snapshot().leading.mode is Mode.FOLLOWING)
        first = len(session.ticks)
        for amplitude in (1.0, 0.4):
            values = {"amplitude": amplitude}
            pulse = Effect("pulse", 0.5, 9.0, fade_in_s=0.1, parameters=values)
            player.replace_track("realistic", rendering.track(EffectList((pulse,))))
            session.poll_until(
                lambda a=amplitude: abs(session.planned_n()[1] - a) < 0.1
            )
        snapshot, ticks = player.snapshot(), session.ticks[first:]
    finally:
        player.close()
    assert snapshot.phase is Phase.PLAYING
    assert not {Cause.SEEK, Cause.NO_TRACK} & set(ticks["cause"].tolist())
    follows = ticks["mode"] == Mode.FOLLOWING
    is_step = follows[1:] & follows[:-1] & (np.diff(ticks["monotonic_s"]) < 0.0015)
    assert is_step.sum() > 100  # a busy machine may be late in between
    steps_n = np.linalg.norm(np.diff(ticks["planned_n"], axis=0), axis=1)[is_step]
    own_n = 1.0 / 100 + 0.005  # the fade of the pulse, and the clip
    assert steps_n.max() <= Limits().entry_slew_n + own_n
