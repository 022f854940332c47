"""Reads audio (WAV) as force: our own, and PCM or float of any number of channels.

Three channels are x, y, z, others act together along the chosen direction. The newton of full
scale is in the comment of our own files (see `wav`), wherever other programs have put it,
else it is chosen. Samples of fewer bits than their bytes have lie at the upper end of them,
by the format, or at the lower, as some programs write them: the samples themselves tell.
RIFX has its numbers the other way round; pad bytes that are missing are missed.
"""

import math
import os
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, shell_line
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
_GUID_END = bytes.fromhex("800000AA00389B71")
"""Of the extensible format."""
_MOST_CHANNELS = 256

_STREAMED, _ENDLESS = 0xFFFFFFFF, 0x7FFFF000
"""The length of what has none, and from where programs mean that, such as SoX."""

_RIFF = {b"RIFF": "<", b"RIFX": ">", b"RF64": "<", b"BW64": "<"}
"""How a file begins, and the order of its bytes."""

_CHUNKS = (b"data", b"fmt ", b"fact", b"LIST", b"bext", b"JUNK", b"cue ", b"id3 ")
_MAX_COMMENT_BYTES = 1 << 16
SAMPLES_AT_ONCE = 1 << 18
"""Of each of up to 8 channels."""

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
    notes, unread = list(data.assumed), list(data.unread)
    scale_n = data.scale_n
    if scale_n is None:
        scale_n = choices.take("full_scale_n")
        notes.append(Message("full scale was taken as {full_n:.3g} N", full_n=scale_n))
    rate = data.form.rate_hz
    if data.is_faster:
        rate = _LOOP_HZ
        unread.append(Message("sound above {limit_hz} Hz was left out", limit_hz=500))
    way = None
    if data.form.channels == 3 and data.scale_n is None:
        notes.append(Message("three channels were taken as x, y and z"))
    if data.form.channels != 3:
        way = choices.take("direction")
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
    """What `fmt ` says.

    Attributes:
        order: of bytes, as in `struct`.
        code: FLOAT or PCM.
        channels: of a frame.
        rate_hz: frames per second.
        bits: of a sample.
        width: bytes of a sample.
        unit: what full scale is, as a number of PCM.
    """

    order: str
    code: int
    channels: int
    rate_hz: int
    bits: int
    width: int
    unit: float

    @property
    def at_once(self) -> int:
        """Frames that are in memory."""
        return max(1, SAMPLES_AT_ONCE // -(-self.channels // 8))


class _Data(NamedTuple):
    """Where the samples are.

    Attributes:
        form: what they are.
        at: their first byte in the file.
        frames: samples of each channel.
        scale_n: of full scale; None where the file does not say it.
        assumed: what the file does not say.
        unread: what is missing.
    """

    form: _Form
    at: int
    frames: int
    scale_n: float | None
    assumed: tuple[Message, ...] = ()
    unread: tuple[Message, ...] = ()

    @property
    def is_faster(self) -> bool:
        """Whether it holds what the haptic loop cannot follow; ours is force at each time."""
        most = 1 if self.scale_n is None else 8
        return self.form.rate_hz > most * _LOOP_HZ


def _data(reader: BinaryIO, where: str) -> _Data:
    """Return where the samples are, and what they are."""
    size_bytes = os.fstat(reader.fileno()).st_size
    if size_bytes > MAX_BYTES:
        raise InputError(
            Message("is too large (limit: {most_bytes} bytes)", most_bytes=MAX_BYTES),
            where=where,
            remedy=ANOTHER,
        )
    form, scale_n = None, None
    samples: list[tuple[int, int]] = []
    order = _order(reader, where)
    for name, at, size, body in _chunks(reader, order):
        if name == b"data":
            samples.append((at, size))
        elif name == b"fmt " and len(body) >= 16 and form is None:
            form = _form(body, order, where)
        elif found := _SCALE.search(body):
            scale_n = _number(found[1])
    begin, said = samples[0] if samples else (0, 0)
    size = min(said, size_bytes - begin)
    if form is None or size < form.channels * form.width:
        raise InputError("holds no samples", where=where, remedy=ANOTHER)
    frames, unread = size // (form.channels * form.width), []
    if size < said < _ENDLESS:
        lost = said // (form.channels * form.width) - frames
        unread.append(Message("the last {count} samples are missing", count=lost))
    if len(samples) > 1:
        unread.append(
            Message("not read: {what} ({count})", what="data", count=len(samples) - 1)
        )
    data = _Data(form, begin, frames, scale_n, (), tuple(unread))
    return data if form.bits == 8 * form.width else _justified(reader, data)


def _order(reader: BinaryIO, where: str) -> str:
    """How the numbers of a file are written."""
    head = reader.read(12)
    if head[:4] not in _RIFF or head[8:12] != b"WAVE":
        raise InputError("is not a WAV file", where=where, remedy=_as_pcm(where))
    return _RIFF[head[:4]]


def _chunks(reader: BinaryIO, order: str) -> Iterator[tuple[bytes, int, int, bytes]]:
    """Yield name, place, size and the beginning of each chunk; no samples."""
    at, long_size = 20, _STREAMED
    while len(head := reader.read(8)) == 8:
        name, size = head[:4], struct.unpack_from(f"{order}I", head, 4)[0]
        body = b"" if name == b"data" else reader.read(min(size, _MAX_COMMENT_BYTES))
        if name == b"ds64" and len(body) >= 16:  # of a file that may exceed 4 GB
            long_size = struct.unpack_from("<Q", body, 8)[0]
        elif name == b"data" and size == _STREAMED:
            size = min(long_size, _STREAMED)
        elif name == b"data" and not size and not _is_chunk(reader.read(4)):
            size = _STREAMED  # left open by a program that was ended
        yield name, at, size, body
        at += 8 + size + _padding(reader, at, size)
        reader.seek(at - 8)


def _padding(reader: BinaryIO, at: int, size: int) -> int:
    """The bytes behind a chunk of an odd size: one, where it was not forgotten."""
    if size % 2 == 0:
        return 0
    reader.seek(at + size)
    after = reader.read(5)
    is_forgotten = _is_chunk(after[:4]) and after[1:5] not in _CHUNKS
    return 0 if is_forgotten else 1


def _is_chunk(name: bytes) -> bool:
    return len(name) == 4 and all(32 <= byte < 127 for byte in name)


def _form(body: bytes, order: str, where: str) -> _Form:
    code, channels, rate, _, block, bits = struct.unpack_from(f"{order}HHIIHH", body)
    if code == _EXTENSIBLE and len(body) >= 40 and body[32:40] == _GUID_END:
        valid, real, *rest = struct.unpack_from(f"{order}H4xIHH", body, 18)
        code, bits = (real if rest == [0, 16] else code), valid or bits
    width = block // channels if channels and block % channels == 0 else 0
    is_known = (
        (code == FLOAT and (width, bits) in ((2, 16), (4, 32), (8, 64)))
        or (code == _PCM and width in (1, 2, 3, 4, 8) and 2 <= bits <= 8 * width)
    ) and channels <= _MOST_CHANNELS
    if not is_known or not 100 <= rate <= 192_000:
        again = Message(
            "export it again as PCM of 16, 24 or 32 bits, of up to {most} channels",
            most=_MOST_CHANNELS,
        )
        is_coded = is_known or code not in (FLOAT, _PCM)
        raise InputError(
            "has an unusual format ({bits} bits in {block} bytes for {channels} channels, "
            "{rate_hz} Hz)",
            where=where,
            remedy=_as_pcm(where) if is_coded else again,
            bits=bits,
            block=block,
            channels=channels,
            rate_hz=rate,
        )
    return _Form(order, code, channels, rate, bits, width, 2.0 ** (8 * width - 1))


def _as_pcm(where: str) -> Message:
    path = Path(where)
    to = path.with_name(f"{path.stem}-pcm.wav")
    words = ("-i", path, "-c:a", "pcm_f32le", "-ar", "48000", to)
    return Message(
        "make another of it with: {command}",
        command=shell_line("ffmpeg", *words),
    )


def _justified(reader: BinaryIO, data: _Data) -> _Data:
    """Tell by the samples at which end of their bytes the bits are."""
    form, below = data.form, 1 << (8 * data.form.width - data.form.bits)
    frame = form.channels * form.width
    reader.seek(data.at)
    for first in range(0, data.frames, form.at_once):
        count = min(form.at_once, data.frames - first)
        raw = _whole(form, reader.read(count * frame))
        if (raw % below).any():
            if np.abs(raw).max() >> (form.bits - 1) > 1:
                break  # more bits than it says
            said = Message(
                "samples of {bits} bits were taken from the lower end of {width} bytes",
                bits=form.bits,
                width=form.width,
            )
            low = form._replace(unit=2.0 ** (form.bits - 1))
            return data._replace(form=low, assumed=(said,))
    return data


def _number(text: bytes) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if 0.0 < value <= 1e4 else None


def _force_n(
    reader: BinaryIO, data: _Data, scale_n: float, way: Direction | None, where: str
) -> NDArray[np.float32]:
    """Return force (n, 3) N, of what is too fast at the rate of the haptic loop."""
    up, down, margin = 1, 1, 0
    if data.is_faster:
        common = math.gcd(data.form.rate_hz, _LOOP_HZ)
        up, down = _LOOP_HZ // common, data.form.rate_hz // common
        margin = down * (1 + _REACH * max(up, down) // (up * down))
    count = -(-data.frames * up // down)
    if count > MAX_SAMPLES:
        raise InputError("holds too many values", where=where, remedy=ANOTHER)
    width = data.form.channels * data.form.width
    force_n = np.zeros((count, 3), dtype=np.float32)
    size = down * max(1, data.form.at_once // down)
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
    if form.code == FLOAT:
        with np.errstate(invalid="ignore"):  # what is no number is refused later
            kind = f"{form.order}f{form.width}"
            values: Floats = np.frombuffer(data, kind).astype(np.float64)
    else:
        values = _whole(form, data) / form.unit
    return values.reshape(-1, form.channels)


def _whole(form: _Form, data: bytes) -> NDArray[np.int64]:
    """Return the whole numbers of PCM, each in its bytes."""
    if form.width == 1:
        return np.frombuffer(data, "u1").astype(np.int64) - 128
    if form.width == 3:
        parts = np.frombuffer(data, "u1").reshape(-1, 3).astype(np.int64).T
        low, mid, high = parts if form.order == "<" else parts[::-1]
        whole = low | mid << 8 | high << 16
        return np.asarray(whole - (whole >> 23 << 24))
    return np.frombuffer(data, f"{form.order}i{form.width}").astype(np.int64)


def _slower(samples: Floats, up: int, down: int) -> Floats:
    from scipy.signal import resample_poly

    return np.asarray(resample_poly(samples, up, down, axis=0))
