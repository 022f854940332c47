"""A run without a window: what was measured in one is used, and --mute is silent."""

import json

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from tests.e2e.command import forces_of, hapticplayer, in_process, read_log

DEVICE_MS, DISPLAY_MS = 40.0, 300.0


@pytest.fixture(scope="module")
def clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "sound.mp4"
    grey = (np.full((72, 128, 3), 3 * k, dtype=np.uint8) for k in range(30))
    tone = np.full((48_000, 2), 0.1, np.float32)
    write_clip(path, grey, frame_rate_hz=30, audio=tone)
    return path


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    """The settings of somebody who has measured."""
    folder = tmp_path_factory.mktemp("config")
    (folder / "hapticplayer").mkdir()
    latencies = {
        "display": {"screen": DISPLAY_MS},
        "device": {"simulated": DEVICE_MS},
        "sound": {"some output": 70.0},
    }
    settings = {"version": 1, "latencies": latencies}
    (folder / "hapticplayer" / "window.json").write_text(json.dumps(settings))
    return folder


def log_of(clip, home, tmp_path, *more):
    log = tmp_path / "log.jsonl"
    options = ["--headless", "--duration", 0.4, "--log", log, *more]
    done = in_process("play", clip, *options, env={"XDG_CONFIG_HOME": str(home)})
    assert done.returncode == 0, done.stderr
    return read_log(log)


def early_s(lines):
    """Return by how much the force came before each frame, s."""
    time_s, media_s, _ = forces_of(lines)
    inside = (media_s > 0.1) & (media_s < 0.4)
    return [
        line["monotonic_s"]
        - np.interp(line["media_s"], media_s[inside], time_s[inside])
        for line in lines
        if line["kind"] == "frame" and 0.12 < line["media_s"] < 0.38
    ]


@pytest.mark.realtime
def test_the_latencies_that_were_measured_are_used_and_told(clip, home, tmp_path):
    # a busy machine shows frames late, but none earlier than they are aimed
    for _ in range(10):
        lines = log_of(clip, home, tmp_path, "--mute")
        least_s = min(early_s(lines), default=0.0)
        if least_s == pytest.approx(0.04, abs=0.005):
            break
    latencies = [line for line in lines if line.get("name") == "latency"]
    assert latencies[-1]["device_s"] == pytest.approx(1e-3 * DEVICE_MS)
    assert latencies[-1]["display_s"] == 0.0  # there is no screen
    # the force is sent so much earlier that it is felt with its frame
    assert least_s == pytest.approx(0.04, abs=0.005)


@pytest.mark.realtime
def test_mute_plays_the_same_pictures_without_sound(clip, home, tmp_path):
    lines = log_of(clip, home, tmp_path, "--mute", "--device", "none")
    summary = lines[-1]
    assert summary["clock"] == "monotonic"
    assert summary["audio_underrun_s"] == 0.0
    assert not [line for line in lines if line["kind"] == "audio"]
    assert not [line for line in lines if line.get("name") == "no_sound_output"]
    frames = [line["media_s"] for line in lines if line["kind"] == "frame"]
    assert len(frames) == summary["frames"]["shown"] > 0
    assert np.allclose(
        np.array(frames) * 30, np.round(np.array(frames) * 30), atol=0.01
    )


def test_a_force_track_in_milliseconds_is_noticed(clip, tmp_path):
    force = tmp_path / "force.csv"
    force.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n300,1,0,0\n1000,0,0,0\n")
    options = ("--headless", "--mute", "--device", "none", "--duration", 0.1)
    done = hapticplayer("play", clip, "--force", force, *options)
    assert done.returncode == 0
    assert "note: the force track goes from 0 s to 1000 s" in done.stderr
    assert "it looks like milliseconds" in done.stderr
