"""funscript 1.0, 1.1 and 2.0: positions over time on three axes, 0 to 100.

Written is the excursion that a normal hand would make, as lines within one step; 50 is the
centre, 0 and 100 the edge of the workspace. Read is the set-point of a centring spring: the force is that of
the spring on a hand at the centre, stiffness times set-point. A file holds no newtons.
Axes: L0 up, L1 (surge) forward, L2 (sway) to the left; others are not read. Version 1.0 is
a file for each axis, `ride.surge.funscript` beside `ride.funscript`. A file of strengths,
`ride.vib.funscript`, is a vibration. Names of entries count in any case, null as absent.
"""

import json
from pathlib import Path
from typing import Annotated, Any, BinaryIO, NamedTuple

import numpy as np
from msgspec import Meta, Struct

from hapticplayer import __version__
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.hjif_bands import MAX_SAMPLES
from hapticplayer.extras.formats.hjif_file import MAX_BYTES, Number
from hapticplayer.extras.formats.hjif_signals import (
    BEFORE_ZERO,
    STEP_S,
    HjifEffect,
    Keyframes,
    from_zero,
    stepped,
    wave,
)
from hapticplayer.extras.formats.thinning import Polyline, thin
from hapticplayer.haptics.limiter import limits_of
from hapticplayer.model import ForceTrack
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MAX_SECONDS, refuse_large_force
from hapticplayer.sequence.excursion import travel_m
from hapticplayer.sequence.force_files import (
    ForceFile,
    Loss,
    ReadChoices,
    WriteChoices,
    origin,
)
from hapticplayer.sequence.milliseconds import Ticks, end_ms
from hapticplayer.structures import convert, read_json
from hapticplayer.untrusted import ANOTHER

REACH_M = limits_of(FALCON).workspace_m
MAX_ACTIONS = 900_000
"""What `read` takes."""

_AT_ONCE = 1 << 14  # actions in memory as text
_AXES = {"L0": (1, 1.0), "L1": (2, -1.0), "L2": (0, -1.0)}
_CHANNELS = {"surge": "L1", "sway": "L2"}
_PARTS = {"": "L0", ".surge": "L1", ".sway": "L2"}
"""What stands before the suffix of a file of version 1.0, and its axis."""

_NAMED = {
    **dict.fromkeys(("l0", "stroke", "up"), "L0"),
    **dict.fromkeys(("l1", "surge", "forward"), "L1"),
    **dict.fromkeys(("l2", "sway", "left"), "L2"),
}
_ROTATIONS = ("r0", "twist", "yaw", "r1", "roll", "r2", "pitch")
_VIBRATIONS = ("v0", "vib", "vibe", "vibrate", "vibration", "vib1", "vib2")
_STRENGTHS = (
    *("v1", "pump", "a0", "valve", "a1", "suck", "suction", "a2", "lube", "squeeze"),
    *("oscillate", "alpha", "beta", "volume", "frequency", "pulse_frequency"),
    "pulse_width",
)
"""As MultiFunPlayer and its neighbours name files; 0 is off, not the lowest place."""

VIBRATION_HZ = 50.0
_SHORTEST_MS = 4.0
"""No device takes positions as near as that: the times are seconds."""

_WHOLE_RANGE, _USUAL_RANGE = 100.0, 90.0
"""The latter stands in most files, and players do not apply it."""
_MARK = b"written by hapticplayer"


class _Action(Struct, gc=False):
    at: Annotated[float, Meta(ge=-1000.0 * MAX_SECONDS, le=1000.0 * MAX_SECONDS)]
    pos: Number


class _Axis(Struct):
    actions: list[_Action] = []
    inverted: bool = False
    id: str = ""
    is_null: bool = False


_OURS = ("is_null", "others")
"""No entries of files."""


class _Script(_Axis):
    range: Number = 100.0
    axes: list[_Axis] = []
    channels: dict[str, _Axis] = {}
    others: list[str] = []


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return head.startswith(b'{"version"') and _MARK in head[:200]


def parts(choices: WriteChoices) -> tuple[str, ...]:
    """What stands before the suffix of the files of a version."""
    return tuple(_PARTS) if choices.funscript_version == "1.0" else ("",)


def write(
    track: ForceTrack, out: BinaryIO, choices: WriteChoices
) -> tuple[Message, ...]:
    """Write the excursion of a normal hand; a file of version 1.0 has one axis."""
    refuse_large_force(track.force_n, "funscript")
    time_s, place_m = travel_m(track, end_ms(track, choices.duration_s) / 1000.0)
    wanted = [_PARTS[choices.part]] if choices.funscript_version == "1.0" else _AXES
    axes = {
        name: _actions(time_s, 50.0 * sign * place_m[:, column] / REACH_M)
        for name, (column, sign) in _AXES.items()
        if name in wanted
    }
    _refuse_many(sum(len(at_ms) for at_ms, _ in axes.values()))
    about = {"creator": f"{_MARK.decode()} {__version__}{origin(track)}"}
    version = choices.take("funscript_version")
    head = {"version": version, "metadata": about}
    out.write(json.dumps(head, separators=(",", ":")).encode().removesuffix(b"}"))
    out.write(b',"actions":')
    _write_actions(out, *axes.pop(_PARTS[choices.part]))
    if version == "1.1":
        heads = [f'{{"id":"{name}","actions":' for name in axes]
        _write_axes(out, ',"axes":[', heads, list(axes.values()), "]")
    elif version == "2.0":
        names = {axis: name for name, axis in _CHANNELS.items()}
        heads = [f'"{names[axis]}":{{"actions":' for axis in axes]
        _write_axes(out, ',"channels":{', heads, list(axes.values()), "}")
    out.write(b"}")
    left_out = [Message("the force in newtons")]
    if float(np.abs(place_m).max(initial=0.0)) > REACH_M:
        edge = Message("excursions beyond {reach_mm:g} mm", reach_mm=1000.0 * REACH_M)
        left_out.append(edge)
    return tuple(left_out)


def no_newtons(_track: ForceTrack, _path: Path, _choices: WriteChoices) -> Loss:
    return Loss(None, None, Message("positions, no newtons"))


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the spring's force on a hand at the centre, or a vibration."""
    if _part_of(path) in _VIBRATIONS:
        return _vibration(path, choices)
    stiffness: float = choices.take("stiffness_n_per_m")
    said = Message(
        "positions were taken as the set-point of a spring of {stiffness:.3g} N/m, "
        "with the hand at the centre",
        stiffness=stiffness,
    )
    reader = _AxisReader([said], [], {})
    reader.add(path)
    for beside, axis in _files_beside(path):
        if axis not in _AXES:
            said = Message("not read: {what} beside it", what=beside.name)
            reader.unread.append(said)
            continue
        reader.add(beside)
        said = Message("{name} beside it was read, too", name=beside.name)
        reader.assumed.append(said)
    axes = reader.axes
    if not axes:
        raise _nothing(path, reader.unread)
    time_s = np.unique(np.concatenate([at_s for at_s, _ in axes.values()]))
    force_n = np.zeros((len(time_s), 3))
    for name, (at_s, place) in axes.items():
        column, sign = _AXES[name]
        shift_m = sign * REACH_M * (np.interp(time_s, at_s, place) - 50.0) / 50.0
        force_n[:, column] = stiffness * shift_m
    return _file(path, reader, time_s, force_n, "funscript set-point")


def _vibration(path: Path, choices: ReadChoices) -> ForceFile:
    """A vibration of the strengths of a file."""
    full_n, way = choices.take("full_scale_n"), choices.take("direction")
    said = Message(
        "vibration of {hertz:g} Hz along x {x:.2f}, y {y:.2f}, z {z:.2f}: strength 100 was "
        "taken as {full_n:.3g} N",
        hertz=VIBRATION_HZ,
        full_n=full_n,
        **dict(zip("xyz", way, strict=True)),
    )
    reader = _AxisReader([said], [], {})
    reader.add(path)
    if "L0" not in reader.axes:
        raise _nothing(path, reader.unread)
    at_s, strength = reader.axes["L0"]
    if at_s[-1] > MAX_SAMPLES / 1000.0:
        raise InputError(
            "waves of more than {most_s:.0f} s",
            where=str(path),
            remedy=Message("cut it into parts"),
            most_s=MAX_SAMPLES / 1000.0,
        )
    is_early = at_s[0] < 0.0
    at_s, levels = from_zero(at_s, strength[:, None] / 100.0, str(path))
    if at_s[0] > STEP_S:  # off until its first action
        at_s = np.concatenate([[0.0, at_s[0] - STEP_S], at_s])
        levels = np.concatenate([np.zeros((2, 1)), levels])
    hertz = np.full(len(at_s), VIBRATION_HZ)
    shape = wave(
        HjifEffect(0.0, Keyframes(at_s, levels[:, 0], hertz)), 0.0, VIBRATION_HZ
    )
    if is_early:
        reader.unread.append(BEFORE_ZERO)
    force_n = full_n * np.outer(shape.value, way)
    return _file(path, reader, shape.time_s, force_n, "funscript vibration")


def _file(
    path: Path, reader: "_AxisReader", time_s: Floats, force_n: Floats, what: str
) -> ForceFile:
    if time_s[0] < 0.0:
        reader.unread.append(BEFORE_ZERO)
    time_s, force_n = from_zero(time_s, force_n, str(path))
    source = {"source": path.name, "reader": what}
    track = ForceTrack(time_s, force_n.astype(np.float32), provenance=source)
    return ForceFile(track, tuple(reader.assumed), tuple(reader.unread))


def _nothing(path: Path, unread: list[Message]) -> InputError:
    if not unread:
        return InputError("holds no positions", where=str(path), remedy=ANOTHER)
    return InputError(
        "holds no positions that are read ({first})",
        where=str(path),
        remedy=ANOTHER,
        first=unread[0],
    )


def _script(path: Path) -> _Script:
    """The content of a file, its names and numbers as they should be written."""
    given = _tidy(read_json(path, dict[str, Any], InputError, ANOTHER, MAX_BYTES))
    script = convert(given, _Script, str(path), strict=False)
    known = _Script.__struct_fields__
    script.others = [k for k, v in given.items() if k not in known and _is_actions(v)]
    return script


def _is_actions(value: Any) -> bool:
    """Whether an entry of another name holds actions."""
    held = value.get("actions") if isinstance(value, dict) else value
    first = held[0] if isinstance(held, list) and held else None
    return isinstance(first, dict) and {"at", "pos"} <= first.keys()


def _tidy(given: dict[str, Any]) -> dict[str, Any]:
    """An object with names in small letters, without entries that are null."""
    found: dict[str, Any] = {}
    for name, value in given.items():
        key = name.strip().lower()
        if value is None and key == "actions":
            found["is_null"] = True
        elif value is None:
            continue
        elif key not in _OURS and (key not in found or key == name):
            found[key] = value
    if isinstance(actions := found.get("actions"), list):
        found["actions"] = [_tidy_action(one) for one in actions]
    for key in ("axes", "channels"):
        held = found.get(key)
        if isinstance(held, list):
            found[key] = [_tidied(one) for one in held if one is not None]
        elif isinstance(held, dict):
            found[key] = {k: _tidied(v) for k, v in held.items() if v is not None}
    return found


def _tidied(value: Any) -> Any:
    return _tidy(value) if isinstance(value, dict) else value


def _tidy_action(one: Any) -> Any:
    """An action with names in small letters; what is null in it is named."""
    if not isinstance(one, dict) or one.keys() >= {"at", "pos"}:
        return one
    return {name.strip().lower(): value for name, value in one.items()}


class _AxisReader(NamedTuple):
    """Collects the axes of files as times (n,) s and positions (n,) 0 to 100."""

    assumed: list[Message]
    unread: list[Message]
    axes: dict[str, tuple[Floats, Floats]]

    def add(self, path: Path) -> None:
        """Add all axes of a file."""
        main = _axis_of(path)
        script = _script(path)
        if script.range != _WHOLE_RANGE:
            said = Message(
                "the range of {range:g} % was not applied: 0 to 100 is the whole way",
                range=script.range,
            )
            is_usual = script.range == _USUAL_RANGE
            (self.assumed if is_usual else self.unread).append(said)
        for other in script.others:
            self.unread.append(
                Message("not read: {what} ({count})", what=other, count=1)
            )
        self._add_axis(main, script, str(path))
        for axis in script.axes:
            self._add_axis(axis.id, axis, str(path))
        for name, axis in script.channels.items():
            self._add_axis(name, axis, str(path))

    def _add_axis(self, given: str, one: _Axis, where: str) -> None:
        name = _NAMED.get(given.lower(), given)
        if name not in _AXES:
            what = given[:20] or Message("axis without an id")
            said = Message("not read: {what} ({count})", what=what, count=1)
            self.unread.append(said)
            return
        if one.is_null:
            self.unread.append(Message("{axis}: its actions are null", axis=name))
        if not one.actions:
            return
        _refuse_seconds(one.actions, name, where)
        largest = max(action.pos for action in one.actions)
        if len(one.actions) > 1 and 0.0 < largest <= 1.0:
            raise InputError(
                "its positions of {axis} go from 0 to 1, but a funscript's go to 100",
                where=where,
                remedy="multiply its positions by 100",
                axis=name,
            )
        beyond = sum(not 0.0 <= action.pos <= 100.0 for action in one.actions)
        if beyond:
            said = Message(
                "{count} positions of {axis} beyond 0 to 100 were limited",
                count=beyond,
                axis=name,
            )
            self.assumed.append(said)
        curve = _positions(one)
        same = self.axes.setdefault(name, curve)
        if not all(map(np.array_equal, same, curve)):
            said = Message("{axis} appears twice; the first was read", axis=name)
            self.unread.append(said)


def _refuse_seconds(actions: list[_Action], name: str, where: str) -> None:
    """Raise InputError where the times can only be seconds."""
    times = np.unique([action.at for action in actions])
    is_whole = not np.any(times % 1.0)
    if len(times) > 2 and not is_whole and np.median(np.diff(times)) < _SHORTEST_MS:
        raise InputError(
            "its times of {axis} look like seconds, but a funscript's are milliseconds",
            where=where,
            remedy="multiply its times by 1000",
            axis=name,
        )


def _part_of(path: Path) -> str:
    """What stands before the suffix of a name, in small letters."""
    name, _, part = path.name.lower().removesuffix(".funscript").rpartition(".")
    return part if name else ""


def _axis_of(path: Path) -> str:
    """The axis that the name of a file says; up where it says none."""
    part = _part_of(path)
    if part in _ROTATIONS or part in _STRENGTHS:
        is_rotation = part in _ROTATIONS
        stem = path.stem[: -len(part) - 1]
        other = f"{stem}.funscript" if is_rotation else f"{stem}.vib.funscript"
        as_what = Message("up and down") if is_rotation else Message("vibration")
        raise InputError(
            "holds {what} (.{part}), which are not read",
            where=str(path),
            remedy=Message(
                "rename it to {name!r} to feel it as {as_what}",
                name=other,
                as_what=as_what,
            ),
            what=Message("rotations") if is_rotation else Message("strengths"),
            part=part,
        )
    return _NAMED.get(part, "L0")


def _files_beside(path: Path) -> list[tuple[Path, str]]:
    """The others of a script that is named without an axis, each with its own."""
    if _axis_of(path) != "L0":
        return []
    stem, found = path.stem.lower(), []
    for one in sorted(path.parent.iterdir()):
        base, _, part = one.stem.lower().rpartition(".")
        if base == stem and one.suffix.lower() == ".funscript" and one.is_file():
            axis = _NAMED.get(part, part)
            if axis in _AXES or part in _ROTATIONS + _STRENGTHS + _VIBRATIONS:
                found.append((one, axis))
    return found


def _positions(one: _Axis) -> tuple[Floats, Floats]:
    """Return times (n,) s, increasing, and positions (n,) 0 to 100."""
    rows = np.array([(action.at, action.pos) for action in one.actions])
    rows = rows[np.argsort(rows[:, 0], kind="stable")]
    at_s, place = stepped(rows[:, 0] / 1000.0, np.clip(rows[:, 1], 0.0, 100.0))
    return at_s, 100.0 - place if one.inverted else place


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
