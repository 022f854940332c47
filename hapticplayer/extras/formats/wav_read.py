"""Reads audio (WAV) as force: our own, and PCM or float of up to 8 channels.

Three channels are x, y, z, others act together along the chosen direction. The newton of full
scale is in the comment of our own files (see `wav`), else it is chosen.
"""

import math
import os
import re
import struct
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import Direction, ForceFile, ReadChoices
from hapticplayer.untrusted import ANOTHER, open_regular

MAX_BYTES, MAX_SAMPLES = 160 << 20, 9_000_000
"""Of a file, and of the force it becomes: 2 h 30 min of our own at 1 kHz, in 512 MB."""

MARK = b"hapticplayer force; newton = sample * "
_SCALE = re.compile(re.escape(MARK) + rb"([0-9.e+-]{1,24}); x, y, z")
FLOAT, _PCM, _EXTENSIBLE = 3, 1, 0xFFFE
_KINDS = {
    (_PCM, 8): "u1",
    (_PCM, 16): "<i2",
    (_PCM, 24): "u1",
    (_PCM, 32): "<i4",
    (FLOAT, 32): "<f4",
    (FLOAT, 64): "<f8",
}
SAMPLES_AT_ONCE = 1 << 18
"""Of each channel."""

_REACH = 10  # periods of the lower rate, to each side of the filter
_LOOP_HZ = 1000


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file, which is never in memory as a whole."""
    try:
        with open_regular(path) as reader:
            return _read(reader, path, choices)
    except OSError as problem:
        what = Message("cannot be read ({reason})", reason=problem)
        raise InputError(what, where=str(path), remedy=ANOTHER) from problem


def _read(reader: BinaryIO, path: Path, choices: ReadChoices) -> ForceFile:
    data = _data(reader, str(path))
    notes: list[Message] = []
    unread: list[Message] = []
    scale_n = data.scale_n
    if scale_n is None:
        scale_n = choices.full_scale_n
        notes.append(Message("full scale was taken as {full_n:.3g} N", full_n=scale_n))
    rate = data.form.rate_hz
    if rate > 8 * _LOOP_HZ:
        rate = _LOOP_HZ
        unread.append(Message("sound above {limit_hz} Hz was left out", limit_hz=500))
    way = None
    if data.form.channels != 3:
        way = choices.direction
        notes.append(
            Message(
                "{count} channels act along x {x:.2f}, y {y:.2f}, z {z:.2f}",
                count=data.form.channels,
                **dict(zip("xyz", way, strict=True)),
            )
        )
    force_n = _force_n(reader, data, scale_n, way, str(path))
    time_s = np.arange(len(force_n)) / rate
    for made in (force_n, time_s):
        made.setflags(write=False)  # so that the track takes them as they are
    source = {"source": path.name, "reader": "wav"}
    track = ForceTrack(time_s, force_n, provenance=source)
    return ForceFile(track, tuple(notes), tuple(unread))


class _Form(NamedTuple):
    """What `fmt ` says."""

    code: int
    channels: int
    rate_hz: int
    bits: int


class _Data(NamedTuple):
    """Where the samples are.

    Attributes:
        form: what they are.
        at: their first byte in the file.
        frames: samples of each channel.
        scale_n: of full scale; None where the file does not say it.
    """

    form: _Form
    at: int
    frames: int
    scale_n: float | None


def _data(reader: BinaryIO, where: str) -> _Data:
    """Return where the samples are, and what they are."""
    size_bytes = os.fstat(reader.fileno()).st_size
    if size_bytes > MAX_BYTES:
        raise InputError(
            Message("is too large (limit: {most_bytes} bytes)", most_bytes=MAX_BYTES),
            where=where,
            remedy=ANOTHER,
        )
    head = reader.read(12)
    if head[:4] != b"RIFF" or head[8:12] != b"WAVE":
        raise InputError("is not a WAV file", where=where, remedy=ANOTHER)
    at, form, scale_n = 12, None, None
    while len(head := reader.read(8)) == 8:
        name, size = head[:4], struct.unpack_from("<I", head, 4)[0]
        if name == b"data":
            if form is None:
                break
            width = form.channels * form.bits // 8
            count = min(size, size_bytes - at - 8) // width
            if not count:
                break
            return _Data(form, at + 8, count, scale_n)
        body = reader.read(min(size, 1024))
        if name == b"fmt " and len(body) >= 16:
            form = _form(body, where)
        elif name == b"LIST" and (found := _SCALE.search(body)):
            scale_n = _number(found[1])
        at += 8 + size + size % 2
        reader.seek(at)
    raise InputError("holds no samples", where=where, remedy=ANOTHER)


def _form(body: bytes, where: str) -> _Form:
    code, channels, rate, _, _, bits = struct.unpack_from("<HHIIHH", body)
    if code == _EXTENSIBLE and len(body) >= 26:
        code = struct.unpack_from("<H", body, 24)[0]
    is_usual = 1 <= channels <= 8 and 100 <= rate <= 192_000
    if not is_usual or (code, bits) not in _KINDS:
        raise InputError("has no usual format", where=where, remedy=ANOTHER)
    return _Form(code, channels, rate, bits)


def _number(text: bytes) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if 0.0 < value <= 1e4 else None


def _force_n(
    reader: BinaryIO, data: _Data, scale_n: float, way: Direction | None, where: str
) -> NDArray[np.float32]:
    """Return force (n, 3) N, of more than 8 kHz at the rate of the haptic loop."""
    up, down, margin = 1, 1, 0
    if data.form.rate_hz > 8 * _LOOP_HZ:
        common = math.gcd(data.form.rate_hz, _LOOP_HZ)
        up, down = _LOOP_HZ // common, data.form.rate_hz // common
        margin = down * (1 + _REACH * max(up, down) // (up * down))
    count = -(-data.frames * up // down)
    if count > MAX_SAMPLES:
        raise InputError("holds too many values", where=where, remedy=ANOTHER)
    width = data.form.channels * data.form.bits // 8
    force_n = np.zeros((count, 3), dtype=np.float32)
    size = down * max(1, SAMPLES_AT_ONCE // down)
    for first in range(0, data.frames, size):
        begin, end = max(0, first - margin), min(data.frames, first + size + margin)
        reader.seek(data.at + begin * width)
        samples = _samples(data.form, reader.read((end - begin) * width))
        if not np.isfinite(samples).all():
            raise InputError("holds no numbers", where=where, remedy=ANOTHER)
        if way is not None:
            samples = samples.sum(axis=1)[:, None]
        if margin:
            samples = _slower(samples, up, down)
        row = first * up // down
        last = min(len(force_n), row + size * up // down)
        skipped = (first - begin) * up // down
        part = scale_n * samples[skipped : skipped + last - row]
        refuse_large_force(part, where, Message("give another full scale"))
        force_n[row:last] = part if way is None else part * np.array(way)
    return force_n


def _samples(form: _Form, data: bytes) -> Floats:
    """Return samples (n, channels), full scale is 1."""
    raw: NDArray[Any] = np.frombuffer(data, _KINDS[form.code, form.bits])
    if form.code == FLOAT:
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


def _slower(samples: Floats, up: int, down: int) -> Floats:
    from scipy.signal import resample_poly

    return np.asarray(resample_poly(samples, up, down, axis=0))
