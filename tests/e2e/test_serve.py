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
    played,
    refused,
    started,
)
from tests.needed_extras import needs

pytestmark = needs("web")


@pytest.fixture(scope="module")
def packed(demo, tmp_path_factory):
    target = tmp_path_factory.mktemp("packed") / "ride.mkv"
    assert hapticplayer("pack", demo, "-o", target).returncode == 0
    return target


def test_the_url_is_printed_and_ctrl_c_ends_it(packed):
    with started("serve", packed, "--json", stdout=subprocess.PIPE) as process:
        said = json.loads(process.stdout.readline())
        url = said["url"]
        with urlopen(url, timeout=30) as response:
            assert response.read() == packed.read_bytes()
        with pytest.raises(HTTPError, match="403"):
            urlopen(url.replace(url.split("/")[3], "guessed"), timeout=30)
        process.send_signal(signal.SIGINT)
        _, notes = process.communicate(timeout=60)
    assert (said["title"], process.returncode) == ("Simulated ride: demo", 0)
    assert notes == "note: stopped\n"


def test_a_sequence_is_packed_and_says_who_can_watch(demo):
    words = ("serve", demo, "--bind", "0.0.0.0")
    with started(*words, stdout=subprocess.PIPE) as process:
        lines = [process.stdout.readline() for _ in range(2)]
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 0
    assert lines[1].startswith("  hapticplayer play --allow-network http://")
    assert "can watch and feel the clip; nothing is encrypted" in said


@pytest.mark.parametrize("address", ["", "0", "1.2.3", "no such host", "1.2.3.4.5"])
def test_an_address_that_is_not_whole_is_wrong_usage(packed, address):
    done = hapticplayer("serve", packed, "--bind", address)
    assert "(--bind) is not an address of this machine; give one in full" in refused(
        done, 2
    )


def test_an_address_of_elsewhere_is_refused(packed):
    done = hapticplayer("serve", packed, "--bind", "203.0.113.7")
    assert "203.0.113.7: cannot listen on port 0" in refused(done)


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
def test_the_hand_gets_the_force_of_the_file(url, packed, tmp_path):
    words = (url, "--allow-network", "--mute", "--start", "3", "--duration", "3")
    lines = played(tmp_path / "log", *words)
    media_s, force_n = followed(lines)
    expected = open_source(packed).tracks["realistic"].at(media_s)
    assert np.median(np.linalg.norm(force_n - expected, axis=1)) < 0.01
    assert lines[-1]["frames"]["shown"] > 0
    assert "waiting" not in [line.get("name") for line in lines]
