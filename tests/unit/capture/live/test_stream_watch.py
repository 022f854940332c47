import numpy as np
import pytest

from hapticplayer.capture.live.stream_watch import StreamWatch
from hapticplayer.capture.recorded import Gap

EVEN_S = np.arange(300) / 30.0


def watched(at_s):
    watch = StreamWatch("camera", 1.0)
    for one_s in at_s:
        watch.take(np.array([one_s]), one_s + 0.01)
    return watch


def test_an_even_stream_drops_nothing(rng):
    watch = watched(EVEN_S + rng.uniform(-0.004, 0.004, len(EVEN_S)))
    assert (watch.count, watch.dropped, watch.gaps) == (300, 0, [])
    assert watch.rate_hz == pytest.approx(30.0, rel=0.1)


def test_missing_frames_are_counted_and_long_gaps_marked():
    kept = np.delete(EVEN_S, [40, 41, *range(100, 130)])
    watch = watched(kept)
    assert watch.dropped == 32
    assert watch.gaps == [Gap("camera", 3.3, pytest.approx(130 / 30), 30)]


def test_a_camera_that_slows_down_in_dim_light_is_believed_soon():
    watch = watched(np.concatenate([EVEN_S[:100], 3.3 + np.arange(1, 200) / 15.0]))
    assert watch.dropped <= 12
    assert watch.rate_hz == pytest.approx(15.0)


def test_silence_is_told_once_and_marked_up_to_the_end():
    watch = watched(EVEN_S[:60])
    assert not watch.stalls(2.5)
    assert watch.stalls(3.2)
    assert not watch.stalls(3.3)
    watch.end(5.0)
    assert watch.gaps == [Gap("camera", pytest.approx(59 / 30, abs=1e-6), 5.0, 91)]
