"""Sessions from another machine, and conflicts that are named."""

import shutil

import pytest

from hapticplayer.errors import Cancelled, StudyError
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.journal import encode
from hapticplayer.study.merging import merge_copies, merge_sessions
from hapticplayer.study.study_folder import begin_session, open_study
from tests.unit.study.conftest import tree


@pytest.fixture
def other(study, tmp_path):
    shutil.copytree(study.folder, tmp_path / "other")
    return open_study(tmp_path / "other")


def test_sessions_of_both_machines_come_together(study, other, scripted):
    here, there = scripted(study), scripted(other)
    merged = merge_sessions(study, other)
    assert merged.added == (there,)
    assert not merged.conflicts
    assert sorted(study.codes()) == sorted([here, there])
    assert len(read_answers(study.folder).ratings) == 2 * 48
    left, right = study.session_folder(there), other.session_folder(there)
    assert tree(left) == tree(right)
    assert merge_sessions(study, other).same == (there,)


def test_two_sessions_of_one_code_are_a_conflict_and_stay(study, other, scripted):
    code = scripted(other)
    merge_sessions(study, other)
    path = other.session_folder(code) / "answers.jsonl"
    kept = path.read_bytes().splitlines(keepends=True)
    other_end = encode(len(kept), "now", 1.0, "end", {"complete": False})
    path.write_bytes(b"".join(kept[:-1]) + other_end)
    before = tree(study.folder)
    merged = merge_sessions(study, other)
    assert len(merged.conflicts) == 1
    assert code in merged.conflicts[0]
    assert tree(study.folder) == before


def test_sessions_that_played_other_clips_are_named(study, other, manual_clock):
    for place, checksum in ((study, "a1"), (other, "a1"), (other, "b2")):
        clips = {"bike": checksum, "horse": "same"}
        last = begin_session(place, "en", clips, manual_clock)
    merged = merge_sessions(study, other)
    assert len(merged.added) == 2
    assert merged.conflicts == ()
    (notice,) = merged.notices
    assert (
        notice == f"{last.code}: played another sequence 'bike' than the sessions here"
    )


def test_a_stranger_among_copies_keeps_all_of_them_out(
    study, other, scripted, tmp_path
):
    scripted(other)
    stranger = create_study(tmp_path / "stranger")
    before = tree(study.folder)
    with pytest.raises(StudyError, match="is the study"):
        merge_copies(study, [("", other), ("", stranger)])
    with pytest.raises(StudyError, match="site"):
        merge_copies(study, [("", other), ("Two Words", other)])
    assert tree(study.folder) == before


def test_a_merge_that_is_stopped_keeps_whole_sessions(study, other, scripted):
    codes = [scripted(other) for _ in range(3)]

    def stop(fraction, _step):
        if fraction > 0:
            raise Cancelled

    with pytest.raises(Cancelled):
        merge_copies(study, [("", other)], stop)
    there = study.codes()
    assert set(there) <= set(codes)
    assert all(study.session(code).is_sound for code in there)
    again = merge_sessions(study, other)
    assert sorted([*again.added, *again.same]) == sorted(codes)
