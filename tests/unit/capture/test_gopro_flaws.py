"""Missing samples, compasses, and cameras without accelerations."""

import re

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.assemble import as_answered
from hapticplayer.capture.choices import LogQuestion, parse_choices
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.errors import TelemetryError
from hapticplayer.media.telemetry import TelemetryPacket
from tests.faults.import_formats import gopro_payloads
from tests.faults.import_signal import (
    Sampled,
    sample,
    true_field,
    true_force,
    true_rate,
)
from tests.unit.capture.conftest import device, recorded, sensor


def packets(clean: Sampled) -> list[TelemetryPacket]:
    return [TelemetryPacket(t, 1.0, payload) for t, payload in gopro_payloads(clean)]


def test_motion_in_closed_form_comes_back():
    telemetry = read_gopro(packets(sample(apart=True)))
    t = telemetry.imu.time_s
    assert telemetry.provenance["accelerometer_rate_hz"] == pytest.approx(
        100.0, abs=0.01
    )
    assert telemetry.provenance["gyro_rate_hz"] == pytest.approx(107.0, abs=0.01)
    assert np.abs(telemetry.imu.specific_force_mps2 - true_force(t)).max() < 0.06
    rate_error = telemetry.imu.angular_rate_radps - true_rate(t)
    assert np.abs(rate_error).max() < 0.02
    assert len(telemetry.notes) == 1  # how it was read


def _stamps_of(content: bytes, key: bytes) -> list[int]:
    """Where the time stamps of a sensor's streams stand."""
    places = [one.end() for one in re.finditer(b"STMPJ...", content, re.DOTALL)]
    ends = [content.find(b"STRM", place) % (len(content) + 1) for place in places]
    pairs = zip(places, ends, strict=True)
    return [place for place, end in pairs if key in content[place:end]]


@pytest.mark.parametrize("key", [b"ACCL", b"GYRO"])
@pytest.mark.parametrize(
    ("payload", "off_s"),
    [(3, 0.05), (5, 0.5), (6, 5.0), (4, 1e4), (0, 5.0), (-1, 50.0)],
)
def test_one_lying_stamp_moves_no_sample(tmp_path, key, payload, off_s):
    """It made the stamps run backwards, or all of them ignored."""
    source = recorded("gopro/hero8_grass.gpmf")
    content = bytearray(source.read_bytes())
    at = _stamps_of(bytes(content), key)[payload]
    stamp_us = int.from_bytes(content[at : at + 8], "big") + round(1e6 * off_s)
    content[at : at + 8] = stamp_us.to_bytes(8, "big")
    (tmp_path / "lying.gpmf").write_bytes(content)
    before, after = (read_recording(p) for p in (source, tmp_path / "lying.gpmf"))
    assert len(after.imu) == len(before.imu)
    assert np.abs(after.imu.time_s - before.imu.time_s).max() < 1e-3
    assert after.notes == before.notes


def test_missing_accelerations_are_filled_and_marked():
    clean = sample(apart=True)
    clean.force[500:505] = np.nan
    telemetry = read_gopro(packets(clean))
    imu = telemetry.imu
    assert imu.valid is not None
    bad_s = imu.time_s[~imu.valid]
    assert len(bad_s) == 5
    np.testing.assert_allclose(bad_s, clean.force_s[500:505], atol=2e-3)
    assert any("were filled in" in note for note in telemetry.notes)


def test_missing_rates_are_marked_where_they_were_missing():
    """A tenth of a second of NaN in the faster gyro does not spread."""
    clean = sample(apart=True)
    lost = slice(700, 711)
    clean.rate[lost] = np.nan
    imu = read_gopro(packets(clean)).imu
    assert imu.valid is not None
    bad_s = imu.time_s[~imu.valid]
    assert bad_s.min() > clean.rate_s[700] - 0.03
    assert bad_s.max() < clean.rate_s[710] + 0.03
    assert 8 <= len(bad_s) <= 13
    good = imu.valid
    error = imu.angular_rate_radps - true_rate(imu.time_s)
    assert np.abs(error[good]).max() < 0.02


def with_compass(components: int, orin: str) -> list[TelemetryPacket]:
    """The closed form's field in MAGN, 25 a second, stored as Z, X, Y."""
    out = []
    for t, payload in gopro_payloads(sample(apart=True)):
        times = t + np.arange(25) / 25.0
        x, y, z = true_field(times).T
        stored = np.stack([z, -x, -y], axis=1)
        if components == 4:
            stored = np.concatenate([np.full((25, 1), 7.0), stored], axis=1)
        total = 25 * (round(t) + 1)
        stamp_us = round(1e6 * (t + 1.0))
        magn = sensor("MAGN", stored, orin=orin, total=total, stamp_us=stamp_us)
        # into the camera's own DEVC, whose length stands in its head
        body = payload[8:] + magn
        head = payload[:4] + b"\0\x01" + len(body).to_bytes(2, "big")
        out.append(TelemetryPacket(t, 1.0, head + body))
    return out


@pytest.mark.parametrize("components", [3, 4])
def test_compass_is_rotated_into_frame_a(components):
    imu = read_gopro(with_compass(components, "ZXY")).imu
    assert imu.magnetic_field_ut is not None
    error = np.abs(imu.magnetic_field_ut - true_field(imu.time_s))
    inside = imu.time_s < 11.9
    assert error[inside].max() < 0.1


def test_compass_without_axes_is_ignored_with_a_note():
    telemetry = read_gopro(with_compass(3, ""))
    assert telemetry.imu.magnetic_field_ut is None
    assert any("compass is ignored" in note for note in telemetry.notes)


def test_compass_of_the_fusion_is_ignored():
    recording = read_recording(recorded("gopro/fusion.bin"))
    assert recording.imu.magnetic_field_ut is None
    assert any("declare its axes" in note for note in recording.notes)


def test_real_recordings_need_no_repair():
    for name in ("karma.mp4", "hero06.bin", "hero8_grass.gpmf", "hero9_rotation.gpmd"):
        recording = read_recording(recorded(f"gopro/{name}"))
        assert recording.imu.valid is None, name
        assert not any("filled" in note for note in recording.notes), name


def test_orientations_without_accelerations_are_refused():
    """What a DJI-like GPMF would be: quaternions only."""
    payload = device("Osmo", sensor("CORI", np.tile([1.0, 0, 0, 0], (30, 1))))
    with pytest.raises(TelemetryError, match="no accelerometer samples"):
        read_gopro(
            [TelemetryPacket(0.0, 1.0, payload), TelemetryPacket(1.0, 1.0, payload)]
        )


def test_a_rate_in_degrees_is_asked_about():
    """A damaged SCAL: the angular rate is 57 times too high."""
    clean = sample(apart=True, seconds=40.0)
    right = as_answered(read_gopro(packets(clean), "clip.mp4"), parse_choices([]))
    clean.rate[:] = np.degrees(clean.rate)
    damaged = read_gopro(packets(clean), "clip.mp4")
    with pytest.raises(LogQuestion, match="57 times too high") as asked:
        as_answered(damaged, parse_choices([]))
    answer = str(asked.value.answers[0]).split()[0]
    mended = as_answered(damaged, parse_choices([answer]))
    np.testing.assert_allclose(
        mended.imu.angular_rate_radps, right.imu.angular_rate_radps, atol=1e-3
    )
