"""`export`, `import-force` and `convert` from the command line."""

import json

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.errors import from_json
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.force_formats import read_formats, written_formats
from tests.needed_extras import needs

KINDS = [
    name for name in written_formats() if name in read_formats() and name != "funscript"
]


@pytest.fixture
def report_of(capsys):
    def run(*words):
        assert cli.main([*map(str, words), "--json"]) == 0
        return json.loads(capsys.readouterr().out)

    return run


@pytest.mark.parametrize("name", KINDS)
def test_an_exported_track_comes_back_into_the_sequence(
    name, report_of, sequence_folder, tmp_path
):
    path = tmp_path / f"out{written_formats()[name].suffix}"
    report = report_of("export", sequence_folder, "--format", name, "-o", path)
    assert report["bytes"] == path.stat().st_size
    assert report["error_max_n"] <= 0.0101
    assert report_of("import-force", "--check", path)["unread"] == []
    added = report_of("import-force", path, sequence_folder, "--name", "back")
    assert added["feedback"] == "back"
    tracks = open_sequence(sequence_folder).tracks
    at_s = np.arange(0, 500) / 1000.0
    error_n = tracks["back"].at(at_s) - tracks["realistic"].at(at_s)
    assert np.linalg.norm(error_n, axis=1).max() <= 0.0101


@pytest.mark.parametrize(
    ("last_s", "is_said"), [(1.0, False), (1.0009, False), (99.0, True)]
)
def test_force_after_the_clip_is_said(
    report_of, sequence_folder, tmp_path, last_s, is_said
):
    source = tmp_path / "in.csv"
    source.write_text(f"time_s,fx_n,fy_n,fz_n\n0,0,1,0\n{last_s},0,0,0\n")
    notes = report_of("import-force", source, sequence_folder)["notes"]
    said = [note for note in map(from_json, notes) if "goes on until" in note]
    assert bool(said) is is_said


@pytest.mark.parametrize("name", written_formats())
@needs("formats")
def test_every_format_is_made_of_a_csv(name, report_of, tmp_path):
    source = tmp_path / "in.csv"
    source.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n0.5,0,1.5,0\n1.5,0,0,0\n")
    path = tmp_path / f"out{written_formats()[name].suffix}"
    report = report_of("convert", source, path, "--to", name)
    assert report["bytes"] == path.stat().st_size > 0
    assert set(report) >= {"kbit_s", "kbit_s_compressed", "track_kbit_s", "notes"}


@pytest.mark.parametrize(
    "command", ["export", pytest.param("convert", marks=needs("formats"))]
)
def test_a_command_says_what_is_left_out(command, sequence_folder, tmp_path, capsys):
    source, target = tmp_path / "in.csv", str(tmp_path / "out.csv")
    source.write_text("time_s,fx_n,fy_n,fz_n\n-1,0,1,0\n0.5,0,1.5,0\n1.5,0,0,0\n")
    words = {"convert": ["convert", str(source), target]}
    words["export"] = ["export", str(sequence_folder), "-o", target]
    assert cli.main(words[command]) == 0
    left_out = {"convert": "before 0 s", "export": "after the end of the clip"}
    assert f"left out: the force {left_out[command]}" in capsys.readouterr().out


@needs("formats")
def test_motion_is_exported_where_it_was_shared(report_of, sequence_folder, tmp_path):
    path = tmp_path / "a.sem"
    report_of("export", sequence_folder, "-o", path, "--with-motion")
    assert b"MoveToward" in path.read_bytes()
    report_of("pack", sequence_folder, "-o", tmp_path / "ride.mkv")
    packed = ["export", str(tmp_path / "ride.mkv"), "--with-motion", "-o"]
    assert cli.main([*packed, str(tmp_path / "b.sem")]) == 1
    assert cli.main([*packed, str(tmp_path / "b.hjif")]) == 2


@needs("formats")
def test_a_packed_video_is_exported_like_its_folder(
    report_of, sequence_folder, tmp_path
):
    report_of("pack", sequence_folder, "-o", tmp_path / "ride.mkv")
    one = report_of("export", sequence_folder, "-o", tmp_path / "a.wav")
    two = report_of("export", tmp_path / "ride.mkv", "-o", tmp_path / "b.wav")
    assert (tmp_path / "a.wav").read_bytes() == (tmp_path / "b.wav").read_bytes()
    assert one["error_max_n"] == two["error_max_n"]


@needs("formats")
def test_the_tolerance_is_kept_and_saves_bytes(report_of, sequence_folder, tmp_path):
    fine = report_of(
        "export", sequence_folder, "-o", tmp_path / "a.hjif", "--tolerance", 0.001
    )
    rough = report_of(
        "export", sequence_folder, "-o", tmp_path / "b.hjif", "--tolerance", 0.1
    )
    assert fine["error_max_n"] <= 0.001 < rough["error_max_n"] <= 0.1
    assert rough["bytes"] < fine["bytes"]


@needs("formats")
def test_a_check_says_which_parts_of_a_file_would_be_lost(capsys, tmp_path):
    path = tmp_path / "ride.sem"
    effect = '<Effect type="{}" timestamp="0" duration="900">{}</Effect>'
    kinds = effect.format("Vibration", "") + effect.format("Wind", "")
    path.write_text(f"<SEM>{kinds}</SEM>")
    assert cli.main(["import-force", "--check", str(path)]) == 2
    said = capsys.readouterr().out
    assert "mpegv, force until 0.900 s, peak 0." in said
    assert "not read: Wind (1)" in said
    assert "only a part of it would be read" in said


def test_a_check_of_a_table_says_when_it_ends(report_of, tmp_path):
    path = tmp_path / "in.csv"
    path.write_text("time_s,fx_n,fy_n,fz_n\n0,0,1,0\n2.5,0,0,0\n")
    assert report_of("import-force", "--check", path)["end_s"] == 2.5


@needs("formats")
def test_a_check_refuses_what_an_import_would_refuse(capsys, tmp_path):
    path = tmp_path / "bad.hjif"
    path.write_text('{"version":"2020"}')
    assert cli.main(["import-force", "--check", str(path)]) == 1
    assert "missing entry 'perceptions'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "status", "says"),
    [
        (["export", "{folder}", "-o", "x.doc"], 2, "unknown"),
        (["export", "{folder}", "-o", "x.csv", "--feedback", "y"], 2, "choose one of"),
        (["export", "{folder}", "-o", "x.csv", "--tolerance", "9"], 2, "between"),
        pytest.param(
            *(["convert", "x.hjif", "y.csv", "--direction", "0,0,0"], 2),
            *("three numbers",),
            marks=needs("formats"),
        ),
        pytest.param(
            *(["convert", "none.hjif", "y.csv"], 1, "no such file"),
            marks=needs("formats"),
        ),
        (["import-force", "away.csv", "{folder}"], 1, "no such file"),
        (["import-force", "away.csv"], 2, "needs a SEQUENCE"),
        (["import-force", "--check", "away.csv", "{folder}"], 2, "no SEQUENCE"),
    ],
)
def test_an_impossible_command_is_refused_in_one_sentence(
    words, status, says, sequence_folder, capsys, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    words = [word.format(folder=sequence_folder) for word in words]
    assert cli.main(words) == status
    said = capsys.readouterr().err.strip().splitlines()[-1]
    assert says in said
    assert not list(tmp_path.glob("x.*"))
