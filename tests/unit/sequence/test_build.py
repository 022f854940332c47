"""Importing writes all or nothing."""

import dataclasses
import hashlib
import os
import shutil

import numpy as np
import pytest

from hapticplayer import storage
from hapticplayer.capture.mounting import BY_FRAMES
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.capture.sync.result import FoundMounting
from hapticplayer.cli import main
from hapticplayer.errors import Cancelled, HapticPlayerError, InputError
from hapticplayer.model import ClockMap
from hapticplayer.sequence import mounting_by_frames, open_sequence
from hapticplayer.sequence.build import Choices, build_sequence, write_sequence
from hapticplayer.sequence.synchronizing import SyncChoices
from hapticplayer.untrusted import HeldFile
from tests.needed_extras import needs


@pytest.fixture
def log_file(tmp_path, still_log):
    path = tmp_path / "log.csv"
    write_imu_csv(path, still_log)
    return path


def test_a_video_with_a_log_becomes_a_sequence(tmp_path, tiny_clip, log_file):
    steps = []
    folder = build_sequence(
        tiny_clip.path,
        tmp_path / "new" / "ride",
        imu_log=log_file,
        choices=Choices(sync=SyncChoices(offset_s=-1.5)),
        progress=lambda fraction, step: steps.append((fraction, step)),
    )
    sequence = open_sequence(folder)
    assert sequence.motion.time_s[0] == pytest.approx(-1.5)
    assert sequence.description.clock_map.offset_s == -1.5
    fractions = [fraction for fraction, _ in steps]
    assert fractions == sorted(fractions)
    assert (fractions[0], fractions[-1]) == (0.0, 1.0)


def test_following_frames_moves_the_bar_for_most_of_it(
    tmp_path, tiny_clip, log_file, monkeypatch
):
    def follow(_clip, _imu, _clock, progress):
        for share in (0.0, 0.5, 1.0):
            progress(share, "following the frames")
        return FoundMounting("y,-x,z", 2.0, "x,y,z")

    monkeypatch.setattr(mounting_by_frames, "frame_function", lambda _name: follow)
    steps = []
    build_sequence(
        tiny_clip.path,
        tmp_path / "ride",
        imu_log=log_file,
        choices=Choices(sync=SyncChoices(offset_s=0.0), mounting=BY_FRAMES),
        progress=lambda fraction, step: steps.append((fraction, step)),
    )
    fractions = [fraction for fraction, _ in steps]
    assert fractions == sorted(fractions)
    followed = [fraction for fraction, step in steps if step == "following the frames"]
    assert followed[-1] - followed[0] > 0.7
    assert (fractions[0], fractions[-1]) == (0.0, 1.0)


@needs("loggers")
def test_a_log_in_two_files_becomes_a_sequence(tmp_path, tiny_clip, still_log):
    tables = (still_log.specific_force_mps2, still_log.angular_rate_radps)
    logs = [tmp_path / "acc.csv", tmp_path / "gyr.csv"]
    for path, values in zip(logs, tables, strict=True):
        rows = np.column_stack([still_log.time_s, values])
        np.savetxt(path, rows, fmt="%.9f", delimiter=",")
    words = ["columns=time,ax,ay,az/time,gx,gy,gz", "time-unit=s", "accel-unit=m/s2",
             "rate-unit=rad/s"]  # fmt: skip
    command = [
        "import",
        str(tiny_clip.path),
        "--offset",
        "0",
        "-o",
        str(tmp_path / "r"),
    ]
    command += [word for log in logs for word in ("--imu", str(log))]
    assert main([*command, *(w for word in words for w in ("--read-as", word))]) == 0
    made_of = open_sequence(tmp_path / "r").description.provenance
    assert made_of["motion_source"] == "acc.csv + gyr.csv"
    with np.load(tmp_path / "r" / "imu.npz") as kept:
        np.testing.assert_allclose(
            kept["angular_rate_radps"], still_log.angular_rate_radps, atol=2e-9
        )


def stop_at(fraction):
    def progress(done, _step):
        if done >= fraction:
            raise Cancelled

    return progress


@pytest.mark.parametrize("fraction", [0.0, 0.05, 0.3, 0.7, 0.8, 0.95, 1.0])
def test_cancelling_leaves_nothing(tmp_path, tiny_clip, log_file, fraction):
    before = sorted(tmp_path.iterdir())
    with pytest.raises(Cancelled):
        build_sequence(
            tiny_clip.path,
            tmp_path / "ride",
            imu_log=log_file,
            choices=Choices(sync=SyncChoices(offset_s=0.0)),
            progress=stop_at(fraction),
        )
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("error", [KeyboardInterrupt, MemoryError, OSError(28, "full")])
def test_whatever_goes_wrong_leaves_nothing(tmp_path, tiny_clip, log_file, error):
    def progress(done, _step):
        if done > 0.95:  # it writes
            raise error

    with pytest.raises((KeyboardInterrupt, MemoryError, HapticPlayerError)):
        build_sequence(
            tiny_clip.path,
            tmp_path / "ride",
            imu_log=log_file,
            choices=Choices(sync=SyncChoices(offset_s=0.0)),
            progress=progress,
        )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["log.csv"]


@pytest.mark.parametrize("kind", ["folder", "empty folder", "file"])
def test_a_target_that_another_makes_meanwhile_is_kept(
    tmp_path, tiny_clip, recording, kind
):
    target = tmp_path / "ride"

    def progress(_done, said):
        if said == "writing":
            target.write_text("theirs") if kind == "file" else target.mkdir()
            if kind == "folder":
                (target / "theirs").write_text("theirs")

    with pytest.raises(InputError, match="ride: was made by another process"):
        write_sequence(tiny_clip, recording, target, progress=progress)
    assert [p.name for p in tmp_path.iterdir()] == ["ride"]
    assert target.is_file() or len(list(target.iterdir())) == (kind == "folder")


def test_folders_of_killed_imports_are_removed_and_no_others(tmp_path):
    for name in (".hapticplayer-dead.part", ".other-dead.part", ".hapticplayer-mine"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "clip.mp4").write_bytes(b"half")
    (tmp_path / ".hapticplayer-file.part").write_text("a file")
    (tmp_path / ".hapticplayer-link.part").symlink_to(tmp_path / ".other-dead.part")
    before = {path.name for path in tmp_path.iterdir()}
    with storage.scratch_beside(tmp_path / "one") as living:
        with storage.scratch_beside(tmp_path / "two"):
            assert living.is_dir()
        left = {path.name for path in tmp_path.iterdir()}
        assert left == before - {".hapticplayer-dead.part"} | {living.name}
    assert (tmp_path / ".other-dead.part" / "clip.mp4").exists()


@pytest.mark.parametrize("kind", ["folder", "empty folder", "file", "dead link"])
def test_an_existing_target_is_never_touched(tmp_path, tiny_clip, log_file, kind):
    target = tmp_path / "ride"
    if kind == "file":
        target.write_text("mine")
    elif kind == "dead link":
        target.symlink_to(tmp_path / "nowhere")
    else:
        target.mkdir()
        if kind == "folder":
            (target / "mine").write_text("mine")
    before = os.lstat(target)
    with pytest.raises(InputError, match="already exists"):
        build_sequence(tiny_clip.path, target, imu_log=log_file)
    assert os.lstat(target).st_mtime_ns == before.st_mtime_ns


def test_motion_that_misses_the_clip_is_refused(tmp_path, tiny_clip, recording):
    away = dataclasses.replace(recording, clock_map=ClockMap(1000.0))
    with pytest.raises(InputError, match="--offset"):
        write_sequence(tiny_clip, away, tmp_path / "ride")


def test_a_file_is_copied_whole(tmp_path, rng):
    source, progress, content = tmp_path / "a", [], rng.bytes(3_000_001)
    source.write_bytes(content)
    with HeldFile(source) as held:
        checksum = storage.copy_file(held, tmp_path / "b", progress.append)
    assert (tmp_path / "b").read_bytes() == content
    assert checksum == hashlib.sha256(content).hexdigest()
    assert progress[-1] == 1.0


def truncated(path):
    os.truncate(path, 0)


def cut_in_half(path):
    os.truncate(path, path.stat().st_size // 2)


def replaced(path):
    path.with_suffix(".new").write_bytes(b"another clip")
    path.with_suffix(".new").replace(path)


def written_over(path):
    path.write_bytes(path.read_bytes()[::-1])


@pytest.mark.parametrize("change", [truncated, cut_in_half, replaced, written_over])
@pytest.mark.parametrize("step", ["synchronising", "copying the clip", "writing"])
def test_a_clip_that_changes_meanwhile_is_refused(
    tmp_path, tiny_clip, log_file, change, step
):
    clip = tmp_path / "ride.mp4"
    shutil.copyfile(tiny_clip.path, clip)

    def progress(_done, said):
        if said == step:
            change(clip)

    with pytest.raises(InputError, match="changed or replaced while it was read"):
        build_sequence(
            clip,
            tmp_path / "ride",
            imu_log=log_file,
            choices=Choices(sync=SyncChoices(offset_s=0.0)),
            progress=progress,
        )
    assert sorted(p.name for p in tmp_path.iterdir()) == ["log.csv", "ride.mp4"]


def test_paths_of_the_machine_stay_out_of_the_sequence(sequence_folder, tmp_path):
    text = (sequence_folder / "sequence.json").read_text()
    assert str(tmp_path) not in text
