"""MPEG-V sensory effects (ISO/IEC 23005-3, schema of 2010): kinesthetic force, motion.

PassiveKinestheticForce is a matrix of samples, evenly over its duration, with lines
between; a span without force has none. RigidBodyMotion, where motion is given, is the mean
acceleration of each 50 ms (MoveToward; 0 degrees is to the front, positive to the right
and up). `timeSamples` is the number of rows, `mpegv_read` has why.
"""

import math
from collections.abc import Iterator
from typing import BinaryIO

import numpy as np

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.mpegv_read import MAX_BYTES, MAX_ROWS, MAX_TAGS
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import WriteChoices, origin
from hapticplayer.sequence.milliseconds import Ticks, end_ms, pieces

_STEPS_MS = (50, 40, 20, 10, 8, 5, 4, 2, 1)
_PIECE_MS, _MOTION_MS = 10_000, 50
_STILL_MPS2 = 5e-4  # nothing, in three decimals
_SEDL = "urn:mpeg:mpeg-v:2010:01-SEDL-NS"
_MARK = "written by hapticplayer: x right, y up, z towards the user, newton"
_HEAD = f"""<?xml version="1.0" encoding="UTF-8"?>
<!-- {_MARK} -->
<SEM xmlns="{_SEDL}" xmlns:sev="urn:mpeg:mpeg-v:2010:01-SEV-NS" \
xmlns:si="urn:mpeg:mpeg21:2003:01-DIA-XSI-NS" xmlns:mpeg7="urn:mpeg:mpeg7:schema:2004" \
xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" si:timeScale="1000">
"""


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return _MARK.encode() in head[:200]


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write a track; each 10 s at the lowest rate that stays within the tolerance."""
    refuse_large_force(track.force_n, "mpegv")
    until_ms = end_ms(track, choices.duration_s)
    rows = tags = 0
    out.write(_HEAD.replace(_MARK, _MARK + origin(track)).encode())
    for kept, text in _forces(track, until_ms, choices.take("tolerance_n")):
        rows, tags = rows + kept, tags + text.count("<")
        out.write(text.encode())
    if choices.motion is not None:
        for text in _motions(choices.motion, until_ms):
            tags += text.count("<")
            out.write(text.encode())
    out.write(b"</SEM>\n")
    if (
        out.tell() > MAX_BYTES
        or rows > MAX_ROWS
        or tags > MAX_TAGS - _HEAD.count("<") - 1
    ):
        raise InputError(
            "the track is too long for this format", remedy="choose another format"
        )
    if choices.motion is None:
        return ()
    within = Message(
        "rotations, and what of the motion changes within {span_ms} ms",
        span_ms=_MOTION_MS,
    )
    if choices.motion.valid.all():
        return (within,)
    return within, Message("the motion where it is not valid")


def _forces(
    track: ForceTrack, until_ms: int, tolerance_n: float
) -> Iterator[tuple[int, str]]:
    """Yield the number of rows and the text of effects, one at least."""
    digits = max(0, math.ceil(-math.log10(tolerance_n / 20.0)))
    wrote = False
    for first, last in pieces(until_ms, _PIECE_MS):
        ticks = np.arange(first, last + 1)
        force_n = track.at(ticks / 1000.0)
        if not force_n.any() and (wrote or last < until_ms):
            continue
        step_ms = last - first
        if force_n.any():
            step_ms = _step_ms(ticks, force_n, tolerance_n * 0.9)
        kept, wrote = force_n[::step_ms], True
        yield len(kept), _effect(first, last - first, kept, digits)


def _motions(motion: MotionTrack, until_ms: int) -> Iterator[str]:
    """Yield the text of the effects of some seconds."""
    acceleration = (motion.acceleration_mps2 * motion.valid[:, None]).T
    for first, last in pieces(until_ms, _PIECE_MS):
        at_s = np.arange(first, last) / 1000.0
        moved = [
            np.interp(at_s, motion.time_s, axis, left=0.0, right=0.0)
            for axis in acceleration
        ]
        begins = np.arange(0, last - first, _MOTION_MS)
        lengths = np.diff(begins, append=last - first)
        right, front, up = np.add.reduceat(moved, begins, axis=1) / lengths
        size = np.sqrt(right**2 + front**2 + up**2)
        across = np.degrees(np.arctan2(right, front)).round().astype(int) % 360
        above = np.degrees(np.arctan2(up, np.hypot(right, front))).round()
        yield "".join(
            f'<Effect xsi:type="sev:RigidBodyMotionType" si:pts="{first + begin}" '
            f'activate="true" duration="{length}"><sev:MoveToward '
            f'acceleration="{mps2:.3f}" directionH="{flat}" directionV="{steep}"/>'
            "</Effect>\n"
            for begin, length, mps2, flat, steep in zip(
                begins, lengths, size, across, above.astype(int) % 360, strict=True
            )
            if mps2 > _STILL_MPS2
        )


def _step_ms(ticks: Ticks, force_n: Floats, tolerance_n: float) -> int:
    for step_ms in _STEPS_MS:
        if (len(ticks) - 1) % step_ms:
            continue
        kept = ticks[::step_ms]
        lines = np.stack(
            [np.interp(ticks, kept, axis[::step_ms]) for axis in force_n.T], axis=1
        )
        if np.square(lines - force_n).sum(axis=1).max() <= tolerance_n**2:
            return step_ms
    return 1


def _effect(first_ms: int, length_ms: int, force_n: Floats, digits: int) -> str:
    values = " ".join(f"{value:.{digits}f}" for value in force_n.ravel().tolist())
    return (
        f'<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="{first_ms}" '
        f'activate="true" duration="{length_ms}" timeSamples="{len(force_n)}">'
        f'<sev:PassiveKinestheticForce mpeg7:dim="{len(force_n)} 3">{values}'
        "</sev:PassiveKinestheticForce></Effect>\n"
    )
