from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.capture import read_recording
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import TelemetryError
from hapticplayer.media.telemetry import TelemetryPacket, read_telemetry_packets
from hapticplayer.model import Sampling
from tests.faults.import_cases import READ, REFUSED, judge, mutated
from tests.faults.import_formats import FORMATS, put
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


class Real(NamedTuple):
    """What is known of a real recording (rates and norms: capture.md, section 1 and 2.5)."""

    camera: str
    accel_hz: float
    gyro_hz: float
    norm: float | None  # HERO7 is upside down and in rough motion
    tolerance: float
    is_upright: bool = False
    residual_s: float | None = None  # of the counts against the payloads' starts


REAL = {
    "karma.mp4": Real("Camera", 198.6, 397.0, 9.8, 0.1, True, 8e-3),
    "hero06.bin": Real("Hero6 Black", 202.9, 202.9, 10.8, 0.05, True, 9e-3),
    "hero7_17s.gpmf": Real("Hero7 Black", 198.4, 198.4, None, 0.0),
    "hero8_grass.gpmf": Real("HERO8 Black", 201.9, 201.9, 9.8, 0.2),
    "hero9_rotation.gpmd": Real("HERO9 Black", 200.2, 200.2, 9.92, 0.02, False, 2e-3),
    "fusion.bin": Real("Fusion", 189.5, 3210.0, 9.8, 0.2, True),
}


@pytest.mark.parametrize("name", REAL)
def test_real_recording_has_its_rates_and_gravity(name):
    known, recording = REAL[name], read_file(name)
    imu, made_of = recording.imu, recording.provenance
    assert recording.camera == known.camera
    assert imu.sampling is Sampling.INSTANT
    assert imu.rate_hz == pytest.approx(known.accel_hz, abs=0.2)
    assert made_of["accelerometer_rate_hz"] == pytest.approx(known.accel_hz, abs=0.2)
    assert made_of["gyro_rate_hz"] == pytest.approx(known.gyro_hz, rel=2e-3)
    accel = imu.specific_force_mps2
    if known.norm is not None:
        mean_norm = np.linalg.norm(accel, axis=1).mean()
        assert mean_norm == pytest.approx(known.norm, abs=known.tolerance)
    mean = accel.mean(axis=0)
    assert (mean[2] > 0.9 * np.linalg.norm(mean)) or not known.is_upright
    if known.residual_s is not None:
        starts_s = np.arange(1, int(imu.time_s[-1] / 1.001)) * 1.001
        nearest_s = imu.time_s[np.searchsorted(imu.time_s, starts_s)]
        apart_s = np.abs(nearest_s - starts_s).max()
        assert apart_s <= 1.0 / imu.rate_hz + known.residual_s


def test_whole_of_karma_is_covered_without_gaps():
    imu = read_file("karma.mp4").imu
    assert len(imu) == 2397
    assert -0.03 < imu.time_s[0] < 0.03
    assert imu.time_s[-1] == pytest.approx(12.08, abs=0.03)
    assert np.diff(imu.time_s).max() < 1.01 / 198.6


def test_time_lapse_is_refused_with_the_reason():
    path = recorded("gopro/hero13_timelapse.bin")
    with pytest.raises(TelemetryError, match="407 motion samples in 407 payloads") as e:
        read_recording(path)
    assert "time-lapse" in str(e.value)
    assert "record normal video" in str(e.value)
    assert path.name in str(e.value)


def test_cameras_without_stamps_are_noted():
    assert "does not timestamp" in read_file("karma.mp4").notes[1]
    assert not any(
        "timestamp its" in note for note in read_file("hero9_rotation.gpmd").notes
    )


def synthetic(
    counts: list[int],
    *,
    rate_hz: float = 200.0,
    stamps: NDArray[np.int64] | None = None,
    frame0_us: int | None = 0,
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
        if stamps is not None and frame0_us is not None:
            shutter = [[1.0]] * 30
            streams.append(
                sensor("SHUT", shutter, stamp_us=frame0_us + 1_001_000 * number)
            )
        payload = device("HERO9 Black", *streams, *more.values())
        packets.append(TelemetryPacket(1.001 * number, 1.001, payload))
        first += count
    return packets


def test_stamps_are_relative_to_the_first_frame():
    stamps = 500_000 - 12_000 + 1_000_000 * np.arange(5)
    packets = synthetic([200] * 5, stamps=stamps, frame0_us=500_000)
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.time_s, -0.012 + np.arange(1000) / 200.0, atol=1e-9)
    np.testing.assert_allclose(
        imu.angular_rate_radps[:, 2], np.arange(1000) / 200.0, atol=1e-5
    )
    np.testing.assert_allclose(imu.specific_force_mps2[:, 2], 9.80665, atol=1e-5)


def test_long_recordings_follow_a_drifting_sensor_clock():
    """Above a minute the line is broken at each payload: 1 part in 1e4 drift."""
    start_s = np.arange(120.0) * (1.0 + 1e-6 * np.arange(120.0))
    packets = synthetic([200] * 120, stamps=np.rint(1e6 * start_s).astype(np.int64))
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.time_s[::200], start_s, atol=2e-6)
    straight = np.polynomial.Polynomial.fit(np.arange(len(imu)), imu.time_s, 1)
    bend_s = np.abs(imu.time_s - straight(np.arange(len(imu)))).max()
    assert bend_s > 1e-3, "one line would have been wrong by milliseconds"


def test_without_stamps_the_counts_give_the_rate():
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


def test_sensor_that_starts_early_does_not_bend_the_line():
    """HERO7 delivers 234 samples in the first second."""
    packets = synthetic([234] + [199] * 10, rate_hz=198.8)
    telemetry = read_gopro(packets)
    assert telemetry.provenance["accelerometer_rate_hz"] == pytest.approx(
        199 / 1.001, abs=0.1
    )
    assert telemetry.imu.time_s[0] == pytest.approx(-35 / 198.8, abs=0.01)


def test_later_chapter_counts_from_its_own_start():
    totals = [199_173 + 200 * number for number in range(1, 6)]
    first = read_gopro(synthetic([200] * 5)).imu
    later = read_gopro(synthetic([200] * 5, totals=totals)).imu
    np.testing.assert_array_equal(first.time_s, later.time_s)


def test_lost_samples_leave_a_gap():
    stamps = np.array([0, 1_000_000, 2_500_000, 3_500_000])
    totals = [200, 400, 700, 900]
    imu = read_gopro(synthetic([200] * 4, totals=totals, stamps=stamps)).imu
    steps_s = np.diff(imu.time_s)
    assert steps_s.max() == pytest.approx(0.505, abs=1e-3)
    assert np.sum(steps_s > 0.006) == 1


def test_implausible_totals_are_ignored():
    totals = [200, 100, 2_000_000_000, 5]
    plain = read_gopro(synthetic([200] * 4)).imu
    np.testing.assert_array_equal(
        plain.time_s, read_gopro(synthetic([200] * 4, totals=totals)).imu.time_s
    )


@pytest.mark.parametrize(
    "stamps",
    [
        [0, 1_900_000, 900_000, 3_000_000],  # backwards
        [0, 2_000_000, 4_000_000, 6_000_000],  # another pace
        [9_000_000, 10_000_000, 11_000_000, 12_000_000],  # far from the frames
    ],
)
def test_stamps_that_contradict_the_video_are_ignored(stamps):
    packets = synthetic([200] * 4, stamps=np.array(stamps))
    telemetry = read_gopro(packets)
    assert "does not timestamp" in telemetry.notes[1]
    assert telemetry.imu.time_s[-1] == pytest.approx(4.0, abs=0.01)


def test_raw_dumps_of_any_length_believe_their_stamps():
    """Their assumed payload times are off by seconds in the end."""
    start_s = np.arange(40) * 1.25
    packets = synthetic([250] * 40, stamps=np.rint(1e6 * start_s).astype(np.int64))
    with_times = read_gopro(packets).imu
    without = read_gopro(packets, is_raw=True)
    assert not any("stamp" in note for note in without.notes)
    assert with_times.time_s[-1] < without.imu.time_s[-1]


def test_drone_that_carries_the_camera_is_ignored():
    drone = device("Karma", sensor("ACCL", np.full((200, 3), 3.0)), number=99)
    packets = [
        TelemetryPacket(p.start_s, p.duration_s, p.payload + drone)
        for p in synthetic([200] * 4)
    ]
    imu = read_gopro(packets).imu
    np.testing.assert_allclose(imu.specific_force_mps2[:, 2], 9.80665, atol=1e-5)


@pytest.mark.parametrize("every", [1, 2])
def test_devices_of_one_payload_share_its_time(tmp_path, every):
    """One DEVC for the camera, one for a drone or a sensor that comes and goes."""
    other = device("SENSORB6", sensor("acc1", np.full((80, 3), 3.0)), number=99)
    path = tmp_path / "dump.raw"
    path.write_bytes(
        b"".join(
            packet.payload + other * (number % every == 0)
            for number, packet in enumerate(synthetic([199] * 12))
        )
    )
    recording = read_recording(path)
    assert len(recording.imu) == 12 * 199
    rate_hz = recording.provenance["accelerometer_rate_hz"]
    assert rate_hz == pytest.approx(199 / 1.001, abs=0.01)


def test_dump_of_camera_and_drone_is_as_long_as_the_video(tmp_path):
    """karma.mp4 has both in each packet; one after the other they are karma.raw."""
    clip = recorded("gopro/karma.mp4")
    path = tmp_path / "karma.raw"
    path.write_bytes(
        b"".join(packet.payload for packet in read_telemetry_packets(clip))
    )
    imu = read_recording(path).imu
    assert imu.rate_hz == pytest.approx(198.7, abs=0.1)
    assert imu.time_s[-1] - imu.time_s[0] == pytest.approx(12.06, abs=0.01)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_few_payloads_without_stamps_tell_no_rate(count):
    """By its counts the HERO7 would run at 234 Hz instead of 199."""
    packets = synthetic([234, 199, 199][:count])
    with pytest.raises(
        TelemetryError, match=rf"too few payloads \({count}\)"
    ) as caught:
        read_gopro(packets)
    assert "record at least 4 s" in str(caught.value)


@pytest.mark.parametrize("shutter_us", [0, None])
def test_stamps_of_two_payloads_give_the_rate(shutter_us):
    """Also without the stamps of the frames; the payloads' starts say 233.8 Hz."""
    stamps = np.array([0, round(234 / 199.0 * 1e6)])
    packets = synthetic([234, 199], stamps=stamps, frame0_us=shutter_us)
    recording = read_gopro(packets)
    assert recording.provenance["accelerometer_rate_hz"] == pytest.approx(
        199.0, abs=0.01
    )
    assert recording.imu.time_s[0] == pytest.approx(0.0, abs=1e-6)


def test_scale_per_axis_is_divided():
    stream = nested(
        "STRM", text("ORIN", "ZXY"), shorts("SCAL", [[100], [10], [1]]),
        shorts("ACCL", [[981, 5, 2]] * 200),
    )  # fmt: skip
    gyro = sensor("GYRO", np.zeros((200, 3)))
    packets = [
        TelemetryPacket(float(k), 1.0, device("HERO9 Black", stream, gyro))
        for k in range(4)
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
def test_unusable_telemetry_is_refused_in_one_sentence(streams, sentence):
    packets = [
        TelemetryPacket(float(k), 1.0, device("HERO9 Black", *streams))
        for k in range(4)
    ]
    with pytest.raises(TelemetryError, match=sentence) as caught:
        read_gopro(packets, "ride.mp4")
    assert str(caught.value).startswith("ride.mp4: ")
    assert "; " in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("limit", "value"), [("MAX_PAYLOADS", 4), ("MAX_SAMPLES", 800)]
)
def test_limits_hold_at_their_value_and_refuse_beyond(monkeypatch, limit, value):
    name = f"hapticplayer.capture.gopro_streams.{limit}"
    monkeypatch.setattr(name, value)
    assert len(read_gopro(synthetic([200] * 4)).imu) == 800
    monkeypatch.setattr(name, value - 1)
    with pytest.raises(TelemetryError, match=r"too many|more than is read"):
        read_gopro(synthetic([200] * 4))


def test_huge_dump_is_refused_before_it_is_read(tmp_path, monkeypatch):
    path = tmp_path / "dump.gpmf"
    path.write_bytes(b"".join(p.payload for p in synthetic([200] * 4)))
    size_bytes = path.stat().st_size
    name = "hapticplayer.capture.gopro.MAX_RAW_GPMF_BYTES"
    monkeypatch.setattr(name, size_bytes)
    assert len(read_recording(path).imu) == 800
    monkeypatch.setattr(name, size_bytes - 1)
    with pytest.raises(TelemetryError, match="is too large"):
        read_recording(path)


def test_no_damage_gets_out_as_numbers(tmp_path):
    """Each of 120 damaged dumps is refused, or gives finite, increasing samples."""
    content = recorded("gopro/hero7_17s.gpmf").read_bytes()
    outcomes = set()
    for number in range(120):
        damaged = mutated({"a.gpmf": content}, np.random.default_rng([9, number]))
        path = put(damaged, tmp_path / "in")
        outcomes.add(judge(path, FORMATS["GoPro, raw"]).outcome)
    assert outcomes == {READ, REFUSED}


@pytest.mark.parametrize("mark", [b"gpmd", b"mebx"])
def test_a_track_that_was_renamed_is_read(shared_data, tmp_path, mark):
    content = (shared_data / "capture" / "gopro" / "karma.mp4").read_bytes()
    renamed = tmp_path / "renamed.mp4"
    assert content.count(b"GoPro MET") == 1
    renamed.write_bytes(
        content.replace(b"GoPro MET", b"Core Meta").replace(b"gpmd", mark)
    )
    found = read_recording(renamed).imu
    own = read_recording(shared_data / "capture" / "gopro" / "karma.mp4").imu
    assert np.array_equal(found.specific_force_mps2, own.specific_force_mps2)
    assert np.array_equal(found.time_s, own.time_s)
