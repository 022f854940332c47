"""File names are bytes: those that are no UTF-8 are carried, shown and stored."""

import io
import json
import os
import shutil
from contextlib import redirect_stderr, redirect_stdout

import pytest

from hapticplayer import cli
from hapticplayer.capture.si_csv import write_imu_csv
from tests.e2e.command import in_process

STRICT = {"PYTHONIOENCODING": "utf-8:strict", "LC_ALL": "C.UTF-8"}


def named(text):
    return os.fsdecode(text.encode() + b" \xe9\xff")


def done(*arguments):
    """Run a command here, whose words have to be UTF-8."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", "strict") for _ in "oe")
    with redirect_stdout(out), redirect_stderr(err):
        status = cli.main(list(map(str, arguments)))
    for stream in (out, err):
        stream.flush()
    out, err = (stream.buffer.getvalue().decode() for stream in (out, err))
    assert (status, "Traceback" in err) == (0, False), err
    return out


@pytest.fixture
def ride(clip, still_log, tmp_path):
    video, log = tmp_path / (named("ride") + ".mp4"), tmp_path / (named("log") + ".csv")
    shutil.copyfile(clip, video)
    write_imu_csv(log, still_log)
    return video, log


def test_a_clip_and_a_log_are_imported_and_play(ride, tmp_path):
    video, log = ride
    folder, said = tmp_path / named("sequence"), tmp_path / named("said")
    report = done("import", video, "--imu", log, "--offset", "0", "--json",
                  "--read-as", "axes=x,y,z", "-o", folder)  # fmt: skip
    assert json.loads(report)["title"] == video.stem
    stored = json.loads((folder / "sequence.json").read_bytes().decode("utf-8"))
    assert stored["provenance"]["video"] == video.name
    done("play", folder, "--headless", "--device", "none", "--duration", "0.2",
         "--feedback", "none", "--log", said)  # fmt: skip
    lines = [json.loads(line) for line in said.read_bytes().splitlines()]
    assert (lines[0]["title"], lines[-1]["kind"]) == (video.stem, "summary")


def test_a_clip_plays_to_the_end_of_its_log(ride, tmp_path):
    said = tmp_path / "log.jsonl"
    found = in_process("play", ride[0], "--headless", "--device", "none",
                       "--duration", "0.2", "--log", said, env=STRICT)  # fmt: skip
    assert (found.returncode, "Traceback" in found.stderr) == (0, False), found.stderr
    lines = [json.loads(line) for line in said.read_bytes().splitlines()]
    assert (lines[0]["clip"], lines[-1]["kind"]) == (ride[0].name, "summary")


def test_recordings_are_reported(ride, tmp_path):
    video, log = ride
    report = json.loads(done("process", log, "--json", "--plot", tmp_path / "plot.svg"))
    assert report["recording"]["source"] == log.name
    done("process", log)
    done("sync", video, "--imu", log, "--offset", "0")


def test_a_study_is_made_analysed_and_exported(tmp_path):
    study, other = tmp_path / named("study"), tmp_path / named("other")
    done("study", "new", other, "--sequence", f"bike={tmp_path / named('bike')}")
    stored = json.loads((other / "study.json").read_bytes().decode("utf-8"))
    assert stored["sequences"][0]["folder"] == str(tmp_path / named("bike"))
    done("study", "status", other)
    done("study", "simulate", study, "--participants", "4")
    done("study", "analyse", study, "--output", tmp_path / named("report"))
    assert (tmp_path / named("report") / "report.pdf").stat().st_size
    done("study", "export", study, "-o", tmp_path / named("csv"))
    done(
        "study", "delete-participant", study, next((study / "sessions").iterdir()).name
    )
