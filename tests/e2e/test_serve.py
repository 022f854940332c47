"""`serve`, as a user runs it."""

import json
import signal
import subprocess
from urllib.error import HTTPError
from urllib.request import urlopen

import numpy as np
import pytest

from hapticplayer.playback.source import open_source
from tests.e2e.command import (
    followed,
    hapticplayer,
    in_process,
    played,
    refused,
    started,
)


@pytest.fixture(scope="module")
def packed(demo, tmp_path_factory):
    target = tmp_path_factory.mktemp("packed") / "ride.mkv"
    assert hapticplayer("pack", demo, "-o", target).returncode == 0
    return target


def test_it_prints_the_url_and_ends_with_ctrl_c(packed):
    with started("serve", packed, "--json", stdout=subprocess.PIPE) as process:
        url = json.loads(process.stdout.readline())["url"]
        with urlopen(url, timeout=30) as response:
            title = json.load(response)["title"]
        with pytest.raises(HTTPError, match="403"):
            urlopen(url.replace(url.split("/")[3], "guessed"), timeout=30)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert (title, process.returncode) == ("Simulated ride: demo", 0)
    assert said == "note: stopped\n"


def test_a_folder_is_served_too_and_says_who_can_watch(demo):
    words = ("serve", demo, "--bind", "0.0.0.0")
    with started(*words, stdout=subprocess.PIPE) as process:
        lines = [process.stdout.readline() for _ in range(2)]
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 0
    assert lines[1].startswith("  hapticplayer play --allow-network http://")
    assert "can watch and feel the clip; nothing is encrypted" in said


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--bind", "203.0.113.7"], "203.0.113.7: cannot listen on port 0"),
        (["--bind", "no such host"], "no such host: cannot listen"),
        (["--accept-changed-video", "--bind", "1.2.3.4.5"], "cannot listen"),
    ],
)
def test_an_address_of_elsewhere_is_refused(packed, words, sentence):
    assert sentence in refused(hapticplayer("serve", packed, *words))


def test_a_port_out_of_range_is_wrong_usage(packed):
    done = hapticplayer("serve", packed, "--port", "65536")
    assert "--port must be a whole number between 0 and 65535" in refused(done, 2)


def test_a_video_without_force_is_refused(clip):
    assert "holds no force" in refused(hapticplayer("serve", clip))


@pytest.fixture(scope="module")
def url(packed):
    """The address of a server that runs meanwhile."""
    with started("serve", packed, "--json", stdout=subprocess.PIPE) as process:
        yield json.loads(process.stdout.readline())["url"]
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)


@pytest.mark.realtime
def test_what_is_felt_is_the_force_of_the_file(url, packed, tmp_path):
    words = (url, "--allow-network", "--mute", "--start", "3", "--duration", "3")
    lines = played(tmp_path / "log", *words)
    media_s, force_n = followed(lines)
    expected = open_source(packed).tracks["realistic"].at(media_s)
    # whole milliseconds of the file, between which the loop draws lines
    assert np.median(np.linalg.norm(force_n - expected, axis=1)) < 0.01
    assert lines[-1]["frames"]["shown"] > 0
    names = [line["name"] for line in lines if line["kind"] == "event"]
    assert "force_late" not in names[names.index("force_following") :]


@pytest.mark.parametrize("words", [(), ("--accept-changed-video",)])
def test_a_network_is_used_only_when_it_is_allowed(url, words):
    done = hapticplayer("play", "--headless", url, *words)
    assert "nothing is fetched from a network without --allow-network" in refused(
        done, 2
    )


@pytest.mark.parametrize(
    "address", ["http://127.0.0.1:9/ride.mp4", "https://127.0.0.1:9/tttttttt/"]
)
def test_only_the_address_of_a_stream_is_played(address):
    done = hapticplayer("play", "--headless", "--allow-network", address)
    assert "is not the address of a stream" in refused(done)


def test_other_force_than_that_of_the_stream_is_refused(url, tmp_path):
    words = ("--allow-network", "--force", tmp_path / "x.csv")
    done = hapticplayer("play", "--headless", url, *words)
    assert "--force needs a clip on this machine" in refused(done, 2)


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
def test_playing_a_file_never_opens_a_socket(way, url, packed, demo, tmp_path):
    (tmp_path / "sitecustomize.py").write_text(WATCH)
    env = {"PYTHONPATH": str(tmp_path), "WATCHED": str(tmp_path / "watched")}
    words = {"file": [packed], "folder": [demo], "address": [url, "--allow-network"]}
    words = [*words[way], "--headless", "--mute", "--duration", "0.3"]
    done = in_process("play", *words, env=env)
    assert done.returncode == 0, done.stderr
    # in all of its processes; that a stream is noticed shows that they are watched
    assert (tmp_path / "watched").exists() is (way == "address")
