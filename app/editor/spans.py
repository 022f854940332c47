"""Spans on a time line, without Qt: rows in which they do not cover each other."""

from collections.abc import Sequence

Span = tuple[float, float]
"""Begin and end, s."""


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
