"""Synchronisation on the command line: files in, an offset or a question out."""

import json
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.signal import resample_poly

from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.media.encode import write_clip
from tests.e2e.command import hapticplayer, refused, report_of
from tests.material.sync_clips import simulate_pats

SECONDS = 20


def write_video(path, sound=None):
    grey = (np.full((36, 64, 3), k % 250, np.uint8) for k in range(30 * SECONDS))
    audio = None
    if sound is not None:
        audio = resample_poly(sound, 3, 1).astype(np.float32)[:, None]
    write_clip(path, grey, frame_rate_hz=30, audio=audio)
    return path


@pytest.fixture(scope="module")
def ride(tmp_path_factory):
    """A clip with pats, its log, a stranger's log, and the truth."""
    folder = tmp_path_factory.mktemp("ride")
    made = simulate_pats(41_001, hard=False, rate_hz=200, duration_s=SECONDS)
    write_video(folder / "ride.mp4", made.audio)
    write_video(folder / "mute.mp4")
    write_imu_csv(folder / "log.csv", made.imu)
    other = simulate_pats(41_002, hard=False, rate_hz=200, duration_s=SECONDS)
    write_imu_csv(folder / "other.csv", other.imu)
    return folder, made


def offset_error_s(found, made):
    at_s = made.pats_s[1]
    log_s = (at_s - made.clock_map.offset_s) / made.clock_map.rate
    rate = 1.0 + 1e-6 * found.get("drift_ppm", 0.0)
    return rate * log_s + found["offset_s"] - at_s


def test_sync_reports_offset_confidence_and_pats(ride):
    folder, made = ride
    done = hapticplayer(
        "sync", folder / "ride.mp4", "--imu", folder / "log.csv", "--json"
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert abs(offset_error_s(found, made)) < 0.004  # AAC included
    assert found["method"] == "pats"
    heard = [pat["heard_s"] for pat in found["pats"]]
    assert heard == pytest.approx(made.pats_s, abs=0.005)


def test_an_import_synchronises_and_keeps_the_evidence(ride, tmp_path):
    folder, made = ride
    done = hapticplayer(
        *("import", folder / "ride.mp4", "--imu", folder / "log.csv"),
        *("-o", tmp_path / "out"),
    )
    assert done.returncode == 0, done.stderr
    assert "tap 3: heard at" in done.stdout
    kept = json.loads((tmp_path / "out" / "sequence.json").read_text())
    assert abs(offset_error_s(kept["clock_map"], made)) < 0.004
    evidence = kept["provenance"]["synchronisation"]
    assert evidence["confidence"] == pytest.approx(
        kept["clock_map"]["confidence"], abs=1e-4
    )
    assert len(evidence["pats"]) == 3


@pytest.mark.parametrize("command", ["sync", "import"])
def test_a_strangers_log_is_a_question_not_an_answer(ride, tmp_path, command):
    folder, _ = ride
    output = ("-o", tmp_path / "out") if command == "import" else ()
    done = hapticplayer(
        command, folder / "ride.mp4", "--imu", folder / "other.csv", *output
    )
    sentence = refused(done, status=2)
    assert "--offset" in sentence
    assert "--plot" in sentence
    assert not (tmp_path / "out").exists()


def test_a_mute_clip_asks_for_the_offset(ride, tmp_path):
    folder, _ = ride
    arguments = ("import", folder / "mute.mp4", "--imu", folder / "log.csv")
    sentence = refused(hapticplayer(*arguments, "-o", tmp_path / "out"))
    assert "no sound" in sentence
    assert "--offset" in sentence
    done = hapticplayer(*arguments, "--offset", 0, "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", ["ride.mp4", "log.csv"])
def test_check_says_of_one_file_that_its_pats_can_be_used(ride, name):
    folder, _ = ride
    done = hapticplayer("sync", "--check", folder / name)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "the taps can be used" in done.stdout


def test_check_of_clip_and_log_together_and_of_a_mute_one(ride):
    folder, _ = ride
    arguments = ("sync", "--check", folder / "ride.mp4", "--json", "--imu")
    report = report_of(hapticplayer(*arguments, folder / "log.csv"))
    assert report["is_usable"]
    assert report["together"]["is_confident"]
    mistaken = hapticplayer(*arguments, folder / "other.csv")
    assert mistaken.returncode == 2
    assert not json.loads(mistaken.stdout)["is_usable"]
    refused(hapticplayer("sync", "--check", folder / "mute.mp4"))


def test_a_camera_that_keeps_its_motion_needs_no_pats(shared_data):
    clip = shared_data / "capture" / "gopro" / "karma.mp4"
    done = hapticplayer("sync", "--check", clip)
    assert done.returncode == 0
    assert "no taps needed" in done.stdout
    # a drone: no pats, and by its sound alone nobody could tell
    assert "--offset" in refused(hapticplayer("sync", clip, "--sync", "pats"), 2)


def test_a_stored_skew_is_taken_off_for_its_camera_only(ride, tmp_path):
    folder, _ = ride
    home = {"XDG_CONFIG_HOME": str(tmp_path)}
    clip = ("sync", folder / "ride.mp4", "--imu", folder / "log.csv", "--json")
    plain = report_of(hapticplayer(*clip, env=home))
    stored = (*clip, "--camera", "Cam 5", "--skew", 0.06, "--store-skew")
    assert hapticplayer(*stored, env=home).returncode == 0
    late = report_of(hapticplayer(*clip, "--camera", "Cam 5", env=home))
    assert plain["offset_s"] - late["offset_s"] == pytest.approx(0.06, abs=2e-6)
    assert report_of(hapticplayer(*clip, env=home)) == plain
    unknown = hapticplayer(*clip, "--camera", "Cam 6", env=home)
    assert "Cam 5" in refused(unknown, status=2)
    refused(hapticplayer(*clip, "--skew", 99, env=home), status=2)


def test_the_plot_shows_both_streams_and_three_pats(ride, tmp_path):
    folder, _ = ride
    clip = ("sync", folder / "ride.mp4", "--imu", folder / "log.csv")
    target = tmp_path / "sync.svg"
    assert hapticplayer(*clip, "--plot", target).returncode == 0
    texts = " ".join(ET.parse(target).getroot().itertext())
    assert "media time, s" in texts
    assert "offset" in texts
    again = tmp_path / "again.svg"
    assert hapticplayer(*clip, "--plot", again).returncode == 0
    assert again.read_bytes() == target.read_bytes()
    refused(hapticplayer(*clip, "--plot", target))


def test_methods_that_lack_their_ground_are_refused(ride):
    folder, _ = ride
    clip = ("sync", folder / "ride.mp4", "--imu", folder / "log.csv", "--sync")
    assert "--offset" in refused(hapticplayer(*clip, "offset"), status=2)
    assert "clock" in refused(hapticplayer(*clip, "embedded"), status=2)


def test_a_batch_imports_what_it_can_and_sums_up(ride, tmp_path):
    folder, _ = ride
    videos = []
    for name, log in (("a", "log.csv"), ("b", "other.csv"), ("c", None)):
        videos.append(tmp_path / f"{name}.mp4")
        videos[-1].symlink_to(folder / "ride.mp4")
        if log:
            (tmp_path / f"{name}.csv").symlink_to(folder / log)
    out = tmp_path / "out"
    done = hapticplayer("import", *videos, "-o", out)
    assert done.returncode == 1
    lines = done.stdout.splitlines()
    assert "by pats" in lines[0]
    assert "to be decided" in lines[1]
    assert "refused" in lines[2]
    assert lines[3] == "3 videos: 1 done, 1 refused, 1 to be decided"
    assert [path.name for path in out.iterdir()] == ["a"]
    refused(hapticplayer("import", *videos, "-o", out, "--offset", 0), status=2)


def test_the_skew_of_the_camera_in_the_clip_is_used_everywhere(ride, tmp_path):
    import av

    folder, _ = ride
    clip = tmp_path / "named.mp4"
    with av.open(str(folder / "ride.mp4")) as source:
        options = {"movflags": "use_metadata_tags"}
        with av.open(str(clip), "w", options=options) as target:
            target.metadata.update({"make": "Acme", "model": "Cam 5"})
            streams = {
                s.index: target.add_stream_from_template(s) for s in source.streams
            }
            for packet in source.demux():
                if packet.dts is not None:
                    packet.stream = streams[packet.stream_index]
                    target.mux(packet)
    home = {"XDG_CONFIG_HOME": str(tmp_path / "home")}
    both = (clip, "--imu", folder / "log.csv", "--json")
    plain = report_of(hapticplayer("sync", *both, env=home))
    kept = ("--camera", "Acme Cam 5", "--skew", 0.06, "--store-skew")
    assert hapticplayer("sync", *both, *kept, env=home).returncode == 0
    late = report_of(hapticplayer("sync", *both, env=home))
    assert plain["offset_s"] - late["offset_s"] == pytest.approx(0.06, abs=2e-6)
    done = hapticplayer("import", *both, "-o", tmp_path / "out", env=home)
    made = json.loads(done.stdout)
    assert made["clock_map"]["offset_s"] == pytest.approx(late["offset_s"], abs=2e-6)
    assert made["provenance"]["synchronisation"]["sound_late_s"] == 0.06
