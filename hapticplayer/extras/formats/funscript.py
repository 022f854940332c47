"""funscript 1.0, 1.1 and 2.0: positions over time on three axes, 0 to 100.

Written is the excursion that a normal hand would make, as lines within one step; 50 is the
centre, 0 and 100 the edge of the workspace. Read is the set-point of a centring spring: the force is that of
the spring on a hand at the centre, stiffness times set-point. A file holds no newtons.
Axes: L0 up, L1 (surge) forward, L2 (sway) to the left; others are not read.
"""

import json
from pathlib import Path
from typing import BinaryIO

import numpy as np

from hapticplayer import __version__
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.json_fields import Fields, read_crowd
from hapticplayer.extras.formats.thinning import Polyline, thin
from hapticplayer.haptics.limiter import limits_of
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.excursion import travel_m
from hapticplayer.sequence.force_files import (
    MAX_SECONDS,
    ForceFile,
    Loss,
    ReadChoices,
    WriteChoices,
    origin,
)
from hapticplayer.sequence.milliseconds import Ticks, end_ms
from hapticplayer.untrusted import ANOTHER

REACH_M = limits_of(FALCON).workspace_m
MAX_ACTIONS = 900_000
"""What `read` takes."""

_AT_ONCE = 1 << 14  # actions in memory as text
_AXES = {"L0": (1, 1.0), "L1": (2, -1.0), "L2": (0, -1.0)}
_CHANNELS = {"stroke": "L0", "surge": "L1", "sway": "L2"}
_SUFFIXES = {".surge": "L1", ".sway": "L2"}
_OTHER_SUFFIXES = (".twist", ".roll", ".pitch")
_MARK = b"written by hapticplayer"


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b'{"version"') and _MARK in head[:200]


def write(track: ForceTrack, out: BinaryIO, choices: WriteChoices) -> None:
    """Write the excursion of a normal hand; version 1.0 has the axis up alone."""
    refuse_large_force(track.force_n, "funscript")
    time_s, place_m = travel_m(track, end_ms(track, choices.duration_s) / 1000.0)
    axes = {
        name: _actions(time_s, 50.0 * sign * place_m[:, column] / REACH_M)
        for name, (column, sign) in _AXES.items()
    }
    _refuse_many(sum(len(at_ms) for at_ms, _ in axes.values()))
    about = {"creator": f"{_MARK.decode()} {__version__}{origin(track)}"}
    head = {"version": choices.funscript_version, "metadata": about}
    out.write(json.dumps(head, separators=(",", ":")).encode().removesuffix(b"}"))
    out.write(b',"actions":')
    _write_actions(out, *axes.pop("L0"))
    if choices.funscript_version == "1.1":
        heads = [f'{{"id":"{name}","actions":' for name in axes]
        _write_axes(out, ',"axes":[', heads, list(axes.values()), "]")
    elif choices.funscript_version == "2.0":
        names = {axis: name for name, axis in _CHANNELS.items()}
        heads = [f'"{names[axis]}":{{"actions":' for axis in axes]
        _write_axes(out, ',"channels":{', heads, list(axes.values()), "}")
    out.write(b"}")


def no_newtons(_track: ForceTrack, _path: Path, _choices: WriteChoices) -> Loss:
    return Loss(None, None, Message("positions, no newtons"))


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the spring's force on a hand at the centre."""
    root = Fields.of(read_crowd(path), str(path))
    stem = path.name.lower().removesuffix(".funscript")
    if stem.endswith(_OTHER_SUFFIXES):
        raise InputError(
            "holds rotations, which are not read", where=str(path), remedy=ANOTHER
        )
    main = next((one for end, one in _SUFFIXES.items() if stem.endswith(end)), "L0")
    lists = {main: root}
    unread: list[str] = []
    for axis in root.objects("axes"):
        lists[axis.text("id")] = axis
    channels = root.values.get("channels", {})
    for name, value in Fields.of(channels, f"{path}, channels").values.items():
        one = Fields.of(value, f"{path}, channels, {name[:40]}")
        lists[_CHANNELS.get(name, name)] = one
    curves = []
    for name, one in lists.items():
        if name not in _AXES:
            unread.append(name[:20])
        elif one.items("actions"):
            curves.append((*_AXES[name], *_positions(one)))
    if not curves:
        raise InputError("holds no positions", where=str(path), remedy=ANOTHER)
    time_s = np.unique(np.concatenate([curve[2] for curve in curves]))
    force_n = np.zeros((len(time_s), 3))
    for column, sign, at_s, place in curves:
        shift_m = sign * REACH_M * (np.interp(time_s, at_s, place) - 50.0) / 50.0
        force_n[:, column] = choices.stiffness_n_per_m * shift_m
    stiffness = Message(
        "positions were taken as the set-point of a spring of {stiffness:.3g} N/m, with "
        "the hand at the centre",
        stiffness=choices.stiffness_n_per_m,
    )
    notes = tuple(
        Message("not read: {what} ({count})", what=n, count=1) for n in unread
    )
    track = ForceTrack(
        time_s,
        force_n.astype(np.float32),
        provenance={"source": path.name, "reader": "funscript set-point"},
    )
    return ForceFile(track, (stiffness,), notes)


def _positions(one: Fields) -> tuple[Floats, Floats]:
    """Return times (n,) s, increasing, and positions (n,) 0 to 100."""
    rows = np.array(
        [
            (action.number("at", most=1000.0 * MAX_SECONDS), action.number("pos"))
            for action in one.objects("actions")
        ]
    )
    rows = rows[rows[:, 0] >= 0.0]
    if not len(rows):
        raise InputError("holds no positions", where=one.where, remedy=ANOTHER)
    at_ms, first = np.unique(rows[:, 0], return_index=True)
    place = np.clip(rows[first, 1], 0.0, 100.0)
    return at_ms / 1000.0, 100.0 - place if one.values.get(
        "inverted"
    ) is True else place


def _actions(time_s: Floats, shift: Floats) -> Polyline:
    """Return times (k,) ms and whole positions (k,) of lines near a curve.

    Args:
        time_s: (n,).
        shift: (n,) from the centre; 50 is the edge.
    """
    ticks = np.round(time_s * 1000.0).astype(np.int64)
    if len(ticks) == 1:
        return ticks, np.array([50.0])
    at_ms, whole = thin(ticks, np.clip(shift, -50.0, 50.0), 1.0, 1.0)
    return at_ms, np.clip(whole + 50.0, 0.0, 100.0)


def _write_axes(
    out: BinaryIO, begin: str, heads: list[str], curves: list[Polyline], end: str
) -> None:
    for head, curve in zip(heads, curves, strict=True):
        out.write((begin + head).encode())
        _write_actions(out, *curve)
        out.write(b"}")
        begin = ","
    out.write(end.encode())


def _write_actions(out: BinaryIO, at_ms: Ticks, place: Floats) -> None:
    out.write(b"[")
    for first in range(0, len(at_ms), _AT_ONCE):
        rows = zip(
            at_ms[first : first + _AT_ONCE].tolist(),
            place[first : first + _AT_ONCE].astype(int).tolist(),
            strict=True,
        )
        text = ",".join(f'{{"at":{at},"pos":{pos}}}' for at, pos in rows)
        out.write(("," * bool(first) + text).encode())
    out.write(b"]")


def _refuse_many(count: int) -> None:
    if count > MAX_ACTIONS:
        raise InputError(
            "the track needs {count} positions (limit: {most})",
            remedy=Message("choose another format"),
            count=count,
            most=MAX_ACTIONS,
        )
