"""What the version before wrote opens, and gives the same numbers."""

import csv
import json
import tarfile
from pathlib import Path

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.sequence import open_sequence

DATA = Path(__file__).parents[1] / "data" / "previous"
EXPECTED = json.loads((DATA / "expected.json").read_text(encoding="utf-8"))
# four ratings of each study were replaced by a repetition, which it did not count
for name in ("study", "study_complete_with_unsound"):
    EXPECTED[name]["missing"]["replaced_by_repetition"] = 4
# sentences for people may become better
WORDS = {"warnings", "remarks", "provenance", "population"}
# other resamples of the same distribution: sums of n integers, whose quantile may fall
# on the next one; none where all values are equal
RESAMPLED = {"mean_low", "mean_high"}
# by another method, which holds at -1 and 1; by all simulated deviances that are equal
REPLACED = {"rank_biserial_interval", "p_fit"}


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    folder = tmp_path_factory.mktemp("previous")
    # Debian 12 has Python 3.11.2, whose tarfile knows no filters yet
    options = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}
    for path in DATA.glob("*.tar.xz"):
        with tarfile.open(path) as archive:
            archive.extractall(folder, **options)
    return folder


@pytest.fixture
def report(capsys):
    """Run a command with --json and return its report."""

    def run(*arguments):
        assert cli.main([*map(str, arguments), "--json"]) == 0
        return json.loads(capsys.readouterr().out)

    return run


def check_same(found, expected, where=""):
    """Compare two reports; numbers may differ by rounding alone."""
    if isinstance(expected, dict):
        assert found.keys() - WORDS >= expected.keys() - WORDS, where
        for key in expected.keys() - WORDS - REPLACED - RESAMPLED:
            check_same(found[key], expected[key], f"{where}/{key}")
        for key in expected.keys() & RESAMPLED:
            if expected["low"] == expected["high"]:
                assert found[key] is None, where
            else:
                step = 1.01 / expected["n"]
                assert found[key] == pytest.approx(expected[key], abs=step), where
    elif isinstance(expected, list):
        assert len(found) == len(expected), where
        for place, (one, other) in enumerate(zip(found, expected, strict=True)):
            check_same(one, other, f"{where}/{place}")
    elif isinstance(expected, float):
        # a fit stops where a step gains nothing: processors end 1e-7 apart
        near = 1e-6 if "/curves/" in where else 1e-9
        assert found == pytest.approx(expected, rel=near, abs=1e-3 * near), where
    else:
        assert found == expected, where


@pytest.mark.parametrize(
    ("name", "study", "options"),
    [
        ("study", "study", []),
        (
            "study_complete_with_unsound",
            "study",
            ["--missing", "complete", "--with-unsound"],
        ),
        ("consistency", "consistency", []),
    ],
)
def test_analysis_gives_the_same_numbers(report, unpacked, name, study, options):
    found = report("study", "analyse", unpacked / study, *options)
    check_same(found, EXPECTED[name], name)
    assert len(found["warnings"]) == len(EXPECTED[name]["warnings"])


@pytest.mark.parametrize("name", ["study", "consistency"])
def test_status_is_the_same(report, unpacked, name):
    found = report("study", "status", unpacked / name)
    check_same(found, EXPECTED[f"{name}_status"], name)


def test_export_gives_the_same_tables(report, unpacked, tmp_path):
    report("study", "export", unpacked / "study", "-o", tmp_path / "out")
    for name in ("trials", "texts"):
        written = (tmp_path / "out" / f"{name}.csv").read_text(encoding="utf-8")
        found, expected = (
            list(csv.reader(text.splitlines()))
            for text in (written, EXPECTED[f"{name}_csv"])
        )
        # columns may be added at the end
        assert [row[: len(expected[0])] for row in found] == expected


@pytest.mark.parametrize("form", ["bids", "xdf"])
def test_records_of_the_device_are_exported(report, unpacked, tmp_path, form):
    found = report(
        "study", "export", unpacked / "study", "-o", tmp_path / form, "--format", form
    )
    suffix = {"bids": "_motion.tsv", "xdf": "_run-1.xdf"}[form]
    assert len([name for name in found["files"] if name.endswith(suffix)]) == 1


@pytest.mark.parametrize("pilot", [False, True])
def test_power_is_the_same(report, unpacked, pilot):
    options = ["--studies", "300", "--largest", "20", "--seed", "4"]
    if pilot:
        options += [str(unpacked / "study"), "--measure", "comfort"]
    found = report("study", "power", *options)
    check_same(found, EXPECTED["power_pilot" if pilot else "power"])


def test_sequence_opens_with_the_same_values(unpacked):
    expected = EXPECTED["sequence"]
    sequence = open_sequence(unpacked / "sequence")
    motion = sequence.motion
    found = {
        "title": sequence.title,
        "force_at_s": expected["force_at_s"],
        "force_n": {
            name: track.at(np.array(expected["force_at_s"])).tolist()
            for name, track in sequence.tracks.items()
        },
        "samples": len(motion.time_s),
        "acceleration_rms_mps2": np.sqrt(
            (motion.acceleration_mps2**2).mean(axis=0)
        ).tolist(),
        "gravity_mean_mps2": motion.gravity_mps2.mean(axis=0).tolist(),
        "quaternion_last_wxyz": motion.quaternion_wxyz[-1].tolist(),
    }
    check_same(found, expected)
