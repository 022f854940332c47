"""Ratings while clips played, as `physio` of BIDS: one table of equal steps for each run."""

import gzip
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hapticplayer import storage
from hapticplayer.study.definition import LiveRating, RatingKind
from hapticplayer.study.live_ratings import RATE_HZ, RatingTrack
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import position_of

RECORDING = "rating"
MOST_GAP_S = 3600.0
"""Between two clips of a table; behind it another one begins."""
_MISSING = "n/a"
Attempt = tuple[RatingTrack, ...]
"""All ratings of one attempt at a trial."""


class PhysioTable(NamedTuple):
    """A table without a header, and what describes it."""

    begin_s: float
    lines: bytes
    sidecar: Mapping[str, Any]


def physio_tables(
    session: StoredSession, tracks: Sequence[RatingTrack]
) -> Iterator[PhysioTable]:
    """Yield the tables of what was rated in a session."""
    ratings = session.definition.while_watching
    for run in _runs(_in_turn(session, tracks)):
        begin_s = min(track.monotonic_s[0] for track in run[0])
        lines = [line for attempt in run for line in _lines(attempt, ratings, begin_s)]
        text = "".join(_each_step(lines, len(ratings)))
        yield PhysioTable(float(begin_s), text.encode(), _sidecar(session, ratings))


def write_physio(base: Path, table: PhysioTable) -> None:
    """Write a table and its side-car beside each other."""
    packed = gzip.compress(table.lines, mtime=0)  # the same bytes each time
    storage.write_private(base.with_name(f"{base.name}_physio.tsv.gz"), packed)
    text = storage.json_text(dict(table.sidecar))
    storage.write_private(base.with_name(f"{base.name}_physio.json"), text)


def _in_turn(
    session: StoredSession, tracks: Sequence[RatingTrack]
) -> Iterator[Attempt]:
    """The attempts at trials in the order in which they were begun."""
    known = [one for one in tracks if len(one.monotonic_s)]
    by_attempt = {
        key: tuple(found)
        for key, found in groupby(known, lambda one: (one.position, one.attempt))
    }
    for record in session.records.intact:
        if record.kind == "trial-begin":
            position = position_of(str(record.content.get("step"))) or 0
            found = by_attempt.pop((position, record.content.get("attempt", 0)), ())
            if found:
                yield found


def _runs(attempts: Iterator[Attempt]) -> Iterator[list[Attempt]]:
    """Attempts that one clock counted, without a long gap."""
    run: list[Attempt] = []
    until_s = 0.0
    for attempt in attempts:
        begin_s = min(track.monotonic_s[0] for track in attempt)
        if run and not until_s <= begin_s <= until_s + MOST_GAP_S:
            yield run
            run = []
        run.append(attempt)
        until_s = max(track.monotonic_s[-1] for track in attempt)
    if run:
        yield run


def _lines(
    attempt: Attempt, ratings: Sequence[LiveRating], begin_s: float
) -> Iterator[tuple[int, str]]:
    """Yield number and line of the steps of one attempt."""
    first = attempt[0]
    sampled = max(attempt, key=lambda one: len(one.monotonic_s))
    span_s = sampled.monotonic_s[[0, -1]] - begin_s
    from_step, to_step = np.ceil(span_s * RATE_HZ - 1e-6).astype(int).tolist()
    steps = np.arange(from_step, to_step + 1)
    time_s = begin_s + steps / RATE_HZ
    media_s = np.interp(time_s, sampled.monotonic_s, sampled.media_s)
    by_key = {track.rating.key: track for track in attempt}
    columns = [_held(by_key.get(one.key), time_s) for one in ratings]
    head = f"{first.position}\t{first.attempt}"
    for step, at_s, *values in zip(
        steps.tolist(), media_s.tolist(), *(c.tolist() for c in columns), strict=True
    ):
        cells = (_MISSING if math.isnan(v) else f"{v:.6g}" for v in values)
        yield step, f"{head}\t{at_s:.4f}\t" + "\t".join(cells) + "\n"


def _held(track: RatingTrack | None, time_s: NDArray[np.float64]) -> Any:
    """The last value at each time; NaN before there was one."""
    if track is None:
        return np.full(len(time_s), np.nan)
    is_given = ~np.isnan(track.value)
    given_s, value = track.monotonic_s[is_given], track.value[is_given]
    at = np.searchsorted(given_s, time_s + 1e-9, side="right") - 1
    if not len(value):
        return np.full(len(time_s), np.nan)
    return np.where(at >= 0, value[at], np.nan)


def _each_step(lines: Sequence[tuple[int, str]], ratings: int) -> Iterator[str]:
    """A line for each step, also between clips."""
    empty = "\t".join([_MISSING] * (len(_MEANINGS) + ratings)) + "\n"
    due = 0
    for step, line in lines:
        while due < step:
            yield empty
            due += 1
        if step == due:
            yield line
            due += 1


_MEANINGS = {
    "trial": "place in this participant's order, from 1; n/a between clips",
    "attempt": "from 1; more if the trial was repeated",
    "media": "position in the clip",
}


def _sidecar(session: StoredSession, ratings: Sequence[LiveRating]) -> dict[str, Any]:
    language = session.definition.languages[0]
    made: dict[str, Any] = {
        "SamplingFrequency": RATE_HZ,
        "StartTime": 0.0,
        "Columns": [*_MEANINGS, *(one.key for one in ratings)],
        **{name: {"Description": text} for name, text in _MEANINGS.items()},
    }
    made["media"]["Units"] = "s"
    for one in ratings:
        text = one.text[language]
        if one.kind is RatingKind.HELD_KEY:
            made[one.key] = {
                "Description": text,
                "Levels": {"0": "let go", "1": "held"},
            }
        else:
            limits = f"from {one.least} to {one.most}"
            what = f"{text} ({limits})"
            if one.kind is RatingKind.NUMBER:
                what += "; the last number that was given"
            made[one.key] = {"Description": what}
    return made
