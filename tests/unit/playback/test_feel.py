"""What is measured now in place of the clip's force."""

from hapticplayer.haptics.live import LiveForce
from hapticplayer.playback.output import LIVE


def test_a_live_force_is_in_place_of_the_clip_for_a_while(silent_theatre):
    theatre, force = silent_theatre, LiveForce()
    player = theatre.player
    player.play()
    theatre.run(0.1)
    player.feel(force)
    theatre.run(0.1)
    _, clock, track = theatre.published[-1]
    assert (clock.rate, track) == (0.0, LIVE)  # nothing was measured yet
    force.write(theatre.clock.now_s(), (1.0, 0.0, 0.0))
    theatre.run(0.1)
    at_s, clock, track = theatre.published[-1]
    assert (clock.media_s(at_s), clock.rate, track) == (at_s, 1.0, LIVE)
    before = clock.epoch
    player.feel(None)
    player.play()
    theatre.run(0.1)
    _, clock, track = theatre.published[-1]
    assert clock.epoch > before  # a new epoch fades out and in
    assert (clock.rate, track) == (1.0, "realistic")
    assert clock.media_s(theatre.clock.now_s()) < 1.0


def test_a_stop_withholds_a_live_force_until_re_armed(silent_theatre):
    theatre, force = silent_theatre, LiveForce()
    theatre.player.feel(force)
    theatre.player.stop_force()
    force.write(theatre.clock.now_s(), (1.0, 0.0, 0.0))
    theatre.run(0.02)
    assert theatre.published[-1][2] == ""
    theatre.player.rearm()
    theatre.run(0.02)
    assert theatre.published[-1][2] == LIVE


def test_a_clip_that_is_opened_ends_a_live_force(silent_theatre):
    theatre = silent_theatre
    theatre.player.feel(LiveForce())
    theatre.player.open(theatre.player.snapshot().source)
    theatre.run(0.02)
    assert theatre.published[-1][2] == "realistic"
