"""Force as audio (WAV): three channels for transducers, the newton scale in its metadata.

32-bit float samples of force / scale; the scale and the axes are in a LIST INFO comment
of the form `hapticplayer force; newton = sample * 4.5; x, y, z`. Other files are read as
PCM or float of up to 8 channels: three are x, y, z, others act along the chosen direction.
"""

import math
import re
import struct
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.interchange.force_files import (
    ForceFile,
    ReadChoices,
    WriteChoices,
    refuse_large,
)
from hapticplayer.interchange.milliseconds import end_ms, pieces
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.untrusted import read_regular

MAX_BYTES = 160 << 20
"""3 h 50 min of our own at 1 kHz."""

_MARK = b"hapticplayer force; newton = sample * "
_SCALE = re.compile(re.escape(_MARK) + rb"([0-9.e+-]{1,24}); x, y, z")
_FLOAT, _PCM, _EXTENSIBLE = 3, 1, 0xFFFE
_LOOP_HZ = 1000
_ANOTHER = Message("choose another file")


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b"RIFF") and _MARK in head[:200]


def write(track: ForceTrack, out: BinaryIO, choices: WriteChoices) -> None:
    """Write a track; its lines and steps are sampled.

    Raises:
        InputError: for forces beyond any device, or a track that is too long.
    """
    refuse_large(track.force_n, "wav")
    scale_n = max(0.01, math.ceil(float(np.abs(track.force_n).max()) * 1000.0) / 1000.0)
    comment = _MARK + f"{scale_n:.3f}; x, y, z".encode()
    comment += b"\0" * (2 - len(comment) % 2)
    until_ms, rate = end_ms(track, choices.duration_s), choices.sample_rate_hz
    count = max(1, until_ms * rate // 1000 + 1)
    if 12 * count > MAX_BYTES - 1000:
        raise InputError(
            "the track is too long for this format",
            remedy="choose a lower sample rate, or another format",
        )
    form = struct.pack("<HHIIHH", _FLOAT, 3, rate, 12 * rate, 12, 32)
    info = b"INFO" + _chunk(b"ICMT", comment)
    head = b"WAVE" + _chunk(b"fmt ", form) + _chunk(b"LIST", info)
    size = len(head) + 8 + 12 * count
    out.write(b"RIFF" + struct.pack("<I", size) + head)
    out.write(b"data" + struct.pack("<I", 12 * count))
    for first, last in pieces(count, 1 << 18):
        at_s = np.arange(first, last) / rate
        out.write((track.at(at_s) / scale_n).astype("<f4").tobytes())


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file.

    Raises:
        InputError: when it is no such file.
    """
    content = read_regular(path, MAX_BYTES)
    if content[:4] != b"RIFF" or content[8:12] != b"WAVE":
        raise InputError("is not a WAV file", where=str(path), remedy=_ANOTHER)
    form, data, scale_n = _chunks(content, str(path))
    samples = _samples(form, data, str(path))
    if not np.isfinite(samples).all():
        raise InputError("holds no numbers", where=str(path), remedy=_ANOTHER)
    notes: list[Message] = []
    if scale_n is None:
        scale_n = choices.full_scale_n
        notes.append(Message("full scale was taken as {full_n:.3g} N", full_n=scale_n))
    rate = form.rate_hz
    if rate > 8 * _LOOP_HZ:
        samples, rate = _slower(samples, rate), _LOOP_HZ
        notes.append(Message("sound above {limit_hz} Hz was left out", limit_hz=500))
    if form.channels == 3:
        force_n = scale_n * samples
    else:
        force_n = scale_n * samples.sum(axis=1)[:, None] * np.array(choices.direction)
        notes.append(
            Message(
                "{count} channels act along x {x:.2f}, y {y:.2f}, z {z:.2f}",
                count=form.channels,
                **dict(zip("xyz", choices.direction, strict=True)),
            )
        )
    refuse_large(force_n, str(path), Message("give another full scale"))
    track = ForceTrack(
        np.arange(len(force_n)) / rate,
        force_n.astype(np.float32),
        provenance={"source": path.name, "reader": "wav"},
    )
    return ForceFile(track, tuple(notes))


class _Form(NamedTuple):
    """What `fmt ` says."""

    code: int
    channels: int
    rate_hz: int
    bits: int


def _chunk(name: bytes, content: bytes) -> bytes:
    return name + struct.pack("<I", len(content)) + content


def _chunks(content: bytes, where: str) -> tuple[_Form, bytes, float | None]:
    """Return format, samples and scale."""
    at, form, data, scale_n = 12, None, None, None
    while at + 8 <= len(content) and data is None:
        name, size = content[at : at + 4], struct.unpack_from("<I", content, at + 4)[0]
        body = content[at + 8 : at + 8 + size]
        if name == b"fmt " and len(body) >= 16:
            code, channels, rate, _, _, bits = struct.unpack_from("<HHIIHH", body)
            if code == _EXTENSIBLE and len(body) >= 26:
                code = struct.unpack_from("<H", body, 24)[0]
            form = _Form(code, channels, rate, bits)
        elif name == b"LIST" and (found := _SCALE.search(body[:1024])):
            scale_n = _number(found[1])
        elif name == b"data":
            data = body
        at += 8 + size + size % 2
    if form is None or data is None:
        raise InputError("holds no samples", where=where, remedy=_ANOTHER)
    return form, data, scale_n


def _number(text: bytes) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if 0.0 < value <= 1e4 else None


def _samples(form: _Form, data: bytes, where: str) -> Floats:
    """Return samples (n, channels), full scale is 1."""
    if not (1 <= form.channels <= 8 and 100 <= form.rate_hz <= 192_000):
        raise InputError("has no usual format", where=where, remedy=_ANOTHER)
    width = form.bits // 8
    data = data[: len(data) // (width * form.channels or 1) * width * form.channels]
    kinds = {(_PCM, 16): "<i2", (_PCM, 32): "<i4", (_FLOAT, 32): "<f4"}
    kinds |= {(_FLOAT, 64): "<f8", (_PCM, 8): "u1", (_PCM, 24): "u1"}
    kind = kinds.get((form.code, form.bits))
    if kind is None or not data:
        raise InputError("has no usual format", where=where, remedy=_ANOTHER)
    raw: NDArray[Any] = np.frombuffer(data, kind)
    if form.code == _FLOAT:
        with np.errstate(invalid="ignore"):  # what is no number is refused later
            values: Floats = raw.astype(np.float64)
    elif form.bits == 24:
        low, mid, high = raw.reshape(-1, 3).astype(np.int32).T
        whole = low | mid << 8 | high << 16
        values = (whole - (whole >> 23 << 24)) / float(1 << 23)
    elif form.bits == 8:
        values = (raw.astype(np.float64) - 128.0) / 128.0
    else:
        values = raw / float(1 << (form.bits - 1))
    return np.asarray(values).reshape(-1, form.channels)


def _slower(samples: Floats, rate_hz: int) -> Floats:
    """Return samples at the rate of the haptic loop."""
    from scipy.signal import resample_poly

    common = math.gcd(rate_hz, _LOOP_HZ)
    slow = resample_poly(samples, _LOOP_HZ // common, rate_hz // common, axis=0)
    return np.asarray(slow)
