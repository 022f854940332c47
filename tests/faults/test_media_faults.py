"""A named part of what `benchmarks.robustness media` plays: damaged files of five kinds."""

import errno
import os
import re
from itertools import pairwise

import av
import media_cases as cases
import nasty_files as nasty
import pytest

from hapticplayer.media.video import VideoDecoder
from hapticplayer.playback.log import PlaybackLog

MUTATIONS = 12


@pytest.fixture(scope="module", params=cases.CONTAINERS)
def clip(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    return request.param, cases.make_clip(folder, request.param)


def test_a_whole_file_is_played_and_not_marked(clip):
    assert cases.play(clip[1]) == (cases.PICTURES, False)


def test_damaged_files_never_crash_or_hang_and_losses_are_marked(clip, tmp_path):
    container, whole = clip
    content, path = whole.read_bytes(), tmp_path / f"damaged.{container}"
    kinds = set()
    for number in range(MUTATIONS):
        path.write_bytes(cases.mutation(content, container, number))
        outcome = cases.play_in_child(path)
        assert outcome.kind in {"played", "refused"}, (number, outcome)
        assert outcome.extra_bytes <= cases.EXTRA_BYTES
        assert outcome.kind == "played" or outcome.text
        if outcome.kind == "played" and outcome.pictures < cases.PICTURES:
            assert outcome.is_marked, (number, outcome)
        kinds.add(outcome.kind)
    assert kinds == {"played", "refused"}


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    return cases.make_clip(tmp_path_factory.mktemp("good"), "mp4").read_bytes()


@pytest.mark.parametrize("name", nasty.NASTY)
def test_a_nasty_file_comes_to_what_it_must(name, good, tmp_path):
    expected = nasty.NASTY[name]
    outcome = cases.play_in_child(expected.make(tmp_path, good))
    assert outcome.extra_bytes <= cases.EXTRA_BYTES
    if expected.pictures == 0:
        assert outcome.kind == "refused", outcome
        assert re.search(expected.says, outcome.text), outcome
        assert "\n" not in outcome.text
        return
    assert outcome.kind == "played", outcome
    wanted = cases.PICTURES if expected.pictures == nasty.ALL else expected.pictures
    assert outcome.pictures == wanted
    assert not outcome.is_marked


def test_the_times_that_run_backwards_do(tmp_path):
    """And the decoder makes an order of them."""
    path = nasty.NASTY["times that run backwards"].make(tmp_path, b"")
    with av.open(str(path)) as file:
        stored = [p.pts for p in file.demux(video=0) if p.pts is not None]
    assert stored != sorted(stored)
    with VideoDecoder(path) as decoder:
        times_s = [frame.pts_s for frame in decoder.frames()]
    assert len(times_s) == nasty.PICTURES
    assert all(a < b for a, b in pairwise(times_s))


def test_a_file_without_rights_is_refused(good, tmp_path, monkeypatch):
    path = tmp_path / "clip.mp4"
    path.write_bytes(good)

    def refuse(*_arguments):  # tests may run as root
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(os, "open", refuse)
    outcome = cases.play_in_child(path)
    assert (outcome.kind, "permission denied" in outcome.text) == ("refused", True)


def test_a_file_that_is_deleted_while_it_plays_plays_to_its_end(good, tmp_path):
    path = tmp_path / "clip.mp4"
    path.write_bytes(good)
    with VideoDecoder(path) as decoder:
        decoder.next_frame()
        path.unlink()
        left = sum(1 for _ in decoder.frames())
        assert left == cases.PICTURES - 1
        decoder.seek(0.0)
        assert decoder.next_frame().pts_s == 0.0


def test_a_file_that_grows_shows_what_has_come(good, tmp_path):
    short = nasty.NASTY["still being written"].make(tmp_path, good)
    with VideoDecoder(short) as decoder:
        decoder.next_frame()
        with short.open("ab") as writer:
            writer.write(bytes(4096))  # a hole where the next packets shall be
        shown = 1 + sum(1 for _ in decoder.frames())
    assert 1 < shown < nasty.PICTURES


def test_on_a_full_disk_the_clip_plays_on_and_the_log_says_so(tmp_path, fill_disk):
    fill_disk()
    log = PlaybackLog(tmp_path / "log.jsonl", {"clip": "clip.mp4"})
    for number in range(2000):
        log.line("frame", monotonic_s=float(number), media_s=0.04 * number)
    log.close({})
    assert "incomplete" in log.problem
    assert "larger than a file" in log.problem
