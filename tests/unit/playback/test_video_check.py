"""Without the video that it was made for, a force waits for a person."""

import json
import os
import threading

import numpy as np
import pytest
from msgspec import structs

from hapticplayer import cli
from hapticplayer.errors import InputError
from hapticplayer.media.identity import Times
from hapticplayer.media.matroska import read_attachments
from hapticplayer.media.remux import MATROSKA, Additions, remux, video_payload
from hapticplayer.playback import video_check
from hapticplayer.playback.source import open_source
from hapticplayer.playback.video_check import Verdict, VideoCheck
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import MANIFEST
from tests.unit.playback.conftest import Theatre


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def packed_file(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mkv")
    return tmp_path / "ride.mkv"


@pytest.fixture
def changed_file(packed_file, sequence_folder, tmp_path):
    """The force of one ride, with a video of which one byte is another."""
    content = bytearray((sequence_folder / "clip.mp4").read_bytes())
    content[content.index(b"mdat") + 900] ^= 1
    (tmp_path / "changed.mp4").write_bytes(content)
    attached = tuple(read_attachments(packed_file, MANIFEST))
    target = tmp_path / "changed.mkv"
    remux(tmp_path / "changed.mp4", target, MATROSKA, Additions(attached))
    return target


def test_a_packed_file_plays_as_its_folder_does(packed_file, sequence_folder):
    whole, source = open_source(sequence_folder), open_source(packed_file)
    assert source.check.wait() is Verdict.SAME
    assert (source.title, source.feedback) == (whole.title, whole.feedback)
    assert list(source.tracks) == list(whole.tracks)
    for name, track in whole.tracks.items():
        assert np.array_equal(source.tracks[name].force_n, track.force_n)
    assert source.clip.duration_s == pytest.approx(whole.clip.duration_s, abs=2e-3)
    assert source.description.feedbacks == whole.description.feedbacks


def test_another_video_is_noticed_and_may_be_accepted(changed_file):
    check = open_source(changed_file).check
    assert check.wait() is Verdict.ANOTHER
    assert not check.allows_force
    check.accept()
    assert check.verdict is Verdict.ACCEPTED
    assert check.allows_force


def test_a_file_is_read_once_until_it_changes(packed_file, monkeypatch):
    payload = video_payload(packed_file)
    calls = []
    monkeypatch.setattr(
        video_check, "video_payload", lambda *_: calls.append(1) or payload
    )
    for _ in range(2):
        assert VideoCheck(packed_file, payload).wait() is Verdict.SAME
    assert len(calls) == 1
    with packed_file.open("ab") as writer:
        writer.write(b"\xec\x80")  # an empty Void element
    assert VideoCheck(packed_file, payload).wait() is Verdict.SAME
    assert len(calls) == 2
    other = structs.replace(payload, sha256="0" * 64)
    assert VideoCheck(packed_file, other).wait() is Verdict.ANOTHER


def test_a_change_whose_time_was_put_back_is_noticed(packed_file):
    payload = video_payload(packed_file)
    assert VideoCheck(packed_file, payload).wait() is Verdict.SAME
    before = packed_file.stat()
    content = bytearray(packed_file.read_bytes())
    content[content.index(b"\x1f\x43\xb6\x75") + 900] ^= 1
    with packed_file.open("r+b") as writer:
        writer.write(content)
    os.utime(packed_file, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert packed_file.stat().st_size == before.st_size
    assert VideoCheck(packed_file, payload).wait() is Verdict.ANOTHER


def test_a_video_that_cannot_be_read_is_another_one(tmp_path):
    (tmp_path / "bad.mkv").write_bytes(b"\x1a\x45\xdf\xa3" + bytes(500))
    times = Times(0.0, (), (), (), 0.0)
    expected = video_check.VideoDigest("0" * 64, 1, 1, "", times)
    assert VideoCheck(tmp_path / "bad.mkv", expected).wait() is Verdict.ANOTHER


def test_a_clip_that_was_changed_in_its_folder_is_noticed(sequence_folder):
    check = open_source(sequence_folder).check
    assert check.allows_force, "meanwhile, too"
    assert check.wait() is Verdict.SAME
    clip = sequence_folder / "clip.mp4"
    content = bytearray(clip.read_bytes())
    at = content.index(b"mvhd") + 16  # its time scale
    content[at : at + 4] = (500).to_bytes(4, "big")
    clip.write_bytes(content)
    check = open_source(sequence_folder).check
    assert check.wait() is Verdict.ANOTHER
    assert not check.allows_force


def test_the_mp4_without_its_side_car_says_so(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mp4")
    assert open_source(tmp_path / "ride.mp4").check.wait() is Verdict.SAME
    (tmp_path / "ride.haptics.mkv").unlink()
    source = open_source(tmp_path / "ride.mp4")
    assert source.feedback == "none"
    assert "ask for both files again" in source.notice


def test_a_side_car_that_is_damaged_is_refused(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mp4")
    side_car = tmp_path / "ride.haptics.mkv"
    content = bytearray(side_car.read_bytes())
    content[len(content) // 2] ^= 1
    side_car.write_bytes(content)
    with pytest.raises(InputError, match=r"ride\.haptics\.mkv"):
        open_source(tmp_path / "ride.mp4")


# --- the player -----------------------------------------------------------------------


@pytest.fixture
def stage(silent_clip, packed_file, monkeypatch):
    """A player with a packed file whose checksum is not known before `known` is set."""
    known, payload = threading.Event(), video_payload(packed_file)
    found = [payload]

    def slow(_path, _report):
        known.wait(30.0)
        return found[0]

    monkeypatch.setattr(video_check, "video_payload", slow)
    theatre = Theatre(silent_clip)
    source = open_source(packed_file)
    theatre.player.open(source)
    yield theatre, source.check, known, found
    known.set()
    theatre.player.close()


def tracks_of(theatre, since):
    return {track for _, _, track in theatre.published[since:]}


def test_the_force_comes_once_the_video_is_known(stage):
    theatre, check, known, _ = stage
    theatre.published.clear()
    theatre.player.play()
    theatre.run(0.2)
    assert tracks_of(theatre, 0) == {""}
    known.set()
    assert check.wait() is Verdict.SAME
    before = len(theatre.published)
    theatre.run(0.1)
    assert tracks_of(theatre, before) == {"realistic"}
    assert check.notice not in theatre.player.snapshot().notices


def test_another_video_plays_without_force_until_accepted(stage):
    theatre, check, known, found = stage
    theatre.published.clear()
    found[0] = structs.replace(found[0], packets=1)
    known.set()
    assert check.wait() is Verdict.ANOTHER
    theatre.player.play()
    theatre.run(0.2)
    assert tracks_of(theatre, 0) == {""}
    assert theatre.player.snapshot().media_s > 0.1
    assert theatre.player.snapshot().notices.count(check.notice) == 1
    check.accept()
    before = len(theatre.published)
    theatre.run(0.1)
    assert tracks_of(theatre, before) == {"realistic"}


def test_a_force_of_ones_own_needs_no_check(stage, tmp_path):
    theatre, _, _, _ = stage
    (tmp_path / "own.csv").write_text("time_s,fx_n,fy_n,fz_n\n0,1,0,0\n2,1,0,0\n")
    theatre.player.open(open_source(tmp_path / "ride.mkv", tmp_path / "own.csv"))
    before = len(theatre.published)
    theatre.run(0.1)
    assert tracks_of(theatre, before) == {"file"}


# --- the command ------------------------------------------------------------------------


@pytest.mark.realtime
@pytest.mark.parametrize("accepted", [False, True])
def test_the_command_warns_and_obeys(changed_file, tmp_path, capsys, accepted):
    log = tmp_path / "play.jsonl"
    words = ["play", str(changed_file), "--headless", "--mute", "--duration", "0.8"]
    words += ["--log", str(log), *(["--accept-changed-video"] * accepted)]
    assert cli.main(words) == 0
    assert ("plays without force" in capsys.readouterr().err) is not accepted

    lines = [json.loads(line) for line in log.read_text().splitlines()]
    felt = [np.linalg.norm(one["force_n"]) for one in lines if one["kind"] == "force"]
    expected = open_sequence(tmp_path / "ride").tracks["realistic"]
    assert expected.at(np.linspace(0.3, 0.8, 50)).any()
    assert bool(max(felt) > 0.0) is accepted
