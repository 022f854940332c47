"""What a microphone hears of a ride's shaking, and of what covers it."""

import numpy as np
import pytest

from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES
from tests.material.contact_sound import contact_sound, covered


def test_a_contact_sound_is_loudest_where_the_ride_is_rough():
    ride = MOTION_SCENES["bicycle"].build(np.random.default_rng(3), 40.0)
    sound = contact_sound(ride, 40.0, np.random.default_rng(4))
    assert len(sound) == 40_000
    assert np.std(sound) == pytest.approx(0.1)
    time_s = np.arange(40_000) / 1000.0
    rough = np.linalg.norm(ride.at(time_s).acceleration_mps2, axis=1)
    seconds = [np.sqrt(np.square(v).reshape(-1, 1000).mean(1)) for v in (sound, rough)]
    assert np.corrcoef(*seconds)[0, 1] > 0.5
    again = contact_sound(ride, 40.0, np.random.default_rng(4))
    assert np.array_equal(sound, again)


@pytest.mark.parametrize("cover", ["wind", "speech"])
def test_a_cover_is_as_loud_as_was_asked_for(cover, rng):
    sound = 0.05 * rng.standard_normal(20_000)
    more = covered(sound, cover, 6.0, rng).samples - sound
    # 6 dB are a factor of 2.0
    assert np.std(more) / np.std(sound) == pytest.approx(1.995, rel=0.01)
