"""Where a GoPro's telemetry belongs in its clip: by the packets' times, and by its stamps.

A camera begins both with the first frame. A clip that was cut begins in the middle of a
payload of 1 s, one that was joined has stamps that jump: there the packets' times with
the edit list place the telemetry, and the stamps only time the samples in each part.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from hapticplayer.capture.gopro_streams import GpmfPayload, collect, first_stamp_us
from hapticplayer.capture.gopro_timing import TimeReference
from hapticplayer.capture.gpmf import first_number_of
from hapticplayer.capture.recording import OtherPlace, Placing
from hapticplayer.errors import Message, TelemetryError
from hapticplayer.model.arrays import Floats

FRAME_KEYS = ("SHUT", "CORI", "IORI", "ISOE", "WBAL")
"""Streams with one sample per frame; their first stamp is that of the first frame."""

PAYLOAD_S = 1.1
"""More than a payload: so far a cut clip's telemetry reaches beyond its ends."""

_FRAME_S = 1 / 24
_JUMP_S = 0.1  # payloads hold a frame more or less
_COUNTED_JUMP_S = 0.3  # the first payload of a HERO7 has samples of 0.2 s before it
_MOST_PARTS = 100
_PACE = 3e-4  # quartzes differ by less

_BY_STAMPS = Message("as the camera's stamps begin")
_BY_EDITS = Message("as the edit list cuts the video")


class PayloadRun(NamedTuple):
    """Payloads that were recorded in one go.

    Attributes:
        payloads: of the part.
        clock: how their stamps become media time.
        end_s: media time at which the next part begins.
    """

    payloads: Sequence[GpmfPayload]
    clock: TimeReference
    end_s: float


def parts_of(
    payloads: Sequence[GpmfPayload], *, has_packet_times: bool
) -> tuple[PayloadRun, ...]:
    """The parts of a recording, each with its own clock."""
    # without stamps of the frames: the accelerometer begins within 5 ms of frame 0
    frame0_us = first_stamp_us(payloads, (*FRAME_KEYS, "ACCL"))
    whole = PayloadRun(payloads, TimeReference(frame0_us, has_packet_times), np.inf)
    marks_s, jump_s = _marks(payloads, frame0_us)
    start_s = np.array([payload.start_s for payload in payloads])
    if not has_packet_times or len(marks_s) < 2:
        return (whole,)
    breaks = np.flatnonzero(np.abs(np.diff(marks_s) - np.diff(start_s)) > jump_s) + 1
    is_joined = 0 < breaks.size <= min(_MOST_PARTS, len(payloads) // 3)
    if breaks.size and not is_joined:  # its stamps are checked sample by sample
        return (whole,)
    if (
        not is_joined
        and abs(start_s[0]) <= _FRAME_S
        and _keep_pace(marks_s, start_s, jump_s)
    ):
        return (whole,)
    return tuple(_parts(payloads, marks_s, start_s, [0, *breaks.tolist()], frame0_us))


def _parts(
    payloads: Sequence[GpmfPayload],
    marks_s: Floats,
    start_s: Floats,
    begins: Sequence[int],
    frame0_us: float | None,
) -> Iterator[PayloadRun]:
    for begin, end in zip(begins, [*begins[1:], len(payloads)], strict=True):
        marks, starts = marks_s[begin:end], start_s[begin:end]
        rate = 1.0
        if not _keep_pace(marks, starts, _COUNTED_JUMP_S):
            rate = float(np.polyfit(marks, starts, 1)[0])
        zero_s = float(np.median(marks - starts / rate))
        zero_us = None if frame0_us is None else frame0_us + 1e6 * zero_s
        clock = TimeReference(zero_us, True, rate)
        end_s = float(start_s[end]) if end < len(payloads) else np.inf
        yield PayloadRun(payloads[begin:end], clock, end_s)


def _keep_pace(marks_s: Floats, start_s: Floats, jump_s: float) -> bool:
    """Whether stamps and packets run equally fast, as far as frames show it."""
    apart_s = (marks_s[-1] - marks_s[0]) - (start_s[-1] - start_s[0])
    return bool(abs(apart_s) <= max(jump_s, _PACE * (marks_s[-1] - marks_s[0])))


def _marks(
    payloads: Sequence[GpmfPayload], frame0_us: float | None
) -> tuple[Floats, float]:
    """The camera's own time of each payload, from the first on, and its jitter.

    By its stamps; without, by its count of samples; nothing where neither is whole.
    """
    if frame0_us is not None:
        key = next(k for k in (*FRAME_KEYS, "ACCL") if _stamp_us(payloads[0], k) >= 0)
        stamps_us = np.array([_stamp_us(payload, key) for payload in payloads])
        if np.isfinite(stamps_us).all():
            jump_s = _COUNTED_JUMP_S if key == "ACCL" else _JUMP_S
            return 1e-6 * (stamps_us - frame0_us), jump_s
        return np.zeros(0), 0.0
    try:
        stream = collect(payloads, "ACCL")
    except TelemetryError:
        stream = None
    if stream is None or len(stream.counts) != len(payloads) or len(payloads) < 3:
        return np.zeros(0), 0.0
    totals = [first_number_of(p.streams["ACCL"].find("TSMP")) for p in payloads]
    first = np.array(totals) - stream.counts
    if not np.isfinite(first).all():
        return np.zeros(0), 0.0
    rate_hz = np.median(stream.counts) / np.median(np.diff(stream.start_s))
    return (first - first[0]) / rate_hz, _COUNTED_JUMP_S


def _stamp_us(payload: GpmfPayload, key: str) -> float:
    stream = payload.streams.get(key)
    return first_number_of(stream.find("STMP")) if stream else np.nan


def placing(
    parts: Sequence[PayloadRun], span_s: tuple[float, float], hidden_s: float
) -> Placing:
    """What the sources say of the place of a log.

    Args:
        parts: of the recording.
        span_s: media time of its first and last sample.
        hidden_s: how much of the video an edit list hides that it shows of the motion.
    """
    first_s = parts[0].payloads[0].start_s
    others = []
    if abs(first_s) > _FRAME_S:
        others.append(OtherPlace(_BY_STAMPS, -first_s))
    if hidden_s > _FRAME_S:
        others.append(OtherPlace(_BY_EDITS, -hidden_s))
    is_cut = any(map(_is_cut, parts, parts[1:])) or parts[0].clock.rate != 1.0
    return Placing(span_s, PAYLOAD_S, tuple(others), is_cut=is_cut)


def _is_cut(part: PayloadRun, later: PayloadRun) -> bool:
    """Whether a part does not end where the next one begins."""
    starts = [payload.start_s for payload in part.payloads]
    usual_s = float(np.median(np.diff(starts))) if len(starts) > 1 else PAYLOAD_S
    ends_s = starts[-1] + usual_s
    return abs(later.payloads[0].start_s - ends_s) > _FRAME_S
