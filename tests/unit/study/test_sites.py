"""A study is packed, run at several sites, and comes together again."""

import json
import shutil

import pytest

from hapticplayer import cli
from hapticplayer.errors import InputError, StudyError
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.merging import merge_sessions
from hapticplayer.study.sites import MANIFEST, PACKED, SITE, check_package, pack_study
from hapticplayer.study.study_export import export_study
from hapticplayer.study.study_folder import begin_session, open_study
from tests.unit.study.conftest import tree


@pytest.fixture
def packed(tmp_path, sequence_folder):
    """A study with real sequences, and its package."""
    folders = dict.fromkeys(
        ("bike", "horse", "car-turning", "car-braking"), sequence_folder
    )
    study = create_study(tmp_path / "study", folders=folders)
    pack_study(study, tmp_path / "package")
    return study, open_study(tmp_path / "package")


def site(package, target):
    shutil.copytree(package.folder, target)
    return open_study(target)


def test_a_package_has_all_that_a_site_needs_and_its_checksums(packed, tmp_path):
    study, package = packed
    listed = json.loads((package.folder / MANIFEST).read_bytes())
    assert {*listed["files"], MANIFEST} == tree(package.folder).keys()
    assert (study.folder / PACKED).read_bytes() == (
        package.folder / MANIFEST
    ).read_bytes()
    check_package(package)
    check_package(study)  # is none itself
    assert package.definition.id == study.definition.id
    with pytest.raises(InputError, match="already exists"):
        pack_study(study, tmp_path / "package")


@pytest.mark.parametrize(
    ("name", "before", "after", "reason"),
    [
        ("study.json", b'"sound": true', b'"sound": false', "was altered since"),
        ("sequences/bike/sequence.json", b"Ride", b"Rode", "was altered since"),
        (MANIFEST, b'_utc": "2', b'_utc": "3', "its checksum differs"),
    ],
)
def test_a_package_that_was_altered_does_not_run(packed, name, before, after, reason):
    path = packed[1].folder / name
    content = path.read_bytes()
    assert before in content
    path.write_bytes(content.replace(before, after, 1))
    with pytest.raises(StudyError, match=reason):
        check_package(open_study(packed[1].folder))


def test_sites_come_together_with_their_names(packed, scripted, tmp_path, capsys):
    study, package = packed
    places = {"berlin": tmp_path / "all" / "berlin", "rennes": tmp_path / "elsewhere"}
    codes = {name: [scripted(site(package, at))] for name, at in places.items()}
    folders = [str(tmp_path / "all"), f"rennes={places['rennes']}"]
    assert cli.main(["study", "merge", str(study.folder), *folders, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [one["added"] for one in found] == list(codes.values())
    assert [one["site"]["site"] for one in found] == list(codes)
    assert found[0]["site"]["sessions"] == found[0]["site"]["simulated"] == 1
    answers = read_answers(study.folder)
    assert {one.code: one.site for one in answers.participants} == {
        code: name for name, of in codes.items() for code in of
    }
    export_study(study, tmp_path / "csv", "csv")
    rows = (tmp_path / "csv" / "participants.csv").read_text(encoding="utf-8")
    assert rows.splitlines()[0].endswith(",site")
    assert rows.count(",berlin\n") == 1
    again = merge_sessions(study, open_study(places["berlin"]), "berlin")
    assert again.same == tuple(codes["berlin"])


def test_one_folder_that_is_refused_leaves_the_study_as_it_was(
    packed, tmp_path, manual_clock, capsys
):
    study, package = packed
    begin_session(site(package, tmp_path / "good"), "en", {}, manual_clock)
    for bad in (f"a b={tmp_path / 'good'}", str(tmp_path / "none")):
        words = [str(study.folder), str(tmp_path / "good"), bad]
        assert cli.main(["study", "merge", *words]) == 1
        assert capsys.readouterr().err
        assert study.codes() == []


def test_an_altered_definition_is_not_merged(packed, scripted, tmp_path):
    study, package = packed
    other = site(package, tmp_path / "site")
    scripted(other)
    path = other.folder / "study.json"
    content = path.read_text(encoding="utf-8")
    path.write_text(content.replace('"seed": 2012', '"seed": 2013'), encoding="utf-8")
    with pytest.raises(StudyError, match="altered since the study was packed"):
        merge_sessions(study, open_study(other.folder))
    code = scripted(open_study(other.folder))
    path.write_text(content, encoding="utf-8")  # as if nothing had been changed
    merged = merge_sessions(study, open_study(other.folder), "there")
    (conflict,) = merged.conflicts
    assert conflict.startswith(f"{code}: ")
    assert "altered after the study was packed" in conflict
    assert len(merged.added) == 1


def test_a_session_that_played_other_clips_is_not_merged(
    packed, tmp_path, manual_clock
):
    study, package = packed
    other = site(package, tmp_path / "site")
    begin_session(other, "en", {"bike": "0" * 64}, manual_clock)
    (conflict,) = merge_sessions(study, other).conflicts
    assert "played another sequence 'bike'" in conflict


def test_a_damaged_name_of_a_site_costs_no_answers(study, scripted):
    code = scripted(study)
    (study.session_folder(code) / SITE).write_text('{"site": "a b"}')
    answers = read_answers(study.folder)
    assert [(one.code, one.site) for one in answers.participants] == [(code, "")]
    assert any(SITE in one for one in answers.notices)


def test_a_session_with_a_damaged_site_is_not_merged(packed, tmp_path, manual_clock):
    study, package = packed
    other = site(package, tmp_path / "site")
    code = begin_session(other, "en", {}, manual_clock).code
    (other.session_folder(code) / SITE).write_text('{"site": 3}')
    (conflict,) = merge_sessions(study, other).conflicts
    assert SITE in conflict
    assert study.codes() == []


def test_a_site_reports_devices_and_latencies(study, tmp_path, manual_clock):
    from hapticplayer.study.sites import site_summary
    from tests.unit.study.test_runner import RunningSession

    running = RunningSession(study, manual_clock)
    running.to_trials()
    shown = [("falcon", 2.0), ("falcon", 9.0), ("simulated", -30.0)]
    for device, p50 in shown:
        figures = {"outputs": [device], "force_minus_video_ms": {"p50": p50}}
        running.stage.figures = figures
        running.trial()
    running.runner.close()
    found = site_summary("lab", [study.session(running.code)])
    assert (found.sessions, found.complete, found.trials) == (1, 0, 3)
    assert found.devices == {"falcon": 2, "simulated": 1}
    assert (found.video_ms, found.sound_ms) == ((2.0, -30.0), None)
