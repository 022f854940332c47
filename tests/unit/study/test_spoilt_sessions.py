"""Records that this program did not write: named, left out, and never a wrong number."""

import hashlib
import json
import random
import shutil
import zlib

import pytest

from hapticplayer import cli
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.answers import collect_answers
from hapticplayer.study.creation import change_definition
from hapticplayer.study.journal import Journal, decode, encode
from hapticplayer.study.merging import merge_sessions
from hapticplayer.study.plan import describe, plan_file
from hapticplayer.study.study_export import study_exporters
from hapticplayer.study.study_folder import open_study, save_consent
from tests.unit.study.conftest import SHEET, VALUES, tree
from tests.unit.test_spoilt_documents import WRONG, as_text, places

SPOILT = [*WRONG, "=1+1", "trial-99", -1e300, 10**12, "2012", 3]
MOST = 60
PLAYED = {
    "begun_mono_s": 9.0,
    "ended_mono_s": 13.5,
    "duration_s": 4.0,
    "frames_shown": 100,
    "frames_dropped": 1,
    "force_minus_video_ms": {"count": 9, "p05": 1.0, "p50": 2.0, "p95": 3.0},
    "force_minus_sound_ms": None,
    "ticks": 4000,
    "missed": 1,
    "force_rms_n": [0.1, 0.2, 0.3],
    "outputs": ["simulated"],
}


@pytest.fixture
def session(study, manual_clock):
    """A study with a session that has a record of each kind, and its journal."""
    code = write_scripted_session(
        study, SHEET, lambda _c: VALUES, manual_clock, origin={"scripted": True}
    )
    path = study.session_folder(code) / "answers.jsonl"
    trial = {
        "step": "trial-01",
        "attempt": 2,
        "condition": describe(study.session(code).plan.order[0]),
    }
    journal = Journal(path, manual_clock)
    journal.append("checks", checks=[{"check": "volume"}], overridden=False)
    journal.append("trial-begin", **trial)
    journal.append("trial", **trial, is_valid=True, reasons=[], playback=PLAYED)
    journal.append("answers", **trial, page="rating", values=VALUES, response_s=3.0)
    journal.append("pause", step="trial-02", reason="paused")
    journal.append("go-on", by="operator")
    journal.append(
        "answers", step="post-test", page="post-test", values={"tiring": "no"}
    )
    journal.append("end", complete=True, reason="", by="")
    journal.close()
    return study, path


def signed(body: bytes) -> bytes:
    return body + b',"crc":"%08x"}\n' % zlib.crc32(body)


def line_of(record) -> bytes:
    """A record as a line whose checksum is right, whatever it holds."""
    return signed(as_text(record).rstrip()[:-1])


def spoilt_journals(data: bytes):
    """Yield journals in which an entry of a record is wrong, with what is wrong."""
    lines = data.splitlines(keepends=True)
    last = {json.loads(line)["kind"]: number for number, line in enumerate(lines)}
    chosen = []
    for number in last.values():
        record = json.loads(lines[number])
        record.pop("crc")
        chosen += [(number, record, p, w) for p in places(record) for w in SPOILT]
    random.Random(47).shuffle(chosen)
    for number, record, path, wrong in chosen[:MOST]:
        made = json.loads(json.dumps(record))
        at = made
        for name in path[:-1]:
            at = at[name]
        at[path[-1]] = wrong
        what = f"{record['kind']} {path} {str(wrong)[:20]!r}"
        changed = [*lines[:number], line_of(made), *lines[number + 1 :]]
        yield what, b"".join(changed)


def test_every_command_works_with_a_spoilt_record(session, tmp_path, capsys):
    study, path = session
    truth = {(r.sequence, r.feedback, r.factor) for r in collect_answers(study).ratings}
    commands = [["status"], ["analyse"], ["review"]]
    forms = {"csv", "bids", "xdf"} & study_exporters().keys()
    commands += [["export", "-o", str(tmp_path / f), "--format", f] for f in forms]
    for what, journal in spoilt_journals(path.read_bytes()):
        path.write_bytes(journal)
        for action, *options in commands:
            status = cli.main(["study", action, str(study.folder), *options])
            assert status in (0, 1), what
            assert "Traceback" not in capsys.readouterr().err, what
        for form in forms:
            shutil.rmtree(tmp_path / form, ignore_errors=True)
        found = collect_answers(open_study(study.folder))
        values = {(r.sequence, r.feedback, r.factor): r.value for r in found.ratings}
        assert not values or values.keys() == truth, what
        wrong = {k: v for k, v in values.items() if v not in (None, VALUES[k[2]])}
        # the other valid answer that a record can have been given
        assert set(wrong.values()) <= {3}, what
        assert path.read_bytes() == journal, what


def test_a_spoilt_session_is_named_and_not_merged(session, tmp_path):
    study, path = session
    shutil.copytree(study.folder, tmp_path / "other")
    there = tmp_path / "other" / path.relative_to(study.folder)
    shutil.rmtree(path.parent)
    before = tree(study.folder)
    refused = 0
    for what, journal in spoilt_journals(there.read_bytes()):
        there.write_bytes(journal)
        merged = merge_sessions(study, open_study(tmp_path / "other"))
        assert there.read_bytes() == journal, what
        if merged.conflicts:
            refused += 1
            assert path.parent.name in merged.conflicts[0], what
            assert tree(study.folder) == before, what
        else:
            assert study.session(path.parent.name).is_sound, what
            shutil.rmtree(path.parent)
    assert refused > MOST // 2


def rewritten(path, kind, change):
    """Change the last record of a kind, and sign it."""
    lines = path.read_bytes().splitlines(keepends=True)
    kinds = [json.loads(line)["kind"] for line in lines]
    number = len(kinds) - 1 - kinds[::-1].index(kind)
    record = json.loads(lines[number])
    record.pop("crc")
    change(record)
    lines[number] = line_of(record)
    path.write_bytes(b"".join(lines))
    return record["record"]


@pytest.mark.parametrize(
    "value", [None, [3], "3", {}, True, 0, 6, 10**400, 3.5, -1, "=1+1"]
)
def test_an_answer_out_of_its_scale_is_missing_and_named(session, value):
    study, path = session
    lines = path.read_bytes().splitlines(keepends=True)
    number = max(n for n, one in enumerate(lines) if b'"realism"' in one)
    record = json.loads(lines[number])
    record.pop("crc")
    record["values"]["realism"] = value
    lines[number] = line_of(record)
    path.write_bytes(b"".join(lines))
    found = collect_answers(open_study(study.folder))
    values = [r.value for r in found.ratings if r.factor == "realism"]
    assert sorted(values, key=str) == [3] * 11 + [None]
    assert sum(r.value is None for r in found.ratings) == 1
    named = any("'realism'" in one and "left out" in one for one in found.notices)
    assert named is (value is not None)  # a question that was not answered


def test_a_line_that_is_there_twice_counts_once(session):
    study, path = session
    truth = collect_answers(study)
    for line in path.read_bytes().splitlines(keepends=True):
        kept = path.read_bytes()
        path.write_bytes(kept + line)
        found = collect_answers(open_study(study.folder))
        assert (found.ratings, found.repeated) == (truth.ratings, truth.repeated)
        assert len(found.notices) == len(truth.notices) + 1
        path.write_bytes(kept)


def test_a_trial_that_contradicts_itself_is_not_valid(session):
    study, path = session

    def change(record):
        record["reasons"] = ["no_sound"]

    number = rewritten(path, "trial", change)
    found = collect_answers(open_study(study.folder))
    assert sum(not r.is_valid for r in found.ratings) == 4
    assert any(f"record {number} (trial)" in one for one in found.notices)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"code": "CCCCCC"}, "is the session of CCCCCC"),
        ({"study": "other"}, "does not fit"),
        ({"language": "xx"}, "does not fit"),
        ({"labels": ["none"]}, "does not fit"),
        ({"order": []}, "does not fit"),
        ({"created_utc": "yesterday"}, "not a time"),
    ],
)
def test_a_plan_of_something_else_is_named_and_not_merged(
    session, tmp_path, change, said
):
    study, path = session
    shutil.copytree(study.folder, tmp_path / "other")
    there = (tmp_path / "other" / path.relative_to(study.folder)).parent
    plan = study.session(path.parent.name).plan
    spoilt = json.loads(plan_file(plan))
    spoilt.pop("sha256")
    spoilt |= change
    digest = json.dumps(spoilt, sort_keys=True, ensure_ascii=False).encode()
    spoilt["sha256"] = hashlib.sha256(digest).hexdigest()
    (there / "session.json").write_text(json.dumps(spoilt))
    (there / "answers.jsonl").write_bytes(
        (there / "answers.jsonl").read_bytes().split(b"\n", 1)[1]
    )
    shutil.rmtree(path.parent)
    merged = merge_sessions(study, open_study(tmp_path / "other"))
    assert said in merged.conflicts[0]
    assert study.codes() == []
    (notice,) = open_study(tmp_path / "other").sessions()[1]
    assert said in notice


def test_a_session_of_another_study_is_named(session, tmp_path):
    study, path = session
    content = json.loads(study.content)
    change_definition(study, {**content, "id": "another"})
    (notice,) = open_study(study.folder).sessions()[1]
    assert path.parent.name in notice
    assert f"is a session of the study {content['id']}" in notice


def test_a_torn_line_is_merged_but_an_altered_record_is_not(session, tmp_path):
    study, path = session
    shutil.copytree(study.folder, tmp_path / "other")
    there = tmp_path / "other" / path.relative_to(study.folder)
    shutil.rmtree(path.parent)
    whole = there.read_bytes()
    there.write_bytes(whole.replace(b'"realism":3', b'"realism":4', 1))
    merged = merge_sessions(study, open_study(tmp_path / "other"))
    assert "damaged" in merged.conflicts[0]
    assert study.codes() == []
    torn = whole + encode(99, "x", 1.0, "note", {"text": "a"})[:40]
    there.write_bytes(torn)
    assert merge_sessions(study, open_study(tmp_path / "other")).added


def test_a_record_that_was_taken_out_is_missed(session, tmp_path):
    study, path = session
    shutil.copytree(study.folder, tmp_path / "other")
    there = tmp_path / "other" / path.relative_to(study.folder)
    lines = there.read_bytes().splitlines(keepends=True)
    there.write_bytes(b"".join(lines[:2] + lines[3:]))
    shutil.rmtree(path.parent)
    (conflict,) = merge_sessions(study, open_study(tmp_path / "other")).conflicts
    assert "1 records are missing, the first is number 3" in conflict
    assert study.codes() == []


@pytest.mark.parametrize("content", [b"", b"[]", b'{"given": 1}', b"null", b"{" * 9])
def test_a_spoilt_consent_is_named_and_not_merged(session, tmp_path, content):
    study, path = session
    code = path.parent.name
    save_consent(study, code, given=True, text="yes?", language="en")
    shutil.copytree(study.folder, tmp_path / "other")
    shutil.rmtree(path.parent)
    consent = study.folder / "consents" / f"{code}.json"
    consent.unlink()
    other = tmp_path / "other"
    (other / "consents" / consent.name).write_bytes(content)
    merged = merge_sessions(study, open_study(other))
    assert f"{code}.json" in merged.conflicts[0]
    assert study.codes() == []
    assert not consent.exists()


def test_each_damaged_line_of_a_long_journal_has_its_number():
    record = encode(1, "x", 1.0, "note", {"text": "a"})
    found = decode((record + b"damaged\n") * 20_000)
    assert len(found.damaged) == 20_000
    assert "(line 40000," in found.damaged[-1]


@pytest.mark.parametrize("opening", [b'{"record":', b"[", b'{"a":', b'{"record":[{'])
def test_nested_openings_with_a_right_checksum_are_damage(opening):
    head = b'{"record":1,"v":1,"utc":"x","mono_s":1,"kind":"note","text":'
    line = signed(head + opening * (400_000 // len(opening)))
    found = decode(line + encode(2, "x", 1.0, "note", {}))
    assert [one.number for one in found.intact] == [2]
    assert len(found.damaged) == 1
