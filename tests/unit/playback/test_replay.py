"""A playback log becomes a force track, or is refused with its line."""

import json

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.haptics.shared import TICK
from hapticplayer.model import ForceTrack
from hapticplayer.playback.log import PlaybackLog
from hapticplayer.playback.replay import FROM_LOG, read_force_log, with_log
from hapticplayer.playback.source import Source


def ticks(media_s, force_n):
    made = np.zeros(len(media_s), dtype=TICK)
    made["monotonic_s"] = 50.0 + 0.001 * np.arange(len(media_s))
    made["media_s"], made["force_n"] = media_s, force_n
    return made


@pytest.fixture
def source(clip):
    track = ForceTrack([0.0, 3.0], [[0, 1.0, 0], [0, 1.0, 0]])
    return Source("short", clip.path, clip, {"realistic": track}, None, "realistic")


def written(path, clip, *parts):
    log = PlaybackLog(path, {"clip": clip.path.name, "duration_s": clip.duration_s})
    for part in parts:
        log.ticks(part)
        log.line("event", name="pause", monotonic_s=1.0)
    log.close({})
    return path


def test_the_force_of_a_log_is_played_again(source, tmp_path):
    media_s = np.arange(0.0, 2.0, 0.001)
    force_n = np.stack([np.sin(media_s), np.cos(media_s), 0.2 * media_s], axis=1)
    path = written(tmp_path / "log", source.clip, ticks(media_s, force_n))
    replayed = with_log(source, path)
    assert replayed.feedback == FROM_LOG
    assert list(replayed.tracks) == [FROM_LOG, "realistic"]
    at_s = np.array([0.1234, 1.0, 1.777])
    wanted = np.stack([np.sin(at_s), np.cos(at_s), 0.2 * at_s], axis=1)
    assert replayed.tracks[FROM_LOG].at(at_s) == pytest.approx(wanted, abs=1e-4)


def test_of_two_passes_the_last_one_counts(source, tmp_path):
    media_s = np.arange(0.0, 1.0, 0.001)
    first = ticks(media_s, np.full((1000, 3), 1.0))
    second = ticks(media_s[400:600], np.full((200, 3), 2.0))
    path = written(tmp_path / "log", source.clip, first, second)
    _, track = read_force_log(path)
    found = track.at(np.array([0.2, 0.5, 0.8]))[:, 0]
    assert found == pytest.approx([1.0, 2.0, 1.0])
    assert len(track.time_s) == 1000


def test_a_log_of_another_clip_is_refused(source, tmp_path):
    path = written(tmp_path / "log", source.clip, ticks([0.0], [[0, 0, 0]]))
    lines = path.read_text().splitlines()
    header = {**json.loads(lines[0]), "clip": "other.mp4"}
    path.write_text("\n".join([json.dumps(header), *lines[1:]]))
    with pytest.raises(InputError, match=r"other\.mp4.*open its sequence first"):
        with_log(source, path)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "no force"),
        ("[]\n", "line 1"),
        ('{"kind": "frame"}\n', "without a header"),
        ('{"kind": "header"}\n{"kind": "force"}\n', "line 2"),
        ('{"kind": "header"}\n{"kind": "force", "media_s": 1, "force_n": [1]}', "line 2"),
        (
            (
                '{"kind": "header"}\n'
                '{"kind": "force", "media_s": NaN, "force_n": [0, 0, 0]}'
            ),
            "line 2",
        ),
        (
            (
                '{"kind": "header"}\n'
                '{"kind": "force", "media_s": 1, "force_n": [1e9, 0, 0]}'
            ),
            "line 2",
        ),
        ('{"kind": "header"}\n' + "[" * 70_000, "line 2"),
        ("\0\0\0", "line 1"),
    ],
)  # fmt: skip
def test_a_file_that_is_not_a_log_is_refused_with_its_line(tmp_path, content, message):
    path = tmp_path / "log"
    path.write_text(content)
    with pytest.raises(InputError, match=message):
        read_force_log(path)


def test_a_folder_and_a_missing_file_are_refused(tmp_path):
    for path in (tmp_path, tmp_path / "missing"):
        with pytest.raises(InputError, match=r"not a file|no such file"):
            read_force_log(path)
