"""Simulated ratings while clips play, so that what is made of them can be tried.

Sliders follow the mismatch of the force as in `analysis.first_order`, whatever they ask;
numbers grow with the time of the clip; a key is held sooner and longer with more force.
"""

import json
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

from hapticplayer import storage
from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.first_order import low_pass
from hapticplayer.study.definition import Condition, LiveRating, RatingKind
from hapticplayer.study.drafts import clip_seconds
from hapticplayer.study.live_ratings import HEAD, RATE_HZ, rating_file, row_text
from hapticplayer.study.rating_rules import start_of
from hapticplayer.study.study_folder import Study
from hapticplayer.study.watched import COURSE_HZ, Forces, played_forces
from hapticplayer.study.watching import LIMIT

LAG_S, LATERAL = 1.5, 0.66
_GAIN = 0.4
"""Share of a slider's range for each newton."""
_UNKNOWN_N = {"realistic": 0.0, "random": 1.5, "none": 1.5}
"""Mismatch where the sequences are not known, by what a feedback is rated like."""
_SCATTER, _NOISE = 0.08, 0.04  # of people, and of the moment, as shares of the range
_SICK_EACH_MIN = 0.03  # share of a number's range that the median person adds
_ANSWER_S = 2.0
_ONSET_S = {"realistic": 8.0, "random": 16.0, "none": 30.0}
_HELD_S, _LET_GO_S = 10.0, 4.0


class _RatingRows(NamedTuple):
    """Rows of a rating; None where a number is asked for."""

    media_s: list[float]
    values: list[float | None]


class Raters:
    """Simulated people who rate the clips of a study.

    Args:
        study: opened.
        like: the paper's condition that each feedback is rated like.
        rng: of all people.
        notices: gets why there are no forces.
    """

    def __init__(
        self,
        study: Study,
        like: Mapping[str, str],
        rng: np.random.Generator,
        notices: list[str],
    ) -> None:
        self.ratings, self.like, self.rng = study.definition.while_watching, like, rng
        self._study, self._notices = study, notices

    @cached_property
    def clips_s(self) -> Mapping[str, float]:
        return clip_seconds(json.loads(self._study.content), self._study.folder)

    @cached_property
    def forces(self) -> Mapping[tuple[str, str], Forces]:
        return played_forces(self._study, self._notices)

    def person(self, begin_s: float) -> "SimulatedRater":
        return SimulatedRater(self, begin_s)


class SimulatedRater:
    """One of them, whose first clip begins at a monotonic time."""

    def __init__(self, raters: Raters, begin_s: float) -> None:
        self._raters, self._begin_s = raters, begin_s
        rng = raters.rng
        self._gain, self._haste = rng.lognormal(0.0, 0.3), rng.lognormal(0.0, 0.5)
        self._sickness = rng.lognormal(0.0, 0.8)
        self._offset = _SCATTER * rng.normal()

    def watch(
        self, folder: Path, position: int, condition: Condition
    ) -> tuple[str, ...]:
        """Write what is rated in a trial; why it is not valid."""
        until_s = self._raters.clips_s[condition.sequence]
        made = {
            one.key: self._rows(one, condition, until_s) for one in self._raters.ratings
        }
        limit = min(self._limits(made), default=None)
        if limit is not None:
            until_s = limit[0]
        for key, rows in made.items():
            lines = [
                row_text(self._begin_s + at_s, at_s, value)
                for at_s, value in zip(*rows, strict=True)
                if at_s <= until_s
            ]
            path = rating_file(folder, position, 1, key)
            storage.write_private(path, f"{HEAD}\n{''.join(lines)}".encode())
        self._begin_s += until_s + 1.0
        return () if limit is None else (f"{LIMIT}:{limit[1]}",)

    def _limits(self, made: Mapping[str, _RatingRows]) -> Iterator[tuple[float, str]]:
        """When the first limit of each rating is reached."""
        for one in self._raters.ratings:
            for at_s, value in zip(*made[one.key], strict=True):
                if None not in (one.stop_at, value) and value >= one.stop_at:  # type: ignore[operator]
                    yield at_s, one.key
                    break

    def _rows(
        self, one: LiveRating, condition: Condition, until_s: float
    ) -> _RatingRows:
        if one.kind is RatingKind.NUMBER:
            return self._numbers(one, until_s)
        time_s = np.arange(0.0, until_s, 1.0 / RATE_HZ)
        is_slider = one.kind is RatingKind.SLIDER
        values = (
            self._slider(one, condition, time_s)
            if is_slider
            else self._held(condition, time_s)
        )
        return _RatingRows(time_s.tolist(), values.tolist())

    def _slider(self, one: LiveRating, condition: Condition, time_s: Floats) -> Floats:
        """From where it starts towards its largest value, with the mismatch."""
        rng, steps_s = (
            self._raters.rng,
            np.arange(0.0, time_s[-1] + 0.2, 1.0 / COURSE_HZ),
        )
        of = self._raters.forces.get((condition.sequence, condition.feedback))
        if of is None:
            like = self._raters.like[condition.feedback]
            mismatch_n = np.full(len(steps_s), _UNKNOWN_N[like])
        else:
            apart_n = np.abs(of[1](steps_s) - of[0](steps_s))[:, [0, 2]]
            mismatch_n = apart_n @ np.array([LATERAL, 1.0 - LATERAL])
        noise = low_pass(rng.normal(size=len(steps_s)), 1.0) * _NOISE * 3.0
        share = _GAIN * self._gain * low_pass(mismatch_n, LAG_S) + self._offset + noise
        least, most = float(one.least or 0), float(one.most or 0)
        start = start_of(one)
        values = np.clip(start + (most - start) * share, least, most)
        return np.asarray(np.interp(time_s, steps_s, values))

    def _numbers(self, one: LiveRating, until_s: float) -> _RatingRows:
        least, most = one.least or 0, one.most or 0
        rows = _RatingRows([], [])
        for asked_s in np.arange(one.every_s or until_s, until_s, one.every_s).tolist():
            share = _SICK_EACH_MIN * self._sickness * asked_s / 60.0
            share += 0.02 * self._raters.rng.normal()
            value = float(np.clip(round(least + share * (most - least)), least, most))
            rows.media_s.extend((asked_s, min(until_s, asked_s + _ANSWER_S)))
            rows.values.extend((None, value))
        return rows

    def _held(self, condition: Condition, time_s: Floats) -> Floats:
        """Held from an onset on, with pauses; often never with little force."""
        rng = self._raters.rng
        like = self._raters.like[condition.feedback]
        at_s = self._haste * rng.exponential(_ONSET_S[like])
        held = np.zeros(len(time_s))
        while at_s < time_s[-1]:
            until_s = at_s + rng.exponential(_HELD_S)
            held[(time_s >= at_s) & (time_s < until_s)] = 1.0
            at_s = until_s + rng.exponential(_LET_GO_S)
        return held
