"""A run without a window: what was measured in one is used, and --mute is silent."""

import json

import numpy as np
import pytest

from hapticplayer.media.encode import write_clip
from tests.e2e.test_command_line import hapticplayer, read_log

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
    done = hapticplayer("play", clip, *options, env={"XDG_CONFIG_HOME": str(home)})
    assert done.returncode == 0, done.stderr
    return read_log(log)


def test_the_latencies_that_were_measured_are_used_and_told(clip, home, tmp_path):
    lines = log_of(clip, home, tmp_path, "--mute")
    told = [line for line in lines if line.get("name") == "latency"]
    assert told[-1]["device_s"] == pytest.approx(1e-3 * DEVICE_MS)
    assert told[-1]["display_s"] == 0.0  # there is no screen
    # the force is sent so much earlier that it is felt with its picture
    forces = [line for line in lines if line["kind"] == "force"]
    frames = [line for line in lines if line["kind"] == "frame"]
    time_s, media_s = (
        np.array([line[name] for line in forces if 0.1 < line["media_s"] < 0.4])
        for name in ("monotonic_s", "media_s")
    )
    early_s = [
        frame["monotonic_s"] - np.interp(frame["media_s"], media_s, time_s)
        for frame in frames
        if 0.12 < frame["media_s"] < 0.38
    ]
    # a busy machine shows pictures late, none earlier than they are aimed (1 ms early)
    assert len(early_s) >= 5
    assert min(early_s) == pytest.approx(0.04, abs=0.005)


def test_mute_plays_the_same_pictures_without_sound(clip, home, tmp_path):
    lines = log_of(clip, home, tmp_path, "--mute", "--device", "none")
    summary = lines[-1]
    assert summary["clock"] == "monotonic"
    assert summary["audio_underrun_s"] == 0.0
    assert not [line for line in lines if line["kind"] == "audio"]
    assert not [line for line in lines if line.get("name") == "no_sound_output"]
    frames = [line["media_s"] for line in lines if line["kind"] == "frame"]
    shown = summary["frames"]["shown"] + summary["frames"]["dropped"]
    assert shown >= 12
    assert np.allclose(
        np.array(frames) * 30, np.round(np.array(frames) * 30), atol=0.01
    )
