"""The ring between decoder and DAC: exact positions, silence, late samples."""

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.playback.sound_memory import CHANNELS, SoundBlock, SoundReader
from hapticplayer.playback.sound_ring import AHEAD_S, PAUSED_AHEAD_S, AudioRing
from tests.material.sound_output import SilentOutput

RATE = 1000  # one sample is one millisecond: easy to read


def ramp(start, count):
    return np.repeat(
        np.arange(start, start + count, dtype=np.float32)[:, None], 2, axis=1
    )


class Played(AudioRing):
    """A ring with the other side of its memory."""

    def __init__(self, rate_hz):
        super().__init__(rate_hz)
        self.reader = SoundReader(SoundBlock(self.descriptor))


def render(ring, count, dac_s=0.0, silence_s=0.0):
    out = np.full((count, CHANNELS), np.nan, dtype=np.float32)
    ring.reader.render(memoryview(out).cast("B"), dac_s, silence_s)
    return out[:, 0]


@pytest.fixture
def ring():
    made = Played(RATE)
    made.load(1, 5.0)
    yield made
    made.close()


def test_silence_until_it_plays(ring):
    ring.write(1, 5.0, ramp(5000, 100))
    assert not render(ring, 10).any()
    assert ring.reports() == []


def test_samples_come_out_at_their_media_time(ring):
    ring.write(1, 5.0, ramp(5000, 100))
    ring.play()
    assert render(ring, 30, dac_s=77.0).tolist() == list(range(5000, 5030))
    assert render(ring, 30, dac_s=77.03)[0] == 5030
    reports = ring.reports()
    assert [(r.epoch, r.monotonic_s, r.media_s) for r in reports] == [
        (1, 77.0, 5.0),
        (1, 77.03, 5.03),
    ]


def test_missing_samples_are_silent_and_the_time_goes_on(ring):
    ring.write(1, 5.0, ramp(5000, 10))
    ring.play()
    out = render(ring, 30)
    assert out[:10].tolist() == list(range(5000, 5010))
    assert not out[10:].any()
    assert ring.underrun_samples == 20
    # 40 more arrive; those for the 20 ms that have passed are late
    assert ring.write(1, 5.01, ramp(5010, 40)) == 40
    assert render(ring, 20).tolist() == list(range(5030, 5050))


def test_silence_of_the_output_itself_leaves_as_much_sound_out(ring):
    """Else the sound would be late from then on, and picture and force with it."""
    ring.write(1, 5.0, ramp(5000, 200))
    ring.play()
    render(ring, 30, dac_s=77.0)
    assert render(ring, 30, dac_s=77.05, silence_s=0.02)[0] == 5050
    assert ring.underrun_samples == 20
    early, late = ring.reports()
    assert late.media_s - early.media_s == pytest.approx(0.05)
    ring.hold()
    render(ring, 30, dac_s=78.0, silence_s=0.02)
    ring.play()
    assert render(ring, 30, dac_s=79.0)[0] == 5080


def test_a_gap_in_the_sound_is_silence_at_the_right_place(ring):
    ring.write(1, 5.0, ramp(5000, 10))
    ring.write(1, 5.02, ramp(5020, 10))
    ring.play()
    out = render(ring, 30)
    assert not out[10:20].any()
    assert out[20:].tolist() == list(range(5020, 5030))
    assert ring.underrun_samples == 0


def test_a_full_ring_takes_what_fits(ring):
    """Less of it while nothing plays: most seeks go on to the next."""
    taken = ring.write(1, 5.0, ramp(5000, 9000))
    assert taken == PAUSED_AHEAD_S * RATE
    ring.play()
    taken += ring.write(1, 5.0 + taken / RATE, ramp(5000 + taken, 9000))
    assert taken == AHEAD_S * RATE
    render(ring, 100)
    assert ring.write(1, 5.0 + taken / RATE, ramp(5000 + taken, 500)) == 100


def test_a_stale_generation_is_swallowed(ring):
    ring.load(2, 9.0)
    assert ring.write(1, 5.0, ramp(5000, 10)) == 10
    ring.play()
    assert not render(ring, 10).any()


def test_after_a_pause_the_sound_goes_on_where_it_was_heard(ring):
    ring.write(1, 5.0, ramp(5000, 1000))
    ring.play()
    render(ring, 400)
    assert ring.resume_from(2, 5.3)  # 100 ms were on their way and not heard
    assert not render(ring, 10).any()
    ring.play()
    assert render(ring, 3).tolist() == [5300, 5301, 5302]
    assert ring.reports()[-1].epoch == 2
    assert ring.write(1, 6.0, ramp(6000, 10)) == 10  # same generation: still welcome
    assert ring.buffered_s() == pytest.approx(1.010 - 0.303)


def test_a_position_that_is_gone_cannot_be_resumed(ring):
    ring.write(1, 5.0, ramp(5000, 10))
    assert not ring.resume_from(2, 4.0)
    assert not ring.resume_from(2, 6.0)


def test_the_end_of_the_sound_is_no_underrun(ring):
    ring.write(1, 5.0, ramp(5000, 10))
    ring.finish(1)
    ring.play()
    render(ring, 100)
    assert ring.underrun_samples == 0
    assert ring.reports()[-1].media_s == 5.0


def test_long_runs_wrap_around_without_a_seam(ring):
    ring.play()
    written, heard = 5000, []
    for _ in range(200):
        written += ring.write(1, written / RATE, ramp(written, 64))
        heard.extend(render(ring, 50).tolist())
    assert heard == list(range(5000, 15000))


def test_a_silent_output_reports_its_latency(ring):
    clock = ManualClock(10.0)
    out = SilentOutput(ring, clock, latency_s=0.1)
    ring.play()
    out.advance(10)
    assert ring.reports()[0].monotonic_s == pytest.approx(10.1)
