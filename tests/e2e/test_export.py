"""`play --record` and `export`, as a user runs them."""

import csv
import os
import signal
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.haptics.record_reader import read_record
from hapticplayer.haptics.records import (
    MAX_FRAME_TICKS,
    encode_frame,
    encode_header,
)
from hapticplayer.haptics.shared import TICK
from hapticplayer.linux import SWITCH
from tests.e2e.command import (
    ROOT,
    forces_of,
    hapticplayer,
    in_process,
    read_log,
    refused,
    report_of,
    started,
)
from tests.needed_extras import needs

pytestmark = needs("records")

HEADER = {
    "device": "simulated",
    "modes": {"0": "idle", "2": "following"},
    "causes": {"0": "none"},
}


def some_ticks(count):
    ticks = np.zeros(count, dtype=TICK)
    ticks["monotonic_s"] = 100.0 + np.arange(count) * 1e-3
    ticks["force_n"] = np.random.default_rng(4).standard_normal((count, 3))
    ticks["mode"] = 2
    return ticks


def write_record(path, ticks, *, lost=0, is_ended=True):
    parts = [encode_header(HEADER)]
    parts += [
        encode_frame(first, 0, ticks[first : first + 50])
        for first in range(0, len(ticks), 50)
    ]
    if is_ended:
        parts.append(encode_frame(len(ticks) + lost, lost, ticks[:0]))
    path.write_bytes(b"".join(parts))
    return path


@pytest.fixture
def record(tmp_path):
    return write_record(tmp_path / "ride.record", some_ticks(20_000), lost=5)


@pytest.fixture
def long_record(tmp_path):
    """Half an hour: one frame again and again, which is quick to write."""
    ticks, path = some_ticks(MAX_FRAME_TICKS), tmp_path / "long.record"
    with path.open("wb") as file:
        file.write(encode_header(HEADER))
        for k in range(55):
            file.write(encode_frame(k * len(ticks), 0, ticks))
    yield path
    path.unlink()


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_all_ticks_become_lines(record, tmp_path):
    target = tmp_path / "ride.csv"
    done = hapticplayer("export", record, "-o", target, "--format", "csv")
    assert done.returncode == 0, done.stderr
    assert "20000 ticks in 20.0 s, 5 lost" in done.stdout
    rows = rows_of(target)
    expected = some_ticks(20_000)
    force = np.array([[row[f"force_f{axis}_n"] for axis in "xyz"] for row in rows])
    assert np.abs(force.astype(float) - expected["force_n"]).max() <= 0.51e-6
    times = np.array([row["monotonic_s"] for row in rows], dtype=float)
    assert np.abs(times - expected["monotonic_s"]).max() <= 1e-9
    assert [int(row["tick"]) for row in rows] == list(range(20_000))
    assert {(row["mode"], row["cause"]) for row in rows} == {("following", "none")}


def test_the_report_says_what_is_in_it(record, tmp_path):
    report = report_of(
        hapticplayer("export", record, "-o", tmp_path / "x.csv", "--json")
    )
    assert report["ticks"] == 20_000
    assert report["lost"] == 5
    assert report["is_complete"] is True
    assert report["duration_s"] == pytest.approx(19.999)
    assert report["header"] == HEADER
    with (tmp_path / "x.csv").open() as file:
        assert file.readline().rstrip().split(",") == report["columns"]


def test_a_record_that_a_crash_cut_off_is_converted_with_a_note(tmp_path):
    path = write_record(tmp_path / "ride", some_ticks(500), is_ended=False)
    os.truncate(path, path.stat().st_size - 1)
    done = hapticplayer("export", path, "-o", tmp_path / "ride.csv")
    assert done.returncode == 0
    assert "note:" in done.stderr
    assert "truncated" in done.stderr
    assert len(rows_of(tmp_path / "ride.csv")) == 450


def test_a_record_without_a_tick_is_a_table_without_a_row(tmp_path):
    path = write_record(tmp_path / "ride", some_ticks(0))
    done = hapticplayer("export", path, "-o", tmp_path / "ride.csv")
    assert done.returncode == 0, done.stderr
    assert rows_of(tmp_path / "ride.csv") == []


def test_lost_ticks_are_a_gap_in_the_numbers(tmp_path):
    ticks = some_ticks(6)
    path = tmp_path / "ride"
    path.write_bytes(
        encode_header(HEADER)
        + encode_frame(0, 0, ticks[:3])
        + encode_frame(10, 7, ticks[3:])
    )
    assert hapticplayer("export", path, "-o", tmp_path / "x.csv").returncode == 0
    numbers = [int(row["tick"]) for row in rows_of(tmp_path / "x.csv")]
    assert numbers == [0, 1, 2, 10, 11, 12]


@needs("formats")
def test_an_unknown_format_is_a_usage_error_with_choices(record, tmp_path):
    done = hapticplayer("export", record, "-o", tmp_path / "x", "--format", "hjif")
    assert done.returncode == 2
    assert "a record is not exported as hjif; choose one of csv" in done.stderr
    assert not (tmp_path / "x").exists()


def test_an_unconvertible_record_is_refused_and_leaves_no_file(record, tmp_path):
    (tmp_path / "dear.csv").write_text("dear")
    (tmp_path / "text").write_text("no record")
    before = sorted(tmp_path.iterdir())
    for source, target in (
        (record, "dear.csv"),
        (tmp_path / "text", "new.csv"),
        (tmp_path / "none", "new.csv"),
        (tmp_path, "new.csv"),
    ):
        refused(hapticplayer("export", source, "-o", tmp_path / target))
    assert sorted(tmp_path.iterdir()) == before
    assert (tmp_path / "dear.csv").read_text() == "dear"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_cancelled_it_leaves_nothing(long_record, tmp_path, number):
    with started("export", long_record, "-o", tmp_path / "out.csv") as process:
        assert process.stderr.readline() == "converting\n"
        process.send_signal(number)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 128 + number
    assert "no file was left half written" in said
    assert list(tmp_path.iterdir()) == [long_record]


def test_a_long_record_takes_less_memory_than_it_is_large(long_record, tmp_path):
    code = (  # getrusage would count what was there before the exec
        "import sys, app.__main__ as m\n"
        "status = m.main(sys.argv[1:])\n"
        "lines = open('/proc/self/status').read().splitlines()\n"
        "peak = [x for x in lines if x.startswith('VmHWM')][0].split()[1]\n"
        "print(status, peak)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "export", long_record, "-o", tmp_path / "x.csv"],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=True,
    )
    status, peak_kb = map(int, done.stdout.splitlines()[-1].split())
    (tmp_path / "x.csv").unlink()
    assert status == 0
    assert peak_kb * 1024 < 0.75 * long_record.stat().st_size


# --- recording --------------------------------------------------------------


@pytest.mark.realtime
def test_a_played_force_is_recorded_and_agrees_with_the_log(clip, tmp_path):
    force, record, log = (tmp_path / name for name in ("f.csv", "ride", "log"))
    force.write_text("time_s,fx_n,fy_n,fz_n\n0,0.5,-0.25,0\n")
    done = in_process(
        *("play", clip, "--headless", "--force", force),
        *("--record", record, "--log", log),
        env={SWITCH: "memfd,idle"},
    )
    assert done.returncode == 0, done.stderr
    recorded = read_record(record)
    assert recorded.is_complete
    assert recorded.lost == 0
    assert recorded.header["device"] == "simulated"
    lines = read_log(log)
    times_s, _, force_n = forces_of(lines)
    # the log begins a little later, and each of its ticks is in the record
    place = np.searchsorted(recorded.ticks["monotonic_s"], times_s - 2e-6)
    assert np.array_equal(np.diff(place), np.ones(len(place) - 1))
    assert np.abs(recorded.ticks["force_n"][place] - force_n).max() <= 0.51e-5
    assert np.abs(recorded.ticks["planned_n"][:, 0]).max() == 0.5
    assert recorded.header["scheduling"] == lines[-1]["scheduling"]
    assert recorded.header["without"] == lines[0]["without"] == ["idle", "memfd"]


def test_a_record_is_never_written_over(clip, tmp_path):
    (tmp_path / "ride").write_text("dear")
    done = hapticplayer("play", clip, "--headless", "--record", tmp_path / "ride")
    assert "already exists" in refused(done)
    assert (tmp_path / "ride").read_text() == "dear"


def test_a_record_needs_a_device(clip, tmp_path):
    record = ("--record", tmp_path / "ride", "--device", "none")
    done = hapticplayer("play", clip, "--headless", *record)
    assert "needs a device" in refused(done, 2)
    assert not (tmp_path / "ride").exists()
