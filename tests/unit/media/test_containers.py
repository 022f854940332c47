"""A clip in a container that is not read is named, and the printed command mends it."""

import shlex
import shutil
import subprocess
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest

from hapticplayer.errors import MediaError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.containers import OTHERS
from hapticplayer.media.opening import open_media

needs_ffmpeg = pytest.mark.skipif(
    shutil.which("ffmpeg") is None, reason="needs ffmpeg, which the command starts"
)
TWO_SECONDS = 50


def written(path: Path, kind: str, video: str, sound: str) -> Path:
    with av.open(str(path), "w", format=kind) as file:
        stream = file.add_stream(video, rate=25)
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuv420p"
        heard = file.add_stream(sound, rate=48_000)
        heard.layout = "stereo"
        for number in range(TWO_SECONDS):
            picture = np.full((48, 64, 3), 5 * number, np.uint8)
            frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
            frame.pts, frame.time_base = number, Fraction(1, 25)
            file.mux(stream.encode(frame))
            samples = np.zeros((1, 2 * 1920), np.int16)
            tone = av.AudioFrame.from_ndarray(samples, "s16", "stereo")
            tone.sample_rate, tone.pts = 48_000, number * 1920
            tone.time_base = Fraction(1, 48_000)
            file.mux(heard.encode(tone))
        file.mux(stream.encode(None))
        file.mux(heard.encode(None))
    return path


def command_of(path: Path) -> list[str]:
    with pytest.raises(MediaError, match=r"which is not read; make an MP4") as caught:
        open_media(path)
    return shlex.split(str(caught.value).partition("with: ")[2])


@needs_ffmpeg
@pytest.mark.parametrize(
    ("name", "kind", "video", "sound"),
    [
        ("a ride's.ts", "mpegts", "libx264", "aac"),
        ("AVCHD.MTS", "mpegts", "libx264", "ac3"),
        ("old.mpg", "vob", "mpeg2video", "mp2"),
        ("camcorder.mxf", "mxf", "mpeg2video", "pcm_s16le"),
        ("dash cam.flv", "flv", "flv", "libmp3lame"),
        ("old.wmv", "asf", "wmv2", "libmp3lame"),
    ],
)
def test_a_remux_by_the_printed_command_is_read(tmp_path, name, kind, video, sound):
    command = command_of(written(tmp_path / name, kind, video, sound))
    subprocess.run(command, check=True, capture_output=True)
    clip = probe(command[-1])
    assert clip.duration_s == pytest.approx(2.0, abs=0.1)
    assert clip.has_audio


@needs_ffmpeg
def test_a_remux_goes_to_a_name_that_is_free(tmp_path):
    path = written(tmp_path / "ride.mp4", "mpegts", "libx264", "aac")
    command = command_of(path)
    assert command[-1] == str(tmp_path / "ride2.mp4")
    subprocess.run(command, check=True, capture_output=True)
    assert probe(command[-1]).duration_s == pytest.approx(2.0, abs=0.1)


@needs_ffmpeg
def test_a_camcorders_uncompressed_sound_is_encoded(tmp_path):
    made = written(tmp_path / "a.ts", "mpegts", "libx264", "aac")
    path = tmp_path / "b.m2ts"
    words = f"ffmpeg -i {made} -c:v copy -c:a pcm_bluray -mpegts_m2ts_mode 1 {path}"
    subprocess.run(shlex.split(words), check=True, capture_output=True)
    command = command_of(path)
    subprocess.run(command, check=True, capture_output=True)
    assert probe(command[-1]).has_audio


@needs_ffmpeg
def test_a_camcorder_clip_becomes_one_that_plays(tmp_path, case):
    path = tmp_path / "camcorder.mts"
    path.write_bytes(case("mpeg-ts/camcorder.mts").read_bytes())
    command = command_of(path)
    subprocess.run(command, check=True, capture_output=True)
    assert probe(command[-1]).duration_s == pytest.approx(2.0, abs=0.1)


@needs_ffmpeg
@pytest.mark.parametrize("cut", [1, 100, 187])
def test_a_transport_stream_cut_within_a_packet_is_known(tmp_path, cut):
    """As a camera's card or a capture begins anywhere."""
    whole = written(tmp_path / "whole.ts", "mpegts", "libx264", "aac")
    path = tmp_path / "cut.ts"
    path.write_bytes(whole.read_bytes()[cut:])
    command = command_of(path)
    subprocess.run(command, check=True, capture_output=True)
    assert probe(command[-1]).duration_s == pytest.approx(2.0, abs=0.1)


@needs_ffmpeg
@pytest.mark.parametrize("name", ["film.nut", "live.m3u8"])
def test_a_playlist_and_nut_are_remuxed_by_the_printed_command(tmp_path, name):
    made = written(tmp_path / "made.mp4", "mp4", "libx264", "aac")
    words = ["ffmpeg", "-v", "error", "-i", made, "-c", "copy", tmp_path / name]
    subprocess.run(words, check=True)
    command = command_of(tmp_path / name)
    subprocess.run(command, check=True, capture_output=True)
    assert probe(command[-1]).duration_s == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize(
    "other", OTHERS, ids=lambda one: f"{one.name} {one.magic!r} {one.every}"
)
def test_another_container_is_known_by_its_magic(tmp_path, other):
    period = other.magic.ljust(other.every or 400, b"\0")
    path = tmp_path / f"clip{other.endings[0]}"
    path.write_bytes(20 * period)
    with pytest.raises(MediaError, match=f"it is {other.name}, which is not read"):
        open_media(path)
