import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.errors import InputError, MediaError, TelemetryError
from hapticplayer.media.encode import write_clip
from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry
from hapticplayer.model import ClockMap, ImuLog
from tests.needed_extras import needs
from tests.unit.capture.conftest import device, recorded, sensor


@pytest.fixture(scope="module")
def mute_clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "mute.mp4"
    pictures = [np.full((48, 64, 3), 9 * number, np.uint8) for number in range(20)]
    write_clip(path, pictures, frame_rate_hz=10.0)
    return path


def test_gopro_video_is_recognised():
    recording = read_recording(recorded("gopro/karma.mp4"))
    assert len(recording.imu) == 2397
    assert recording.camera == "Camera"
    assert recording.clock_map == ClockMap()
    assert recording.provenance["reader"] == "GPMF track"
    assert recording.provenance["gyro_rate_hz"] == pytest.approx(397.3, abs=0.2)
    assert recording.imu.source.endswith("karma.mp4")


def test_raw_dump_is_recognised_whatever_its_name(tmp_path):
    path = tmp_path / "dump.csv"
    path.write_bytes(recorded("gopro/hero8_grass.gpmf").read_bytes())
    assert read_recording(path).camera == "HERO8 Black"


def test_log_is_recognised_and_its_clock_is_open(tmp_path):
    path = tmp_path / "log.txt"
    rows = [f"{n / 100},0,0,9.8{n % 3},0,0,0.0{n % 2}" for n in range(50)]
    path.write_text("\n".join(["time_s,ax,ay,az,gx,gy,gz", *rows]))
    recording = read_recording(path)
    assert len(recording.imu) == 50
    assert recording.clock_map.confidence == 0.0
    assert recording.notes == ()


def test_repaired_samples_are_noted(tmp_path):
    path = tmp_path / "log.csv"
    rows = [f"{n / 100},0,0,9.8{n % 3},0,0,0.0{n % 2}" for n in range(50)]
    rows[7] = "0.07,,,,0,0,0"
    path.write_text("\n".join(["time_s,ax,ay,az,gx,gy,gz", *rows]))
    recording = read_recording(path)
    assert recording.imu.valid is not None
    assert np.flatnonzero(~recording.imu.valid).tolist() == [7]
    assert len(recording.notes) == 1
    assert "line 9" in recording.notes[0]


def test_gap_is_noted(tmp_path):
    times_s = np.concatenate([np.arange(50), np.arange(80, 120)]) / 100
    path = tmp_path / "log.csv"
    rows = [f"{time_s},0,0,9.8,0,0,0" for time_s in times_s]
    path.write_text("\n".join(["time_s,ax,ay,az,gx,gy,gz", *rows]))
    assert "one gap, the longest of 0.31 s at 0.49 s" in read_recording(path).notes[0]


def test_synthetic_camera_file_is_read_with_its_times(tmp_path, mute_clip):
    streams = [
        sensor("ACCL", [[9.8, 0.0, 0.0]] * 200),
        sensor("GYRO", [[0.0] * 3] * 200),
    ]
    payload = device("HERO5 Black", *streams)
    packets = [TelemetryPacket(float(k), 1.0, payload) for k in range(4)]
    path = tmp_path / "camera.mp4"
    add_telemetry(mute_clip, path, packets)
    recording = read_recording(path)
    assert recording.camera == "HERO5 Black"
    assert recording.imu.rate_hz == pytest.approx(200.0)
    np.testing.assert_allclose(recording.imu.specific_force_mps2[:, 2], 9.8, rtol=1e-6)


@needs("frames")
def test_video_without_motion_names_the_remedy(mute_clip):
    with pytest.raises(TelemetryError) as caught:
        read_recording(mute_clip)
    assert str(caught.value) == (
        f"{mute_clip}: contains no motion data; give the log, too (--imu LOG), or "
        "have the motion estimated from the frames (--suggest-motion)"
    )


@pytest.mark.parametrize(
    ("content", "error"),
    [
        (b"", InputError),
        (b"DEVC", TelemetryError),
        (b"DEVC\0\x01\xff\xffgarbage", TelemetryError),
        (b"hello", InputError),
        (b"\0\0\0\x18ftypmp42" + bytes(300), MediaError),
        (np.random.default_rng(1).bytes(5000), MediaError),
    ],
)
def test_nonsense_is_refused_in_one_sentence(tmp_path, content, error):
    path = tmp_path / "nonsense.bin"
    path.write_bytes(content)
    with pytest.raises(error) as caught:
        read_recording(path)
    assert "nonsense.bin" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_text_is_recognised_when_a_character_is_cut(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("x" * 4095 + "ü" * 10)
    with pytest.raises(InputError, match="the header is"):
        read_recording(path)


def test_importing_the_room_loads_neither_pyav_nor_scipy():
    code = (
        "import sys, hapticplayer.capture, hapticplayer.media;"
        "print([m for m in ('av', 'scipy') if m in sys.modules])"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"


def test_units_and_axes_of_a_camera_are_noted(tmp_path):
    """A HERO9 at rest shows 9.83 m/s2 here, by its own norm; 1.3 g is implausible."""
    from hapticplayer.extras.rides.gpmf_writer import write_payloads

    real = read_recording(recorded("gopro/hero9_rotation.gpmd"))
    assert "9.83 m/s2 at rest" in real.notes[0]
    assert "x right, y forward, z up" in real.notes[0]
    largest = float(np.abs(real.imu.angular_rate_radps).max())
    assert f"up to {largest:.2f} rad/s" in real.notes[0]
    rng = np.random.default_rng(3)
    force = np.array([0.0, 0.0, 1.3 * 9.81]) + 0.02 * rng.standard_normal((2000, 3))
    still = ImuLog(np.arange(2000) / 200.0, force, np.full((2000, 3), 0.001))
    path = tmp_path / "still.gpmf"
    path.write_bytes(b"".join(payload for _, payload in write_payloads(still)))
    notes = read_recording(path).notes
    assert any("at rest instead of 9.81" in note for note in notes)
    assert not any("instead of 9.81" in note for note in real.notes)
