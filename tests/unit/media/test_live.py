"""Cameras and microphones: FFmpeg's test sources, as fast as they are read."""

import itertools
import shutil

import av
import numpy as np
import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.errors import InputError
from hapticplayer.media import live_input
from hapticplayer.media.clip_info import probe
from hapticplayer.media.live_clip import LiveClip, first_shown
from hapticplayer.media.live_input import CAMERAS, MICROPHONES, Live, LiveInput, Stamps
from hapticplayer.media.remux import MATROSKA, remux

FILM = "lavfi:testsrc2=size=160x120:rate=30:duration=3,setpts=PTS"
SOUND = "lavfi:sine=frequency=440:sample_rate=48000:samples_per_frame=1024:duration=3,asetpts=PTS"


class Passing(ManualClock):
    """A clock on which the time of a frame or a block passes with each look."""

    def __init__(self, step_s=1 / 30):
        super().__init__(0.0)
        self._step_s = step_s

    def now_s(self):
        self.advance(self._step_s)
        return super().now_s()


@pytest.fixture
def camera():
    return LiveInput(FILM, CAMERAS, Passing())


def frame_times(path):
    with av.open(str(path)) as file:
        return [
            float(one.pts * one.time_base) for one in file.demux(video=0) if one.size
        ]


@pytest.mark.parametrize(("stamp_s", "clock"), [(500.2, "monotonic"), (9500.2, "wall")])
def test_stamps_of_either_clock_become_monotonic_times(stamp_s, clock):
    stamps = Stamps("camera", 9000.0)
    assert stamps.host_s(stamp_s, 500.25) == pytest.approx(500.2)
    assert stamps.clock == clock
    assert stamps.host_s(stamp_s + 0.1, 500.4) == pytest.approx(500.3)
    assert stamps.host_s(stamp_s + 0.1, 502.4) is None


def test_a_camera_with_a_clock_of_its_own_is_refused():
    with pytest.raises(InputError, match=r"100\.0 s from this machine's clock"):
        Stamps("camera", 9000.0).host_s(600.0, 500.0)


def test_a_camera_that_is_not_there_names_the_list(tmp_path):
    with pytest.raises(InputError, match="record --list"):
        LiveInput(str(tmp_path / "video9"), CAMERAS, ManualClock())


def test_frames_have_the_times_of_their_stamps(tmp_path, camera):
    frames = camera.packets()
    first = first_shown(camera, frames)
    clip = LiveClip(tmp_path / "clip.mkv", camera, None, first.host_s)
    written = [clip.add(first, is_shown=False)]
    for number, live in zip(range(1, 40), frames, strict=False):
        if number % 10 != 5:  # lost on the way
            late_s = 0.004 * (number % 3)
            written.append(
                clip.add(live._replace(host_s=live.host_s + late_s), is_shown=False)
            )
    clip.close()
    assert all(written)
    wanted = [n / 30 + 0.004 * (n % 3) for n in range(40) if n % 10 != 5]
    assert frame_times(tmp_path / "clip.mkv") == pytest.approx(wanted, abs=0.0006)
    with av.open(str(tmp_path / "clip.mkv")) as file:
        keys = [one.is_keyframe for one in file.demux(video=0) if one.size]
    assert sum(keys) == 1  # raw frames say that each of them is one


def test_a_frame_without_a_time_of_its_own_is_dropped(tmp_path, camera):
    frames = camera.packets()
    first = next(frames)
    clip = LiveClip(tmp_path / "clip.mkv", camera, None, first.host_s)
    assert clip.add(first, is_shown=True)
    assert not clip.add(next(frames)._replace(host_s=first.host_s), is_shown=False)
    assert clip.shown().shape == (120, 160, 3)
    clip.close()
    assert frame_times(tmp_path / "clip.mkv") == [0.0]


def test_a_kill_loses_less_than_half_a_second(tmp_path, camera):
    microphone = LiveInput(SOUND, MICROPHONES, Passing(1024 / 48_000))
    path = tmp_path / "clip.mkv"
    frames, sound = camera.packets(), microphone.packets()
    first = next(frames)
    clip = LiveClip(path, camera, microphone, first.host_s)
    clip.add(first, is_shown=False)
    for live, heard in zip(frames, sound, strict=False):
        clip.add(live, is_shown=False)
        clip.add_sound(heard)
        if live.host_s > 2.0:
            break
    shutil.copy(path, tmp_path / "killed.mkv")
    clip.close()
    remux(tmp_path / "killed.mkv", tmp_path / "whole.mkv", MATROSKA)
    found = probe(tmp_path / "whole.mkv")
    assert found.duration_s > 1.5
    assert found.has_audio
    assert frame_times(tmp_path / "whole.mkv")[-1] > 1.5


@pytest.mark.parametrize("codec", ["mjpeg", "libx264"])
def test_frames_that_the_camera_compressed_are_copied(tmp_path, monkeypatch, codec):
    path = tmp_path / "camera.mkv"
    with av.open(str(path), "w") as file:
        stream = file.add_stream(codec, rate=30, options={"bf": "0"})
        stream.width, stream.height = 64, 48
        stream.pix_fmt = "yuvj420p" if codec == "mjpeg" else "yuv420p"
        for number in range(20):
            picture = np.full((48, 64, 3), 10 * number, np.uint8)
            file.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        file.mux(stream.encode())
    with av.open(str(path)) as file:
        sizes = [one.size for one in file.demux(video=0) if one.size]
    monkeypatch.setattr(
        live_input, "open_device", lambda _name, _kind: av.open(str(path))
    )
    camera = LiveInput("compressing", CAMERAS, Passing())
    assert camera.is_copied
    frames = camera.packets()
    first = first_shown(camera, frames)
    clip = LiveClip(tmp_path / "clip.mkv", camera, None, first.host_s)
    clip.add(first, is_shown=True)
    for live in itertools.islice(frames, len(sizes) - 1):
        clip.add(live, is_shown=False)
    with pytest.raises(InputError, match="has ended"):
        next(frames)
    clip.close()
    with av.open(str(tmp_path / "clip.mkv")) as file:
        assert [one.size for one in file.demux(video=0) if one.size] == sizes


def heard(stamps_s, tmp_path):
    """Times of the blocks of 1024 samples in a clip, which had these stamps."""
    camera = LiveInput(FILM, CAMERAS, Passing())
    microphone = LiveInput(SOUND, MICROPHONES, Passing(1024 / 48_000))
    clip = LiveClip(tmp_path / "clip.mkv", camera, microphone, 0.0)
    clip.add(next(camera.packets()), is_shown=False)
    for stamp_s, live in zip(stamps_s, microphone.packets(), strict=False):
        clip.add_sound(Live(live.packet, stamp_s))
    residual_s, jumps = clip.sound.residual_s, clip.sound.jumps
    clip.close()
    with av.open(str(tmp_path / "clip.mkv")) as file:
        found = [one.pts * one.time_base for one in file.demux(audio=0) if one.size]
    return np.array(found, dtype=float), residual_s, jumps


def test_sound_follows_the_mean_of_its_stamps(tmp_path, rng):
    true_s = np.arange(130) * 1024 / 48_000 * (1 + 200e-6)
    found_s, residual_s, jumps = heard(true_s + rng.normal(0, 0.001, 130), tmp_path)
    assert jumps == 0
    assert np.abs(found_s - true_s)[20:].max() < 0.002
    assert residual_s == pytest.approx(0.001, rel=0.4)


def test_sound_after_a_gap_has_its_own_time(tmp_path):
    true_s = np.arange(100) * 1024 / 48_000
    true_s[50:] += 0.5
    found_s, _, jumps = heard(true_s, tmp_path)
    assert jumps == 1
    assert found_s == pytest.approx(true_s, abs=0.001)


def test_sound_never_goes_back(tmp_path):
    true_s = np.arange(100) * 1024 / 48_000
    true_s[50:] -= 0.3
    found_s, _, _ = heard(true_s, tmp_path)
    assert (np.diff(found_s) > 0).all()
    assert found_s[-1] == pytest.approx(true_s[-1], abs=0.001)
