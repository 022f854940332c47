"""Crossed and nested random intercepts: the curvature of a likelihood by them, solved.

It is diagonal among the members of a nested group, such as people with each feedback, so
that the work grows with the number of people, not its cube.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model.arrays import Floats

Indices = NDArray[np.intp]


class Places(NamedTuple):
    """Of each answer's random intercepts among all q of them, with their deviations.

    Attributes:
        at: (n,) for each group.
        deviations: of the groups.
        firsts: place of the first of each group, and q.
        nested: number of the groups that are diagonal, each within the next.
    """

    at: tuple[Indices, ...]
    deviations: Floats
    firsts: Indices
    nested: int

    @classmethod
    def of(cls, groups: tuple[Indices, ...], nested: int) -> "Places":
        sizes = [int(group.max()) + 1 for group in groups]
        firsts = np.cumsum([0, *sizes])
        at = tuple(group + first for group, first in zip(groups, firsts, strict=False))
        return cls(at, np.zeros(len(at)), firsts, nested)

    @property
    def size(self) -> int:
        return int(self.firsts[-1])

    def local(self, group: int) -> Indices:
        """Of each answer in a group, from 0."""
        return np.asarray(self.at[group] - self.firsts[group], np.intp)

    def values(self, u: Floats) -> Floats:
        """The shift (n,) of each answer."""
        return np.asarray(self.deviations @ np.stack([u[at] for at in self.at]))

    def sums(self, values: Floats) -> Floats:
        """The transpose of `values`: (q,) from (n,)."""
        total = np.zeros(self.size)
        for at, deviation in zip(self.at, self.deviations, strict=True):
            total += deviation * np.bincount(at, values, self.size)
        return total


class Level(NamedTuple):
    """A group that was eliminated: nothing couples two of its members.

    Attributes:
        own: (f,) diagonal.
        share: (f, r) cross part with the groups that are left, over it.
        above: for each nested group after it the places (f,) of its members there, and
            the cross part with them over `own`.
    """

    own: Floats
    share: Floats
    above: tuple[tuple[Indices, Floats], ...]


class Curvature(NamedTuple):
    """The negative Hessian by the intercepts, solved by Schur's complement.

    Attributes:
        levels: of the nested groups.
        inverse: (r, r) of the complement.
        size: its log determinant.
    """

    levels: tuple[Level, ...]
    inverse: Floats
    size: float

    @classmethod
    def of(cls, places: Places, bend: Floats) -> "Curvature":
        count, deviations = places.nested, places.deviations
        start = places.firsts[count]
        left = places.size - int(start)
        others = [at - start for at in places.at[count:]]
        rest = np.eye(left)
        for at, deviation in zip(others, deviations[count:], strict=True):
            for other, by in zip(others, deviations[count:], strict=True):
                pairs = np.bincount(at * left + other, bend, left**2)
                rest += deviation * by * pairs.reshape(left, left)
        here = [places.local(group) for group in range(count)]
        sizes = np.diff(places.firsts)[:count].tolist()
        own: list[Floats] = []
        cross: list[Floats] = []
        coupled: dict[tuple[int, int], Floats] = {}
        for group, (at_here, size) in enumerate(zip(here, sizes, strict=True)):
            total = deviations[group] * np.bincount(at_here, bend, size)
            own.append(1.0 + deviations[group] * total)
            cross.append(np.zeros((size, left)))
            for at, deviation in zip(others, deviations[count:], strict=True):
                cells = np.bincount(at_here * left + at, bend, size * left)
                cross[group] += (
                    deviations[group] * deviation * cells.reshape(size, left)
                )
            for later in range(group + 1, count):
                coupled[group, later] = deviations[later] * total
        levels: list[Level] = []
        for group in range(count):
            share, above = cross[group] / own[group][:, None], []
            for later in range(group + 1, count):
                up = np.zeros(sizes[group], np.intp)
                up[here[group]] = here[later]
                whole = coupled[group, later]
                part = whole / own[group]
                above.append((up, part))
                own[later] -= np.bincount(up, part * whole, sizes[later])
                cells = up[:, None] * left + np.arange(left)
                moved = np.ravel(whole[:, None] * share)
                counted = np.bincount(cells.ravel(), moved, sizes[later] * left)
                cross[later] -= counted.reshape(sizes[later], left)
                for last in range(later + 1, count):
                    moved = part * coupled[group, last]
                    coupled[later, last] -= np.bincount(up, moved, sizes[later])
            rest -= cross[group].T @ share
            levels.append(Level(own[group], share, tuple(above)))
        inverse = np.asarray(np.linalg.inv(rest), np.float64)
        return cls(tuple(levels), inverse, float(np.linalg.slogdet(rest)[1]))

    def solve(self, right: Floats) -> Floats:
        """The inverse times (q,)."""
        sizes = [len(one.own) for one in self.levels]
        *parts, others = np.split(right.copy(), np.cumsum(sizes))
        for group, one in enumerate(self.levels):
            others -= parts[group] @ one.share
            for later, (up, part) in enumerate(one.above, group + 1):
                parts[later] -= np.bincount(up, parts[group] * part, sizes[later])
        others = self.inverse @ others
        for group in reversed(range(len(parts))):
            one = self.levels[group]
            parts[group] = parts[group] / one.own - one.share @ others
            for later, (up, part) in enumerate(one.above, group + 1):
                parts[group] -= part * parts[later][up]
        return np.concatenate([*parts, others])

    def log_determinant(self) -> float:
        return float(sum(np.log(one.own).sum() for one in self.levels) + self.size)

    def of_answers(self, places: Places) -> Floats:
        """The inverse times each answer's scaled row, at its own places: (K, n)."""
        count, deviations = places.nested, places.deviations
        start, people = places.firsts[count], len(places.at[0])
        others = np.zeros((people, len(self.inverse)))
        rows = np.arange(people)
        for at, deviation in zip(places.at[count:], deviations[count:], strict=True):
            others[rows, at - start] += deviation
        parts = [np.full(people, deviation) for deviation in deviations[:count]]
        here = [places.local(group) for group in range(count)]
        for group, one in enumerate(self.levels):
            others -= parts[group][:, None] * one.share[here[group]]
            for later, (_, part) in enumerate(one.above, group + 1):
                parts[later] -= parts[group] * part[here[group]]
        others = others @ self.inverse
        for group in reversed(range(count)):
            one, at = self.levels[group], here[group]
            parts[group] = parts[group] / one.own[at]
            parts[group] -= (one.share[at] * others).sum(axis=1)
            for later, (_, part) in enumerate(one.above, group + 1):
                parts[group] -= part[at] * parts[later]
        return np.array(
            [*parts, *(others[rows, at - start] for at in places.at[count:])]
        )
