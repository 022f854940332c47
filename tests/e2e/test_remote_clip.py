"""Playing a packed file from web servers, good and bad ones."""

import os
import shutil
import socket
import subprocess

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.extras.web import http_clip
from hapticplayer.extras.web.http_clip import HttpClip
from hapticplayer.haptics.contract import Mode
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import open_source
from hapticplayer.sequence.pack import pack
from tests.e2e.command import hapticplayer, in_process, refused
from tests.web_server import WebServer, wait_for

CLOCK = SystemClock()
PATIENCE_S = 60.0


@pytest.fixture(scope="module")
def packed(demo, tmp_path_factory):
    folder = tmp_path_factory.mktemp("packed")
    for name in ("ride.mkv", "ride.mp4"):
        pack(demo, folder / name)
    return folder


@pytest.fixture
def server(packed):
    contents = {f"/{file.name}": file.read_bytes() for file in packed.iterdir()}
    with WebServer(contents) as made:
        yield made


@pytest.fixture(scope="module")
def nginx(packed, tmp_path_factory):
    """The address of nginx, with the files in its root."""
    program = shutil.which("nginx") or shutil.which("/usr/sbin/nginx")
    if program is None:
        pytest.skip("nginx is not installed (Debian: nginx-light)")
    place = tmp_path_factory.mktemp("nginx")
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    folders = "".join(
        f"{kind}_temp_path {place};"
        for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    )
    (place / "conf").write_text(
        f"daemon off; pid {place}/pid; error_log {place}/errors; events {{}}\n"
        f"http {{ access_log {place}/log; {folders}\n"
        f"server {{ listen 127.0.0.1:{port}; root {packed}; }} }}\n"
    )
    packed.chmod(0o755)
    words = [program, "-c", str(place / "conf"), "-e", str(place / "errors")]
    with subprocess.Popen(
        [*words, "-g", "user root;" if _is_root() else ""]
    ) as process:
        wait_for(lambda: not _refuses(port))
        yield f"http://127.0.0.1:{port}"
        process.terminate()


def _is_root():
    return os.geteuid() == 0


def _refuses(port):
    with socket.socket() as asked:
        return asked.connect_ex(("127.0.0.1", port)) != 0


class Viewer:
    """A player of an address on a simulated device."""

    def __init__(self, url, start_s=0.0):
        self.player = Player(CLOCK, outputs=["simulated"], audio=None)
        self.player.wait_ready()
        self.player.open(open_source(HttpClip(url, CLOCK)))
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


def is_felt(now):
    return now.leading.mode is Mode.FOLLOWING and now.leading.tick["force_n"].any()


@pytest.mark.parametrize("name", ["ride.mkv", "ride.mp4"])
def test_nginx_gives_force_and_clip(nginx, packed, name):
    source, near = (
        open_source(HttpClip(f"{nginx}/{name}", CLOCK)),
        open_source(packed / name),
    )
    assert source.clip.duration_s == near.clip.duration_s
    assert list(source.tracks) == list(near.tracks)
    for one, other in zip(source.tracks.values(), near.tracks.values(), strict=True):
        assert np.array_equal(one.force_n, other.force_n)
    source.check.wait()
    assert source.check.allows_force
    source.clip.remote.close()


@pytest.mark.realtime
@pytest.mark.parametrize("name", ["ride.mkv", "ride.mp4"])
def test_seeks_on_nginx_are_felt_where_they_land(nginx, packed, name):
    track = open_source(packed / name).tracks["realistic"]
    with Viewer(f"{nginx}/{name}") as one:
        for at_s in (9.0, 3.0, 7.0, 5.0):
            one.player.seek(at_s)
            one.until(lambda now, at_s=at_s: is_felt(now) and now.media_s > at_s + 0.4)
            tick = one.now.leading.tick
            expected = track.at(float(tick["media_s"]))[0]
            assert np.abs(tick["planned_n"] - expected).max() < 0.05


@pytest.mark.realtime
def test_two_viewers_feel_different_places_at_once(nginx):
    url = f"{nginx}/ride.mkv"
    with Viewer(url) as one, Viewer(url, 5.0) as other:
        end_s = CLOCK.now_s() + PATIENCE_S
        while not (is_felt(one.now) and is_felt(other.now)):
            assert CLOCK.now_s() < end_s, "they did not feel anything at once"
            CLOCK.sleep_until(min(one.player.poll(), other.player.poll()))
        assert other.now.media_s > one.now.media_s + 2.0


FAULTS = {
    "stalls": {},
    "ends": {"most_bytes": 0},
    "lies": {"lies": {"Content-Range": "bytes 0-9/10"}},
    "changes": {"lies": {"ETag": '"another"'}},
    "refuses": {"statuses": [403] * 10_000},
}


@pytest.mark.realtime
@pytest.mark.parametrize("name", FAULTS)
def test_a_bad_server_pauses_clip_and_force_until_it_is_well(server, monkeypatch, name):
    monkeypatch.setattr(http_clip, "BLOCK_BYTES", 4 << 10)
    monkeypatch.setattr(http_clip, "AHEAD_BLOCKS", 4)
    with Viewer(server.url()) as one:
        one.until(is_felt)
        for key, value in FAULTS[name].items():
            setattr(server, key, value)
        if not FAULTS[name]:
            server.gate.clear()
        one.until(
            lambda now: (
                now.phase is Phase.BUFFERING
                and now.leading.mode is Mode.IDLE
                and now.problem
            )
        )
        assert "ride.mkv" in one.now.problem
        stood_s = one.now.media_s
        server.lies, server.statuses, server.most_bytes = {}, [], None
        server.gate.set()
        one.until(lambda now: is_felt(now) and now.media_s > stood_s)
        assert not one.now.problem


@pytest.mark.realtime
def test_force_is_withheld_from_another_video(server, packed):
    other = server.contents["/ride.mp4"]
    at = other.index(b"mdat") + 2000
    server.contents["/ride.mp4"] = other[:at] + b"1234" + other[at + 4 :]
    said = "not the video that the force was made for"
    with Viewer(server.url("/ride.mp4")) as one:
        one.until(lambda now: now.phase is Phase.PLAYING and now.media_s > 0.5)
        # a second notice, of a frame that the bytes broke, may come before it
        one.until(lambda now: any(said in notice for notice in now.notices))
        assert not one.now.leading.tick["force_n"].any()


@pytest.mark.parametrize("words", [(), ("--accept-changed-video",)])
def test_a_network_is_used_only_when_it_is_allowed(server, words):
    done = hapticplayer("play", "--headless", server.url(), *words)
    assert "nothing is fetched from a network without --allow-network" in refused(
        done, 2
    )


def test_a_server_that_is_not_there_is_one_sentence():
    address = "http://127.0.0.1:9/s3cret/ride.mkv?key=s3cret"
    done = hapticplayer("play", "--headless", "--allow-network", address)
    said = refused(done)
    assert "http://127.0.0.1:9: ride.mkv: cannot be reached" in said
    assert "s3cret" not in said


WATCH = """
import os, sys
def watch(name, arguments):
    is_used = name in ("socket.connect", "socket.bind", "socket.getaddrinfo",
                       "socket.gethostbyname", "socket.sendto", "urllib.Request")
    if is_used or (name == "socket.__new__" and arguments[1] in (2, 10)):
        with open(os.environ["WATCHED"], "a") as log:
            log.write(f"{name} {arguments}\\n")
sys.addaudithook(watch)
"""


@pytest.mark.parametrize("way", ["file", "folder", "address"])
def test_playing_a_file_never_opens_a_socket(way, server, packed, demo, tmp_path):
    (tmp_path / "sitecustomize.py").write_text(WATCH)
    env = {"PYTHONPATH": str(tmp_path), "WATCHED": str(tmp_path / "watched")}
    words = {
        "file": [packed / "ride.mkv"],
        "folder": [demo],
        "address": [server.url(), "--allow-network"],
    }
    words = [*words[way], "--headless", "--mute", "--duration", "0.3"]
    done = in_process("play", *words, env=env)
    assert done.returncode == 0, done.stderr
    # in all of its processes; that an address is noticed shows that they are watched
    assert (tmp_path / "watched").exists() is (way == "address")
