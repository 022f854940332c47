"""4K is played in the window's size, and what cannot be shown in time is counted."""

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import FrameConverter
from hapticplayer.playback import headless
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source

WIDTH, HEIGHT, RATE_HZ, COUNT = 3840, 2160, 30, 20
SHOWN = (1280, 720)


class SizesSink:
    def __init__(self):
        self.seen, self.converter = [], FrameConverter()

    def show(self, frame):
        image = self.converter.convert(frame, *SHOWN)
        grey = image.as_rgb()[::90, ::90].mean()
        self.seen.append((image.width, image.height, float(grey)))


@pytest.fixture(scope="module")
def large(tmp_path_factory):
    path = tmp_path_factory.mktemp("large") / "large.mp4"
    levels = (40 + 8 * number for number in range(COUNT))
    pictures = (np.full((HEIGHT, WIDTH, 3), level, np.uint8) for level in levels)
    write_clip(path, pictures, frame_rate_hz=RATE_HZ, is_quick=True)
    return path


def test_every_frame_of_a_4k_clip_is_shown_or_counted_as_dropped(large):
    assert (probe(large).width, probe(large).height) == (WIDTH, HEIGHT)
    clock, sink = SystemClock(), SizesSink()
    player = Player(clock, sink, audio=None)
    try:
        player.open(open_source(large))
        headless.run(player, clock, start_s=0.0, until_s=10.0)
        snapshot = player.snapshot()
    finally:
        player.close()
    # the first one is shown once more, before the clip plays
    assert snapshot.frames_shown + snapshot.frames_dropped in (COUNT, COUNT + 1)
    assert snapshot.problem == ""
    assert {seen[:2] for seen in sink.seen[1:]} == {SHOWN}
    greys = [grey for _, _, grey in sink.seen]
    assert greys == sorted(greys)  # in order, and the right ones
    assert greys[0] == pytest.approx(40.0, abs=2.5)
