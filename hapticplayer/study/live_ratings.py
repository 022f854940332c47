"""Ratings while a clip plays: their files, and what follows from them.

A session has a file `ratings-TRIAL-ATTEMPT-KEY.csv` for each rating of each trial.
"""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message, joined
from hapticplayer.study.definition import Condition, LiveRating, RatingKind, read_file
from hapticplayer.study.session_folder import StoredSession

RATE_HZ = 50.0
"""Of what is moved or held."""
HEAD = "monotonic_s,media_s,value"
MAX_BYTES = 64 << 20
_NAME = re.compile(r"ratings-([0-9]{2,6})-([0-9]{1,5})-([a-z0-9_-]{1,40})\.csv")
_MOST = 1e9


# --- the files ----------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class RatingTrack:
    """What somebody rated in one trial, over time.

    Attributes:
        rating: of the definition.
        position: of the trial in the participant's order, from 1.
        attempt: from 1; more if the trial was repeated.
        condition: of the trial.
        monotonic_s: of the machine's clock (N,).
        media_s: of the clip (N,).
        value: of the slider or number; 1 while a key is held, else 0; NaN where a number
            was asked for (N,).
    """

    rating: LiveRating
    position: int
    attempt: int
    condition: Condition
    monotonic_s: NDArray[np.float64]
    media_s: NDArray[np.float64]
    value: NDArray[np.float64]


def rating_file(folder: Path, position: int, attempt: int, key: str) -> Path:
    return folder / f"ratings-{position:02d}-{attempt}-{key}.csv"


def read_ratings(session: StoredSession, notices: list[str]) -> list[RatingTrack]:
    """The ratings of a session by trial and attempt; what is damaged adds to notices."""
    ratings = {one.key: one for one in session.definition.while_watching}
    order, found = session.plan.order, []
    for path in sorted(session.folder.glob("ratings-*.csv")):
        where = f"{session.code}/{path.name}"
        named = _NAME.fullmatch(path.name)
        position = int(named[1]) if named else 0
        if not named or named[3] not in ratings or not 1 <= position <= len(order):
            notices.append(Message("{file}: is not of this session", file=where))
            continue
        try:
            rows, damaged = _rows(read_file(path, MAX_BYTES))
        except InputError as problem:
            notices.append(joined(": ", (where, problem.what)))
            continue
        if damaged:
            what = Message("{count} rows are damaged", count=damaged)
            notices.append(joined(": ", (where, what)))
        of = ratings[named[3]], position, int(named[2]), order[position - 1]
        found.append(RatingTrack(*of, *rows))
    return sorted(found, key=lambda one: (one.position, one.attempt))


def _rows(content: bytes) -> tuple[NDArray[np.float64], int]:
    """The columns of a file, and how many rows are damaged; the last one may be torn."""
    head, *lines = content.decode(errors="replace").split("\n")
    if lines:
        lines.pop()  # empty, or of an interrupted write
    begin = (-math.inf, math.nan, math.nan)
    rows = [begin, begin]
    for line in lines:
        if (row := _row(line)) is None:
            continue
        if row[0] < rows[-1][0] and row[0] >= rows[-2][0]:
            rows.pop()  # its time was damaged: the file goes on before it
        if row[0] >= rows[-1][0]:
            rows.append(row)
    del rows[:2]
    columns = np.array(rows, np.float64).reshape(-1, 3).T
    return columns, len(lines) - len(rows) + (bool(lines) and head != HEAD)


def _row(line: str) -> tuple[float, float, float] | None:
    try:
        time_s, media_s, value = (
            float(cell) if cell else math.nan for cell in line.split(",")
        )
    except ValueError:
        return None
    is_known = all(abs(one) < _MOST for one in (time_s, media_s))
    is_value = math.isnan(value) or abs(value) < _MOST
    return (time_s, media_s, value) if is_known and is_value else None


def row_text(monotonic_s: float, media_s: float, value: float | None) -> str:
    """A line of a file; None where a number is asked for."""
    shown = "" if value is None else f"{value:.6g}"
    return f"{monotonic_s:.6f},{media_s:.6f},{shown}\n"


# --- figures ------------------------------------------------------------------

Figure = Callable[[RatingTrack], float | None]


def mean(track: RatingTrack) -> float | None:
    """Of a slider over the time of the clip; of numbers their mean."""
    value, media_s = track.value, track.media_s
    if track.rating.kind is RatingKind.NUMBER:
        value = value[~np.isnan(value)]
        return float(value.mean()) if len(value) else None
    lasted_s = np.diff(media_s)
    if not len(lasted_s) or media_s[-1] <= media_s[0]:
        return None
    return float((value[:-1] * lasted_s).sum() / (media_s[-1] - media_s[0]))


def largest(track: RatingTrack) -> float | None:
    given = track.value[~np.isnan(track.value)]
    return float(given.max()) if len(given) else None


def last(track: RatingTrack) -> float | None:
    given = track.value[~np.isnan(track.value)]
    return float(given[-1]) if len(given) else None


def onset_s(track: RatingTrack) -> float | None:
    """Media time at which a key was held first; None if it never was."""
    held = np.flatnonzero(track.value > 0.0)
    return float(track.media_s[held[0]]) if len(held) else None


def held_s(track: RatingTrack) -> float:
    """Time in which a key was held."""
    return float((track.value[:-1] * np.diff(track.media_s)).sum())


FIGURES: dict[RatingKind, dict[str, tuple[Figure, str, str]]] = {
    RatingKind.SLIDER: {
        "mean": (mean, "mean over the clip", ""),
        "most": (largest, "largest", ""),
        "last": (last, "at the end of the clip", ""),
    },
    RatingKind.NUMBER: {
        "mean": (mean, "mean of the numbers", ""),
        "most": (largest, "largest", ""),
        "last": (last, "the last one", ""),
    },
    RatingKind.HELD_KEY: {
        "onset_s": (onset_s, "media time of the first press; empty if none", "s"),
        "held_s": (held_s, "time in which the key was held", "s"),
        "share": (mean, "share of the time in which the key was held", "0 to 1"),
    },
}
"""What follows from a rating of a trial: function, meaning and unit, by name."""
