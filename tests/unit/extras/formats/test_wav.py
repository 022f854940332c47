"""WAV: samples, scale and what others write."""

import math
import shlex
import shutil
import struct
import subprocess

import numpy as np
import pytest
from scipy.io import wavfile
from scipy.signal import resample_poly

from hapticplayer.errors import InputError
from hapticplayer.sequence.force_files import ReadChoices
from hapticplayer.sequence.force_formats import (
    read_force,
)
from tests.unit.extras.formats.conftest import at


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


@pytest.mark.parametrize("rate", [2000, 4000, 8000, 44100])
def test_sound_that_no_hand_follows_does_not_become_another(tmp_path, rate):
    """A tone of 900 Hz is not felt as one of 100 Hz, which every millisecond of it is."""
    time_s = np.arange(2 * rate) / rate
    tones = [np.sin(2.0 * np.pi * hertz * time_s) for hertz in (60.0, 900.0)]
    for name, tone in zip(("low", "high"), tones, strict=True):
        wavfile.write(tmp_path / f"{name}.wav", rate, tone.astype(np.float32))
    at_s = np.arange(0.5, 1.5, 0.001)
    low, high = (read_force(tmp_path / f"{one}.wav") for one in ("low", "high"))
    assert np.abs(low.track.at(at_s)).max() == pytest.approx(1.0, abs=0.03)
    assert np.abs(high.track.at(at_s)).max() < 0.03
    assert "sound above 500 Hz was left out" in str(high.unread[0])


@pytest.mark.parametrize("rate", [1500, 8001, 12345, 44100, 48000])
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
        (form_of(3, 3, 24, 9), "unusual format"),
        (form_of(1, 300, 8, 300), "up to 256 channels"),
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


def test_a_wav_for_more_than_4_gb_is_read(read, written):
    plain = written("wav").read_bytes()
    place = plain.index(b"data") + 4
    (size,) = struct.unpack_from("<I", plain, place)
    ds64 = b"ds64" + struct.pack("<IQQQI", 28, 0, size, 0, 0)
    long = b"RF64" + plain[4:12] + ds64 + plain[12:place] + b"\xff" * 4
    found = read(long + plain[place + 4 :] + b"LIST\4\0\0\0abcd", ".wav")
    assert not found.notes
    assert at(found.track, 0.5)[0] == pytest.approx([1, 2, -3], abs=1e-3)


def turned(content):
    """A WAV file of 2, 4 or 8 bytes a sample with its numbers the other way round."""
    made, at_byte = bytearray(b"RIFX" + content[7:3:-1] + content[8:12]), 12
    width = struct.unpack_from("<H", content, content.index(b"fmt ") + 22)[0] // 8
    while at_byte < len(content):
        name = content[at_byte : at_byte + 4]
        (size,) = struct.unpack_from("<I", content, at_byte + 4)
        body = content[at_byte + 8 : at_byte + 8 + size]
        if name == b"data":
            body = np.frombuffer(body, "u1").reshape(-1, width)[:, ::-1].tobytes()
        elif name == b"fmt ":
            body = struct.pack(">HHIIHH", *struct.unpack_from("<HHIIHH", body))
        made += name + struct.pack(">I", len(body)) + body + b"\0" * (len(body) % 2)
        at_byte += 8 + size + size % 2
    return bytes(made)


@pytest.mark.parametrize("kind", ["<i2", "<i4", "<f4", "<f8", "3"])
def test_rifx_is_read_like_the_same_riff(read, kind):
    if kind == "3":
        whole = np.round(WAVE * (1 << 23)).astype("<i4").tobytes()
        data = np.frombuffer(whole, "u1").reshape(-1, 4)[:, :3].tobytes()
        form = form_of(1, 3, 24, 9)
    else:
        width = int(kind[2])
        values = WAVE if kind[1] == "f" else np.round(WAVE * (1 << (8 * width - 1)))
        data, code = values.astype(kind).tobytes(), 3 if kind[1] == "f" else 1
        form = form_of(code, 3, 8 * width, 3 * width)
    found = read(turned(sound(form, data)), ".wav", full_scale_n=2.0)
    np.testing.assert_allclose(found.track.force_n, 2.0 * WAVE, atol=2e-4)


def test_floats_of_two_bytes_are_read(read):
    found = read(sound(form_of(3, 3, 16, 6), WAVE.astype("<f2").tobytes()), ".wav")
    np.testing.assert_allclose(found.track.force_n, WAVE, atol=3e-4)


@pytest.mark.parametrize("channels", [1, 9, 24, 256])
def test_all_channels_of_a_wav_act_together(read, channels):
    samples = np.zeros((2000, channels), "<i2")
    samples[1000:] = 16384 // channels
    form = form_of(1, channels, 16, 2 * channels)
    found = read(sound(form, samples.tobytes()), ".wav", full_scale_n=2.0)
    assert at(found.track, 0.5, 1.5)[:, 1] == pytest.approx([0.0, 1.0], abs=0.01)


@pytest.mark.parametrize("name", [b"data", b"LIST"])
@pytest.mark.parametrize("is_padded", [True, False])
def test_a_pad_byte_may_be_forgotten(read, name, is_padded):
    """The odd chunk stands before the samples, or is the samples."""
    pad = b"\0" * is_padded
    comment = b"INFOICMT\x35\0\0\0hapticplayer force; newton = sample * 8.000; x, y, z"
    comment += b" " * (len(comment) % 2 == 0)
    form = chunk(b"fmt ", form_of(1, 3, 8, 3))
    levels = np.array([[128, 192, 64]] * 33, "u1").tobytes()  # 99 bytes
    listed = b"LIST" + struct.pack("<I", len(comment)) + comment + pad
    data = b"data" + struct.pack("<I", 99) + levels + pad
    body = b"WAVE" + form + (listed + data if name == b"LIST" else data + listed)
    content = b"RIFF" + struct.pack("<I", len(body)) + body
    force_n = read(content, ".wav").track.force_n
    np.testing.assert_allclose(force_n, [[0.0, 4.0, -4.0]] * 33)


@pytest.mark.parametrize("size", [0, 0x7FFFF000, 0xFFFFFFFF])
def test_a_wav_from_a_pipe_is_read_to_its_end(read, size):
    content = sound(form_of(3, 3, 32, 12), WAVE.astype("<f4").tobytes())
    place = content.index(b"data") + 4
    content = content[:place] + struct.pack("<I", size) + content[place + 4 :]
    found = read(content, ".wav")
    assert (len(found.track.time_s), found.unread) == (len(WAVE), ())


FFMPEG = shutil.which("ffmpeg")
CODED = {
    "ima": ("wav", "-c:a", "adpcm_ima_wav"),
    "alaw": ("wav", "-c:a", "pcm_alaw"),
    "mp3": ("wav", "-c:a", "libmp3lame", "-ar", "44100"),
    "fast": ("wav", "-ar", "384000"),
    "aiff": ("aiff", "-c:a", "pcm_s16be"),
    "flac": ("flac", "-c:a", "flac"),
}


@pytest.mark.skipif(FFMPEG is None, reason="needs ffmpeg")
@pytest.mark.parametrize("kind", CODED)
def test_the_printed_command_makes_a_wav_that_is_read(tmp_path, kind):
    form, *more = CODED[kind]
    path = tmp_path / "it's 12:30 \u00fc 100%d.wav"
    tone = ["-f", "lavfi", "-i", "sine=frequency=20:duration=1:sample_rate=48000"]
    made = [FFMPEG, "-v", "error", *tone, *more, "-f", form, f"file:{path}"]
    subprocess.run(made, check=True, timeout=60)
    with pytest.raises(InputError) as refused:
        read_force(path)
    command = str(refused.value).partition("with: ")[2]
    words = shlex.split(command)
    assert words[0] == "ffmpeg"
    subprocess.run([*words, "-v", "error"], check=True, timeout=60)
    (other,) = set(tmp_path.iterdir()) - {path}
    force_n = read_force(other).track.force_n
    assert len(force_n) == pytest.approx(1000, abs=60)
    assert np.abs(force_n[300:700]).max() == pytest.approx(0.125, rel=0.1)


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
