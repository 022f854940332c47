"""The loop's upsampling equals the plain one, and the border refuses nonsense."""

import math
import os

import numpy as np
import pytest

from hapticplayer.haptics.track import map_track, to_shared_memory
from hapticplayer.linux import anonymous_memory
from hapticplayer.model import ForceTrack, Reconstruction


@pytest.mark.parametrize("how", list(Reconstruction))
def test_the_loop_upsamples_like_the_plain_version(how, rng):
    force = rng.standard_normal((300, 3)) * (rng.random((300, 1)) < 0.6)
    track = ForceTrack(np.cumsum(rng.random(300) / 50), force, how)
    descriptor = to_shared_memory(track)
    loaded = map_track(descriptor)
    os.close(descriptor)
    query = np.linspace(-0.5, track.time_s[-1] + 0.5, 20_000)
    found = np.array([loaded.force_at(t) for t in query.tolist()])
    # float32 entries, double arithmetic in another order
    assert np.abs(found - track.at(query)).max() < 1e-6


def test_at_the_entries_themselves_the_value_is_exact(rng):
    track = ForceTrack(np.arange(50) / 10.0, rng.standard_normal((50, 3)))
    descriptor = to_shared_memory(track)
    loaded = map_track(descriptor)
    os.close(descriptor)
    for time_s, force in zip(track.time_s[:-1], track.force_n, strict=False):
        assert loaded.force_at(float(time_s)) == tuple(map(float, force))


@pytest.mark.parametrize("rows", [1, 2, 3, 4, 200])
@pytest.mark.parametrize("how", list(Reconstruction))
def test_a_force_is_the_same_in_any_order_of_times(rows, how, rng):
    times = np.cumsum(rng.random(rows) / 50)
    descriptor = to_shared_memory(
        ForceTrack(times, rng.standard_normal((rows, 3)), how)
    )
    used, end_s = map_track(descriptor), float(times[-1])
    forward = np.arange(-0.01, end_s + 0.05, 0.001)
    leaps = rng.uniform(-0.1, end_s + 0.1, 300)
    query = [*forward, *leaps, *forward[::-1], *np.repeat(times, 2), *times[::-1]]
    for media_s in map(float, query):
        fresh = map_track(descriptor)
        assert used.force_at(media_s) == fresh.force_at(media_s)
    for special in (math.nan, math.inf, -math.inf, 0.0, math.nan):
        assert repr(used.force_at(special)) == repr(
            map_track(descriptor).force_at(special)
        )
    os.close(descriptor)


@pytest.mark.parametrize("size", [1, 23, 24, 100])
def test_a_block_that_is_no_track_is_refused(size):
    descriptor = anonymous_memory("test", size)
    try:
        with pytest.raises(ValueError, match="does not match"):
            map_track(descriptor)
    finally:
        os.close(descriptor)


@pytest.mark.parametrize(
    "numbers", [[math.nan], [math.inf], [-math.inf], [math.inf, -math.inf]]
)
def test_a_number_that_is_not_finite_is_refused_at_load(numbers):
    descriptor = to_shared_memory(ForceTrack([0.0, 1.0], np.ones((2, 3))))
    try:
        bad = np.array(numbers, np.float32).tobytes()
        os.pwrite(descriptor, bad, os.fstat(descriptor).st_size - len(bad))
        track = map_track(descriptor)
        assert not track.check(2)  # the times
        with pytest.raises(ValueError, match="NaN or infinity"):
            track.check(6)
    finally:
        os.close(descriptor)
