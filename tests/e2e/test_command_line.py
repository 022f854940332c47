"""The command line as a user runs it: a process, its status, its words, its files."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.cli import play
from hapticplayer.clock import SystemClock
from hapticplayer.devices import device_names
from hapticplayer.doctor import ROOT
from hapticplayer.linux import SWITCH
from hapticplayer.model import ImuLog
from hapticplayer.playback.log import PlaybackLog
from tests.e2e.command import (
    followed,
    forces_of,
    hapticplayer,
    in_process,
    played,
    read_log,
    refused,
    report_of,
    started,
)
from tests.needed_extras import needs

# --- what works -------------------------------------------------------------


def test_help_and_version_import_nothing_heavy():
    code = (
        "import sys, app.__main__ as m\n"
        "m.main(['--help'])\n"
        "print(sorted({'numpy', 'av', 'PySide6', 'scipy', 'vqf'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=True,
    )
    assert done.stdout.splitlines()[-1] == "[]"
    for command in ("play", "import", "process", "study", "device", "doctor"):
        assert command in done.stdout


@pytest.fixture(scope="module")
def demo_log(demo, tmp_path_factory):
    """Return the log of the demo's beginning."""
    log = tmp_path_factory.mktemp("log") / "log.jsonl"
    words = ("--start", 2, "--duration", 4.5)
    return played(log, demo, *words, follows_s=3.5)


@pytest.mark.realtime
def test_the_demo_plays_and_its_log_proves_it(demo_log):
    summary = demo_log[-1]
    assert [demo_log[0]["kind"], summary["kind"]] == ["header", "summary"]
    frames = [x for x in demo_log if x["kind"] == "frame"]
    assert summary["frames"]["shown"] == len(frames)
    times_s = [x["monotonic_s"] for x in demo_log if x["kind"] == "force"]
    assert np.all(np.diff(times_s) > 0)
    _, _, force = forces_of(demo_log)
    size = np.linalg.norm(force, axis=1)
    assert 0.05 < size.max() <= 4.5 + 1e-4
    assert size[-1] == 0.0
    change = np.linalg.norm(np.diff(force, axis=0), axis=1)
    periods = np.maximum(1.0, np.diff(times_s) / 1e-3)  # a busy machine may be late
    assert np.all((change <= 1.0 * periods + 0.01) | (size[1:] == 0.0))
    assert summary["scheduling"] in ("fifo", "slice", "normal")
    assert set(summary["lateness_us"]) == {"p50", "p99", "p999", "max"}


@pytest.mark.realtime
def test_up_pushes_up_and_forward_pulls_away_end_to_end(demo, demo_log):
    """The sign of each axis, from the simulated ride's truth to the logged force."""
    media, force = followed(demo_log)
    with np.load(demo / "truth.npz", allow_pickle=False) as truth:
        times, p = truth["time_s"], truth["acceleration_mps2"]
    moving = media > 2.5
    felt = {axis: force[moving, i] for i, axis in enumerate("xyz")}
    meant = {
        axis: np.interp(media[moving], times, p[:, i]) for i, axis in enumerate("xyz")
    }
    assert np.corrcoef(felt["x"], meant["x"])[0, 1] > 0.9  # right
    assert np.corrcoef(felt["y"], meant["z"])[0, 1] > 0.9  # up
    assert np.corrcoef(felt["z"], -meant["y"])[0, 1] > 0.9  # forward
    up = meant["z"] > 2.0
    forward = meant["y"] > 1.5
    assert up.any()
    assert np.median(felt["y"][up]) > 0.4
    assert forward.any()
    assert np.median(felt["z"][forward]) < -0.3


@pytest.mark.realtime
def test_the_real_clip_is_imported_and_played(shared_data, tmp_path):
    karma, target = shared_data / "capture" / "gopro" / "karma.mp4", tmp_path / "karma"
    report = report_of(hapticplayer("import", karma, "-o", target, "--json"))
    assert report["provenance"]["imu_rate_hz"] == pytest.approx(198.6, abs=0.2)
    assert set(report["feedbacks"]) == {"realistic", "none", "random"}
    lines = played(tmp_path / "log.jsonl", target, "--duration", 2)
    assert np.linalg.norm(followed(lines)[1], axis=1).max() > 0.2


@pytest.mark.realtime
def test_a_video_with_a_csv_log_is_imported_with_its_offset(clip, tmp_path, still_log):
    log, out = tmp_path / "log.csv", tmp_path / "out"
    write_imu_csv(log, still_log)
    options = ("--imu", log, "--offset", "-3.25", "-o", out, "--json")
    report = report_of(hapticplayer("import", clip, *options))
    assert report["clock_map"]["offset_s"] == -3.25
    assert not [note for note in report["provenance"]["notes"] if "offset" in note]
    media_s, felt = followed(played(tmp_path / "played.jsonl", out))
    with np.load(out / "force_realistic.npz") as stored:
        times, planned = stored["time_s"], stored["force_n"]
    meant = [np.interp(media_s, times, planned[:, axis]) for axis in range(3)]
    assert len(felt)
    assert np.allclose(felt, np.transpose(meant), atol=1e-4)


@pytest.mark.realtime
def test_any_video_plays_with_any_force_track_held_between_rows(clip, tmp_path):
    force = tmp_path / "force.csv"
    force.write_text("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n0.8,1.5,0,-0.5\n1.2,0,0,0\n")
    media_s, felt = followed(played(tmp_path / "log.jsonl", clip, "--force", force))
    held = felt[(media_s > 0.81) & (media_s < 1.19)]
    assert len(held)
    assert np.allclose(held, [1.5, 0.0, -0.5], atol=1e-4)
    assert not felt[media_s > 1.21].any()


@pytest.mark.realtime
def test_feedback_none_and_device_none(demo, tmp_path):
    log = tmp_path / "log.jsonl"
    arguments = ("play", demo, "--headless", "--duration", 0.5, "--log", log)
    assert in_process(*arguments, "--feedback", "none").returncode == 0
    assert not forces_of(read_log(log))[2].any()
    done = in_process(*arguments, "--device", "none", "--overwrite")
    assert done.returncode == 0, done.stderr
    assert not [x for x in read_log(log) if x["kind"] == "force"]


@pytest.mark.realtime
def test_without_a_display_the_demo_plays_headless(clip, monkeypatch):
    """Its clip is a shorter one here."""
    monkeypatch.setattr(play, "DEMO", clip)
    done = hapticplayer()
    assert done.returncode == 0, done.stderr
    assert "lateness" in done.stdout
    assert "force minus video" in done.stdout


def test_only_a_facility_can_be_taken_away():
    said = refused(hapticplayer("doctor", env={SWITCH: "memfd,gravity"}), 2)
    assert f"{SWITCH} names gravity" in said
    assert "robust-mutex" in said


def test_devices_and_doctor_report_as_json():
    listed = report_of(hapticplayer("device", "list", "--json"))
    names = [d["name"] for d in listed["devices"]]
    assert names == device_names()
    assert report_of(hapticplayer("doctor", "--json"))


@pytest.mark.realtime
def test_a_haptics_process_that_dies_is_told(demo, tmp_path):
    log = tmp_path / "log.jsonl"
    process = started("play", demo, "--headless", "--duration", 4, "--log", log)
    try:
        os.kill(child_of_a_playing(process, log), signal.SIGKILL)
        _, complaint = process.communicate(timeout=60)
    finally:
        process.kill()
        process.wait()
    assert process.returncode == 1
    assert "haptics process has ended" in complaint
    lost = [x for x in read_log(log) if x.get("name") == "device_lost"]
    assert "has ended" in lost[0]["problem"]


def child_of_a_playing(process, log):
    """Return the pid of the haptics process, once pictures are shown."""
    clock = SystemClock()
    while process.poll() is None and not (
        log.exists() and '"kind": "frame"' in log.read_text()
    ):
        clock.sleep_until(clock.now_s() + 0.02)
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    return next(
        int(child)
        for child in children.read_text().split()
        if "hapticplayer.haptics"
        in Path(f"/proc/{child}/cmdline").read_text().split("\0")
    )


def test_a_log_on_a_full_disk_is_told(clip, tmp_path, fill_disk, monkeypatch):
    def begun(*arguments, **options):
        fill_disk()
        return PlaybackLog(*arguments, **options)

    monkeypatch.setattr("hapticplayer.cli.play.PlaybackLog", begun)
    words = ("--headless", "--device", "none", "--duration", 0.5)
    done = hapticplayer("play", clip, *words, "--log", tmp_path / "log")
    assert "log is incomplete" in refused(done)


# --- what is refused --------------------------------------------------------


@pytest.fixture(scope="module")
def long_log(tmp_path_factory):
    """A log whose import takes a while."""
    path, count = tmp_path_factory.mktemp("long") / "big.csv", 200_000
    force = np.tile([0.0, 0.0, 9.81], (count, 1))
    write_imu_csv(path, ImuLog(np.arange(count) / 200.0, force, np.zeros((count, 3))))
    return path


def begun_import(clip, log, target, step):
    """Start an import and return it in one of its steps."""
    process = started("import", clip, "--imu", log, "--offset", "0", "-o", target)
    while not process.stderr.readline().startswith(step):
        assert process.poll() is None
    return process


@pytest.mark.parametrize(
    ("number", "step"),
    [
        (signal.SIGINT, "reading"),
        (signal.SIGTERM, "copying the clip"),
        (signal.SIGHUP, "copying the clip"),
        (signal.SIGQUIT, "reading"),
    ],
)
def test_interrupting_an_import_leaves_nothing(clip, long_log, tmp_path, number, step):
    process = begun_import(clip, long_log, tmp_path / "o", step)
    process.send_signal(number)
    rest = process.communicate(timeout=60)[1]
    assert process.returncode == 128 + number
    assert "no file was left half written" in rest
    assert "Traceback" not in rest
    assert list(tmp_path.iterdir()) == []


def test_an_import_tidies_up_after_one_that_was_killed(
    clip, long_log, still_log, tmp_path
):
    process = begun_import(clip, long_log, tmp_path / "o", "copying the clip")
    process.kill()
    process.communicate(timeout=60)
    assert len(list(tmp_path.iterdir())) == 1
    log, again = tmp_path / "short.csv", tmp_path / "again"
    write_imu_csv(log, still_log)
    report_of(
        hapticplayer("import", clip, "--imu", log, "--offset", 0, "-o", again, "--json")
    )
    assert sorted(tmp_path.iterdir()) == [again, log]


GOOD_ROW = "0.00,0,0,9.81,0,0,0\n0.01,0,0,9.81,0,0,0\n"
HEADER = "time_s,ax,ay,az,gx,gy,gz\n"


def still_rows(gravity, step_s):
    """Return the rows of a sensor at rest."""
    noise = np.random.default_rng(1).normal(0.0, 0.002, (1000, 6))
    noise[:, 2] += 1.0
    return "".join(
        f"{step_s * k:.3f}," + ",".join(f"{x:.5f}" for x in gravity * row) + "\n"
        for k, row in enumerate(noise)
    )


def bad_media(name, folder, clip):
    """Make one of the files that nobody should have to open."""
    path = folder / name
    whole = clip.read_bytes()
    if name == "folder.mp4":
        path.mkdir()
    elif name == "fifo.mp4":
        os.mkfifo(path)
    elif name != "missing.mp4":
        path.write_bytes(
            {
                "empty.mp4": b"",
                "random.mp4": np.random.default_rng(3).bytes(100_000),
                "truncated.mp4": whole[: len(whole) * 2 // 3],
                "headless.mp4": whole[:100],
                "playlist.mp4": b"#EXTM3U\n#EXT-X-TARGETDURATION:9\n#EXTINF:9,\n"
                b"http://127.0.0.1:9/a.ts\n",
                "concat.mp4": b"ffconcat version 1.0\nfile plain.mp4\n",
                "text.mp4": b"hello\n" * 100,
            }[name]
        )
    return path


@pytest.mark.parametrize(
    "name",
    [
        "missing.mp4",
        "folder.mp4",
        "fifo.mp4",
        "empty.mp4",
        "random.mp4",
        "truncated.mp4",
        "headless.mp4",
        "playlist.mp4",
        "concat.mp4",
        "text.mp4",
    ],
)
@pytest.mark.parametrize("command", ["play", "import"])
def test_bad_media_get_one_sentence(name, command, clip, tmp_path):
    path = bad_media(name, tmp_path, clip)
    before = sorted(tmp_path.iterdir())
    arguments = ["--headless"] if command == "play" else ["-o", tmp_path / "out"]
    sentence = refused(hapticplayer(command, path, *arguments))
    assert name.split(".")[0] in sentence
    assert sorted(tmp_path.iterdir()) == before


def test_a_video_without_telemetry_says_how_to_go_on(clip, tmp_path):
    sentence = refused(hapticplayer("import", clip, "-o", tmp_path / "out"))
    assert "--imu" in sentence
    assert not list(tmp_path.iterdir())


def test_time_lapse_telemetry_is_refused(shared_data, clip, tmp_path):
    path = shared_data / "capture" / "gopro" / "hero13_timelapse.bin"
    arguments = ("import", clip, "--imu", path, "-o", tmp_path / "out")
    assert "lapse" in refused(hapticplayer(*arguments))


BAD_LOGS = pytest.mark.parametrize(
    ("content", "words"),
    [
        (HEADER + 3 * (GOOD_ROW + "0.02,0,1,9.81,0,0,0\n"), ["jumps", "line 5"]),
        (HEADER + GOOD_ROW + 3 * "0.02,,,,0,0,0.1\n", ["specific_force", "line 4"]),
        (HEADER + GOOD_ROW + "0.02,0,0,9.81,0,0\n", ["4"]),
        (HEADER + GOOD_ROW + "0.02,zero,0,9.81,0,0,0\n", ["4", "ax"]),
        pytest.param("t,x,y,z\n1,2,3,4\n", ["hold text"], marks=needs("loggers")),
        (HEADER, ["row"]),
        ("", []),
        (HEADER + still_rows(9.81, 10.0), ["1000"]),
    ],
)


def test_a_log_in_g_is_asked_for_its_unit(clip, tmp_path):
    log = tmp_path / "log.csv"
    log.write_text(HEADER + still_rows(1.0, 0.01))
    out = tmp_path / "out"
    arguments = ("import", clip, "--imu", log, "--offset", 0, "-o", out)
    assert "accel-unit=g" in refused(hapticplayer(*arguments), 2)
    done = hapticplayer(*arguments, "--read-as", "accel-unit=g")
    assert done.returncode == 0, done.stderr


@BAD_LOGS
def test_a_bad_log_is_refused_with_line_and_column(content, words, clip, tmp_path):
    log = tmp_path / "log.csv"
    log.write_text(content)
    arguments = ("import", clip, "--imu", log, "--offset", 0, "-o", tmp_path / "out")
    sentence = refused(hapticplayer(*arguments))
    assert "log.csv" in sentence
    for word in words:
        assert word in sentence
    assert [p.name for p in tmp_path.iterdir()] == ["log.csv"]


@pytest.mark.parametrize(
    "content",
    [
        "time_s,fx_n,fy_n\n0,0,0\n",
        "time_s,fx_n,fy_n,fz_n\n0,0,inf,0\n",
        "time_s,fx_n,fy_n,fz_n\n1,0,0,0\n0,0,0,0\n",
        "time_s,fx_n,fy_n,fz_n\n",
        "time_s,fx_n,fy_n,fz_n\n99,0,0,0\n",
    ],
)
def test_a_bad_force_track_is_refused(content, clip, tmp_path):
    force = tmp_path / "force.csv"
    force.write_text(content)
    done = hapticplayer("play", clip, "--force", force, "--headless")
    assert "force.csv" in refused(done)


def test_a_ride_without_a_clip_is_a_log_with_its_truth(tmp_path):
    from hapticplayer.extras.rides.motion_scenes import simulate_motion

    target = tmp_path / "walk"
    done = hapticplayer("simulate", "walk", "-o", target, "--seed", "3")
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in target.iterdir()) == ["imu.csv", "truth.npz"]
    assert [path.name for path in tmp_path.iterdir()] == ["walk"]
    log = read_recording(target / "imu.csv").imu
    expected = simulate_motion("walk", 3)
    np.testing.assert_allclose(log.time_s, expected.imu.time_s, atol=1e-9)
    np.testing.assert_allclose(
        log.specific_force_mps2, expected.imu.specific_force_mps2, rtol=1e-8, atol=1e-9
    )
    with np.load(target / "truth.npz", allow_pickle=False) as truth:
        gravity = log.specific_force_mps2 - truth["acceleration_mps2"]
        leak = gravity - 9.80665 * truth["vertical"]
        assert np.sqrt(np.mean(leak**2)) < 0.1  # noise and bias of the sensor
    again = hapticplayer("simulate", "walk", "-o", target)
    assert "already exists" in refused(again)


@needs("faults")
def test_a_device_that_is_not_there_is_refused(clip):
    play = ("play", clip, "--headless", "--device")
    # nobody has a Falcon of that number
    assert "Falcon" in refused(hapticplayer(*play, "falcon:NOWHERE0"))
    done = hapticplayer(*play, "abacus")
    assert done.returncode == 2
    assert "falcon-simulated" in done.stderr


def test_wrong_usage_has_status_2(demo):
    assert hapticplayer("dance").returncode == 2
    assert hapticplayer("import", "x.mp4").returncode == 2
    assert hapticplayer("device").returncode == 2
    assert "realistic" in refused(
        hapticplayer("play", demo, "--headless", "--feedback", "strong"), status=2
    )
    assert refused(hapticplayer("simulate", "moon", "-o", demo / "x"), status=2)
    assert "10.0 s" in refused(
        hapticplayer("play", demo, "--headless", "--start", "400"), status=2
    )


def test_pipes_and_folders_are_refused_in_place_of_files(clip, tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    play = ("play", clip, "--headless", "--duration", 0.2)
    for arguments in (
        ("import", clip, "--imu", pipe, "-o", tmp_path / "out"),
        ("import", clip, "--imu", tmp_path, "-o", tmp_path / "out"),
        (*play, "--force", pipe),
        (*play, "--force", tmp_path),
        (*play, "--log", pipe),
        (*play, "--log", tmp_path),
        ("play", tmp_path, "--headless"),
    ):
        refused(hapticplayer(*arguments))
    assert [p.name for p in tmp_path.iterdir()] == ["pipe"]
