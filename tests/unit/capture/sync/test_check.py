"""Three pats of one stream stand out, against rides without any."""

import pytest

from hapticplayer.capture.sync.check import check_log, check_sound
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.extras.rides.motion_scenes import simulate_motion
from tests.material.sync_clips import simulate_pats

SCENES = ("car-hard", "car-motorway", "walk", "run", "bicycle")


def test_rides_without_pats_are_hardly_ever_called_usable():
    rides = [
        simulate_motion(scene, seed, duration_s=60.0)
        for scene in SCENES
        for seed in (71, 72)
    ]
    assert sum(check_log(ride.imu).is_usable for ride in rides) <= 1


def test_clear_pats_are_found_where_they_are():
    heard = 0
    for seed in range(870_000, 870_006):
        clip = simulate_pats(seed, hard=False, rate_hz=200)
        log = check_log(clip.imu)
        assert log.is_usable
        clocks = clip.clock_map
        felt_s = [clocks.rate * at_s + clocks.offset_s for at_s in log.pats_s]
        assert felt_s == pytest.approx(list(clip.pats_s), abs=0.03)
        sound = check_sound(ClipSound(clip.audio, clip.audio_rate_hz))
        if sound.is_usable:  # speech beside the pats may drown them
            heard += 1
            assert sound.pats_s == pytest.approx(list(clip.pats_s), abs=0.03)
    assert heard >= 5
