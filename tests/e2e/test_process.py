"""`process`, and what `import` does to the motion, as a user runs them."""

import json
import os
import pty
import signal
import subprocess
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from hapticplayer import motion
from hapticplayer.capture import read_recording
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.sequence.store import read_recorded
from tests.e2e.command import command_line, hapticplayer, refused, report_of, started
from tests.needed_extras import needs


@pytest.fixture(scope="module")
def ride():
    """A minute of somebody walking, with the truth."""
    from hapticplayer.extras.rides.motion_scenes import simulate_motion

    return simulate_motion("walk", 5)


@pytest.fixture(scope="module")
def log(ride, tmp_path_factory):
    path = tmp_path_factory.mktemp("log") / "walk.csv"
    write_imu_csv(path, ride.imu)
    return path


# --- the report -------------------------------------------------------------


def test_a_person_reads_what_was_found(log):
    done = hapticplayer("process", log)
    assert done.returncode == 0, done.stderr
    imu = read_recording(log).imu
    for words in (
        "walk.csv - CSV log",
        f"{len(imu)} samples in",
        f"at {imu.rate_hz:.2f} Hz, no gaps",
        "smoother, time constant",
        "how fast the recording moves",
        "gyro bias",
        "at the sensor's limit",
        "median sigma",
        "RMS",
    ):
        assert words in done.stdout
    assert "removing gravity" in done.stderr


def test_the_figures_agree_with_the_truth(log, ride):
    report = report_of(hapticplayer("process", log, "--json"))
    assert report["recording"]["samples"] == len(ride.imu)
    assert report["recording"]["rate_hz"] == pytest.approx(ride.imu.rate_hz, rel=1e-6)
    true = ride.truth_arrays()["acceleration_mps2"]
    rms_true = np.sqrt(np.mean(np.sum(true**2, axis=1)))
    # sensor noise and the error of the vertical add to it
    assert report["motion"]["rms_mps2"] == pytest.approx(rms_true, rel=0.05)
    expected = motion.analyse(read_recording(log).imu).summary
    for name in ("time_constant_s", "accelerometer_gain", "gravity_sigma_mps2"):
        assert report["gravity_removal"][name] == expected[name]


def test_a_part_is_estimated_on_the_whole_log(log):
    """Ten seconds alone would have another calibration, and other gravity."""
    part = ("--start", "20", "--duration", "10", "--compare", "--json")
    report = report_of(hapticplayer("process", log, *part))
    whole = report_of(hapticplayer("process", log, "--json"))
    found = report["gravity_removal"]["gyro_bias_radps"]
    assert found == whole["gravity_removal"]["gyro_bias_radps"]
    assert report["recording"]["duration_s"] == pytest.approx(10.0, abs=0.02)
    imu = read_recording(log).imu
    first, last = np.searchsorted(imu.time_s - imu.time_s[0], [20.0, 30.0])
    p = motion.remove_gravity(imu).acceleration_mps2[first:last]
    rms = float(np.sqrt(np.mean(np.square(p).sum(axis=1))))
    assert report["motion"]["rms_mps2"] == pytest.approx(rms)
    assert report["methods"][0]["rms_mps2"] == pytest.approx(rms)
    said = refused(hapticplayer("process", log, "--start", "500"), status=2)
    assert "there is no motion in this part of walk.csv" in said


def test_a_calibration_is_kept_and_given(log, tmp_path):
    kept = tmp_path / "phone.json"
    saved = hapticplayer(
        "process", log, "--mounting=-x,-y,z", "--save-calibration", kept
    )
    assert saved.returncode == 0, saved.stderr
    found = json.loads(kept.read_text())["gyro_bias_radps"]
    plain = report_of(hapticplayer("process", log, "--json"))["gravity_removal"]
    # in the recorder's own axes, whatever the mounting
    assert found == pytest.approx(plain["gyro_bias_radps"], abs=1e-4)
    for other in (("--method", "vqf"), ("--time-constant", "9")):
        done = hapticplayer("process", log, *other, "--save-calibration", f"{kept}2")
        assert "needs the method smoother" in refused(done, status=2)
    report = report_of(hapticplayer("process", log, "--calibration", kept, "--json"))
    after = report["gravity_removal"]["gyro_bias_radps"]
    assert after == pytest.approx(found, abs=1e-3)


def test_methods_stand_side_by_side(log):
    report = report_of(hapticplayer("process", log, "--compare", "--json"))
    rows = {row["method"]: row for row in report["methods"]}
    assert set(rows) == set(motion.METHODS)
    imu = read_recording(log).imu
    default, other = motion.remove_gravity(imu), motion.remove_gravity(imu, "vqf")
    apart = (default.gravity_mps2 - other.gravity_mps2)[default.valid & other.valid]
    expected = np.sqrt(np.mean(np.sum(apart**2, axis=1)))
    assert rows["vqf"]["difference_mps2"] == pytest.approx(expected)
    assert all(row["us_per_sample"] > 0.0 for row in rows.values())
    text = hapticplayer("process", log, "--compare", "--method", "lowpass").stdout
    table = text[text.index("us/sample") :].splitlines()
    assert [line.split()[0] for line in table[1:]] == list(rows)
    assert [line.split()[0] for line in table if " * " in line] == ["lowpass"]


def test_a_sequence_is_processed_by_its_samples(log, clip, tmp_path):
    folder = tmp_path / "walk"
    done = hapticplayer("import", clip, "--imu", log, "--offset", 0, "-o", folder)
    assert done.returncode == 0, done.stderr
    of_log = report_of(hapticplayer("process", log, "--json"))
    of_folder = report_of(hapticplayer("process", folder, "--json"))
    assert of_folder["gravity_removal"] == of_log["gravity_removal"]
    assert of_folder["recording"]["source"] == "walk.csv"


def test_a_camera_clip_is_processed(shared_data):
    karma = shared_data / "capture" / "gopro" / "karma.mp4"
    report = report_of(hapticplayer("process", karma, "--json"))
    assert report["recording"]["rate_hz"] == pytest.approx(198.6, abs=0.2)
    assert report["recording"]["gaps"] == 0
    assert 0.5 < report["motion"]["rms_mps2"] < 2.0


def test_conditioning_is_done_and_said(log):
    chosen = ("--remove-spikes", "--repair-clipping", "--average", 50, "--lowpass", 5)
    report = report_of(hapticplayer("process", log, *chosen, "--json"))
    words = [step.split()[0] for step in report["conditioning"]]
    assert words == ["spikes", "clipped", "averaged", "motion"]
    plain = report_of(hapticplayer("process", log, "--json"))
    assert report["motion"]["rms_mps2"] < plain["motion"]["rms_mps2"]


def test_a_terminal_sees_the_progress_and_a_pipe_only_the_report(log):
    leader, follower = pty.openpty()
    try:
        done = subprocess.run(
            command_line("process", log, "--json"),
            stdout=subprocess.PIPE,
            stderr=follower,
            timeout=300,
            check=True,
        )
        drawn = os.read(leader, 100_000).decode()
    finally:
        os.close(leader)
        os.close(follower)
    assert "#" in drawn
    assert "removing gravity: smoother" in drawn
    json.loads(done.stdout)


# --- the picture ------------------------------------------------------------


def test_a_picture_is_drawn_as_png(log, tmp_path):
    done = hapticplayer("process", log, "--plot", tmp_path / "new" / "walk.png")
    assert done.returncode == 0, done.stderr
    content = (tmp_path / "new" / "walk.png").read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


def test_the_same_recording_gives_the_same_svg(log, tmp_path):
    for name in ("a.svg", "b.svg"):
        done = hapticplayer("process", log, "--plot", tmp_path / name)
        assert done.returncode == 0, done.stderr
    first, second = ((tmp_path / name).read_bytes() for name in ("a.svg", "b.svg"))
    assert first == second
    assert ET.fromstring(first).tag.endswith("svg")
    for words in (b"gravity \xc2\xb1 sigma", b"motion p", b"walk.csv", b"z (up)"):
        assert words in first
    assert b"not valid" not in first


def test_invalid_samples_are_shaded(log, tmp_path):
    lines = log.read_text().splitlines()
    cells = lines[500].split(",")
    flawed, picture = tmp_path / "flawed.csv", tmp_path / "flawed.svg"
    lines[500] = ",".join([cells[0], "", "", "", *cells[4:]])
    flawed.write_text("\n".join(lines))
    done = hapticplayer("process", flawed, "--plot", picture)
    assert done.returncode == 0, done.stderr
    assert "first in line 501" in done.stdout
    assert b"not valid" in picture.read_bytes()


@pytest.mark.parametrize("kind", ["file", "dead link", "folder"])
def test_an_existing_file_is_not_drawn_over(log, tmp_path, kind):
    target = tmp_path / "mine.png"
    if kind == "file":
        target.write_text("mine")
    elif kind == "folder":
        target.mkdir()
    else:
        target.symlink_to(tmp_path / "nowhere")
    before = os.lstat(target)
    done = hapticplayer("process", log, "--plot", target)
    assert "already exists; choose another file" in refused(done)
    assert os.lstat(target).st_mtime_ns == before.st_mtime_ns
    assert "removing" not in done.stderr  # refused before the work


def test_a_picture_that_cannot_be_written_is_refused(log, tmp_path):
    (tmp_path / "file").write_text("mine")
    done = hapticplayer("process", log, "--plot", tmp_path / "file" / "a.png")
    assert "file" in refused(done)


# --- what is refused --------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--time-constant", "9", "--method", "vqf"), "method smoother"),
        (("--plot", "walk.pdf"), ".png or .svg"),
    ],
)
def test_wrong_usage_gets_one_sentence_and_status_2(log, arguments, words):
    assert words in refused(hapticplayer("process", log, *arguments), status=2)


@pytest.mark.parametrize(
    "arguments",
    [
        ("--method", "magic"),
        ("--time-constant", "0"),
        ("--average", "-3"),
        ("--lowpass", "nan"),
    ],
)
def test_impossible_options_have_status_2(log, arguments):
    done = hapticplayer("process", log, *arguments)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [(("--average", "5000"), "rate"), (("--lowpass", "5000"), "cutoff")],
)
def test_options_that_do_not_fit_the_recording_are_refused(log, arguments, words):
    assert words in refused(hapticplayer("process", log, *arguments))


@needs("frames")
def test_a_file_without_motion_is_refused(clip, tmp_path):
    assert "contains no motion data" in refused(hapticplayer("process", clip))
    assert "no such file" in refused(hapticplayer("process", tmp_path / "none.csv"))
    assert "sequence" in refused(hapticplayer("process", tmp_path))


def test_interrupting_leaves_nothing(log, tmp_path):
    process = started(
        *("process", log, "--method", "ekf", "--compare"),
        *("--plot", tmp_path / "walk.png"),
        stdout=subprocess.PIPE,
        env={**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")},
    )
    steps = [process.stderr.readline() for _ in range(2)]
    process.send_signal(signal.SIGTERM)
    said, rest = process.communicate(timeout=60)
    assert "removing" in steps[1]
    assert process.returncode == 128 + signal.SIGTERM
    assert said == ""
    assert "no file was left half written" in rest
    assert "Traceback" not in rest
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


# --- importing --------------------------------------------------------------


def test_an_import_takes_the_same_choices_and_records_them(log, clip, tmp_path):
    out = tmp_path / "out"
    done = hapticplayer(
        *("import", clip, "--imu", log, "--offset", 0, "-o", out, "--json"),
        *("--time-constant", 20, "--average", 50, "--lowpass", 8),
    )
    made_of = report_of(done)["provenance"]
    assert made_of["gravity_removal"] == "smoother"
    assert made_of["processing"]["average_hz"] == 50.0
    assert made_of["motion_summary"]["time_constant_from"] == "chosen by a person"
    assert made_of["conditioning"][-1] == "motion low-passed at 8 Hz, zero phase"
    with np.load(out / "motion.npz") as stored:
        assert 1.0 / np.median(np.diff(stored["time_s"])) == pytest.approx(50.0)
    assert read_recorded(out)[0].rate_hz == pytest.approx(
        read_recording(log).imu.rate_hz
    )


def test_an_import_by_another_method_says_so(log, clip, tmp_path):
    done = hapticplayer(
        *("import", clip, "--imu", log, "--offset", 0, "-o", tmp_path / "out"),
        *("--method", "offline-vqf"),
    )
    assert done.returncode == 0, done.stderr
    assert "gravity removed by offline-vqf" in done.stdout


def test_a_flawed_log_is_imported_with_its_flaws_marked(log, clip, tmp_path):
    lines = log.read_text().splitlines()
    flawed = tmp_path / "flawed.csv"
    for number in range(100, 130):  # 30 samples without a gyro
        lines[number] = ",".join([*lines[number].split(",")[:4], "nan", "", "nan"])
    lines[300], lines[301] = lines[301], lines[300]
    flawed.write_text("\n".join(lines))
    out = tmp_path / "out"
    done = hapticplayer(
        *("import", clip, "--imu", flawed, "--offset", 0, "-o", out, "--json")
    )
    notes = " ".join(report_of(done)["provenance"]["notes"])
    assert "swapped in time and put in order (first in line 301)" in notes
    assert "30 of" in notes
    assert "first in line 101" in notes
    assert "is not valid" in notes
    imu, _ = read_recorded(out)
    assert np.flatnonzero(~imu.valid).tolist() == list(range(99, 129))
    with np.load(out / "motion.npz") as stored:
        assert not stored["valid"][99:129].any()
