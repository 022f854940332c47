"""A short clip and a player on a virtual clock, with everything but the decoders."""

import numpy as np
import pytest

from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import ForceTrack
from hapticplayer.playback.feeders import QUEUE_FRAMES
from hapticplayer.playback.player import Player
from hapticplayer.playback.sound_ring import AudioRing
from hapticplayer.playback.source import Source
from tests.conftest import clip_of
from tests.material.sound_output import SilentOutput

RATE_HZ = 25
SECONDS = 3.0


def pictures(count):
    """Grey pictures whose brightness tells their number."""
    for number in range(count):
        yield np.full((72, 128, 3), 20 + 2 * number, dtype=np.uint8)


@pytest.fixture(scope="session")
def clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "short.mp4"
    t = np.arange(int(SECONDS * 48_000)) / 48_000
    tone = (0.2 * np.sin(2 * np.pi * 440 * t)).astype(np.float32)
    write_clip(
        path,
        pictures(int(SECONDS * RATE_HZ)),
        frame_rate_hz=RATE_HZ,
        audio=np.stack([tone, tone], axis=1),
    )
    return probe(path)


@pytest.fixture(scope="session")
def silent_clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "silent.mp4"
    write_clip(path, pictures(int(SECONDS * RATE_HZ)), frame_rate_hz=RATE_HZ)
    return probe(path)


def source_of(info):
    track = ForceTrack([0.0, SECONDS], [[0, 1.0, 0], [0, 1.0, 0]])
    other = ForceTrack([0.0, SECONDS], [[0, -1.0, 0], [0, -1.0, 0]])
    tracks = {"realistic": track, "other": other}
    return Source("short", info.path, info, tracks, None, "realistic")


def wait_for(is_so):
    """Wait for what another thread does."""
    clock = SystemClock()
    end_s = clock.now_s() + 30.0
    while not is_so():
        assert clock.now_s() < end_s, "it did not happen"
        clock.sleep_until(clock.now_s() + 0.0005)


class RecordingSink:
    """Notes when each picture was shown."""

    def __init__(self, clock):
        self.clock = clock
        self.shown = []

    def show(self, picture):
        self.shown.append((self.clock.now_s(), picture.pts_s))


class Processes(HapticsProcesses):
    """Without a device; notes what the loop would be given."""

    def __init__(self, clock, device, **options):
        super().__init__(clock, device, **options)
        self.clock, self.published = clock, []

    def publish(self, clock, track):
        self.published.append((self.clock.now_s(), clock, track))


class Theatre:
    """A player whose time only moves when the decoders have done their work.

    `published` has (monotonic s, clock, track) of every poll.
    """

    STEP_S = 0.004

    def __init__(self, info, *, with_sound=True, with_screen=True):
        self.clock = ManualClock()
        self.sink = RecordingSink(self.clock) if with_screen else None
        self.out = None
        self.published = []
        self.player = Player(
            self.clock,
            self.sink,
            audio=self.make_audio if with_sound else None,
            haptics=self._make_haptics,
        )
        self.player.open(source_of(info))

    def _make_haptics(self, clock, device, **options):
        made = Processes(clock, device, **options)
        self.published = made.published
        return made

    def make_audio(self, ring: AudioRing):
        self.out = SilentOutput(ring, self.clock)
        return self.out

    def settle(self):
        """Wait until the decoders have nothing left to do."""
        self.settle_video()
        sound = clip_of(self.player).sound
        if sound.feeder is not None:
            wait_for(lambda: sound.feeder.is_at_end or sound.ring.buffered_s() > 0.5)

    def settle_video(self):
        """Wait until the queue of frames is full, or holds the last one."""
        feeder = clip_of(self.player).video.feeder
        wait_for(lambda: feeder.is_at_end or feeder.peek(QUEUE_FRAMES - 1))

    def run(self, seconds):
        """Let virtual time pass; the DAC takes its samples."""
        for _ in range(round(seconds / self.STEP_S)):
            self.settle()
            self.player.poll()
            if self.out is not None:
                self.out.advance(round(self.STEP_S * 48_000))
            self.clock.advance(self.STEP_S)
        self.player.poll()


@pytest.fixture
def theatre(clip):
    made = Theatre(clip)
    yield made
    made.player.close()


@pytest.fixture
def silent_theatre(silent_clip):
    made = Theatre(silent_clip)
    yield made
    made.player.close()
