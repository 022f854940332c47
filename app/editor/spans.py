"""Spans on a timeline, without Qt: rows, what the pointer is on, and snapping."""

import enum
from collections.abc import Iterable, Sequence
from typing import NamedTuple

Span = tuple[float, float]
"""Begin and end."""


def rows_of(spans: Sequence[Span]) -> list[int]:
    """Return a row for each span, the first that is free at its time."""
    free_s: list[float] = []  # from when on each row is free
    rows = [0] * len(spans)
    for k in sorted(range(len(spans)), key=lambda k: spans[k]):
        begin_s, end_s = spans[k]
        row = next((r for r, at_s in enumerate(free_s) if at_s <= begin_s), len(free_s))
        if row == len(free_s):
            free_s.append(end_s)
        free_s[row] = end_s
        rows[k] = row
    return rows


class Part(enum.Enum):
    """What of a span is held."""

    START = enum.auto()
    BODY = enum.auto()
    END = enum.auto()
    FADE_IN = enum.auto()
    FADE_OUT = enum.auto()
    POINT = enum.auto()


class Hit(NamedTuple):
    """What the pointer is on."""

    number: int
    part: Part


def hit(spans: Sequence[Span | None], x: float, edge: float) -> Hit | None:
    """Return the span at a place; of several the last, which lies on top.

    Args:
        spans: in the unit of x; None is not there.
        x: of the pointer.
        edge: how far an end reaches to both sides; at most a third of the span
            inwards, so that short spans can be moved, too.
    """
    for number in reversed(range(len(spans))):
        span = spans[number]
        if span is None:
            continue
        begin, end = span
        inwards = min(edge, (end - begin) / 3.0)
        if begin - edge <= x < begin + inwards:
            return Hit(number, Part.START)
        if end - inwards < x <= end + edge:
            return Hit(number, Part.END)
        if begin <= x <= end:
            return Hit(number, Part.BODY)
    return None


class Snap(NamedTuple):
    """What a time is drawn to: marks that are near, else the next frame.

    Attributes:
        marks_s: of events and other effects.
        tolerance_s: how near a mark is.
        frame_s: length of a frame.
    """

    marks_s: tuple[float, ...]
    tolerance_s: float
    frame_s: float

    def at(self, time_s: float) -> float:
        near_s = self._near(time_s)
        return self._frame(time_s) if near_s is None else near_s

    def shift(self, span_s: Span, by_s: float) -> float:
        """Return by how much a span is moved: one of its ends is drawn to a mark.

        Without one that is near, its begin is drawn to the next frame.
        """
        moved = [end_s + by_s for end_s in span_s]
        shifts = [
            near_s - end_s
            for end_s, near_s in zip(moved, map(self._near, moved), strict=True)
            if near_s is not None
        ]
        if shifts:
            return by_s + min(shifts, key=abs)
        return by_s + self._frame(moved[0]) - moved[0]

    def _near(self, time_s: float) -> float | None:
        nearest_s = min(self.marks_s, key=lambda m: abs(m - time_s), default=None)
        if nearest_s is None or abs(nearest_s - time_s) > self.tolerance_s:
            return None
        return nearest_s

    def _frame(self, time_s: float) -> float:
        return round(time_s / self.frame_s) * self.frame_s


def marks_of(*groups: Iterable[Span]) -> tuple[float, ...]:
    """Return the ends of all spans, each once."""
    return tuple(sorted({end for spans in groups for span in spans for end in span}))
