"""Speed, loop, single pictures and volume, on virtual time with real decoders."""

import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.media.audio import AudioBlock
from hapticplayer.media.tempo import TempoFilter
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.sound_ring import AudioRing
from tests.conftest import clip_of
from tests.material.sound_output import SilentOutput

FRAME_S, RATE_HZ = 1 / 25, 48_000


def at_speed(speed, mono):
    """The whole sound at another speed, and the media time of each sample of it."""
    tempo, sound = TempoFilter(speed, RATE_HZ), np.stack([mono, mono], axis=1)
    blocks = []
    for first in range(0, len(sound), 1024):
        piece = sound[first : first + 1024].astype(np.float32)
        blocks += tempo.push(AudioBlock(first / RATE_HZ, piece))
    blocks += tempo.push(None)
    assert tempo.is_over
    samples = np.concatenate([block.samples for block in blocks])
    times = [
        block.media_s + np.arange(len(block.samples)) * speed / RATE_HZ
        for block in blocks
    ]
    return samples[:, 0], np.concatenate(times)


@pytest.mark.parametrize("speed", [0.5, 0.8, 1.25, 2.0, 4.0])
def test_a_tone_keeps_its_pitch_and_lasts_1_by_speed(speed):
    tone = np.sin(2 * np.pi * 440 * np.arange(4 * RATE_HZ) / RATE_HZ)
    samples, _ = at_speed(speed, tone)
    assert len(samples) / RATE_HZ == pytest.approx(4.0 / speed, abs=0.06)
    middle = samples[len(samples) // 4 : 3 * len(samples) // 4]
    spectrum = np.abs(np.fft.rfft(middle * np.hanning(len(middle))))
    peak_hz = np.argmax(spectrum) * RATE_HZ / len(middle)
    assert peak_hz == pytest.approx(440.0, abs=2.0)


@pytest.mark.parametrize("speed", [0.5, 0.75, 1.25, 2.0, 4.0])
def test_the_mean_delay_of_the_filter_is_in_the_times(speed):
    rng = np.random.default_rng(1)
    sound, bursts_s = np.zeros(20 * RATE_HZ), np.arange(0.6, 19.0, 0.613)
    for at_s in bursts_s:
        first = round(at_s * RATE_HZ)
        sound[first : first + 1440] = 0.3 * rng.standard_normal(1440)
    samples, media_s = at_speed(speed, sound)
    loud = np.flatnonzero(np.abs(samples) > 0.12)
    begins = loud[np.diff(media_s[loud], prepend=-1.0) > 0.4]
    assert len(begins) == len(bursts_s)
    late_s = (media_s[begins] - bursts_s) / speed  # in the time of the person
    assert np.median(late_s) == pytest.approx(0.0, abs=0.006)
    assert np.abs(late_s).max() < 0.04


def test_after_a_gap_the_times_are_those_of_the_sound():
    tempo, piece = TempoFilter(2.0, RATE_HZ), np.ones((4800, 2), np.float32)
    times_s = [*np.arange(10) / 10, *(5.0 + np.arange(10) / 10), None]
    made_s = [
        block.media_s
        for at_s in times_s
        for block in tempo.push(None if at_s is None else AudioBlock(at_s, piece))
    ]
    before_s = [s for s in made_s if s < 2.0]
    after_s = made_s[len(before_s) :]
    assert (before_s[0], before_s[-1]) == pytest.approx((0.02, 1.0), abs=0.05)
    assert (after_s[0], after_s[-1]) == pytest.approx((5.02, 6.0), abs=0.05)
    assert np.diff(after_s) == pytest.approx(0.1)


@pytest.mark.parametrize("speed", [0.5, 1.25, 2.0])
def test_at_another_speed_pictures_and_sound_agree(theatre, speed):
    theatre.player.set_speed(speed)
    theatre.player.play()
    theatre.run(1.2)
    shown = np.array(theatre.sink.shown)
    shown = shown[shown[:, 1] > 0.05]
    slope, _ = np.polyfit(shown[:, 0], shown[:, 1], 1)
    assert slope == pytest.approx(speed, rel=0.02)
    assert theatre.player.snapshot().clock == "audio"
    assert clip_of(theatre.player).media.error_s == pytest.approx(0.0, abs=0.002)
    assert theatre.player.snapshot().frames_dropped == 0
    assert clip_of(theatre.player).sound.ring.underrun_samples == 0


def test_a_change_of_speed_while_it_plays_stays_where_it_is(theatre):
    theatre.player.play()
    theatre.run(0.8)
    before_s = theatre.player.snapshot().media_s
    epoch = theatre.player.snapshot().epoch
    theatre.player.set_speed(2.0)
    assert theatre.player.snapshot().media_s == pytest.approx(before_s, abs=1e-9)
    assert theatre.player.snapshot().epoch > epoch  # the force fades out and in
    assert theatre.player.snapshot().is_playing


@pytest.mark.parametrize(("asked", "got"), [(0.01, 0.5), (1.5, 1.5), (99.0, 4.0)])
def test_the_speed_has_limits(theatre, asked, got):
    theatre.player.set_speed(asked)
    assert theatre.player.snapshot().speed == got


def test_single_steps_go_one_picture_forth_and_back(theatre):
    theatre.run(0.05)
    seen = []
    for direction in (1, 1, 1, -1, -1):
        theatre.player.step(direction)
        theatre.run(0.02)
        seen.append(round(theatre.sink.shown[-1][1] / FRAME_S))
    assert seen == [1, 2, 3, 2, 1]
    assert theatre.player.snapshot().phase is Phase.PAUSED


def test_a_step_pauses_what_plays(theatre):
    theatre.player.play()
    theatre.run(0.6)
    last_s = theatre.sink.shown[-1][1]
    theatre.player.step(1)
    assert theatre.player.snapshot().phase is Phase.PAUSED
    assert theatre.sink.shown[-1][1] == pytest.approx(last_s + FRAME_S, abs=1e-6)
    assert theatre.player.snapshot().media_s == theatre.sink.shown[-1][1]


def test_a_loop_returns_to_its_beginning(theatre):
    theatre.player.set_loop((1.0, 1.4))
    theatre.player.seek(1.0)
    theatre.player.play()
    theatre.run(2.0)
    media_s = np.array([pts for _, pts in theatre.sink.shown[1:]])
    assert media_s.max() < 1.4 + FRAME_S
    assert (np.diff(media_s) < -0.3).sum() >= 2
    assert theatre.player.snapshot().is_playing


def test_another_output_takes_over_where_the_sound_is(theatre):
    theatre.player.play()
    theatre.run(1.0)
    first, before_s = theatre.out, theatre.player.snapshot().media_s
    theatre.player.set_sound_output(theatre.make_audio)
    assert theatre.out is not first
    assert theatre.player.snapshot().media_s == pytest.approx(before_s, abs=1e-9)
    theatre.run(0.5)
    assert theatre.player.snapshot().phase is Phase.PLAYING
    assert theatre.player.snapshot().clock == "audio"


def test_the_volume_goes_with_the_cube_and_without_a_step():
    ring = AudioRing()
    out = SilentOutput(ring, ManualClock())
    ring.load(1, 0.0)
    ring.write(1, 0.0, np.ones((3000, 2), np.float32))
    ring.play()
    assert (np.asarray(out.advance(1000)) == 1.0).all()
    ring.gain = 0.5**3
    faded = np.asarray(out.advance(1000))[:, 0]
    assert np.abs(np.diff(faded)).max() < 0.001
    assert np.asarray(out.advance(1000))[:, 0] == pytest.approx(0.125)
