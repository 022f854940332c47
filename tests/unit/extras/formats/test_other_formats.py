"""WAV, MPEG-V, funscript and AHAP: units, axes, and what others write."""

import json
import math
import re
import struct
from dataclasses import replace

import numpy as np
import pytest
from scipy.io import wavfile
from scipy.signal import resample_poly

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, MotionTrack, Reconstruction
from hapticplayer.sequence.excursion import predict, travel_m
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    loss_line,
    read_force,
)

RAMP = ForceTrack([0.0, 0.5, 1.0], [[0, 0, 0], [1, 2, -3], [0, 0, 0]])
SEM = (
    '<SEM xmlns="urn:mpeg:mpeg-v:2010:01-SEDL-NS" '
    'xmlns:sev="urn:mpeg:mpeg-v:2010:01-SEV-NS" '
    'xmlns:si="urn:mpeg:mpeg21:2003:01-DIA-XSI-NS" '
    'xmlns:mpeg7="urn:mpeg:mpeg7:schema:2004" '
    'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" si:timeScale="1000">{}</SEM>'
)


@pytest.fixture
def written(tmp_path):
    def write(name, track=RAMP, **choices):
        path = tmp_path / f"track{force_formats()[name].suffix}"
        export_track(track, path, force_formats()[name], WriteChoices(**choices))
        return path

    return write


@pytest.fixture
def read(tmp_path):
    def reader(content, suffix, **choices):
        path = tmp_path / f"other{suffix}"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return read_force(path, ReadChoices(**choices))

    return reader


@pytest.fixture
def scripts(shared_data):
    folder = shared_data / "cases" / "funscript-axes"
    if not folder.is_dir():
        pytest.skip("the case funscript-axes is not on this machine")
    return folder


def at(track, *seconds):
    return track.at(np.array(seconds, dtype=float))


@pytest.mark.parametrize("rate", [1000, 8000])
def test_wav_is_read_by_others_and_carries_its_scale(written, rate):
    path = written("wav", sample_rate_hz=rate)
    found_rate, samples = wavfile.read(path)
    assert (found_rate, samples.shape[1]) == (rate, 3)
    np.testing.assert_allclose(samples[rate // 2] * 3.0, [1, 2, -3], rtol=1e-5)
    assert b"newton = sample * 3.000; x, y, z" in path.read_bytes()[:200]


@pytest.mark.parametrize("kind", [np.int16, np.int32, np.float32, np.uint8])
def test_wav_of_others_acts_along_the_chosen_direction(tmp_path, kind):
    wave = 0.5 * np.sin(2.0 * np.pi * 20.0 * np.arange(48000) / 48000.0)
    if kind is np.uint8:
        samples = np.round(128 + 127 * wave).astype(kind)
    else:
        most = 1.0 if kind is np.float32 else np.iinfo(kind).max
        samples = (wave * most).astype(kind)
    wavfile.write(tmp_path / "a.wav", 48000, samples)
    found = read_force(
        tmp_path / "a.wav", ReadChoices(full_scale_n=2.0, direction=(0.0, 0.0, 1.0))
    )
    force_n = at(found.track, 0.2125, 0.2375)  # a quarter of a period, and three
    np.testing.assert_allclose(force_n, [[0, 0, 1], [0, 0, -1]], atol=0.02)
    assert len(found.notes) == 3


@pytest.mark.parametrize("rate", [8001, 12345, 44100, 48000])
def test_wav_is_slowed_down_in_blocks_as_in_one(tmp_path, rng, monkeypatch, rate):
    monkeypatch.setattr("hapticplayer.extras.formats.wav_read.SAMPLES_AT_ONCE", 20000)
    samples = rng.normal(0.0, 0.1, (70001, 3)).astype(np.float32)
    wavfile.write(tmp_path / "a.wav", rate, samples)
    common = math.gcd(rate, 1000)
    whole = resample_poly(samples, 1000 // common, rate // common, axis=0)
    found = read_force(tmp_path / "a.wav").track
    np.testing.assert_allclose(found.force_n, whole, atol=1e-6)
    np.testing.assert_allclose(found.time_s, np.arange(len(whole)) / 1000.0)


def chunk(name, content):
    return name + struct.pack("<I", len(content)) + content + b"\0" * (len(content) % 2)


def sound(form, data, *after, before=()):
    """A WAV file of chunks."""
    body = b"WAVE" + chunk(b"fmt ", form) + b"".join(before) + chunk(b"data", data)
    body += b"".join(after)
    return b"RIFF" + struct.pack("<I", len(body)) + body


def form_of(code, channels, bits, block, extension=b""):
    return (
        struct.pack("<HHIIHH", code, channels, 1000, 1000 * block, block, bits)
        + extension
    )


def extensible(channels, bits, block, valid, code=1):
    tail = bytes.fromhex("000000001000800000AA00389B71")
    more = struct.pack("<HHIH", 22, valid, 0, code) + tail
    return form_of(0xFFFE, channels, bits, block, more)


WAVE = 0.5 * np.sin(np.arange(300).reshape(-1, 3) / 9.0)
FORMS = {
    "12 bits above in 2": (form_of(1, 3, 12, 6), 2, 12, 4),
    "12 bits below in 2": (form_of(1, 3, 12, 6), 2, 12, 0),
    "16 bits": (form_of(1, 3, 16, 6), 2, 16, 0),
    "20 bits above in 3": (form_of(1, 3, 20, 9), 3, 20, 4),
    "24 bits": (form_of(1, 3, 24, 9), 3, 24, 0),
    "24 bits above in 4": (form_of(1, 3, 24, 12), 4, 24, 8),
    "24 bits below in 4": (form_of(1, 3, 24, 12), 4, 24, 0),
    "32 bits that say 24": (form_of(1, 3, 24, 12), 4, 32, 0),
    "extensible, 16 bits": (extensible(3, 16, 6, 16), 2, 16, 0),
    "extensible, 24 above in 4": (extensible(3, 32, 12, 24), 4, 24, 8),
    "extensible, 24 below in 4": (extensible(3, 32, 12, 24), 4, 24, 0),
    "extensible, no valid bits": (extensible(3, 16, 6, 0), 2, 16, 0),
}


@pytest.mark.parametrize("kind", FORMS)
def test_wav_samples_are_where_their_bits_are(read, kind):
    form, width, bits, shift = FORMS[kind]
    whole = np.round(WAVE * (1 << (bits - 1))).astype(np.int64) << shift
    data = whole.astype("<i8").tobytes()
    packed = np.frombuffer(data, "u1").reshape(-1, 8)[:, :width].tobytes()
    silence = b"\0" * (len(packed) // len(WAVE)) * 7
    found = read(sound(form, silence + packed), ".wav", full_scale_n=2.0)
    np.testing.assert_allclose(found.track.force_n[7:], 2.0 * WAVE, atol=2e-3)
    assert any("lower end" in str(note) for note in found.assumed) == ("below" in kind)


@pytest.mark.parametrize(
    ("form", "says"),
    [
        (form_of(1, 3, 24, 10), "24 bits in 10 bytes for 3 channels"),
        (form_of(1, 3, 24, 6), "24 bits in 6 bytes"),
        (form_of(1, 3, 16, 0), "unusual format"),
        (form_of(1, 0, 16, 2), "unusual format"),
        (form_of(3, 3, 16, 6), "unusual format"),
        (form_of(2, 3, 4, 12), "unusual format"),
        (extensible(3, 16, 6, 24), "unusual format"),
        (extensible(3, 16, 6, 16)[:-1] + b"x", "unusual format"),
    ],
)
def test_wav_that_contradicts_itself_is_refused(read, form, says):
    with pytest.raises(InputError, match=says):
        read(sound(form, b"\1" * 120), ".wav")


def test_extensible_wav_of_floats_is_read(read):
    data = WAVE.astype("<f4").tobytes()
    found = read(sound(extensible(3, 32, 12, 32, 3), data), ".wav")
    np.testing.assert_allclose(found.track.force_n, WAVE, atol=1e-6)


def test_three_channels_of_others_are_said_to_be_axes(read):
    found = read(sound(form_of(3, 3, 32, 12), WAVE.astype("<f4").tobytes()), ".wav")
    assert "three channels were taken as x, y and z" in map(str, found.assumed)


@pytest.mark.parametrize("name", [b"LIST", b"id3 "])
@pytest.mark.parametrize("filler", [0, 5001])
def test_our_own_scale_is_found_behind_the_samples(read, name, filler):
    comment = b"INFOICMT\0\0" + b" " * filler
    comment += b"hapticplayer force; newton = sample * 8.000; x, y, z"
    content = sound(
        form_of(3, 3, 32, 12), WAVE.astype("<f4").tobytes(), chunk(name, comment)
    )
    found = read(content, ".wav")
    np.testing.assert_allclose(found.track.force_n, 8.0 * WAVE, atol=1e-5)
    assert found.notes == ()


def test_samples_that_are_missing_at_the_end_are_said(read):
    content = sound(form_of(3, 3, 32, 12), WAVE.astype("<f4").tobytes())
    (note,) = read(content[:-120], ".wav").unread
    assert str(note) == "the last 10 samples are missing"


def test_a_streamed_wav_has_no_length_and_is_whole(read):
    content = sound(form_of(3, 3, 32, 12), WAVE.astype("<f4").tobytes())
    size = struct.pack("<I", 12 * len(WAVE))
    found = read(content.replace(b"data" + size, b"data\xff\xff\xff\xff"), ".wav")
    assert len(found.track.time_s) == len(WAVE)
    assert found.unread == ()


def test_a_wav_for_more_than_4_gb_is_read(read, written):
    plain = written("wav").read_bytes()
    place = plain.index(b"data") + 4
    (size,) = struct.unpack_from("<I", plain, place)
    ds64 = b"ds64" + struct.pack("<IQQQI", 28, 0, size, 0, 0)
    long = b"RF64" + plain[4:12] + ds64 + plain[12:place] + b"\xff" * 4
    found = read(long + plain[place + 4 :] + b"LIST\4\0\0\0abcd", ".wav")
    assert not found.notes
    assert at(found.track, 0.5)[0] == pytest.approx([1, 2, -3], abs=1e-3)


@pytest.mark.parametrize(("magic", "code"), [(b"RIFF", 6), (b"RIFX", 1)])
def test_another_wav_is_refused_with_what_makes_pcm_of_it(read, magic, code):
    form = struct.pack("<HHIIHH", code, 1, 8000, 8000, 1, 8)
    chunks = b"WAVEfmt " + struct.pack("<I", 16) + form + b"data\4\0\0\0abcd"
    with pytest.raises(InputError, match=r"with: ffmpeg -i \S+ -c:a pcm_f32le"):
        read(magic + b"\0\0\0\0" + chunks, ".wav")


def test_our_wav_has_what_its_format_requires(written):
    content, chunks, at_byte = written("wav").read_bytes(), {}, 12
    while at_byte < len(content):
        name = content[at_byte : at_byte + 4]
        size = struct.unpack_from("<I", content, at_byte + 4)[0]
        chunks[name] = content[at_byte + 8 : at_byte + 8 + size]
        at_byte += 8 + size + size % 2
    assert list(chunks) == [b"fmt ", b"fact", b"LIST", b"data"]
    assert at_byte == len(content) == 8 + struct.unpack_from("<I", content, 4)[0]
    assert len(chunks[b"fmt "]) == 18
    assert struct.unpack("<H", chunks[b"fmt "][16:]) == (0,)  # nothing is added to it
    frames = len(chunks[b"data"]) // 12
    assert struct.unpack("<I", chunks[b"fact"]) == (frames,)


def test_wav_of_too_many_samples_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("hapticplayer.extras.formats.wav_read.MAX_SAMPLES", 99)
    wavfile.write(tmp_path / "a.wav", 1000, np.zeros(100, dtype=np.float32))
    with pytest.raises(InputError, match="too many values"):
        read_force(tmp_path / "a.wav")


def test_wav_with_samples_that_are_no_numbers_is_refused(written):
    path = written("wav")
    content = bytearray(path.read_bytes())
    content[-4:] = struct.pack("<f", float("nan"))
    path.write_bytes(content)
    with pytest.raises(InputError, match="no numbers"):
        read_force(path)


def test_mpegv_holds_newtons_and_milliseconds(written):
    text = written("mpegv").read_text()
    assert 'si:timeScale="1000"' in text
    assert 'xsi:type="sev:PassiveKinestheticForceType" si:pts="0"' in text
    assert "1.0000 2.0000 -3.0000" in text


def test_mpegv_is_valid_by_the_schema_of_2010(written, shared_data):
    etree = pytest.importorskip("lxml.etree")
    schema = shared_data / "interchange" / "mpegv-2010" / "MPEG-V-SEV.xsd"
    if not schema.is_file():
        pytest.skip("the schema (interchange/mpegv-2010) is not in the shared data")
    parser = etree.XMLParser(no_network=True, resolve_entities=False)
    rules = etree.XMLSchema(etree.parse(str(schema), parser))
    path = written("mpegv", motion=moving((1, 2, 3)))
    assert rules.validate(etree.parse(str(path), parser))


def test_mpegv_effects_of_others_are_read_and_the_rest_is_listed(read):
    effects = (
        '<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="1000" '
        'duration="100" timeSamples="3"><sev:PassiveKinestheticForce mpeg7:dim="3 3">'
        "0 2 0 0 4 0 0 0 0</sev:PassiveKinestheticForce></Effect>"
        '<GroupOfEffects><Effect xsi:type="sev:ActiveKinestheticType" si:pts="2000" '
        'duration="100"><sev:ActiveKinesthetic fx="1" fy="-1.5" fz="0.5"/></Effect>'
        '<Effect xsi:type="sev:WindType" si:pts="0" duration="10"/></GroupOfEffects>'
    )
    found = read(SEM.format(effects), ".sem")
    np.testing.assert_allclose(at(found.track, 1.0, 1.025, 1.075)[:, 1], [2, 3, 2])
    np.testing.assert_allclose(at(found.track, 2.05)[0], [1, -1.5, 0.5])
    assert [str(note) for note in found.notes] == ["not read: Wind (1)"]


def test_mpegv_motion_and_vibration_become_force(read):
    effects = (
        '<Effect xsi:type="sev:RigidBodyMotionType" si:pts="0" duration="1000">'
        '<sev:MoveToward directionH="0" directionV="0" acceleration="2.5"/></Effect>'
        '<Effect xsi:type="sev:VibrationType" si:pts="2000" duration="1000" '
        'intensity-value="50" intensity-range="0 100"/>'
    )
    found = read(SEM.format(effects), ".xml", full_scale_n=2.0)
    np.testing.assert_allclose(at(found.track, 0.5)[0], [0, 0, -1.0], atol=1e-6)
    assert np.abs(found.track.force_n[:, 1]).max() == pytest.approx(1.0, abs=1e-3)


HALF = 'intensity-value="50" intensity-range="0 100"'


def shake(more="", begin=0, length=1000, level=HALF):
    timed = f'duration="{length}"' if length else ""
    when = "" if begin is None else f'si:pts="{begin}"'
    return f'<Effect xsi:type="sev:VibrationType" {when} {timed} {level} {more}/>'


def felt(track, *spans_s):
    """Largest force in spans of media time."""
    return [
        np.abs(track.at(np.arange(begin_s, end_s, 0.001))).max()
        for begin_s, end_s in spans_s
    ]


def test_durations_of_playsem_are_seconds(read):
    pair = (
        shake('activate="true"', 900_000, 0, 'intensity-value="100"')
        + shake('activate="false"', 1_080_000, 0, "")
    )  # fmt: skip
    text = SEM.format(shake('activate="true"', 90_000, 3) + pair)
    found = read(text.replace('"1000">', '"90000">'), ".sem")
    spans = [(0, 1), (1, 4), (4.001, 10), (10, 12), (12.001, 14)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 0, 1, 0], atol=1e-3)
    assert "seconds" in str(found.assumed[0])
    assert found.unread == ()


@pytest.mark.parametrize("scale", [1000, 90_000])
def test_durations_of_the_standard_are_ticks(read, scale):
    effects = shake(begin=scale, length=scale // 2) + shake(
        begin=3 * scale, length=scale
    )
    found = read(SEM.format(effects).replace('"1000">', f'"{scale}">'), ".sem")
    spans = [(0, 1), (1, 1.5), (1.501, 3), (3, 4), (4.001, 5)]
    np.testing.assert_allclose(
        felt(found.track, *spans), [0, 0.5, 0, 0.5, 0], atol=1e-3
    )
    assert len(found.notes) == 1


def test_short_taps_that_follow_each_other_are_ticks(read):
    taps = "".join(shake(begin=500 * row, length=15) for row in range(4))
    found = read(SEM.format(taps), ".sem")
    assert felt(found.track, (0.016, 0.5), (0.516, 1.0)) == [0.0, 0.0]
    assert felt(found.track, (1.5, 1.515))[0] > 0.4


def test_an_effect_lasts_until_the_next_of_its_kind(read):
    effects = (
        shake('activate="true"', 1000, 0)
        + shake('activate="true"', 2000, 0, 'intensity-value="100"')
        + '<Effect xsi:type="sev:WindType" si:pts="2500" duration="100"/>'
        + shake('activate="false"', 3000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 1), (1, 2), (2, 3), (3.001, 4)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 1, 0], atol=1e-3)
    assert [str(note) for note in found.unread] == ["not read: Wind (1)"]


def test_an_effect_without_an_end_lasts_as_long_as_the_clip(read):
    text = SEM.format(shake(length=100) + shake('activate="true"', 1000, 0))
    found = read(text, ".sem")
    assert [str(note) for note in found.unread] == [
        "not read: Vibration without an end (1)"
    ]
    assert felt(found.track, (0.2, 5)) == [0.0]
    found = read(text, ".sem", until_s=5.0)
    assert found.unread == ()
    assert felt(found.track, (4, 5))[0] == pytest.approx(0.5, abs=1e-3)


def test_an_effect_that_is_not_active_is_not_felt(read):
    effects = shake() + shake('activate="false"', 5000, 1000)
    found = read(SEM.format(effects), ".sem")
    assert felt(found.track, (1.001, 9)) == [0.0]
    with pytest.raises(InputError, match="activate must be true or false"):
        read(SEM.format(shake('activate="maybe"')), ".sem")


def test_switching_off_without_a_place_ends_all_of_its_kind(read):
    left, right = (f'activate="true" location="{side}"' for side in ("left", "right"))
    effects = (
        shake(left, 0, 0)
        + shake(right, 500, 0)
        + shake('activate="false"', 2000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 0.5), (1, 2), (2.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [0.5, 1.0, 0.0], atol=1e-3)
    one = shake(left, 0, 0) + shake(right, 500, 0)
    one += shake('activate="false" location="left"', 2000, 0, "")
    one += shake('activate="false" location="right"', 3000, 0, "")
    found = read(SEM.format(one), ".sem")
    spans = [(1, 2), (2.001, 3), (3.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [1.0, 0.5, 0.0], atol=1e-3)


def test_a_vibration_without_an_intensity_is_listed(read):
    (note,) = read(SEM.format(shake(level="") + shake(begin=2000)), ".sem").unread
    assert "vibration without an intensity (1)" in str(note)


def test_times_without_a_scale_are_said_to_be_milliseconds(read):
    found = read(
        SEM.format(shake(begin=2000)).replace('si:timeScale="1000"', ""), ".sem"
    )
    assert "times were taken as milliseconds" in map(str, found.assumed)
    assert felt(found.track, (2, 3))[0] > 0.4


def test_switching_off_ends_a_duration(read):
    effects = shake(length=5000) + shake('activate="0"', 1000, 0)
    found = read(SEM.format(effects), ".sem")
    np.testing.assert_allclose(
        felt(found.track, (0, 1), (1.001, 5)), [0.5, 0.0], atol=1e-3
    )


@pytest.mark.parametrize(
    ("level", "share"),
    [
        ('intensity-value="0.5" intensity-range="0.0 1.0"', 0.5),
        ('intensity-value="5" intensity-range="0 10"', 0.5),
        ('intensity-value="-15" intensity-range="-30 30"', 0.5),
        ('intensity-value="75" intensity-range="50 100"', 0.5),
        ('intensity-value="300" intensity-range="0 255"', 1.0),
        ('intensity-value="50"', 0.5),
        ('intensity="25" intensity-range="0 1e2"', 0.25),
    ],
)
def test_an_intensity_is_a_share_of_its_range(read, level, share):
    found = read(SEM.format(shake(level=level)), ".sem")
    assert felt(found.track, (0, 1))[0] == pytest.approx(share, abs=1e-3)


def test_an_intensity_beyond_its_range_is_limited_and_said(read):
    most = 'intensity-value="150" intensity-range="0 100"'
    found = read(SEM.format(shake(level=most)), ".sem")
    assert np.abs(found.track.force_n).max() == pytest.approx(1.0, abs=1e-3)
    assert "beyond their range" in " ".join(map(str, found.notes))


def test_a_refusal_of_mpegv_names_what_was_not_understood(read):
    with pytest.raises(InputError, match=r"not read: Vibration without an end \(1\)"):
        read(SEM.format(shake(length=0)), ".sem")


def test_an_attribute_that_is_no_number_is_named(read):
    with pytest.raises(InputError, match="duration must be a number, not 'PT2S'"):
        read(SEM.format(shake(length="PT2S")), ".sem")


@pytest.mark.parametrize(
    "level",
    [
        'intensity-value="1_0"',
        'intensity-value="1j"',
        'intensity-value="1e400"',
        'intensity-value="5" intensity-range="100 0"',
        'intensity-value="5" intensity-range="0"',
        'intensity-value="5" intensity-range="a b"',
        'intensity-value="5" intensity-range="0 nan"',
    ],
)
def test_an_intensity_that_is_no_number_is_refused(read, level):
    with pytest.raises(InputError, match=r"intensity-(value|range) (is out|must be)"):
        read(SEM.format(shake(level=level)), ".sem")


def test_a_fade_rises_to_the_level(read):
    constant = (
        '<Effect xsi:type="sev:ActiveKinestheticType" si:pts="0" duration="1000" '
        'fade="400" ><sev:ActiveKinesthetic fx="1"/></Effect>'
    )
    force_n = at(read(SEM.format(constant), ".sem").track, 0.1, 0.2, 0.4, 0.9)[:, 0]
    np.testing.assert_allclose(force_n, [0.25, 0.5, 1, 1], atol=1e-4)


def test_a_fade_from_level_to_level_and_to_nothing(read):
    effects = (
        shake('activate="true"', 0, 0, 'intensity-value="40"')
        + shake('activate="true" fade="1000"', 1000, 0, 'intensity-value="80"')
        + shake('activate="false" fade="500"', 3000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 1), (1, 1.02), (1.48, 1.52), (2, 3), (3.24, 3.26), (3.501, 4)]
    wanted = [0.4, 0.4, 0.6, 0.8, 0.4, 0.0]
    np.testing.assert_allclose(felt(found.track, *spans), wanted, atol=0.03)


def test_a_group_gives_its_time_to_its_effects(read):
    group = (
        '<GroupOfEffects si:pts="5000" duration="2000" fade="1000">'
        f"{shake(begin=None, length=0)}{shake(begin=9000, length=500)}</GroupOfEffects>"
    )
    found = read(SEM.format(group), ".sem")
    spans = [(0, 5), (5.48, 5.52), (6, 7), (7.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.25, 0.5, 0], atol=0.03)
    assert felt(found.track, (9, 9.5))[0] > 0.2
    assert found.unread == ()


def test_a_time_before_that_of_the_group_is_said(read):
    group = f'<GroupOfEffects si:pts="5000">{shake(begin=10)}</GroupOfEffects>'
    (note,) = read(SEM.format(group), ".sem").unread
    assert "a time before that of its group (1)" in str(note)


def test_a_reference_plays_what_was_declared_at_its_own_time(read):
    one = shake('id="buzz"', 700, 400)
    text = SEM.format(
        f"<Declarations>{one}</Declarations>"
        '<ReferenceEffect uri="#buzz" si:pts="2000"/>'
        '<ReferenceEffect uri="#buzz" si:pts="4000" duration="1000"/>'
        '<ReferenceEffect uri="http://127.0.0.1/other.sem#buzz2" si:pts="9000"/>'
    )
    found = read(text, ".sem")
    spans = [(0, 2), (2, 2.4), (2.401, 4), (4, 5), (5.001, 7)]
    np.testing.assert_allclose(
        felt(found.track, *spans), [0, 0.5, 0, 0.5, 0], atol=1e-3
    )
    assert [str(note) for note in found.unread] == ["not read: ReferenceEffect (1)"]


def test_references_in_a_circle_are_refused(read):
    ring = '<GroupOfEffects id="a"><ReferenceEffect uri="#a"/></GroupOfEffects>'
    text = SEM.format(
        f'<Declarations>{ring}</Declarations><ReferenceEffect uri="#a" si:pts="0"/>'
    )
    with pytest.raises(InputError, match="too many values"):
        read(text, ".sem")


@pytest.mark.parametrize("old", ["si:pts", "si:timeScale"])
def test_a_time_without_its_prefix_counts(read, old):
    text = SEM.format(shake(begin=2000, length=500)).replace(old, old[3:])
    found = read(text, ".sem")
    assert felt(found.track, (0, 2)) == [0.0]
    assert felt(found.track, (2, 2.5))[0] == pytest.approx(0.5, abs=1e-3)


def test_a_relative_time_is_listed(read):
    later = shake().replace("si:pts", "si:ptsDelta")
    found = read(SEM.format(shake() + later), ".sem")
    assert "Effect with a time that is relative (1)" in str(found.unread[0])


@pytest.mark.parametrize("words", ["1 2 3 4", "1 2 x", "1 2 1_0", "1 2 3j", "1 2 nan"])
def test_a_matrix_of_other_words_is_refused(read, words):
    matrix = (
        '<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="0" duration="9">'
        f"<sev:PassiveKinestheticForce>{words}</sev:PassiveKinestheticForce></Effect>"
    )
    with pytest.raises(InputError, match="three numbers a row"):
        read(SEM.format(matrix), ".sem")


def test_a_matrix_that_lies_on_its_side_is_refused(written, read):
    text = written("mpegv").read_text()
    rows = re.search(r'dim="(\d+) 3"', text)[1]
    turned = text.replace(f'dim="{rows} 3"', f'dim="3 {rows}"')
    assert read(text, ".sem").track.peak_n() > 1.0
    with pytest.raises(InputError, match="three numbers a row"):
        read(turned, ".sem")


def test_effects_without_a_namespace_are_read(read):
    found = read(
        '<SEM><SensoryEffects><Effect type="vibration" timestamp="1500" '
        'duration="700" intensity="50" location="center"/>'
        '<Effect type="wind" timestamp="0" duration="10" intensity="60"/>'
        "</SensoryEffects></SEM>",
        ".xml",
        full_scale_n=2.0,
    )
    np.testing.assert_allclose(at(found.track, 1.4, 2.3), np.zeros((2, 3)))
    assert np.abs(found.track.force_n[:, 1]).max() == pytest.approx(1.0, abs=1e-3)
    assert str(found.notes[-1]) == "not read: Wind (1)"


def moving(acceleration_mps2, valid=True):
    rows = np.tile(np.asarray(acceleration_mps2, dtype=float), (201, 1))
    return MotionTrack(
        time_s=np.arange(201) / 200.0,
        acceleration_mps2=rows,
        gravity_mps2=np.zeros((201, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (201, 1)),
        gravity_sigma_mps2=None,
        valid=np.full(201, valid),
    )


NO_FORCE = ForceTrack([0.0, 1.0], np.zeros((2, 3)))


@pytest.mark.parametrize("way", [(0, 2, 0), (1, 0, 0), (0, 0, -3), (-1, -2, 1.5)])
def test_mpegv_motion_is_the_acceleration_of_the_actor(written, read, way):
    text = written("mpegv", NO_FORCE, motion=moving(way)).read_text()
    alone = SEM.format("".join(re.findall("<Effect.*RigidBody.*</Effect>", text)))
    force_n = at(read(alone, ".sem").track, 0.01, 0.5, 0.99)
    right, front, up = 0.4 * np.array(way)
    np.testing.assert_allclose(force_n, [[right, up, -front]] * 3, atol=0.02)
    assert text.count("MoveToward") == 20


def test_motion_beside_a_force_adds_nothing_to_it(written, read):
    plain = written("mpegv").read_bytes()
    path = written("mpegv", motion=moving((0, 2, 0)), overwrite=True)
    both = read_force(path)
    assert b"RigidBodyMotion" in path.read_bytes()
    np.testing.assert_array_equal(both.track.force_n, read(plain, ".sem").track.force_n)
    assert "left out (20)" in str(both.notes[0])


@pytest.mark.parametrize("motion", [moving((0, 0, 0)), moving((1, 2, 3), False)])
def test_motion_that_is_still_or_invalid_is_not_written(written, motion):
    assert "Rigid" not in written("mpegv", motion=motion).read_text()


@pytest.mark.parametrize("valid", [True, False])
def test_motion_that_is_not_valid_is_said_to_be_left_out(tmp_path, valid):
    choices = WriteChoices(motion=moving((1, 2, 3), valid))
    form = force_formats()["mpegv"]
    report = export_track(NO_FORCE, tmp_path / "a.sem", form, choices)
    assert bool(report["left_out"]) is not valid


def test_more_motion_than_is_read_is_refused(written, monkeypatch):
    monkeypatch.setattr("hapticplayer.extras.formats.mpegv.MAX_TAGS", 60)
    with pytest.raises(InputError, match="too long"):
        written("mpegv", motion=moving((0, 2, 0)))


@pytest.mark.parametrize(
    "head",
    [
        '<!DOCTYPE a [<!ENTITY b "c">]>',
        '<!DOCTYPE a SYSTEM "http://127.0.0.1/x.dtd">',
        '<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]>',
    ],
)
def test_xml_with_a_document_type_is_refused(read, head):
    with pytest.raises(InputError, match="not valid XML"):
        read(head + SEM.format(""), ".xml")


def positions(actions, time_s):
    rows = [(one["at"] / 1000.0, one["pos"]) for one in actions]
    return np.interp(time_s, *zip(*rows, strict=True))


@pytest.mark.parametrize("version", ["1.0", "1.1", "2.0"])
def test_a_funscript_holds_the_excursion_of_a_hand(written, version):
    push = ForceTrack([0.0, 2.0], [[0, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    path = written("funscript", push, duration_s=3.0, funscript_version=version)
    content = json.loads(path.read_text())
    time_s, place_m = travel_m(push, 3.0)
    up = positions(content["actions"], time_s)
    assert up.max() > 54.0  # pushed up
    np.testing.assert_allclose(up, 50 + 50 * place_m[:, 1] / 0.04, atol=1.0)
    if version == "2.0":
        surge = content["channels"]["surge"]["actions"]
        assert max(one["pos"] for one in surge) > 54  # forward is away from the user
    assert ("axes" in content) == (version == "1.1")


def test_a_script_of_version_1_0_is_a_file_for_each_axis(tmp_path):
    push = ForceTrack([0.0, 2.0], [[-1, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    form, path = force_formats()["funscript"], tmp_path / "ride.funscript"
    choices = WriteChoices(duration_s=3.0, funscript_version="1.0")
    report = export_track(push, path, form, choices)
    names = ["ride.funscript", "ride.surge.funscript", "ride.sway.funscript"]
    assert sorted(one.name for one in tmp_path.iterdir()) == sorted(names)
    assert report["beside"] == names[1:]
    assert report["bytes"] == sum(one.stat().st_size for one in tmp_path.iterdir())
    assert "the other axes are in ride.surge.funscript" in str(loss_line(report))
    time_s, place_m = travel_m(push, 3.0)
    for name, column, sign in zip(names, (1, 2, 0), (1, -1, -1), strict=True):
        content = json.loads((tmp_path / name).read_text())
        assert content.keys() == {"version", "metadata", "actions"}
        exact = 50 + 50 * sign * place_m[:, column] / 0.04
        there = positions(content["actions"], time_s)
        assert there.max() > 51.0
        np.testing.assert_allclose(there, exact, atol=1.0)
    with pytest.raises(InputError, match="exists"):
        export_track(push, path, form, choices)
    export_track(push, path, form, replace(choices, overwrite=True))


def test_a_version_1_0_is_read_like_a_version_1_1(written, tmp_path):
    push = ForceTrack([0.0, 2.0], [[-1, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    one = read_force(written("funscript", push, duration_s=3.0))
    path, form = tmp_path / "ride.funscript", force_formats()["funscript"]
    export_track(push, path, form, WriteChoices(3.0, funscript_version="1.0"))
    three = read_force(path)
    np.testing.assert_array_equal(three.track.force_n, one.track.force_n)
    assert "ride.surge.funscript beside it was read" in str(three.assumed[1])
    (tmp_path / "ride.sway.funscript").unlink()
    two = read_force(path).track
    assert not two.force_n[:, 0].any()
    assert two.force_n[:, 2].any()


def test_one_of_the_files_that_is_in_the_way_is_kept(tmp_path):
    (tmp_path / "ride.sway.funscript").write_text("dear")
    choices = WriteChoices(funscript_version="1.0", overwrite=True)
    form = force_formats()["funscript"]
    with pytest.raises(InputError, match="sway"):
        export_track(RAMP, tmp_path / "ride.funscript", form, choices)
    assert [one.name for one in tmp_path.iterdir()] == ["ride.sway.funscript"]


def test_the_excursion_is_the_one_that_is_predicted():
    push = ForceTrack([0.2, 1.7], [[0, 3, 0], [0, 0, 0]], Reconstruction.HOLD)
    _, place_m = travel_m(push, 3.0)
    reach = predict(push, 3.0).hands["normal"].reach
    assert np.linalg.norm(place_m, axis=1).max() / 0.04 == pytest.approx(
        reach, rel=0.02
    )


def test_a_funscript_has_few_positions_and_all_axes_are_near(written, rng):
    force_n = np.cumsum(rng.normal(0.0, 0.3, (2000, 3)), axis=0)
    track = ForceTrack(np.arange(2000) / 20.0, 2.0 * np.sin(force_n))
    content = json.loads(written("funscript", track).read_text())
    time_s, place_m = travel_m(track, float(track.time_s[-1]))
    axes = [content, *content["axes"]]
    for one, column, sign in zip(axes, (1, 2, 0), (1, -1, -1), strict=True):
        exact = 50 + 50 * sign * place_m[:, column] / 0.04
        there = positions(one["actions"], time_s)
        np.testing.assert_allclose(there, exact, atol=1.0)
        assert len(one["actions"]) < len(time_s) / 2


def test_a_funscript_of_too_many_positions_is_refused(written, monkeypatch):
    monkeypatch.setattr("hapticplayer.extras.formats.funscript.MAX_ACTIONS", 5)
    with pytest.raises(InputError, match="positions"):
        written("funscript")


def test_a_funscript_is_a_spring_set_point_on_three_axes(read):
    content = {
        "version": "1.1",
        "actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 100}],
        "axes": [
            {"id": "L1", "actions": [{"at": 0, "pos": 100}, {"at": 1000, "pos": 100}]},
            {"id": "R0", "actions": [{"at": 0, "pos": 0}]},
        ],
    }
    found = read(json.dumps(content), ".funscript", stiffness_n_per_m=50.0)
    # 50 N/m over 40 mm is 2 N
    np.testing.assert_allclose(at(found.track, 0.5)[0], [0, 1, -2], atol=1e-6)
    notes = [str(note) for note in found.notes]
    assert "set-point" in notes[0]
    assert notes[1] == "not read: R0 (1)"


LINE = [{"at": 0, "pos": 0}, {"at": 1000, "pos": 100}]
EDGE_N = 40.0 * 0.04
"""Of the usual spring at the edge of the workspace."""


def test_a_position_before_the_clip_is_on_the_line_to_the_next(read):
    actions = [
        {"at": -1000, "pos": 0},
        {"at": 400, "pos": 100},
        {"at": 900, "pos": 100},
    ]
    found = read(json.dumps({"actions": actions}), ".funscript")
    force_n = at(found.track, 0.0, 0.4, 0.8)[:, 1]
    first_n = EDGE_N * (100.0 / 1.4 - 50.0) / 50.0  # 71.4 at 0 ms
    np.testing.assert_allclose(force_n, [first_n, EDGE_N, EDGE_N], atol=1e-5)
    assert [str(note) for note in found.unread] == ["what lies before 0 s was left out"]


def test_the_positions_of_the_case_begin_on_the_line(scripts):
    found = read_force(scripts / "negative_at.funscript").track
    assert at(found, 0.0)[0, 1] == pytest.approx(0.69, abs=0.005)


@pytest.mark.parametrize("part", ["vib", "suck", "valve", "lube", "pump", "V0", "roll"])
def test_a_script_of_another_axis_is_refused(read, part):
    with pytest.raises(InputError, match=f"{part.lower()}.*not read"):
        read(json.dumps({"actions": LINE}), f".{part}.funscript")


@pytest.mark.parametrize("part", ["vib", "suck", "valve", "lube"])
def test_the_strengths_of_the_case_are_not_positions(scripts, part):
    with pytest.raises(InputError, match="strengths"):
        read_force(scripts / f"clip.{part}.funscript")


@pytest.mark.parametrize("name", ["roll", "pump", "left", "my.ride", "ride.v2"])
def test_a_script_with_such_a_name_alone_is_up(tmp_path, name):
    path = tmp_path / f"{name}.funscript"
    path.write_text(json.dumps({"actions": LINE}))
    assert at(read_force(path).track, 0.999)[0, 1] == pytest.approx(EDGE_N, abs=0.01)


def test_axes_beside_a_script_are_read_or_said(read, tmp_path):
    text = json.dumps({"actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 100}]})
    for name in ("other.Surge", "other.twist", "other.vib", "another.sway"):
        (tmp_path / f"{name}.funscript").write_text(text)
    found = read(text, ".funscript")
    assert at(found.track, 0.5)[0] == pytest.approx([0, 0.8, -0.8])
    notes = " ".join(map(str, found.notes))
    assert "other.Surge.funscript beside it was read" in notes
    assert "not read: other.twist.funscript" in notes
    assert "not read: other.vib.funscript" in notes
    assert "another" not in notes


def test_a_script_in_utf_16_is_named(read):
    with pytest.raises(InputError, match="UTF-16; save it as text in UTF-8"):
        read(json.dumps({"actions": []}).encode("utf-16"), ".funscript")


@pytest.mark.parametrize(
    ("content", "suffix"),
    [
        ('{"actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 50}]}', ".funscript"),
        ("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n1,0,0,0\n", ".csv"),
    ],
)
def test_a_file_without_any_force_is_said(read, content, suffix):
    assert "0 N from beginning to end" in " ".join(
        map(str, read(content, suffix).notes)
    )


@pytest.mark.parametrize(
    "more", [{"axes": [{"id": "L0"}]}, {"channels": {"stroke": {}}}]
)
def test_an_axis_that_is_there_twice_is_said(read, more):
    (held,) = more.values()
    other = held[0] if isinstance(held, list) else held["stroke"]
    other["actions"] = [{"at": 0, "pos": 50}, {"at": 1000, "pos": 50}]
    found = read(json.dumps({"actions": LINE, **more}), ".funscript")
    assert at(found.track, 0.999)[0, 1] == pytest.approx(EDGE_N, abs=0.01)
    assert [str(note) for note in found.unread] == [
        "L0 appears twice; the first was read"
    ]


@pytest.mark.parametrize("name", ["L1", "l1", "surge", "Forward"])
def test_an_axis_may_be_named_in_words(read, name):
    script = json.dumps({"axes": [{"id": name, "actions": LINE}]})
    assert at(read(script, ".funscript").track, 0.999)[0, 2] < -1.5


def test_two_positions_at_one_time_are_a_step(read):
    places = [(0, 100), (500, 100), (500, 25), (1000, 25)]
    actions = [{"at": at_ms, "pos": place} for at_ms, place in places]
    found = read(json.dumps({"actions": actions}), ".funscript").track
    force_n = at(found, 0.499, 0.501, 0.9)[:, 1]
    np.testing.assert_allclose(force_n, [EDGE_N, -EDGE_N / 2, -EDGE_N / 2], atol=1e-4)


def test_positions_beyond_the_way_are_limited_and_counted(read):
    actions = [{"at": 0, "pos": -5}, {"at": 500, "pos": 50}, {"at": 1000, "pos": 999}]
    found = read(json.dumps({"actions": actions}), ".funscript")
    assert at(found.track, 0.0)[0, 1] == pytest.approx(-EDGE_N)
    assert str(found.assumed[-1]) == "2 positions of L0 beyond 0 to 100 were limited"


def test_an_axis_that_is_there_twice_and_alike_is_one(read):
    content = {"actions": LINE, "axes": [{"id": "L0", "actions": LINE}]}
    assert read(json.dumps(content), ".funscript").unread == ()


@pytest.mark.parametrize(("given", "is_unread"), [(50, True), (90, False), (120, True)])
def test_a_range_that_is_not_applied_is_said(read, given, is_unread):
    found = read(json.dumps({"range": given, "actions": LINE}), ".funscript")
    said = found.unread if is_unread else found.assumed
    assert f"range of {given} % was not applied" in str(said[-1])
    whole = read(json.dumps({"range": 100, "actions": LINE}), ".funscript")
    assert len(whole.notes) == 1


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ('{"actions": [{"at": "0", "pos": 1}]}', r"actions\[0\].at: must be a number"),
        ('{"actions": [{"at": 0}]}', "missing entry 'pos'"),
        ('{"actions": [{"at": 0, "pos": null}]}', "pos: must be a number"),
        ('{"actions": [{"at": 1e12, "pos": 1}]}', "at: must be at most"),
        ('{"actions": {"at": 0, "pos": 1}}', "actions: must be a list"),
        ('{"actions": [[0, 1]]}', r"actions\[0\]: must be an object"),
        ('{"inverted": "true", "actions": []}', "inverted: must be true or false"),
        ('{"channels": {"surge": 3}}', "channels.surge: must be an object"),
        ('{"actions": [{"at": -9, "pos": 1}]}', "ends before 0 s"),
        ('{"actions": []}', "holds no positions"),
        ("[]", "must be an object"),
    ],
)
def test_a_damaged_script_is_refused_by_its_place(read, content, says):
    with pytest.raises(InputError, match=says):
        read(content, ".funscript")


def test_an_ahap_has_the_size_of_the_force(written):
    content = json.loads(written("ahap").read_text())
    curves = [
        one["ParameterCurve"] for one in content["Pattern"] if "ParameterCurve" in one
    ]
    scale_n = float(content["Metadata"]["Description"].split()[-1])
    points = [
        (curve["Time"] + one["Time"], one["ParameterValue"] * scale_n)
        for curve in curves
        if curve["ParameterID"] == "HapticIntensityControl"
        for one in curve["ParameterCurveControlPoints"]
    ]
    size_n = np.interp([0.25, 0.5, 0.75], *zip(*points, strict=True))
    whole_n = np.sqrt(14.0)
    np.testing.assert_allclose(size_n, [whole_n / 2, whole_n, whole_n / 2], atol=0.011)
    assert all(len(one["ParameterCurveControlPoints"]) <= 16 for one in curves)


def test_faster_force_is_sharper(written, tmp_path):
    values = []
    for hertz in (2.0, 20.0):
        wave = np.sin(2.0 * np.pi * hertz * np.arange(3000) / 1000.0)
        track = ForceTrack(np.arange(3000) / 1000.0, np.outer(wave, [0, 2, 0]))
        path = written("ahap", track)
        curves = [
            one.get("ParameterCurve", {})
            for one in json.loads(path.read_text())["Pattern"]
        ]
        sharp = next(
            c for c in curves if c.get("ParameterID") == "HapticSharpnessControl"
        )
        values.append(sharp["ParameterCurveControlPoints"][0]["ParameterValue"])
        path.unlink()
    np.testing.assert_allclose(values, np.log10([2.0, 20.0]) / 2.0, atol=0.03)
