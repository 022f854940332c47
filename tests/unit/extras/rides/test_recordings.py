import dataclasses
import functools
import json
import shlex
from pathlib import Path

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import parse_choices
from hapticplayer.errors import Cancelled, UsageError
from hapticplayer.extras.rides import recordings
from hapticplayer.extras.rides.recording import SimulatedRecording, simulate
from hapticplayer.extras.rides.recordings import READ_AS, write_simulated_recording
from hapticplayer.media.clip_info import probe


@functools.cache
def small_simulate(scene: str, seed: int) -> SimulatedRecording:
    recorded = simulate(scene, seed)
    return dataclasses.replace(recorded, width=64, height=36, frame_rate_hz=3)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures of a stamp's size: their content is tested elsewhere."""

    monkeypatch.setattr(recordings, "simulate", small_simulate)


@pytest.mark.usefixtures("small")
def test_recording_has_clip_log_and_truth_that_belong_together(tmp_path: Path) -> None:
    progress: list[float] = []
    folder = write_simulated_recording(
        "free-fall",
        tmp_path / "fall",
        seed=3,
        with_gopro=True,
        progress=lambda f, _step: progress.append(f),
    )
    names = {"clip.mp4", "gopro.mp4", "imu.csv", "recording.json", "truth.npz"}
    assert {path.name for path in folder.iterdir()} == names
    assert probe(folder / "clip.mp4").duration_s == pytest.approx(22.0, abs=0.01)
    assert np.diff(progress).min() >= -1e-9
    about = json.loads((folder / "recording.json").read_text())
    imu = read_recording(folder / "imu.csv", parse_choices([READ_AS])).imu
    with np.load(folder / "truth.npz", allow_pickle=False) as truth:
        time_s, force = truth["time_s"], truth["specific_force_mps2"]
        assert len(time_s) == 22_001
    clock = about["clock"]
    media_s = clock["rate"] * imu.time_s + clock["offset_s"]
    inside = (media_s > 0.1) & (media_s < 21.9)
    means = np.convolve(force[:, 2], np.full(33, 1 / 33), "same")
    error = imu.specific_force_mps2[inside, 2] - np.interp(
        media_s[inside], time_s, means
    )
    # bias and scale, and what a stall costs in a fall's edge; 10 ms off gives 2.5
    assert np.std(error) < 1.2
    assert [pat["time_s"] for pat in about["pats"]] == sorted(
        pat["time_s"] for pat in about["pats"]
    )


@pytest.mark.usefixtures("small")
def test_cancelled_recording_leaves_nothing(tmp_path: Path) -> None:
    def stop(fraction: float, _step: str) -> None:
        if fraction > 0.3:
            raise Cancelled

    with pytest.raises(Cancelled):
        write_simulated_recording("free-fall", tmp_path / "x", seed=3, progress=stop)
    assert list(tmp_path.iterdir()) == []


def test_other_scenes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="ride 'demo' not found; choose one of bike"):
        write_simulated_recording("demo", tmp_path / "x", seed=1)


@pytest.mark.usefixtures("small")
def test_printed_command_imports_the_recording_it_names(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, target = tmp_path / 'the rider\'s "fall"', tmp_path / "made here"
    assert cli.main(["simulate", "free-fall", "--seed", "3", "-o", str(folder)]) == 0
    line = capsys.readouterr().out.partition(" with: ")[2]
    words = shlex.split(line)[1:-1]
    clock = json.loads((folder / "recording.json").read_text())["clock"]
    offset = (
        f"--offset={clock['offset_s']}"  # stamps have too few pixels to be followed
    )
    assert cli.main([*words, str(target), offset]) == 0
    play = capsys.readouterr().out.rpartition(" with: ")[2]
    assert shlex.split(play) == ["hapticplayer", "play", str(target)]
