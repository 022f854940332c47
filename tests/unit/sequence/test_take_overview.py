"""A take that was recorded here, as it is shown back: sound, motion and taps in media time."""

from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.capture.recorded import (
    CLIP,
    COLUMNS,
    LOG,
    SourceClockLine,
    Stream,
    Take,
    parts_of,
)
from hapticplayer.media.encode import write_clip
from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.sequence.import_batch import items_of
from hapticplayer.sequence.import_preview import loudness_of, preview_import
from hapticplayer.sequence.take_overview import overview_of
from tests.material.sync_clips import simulate_pats

LATE_S = 0.012


@pytest.fixture(scope="module")
def tapped(tmp_path_factory):
    """A simulated ride with three taps, as the recorder writes it; clock 12 ms off."""
    folder = tmp_path_factory.mktemp("takes") / "ride"
    folder.mkdir()
    made = simulate_pats(100_003, hard=False, rate_hz=200, duration_s=15.0)
    grey = (np.full((36, 64, 3), 90, np.uint8) for _ in range(150))
    sound = np.asarray(made.audio, np.float32).reshape(len(made.audio), -1)
    write_clip(
        folder / "clip.mp4",
        grey,
        frame_rate_hz=10,
        audio=sound[:, :1],
        audio_rate_hz=round(made.audio_rate_hz),
        is_quick=True,
    )
    (folder / "clip.mp4").rename(folder / CLIP)
    imu = made.imu
    rows = np.column_stack(
        [imu.time_s, imu.specific_force_mps2, imu.angular_rate_radps, imu.time_s]
    )
    np.savetxt(folder / LOG, rows, "%.6f", ",", header=",".join(COLUMNS), comments="")
    clock = SourceClockLine(made.clock_map.offset_s - LATE_S, made.clock_map.rate, 0.01)
    Take(
        began="2026-11-27T15:00:00+00:00",
        is_finished=True,
        camera=Stream("/dev/video0", "monotonic"),
        imu=Stream("wt901:/dev/ttyUSB0", "source"),
        clock=clock,
    ).write(folder)
    return folder, made


def test_taps_sound_and_motion_lie_in_media_time(tapped):
    folder, made = tapped
    found = overview_of(folder)
    assert found.problem == ""
    assert found.duration_s == pytest.approx(made.duration_s, abs=3.0)
    assert found.taps_s == pytest.approx(made.pats_s, abs=0.01)
    assert found.taps_late_s == pytest.approx(LATE_S, abs=0.004)
    at_s = found.motion.time_s[np.argmax(np.abs(found.motion.acceleration_mps2)) // 3]
    assert np.abs(at_s + LATE_S - made.pats_s).min() < 0.02
    gravity = np.linalg.norm(found.motion.gravity_mps2, axis=1)
    assert np.median(gravity) == pytest.approx(STANDARD_GRAVITY_MPS2, abs=0.2)


def test_the_folder_of_a_take_is_imported_with_both_clocks(tapped):
    folder, _ = tapped
    (item,) = items_of([folder])
    assert item == (folder / CLIP, (folder,))
    assert items_of([folder.parent]) == [item]
    found = preview_import(item.video, item.logs)
    assert found.found.is_confident
    assert found.recorder == "recorded here"
    assert parts_of(folder).log == folder


def test_an_empty_stream_of_sound_is_silence(tmp_path):
    """A microphone that never delivered anything leaves one."""
    clip = tmp_path / "clip.mkv"
    with av.open(str(clip), "w") as file:
        film = file.add_stream("libx264", rate=10)
        film.width, film.height, film.pix_fmt = 64, 36, "yuv420p"
        file.add_stream("pcm_s16le", rate=16000)
        for number in range(5):
            frame = av.VideoFrame(64, 36, "yuv420p")
            frame.pts, frame.time_base = number, Fraction(1, 10)
            file.mux(film.encode(frame))
        file.mux(film.encode())
    times_s, level = loudness_of(clip)
    assert (len(times_s), len(level)) == (0, 0)
