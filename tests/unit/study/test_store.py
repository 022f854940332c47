"""Sessions on the disk: private, recoverable, deletable."""

import json
import os
import stat

import numpy as np
import pytest

from hapticplayer import storage
from hapticplayer.errors import StudyError
from hapticplayer.study.answers import (
    collect_answers,
    read_answers,
)
from hapticplayer.study.journal import Journal
from hapticplayer.study.plan import describe
from hapticplayer.study.reviewing import save_reviewed, text_digest
from hapticplayer.study.session_folder import SessionState
from hapticplayer.study.study_folder import (
    begin_session,
    delete_participant,
    drop_session,
    open_study,
    save_consent,
)
from tests.unit.study.conftest import SHEET, VALUES, tree


def test_everything_is_private_whatever_the_umask(study, scripted):
    before = os.umask(0)
    try:
        code = scripted(study)
        save_consent(study, code, given=True, text="yes?", language="en")
        delete_participant(study, scripted(study))
    finally:
        os.umask(before)
    for path in study.folder.rglob("*"):
        mode = stat.S_IMODE(path.stat().st_mode)
        assert mode == (0o700 if path.is_dir() else 0o600), path


def test_the_plan_is_there_before_anything_else(study, manual_clock):
    session = begin_session(study, "fr", {"bike": "0" * 64}, manual_clock)
    assert session.state is SessionState.UNFINISHED
    plan = json.loads((session.folder / "session.json").read_text())
    assert plan["language"] == "fr"
    assert plan["seed"] == 2012
    assert len(plan["order"]) == 12
    assert sorted(plan["labels"]) == ["none", "random", "realistic"]
    assert (session.folder / "study.json").read_bytes() == study.content


def test_answers_are_read_in_the_order_of_the_definition(study, scripted):
    first, second = (
        scripted(study),
        scripted(study, lambda _c: {**VALUES, "realism": 4}),
    )
    answers = read_answers(study.folder)
    assert answers.sequences == ("bike", "horse", "car-turning", "car-braking")
    assert answers.feedbacks == ("realistic", "none", "random")
    assert answers.factors == ("realism", "sensory", "comfort", "satisfaction")
    assert [p.code for p in answers.participants] == [first, second]
    assert answers.participants[0].age == SHEET["age"]
    assert answers.participants[0].used_device_before is True
    assert answers.participants[0].complete
    assert len(answers.ratings) == 2 * 12 * 4
    assert [r.value for r in answers.ratings[:4]] == [3, 2, 5, 1]
    assert [r.value for r in answers.ratings[48:52]] == [4, 2, 5, 1]
    assert [r.factor for r in answers.ratings[:4]] == list(answers.factors)
    assert {r.sequence for r in answers.ratings[:12]} == {"bike"}


def test_a_skipped_answer_is_missing_and_not_dropped(study, scripted):
    scripted(study, lambda c: None if c.sequence == "horse" else VALUES)
    answers = read_answers(study.folder)
    assert len(answers.ratings) == 48
    missing = [r for r in answers.ratings if r.value is None]
    assert {r.sequence for r in missing} == {"horse"}
    assert len(missing) == 12


def test_impossible_answers_are_missing(study, scripted):
    bad = {"realism": 6, "sensory": True, "comfort": "5", "satisfaction": 3.5}
    scripted(study, lambda _condition: bad)
    assert {r.value for r in read_answers(study.folder).ratings} == {None}


def test_flipped_bytes_lose_at_most_the_records_they_hit(study, scripted):
    code = scripted(study)
    folder = study.session_folder(code)
    truth = read_answers(study.folder)
    rng = np.random.default_rng(3)
    files = [p for p in sorted(folder.iterdir()) if p.is_file()]
    for _ in range(300):
        path = files[int(rng.integers(len(files)))]
        content = path.read_bytes()
        spoilt = bytearray(content)
        spoilt[int(rng.integers(len(content)))] ^= 1 << int(rng.integers(8))
        path.write_bytes(spoilt)
        found = read_answers(study.folder)
        path.write_bytes(content)
        assert found.notices, path.name
        assert len(found.participants) == 1
        lost = [
            (a, b)
            for a, b in zip(truth.ratings, found.ratings, strict=True)
            if a.value != b.value
        ]
        assert len(lost) in (0, 4)
        assert all(b.value is None for _, b in lost)


def test_damage_to_the_record_of_playing_makes_the_trial_invalid(study, scripted):
    path = study.session_folder(scripted(study)) / "answers.jsonl"
    kept = path.read_bytes().splitlines(keepends=True)
    at = next(i for i, line in enumerate(kept) if b'"kind":"trial"' in line)
    kept[at] = kept[at].replace(b"is_valid", b"is_val1d")
    path.write_bytes(b"".join(kept))
    ratings = read_answers(study.folder).ratings
    assert sum(not r.is_valid for r in ratings) == 4
    assert all(r.value is not None for r in ratings)


def test_a_session_without_an_intact_plan_is_named(study, scripted):
    broken, whole = scripted(study), scripted(study)
    folder = study.session_folder(broken)
    (folder / "session.json").write_text("{}")
    (folder / "answers.jsonl").write_text("nonsense")
    answers = read_answers(study.folder)
    assert [p.code for p in answers.participants] == [whole]
    assert any(broken in notice for notice in answers.notices)


def test_a_deleted_participant_leaves_a_count_and_nothing_else(study, scripted):
    code, other = scripted(study), scripted(study)
    save_consent(study, code, given=True, text="yes?", language="en")
    assert delete_participant(study, code.lower()) == []
    left = tree(study.folder)
    assert not any(code in name or code.encode() in text for name, text in left.items())
    assert study.deleted_count() == 1
    assert study.codes() == [other]
    with pytest.raises(StudyError, match="no participant"):
        delete_participant(study, code)


def test_a_deletion_that_was_interrupted_is_finished_once(study, scripted):
    code = scripted(study)
    folder = study.session_folder(code)
    (folder / "link").symlink_to(study.folder)  # to what is not of this session
    folder.rename(folder.with_name(".leaving-0123456789abcdef"))
    for _ in range(2):
        study = open_study(study.folder)
        assert study.deleted_count() == 1
        assert code.encode() not in b"".join(tree(study.folder).values())


def test_a_participant_is_deleted_before_the_count_needs_room(
    study, scripted, monkeypatch
):
    code = scripted(study)

    def write_if_there_is_room(*_):
        assert not list(study.folder.rglob("answers.jsonl"))

    monkeypatch.setattr(storage, "replace_file", write_if_there_is_room)
    delete_participant(study, code)
    assert not list((study.folder / "sessions").iterdir())


def test_files_that_name_a_deleted_participant_are_reported(study, scripted):
    code = scripted(study)
    (study.folder / "report.html").write_text(f"outlier: {code}")
    assert delete_participant(study, code) == ["report.html"]


def test_a_session_damaged_beyond_use_is_deleted_all_the_same(study, scripted):
    code = scripted(study)
    folder = study.session_folder(code)
    (folder / "answers.jsonl").unlink()
    (folder / "session.json").write_bytes(b"{")
    assert delete_participant(study, code) == []
    assert not folder.exists()
    assert study.deleted_count() == 1


def test_unreadable_files_are_named_relative_to_the_study(study, scripted):
    code = scripted(study)
    (study.session_folder(code) / "answers.jsonl").unlink()
    (notice,) = read_answers(study.folder).notices
    assert code in notice
    assert "answers.jsonl" in notice
    assert str(study.folder) not in notice


def test_a_participant_in_a_running_session_is_not_deleted(study, manual_clock):
    from hapticplayer.study.journal import Journal

    session = begin_session(study, "en", {}, manual_clock)
    save_consent(study, session.code, given=True, text="yes?", language="en")
    journal = Journal(session.folder / "answers.jsonl", manual_clock)
    with pytest.raises(StudyError, match="another window"):
        delete_participant(study, session.code)
    journal.close()
    assert (study.folder / "consents" / f"{session.code}.json").is_file()
    assert study.codes() == [session.code]


def test_consent_is_kept_apart_and_without_its_text(study, manual_clock):
    session = begin_session(study, "en", {}, manual_clock)
    save_consent(study, session.code, given=True, text="Do you agree?", language="en")
    kept = json.loads((study.folder / "consents" / f"{session.code}.json").read_text())
    assert kept["given"] is True
    assert len(kept["text_sha256"]) == 64
    assert "agree" not in json.dumps(kept)
    session_text = b"".join(tree(session.folder).values())
    assert b"text_sha256" not in session_text


def test_texts_are_unreviewed_until_a_person_lets_them_pass(study, manual_clock):
    from hapticplayer.study.journal import Journal
    from hapticplayer.study.plan import describe

    session = begin_session(study, "en", {}, manual_clock)
    journal = Journal(session.folder / "answers.jsonl", manual_clock)
    condition = describe(session.plan.order[0])
    journal.append(
        "answers",
        step="trial-01",
        page="rating",
        attempt=1,
        condition=condition,
        values=VALUES,
    )
    words = {"label@random": "wobbly", "tiring": "no, Anna", "applications": " "}
    journal.append("answers", step="post-test", page="post-test", values=words)
    journal.close()
    found = read_answers(study.folder).open_answers
    assert {(a.question, a.feedback, a.text, a.reviewed) for a in found} == {
        ("label", "random", "wobbly", False),
        ("tiring", "", "no, Anna", False),
    }
    save_reviewed(session.folder, [text_digest(session.code, "label@random", "wobbly")])
    found = read_answers(study.folder).open_answers
    assert {a.question for a in found if a.reviewed} == {"label"}


def test_incomplete_and_simulated_sessions_are_reported(study, scripted, manual_clock):
    scripted(study)
    begin_session(study, "en", {}, manual_clock)
    left = begin_session(study, "en", {}, manual_clock)
    journal = Journal(left.folder / "answers.jsonl", manual_clock)
    condition = describe(left.plan.order[0])
    name = {"step": "trial-01", "attempt": 1, "condition": condition}
    journal.append("answers", **name, page="rating", values=VALUES)
    journal.close()
    found = collect_answers(study)
    assert found.notices == (
        "1 of 3 sessions have no answers",
        "1 of 3 sessions have answers but were not completed",
        "1 of 3 sessions are simulated",
    )
    assert len(found.participants) == 2


def test_dropping_ends_a_session_for_good(study, manual_clock):
    session = begin_session(study, "en", {}, manual_clock)
    drop_session(study, session.code, "left", manual_clock)
    assert study.session(session.code).state is SessionState.STOPPED
