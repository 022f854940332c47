"""A session on two screens with the simulated Falcon, to valid BIDS and XDF files."""

import csv
import json
import os
import subprocess
import sys

import numpy as np
import pytest
import pyxdf

from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.record_reader import read_record
from hapticplayer.playback.source import open_source
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.study_folder import open_study
from tests.bids import errors_in
from tests.e2e.command import ROOT, hapticplayer, report_of
from tests.material.shaken import write_shaken_sequence

CLIP_S = 2.0
SHAKES_HZ = {"bike": 2.0, "horse": 3.0}
FEEDBACKS = ("realistic", "none")
FACTORS = ("realism", "sensory", "comfort", "satisfaction")
TRIALS = {
    f"trial-{number:02d}": dict(zip(FACTORS, digits, strict=True))
    for number, digits in enumerate(
        [(1, 2, 3, 4), (5, 4, 3, 2), (2, 2, 5, 1), (4, 1, 1, 5)], 1
    )
}
SHEET = {"age": 28, "gender": "other", "handedness": "left", "used_device_before": True}


@pytest.fixture
def study(clip, tmp_path):
    """Two sequences, with and without force; any machine is good enough."""
    made = create_study(tmp_path / "study")
    content = json.loads(made.content)
    content["sequences"] = [
        {
            **entry,
            "folder": str(write_shaken_sequence(clip, tmp_path / key, shake_hz=hz)),
        }
        for entry in content["sequences"]
        for key, hz in SHAKES_HZ.items()
        if entry["key"] == key
    ]
    content["feedbacks"] = list(FEEDBACKS)
    content["checks"].update(sound=False, disk_free_mb=1)
    return change_definition(made, content)


def run_session(study, tmp_path, **more):
    """Run a participant to the end; return what was on the screens, page by page."""
    answers = tmp_path / "answers.json"
    answers.write_text(json.dumps({"sheet": SHEET, **TRIALS, **more}))
    script = [sys.executable, "-m", "tests.e2e.scripted_participant", str(answers)]
    command = ["study", "run", str(study.folder), "--device", "simulated"]
    done = subprocess.run(
        [*script, *command, "--language", "en"],
        env={
            **os.environ,
            "XDG_CONFIG_HOME": str(tmp_path / "config"),
            "XDG_CACHE_HOME": str(tmp_path / "cache"),
        },
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    opened, *said = done.stdout.splitlines()
    assert opened == "the session is open"  # the window that starts it waits for this
    return [json.loads(line) for line in said]


def export(study, form, target):
    return report_of(
        hapticplayer(
            *("study", "export", study.folder, "-o", target),
            *("--format", form, "--json"),
        )
    )


def table(path):
    return list(csv.DictReader(path.read_text().splitlines(), delimiter="\t"))


def check_screens(shown):
    """The participant had one screen as a whole, the operator was on the other."""
    steps = [one["step"] for one in shown]
    assert steps.count("clip") == len(TRIALS)
    for one in shown:
        assert len(one["screens"]) == 2
        assert one["is_fullscreen"]
        assert one["participant"] in one["screens"]
        (theirs,) = [s for s in one["screens"] if s != one["participant"]]
        assert theirs[0] <= one["operator"][0] < theirs[0] + theirs[2]


def check_bids(out, ticks, code):
    assert errors_in(out) == []
    (motion,) = out.rglob("*_motion.tsv")
    values = np.loadtxt(motion)
    names = [row["name"] for row in table(next(out.rglob("*_channels.tsv")))]
    assert values.shape == (len(ticks), len(names))
    columns = dict(zip(names, values.T, strict=True))
    begun_s = ticks["monotonic_s"][0]
    assert columns["latency"] == pytest.approx(ticks["monotonic_s"] - begun_s, abs=1e-6)
    for place, axis in enumerate("xyz"):
        for name, field in (("force", "force_n"), ("grip", "position_m")):
            given = columns[f"{name}_{axis}"]
            assert given == pytest.approx(ticks[field][:, place], abs=6e-5)
    answered = table(next(out.rglob("*_beh.tsv")))
    assert [
        {factor: int(row[factor]) for factor in FACTORS} for row in answered
    ] == list(TRIALS.values())
    for row in answered:
        assert 0.0 < float(row["reach_m"]) < 0.04
        assert float(row["faded_s"]) > 0.19  # the entry, which a busy machine repeats
        if row["feedback"] == "none":
            assert row["force_error"] == "n/a"
        else:  # a tenth of the clip is the entry
            assert 0.0 < float(row["force_error"]) < 1.0
    (person,) = table(out / "participants.tsv")
    assert person["participant_id"] == f"sub-{code}"
    assert (person["age"], person["handedness"]) == ("28", "left")
    assert person["simulated"] == "false"


def check_xdf(out, ticks):
    """The file has every tick; return when each trial began and ended, by its marker."""
    (file,) = out.iterdir()
    streams, _ = pyxdf.load_xdf(str(file), dejitter_timestamps=False)
    by_name = {stream["info"]["name"][0]: stream for stream in streams}
    device, markers = by_name["device"], by_name["markers"]
    assert device["time_stamps"] == pytest.approx(ticks["monotonic_s"], abs=1e-9)
    assert device["time_series"][:, 3:6] == pytest.approx(ticks["force_n"])
    return {
        text: time_s
        for (text,), time_s in zip(
            markers["time_series"], markers["time_stamps"], strict=True
        )
    }


def check_playback(ticks, marked_s, session):
    """Each clip was played to its end, with the force of the condition in the marker."""
    folders = {one.key: one.folder for one in session.definition.sequences}
    time_s = ticks["monotonic_s"]
    for number, condition in enumerate(session.plan.order, 1):
        key = f"{condition.sequence}/{condition.feedback}"
        begin_s = marked_s[f"trial-{number:02d} begin {key}"]
        end_s = marked_s[f"trial-{number:02d} end {key}"]
        played = ticks[(time_s > begin_s) & (time_s < end_s)]
        assert np.nanmax(played["media_s"]) > CLIP_S - 0.2
        if condition.feedback == "none":
            assert not np.any(played["planned_n"])
            continue
        assert np.any(played["force_n"])
        follows = played[played["mode"] == Mode.FOLLOWING]
        assert len(follows)
        track = open_source(folders[condition.sequence]).tracks["realistic"]
        for place in range(3):
            track_n = np.interp(
                follows["media_s"], track.time_s, track.force_n[:, place]
            )
            assert follows["planned_n"][:, place] == pytest.approx(track_n, abs=1e-4)


@pytest.mark.realtime
def test_a_session_on_two_screens_becomes_valid_data(study, tmp_path):
    check_screens(run_session(study, tmp_path))
    study = open_study(study.folder)
    (code,) = study.codes()
    session = study.session(code)
    record = read_record(session.folder / "ticks-01.hprec")
    assert record.is_complete, record.notice
    for form in ("bids", "xdf"):
        report = export(study, form, tmp_path / form)
        assert (report["participants"], report["remarks"]) == (1, [])
    check_bids(tmp_path / "bids", record.ticks, code)
    marked_s = check_xdf(tmp_path / "xdf", record.ticks)
    check_playback(record.ticks, marked_s, session)


@pytest.mark.realtime
def test_a_stopped_session_has_no_force_until_it_is_resumed(study, tmp_path):
    content = json.loads(study.content)
    content["sequences"] = content["sequences"][:1]
    study = change_definition(study, content)
    said = run_session(study, tmp_path, stop={})
    (stopped_s,) = [one["stopped"] for one in said if "stopped" in one]
    resumed_s = min(
        one["resumed"] for one in said if one.get("resumed", 0.0) > stopped_s
    )
    (code,) = open_study(study.folder).codes()
    ticks = read_record(study.session(code).folder / "ticks-01.hprec").ticks
    time_s, is_felt = ticks["monotonic_s"], ticks["force_n"].any(axis=1)
    assert is_felt[time_s < stopped_s].any()
    is_tripped = (time_s > stopped_s) & (ticks["mode"] == Mode.TRIPPED)
    tripped_s = time_s[is_tripped][0]
    held = (time_s >= tripped_s) & (time_s < resumed_s)
    assert resumed_s - tripped_s > 0.5
    assert is_tripped[held].all()
    assert not is_felt[held].any()
    assert is_felt[time_s > resumed_s].any()
    assert said[-1]["step"] == "end"
