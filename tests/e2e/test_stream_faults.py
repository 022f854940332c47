"""Playing a stream over a bad network: the force fades, it never steps and never trips."""

import threading

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.streamed_track import FADE_S
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.pack import pack
from hapticplayer.simulation.network import BadNetwork, NetworkFaults
from hapticplayer.streaming import force_fetch, remote_clip
from hapticplayer.streaming.offer import Offer
from hapticplayer.streaming.opening import open_stream
from hapticplayer.streaming.server import StreamServer

pytestmark = pytest.mark.realtime
CLOCK = SystemClock()
PATIENCE_S = 60.0


@pytest.fixture(scope="module")
def packed(demo, tmp_path_factory):
    target = tmp_path_factory.mktemp("packed") / "ride.mkv"
    pack(demo, target)
    return target


@pytest.fixture(scope="module")
def url(packed):
    with StreamServer(Offer(open_source(packed)), CLOCK) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.02,))
        thread.start()
        yield server.url
        server.shutdown()
        thread.join()


class Viewer:
    """A player of a stream on a simulated device."""

    def __init__(self, url, start_s=0.0):
        self.player = Player(CLOCK, device="simulated", audio=None)
        self.player.wait_ready()
        self.player.open(open_stream(url, CLOCK))
        self.player.seek(start_s)
        self.player.play()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.player.close()

    @property
    def now(self):
        return self.player.snapshot()

    def until(self, condition):
        """Play until something holds."""
        end_s = CLOCK.now_s() + PATIENCE_S
        while not condition(self.now):
            assert CLOCK.now_s() < end_s, "it did not happen"
            CLOCK.sleep_until(self.player.poll())

    def until_at(self, media_s):
        """Play to a position and return the ticks of the force on the way there."""
        self.until(lambda now: now.media_s >= media_s)
        ticks = self.player.ticks_since(0.0)
        return ticks[np.isin(ticks["mode"], (Mode.ENTERING, Mode.FOLLOWING))]


def is_felt(now):
    return now.mode is Mode.FOLLOWING and now.tick["force_n"].any()


FAULTS = {
    "lost": NetworkFaults(lost=0.05),
    "late": NetworkFaults(delay_s=0.5),
    "reordered": NetworkFaults(is_reordered=True),
    "damaged": NetworkFaults(damaged=0.05),
    "gone": NetworkFaults(gone=0.05),
    "all": NetworkFaults(0.05, 0.05, 0.5, is_reordered=True, damaged=0.05),
}


@pytest.mark.parametrize("name", FAULTS)
def test_the_force_fades_but_never_steps_or_trips(name, url, packed):
    with (
        BadNetwork(url, FAULTS[name], CLOCK) as network,
        Viewer(network.url, 2.0) as viewer,
    ):
        ticks = viewer.until_at(5.0)
        assert viewer.now.mode is not Mode.TRIPPED
    track = open_source(packed).tracks["realistic"]
    planned, whole = ticks["planned_n"], track.at(ticks["media_s"])
    size, error = np.linalg.norm(whole, axis=1), np.linalg.norm(planned - whole, axis=1)
    # a share of the force, but for the ends of lines within a millisecond
    assert np.all(error <= size + 0.05)
    gap_s = np.diff(ticks["monotonic_s"])
    is_near = (gap_s < 0.0015) & (ticks["mode"][1:] == ticks["mode"][:-1])
    change = np.linalg.norm(np.diff(planned, axis=0), axis=1)
    own = np.linalg.norm(np.diff(whole, axis=0), axis=1)
    assert np.all((change <= own + 1.5e-3 / FADE_S * size[1:] + 0.05)[is_near])
    assert np.any(planned)


def test_a_clip_that_stalls_stops_the_force_and_goes_on(url, monkeypatch):
    monkeypatch.setattr(remote_clip, "BLOCK_BYTES", 8 << 10)
    monkeypatch.setattr(remote_clip, "MOST_BLOCKS", 2)
    monkeypatch.setattr(remote_clip, "AHEAD_BLOCKS", 2)
    with BadNetwork(url, NetworkFaults(), CLOCK) as network, Viewer(network.url) as one:
        one.until(is_felt)
        network.holds = "clip"
        one.until(lambda now: now.phase is Phase.BUFFERING and now.mode is Mode.IDLE)
        stood_s = one.now.media_s
        network.holds = ""
        one.until(lambda now: is_felt(now) and now.media_s > stood_s)
        assert not one.now.problem


def test_force_that_stalls_fades_while_the_clip_goes_on(url, monkeypatch):
    monkeypatch.setattr(force_fetch, "AHEAD_PACKETS", 8)
    with BadNetwork(url, NetworkFaults(), CLOCK) as network, Viewer(network.url) as one:
        one.until(is_felt)
        network.holds = "force"
        one.player.seek(8.0)
        one.until(lambda now: now.media_s > 8.5 and now.phase is Phase.PLAYING)
        assert not one.now.tick["planned_n"].any()
        network.holds = ""
        one.until(is_felt)


def test_seeks_are_felt_where_they_land(url, packed):
    track = open_source(packed).tracks["realistic"]
    with Viewer(url) as one:
        for at_s in (9.0, 3.0, 7.0, 5.0):
            one.player.seek(at_s)
            one.until(lambda now, at_s=at_s: is_felt(now) and now.media_s > at_s + 0.4)
            tick = one.now.tick
            expected = track.at(float(tick["media_s"]))[0]
            assert np.abs(tick["planned_n"] - expected).max() < 0.05


def test_two_viewers_feel_different_places_at_once(url):
    with Viewer(url) as one, Viewer(url, 5.0) as other:
        for viewer in (one, other):
            viewer.until(is_felt)
        shown = [viewer.now.frames_shown for viewer in (one, other)]
        end_s = CLOCK.now_s() + PATIENCE_S
        while CLOCK.now_s() < end_s:
            CLOCK.sleep_until(min(one.player.poll(), other.player.poll()))
            if is_felt(one.now) and is_felt(other.now):
                break
        else:
            raise AssertionError("they did not feel anything at once")
        assert other.now.media_s > one.now.media_s + 2.0
        assert all(shown)
