"""MPEG-V sensory effects (ISO/IEC 23005-3, schema of 2010): passive kinesthetic force.

Each effect is a matrix of samples, evenly over its duration, with lines between; a span
without force has none. `timeSamples` is the number of rows: what the standard means by it
could not be verified, so the reader goes by rows and duration alone. Other effects that
are read: ActiveKinesthetic (a constant force), RigidBodyMotion MoveToward (acceleration
times the default gain), Vibration (a sine at the full scale that the user chooses).
XML is read without entities, document types and network.
"""

import math
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO
from xml.etree.ElementTree import Element, ParseError

import numpy as np
from defusedxml import ElementTree
from defusedxml.common import DefusedXmlException

from hapticplayer.errors import InputError, Message
from hapticplayer.interchange.force_files import (
    MAX_SECONDS,
    ForceFile,
    ReadChoices,
    WriteChoices,
    refuse_large,
)
from hapticplayer.interchange.hjif_signals import STEP_S
from hapticplayer.interchange.milliseconds import Ticks, end_ms, pieces
from hapticplayer.model import ForceTrack, Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.untrusted import read_regular

MAX_BYTES = 24 << 20
MAX_ELEMENTS, MAX_ROWS = 100_000, 1_500_000
_STEPS_MS = (50, 40, 20, 10, 8, 5, 4, 2, 1)
_PIECE_MS = 10_000
_VIBRATION_HZ = 50.0
_XSI = "{http://www.w3.org/2001/XMLSchema-instance}type"
_SI = "{urn:mpeg:mpeg21:2003:01-DIA-XSI-NS}"
_SEDL = "urn:mpeg:mpeg-v:2010:01-SEDL-NS"
_MARK = "written by hapticplayer: x right, y up, z towards the user, newton"
_ANOTHER = Message("choose another file")
_HEAD = f"""<?xml version="1.0" encoding="UTF-8"?>
<!-- {_MARK} -->
<SEM xmlns="{_SEDL}" xmlns:sev="urn:mpeg:mpeg-v:2010:01-SEV-NS" \
xmlns:si="urn:mpeg:mpeg21:2003:01-DIA-XSI-NS" xmlns:mpeg7="urn:mpeg:mpeg7:schema:2004" \
xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" si:timeScale="1000">
"""


def is_ours(head: bytes) -> bool:
    """Whether a file begins as this program writes it."""
    return _MARK.encode() in head[:200]


def write(track: ForceTrack, out: BinaryIO, choices: WriteChoices) -> None:
    """Write a track; each 10 s at the lowest rate that stays within the tolerance.

    Raises:
        InputError: for forces beyond any device, or more samples than are read.
    """
    refuse_large(track.force_n, "mpegv")
    digits = max(0, math.ceil(-math.log10(choices.tolerance_n / 20.0)))
    rows, wrote = 0, False
    out.write(_HEAD.encode())
    for first, last in pieces(end_ms(track, choices.duration_s), _PIECE_MS):
        ticks = np.arange(first, last + 1)
        force_n = track.at(ticks / 1000.0)
        if not force_n.any() and (wrote or last < end_ms(track, choices.duration_s)):
            continue
        step_ms = last - first
        if force_n.any():
            step_ms = _step_ms(ticks, force_n, choices.tolerance_n * 0.9)
        kept = force_n[::step_ms]
        rows, wrote = rows + len(kept), True
        out.write(_effect(first, last - first, kept, digits).encode())
    out.write(b"</SEM>\n")
    if rows > MAX_ROWS:
        raise InputError(
            "the track is too long for this format", remedy="choose another format"
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


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file.

    Raises:
        InputError: when it is no such file, or holds no force.
    """
    reader = _Reader(choices, str(path))
    for element, scale in reader.effects(_parsed(path)):
        reader.add(element, scale)
    return reader.result(path.name)


def _parsed(path: Path) -> Element:
    content = read_regular(path, MAX_BYTES)
    if content.count(b"<") > 2 * MAX_ELEMENTS:
        raise InputError("holds too many values", where=str(path), remedy=_ANOTHER)
    try:
        root: Element = ElementTree.fromstring(content, forbid_dtd=True)
    except (ParseError, DefusedXmlException, ValueError, LookupError) as problem:
        raise InputError(
            "is not valid XML ({reason})",
            where=str(path),
            remedy=_ANOTHER,
            reason=str(problem) or type(problem).__name__,
        ) from problem
    if _name(root.tag) != "SEM":
        raise InputError("is not MPEG-V (SEM)", where=str(path), remedy=_ANOTHER)
    return root


class _Reader:
    """Collects effects as polylines of force."""

    def __init__(self, choices: ReadChoices, where: str) -> None:
        self._choices, self._where = choices, where
        self._parts: list[tuple[Floats, Floats]] = []
        self._notes: dict[Message, None] = {}
        self._unread: Counter[str] = Counter()
        self._left = MAX_ROWS

    def effects(self, root: Element) -> Iterator[tuple[Element, float]]:
        """Yield effects, also of groups, with the ticks in a second."""
        scale = self._number(root, _SI + "timeScale", 1000.0, 1.0, 1e9)
        for element in root.iter():
            if _name(element.tag) == "Effect":
                yield element, scale

    def add(self, element: Element, scale: float) -> None:
        """Add an effect, or note that it is not understood."""
        kind = _name(element.get(_XSI, "")).rpartition(":")[2].removesuffix("Type")
        begin_s = self._number(element, _SI + "pts", 0.0, 0.0, 1e15) / scale
        length_s = self._number(element, "duration", 0.0, 0.0, 1e15) / scale
        if begin_s + length_s > MAX_SECONDS:
            raise self._refusal(Message("an effect lies outside of any clip"))
        if kind == "PassiveKinestheticForce":
            force_n = self._matrix(element)
        elif kind == "ActiveKinesthetic":
            force_n = self._constant(element)
        elif kind == "RigidBodyMotion":
            force_n = self._moved(element)
        elif kind == "Vibration":
            force_n = self._vibration(element, length_s)
        else:
            force_n = np.zeros((0, 3))
        if len(force_n) and length_s > 0.0:
            at_s = begin_s + np.linspace(0.0, length_s, len(force_n))
            self._parts.append((at_s, force_n))
        else:
            self._unread[kind or "?"] += 1

    def result(self, name: str) -> ForceFile:
        """Return the sum of all effects as one track."""
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._unread.items()
        ]
        if not self._parts:
            raise self._refusal(Message("holds no force that is understood"))
        ends = [np.array([t[0] - STEP_S, t[-1] - STEP_S]) for t, _ in self._parts]
        time_s = np.unique(np.concatenate([*(t for t, _ in self._parts), *ends]))
        time_s = time_s[time_s >= 0.0]
        force_n = np.zeros((len(time_s), 3))
        for at_s, part_n in self._parts:  # where it ends, the next one counts
            inside = slice(*np.searchsorted(time_s, [at_s[0], at_s[-1]]).tolist())
            for axis in range(3):
                line = np.interp(time_s[inside], at_s, part_n[:, axis])
                force_n[inside, axis] += line
        refuse_large(force_n, self._where)
        track = ForceTrack(
            time_s,
            force_n.astype(np.float32),
            provenance={"source": name, "reader": "mpegv"},
        )
        return ForceFile(track, (*self._notes, *unread))

    def _matrix(self, element: Element) -> Floats:
        """Return a matrix of forces (n, 3) N."""
        texts = [
            (child.text or "").split()
            for child in element.iter()
            if _name(child.tag) == "PassiveKinestheticForce"
        ]
        words = texts[0] if texts else []
        self._spend(len(words) // 3)
        try:
            values = np.array(words, dtype=np.float64)
        except ValueError:
            values = np.array([math.nan])
        if len(values) % 3 or not np.isfinite(values).all():
            raise self._refusal(
                Message("a matrix of forces is not three numbers a row")
            )
        values = values.reshape(-1, 3)
        return np.repeat(values, 2, axis=0) if len(values) == 1 else values

    def _constant(self, element: Element) -> Floats:
        for child in element:
            if _name(child.tag) == "ActiveKinesthetic":
                force_n = [
                    self._number(child, f"f{axis}", 0.0, -1e6, 1e6) for axis in "xyz"
                ]
                return np.array([force_n, force_n])
        return np.zeros((0, 3))

    def _moved(self, element: Element) -> Floats:
        """Return acceleration times the default gain; 0 degrees is to the front."""
        for child in element:
            if _name(child.tag) == "MoveToward" and child.get("acceleration"):
                size = self._number(child, "acceleration", 0.0, -1e3, 1e3)
                flat, steep = (
                    math.radians(
                        self._number(child, f"direction{which}", 0.0, -1e3, 1e3)
                    )
                    for which in "HV"
                )
                front, side = math.cos(steep) * math.cos(flat), math.sin(flat)
                way = np.array([math.cos(steep) * side, math.sin(steep), -front])
                gain = float(np.mean(Mapping().gain_n_per_mps2))
                self._notes[
                    Message(
                        "acceleration was taken times {gain:.2g} N per m/s²", gain=gain
                    )
                ] = None
                return np.tile(gain * size * way, (2, 1))
        return np.zeros((0, 3))

    def _vibration(self, element: Element, length_s: float) -> Floats:
        span = element.get("intensity-range", "0 100").split()
        most = float(span[1][:9]) if len(span) == 2 and span[1].isdecimal() else 100.0
        level = self._number(element, "intensity-value", 0.0, -1e6, 1e6) / max(
            most, 1.0
        )
        count = int(length_s * 1000.0) + 1
        self._spend(count)
        full_n = self._choices.full_scale_n
        self._notes[
            Message(
                "vibration: full intensity was taken as {full_n:.3g} N", full_n=full_n
            )
        ] = None
        wave = np.sin(2.0 * np.pi * _VIBRATION_HZ * np.linspace(0.0, length_s, count))
        height_n = full_n * min(1.0, abs(level))
        return np.asarray(height_n * np.outer(wave, self._choices.direction))

    def _spend(self, rows: int) -> None:
        self._left -= rows
        if self._left < 0:
            raise self._refusal(Message("holds too many values"))

    def _number(
        self, element: Element, name: str, default: float, least: float, most: float
    ) -> float:
        text = element.get(name)
        try:
            value = default if text is None else float(text)
        except ValueError:
            value = math.nan
        if not least <= value <= most:
            raise self._refusal(Message("{name} is out of range", name=name))
        return value

    def _refusal(self, what: Message) -> InputError:
        return InputError(what, where=self._where, remedy=_ANOTHER)


def _name(tag: str) -> str:
    return tag.rpartition("}")[2]
