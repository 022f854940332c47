"""The beats: flash, beep and push of one moment, decoded from the very file."""

from itertools import pairwise

import numpy as np
import pytest

from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.video import VideoDecoder
from hapticplayer.playback.beats import (
    FIRST_S,
    LENGTH_S,
    PULSE_N,
    beat_source,
    beat_times_s,
)


def test_flash_beep_and_push_begin_together(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    source = beat_source()
    beats_s = beat_times_s()[:3]
    with VideoDecoder(source.clip.path) as video:
        shown = []
        while (frame := video.next_frame()) is not None and frame.pts_s < 3.2:
            picture = FrameConverter().convert(frame, 64, 36)
            shown.append((frame.pts_s, picture.as_rgb().mean() > 128))
    flashes_s = [t for (_, before), (t, lit) in pairwise(shown) if lit > before]
    assert flashes_s == pytest.approx(beats_s.tolist(), abs=1e-3)
    with AudioDecoder(source.clip.path) as audio:
        blocks = [audio.next_block() for _ in range(150)]
    sound = np.concatenate([b.samples for b in blocks])[:, 0]
    time_s = blocks[0].media_s + np.arange(len(sound)) / 48_000
    for beat_s in beats_s:
        near = np.abs(time_s - beat_s) < 0.05
        onset_s = time_s[near][np.argmax(np.abs(sound[near]) > 0.1)]
        assert onset_s == pytest.approx(beat_s, abs=0.003)
        quiet = (time_s > beat_s + LENGTH_S + 0.05) & (time_s < beat_s + 0.9)
        assert np.abs(sound[quiet]).max() < 0.01
    track = source.tracks["realistic"]
    push_n = np.interp(beats_s + 0.001, track.time_s, track.force_n[:, 1])
    assert push_n == pytest.approx(PULSE_N)
    assert beat_source().clip.path == source.clip.path  # made once
    assert beats_s[0] == FIRST_S
