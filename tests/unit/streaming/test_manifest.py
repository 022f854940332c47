"""What is said of a stream is believed only within limits."""

import json

import pytest

from hapticplayer.errors import InputError, NetworkError
from hapticplayer.streaming.manifest import Manifest, read_manifest

WHOLE = Manifest("Ride", "ride.mkv", 1000, 2001, ("realistic", "none"), "realistic")


def changed(**values):
    content = json.loads(WHOLE.to_json())
    for path, value in values.items():
        *folders, name = path.split("__")
        at = content
        for folder in folders:
            at = at[folder]
        at[name] = value
    return json.dumps(content).encode()


def test_a_manifest_comes_back_as_it_was():
    assert read_manifest(WHOLE.to_json(), "here") == WHOLE


@pytest.mark.parametrize(
    "values",
    [
        {"schema": "other"},
        {"version": 2},
        {"title": ""},
        {"title": "x" * 201},
        {"clip": None},
        {"clip__size_bytes": 0},
        {"clip__size_bytes": "9"},
        {"clip__name": 7},
        {"force__samples": 0},
        {"force__samples": True},
        {"force__samples": 10**9},
        {"force__rate_hz": 500},
        {"force__samples_per_packet": 64},
        {"force__tracks": []},
        {"force__tracks": ["realistic"] * 2},
        {"force__tracks": ["realistic", 3]},
        {"force__tracks": [f"t{k}" for k in range(17)]},
        {"force__tracks": [["realistic"]]},
        {"force__feedback": "other"},
    ],
)
def test_what_does_not_fit_is_refused_in_one_sentence(values):
    with pytest.raises(NetworkError) as caught:
        read_manifest(changed(**values), "http://host/manifest.json")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b"\xff", b"[" * 9000, b"7"])
def test_what_is_no_manifest_is_refused(content):
    with pytest.raises(InputError):
        read_manifest(content, "here")


def test_titles_hold_no_commands_for_a_terminal():
    found = read_manifest(changed(title="\x1b[2Jride", clip__name="../a\n"), "here")
    assert (found.title, found.clip_name) == ("?[2Jride", "..?a?")
