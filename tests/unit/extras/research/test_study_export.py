"""Exports read by other programs, and what must not be in them."""

import codecs
import csv
import datetime as dt
import getpass
import io
import json
import re
import socket
import stat
from pathlib import Path

import numpy as np
import pytest
import pyxdf
from pyxdf.cli import print_metadata

from hapticplayer import cli
from hapticplayer.errors import InputError, StudyError, UsageError
from hapticplayer.extras.research.bids import begins_of
from hapticplayer.extras.research.xdf import XdfWriter
from hapticplayer.haptics.records import RecordWriter
from hapticplayer.haptics.shared import TICK
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study import study_export
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.journal import Journal
from hapticplayer.study.plan import describe
from hapticplayer.study.reviewing import save_reviewed, text_digest
from hapticplayer.study.study_export import Exporter, export_study
from hapticplayer.study.study_folder import begin_session, open_study
from tests.bids import errors_in, validated
from tests.every_kind import with_every_kind
from tests.recorded_session import recorded_session

VALUES = {"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1}
SHEET = {"age": 31, "gender": "female", "handedness": "left"}
TICKS = 4000


@pytest.fixture
def study(tmp_path, manual_clock):
    """Two participants, one of them with a record of the device and texts."""
    made = create_study(tmp_path / "study")
    for _ in range(2):
        write_scripted_session(
            made, SHEET, lambda _c: VALUES, manual_clock, origin={"scripted": True}
        )
    folder = made.session_folder(made.codes()[0])
    journal = Journal(folder / "answers.jsonl", manual_clock)
    words = {"tiring": "it was Anna", "comfortable": 'yes; "very"\nso'}
    journal.append("answers", step="post-test", page="post-test", values=words)
    journal.close()
    digest = text_digest(folder.name, "comfortable", words["comfortable"])
    save_reviewed(folder, [digest])
    write_ticks(folder / "ticks-01.hprec", manual_clock.now_s() - 1.0)
    return open_study(made.folder)


def write_ticks(path: Path, begun_s: float, *, is_odd: bool = False) -> None:
    ticks = np.zeros(TICKS, dtype=TICK)
    ticks["monotonic_s"] = begun_s + 1e-3 * np.arange(TICKS)
    ticks["media_s"] = 1e-3 * np.arange(TICKS)
    ticks["force_n"][:, 1] = np.sin(1e-2 * np.arange(TICKS))
    ticks["position_m"][:, 0] = 0.01
    ticks["position_m"][7, 2] = np.nan
    if is_odd:
        ticks["monotonic_s"][[0, 9, 500, 1999]] = np.nan, 1e300, -np.inf, 0.0
        ticks["force_n"][600, 1], ticks["media_s"][TICKS - 1] = 1e30, np.inf
    with path.open("wb") as out:
        writer = RecordWriter(out.fileno())
        writer.begin({"device": "simulated"})
        for first in range(0, TICKS, 1000):
            writer.append(first, 0, ticks[first : first + 1000])
        writer.append(TICKS, 0, ticks[:0])


def table(path: Path, mark=",") -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text()), delimiter=mark))


def test_tidy_tables_hold_every_rating_and_explain_each_column(study, tmp_path):
    report = export_study(study, tmp_path / "out", "csv")
    ratings = table(tmp_path / "out" / "ratings.csv")
    assert len(ratings) == 2 * 12 * 4
    assert {(r["factor"], r["value"]) for r in ratings} == {
        (factor, str(value)) for factor, value in VALUES.items()
    }
    explained = {
        (row["file"], row["column"])
        for row in table(tmp_path / "out" / "data_dictionary.csv")
    }
    for name in set(report["files"]) - {"data_dictionary.csv"}:
        for column in table(tmp_path / "out" / name)[0]:
            assert (name, column) in explained
    assert len(table(tmp_path / "out" / "trials.csv")) == 24


FORMULAS = ["=1+1", "+49 30", "-", "@home", "\tx", "'=1", "\uff1d1"]
FORMULAS += [" =1+1", "\ufeff=1", "\u00a0@x", "\u200b=1", "''+1"]
INSIDE = {  # for spreadsheets that separate by semicolons
    "a;=1+1": "a;'=1+1",
    "so; -5": "so; '-5",
    'a;"=1"': 'a;"\'=1"',
    "a\t@b": "a\t'@b",
    "a\n=1": "a\n'=1",
    "a\u2028=1": "a\n'=1",
    "=1;=2": "'=1;'=2",
    "\r=1": "'\n'=1",
    "\n=2": "'\n'=2",
}
SHOWN = {"end\x1aof\0file": "end\ufffdof\ufffdfile", "a\x0bb": "a\nb", "a\x85b": "a\nb"}
PLAIN = [
    "sehr m\u00fcde",
    "a = b",
    "'so'",
    "1-2; 3",
    'he said "no", twice',
    "a\\",
    "5 @ 6",
]
TEXTS = [*FORMULAS, *PLAIN, *INSIDE, *SHOWN]


def said(study, clock, words: str) -> None:
    """Let a participant answer an open question, and approve it."""
    code = write_scripted_session(
        study, SHEET, lambda _c: VALUES, clock, origin={"scripted": True}
    )
    folder = study.session_folder(code)
    journal = Journal(folder / "answers.jsonl", clock)
    journal.append(
        "answers", step="post-test", page="post-test", values={"tiring": words}
    )
    journal.close()
    save_reviewed(folder, [text_digest(code, "tiring", words)])


@pytest.mark.parametrize("form", ["csv", "excel"])
def test_no_spreadsheet_takes_an_answer_for_a_formula(tmp_path, manual_clock, form):
    study = create_study(tmp_path / "study")
    for words in TEXTS:
        said(study, manual_clock, words)
    export_study(study, tmp_path / "out", form)
    for path in (tmp_path / "out").iterdir():
        content = path.read_bytes()
        assert content.startswith(codecs.BOM_UTF8) is (form == "excel"), path
        cells = [*csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""))]
        assert not [one for row in cells for one in row if one[:1] in tuple("=+-@\t\r")]
    text = (tmp_path / "out" / "texts.csv").read_bytes().decode("utf-8-sig")
    written = {row["text"] for row in csv.DictReader(io.StringIO(text, newline=""))}
    guarded = [f"'{one}" for one in FORMULAS]
    expected = {*guarded, *PLAIN, *INSIDE.values(), *SHOWN.values()}
    assert written == {one.replace("\r", "\n") for one in expected}
    for mark in ";\t":  # as a table with other separators
        rows = [*csv.reader(io.StringIO(text, newline=""), delimiter=mark)]
        cells = [one.strip(' "') for row in rows for one in row]
        assert not [one for one in cells if one[:1] in tuple("=+-@")]


LEFT_OUT = {
    "csv": ["each tick of the device", "when each trial and interruption was"],
    "bids": [
        "text answers",
        "planned force",
        "velocity",
        "buttons and timing of each tick",
    ],
    "xdf": ["answers", "planned force", "velocity", "buttons and timing of each tick"],
}
LEFT_OUT["excel"] = LEFT_OUT["csv"]


@pytest.mark.parametrize("form", LEFT_OUT)
def test_an_export_says_what_its_format_leaves_out(study, tmp_path, capsys, form):
    out = tmp_path / "out"
    words = ["study", "export", str(study.folder), "-o", str(out), "--format", form]
    assert cli.main(words) == 0
    said = capsys.readouterr().out.strip().partition("; left out: ")[2]
    assert said.split(", ") == LEFT_OUT[form]
    whole = b"".join(path.read_bytes() for path in out.rglob("*") if path.is_file())
    assert (b'yes; ""very""' in whole) is (form in ("csv", "excel"))
    assert (b"grip_x" in whole or b"PositionX" in whole) is (form in ("bids", "xdf"))


def test_texts_without_a_review_are_not_exported(study, tmp_path):
    for form in ("csv", "bids", "xdf"):
        report = export_study(study, tmp_path / form, form)
        whole = b"".join(p.read_bytes() for p in (tmp_path / form).rglob("*.*"))
        assert b"Anna" not in whole
        assert any("not been reviewed" in notice for notice in report["remarks"])
    texts = table(tmp_path / "csv" / "texts.csv")
    assert [row["text"] for row in texts] == ['yes; "very"\nso']


@pytest.mark.parametrize("form", ["bids", "xdf"])
def test_no_export_names_a_person_a_machine_or_a_path(study, tmp_path, form):
    export_study(study, tmp_path / form, form)
    secrets = [str(tmp_path), str(Path.home()), socket.gethostname(), getpass.getuser()]
    secrets = [secret for secret in secrets if len(secret) > 4]  # others by chance
    for path in (tmp_path / form).rglob("*"):
        content = path.read_bytes() if path.is_file() else b""
        assert not any(secret.encode() in content for secret in secrets), path


def test_xdf_is_what_pyxdf_reads(study, tmp_path):
    export_study(study, tmp_path / "out", "xdf")
    file = next((tmp_path / "out").glob("*_run-1.xdf"))
    streams, _ = pyxdf.load_xdf(str(file))
    by_name = {stream["info"]["name"][0]: stream for stream in streams}
    device, markers = by_name["device"], by_name["markers"]
    assert device["time_series"].shape == (TICKS, 8)
    assert device["info"]["effective_srate"] == pytest.approx(1000.0, rel=1e-6)
    force = device["time_series"][:, 4]
    assert force == pytest.approx(np.sin(1e-2 * np.arange(TICKS)), abs=1e-6)
    assert device["time_series"][:, 7] == pytest.approx(device["time_stamps"], abs=1e-6)
    ends = [text for (text,) in markers["time_series"] if text.startswith("trial-")]
    assert ends == [
        f"trial-{number:02d} end {condition.sequence}/{condition.feedback}"
        for number, condition in enumerate(study.session(file.name[:6]).plan.order, 1)
    ]
    assert len(markers["time_series"]) == 13
    channel = device["info"]["desc"][0]["channels"][0]["channel"][3]
    assert channel["unit"] == ["newton"]


def test_pyxdf_prints_the_metadata_of_every_xdf_file(study, tmp_path, capsys):
    export_study(study, tmp_path / "out", "xdf")
    files = sorted((tmp_path / "out").glob("*.xdf"))
    assert len(files) == 2
    for file in files:
        print_metadata.main(str(file))
        assert capsys.readouterr().out.endswith("Done.\n")
        for stream in pyxdf.resolve_streams(str(file)):
            assert all(value is not None for value in stream.values()), stream
    streams, _ = pyxdf.load_xdf(str(files[0]))
    assert len({one["info"]["uid"][0] for one in streams}) == len(streams)


def test_a_run_without_markers_has_a_footer_for_each_stream(study, tmp_path):
    code = study.codes()[0]
    write_ticks(study.session_folder(code) / "ticks-02.hprec", 1e6)
    export_study(study, tmp_path / "out", "xdf")
    streams, _ = pyxdf.load_xdf(tmp_path / "out" / f"{code}_run-2.xdf")
    counts = {
        stream["info"]["name"][0]: stream["footer"]["info"]["sample_count"]
        for stream in streams
    }
    assert counts == {"device": [str(TICKS)], "markers": ["0"]}


def test_a_session_without_a_device_has_its_markers_in_xdf(study, tmp_path):
    report = export_study(study, tmp_path / "out", "xdf")
    code = study.codes()[1]
    (markers,), _ = pyxdf.load_xdf(str(tmp_path / "out" / f"{code}_markers.xdf"))
    assert len(markers["time_series"]) == 13  # no beginnings, for it is scripted
    assert markers["time_series"][-1] == ["session end"]
    assert any(code in notice and "no record" in notice for notice in report["remarks"])


def test_texts_of_any_language_survive_xdf(tmp_path):
    path = tmp_path / "a.xdf"
    samples = [(1.0, "d\u00e9but"), (1.5, "<&> \u2603"), (9.0, "x" * 300)]
    with path.open("wb") as out:
        writer = XdfWriter(out, "a", 0.0)
        writer.begin_stream(1, "a<b", "Markers", [("m", "M", "n/a")], 0.0, is_text=True)
        writer.texts(1, samples)
        writer.end_stream(1, 1.0, 9.0, 3)
    (stream,), _ = pyxdf.load_xdf(str(path), dejitter_timestamps=False)
    assert stream["info"]["name"] == ["a<b"]
    assert [row[0] for row in stream["time_series"]] == [text for _, text in samples]
    assert stream["time_stamps"].tolist() == [at for at, _ in samples]


def test_bids_has_what_the_specification_requires(study, tmp_path):
    export_study(study, tmp_path / "out", "bids")
    out, code = tmp_path / "out", study.codes()[0]
    description = json.loads((out / "dataset_description.json").read_text())
    assert {"Name", "BIDSVersion"} <= description.keys()
    people = table(out / "participants.tsv", "\t")
    assert {row["participant_id"] for row in people} == {
        f"sub-{code}" for code in study.codes()
    }
    assert people[0]["used_device_before"] == "n/a"
    beh = table(out / f"sub-{code}" / "beh" / f"sub-{code}_task-qoe_beh.tsv", "\t")
    assert len(beh) == 12
    assert {row["realism"] for row in beh} == {"3"}
    base = out / f"sub-{code}" / "motion" / f"sub-{code}_task-qoe_tracksys-falcon_run-1"
    channels = table(Path(f"{base}_channels.tsv"), "\t")
    assert list(channels[0])[:5] == [
        "name",
        "component",
        "type",
        "tracked_point",
        "units",
    ]
    kinds = {"LATENCY", "MISC", "POS"}
    assert {row["type"] for row in channels} == kinds
    lines = Path(f"{base}_motion.tsv").read_text().splitlines()
    assert len(lines) == TICKS
    assert all(len(line.split("\t")) == len(channels) for line in lines[:50])
    first = lines[0].split("\t")
    assert float(first[0]) == 0.0
    assert lines[7].split("\t")[4] == "n/a"
    sidecar = json.loads(Path(f"{base}_motion.json").read_text())
    assert sidecar["SamplingFrequency"] == 1000
    assert sidecar["TaskName"] == "qoe"
    assert sidecar["SamplingFrequencyEffective"] == pytest.approx(1000.0, abs=0.01)
    assert sidecar["MotionChannelCount"] == len(channels)


@pytest.mark.parametrize("form", ["csv", "bids"])
def test_the_measured_force_is_a_column_of_each_trial(tmp_path, manual_clock, form):
    made = create_study(tmp_path / "study")
    session = recorded_session(made, manual_clock)
    export_study(open_study(made.folder), tmp_path / "out", form)
    name, mark = ("trials.csv", ",") if form == "csv" else ("sub-*/beh/*.tsv", "\t")
    (path,) = (tmp_path / "out").glob(name)
    same, half, unknown = table(path, mark)
    assert float(same["force_error"]) < 1e-5
    assert float(half["force_error"]) == pytest.approx(0.5, rel=1e-3)
    # half of the RMS of a sine of 2 N; 1 Hz counts 0.9
    assert float(half["force_error_n"]) == pytest.approx(0.64, abs=0.01)
    assert (same["reach_m"], same["faded_s"], same["force_is_off"]) == (
        *("0.02", "0.0", "false"),
    )
    # short by more than 0.05 N of a sine of 1 N
    short_s = 20.0 * (1.0 - 2.0 / np.pi * np.arcsin(0.05))
    assert float(half["faded_s"]) == pytest.approx(short_s, abs=0.1)
    assert half["force_is_off"] == "true"
    left = "" if form == "csv" else "n/a"
    assert {unknown[n] for n in ("force_error", "reach_m", "force_is_off")} == {left}
    assert session.plan.order[1].feedback == half["feedback"]


def test_the_dictionary_says_what_each_feedback_is(tmp_path, manual_clock):
    late = {"key": "late", "condition": "delayed", "parameters": {"delay_s": 0.2}}
    made = create_study(tmp_path / "study")
    content = {**json.loads(made.content), "feedbacks": ["none", late]}
    recorded_session(change_definition(made, content), manual_clock)
    made = open_study(made.folder)
    export_study(made, tmp_path / "csv", "csv")
    rows = table(tmp_path / "csv" / "data_dictionary.csv")
    (found,) = (
        row["unit_or_levels"]
        for row in rows
        if (row["file"], row["column"]) == ("trials.csv", "feedback")
    )
    assert "late: delayed: the realistic force, later" in found
    assert "(delay_s 0.2)" in found
    assert {r["feedback"] for r in table(tmp_path / "csv" / "ratings.csv")} == {
        *("none", "late"),
    }
    export_study(made, tmp_path / "bids", "bids")
    sidecar = json.loads((tmp_path / "bids" / "task-qoe_beh.json").read_text())
    assert "delay_s 0.2" in sidecar["feedback"]["Levels"]["late"]
    assert sidecar["force_error_n"]["Units"] == "N"


def test_a_dataset_says_who_is_simulated(study, tmp_path, manual_clock):
    recorded_session(study, manual_clock)
    export_study(open_study(study.folder), tmp_path / "out", "bids")
    readme = (tmp_path / "out" / "README").read_text()
    assert "Partly simulated data: 2 of 3 participants" in readme


@pytest.mark.parametrize("has_record", [True, False])
def test_the_bids_readme_describes_what_is_there(study, tmp_path, has_record):
    if not has_record:
        next(study.folder.rglob("*.hprec")).unlink()
    out = tmp_path / "out"
    export_study(study, out, "bids")
    readme = (out / "README").read_text()
    listed = re.findall(r"^- (\S+): .+", readme, re.MULTILINE)
    described = {path for pattern in listed for path in out.glob(pattern)}
    assert described == set(out.rglob("*.tsv"))
    assert all(any(out.glob(pattern)) for pattern in listed)
    for word in ("force_x", "1 kHz"):
        assert (word in readme) is has_record


def test_markers_of_a_changed_force_name_delay_and_gain(tmp_path, manual_clock):
    made = create_study(tmp_path / "study", "consistency")
    write_scripted_session(
        made, {}, lambda _c: {"consistent": True}, manual_clock, origin={"test": True}
    )
    export_study(open_study(made.folder), tmp_path / "out", "xdf")
    (file,) = (tmp_path / "out").glob("*.xdf")
    (markers,), _ = pyxdf.load_xdf(str(file))
    ends = [text.split() for (text,) in markers["time_series"] if "trial" in text]
    assert len({key for _, _, key in ends}) == len(ends)


@pytest.mark.parametrize("form", ["bids", "xdf"])
def test_ticks_that_no_device_has_are_left_out(study, tmp_path, form, manual_clock):
    path = next(study.folder.rglob("*.hprec"))
    write_ticks(path, manual_clock.now_s() - 1.0, is_odd=True)
    report = export_study(study, tmp_path / "out", form)
    assert "ticks-01.hprec: 6 ticks have times or values" in str(report)
    if form == "xdf":
        file = next((tmp_path / "out").glob("*_run-1.xdf"))
        stamps = pyxdf.load_xdf(str(file), dejitter_timestamps=False)[0][0]
        assert np.ptp(stamps["time_stamps"]) == pytest.approx(3.997, abs=1e-6)
    else:
        lines = next((tmp_path / "out").rglob("*_motion.tsv")).read_text().splitlines()
        assert len(lines) == TICKS - 6
        assert max(map(len, lines)) < 120


# what only those who publish the data can fill in
LEFT_TO_PEOPLE = {
    *("Authors", "License", "SourceDatasets", "HEDVersion", "CogAtlasID", "CogPOID"),
    *("InstitutionName", "InstitutionAddress", "InstitutionalDepartmentName"),
    *("DeviceSerialNumber", "SubjectArtefactDescription"),
}


def test_the_official_validator_finds_no_error(study, tmp_path):
    export_study(study, tmp_path / "out", "bids")
    report = validated(tmp_path / "out")
    issues = report["issues"]["issues"]
    assert "error" not in {i["severity"] for i in issues}
    assert set(report["summary"]["modalities"]) == {"motion", "beh"}
    left = {i.get("subCode") for i in issues if i["code"].endswith("_RECOMMENDED")}
    assert left <= LEFT_TO_PEOPLE
    others = {i["code"] for i in issues if not i["code"].endswith("_RECOMMENDED")}
    assert others <= {"TOO_FEW_AUTHORS", "NO_AUTHORS"}


def test_every_kind_of_answer_is_valid_bids(tmp_path, capsys):
    made = create_study(tmp_path / "study")
    made = change_definition(made, with_every_kind(json.loads(made.content)))
    assert cli.main(["study", "simulate", str(made.folder), "--participants=2"]) == 0
    export_study(open_study(made.folder), tmp_path / "out", "bids")
    assert errors_in(tmp_path / "out") == []
    sidecar = json.loads((tmp_path / "out" / "participants.json").read_text())
    assert sidecar["number_before"]["Units"] == "kg"
    assert sidecar["scale_after"]["Levels"]["-3"] == "bad en"
    assert sidecar["scale_after"]["Levels"]["1"] == "1"
    assert "from 0 to 100" in sidecar["visual_before"]["Description"]
    assert sidecar["choices_before.air"]["Levels"] == {"true": "yes", "false": "no"}
    trials = json.loads((tmp_path / "out" / "task-qoe_beh.json").read_text())
    assert trials["choice_after-clip"]["Levels"] == {"car": "car en", "bike": "bike en"}


def test_the_official_validator_finds_no_error_without_device(study, tmp_path):
    next(study.folder.rglob("*.hprec")).unlink()
    export_study(study, tmp_path / "out", "bids")
    assert errors_in(tmp_path / "out") == []


def test_simulated_participants_and_answer_times_are_exported(
    study, tmp_path, manual_clock
):
    session = begin_session(study, "en", {}, manual_clock)
    journal = Journal(session.folder / "answers.jsonl", manual_clock)
    condition = describe(session.plan.order[0])
    trial = {"step": "trial-01", "attempt": 1, "condition": condition}
    journal.append("begin", program="hapticplayer", step="consent")
    journal.append("trial", **trial, is_valid=True, reasons=[], playback={})
    journal.append("answers", **trial, page="rating", values=VALUES, response_s=4.25)
    journal.close()
    export_study(study, tmp_path / "csv", "csv")
    people = table(tmp_path / "csv" / "participants.csv")
    real = {p["participant"]: (p["simulated"], p["complete"]) for p in people}
    assert real.pop(session.code) == ("false", "false")
    assert set(real.values()) == {("true", "true")}
    times = {
        row["response_s"]
        for row in table(tmp_path / "csv" / "trials.csv")
        if row["participant"] == session.code
    }
    assert times == {"4.25"}
    export_study(study, tmp_path / "bids", "bids")
    (beh,) = (tmp_path / "bids").rglob(f"sub-{session.code}*_beh.tsv")
    assert [row["response_time"] for row in table(beh, "\t")] == ["4.25"]
    people = table(tmp_path / "bids" / "participants.tsv", "\t")
    assert {p["simulated"] for p in people} == {"true", "false"}


def test_an_export_is_private_as_the_study_is(study, tmp_path):
    for form in ("csv", "bids", "xdf"):
        export_study(study, tmp_path / form, form)
        for path in (tmp_path / form, *(tmp_path / form).rglob("*")):
            mode = stat.S_IMODE(path.stat().st_mode)
            assert mode == (0o700 if path.is_dir() else 0o600), path


def test_no_dataset_tells_the_days_on_which_people_came(study, tmp_path):
    export_study(study, tmp_path / "out", "bids")
    days = {
        record.utc[:10]
        for session in open_study(study.folder).sessions()[0]
        for record in session.records.intact
    }
    (scans,) = (tmp_path / "out").rglob("*_scans.tsv")
    (row,) = table(scans, "\t")
    assert row["acq_time"] == "1925-01-01T00:00:00.000000Z"
    for path in (tmp_path / "out").rglob("*.*"):
        if path.is_file():
            assert not [day for day in days if day.encode() in path.read_bytes()], path


def test_a_study_without_answers_is_not_exported(tmp_path):
    made = create_study(tmp_path / "study")
    for form in ("csv", "bids", "xdf"):
        with pytest.raises(StudyError, match="no answers"):
            export_study(made, tmp_path / form, form)
        assert not (tmp_path / form).exists()


def test_the_official_validator_would_find_an_error(study, tmp_path):
    export_study(study, tmp_path / "out", "bids")
    next((tmp_path / "out").rglob("*_channels.tsv")).unlink()
    assert errors_in(tmp_path / "out")


def test_an_export_is_whole_or_not_there(study, tmp_path):
    with pytest.raises(UsageError):
        export_study(study, tmp_path / "out", "spss")
    assert not (tmp_path / "out").exists()
    export_study(study, tmp_path / "out", "csv")
    with pytest.raises(InputError, match="already exists"):
        export_study(study, tmp_path / "out", "csv")


def test_exporting_twice_gives_the_same_bytes(study, tmp_path):
    for form in ("csv", "xdf", "bids"):
        for name in ("a", "b"):
            export_study(study, tmp_path / form / name, form)
        for path in (tmp_path / form / "a").rglob("*.*"):
            other = tmp_path / form / "b" / path.relative_to(tmp_path / form / "a")
            assert path.read_bytes() == other.read_bytes()


def test_an_exporter_in_the_registry_can_be_chosen(
    study, tmp_path, monkeypatch, capsys
):
    def write(data, folder):
        text = " ".join(one.code for one in data.answers.participants)
        (folder / "codes.txt").write_text(text)

    dummy = Exporter("dummy", "a list of codes", write)
    known = (*study_export.EXPORTERS, dummy)
    monkeypatch.setattr(study_export, "EXPORTERS", known)
    assert cli.main(["study", "export", "--help"]) == 0
    assert "dummy: a list of codes" in " ".join(capsys.readouterr().out.split())
    out = str(tmp_path / "out")
    arguments = ["study", "export", str(study.folder), "-o", out, "--format", "dummy"]
    assert cli.main(arguments) == 0
    codes = (tmp_path / "out" / "codes.txt").read_text().split()
    assert sorted(codes) == study.codes()


def test_runs_keep_their_order_when_the_wall_clock_is_put_back():
    noon = dt.datetime(2026, 11, 27, 12, tzinfo=dt.UTC)
    runs = [(900.0, noon), (960.0, noon - dt.timedelta(hours=1))]
    runs += [(5.0, noon - dt.timedelta(minutes=50))]  # the machine was started again
    begins = [one.isoformat()[:19] for one in begins_of(runs)]
    assert begins == [f"1925-01-01T00:{at}" for at in ("00:00", "01:00", "11:00")]
