"""The command `events`."""

import json

import numpy as np
import pytest

from hapticplayer import cli, storage
from hapticplayer.capture.recording import Recording
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.sequence import store
from hapticplayer.sequence.build import write_sequence
from hapticplayer.sequence.effects_file import effects_in
from hapticplayer.sequence.events import events_of, sound_of
from hapticplayer.structures import read_json

HIT_S, LENGTH_S = 5.0, 8


@pytest.fixture(scope="module")
def knocked(tmp_path_factory):
    """A sequence at rest but for one blow, which is heard; the log begins 3 s early."""
    folder = tmp_path_factory.mktemp("knocked")
    rng = np.random.default_rng(4)
    sound = 0.003 * rng.standard_normal((LENGTH_S * 48_000, 2))
    first = round(HIT_S * 48_000)
    since_s = np.arange(4800) / 48_000.0
    ringing = np.exp(-since_s / 0.02) * np.sin(2 * np.pi * 90.0 * since_s)
    sound[first : first + 4800] += 0.7 * ringing[:, None]
    grey = (np.full((36, 64, 3), k % 200, np.uint8) for k in range(30 * LENGTH_S))
    audio = sound.astype(np.float32)
    write_clip(folder / "ride.mp4", grey, frame_rate_hz=30, audio=audio)
    time_s = np.arange(0.0, LENGTH_S + 6.0, 0.005)
    force = 0.02 * rng.standard_normal((len(time_s), 3))
    force[:, 2] += STANDARD_GRAVITY_MPS2
    phase = (time_s - 3.0 - HIT_S) / 0.06
    push = np.where((phase > 0) & (phase < 1), np.sin(2 * np.pi * phase), 0.0)
    force[:, 2] += 15.0 * push
    rate = 0.001 * rng.standard_normal((len(time_s), 3))
    log = ImuLog(time_s, force, rate, source="log")
    recording = Recording(log, ClockMap(offset_s=-3.0), "test camera", (), {})
    clip = probe(folder / "ride.mp4")
    return write_sequence(clip, recording, folder / "ride")


def test_a_blow_is_found_at_its_media_time(knocked, capsys):
    assert cli.main(["events", str(knocked), "--json", "--kind", "impact"]) == 0
    (event,) = json.loads(capsys.readouterr().out)["events"]
    assert event["kind"] == "impact"
    assert event["start_s"] == pytest.approx(HIT_S, abs=0.1)
    assert event["text"].endswith("heard too")
    effects = {"schema": "hapticplayer.effects", "version": 1}
    (knock,) = effects_in({**effects, "effects": [event["effect"]]}, "-").effects
    assert (knock.kind, knock.parameters["frequency_hz"]) == ("knock", 60.0)
    assert cli.main(["events", str(knocked), "--kind", "impact", "--no-sound"]) == 0
    shown = capsys.readouterr().out
    assert "1 events" in shown
    assert "heard" not in shown


def test_events_lie_in_the_clip(knocked):
    events = events_of(knocked)
    assert {one.kind for one in events} == {"impact", "stillness"}
    assert all(0.0 <= one.start_s <= one.end_s <= LENGTH_S + 0.1 for one in events)
    assert all(0.0 <= one.effect.start_s < one.effect.end_s for one in events)


def test_the_sound_is_that_of_the_clip(knocked):
    sound = sound_of(store.open_sequence(knocked))
    level = np.abs(sound.samples)
    # the encoder smears by its frames, not by more
    assert np.argmax(level > 0.3) / sound.rate_hz == pytest.approx(HIT_S, abs=0.03)


def test_without_log_events_come_from_the_motion(knocked, tmp_path):
    copy = tmp_path / "shared"
    copy.mkdir()
    store.copy_files(knocked, copy)
    described = read_json(copy / store.DESCRIPTION, dict)
    del described["files"][store.IMU]
    storage.replace_json(copy / store.DESCRIPTION, described)
    (copy / store.IMU).unlink()
    assert "impact" in {one.kind for one in events_of(copy)}


def test_no_sequence_is_refused_in_a_sentence(tmp_path, capsys):
    assert cli.main(["events", str(tmp_path)]) == 1
    assert "holds no sequence.json" in capsys.readouterr().err
