from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.capture import read_recording
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import TelemetryError
from hapticplayer.media.telemetry import TelemetryPacket
from hapticplayer.model import Sampling
from tests.unit.capture.conftest import (
    device,
    floats,
    nested,
    recorded,
    sensor,
    shorts,
    text,
)

UP_ZXY = (9.80665, 0.0, 0.0)  # stored as Z, X, Y


def read_file(name: str) -> Recording:
    return read_recording(recorded(f"gopro/{name}"))


# measured rates: reference table of the recordings (capture.md, section 1)
MEASURED = {
    "karma.mp4": ("Camera", 198.6, 397.0),
    "hero06.bin": ("Hero6 Black", 202.9, 202.9),
    "hero7_17s.gpmf": ("Hero7 Black", 198.4, 198.4),
    "hero8_grass.gpmf": ("HERO8 Black", 201.9, 201.9),
    "hero9_rotation.gpmd": ("HERO9 Black", 200.2, 200.2),
    "fusion.bin": ("Fusion", 189.5, None),
}


@pytest.mark.parametrize("name", MEASURED)
def test_real_recording_has_its_true_rates(name: str) -> None:
    camera, force_hz, rate_hz = MEASURED[name]
    telemetry = read_file(name)
    assert telemetry.camera == camera
    assert telemetry.provenance["accelerometer_rate_hz"] == pytest.approx(
        force_hz, abs=0.2
    )
    assert telemetry.imu.rate_hz == pytest.approx(force_hz, abs=0.2)
    if rate_hz is not None:
        tolerance_hz = 0.4 if rate_hz > 300.0 else 0.2
        assert telemetry.provenance["gyro_rate_hz"] == pytest.approx(
            rate_hz, abs=tolerance_hz
        )
    assert telemetry.imu.sampling is Sampling.INSTANT


# norms of the table in capture.md 2.5; HERO7 is upside down and in rough motion
@pytest.mark.parametrize(
    ("name", "norm", "tolerance"),
    [
        ("hero9_rotation.gpmd", 9.92, 0.02),
        ("hero06.bin", 10.8, 0.05),
        ("karma.mp4", 9.8, 0.1),
        ("fusion.bin", 9.8, 0.2),
        ("hero8_grass.gpmf", 9.8, 0.2),
    ],
)
def test_mean_norm_is_about_gravity(name: str, norm: float, tolerance: float) -> None:
    imu = read_file(name).imu
    norms = np.linalg.norm(imu.specific_force_mps2, axis=1)
    assert np.mean(norms) == pytest.approx(norm, abs=tolerance)


@pytest.mark.parametrize("name", ["karma.mp4", "hero06.bin", "fusion.bin"])
def test_camera_held_upright_feels_gravity_upwards(name: str) -> None:
    mean = read_file(name).imu.specific_force_mps2.mean(axis=0)
    assert mean[2] > 0.9 * np.linalg.norm(mean)


@pytest.mark.parametrize(
    ("name", "residual_s"),
    [("karma.mp4", 8e-3), ("hero06.bin", 9e-3), ("hero9_rotation.gpmd", 2e-3)],
)
def test_time_residuals_are_those_of_the_reference(
    name: str, residual_s: float
) -> None:
    """The count of samples before each payload against the payload's start."""
    imu = read_file(name).imu
    starts_s = np.arange(1, int(imu.time_s[-1] / 1.001)) * 1.001
    nearest_s = imu.time_s[np.searchsorted(imu.time_s, starts_s)]
    assert np.abs(nearest_s - starts_s).max() <= 1.0 / imu.rate_hz + residual_s


def test_whole_of_karma_is_covered_without_gaps() -> None:
    imu = read_file("karma.mp4").imu
    assert len(imu) == 2397
    assert -0.03 < imu.time_s[0] < 0.03
    assert imu.time_s[-1] == pytest.approx(12.08, abs=0.03)
    assert np.diff(imu.time_s).max() < 1.01 / 198.6


def test_fusion_stores_floats_and_a_fast_gyro() -> None:
    telemetry = read_file("fusion.bin")
    assert telemetry.provenance["gyro_rate_hz"] == pytest.approx(3210.0, abs=5.0)
    assert len(telemetry.imu) > 2800


def test_time_lapse_is_refused_with_the_reason() -> None:
    path = recorded("gopro/hero13_timelapse.bin")
    with pytest.raises(TelemetryError, match="407 motion samples in 407 payloads") as e:
        read_recording(path)
    assert "time-lapse" in str(e.value)
    assert "record normal video" in str(e.value)
    assert path.name in str(e.value)


def test_cameras_without_stamps_are_noted() -> None:
    assert "does not timestamp" in read_file("karma.mp4").notes[1]
    assert len(read_file("hero9_rotation.gpmd").notes) == 1  # how it was read


def synthetic(
    counts: list[int],
    *,
    rate_hz: float = 200.0,
    stamps: NDArray[np.int64] | None = None,
    frame0_us: int = 0,
    totals: list[int] | None = None,
    **more: bytes,
) -> list[TelemetryPacket]:
    """Packets of a camera that turns about its upright axis, faster each second."""
    packets, first = [], 0
    for number, count in enumerate(counts):
        index = np.arange(first, first + count)
        stamp = None if stamps is None else int(stamps[number])
        total = first + count if totals is None else totals[number]
        force = np.tile(UP_ZXY, (count, 1))
        rate = np.stack([(index % 4000) / rate_hz, 0 * index, 0 * index], axis=1)
        streams = [
            sensor("ACCL", force, total=total, stamp_us=stamp),
            sensor("GYRO", rate, total=total, stamp_us=stamp),
        ]
        if stamps is not None:
            shutter = [[1.0]] * 30
            streams.append(
                sensor("SHUT", shutter, stamp_us=frame0_us + 1_001_000 * number)
            )
        payload = device("HERO9 Black", *streams, *more.values())
        packets.append(TelemetryPacket(1.001 * number, 1.001, payload))
        first += count
    return packets


def test_stamps_place_the_samples_relative_to_the_first_picture() -> None:
    stamps = 500_000 - 12_000 + 1_000_000 * np.arange(5)
    packets = synthetic([200] * 5, stamps=stamps, frame0_us=500_000)
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.time_s, -0.012 + np.arange(1000) / 200.0, atol=1e-9)
    np.testing.assert_allclose(
        imu.angular_rate_radps[:, 2], np.arange(1000) / 200.0, atol=1e-5
    )
    np.testing.assert_allclose(imu.specific_force_mps2[:, 2], 9.80665, atol=1e-5)


def test_long_recordings_follow_a_drifting_sensor_clock() -> None:
    """Above a minute the line is broken at each payload: 1 part in 1e4 drift."""
    start_s = np.arange(120.0) * (1.0 + 1e-6 * np.arange(120.0))
    packets = synthetic([200] * 120, stamps=np.rint(1e6 * start_s).astype(np.int64))
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.time_s[::200], start_s, atol=2e-6)
    straight = np.polynomial.Polynomial.fit(np.arange(len(imu)), imu.time_s, 1)
    bend_s = np.abs(imu.time_s - straight(np.arange(len(imu)))).max()
    assert bend_s > 1e-3, "one line would have been wrong by milliseconds"


def test_without_stamps_the_counts_give_the_rate() -> None:
    """Sensor at 198.6 Hz; the last payload is short but nominally as long."""
    rng = np.random.default_rng(5)
    ends = np.arange(1, 13) * 1.001 * 198.6 + rng.uniform(-5, 5, 12)
    counts = np.diff(np.concatenate([[0.0], ends]).astype(int)).tolist()
    telemetry = read_gopro(synthetic([*counts, 14]))
    assert telemetry.provenance["accelerometer_rate_hz"] == pytest.approx(
        198.6, abs=0.3
    )
    naive_hz = (sum(counts) + 14) / (13 * 1.001)
    assert abs(naive_hz - 198.6) > 10.0, "what the nominal duration would give"


def test_sensor_that_starts_early_does_not_bend_the_line() -> None:
    """HERO7 delivers 234 samples in the first second."""
    packets = synthetic([234] + [199] * 10, rate_hz=198.8)
    telemetry = read_gopro(packets)
    assert telemetry.provenance["accelerometer_rate_hz"] == pytest.approx(
        199 / 1.001, abs=0.1
    )
    assert telemetry.imu.time_s[0] == pytest.approx(-35 / 198.8, abs=0.01)


def test_later_chapter_counts_from_its_own_start() -> None:
    totals = [199_173 + 200 * number for number in range(1, 6)]
    first = read_gopro(synthetic([200] * 5)).imu
    later = read_gopro(synthetic([200] * 5, totals=totals)).imu
    np.testing.assert_array_equal(first.time_s, later.time_s)


def test_lost_samples_leave_a_gap() -> None:
    stamps = np.array([0, 1_000_000, 2_500_000, 3_500_000])
    totals = [200, 400, 700, 900]
    imu = read_gopro(synthetic([200] * 4, totals=totals, stamps=stamps)).imu
    steps_s = np.diff(imu.time_s)
    assert steps_s.max() == pytest.approx(0.505, abs=1e-3)
    assert np.sum(steps_s > 0.006) == 1


def test_senseless_totals_are_not_believed() -> None:
    totals = [200, 100, 2_000_000_000, 5]
    plain = read_gopro(synthetic([200] * 4)).imu
    np.testing.assert_array_equal(
        plain.time_s, read_gopro(synthetic([200] * 4, totals=totals)).imu.time_s
    )


@pytest.mark.parametrize(
    "stamps",
    [
        [0, 1_000_000, 900_000, 3_000_000],  # backwards
        [0, 2_000_000, 4_000_000, 6_000_000],  # another pace
        [9_000_000, 10_000_000, 11_000_000, 12_000_000],  # far from the pictures
    ],
)
def test_stamps_that_contradict_the_video_are_not_believed(stamps: list[int]) -> None:
    packets = synthetic([200] * 4, stamps=np.array(stamps))
    telemetry = read_gopro(packets)
    assert "does not timestamp" in telemetry.notes[1]
    assert telemetry.imu.time_s[-1] == pytest.approx(4.0, abs=0.01)


def test_raw_dumps_of_any_length_believe_their_stamps() -> None:
    """Their assumed payload times are off by seconds in the end."""
    start_s = np.arange(40) * 1.25
    packets = synthetic([250] * 40, stamps=np.rint(1e6 * start_s).astype(np.int64))
    with_times = read_gopro(packets).imu
    without = read_gopro(packets, is_raw=True)
    assert not any("stamp" in note for note in without.notes)
    assert with_times.time_s[-1] < without.imu.time_s[-1]


def test_drone_that_carries_the_camera_is_ignored() -> None:
    drone = device("Karma", sensor("ACCL", np.full((200, 3), 3.0)), number=99)
    packets = [
        TelemetryPacket(p.start_s, p.duration_s, p.payload + drone)
        for p in synthetic([200] * 3)
    ]
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.specific_force_mps2[:, 2], 9.80665, atol=1e-5)


def test_scale_per_axis_is_divided() -> None:
    stream = nested(
        "STRM", text("ORIN", "ZXY"), shorts("SCAL", [[100], [10], [1]]),
        shorts("ACCL", [[981, 5, 2]] * 200),
    )  # fmt: skip
    gyro = sensor("GYRO", np.zeros((200, 3)))
    packets = [
        TelemetryPacket(float(k), 1.0, device("HERO9 Black", stream, gyro))
        for k in range(2)
    ]
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.specific_force_mps2[0], [-0.5, -2.0, 9.81])


@pytest.mark.parametrize(
    ("streams", "sentence"),
    [
        ([], "no accelerometer samples"),
        ([sensor("GYRO", np.zeros((200, 3)))], "no accelerometer samples"),
        ([sensor("ACCL", np.zeros((200, 3)))], "no gyro samples"),
        (
            [sensor("ACCL", np.zeros((200, 2))), sensor("GYRO", np.zeros((200, 3)))],
            "no accelerometer samples",
        ),
        (
            [sensor("ACCL", np.zeros((200, 3)), orin="XXY"), sensor("GYRO", np.zeros((200, 3)))],
            "are not axes",
        ),
        (
            [sensor("ACCL", np.zeros((200, 3)), orin="XYz"), sensor("GYRO", np.zeros((200, 3)))],
            "mirror",
        ),
        (
            [sensor("ACCL", np.full((200, 3), 1e6)), sensor("GYRO", np.zeros((200, 3)))],
            "beyond what sensors measure",
        ),
        (
            [sensor("ACCL", np.full((200, 3), np.nan)), sensor("GYRO", np.zeros((200, 3)))],
            "beyond what sensors measure",
        ),
        (
            [
                nested("STRM", shorts("SCAL", [[0]]), floats("ACCL", np.ones((200, 3)))),
                sensor("GYRO", np.zeros((200, 3))),
            ],
            "scale of ACCL is damaged",
        ),
    ],
)  # fmt: skip
def test_unusable_telemetry_is_refused_in_one_sentence(
    streams: list[bytes], sentence: str
) -> None:
    packets = [
        TelemetryPacket(float(k), 1.0, device("HERO9 Black", *streams))
        for k in range(3)
    ]
    with pytest.raises(TelemetryError, match=sentence) as caught:
        read_gopro(packets, "ride.mp4")
    assert str(caught.value).startswith("ride.mp4: ")
    assert "; " in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("limit", "value"), [("MAX_PAYLOADS", 3), ("MAX_SAMPLES", 600)]
)
def test_limits_hold_at_their_value_and_refuse_beyond(
    monkeypatch: pytest.MonkeyPatch, limit: str, value: int
) -> None:
    name = f"hapticplayer.capture.gopro_streams.{limit}"
    monkeypatch.setattr(name, value)
    assert len(read_gopro(synthetic([200] * 3)).imu) == 600
    monkeypatch.setattr(name, value - 1)
    with pytest.raises(TelemetryError, match=r"too many|more than is read"):
        read_gopro(synthetic([200] * 3))


def test_huge_dump_is_refused_before_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "dump.gpmf"
    path.write_bytes(b"".join(p.payload for p in synthetic([200] * 3)))
    size_bytes = path.stat().st_size
    name = "hapticplayer.capture.gopro.MAX_RAW_GPMF_BYTES"
    monkeypatch.setattr(name, size_bytes)
    assert len(read_recording(path).imu) == 600
    monkeypatch.setattr(name, size_bytes - 1)
    with pytest.raises(TelemetryError, match="too many"):
        read_recording(path)


def mutated(content: bytes, rng: np.random.Generator) -> bytes:
    """Flip bits, zero or repeat a span, cut, or write extreme numbers."""
    damaged = bytearray(content)
    kind = rng.integers(5)
    at, length = int(rng.integers(len(damaged))), int(rng.integers(1, 400))
    if kind == 0:
        for _ in range(int(rng.choice([1, 20, 300]))):
            damaged[int(rng.integers(len(damaged)))] ^= 1 << int(rng.integers(8))
    elif kind == 1:
        damaged[at : at + length] = bytes(len(damaged[at : at + length]))
    elif kind == 2:
        damaged[at:at] = damaged[at : at + length]
    elif kind == 3:
        del damaged[at:]
    else:
        damaged[at : at + 8] = b"\x7f\xff\xff\xff\xff\xff\xff\xff"
    return bytes(damaged)


def test_no_damage_gets_out_as_numbers(tmp_path: Path) -> None:
    """120 damaged dumps: each is refused, or gives finite, increasing samples."""
    rng = np.random.default_rng(9)
    content = recorded("gopro/hero7_17s.gpmf").read_bytes()
    path = tmp_path / "damaged.gpmf"
    refused = 0
    for _ in range(120):
        path.write_bytes(mutated(content, rng))
        try:
            imu = read_recording(path).imu
        except TelemetryError:
            refused += 1
            continue
        assert np.diff(imu.time_s).min() > 0.0  # ImuLog refuses what is not finite
        assert np.abs(imu.specific_force_mps2).max() <= 500.0
        assert np.abs(imu.angular_rate_radps).max() <= 100.0
    assert refused < 120
