"""Force as audio (WAV): three channels for transducers, the newton scale in its metadata.

32-bit float samples of force / scale; the scale and the axes are in a LIST INFO comment
of the form `hapticplayer force; newton = sample * 4.5; x, y, z`. Other formats than PCM
have an extension size and a `fact` chunk (Multimedia Programming Interface 1.0).
"""

import math
import struct
from typing import BinaryIO

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.wav_read import FLOAT, MARK, MAX_SAMPLES
from hapticplayer.model import ForceTrack
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import WriteChoices, origin
from hapticplayer.sequence.milliseconds import end_ms, pieces


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b"RIFF") and MARK in head[:200]


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write a track; its lines and steps are sampled."""
    refuse_large_force(track.force_n, "wav")
    scale_n = max(0.01, math.ceil(float(np.abs(track.force_n).max()) * 1000.0) / 1000.0)
    comment = MARK + f"{scale_n:.3f}; x, y, z{origin(track)}".encode()
    comment += b"\0" * (2 - len(comment) % 2)
    until_ms, rate = end_ms(track, choices.duration_s), choices.take("sample_rate_hz")
    count = max(1, until_ms * rate // 1000 + 1)
    if count > MAX_SAMPLES:
        raise InputError(
            "the track is too long for this format",
            remedy="choose a lower sample rate, or another format",
        )
    form = struct.pack("<HHIIHHH", FLOAT, 3, rate, 12 * rate, 12, 32, 0)
    info = b"INFO" + _chunk(b"ICMT", comment)
    head = b"WAVE" + _chunk(b"fmt ", form) + _chunk(b"fact", struct.pack("<I", count))
    head += _chunk(b"LIST", info)
    size = len(head) + 8 + 12 * count
    out.write(b"RIFF" + struct.pack("<I", size) + head)
    out.write(b"data" + struct.pack("<I", 12 * count))
    for first, last in pieces(count, 1 << 18):
        at_s = np.arange(first, last) / rate
        out.write((track.at(at_s) / scale_n).astype("<f4").tobytes())
    return ()


def _chunk(name: bytes, content: bytes) -> bytes:
    return name + struct.pack("<I", len(content)) + content
