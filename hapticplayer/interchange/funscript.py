"""funscript 1.0, 1.1 and 2.0: positions over time on three axes, 0 to 100.

Written is the excursion that a normal hand would make; 50 is the centre, 0 and 100 the
edge of the workspace. Read is the set-point of a centring spring: the force is that of
the spring on a hand at the centre, stiffness times set-point. A file holds no newtons.
Axes: L0 up, L1 (surge) forward, L2 (sway) to the left; others are not read.
"""

import json
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from hapticplayer import __version__
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import InputError, Message
from hapticplayer.haptics.limiter import limits_of
from hapticplayer.interchange.force_files import (
    MAX_SECONDS,
    ForceFile,
    Loss,
    ReadChoices,
    WriteChoices,
    refuse_large,
)
from hapticplayer.interchange.json_fields import Fields, read_crowd
from hapticplayer.interchange.milliseconds import end_ms
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.excursion import travel_m

REACH_M = limits_of(FALCON).workspace_m
_AXES = {"L0": (1, 1.0), "L1": (2, -1.0), "L2": (0, -1.0)}
_CHANNELS = {"stroke": "L0", "surge": "L1", "sway": "L2"}
_SUFFIXES = {".surge": "L1", ".sway": "L2"}
_OTHER_SUFFIXES = (".twist", ".roll", ".pitch")
_MARK = b"written by hapticplayer"
_ANOTHER = Message("choose another file")


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b'{"version"') and _MARK in head[:200]


def write(track: ForceTrack, out: BinaryIO, choices: WriteChoices) -> None:
    """Write the excursion of a normal hand; version 1.0 has the axis up alone.

    Raises:
        InputError: for forces beyond any device.
    """
    refuse_large(track.force_n, "funscript")
    time_s, place_m = travel_m(track, end_ms(track, choices.duration_s) / 1000.0)
    axes = {
        name: _actions(time_s, 50.0 + 50.0 * sign * place_m[:, column] / REACH_M)
        for name, (column, sign) in _AXES.items()
    }
    about = {"creator": f"{_MARK.decode()} {__version__}"}
    text: dict[str, Any] = {"version": choices.funscript_version, "metadata": about}
    text["actions"] = axes.pop("L0")
    if choices.funscript_version == "1.1":
        text["axes"] = [{"id": name, "actions": one} for name, one in axes.items()]
    elif choices.funscript_version == "2.0":
        names = {axis: name for name, axis in _CHANNELS.items()}
        text["channels"] = {
            names[axis]: {"actions": actions} for axis, actions in axes.items()
        }
    out.write(json.dumps(text, separators=(",", ":")).encode())


def no_newtons(_track: ForceTrack, _path: Path, _choices: WriteChoices) -> Loss:
    """Return that there is nothing to compare."""
    return Loss(None, None, Message("positions, no newtons"))


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the spring's force on a hand at the centre.

    Raises:
        InputError: when it is no such file.
    """
    root = Fields.of(read_crowd(path), str(path))
    stem = path.name.lower().removesuffix(".funscript")
    if stem.endswith(_OTHER_SUFFIXES):
        raise InputError("turns, and is not read", where=str(path), remedy=_ANOTHER)
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
        raise InputError("holds no positions", where=str(path), remedy=_ANOTHER)
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
    notes = [Message("not read: {what} ({count})", what=n, count=1) for n in unread]
    track = ForceTrack(
        time_s,
        force_n.astype(np.float32),
        provenance={"source": path.name, "reader": "funscript set-point"},
    )
    return ForceFile(track, (stiffness, *notes))


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
        raise InputError("holds no positions", where=one.where, remedy=_ANOTHER)
    at_ms, first = np.unique(rows[:, 0], return_index=True)
    place = np.clip(rows[first, 1], 0.0, 100.0)
    return at_ms / 1000.0, 100.0 - place if one.values.get(
        "inverted"
    ) is True else place


def _actions(time_s: Floats, place: Floats) -> list[dict[str, int]]:
    """Return actions where the position changes, and the points around them."""
    whole = np.clip(np.round(place), 0, 100).astype(int)
    change = np.flatnonzero(np.diff(whole))
    kept = np.unique(np.concatenate([[0], change, change + 1, [len(whole) - 1]]))
    at_ms = np.round(time_s[kept] * 1000.0).astype(int)
    return [
        {"at": at, "pos": pos}
        for at, pos in zip(at_ms.tolist(), whole[kept].tolist(), strict=True)
    ]
