"""What the window keeps is read without it, and nonsense in it is not believed."""

import json

import pytest

from hapticplayer.playback.latency import (
    MOST_NAMES,
    Latencies,
    latencies_in,
    saved_latencies,
)


@pytest.fixture
def keep(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))

    def write(content):
        folder = tmp_path / "hapticplayer"
        folder.mkdir(exist_ok=True)
        (folder / "window.json").write_bytes(content)

    return write


def settings(version=1, **parts):
    return json.dumps({"version": version, "latencies": parts}).encode()


def test_without_a_file_nothing_is_compensated(keep):
    assert saved_latencies() == Latencies()


def test_outputs_and_devices_are_known_by_name(keep):
    keep(settings(sound={"a": 70}, device={"falcon": 12.5}, display={"b": 30}))
    known = saved_latencies().of("a", "falcon")
    assert (known.sound_s, known.device_s) == (0.07, 0.0125)
    assert saved_latencies().of("other", "none").lead_s == known.display_s == 0.0
    assert latencies_in({"display": {"b": 30}}, "b").display_s == 0.03


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\xff\xfe not text",
        b"[1, 2]",
        b'{"latencies": 5}',
        b'{"latencies": {"sound": [1]}}',
        b'{"version": 2, "latencies": {"sound": {"a": 70}}}',
        b'{"version": "new", "latencies": {"sound": {"a": 70}}}',
        b"[" * 100_000,
        settings(sound={"a": float("nan")}),
        settings(sound={"a": -1.0}),
        settings(sound={"a": 1001.0}),
        settings(sound={"a": True}),
        settings(sound={"a": "70"}),
        b" " * (1 << 20) + settings(sound={"a": 70}),
    ],
)
def test_an_implausible_latency_is_not_used(keep, content):
    keep(content)
    assert dict(saved_latencies().sound_s) == {}


def test_a_list_without_end_is_cut():
    table = {"sound": {str(number): 1.0 for number in range(5 * MOST_NAMES)}}
    assert len(latencies_in(table).sound_s) == MOST_NAMES
