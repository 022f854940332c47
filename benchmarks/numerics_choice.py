"""What cutting or resampling a recording changes, and how much of it the choice does.

A shorter recording moves the result for two reasons: it is chosen otherwise how soon an
acceleration is forgotten, and the sensor is calibrated from less. To tell them apart
each changed recording is processed twice, by its own choice and by that of the whole;
what lies between the two is the choice's. Recordings of one block only.
"""

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any
from unittest import mock

import numpy as np
from motion_document import Document
from numerics_invariance import gravity, part
from numpy.typing import NDArray
from recordings import TruthRecording

from hapticplayer.model import ImuLog, Sampling
from hapticplayer.motion.smoother import block, travel
from hapticplayer.motion.smoother.travel import Travel

Floats = NDArray[np.float64]
TRIMMED_S = 10.0
TRIMMED_SHARE = 0.2
RATES = (0.8, 1.5)
CHOICE_LIMIT_MPS2 = 0.03


@dataclass(slots=True, eq=False)
class Choice:
    """What the smoother chose for a recording.

    Attributes:
        time_s: of its nodes, from its start.
        bound_mps: of the velocity there.
        travel: how it was thought to get about.
    """

    time_s: Floats
    bound_mps: Floats
    travel: Travel = field(default_factory=Travel)


@contextlib.contextmanager
def recorded() -> Iterator[Choice]:
    """Note what the last solution of a recording was found with."""
    choice = Choice(np.zeros(1), np.ones(1))
    linearised, travel_of = block.linearised, travel.travel_of

    def noted(nodes: Any, *more: Any) -> Any:
        choice.time_s = np.append(0.0, np.cumsum(nodes.duration_s))
        choice.bound_mps = more[2].bound_mps
        return linearised(nodes, *more)

    def told(*arguments: Any) -> Travel:
        choice.travel = travel_of(*arguments)
        return choice.travel

    last = mock.patch.object(block, "linearised", noted)
    with last, mock.patch.object(travel, "travel_of", told):
        yield choice


@contextlib.contextmanager
def imposed(choice: Choice, start_s: float) -> Iterator[None]:
    """Take a choice that was made for a recording that started so much earlier."""

    def bound(_solution: Any, duration_s: Floats, *_: Any) -> Floats:
        time_s = start_s + np.append(0.0, np.cumsum(duration_s))
        logarithm = np.interp(time_s, choice.time_s, np.log(choice.bound_mps))
        return np.asarray(np.exp(logarithm))

    same = mock.patch.object(travel, "travel_of", return_value=choice.travel)
    with mock.patch.object(block, "velocity_bound", bound), same:
        yield


@dataclass(frozen=True, slots=True, eq=False)
class Changed:
    """A recording that was cut or resampled.

    Attributes:
        log: what is left of it.
        start_s: how much later it starts.
        expected: the gravity of the whole as this log should have it.
    """

    log: ImuLog
    start_s: float
    expected: Callable[[Floats], Floats]


Change = Callable[[ImuLog], Changed | None]
"""None where it would make no sense."""


def cut(first: float, last: float) -> Change:
    """Keep what lies between two shares of the samples; seconds where beyond 1."""

    def changed(log: ImuLog) -> Changed:
        span_s = float(log.time_s[-1] - log.time_s[0])

        def at(place: float) -> int:
            share = abs(place) / span_s if abs(place) > 1.0 else abs(place)
            return round((1.0 - share if place < 0.0 else share) * len(log))

        begin, end = at(first), at(last)
        start_s = float(log.time_s[begin] - log.time_s[0])
        return Changed(part(log, begin, end), start_s, lambda g: g[begin:end])

    return changed


def halved(log: ImuLog) -> Changed:
    """Average pairs of samples, as a sensor would that gives means at half the rate."""
    rate, force = log.angular_rate_radps, log.specific_force_mps2
    if log.sampling is Sampling.AVERAGED:
        count = len(log) // 2 * 2

        def pairs(values: Floats) -> Floats:
            return np.asarray(0.5 * (values[:count:2] + values[1:count:2]))

        means = _with(log, pairs(log.time_s), pairs(force), pairs(rate))
        return Changed(means, 0.0, pairs)
    count = (len(log) - 1) // 2 * 2 + 1

    def over(values: Floats, middle: float) -> Floats:
        ends = values[: count - 2 : 2] + values[2:count:2]
        return np.asarray(
            0.5 * (1.0 - middle) * ends + middle * values[1 : count - 1 : 2]
        )

    mean_rate = 0.5 * (rate[1 : count - 1 : 2] + rate[2:count:2])
    means = _with(log, log.time_s[1 : count - 1 : 2], over(force, 0.5), mean_rate)
    means = replace(means, sampling=Sampling.AVERAGED)
    # the mean of a curve over three samples, by Simpson's rule
    return Changed(means, 0.0, lambda g: over(g, 2.0 / 3.0))


def resampled(factor: float) -> Change:
    """Give it another rate by straight lines, the angular rate by its integral."""

    def changed(log: ImuLog) -> Changed | None:
        if log.sampling is Sampling.AVERAGED:
            return None
        count = int((len(log) - 1) * factor)
        time_s = np.linspace(log.time_s[0], log.time_s[-1], count + 1)

        def at(values: Floats) -> Floats:
            columns = [np.interp(time_s, log.time_s, row) for row in values.T]
            return np.stack(columns, axis=1)

        steps = np.diff(log.time_s, prepend=log.time_s[0])
        angle = at(np.cumsum(log.angular_rate_radps * steps[:, None], axis=0))
        rate = np.diff(angle, axis=0) / np.diff(time_s)[:, None]
        rate = np.concatenate([log.angular_rate_radps[:1], rate])
        return Changed(_with(log, time_s, at(log.specific_force_mps2), rate), 0.0, at)

    return changed


def _with(log: ImuLog, time_s: Floats, force: Floats, rate: Floats) -> ImuLog:
    return replace(
        log,
        time_s=time_s,
        specific_force_mps2=force,
        angular_rate_radps=rate,
        magnetic_field_ut=None,
    )


CHANGES: dict[str, Change] = {
    "first half": cut(0.0, 0.5),
    "second half": cut(0.5, 1.0),
    f"first {TRIMMED_S:g} s off": cut(TRIMMED_S, 1.0),
    f"last {TRIMMED_S:g} s off": cut(0.0, -TRIMMED_S),
    f"first {TRIMMED_SHARE:.0%} off": cut(TRIMMED_SHARE, 1.0),
    f"last {TRIMMED_SHARE:.0%} off": cut(0.0, -TRIMMED_SHARE),
    "half the rate": halved,
    **{f"{factor:g} x the rate": resampled(factor) for factor in RATES},
}


def difference(change: Change, logs: Sequence[ImuLog]) -> dict[str, float] | None:
    """Return the RMS over all samples of some logs, m/s^2.

    Returns:
        "moved" in all, "chosen" for what the choice does to it and "known" for what
        would be left with the choice of the whole; None where no log can be changed.
    """
    squares: dict[str, list[Floats]] = {"moved": [], "chosen": [], "known": []}
    for log in logs:
        one = change(log)
        if one is None:
            continue
        with recorded() as choice:
            whole = one.expected(gravity(log))
        own = gravity(one.log)
        with imposed(choice, one.start_s):
            other = gravity(one.log)
        for name, apart in (
            ("moved", own - whole),
            ("chosen", own - other),
            ("known", other - whole),
        ):
            squares[name].append(np.square(apart).sum(axis=1))
    if not squares["moved"]:
        return None
    return {
        name: float(np.sqrt(np.mean(np.concatenate(held))))
        for name, held in squares.items()
    }


def report(
    families: Sequence[tuple[str, Sequence[TruthRecording]]], document: Document
) -> dict[str, Any]:
    """Print and return by how much gravity changes, by family, and why."""
    figures: dict[str, dict[str, Any]] = {}
    for key, held in families:
        logs = [one.imu for one in held]
        found = {name: difference(change, logs) for name, change in CHANGES.items()}
        figures[key] = {name: one for name, one in found.items() if one is not None}
    for figure, title in (
        ("chosen", f"of that by the choice (limit {CHOICE_LIMIT_MPS2})"),
        ("moved", "in all"),
    ):
        rows = [
            [key, *(_cell(found.get(name), figure) for name in CHANGES)]
            for key, found in figures.items()
        ]
        document.table(
            f"cut {figure}",
            f"RMS change of the gravity when a recording is cut or resampled, {title}, "
            "m/s^2",
            ["recordings", *CHANGES],
            rows,
        )
    return figures


def _cell(found: dict[str, float] | None, figure: str) -> str:
    return "" if found is None else f"{found[figure]:.3f}"
