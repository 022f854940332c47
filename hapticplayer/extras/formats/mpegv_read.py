"""Reads MPEG-V sensory effects (ISO/IEC 23005-3), our own and others', as force.

PassiveKinestheticForce is a matrix of newtons, evenly over its duration; by rows and
duration alone, since what the standard means by `timeSamples` could not be verified.
ActiveKinesthetic is a constant force, Vibration a sine at the full scale that the user
chooses. RigidBodyMotion MoveToward is acceleration times the default gain, unless the
file holds PassiveKinestheticForce: then it moves a seat, and the hand has its force.
Attributes without a namespace, as Python PlaySEM writes them (type="vibration", timestamp,
intensity), are read too. XML is read without entities, document types and network.
"""

import math
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError

import numpy as np
from defusedxml import ElementTree
from defusedxml.common import DefusedXmlException

from hapticplayer.errors import InputError, Message
from hapticplayer.extras.formats.hjif_signals import STEP_S
from hapticplayer.model import ForceTrack, Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import MAX_SECONDS, ForceFile, ReadChoices
from hapticplayer.untrusted import ANOTHER, read_regular

MAX_BYTES = 24 << 20
MAX_TAGS, MAX_ROWS = 200_000, 1_500_000
_VIBRATION_HZ = 50.0
_XSI = "{http://www.w3.org/2001/XMLSchema-instance}type"
_SI = "{urn:mpeg:mpeg21:2003:01-DIA-XSI-NS}"


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file."""
    reader = _EffectReader(choices, str(path))
    for element, scale in reader.effects(_parsed(path)):
        reader.add(element, scale)
    return reader.result(path.name)


def _parsed(path: Path) -> Element:
    content = read_regular(path, MAX_BYTES)
    if content.count(b"<") > MAX_TAGS:
        raise InputError("holds too many values", where=str(path), remedy=ANOTHER)
    try:
        root: Element = ElementTree.fromstring(content, forbid_dtd=True)
    except (ParseError, DefusedXmlException, ValueError, LookupError) as problem:
        raise InputError(
            "is not valid XML ({reason})",
            where=str(path),
            remedy=ANOTHER,
            reason=str(problem) or type(problem).__name__,
        ) from problem
    if _name(root.tag) != "SEM":
        raise InputError("is not MPEG-V (SEM)", where=str(path), remedy=ANOTHER)
    return root


class _EffectReader:
    """Collects effects as polylines of force."""

    def __init__(self, choices: ReadChoices, where: str) -> None:
        self._choices, self._where = choices, where
        self._parts: list[tuple[Floats, Floats]] = []
        self._motions: list[tuple[Floats, Floats]] = []
        self._has_force = False
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
        kind = element.get(_XSI, element.get("type", ""))
        kind = kind.rpartition(":")[2].removesuffix("Type")
        kind = kind[:1].upper() + kind[1:]
        pts = "timestamp" if "timestamp" in element.attrib else _SI + "pts"
        begin_s = self._number(element, pts, 0.0, 0.0, 1e15) / scale
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
            is_motion = kind == "RigidBodyMotion"
            (self._motions if is_motion else self._parts).append((at_s, force_n))
            self._has_force |= kind == "PassiveKinestheticForce"
        else:
            self._unread[kind or "?"] += 1

    def result(self, name: str) -> ForceFile:
        """Return the sum of all effects as one track."""
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._unread.items()
        ]
        parts = self._parts + self._moves(unread)
        if not parts:
            raise self._refusal(Message("holds no force that is understood"))
        time_s, force_n = _summed(parts)
        refuse_large_force(force_n, self._where)
        track = ForceTrack(
            time_s,
            force_n.astype(np.float32),
            provenance={"source": name, "reader": "mpegv"},
        )
        return ForceFile(track, tuple(self._notes), tuple(unread))

    def _moves(self, notes: list[Message]) -> list[tuple[Floats, Floats]]:
        """The force that motion adds: nothing beside a force."""
        count = len(self._motions)
        if self._has_force and count:
            said = Message(
                "motion beside the force was left out ({count})", count=count
            )
            notes.append(said)
            return []
        if count:
            gain = float(np.mean(Mapping().gain_n_per_mps2))
            said = Message(
                "acceleration was taken times {gain:.2g} N per m/s²", gain=gain
            )
            notes.insert(0, said)
        return self._motions

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
                return np.tile(gain * size * way, (2, 1))
        return np.zeros((0, 3))

    def _vibration(self, element: Element, length_s: float) -> Floats:
        span = element.get("intensity-range", "0 100").split()
        most = float(span[1][:9]) if len(span) == 2 and span[1].isdecimal() else 100.0
        name = "intensity" if "intensity" in element.attrib else "intensity-value"
        level = self._number(element, name, 0.0, -1e6, 1e6) / max(most, 1.0)
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
        return InputError(what, where=self._where, remedy=ANOTHER)


def _summed(parts: list[tuple[Floats, Floats]]) -> tuple[Floats, Floats]:
    """Return times (n,) s and the sum (n, 3) N of polylines; each is zero outside."""
    ends = [np.array([t[0] - STEP_S, t[-1] - STEP_S]) for t, _ in parts]
    time_s = np.unique(np.concatenate([*(t for t, _ in parts), *ends]))
    time_s = time_s[time_s >= 0.0]
    force_n = np.zeros((len(time_s), 3))
    for at_s, part_n in parts:  # where it ends, the next one counts
        inside = slice(*np.searchsorted(time_s, [at_s[0], at_s[-1]]).tolist())
        for axis in range(3):
            force_n[inside, axis] += np.interp(time_s[inside], at_s, part_n[:, axis])
    return time_s, force_n


def _name(tag: str) -> str:
    return tag.rpartition("}")[2]
