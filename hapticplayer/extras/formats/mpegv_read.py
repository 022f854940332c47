"""Reads MPEG-V sensory effects (ISO/IEC 23005-3), our own and others', as force.

PassiveKinestheticForce is a matrix of newtons, evenly over its duration; by rows and
duration alone, since what the standard means by `timeSamples` could not be verified.
ActiveKinesthetic is a constant force, Vibration a sine at the full scale that the user
chooses. RigidBodyMotion MoveToward is acceleration times the default gain, unless the
file holds PassiveKinestheticForce: then it moves a seat, and the hand has its force.
Attributes without a namespace, as Python PlaySEM writes them (type="vibration", timestamp,
intensity), are read too; when effects act is in `mpegv_times`. XML is read without
entities, document types and network.
"""

import math
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError

import numpy as np
from defusedxml import ElementTree
from defusedxml.common import DefusedXmlException

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.extras.formats.hjif_signals import STEP_S
from hapticplayer.extras.formats.mpegv_times import (
    Attributes,
    EffectTimes,
    SemEffect,
    name_of,
    number_in,
)
from hapticplayer.model import ForceTrack, Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import refuse_large_force
from hapticplayer.sequence.force_files import ForceFile, ReadChoices
from hapticplayer.untrusted import ANOTHER, read_regular

MAX_BYTES = 24 << 20
MAX_TAGS, MAX_ROWS = 200_000, 1_500_000
_VIBRATION_HZ = 50.0
_MOST_SAID = 3


def read(path: Path, choices: ReadChoices) -> ForceFile:
    """Return the force of a file."""
    root = _parsed(path)
    times = EffectTimes(str(path), choices.until_s, MAX_TAGS)
    reader = _EffectReader(choices, times, str(path))
    for effect in times.effects(root):
        reader.add(effect)
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
    if name_of(root.tag) != "SEM":
        raise InputError("is not MPEG-V (SEM)", where=str(path), remedy=ANOTHER)
    return root


class _EffectReader:
    """Collects effects as polylines of force."""

    def __init__(self, choices: ReadChoices, times: EffectTimes, where: str) -> None:
        self._choices, self._where = choices, where
        self._notes, self._unread, self._times = times.assumed, times.unread, times
        self._parts: list[tuple[Floats, Floats]] = []
        self._motions: list[tuple[Floats, Floats]] = []
        self._has_force = False
        self._left = MAX_ROWS

    def add(self, effect: SemEffect) -> None:
        """Add an effect, or note that it is not understood."""
        force_n = self._force_n(effect)
        if "autoExtraction" in effect.attributes.values:
            self._unread["autoExtraction"] += 1
        if not len(force_n):
            self._unread[effect.kind or "?"] += 1
            return
        at_s, force_n = _faded(effect, force_n)
        part = (effect.begin_s + at_s, force_n)
        is_motion = effect.kind == "RigidBodyMotion"
        (self._motions if is_motion else self._parts).append(part)
        self._has_force |= effect.kind == "PassiveKinestheticForce"

    def _force_n(self, effect: SemEffect) -> Floats:
        """Return samples (n, 3) evenly over an effect; none where it is unknown."""
        if effect.kind == "PassiveKinestheticForce":
            rows = self._matrix(effect.element)
            if effect.attributes.values.get("timeSamples", "").strip() not in (
                *("", str(len(rows))),
                *("1" * (len(rows) == 2)),
            ):
                said = Message(
                    "timeSamples was not used where it is not that of the rows"
                )
                self._notes[said] = None
            return rows
        if effect.kind == "ActiveKinesthetic":
            return self._constant(effect.element)
        if effect.kind == "RigidBodyMotion":
            return self._moved(effect.element)
        if effect.kind == "Vibration":
            return self._vibration(effect)
        return np.zeros((0, 3))

    def result(self, name: str) -> ForceFile:
        """Return the sum of all effects as one track."""
        unread = [
            Message("not read: {what} ({count})", what=what, count=count)
            for what, count in self._unread.items()
        ]
        parts = self._parts + self._moves(unread)
        if not parts:
            if not unread:
                raise self._refusal(Message("holds no force that is understood"))
            what = Message(
                "holds no force that is understood ({first})",
                first=joined("; ", unread[:_MOST_SAID]),
            )
            raise self._refusal(what)
        time_s, force_n = _summed(parts)
        refuse_large_force(force_n, self._where)
        track = ForceTrack(
            time_s,
            force_n.astype(np.float32),
            provenance={"source": name, "reader": "mpegv"},
        )
        return ForceFile(track, tuple(self._notes), tuple(unread))

    def _moves(self, unread: list[Message]) -> list[tuple[Floats, Floats]]:
        """The force that motion adds: nothing beside a force."""
        count = len(self._motions)
        if self._has_force and count:
            said = Message(
                "motion beside the force was left out ({count})", count=count
            )
            unread.append(said)
            return []
        if count:
            gain = float(np.mean(Mapping().gain_n_per_mps2))
            said = Message(
                "acceleration was taken times {gain:.2g} N per m/s²", gain=gain
            )
            self._notes[said] = None
        return self._motions

    def _matrix(self, element: Element) -> Floats:
        """Return a matrix of forces (n, 3) N."""
        name = "PassiveKinestheticForce"
        found = [child for child in element.iter() if name_of(child.tag) == name]
        for child in found[:1]:
            self._times.list_attributes(child, {"dim"})
        words = (found[0].text or "").split() if found else []
        sizes = [
            text.split()
            for child in found[:1]
            for key, text in child.items()
            if name_of(key) == "dim"
        ]
        self._spend(len(words) // 3)
        try:
            values = np.array([number_in(word) for word in words])
        except ValueError:
            values = np.array([math.nan])
        is_turned = bool(sizes) and sizes[0] != [str(len(values) // 3), "3"]
        if is_turned or len(values) % 3 or not np.isfinite(values).all():
            raise self._refusal(
                Message("a matrix of forces is not three numbers a row")
            )
        values = values.reshape(-1, 3)
        return np.repeat(values, 2, axis=0) if len(values) == 1 else values

    def _constant(self, element: Element) -> Floats:
        for child in element:
            if name_of(child.tag) == "ActiveKinesthetic":
                forces = {f"{what}{axis}" for what in "ft" for axis in "xyz"}
                self._times.list_attributes(child, forces)
                given = Attributes(child.attrib, self._where)
                force_n = [given.number(f"f{k}", 0.0, -1e6, 1e6) for k in "xyz"]
                if any(given.number(f"t{k}", 0.0, -1e6, 1e6) for k in "xyz"):
                    self._unread["torque"] += 1
                return np.array([force_n, force_n])
        return np.zeros((0, 3))

    def _moved(self, element: Element) -> Floats:
        """Return acceleration times the default gain; 0 degrees is to the front."""
        force_n = np.zeros((0, 3))
        for child in element:
            name = name_of(child.tag)
            if name != "MoveToward" or not child.get("acceleration") or len(force_n):
                self._unread[f"RigidBodyMotion, {name}"] += 1
                continue
            understood = {"acceleration", "directionH", "directionV"}
            self._times.list_attributes(child, understood)
            given = Attributes(child.attrib, self._where)
            size = given.number("acceleration", 0.0, -1e3, 1e3)
            flat, steep = (
                math.radians(given.number(f"direction{which}", 0.0, -1e3, 1e3))
                for which in "HV"
            )
            front, side = math.cos(steep) * math.cos(flat), math.sin(flat)
            way = np.array([math.cos(steep) * side, math.sin(steep), -front])
            gain = float(np.mean(Mapping().gain_n_per_mps2))
            force_n = np.tile(gain * size * way, (2, 1))
        return force_n

    def _vibration(self, effect: SemEffect) -> Floats:
        if not {"intensity", "intensity-value"} & effect.attributes.values.keys():
            self._unread["vibration without an intensity"] += 1
        if effect.is_beyond:
            self._notes[Message("intensities beyond their range were limited")] = None
        length_s = (effect.length_s or 0.0) + effect.release_s
        count = int(length_s * 1000.0) + 1
        self._spend(count)
        full_n = self._choices.take("full_scale_n")
        self._notes[
            Message(
                "vibration: full intensity was taken as {full_n:.3g} N", full_n=full_n
            )
        ] = None
        wave = np.sin(2.0 * np.pi * _VIBRATION_HZ * np.linspace(0.0, length_s, count))
        return np.asarray(
            full_n * effect.level * np.outer(wave, self._choices.take("direction"))
        )

    def _spend(self, rows: int) -> None:
        self._left -= rows
        if self._left < 0:
            raise self._refusal(Message("holds too many values"))

    def _refusal(self, what: Message) -> InputError:
        return InputError(what, where=self._where, remedy=ANOTHER)


def _faded(effect: SemEffect, force_n: Floats) -> tuple[Floats, Floats]:
    """Return times (n,) s from the begin of an effect, and its force with its fades."""
    length_s, fade_s = effect.length_s or 0.0, effect.fade_s
    whole_s = length_s + effect.release_s
    at_s = np.linspace(0.0, whole_s, len(force_n))
    if not fade_s and not effect.release_s:
        return at_s, force_n
    dense_s = np.union1d(at_s, np.clip([fade_s, length_s], 0.0, whole_s))
    level = np.ones(len(dense_s))
    if fade_s:
        level = np.interp(dense_s, [0.0, fade_s], [effect.rise_from, 1.0])
    if effect.release_s:
        level = level * np.interp(dense_s, [length_s, whole_s], [1.0, 0.0])
    lines = [np.interp(dense_s, at_s, axis) for axis in force_n.T]
    return dense_s, np.stack(lines, axis=1) * level[:, None]


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
