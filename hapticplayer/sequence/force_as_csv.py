"""Force tracks as CSV: `time_s,fx_n,fy_n,fz_n`, each force holds until the next one's time.

A column `is_estimated` of ones marks a motion that nothing measured.
"""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_SECONDS
from hapticplayer.sequence.force_csv import (
    ESTIMATED_COLUMN,
    FORCE_COLUMNS,
    read_force_csv,
    rows_of_csv,
)
from hapticplayer.sequence.force_files import (
    ForceFile,
    Loss,
    ReadChoices,
    WriteChoices,
)
from hapticplayer.sequence.milliseconds import Ticks, end_ms, force_loss, pieces

_PIECE_MS = 60_000
"""Rows are texts in memory for so long."""

_HEAD = ",".join(FORCE_COLUMNS)
_ESTIMATED_HEAD = f"{_HEAD},{ESTIMATED_COLUMN}"


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    first = head.split(b"\n", 1)[0].rstrip(b"\r").decode(errors="replace")
    return first in {_HEAD, _ESTIMATED_HEAD}


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file; see `read_force_csv`."""
    return ForceFile(read_force_csv(path, choices.until_s))


def loss(track: ForceTrack, path: Path, choices: WriteChoices) -> Loss:
    """How a file differs, which is never in memory as a whole."""
    until_ms = end_ms(track, choices.duration_s)
    return force_loss(track, _parts(path), until_ms)


def _parts(path: Path) -> Iterator[tuple[int, ForceTrack]]:
    """Yield the force of a file in parts, each with the millisecond at which it ends."""
    before = np.zeros((0, 0))
    for rows in rows_of_csv(path, math.inf):
        held = np.concatenate([before, rows]) if len(before) else rows
        yield math.ceil(float(held[-1, 0]) * 1000.0), _held(held)
        before = rows[-1:]
    yield round(1000.0 * MAX_SECONDS), _held(before)


def _held(rows: Floats) -> ForceTrack:
    return ForceTrack(rows[:, 0], rows[:, 1:4].astype(np.float32), Reconstruction.HOLD)


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write a row for each millisecond at which the force changes, and a zero at the end."""
    head, mark = (_ESTIMATED_HEAD, ",1") if track.is_estimated else (_HEAD, "")
    out.write(f"{head}\n".encode())
    before_n = np.full((1, 3), np.nan)
    until_ms = end_ms(track, choices.duration_s)
    for first, last in pieces(until_ms, _PIECE_MS):
        ticks = np.arange(first, last)
        force_n = track.at(ticks / 1000.0).astype(np.float32)
        changed = np.any(np.diff(force_n, axis=0, prepend=before_n) != 0.0, axis=1)
        out.write(_rows(ticks[changed], force_n[changed], mark))
        before_n = force_n[-1:].astype(np.float64)
    if before_n.any():
        out.write(_rows(np.array([max(until_ms, 1)]), np.zeros((1, 3)), mark))
    return ()


def _rows(ticks: Ticks, force_n: NDArray[np.floating], mark: str) -> bytes:
    rows = np.column_stack([ticks / 1000.0, force_n])
    line = f"%.3f,%.7g,%.7g,%.7g{mark}\n"
    return (line * len(rows) % tuple(rows.ravel().tolist())).encode()
