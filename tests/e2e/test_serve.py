"""`serve`, as a user runs it."""

import json
import signal
import subprocess
from urllib.error import HTTPError
from urllib.request import urlopen

import pytest

from tests.e2e.command import hapticplayer, refused, started


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
    assert lines[1].startswith("  http://")
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
