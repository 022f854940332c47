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
        parents: (f,) in the next level; None for the last one.
        to_parent: (f,) cross part with it over `own`.
    """

    own: Floats
    share: Floats
    parents: Indices | None = None
    to_parent: Floats | None = None


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
        levels: list[Level] = []
        for group in range(count):
            here, size = places.local(group), int(np.diff(places.firsts)[group])
            scale = deviations[group]
            own = 1.0 + scale**2 * np.bincount(here, bend, size)
            cross = np.zeros((size, left))
            for at, deviation in zip(others, deviations[count:], strict=True):
                cells = np.bincount(here * left + at, bend, size * left)
                cross += scale * deviation * cells.reshape(size, left)
            if levels:
                below = levels[-1]
                assert below.parents is not None
                assert below.to_parent is not None
                moved = below.to_parent * below.own
                own -= np.bincount(below.parents, moved * below.to_parent, size)
                cells = below.parents[:, None] * left + np.arange(left)
                parts = moved[:, None] * below.share
                counted = np.bincount(cells.ravel(), parts.ravel(), size * left)
                cross -= counted.reshape(size, left)
            share = cross / own[:, None]
            rest -= cross.T @ share
            if group + 1 == count:
                levels.append(Level(own, share))
                continue
            parents = np.zeros(size, np.intp)
            parents[here] = places.local(group + 1)
            coupled = scale * deviations[group + 1] * np.bincount(here, bend, size)
            levels.append(Level(own, share, parents, coupled / own))
        inverse = np.asarray(np.linalg.inv(rest), np.float64)
        return cls(tuple(levels), inverse, float(np.linalg.slogdet(rest)[1]))

    def solve(self, right: Floats) -> Floats:
        """The inverse times (q,)."""
        sizes = [len(one.own) for one in self.levels]
        *parts, others = np.split(right.copy(), np.cumsum(sizes))
        for number, one in enumerate(self.levels):
            others -= parts[number] @ one.share
            if one.parents is not None and one.to_parent is not None:
                moved = parts[number] * one.to_parent
                parts[number + 1] -= np.bincount(one.parents, moved, sizes[number + 1])
        others = self.inverse @ others
        found: list[Floats] = []
        for one, part in zip(self.levels[::-1], parts[::-1], strict=True):
            solved = part / one.own - one.share @ others
            if one.parents is not None and one.to_parent is not None:
                solved -= one.to_parent * found[0][one.parents]
            found.insert(0, solved)
        return np.concatenate([*found, others])

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
        for number, one in enumerate(self.levels):
            others -= parts[number][:, None] * one.share[here[number]]
            if one.to_parent is not None:
                parts[number + 1] -= parts[number] * one.to_parent[here[number]]
        others = others @ self.inverse
        found: list[Floats] = []
        for number in reversed(range(count)):
            one, at = self.levels[number], here[number]
            solved = parts[number] / one.own[at] - (one.share[at] * others).sum(axis=1)
            if one.to_parent is not None:
                solved -= one.to_parent[at] * found[0]
            found.insert(0, solved)
        return np.array(
            [*found, *(others[rows, at - start] for at in places.at[count:])]
        )
