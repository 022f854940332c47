"""The camera's own orientation at each frame against its gyro, whose lag is made up."""

import struct

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from hapticplayer.capture import read_recording
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.capture.recording import Recording
from hapticplayer.media.telemetry import TelemetryPacket
from tests.needed_extras import needs
from tests.unit.capture.conftest import device, klv, nested, recorded, sensor, shorts

PAYLOAD_S, PAYLOADS = 1.001, 12
FRAMES = 30
RATE_HZ = 200
UP_ZXY = (9.80665, 0.0, 0.0)


def orientations(time_s: np.ndarray, seed: int = 1, rms_rad: float = 0.02) -> Rotation:
    """Return the camera's orientation, sensor to earth in frame A: a wander of 0.3 to 4 Hz."""
    rng = np.random.default_rng(seed)
    hz, phase = rng.uniform(0.3, 4.0, (12, 3)), rng.uniform(0.0, 6.3, (12, 3))
    waves = np.sin(2 * np.pi * hz * time_s[:, None, None] + phase)
    return Rotation.from_rotvec(rms_rad * np.sqrt(2 / 12) * waves.sum(axis=1))


def cori(stamp_us: int, rotations: Rotation) -> bytes:
    """Return a payload's CORI entry: w, x, z, y of earth to camera."""
    x, y, z, w = rotations.inv().as_quat().T
    stored = np.stack([w, x, -z, y], axis=1)
    return nested(
        "STRM",
        klv("STMP", "J", struct.pack(">Q", stamp_us), 8),
        shorts("SCAL", [[32767]]),
        shorts("CORI", np.rint(32767 * stored)),
    )


def recording(
    lag_s: float,
    *,
    rms_rad: float = 0.02,
    seeds: tuple[int, int] = (1, 1),
    repeated_in: int | None = None,
    payloads: int = PAYLOADS,
) -> Recording:
    """Return a camera whose gyro is stamped too late by `lag_s`."""
    packets, first = [], 0
    rng = np.random.default_rng(3)
    for number in range(payloads):
        begin_us = 1_000_000 + round(1e6 * PAYLOAD_S * number)
        stamp_s = 1.0 + PAYLOAD_S * number
        index = np.arange(RATE_HZ)
        at_s = stamp_s - lag_s + index * PAYLOAD_S / RATE_HZ
        # a sample is the mean rate of the interval that ends at it
        turned = orientations(at_s - PAYLOAD_S / RATE_HZ, seeds[0], rms_rad).inv()
        turned = turned * orientations(at_s, seeds[0], rms_rad)
        rate = turned.as_rotvec() * RATE_HZ / PAYLOAD_S
        rate += 0.003 * rng.standard_normal(rate.shape)
        # frame A is x right, y front, z up; the camera's axes are left, back, up
        rate_zxy = np.stack([rate[:, 2], -rate[:, 0], -rate[:, 1]], axis=1)
        frame_s = stamp_s + np.arange(FRAMES) * PAYLOAD_S / FRAMES
        if number == repeated_in:
            frame_s = np.append(frame_s, frame_s[-1])
        first += RATE_HZ
        streams = (
            sensor(
                "ACCL", np.tile(UP_ZXY, (RATE_HZ, 1)), total=first, stamp_us=begin_us
            ),
            sensor("GYRO", rate_zxy, total=first, stamp_us=begin_us),
            cori(begin_us, orientations(frame_s, seeds[1], rms_rad)),
        )
        payload = device("HERO9 Black", *streams)
        packets.append(TelemetryPacket(PAYLOAD_S * number, PAYLOAD_S, payload))
    return read_gopro(packets)


@pytest.mark.parametrize("lag_s", [0.0, 0.013, -0.021, 0.04])
@needs("frames")
def test_lag_of_the_gyro_is_measured_and_taken_out(lag_s):
    found = recording(lag_s)

    assert found.lag is not None
    assert found.lag.measured_by == "cori"
    assert found.lag.lag_s == pytest.approx(lag_s, abs=1e-4)
    assert abs(found.lag.lag_s - lag_s) < 4.0 * found.lag.sigma_s
    assert found.lag.sigma_s < 1e-4
    # what is stamped 5 s + lag happened at frame time 5 s
    clock = found.clock_map
    assert clock.rate * (5.0 + lag_s) + clock.offset_s == pytest.approx(5.0, abs=1e-4)
    assert found.provenance["clock_lag"]["measured_by"] == "cori"
    assert any("CORI" in note for note in found.notes)


@needs("frames")
def test_a_repeated_orientation_does_not_matter():
    """As a HERO8 and a HERO9 write it."""
    found = recording(0.008, repeated_in=4)

    assert found.lag is not None
    assert found.lag.lag_s == pytest.approx(0.008, abs=3e-4)


@pytest.mark.parametrize(
    "flaw",
    [{"rms_rad": 0.0}, {"seeds": (1, 2)}, {"payloads": 3}],
    ids=["still", "other motion", "short"],
)
def test_an_indistinct_orientation_changes_nothing(flaw):
    found = recording(0.013, **flaw)

    assert found.lag is None
    assert found.clock_map.offset_s == 0.0
    assert "clock_lag" not in found.provenance


@pytest.mark.parametrize(
    ("name", "lag_ms", "tolerance_ms"),
    [
        # 13.0 ms where a sample is taken to be of its own time, not of the 5 ms before
        ("max-heromode.mp4", 10.5, 0.1),
        ("hero8_grass.gpmf", -2.4, 0.2),
        ("hero9_rotation.gpmd", -0.7, 1.0),
    ],
)
@needs("frames")
def test_lag_of_real_cameras(name, lag_ms, tolerance_ms):
    found = read_recording(recorded(f"gopro/{name}"))

    assert found.lag is not None
    assert 1e3 * found.lag.lag_s == pytest.approx(lag_ms, abs=tolerance_ms)
    assert found.lag.sigma_s < 5e-4
