"""Cameras beyond GoPro: the library is not here, so children stand in for it."""

import os
import sys
import textwrap
from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.assemble import assemble
from hapticplayer.capture.choices import LogChoices
from hapticplayer.errors import TelemetryError, UsageError
from hapticplayer.extras.cameras.other_cameras import read_other_camera

AXES = LogChoices(axes="x,y,z")
LIBRARY = """
    import os
    def shake(k, n): return 0.001 * (k * k * (n + 1) % 7907 % 50)
    class Parser:
        camera, model = "Sony", "FX3"
        def __init__(self, path):
            if open(path).read() == "gopro":
                self.camera = "GoPro"
            assert sorted(os.listdir(os.path.dirname(path))) == ["video.mp4"], "side cars"
            self.kind = open(path).read()
        def normalized_imu(self):
            if self.kind == "panic":
                class PanicException(BaseException): pass
                raise PanicException("index out of range")
            if self.kind == "greedy":
                bytearray(3 << 30)
            if self.kind == "dead":
                os.abort()
            if self.kind == "slow":
                while True: pass
            accl = None if self.kind == "gimbal" else (0.1, 0.2, 9.8)
            return [
                dict(timestamp_ms=2500.0 + 5.0 * k, gyro=tuple(a + shake(k, n) for n, a in enumerate((0.9, 0.0, 0.0))),
                     accl=None if self.kind == "half" and k % 2 else
                     accl and tuple(a + shake(k, n) for n, a in enumerate(accl)))
                for k in range(2000)
            ]
"""


@pytest.fixture
def camera(tmp_path, monkeypatch):
    """A folder with a library on the child's path, and a video with a side-car."""
    library = tmp_path / "library"
    library.mkdir()
    (library / "telemetry_parser.py").write_text(textwrap.dedent(LIBRARY))
    here = os.pathsep.join([str(library), *(p for p in sys.path if p)])
    monkeypatch.setenv("PYTHONPATH", here)
    (tmp_path / "clip.gyroflow").write_text("a side-car that must not be seen")
    return tmp_path / "clip.mp4"


def test_video_becomes_a_log_in_si(camera):
    camera.write_text("good")
    log = assemble(read_other_camera(camera, AXES), AXES, str(camera))
    assert log.camera == "Sony FX3"
    assert log.imu.rate_hz == pytest.approx(200.0)
    assert log.imu.time_s[0] == pytest.approx(2.5, abs=1e-3)  # the library's own clock
    np.testing.assert_allclose(log.imu.specific_force_mps2[0], [0.1, 0.2, 9.8])
    assert log.imu.angular_rate_radps[0, 0] == pytest.approx(np.radians(0.9))


def test_axes_are_asked_for(camera):
    camera.write_text("good")
    with pytest.raises(UsageError, match="telemetry does not declare its axes"):
        read_other_camera(camera, LogChoices())


@pytest.mark.parametrize(
    ("kind", "reason"),
    [
        ("panic", "PanicException: index out of range"),
        ("greedy", "MemoryError"),
        ("dead", "it died, status -6|abort"),
        ("gopro", "a GoPro's telemetry is read without it"),
        ("gimbal", "no accelerations"),
        ("half", "only 50% of its samples are whole"),
    ],
)
def test_a_failure_of_the_library_is_one_sentence(camera, kind, reason):
    camera.write_text(kind)
    with pytest.raises(TelemetryError, match=reason) as caught:
        read_other_camera(camera, AXES)
    assert "\n" not in str(caught.value)


def test_library_that_hangs_is_ended(camera):
    camera.write_text("slow")
    with pytest.raises(TelemetryError, match=r"took telemetry-parser 2 s|it died"):
        read_other_camera(camera, AXES, time_limit_s=2.0)


@pytest.mark.parametrize(
    "script",
    [
        "print('no json')",
        "print('{}')",
        'print(\'{"camera": "x", "model": ""}\')',
    ],
)
def test_answers_that_are_none_are_refused(camera, script):
    camera.write_text("good")
    command = (sys.executable, "-c", f"import sys; sys.argv[1:1] = []; {script}")
    with pytest.raises(TelemetryError, match="return invalid data"):
        read_other_camera(camera, AXES, command=command)


def test_the_scratch_copy_is_removed(camera, tmp_path, monkeypatch):
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(scratch))
    camera.write_text("panic")
    with pytest.raises(TelemetryError):
        read_other_camera(camera, AXES)
    assert list(scratch.iterdir()) == []


def marked(path, name="", mark="", end=b""):
    """Write an MP4 with a track of data that has a name and a mark, and a sound."""
    with av.open(str(path), "w", format="mp4") as file:
        sound = file.add_stream("aac", rate=48_000)
        data = file.add_data_stream("bin_data")
        data.codec_tag = "gpmd"
        data.metadata["handler_name"] = "handler-name-here"
        data.time_base = Fraction(1, 1000)
        frame = av.AudioFrame.from_ndarray(np.zeros((2, 1024), np.float32), "fltp")
        frame.sample_rate = 48_000
        file.mux(sound.encode(frame))
        packet = av.Packet(bytes(64))
        packet.stream, packet.pts, packet.dts, packet.duration = data, 0, 0, 20
        packet.time_base = Fraction(1, 1000)
        file.mux(packet)
        file.mux(sound.encode(None))
    content = path.read_bytes().replace(b"gpmd", (mark or "data").encode())
    content = content.replace(b"handler-name-here", name.ljust(17).encode())
    path.write_bytes(content + end)
    return path


INSTA360 = b"8db42d694ccc418790edff439fe026bf"


@pytest.mark.parametrize(
    ("made", "says"),
    [
        ({"mark": "rtmd"}, r"telemetry of Sony.*install hapticplayer\[cameras\]"),
        (
            {"end": bytes(40) + INSTA360},
            r"of Insta360.*install hapticplayer\[cameras\]",
        ),
        (
            {"end": INSTA360 + bytes((1 << 20) + 20)},
            r"of Insta360.*install hapticplayer\[cameras\]",
        ),
        ({"mark": "camm"}, "Google's CAMM, which nothing here reads"),
        ({"mark": "djmd"}, "DJI, .*stores orientations only"),
        ({"name": "DJI meta"}, "DJI, .*stores orientations only"),
        ({"mark": "CTMD"}, "Canon, which has no motion"),
        ({}, "contains no motion data"),
    ],
)
def test_clips_of_other_makers_name_what_they_hold(tmp_path, made, says):
    path = marked(tmp_path / "clip.mp4", **made)
    with pytest.raises(TelemetryError, match=says) as caught:
        read_recording(path)
    assert "--imu LOG" in str(caught.value)


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("rtmd.mp4", r"telemetry of Sony.*install hapticplayer\[cameras\]"),
        ("insta.insv", r"of Insta360.*install hapticplayer\[cameras\]"),
        ("camm.mp4", "Google's CAMM, which nothing here reads"),
    ],
)
def test_real_marks_of_other_makers_are_known(case, name, says):
    with pytest.raises(TelemetryError, match=says):
        read_recording(case(f"other-camera/{name}"))
