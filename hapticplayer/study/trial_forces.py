"""Measured force per trial of a session, from its records."""

from collections.abc import Iterator, Mapping
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.haptics.limiter import Limits, limits_of
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import AnsweredTrial, answered_trials
from hapticplayer.study.ticks import tick_chunks, tick_files
from hapticplayer.study.trial_force import FIELDS, TrialForce, measure_trial_force

TrialKey = tuple[int, int]
"""Position and attempt."""

_LONGEST_TRIAL_S = 3600.0
"""What is held in memory at once: 0.6 GB."""


def measure_trial_forces(
    session: StoredSession, notices: list[str]
) -> dict[TrialKey, TrialForce]:
    """The measured force per answered trial that has a record.

    Args:
        session: with its records; sessions without any have no entries.
        notices: list to which damaged records are added.
    """
    found: dict[TrialKey, TrialForce] = {}
    trials = list(answered_trials(session.records))
    for path in tick_files(session):
        mine = [one for one in trials if _record(one) == path.name]
        for trial, ticks in _trial_ticks(path, mine, notices):
            limits = _limits(trial.playback)
            made = measure_trial_force(
                ticks, float(trial.playback["duration_s"]), limits
            )
            if made is not None:
                found[trial.position, trial.attempt] = made
    return found


def _trial_ticks(
    path: Path, trials: list[AnsweredTrial], notices: list[str]
) -> Iterator[tuple[AnsweredTrial, NDArray[Any]]]:
    """Yield each trial with its ticks, holding those of one trial at a time."""
    spans = sorted(
        (span, number)
        for number, one in enumerate(trials)
        if (span := _span_s(one.playback)) is not None
    )
    if not spans:
        return
    parts: list[NDArray[Any]] = []
    chunks: Iterator[NDArray[Any] | None] = tick_chunks(path, notices)
    for chunk in chain(chunks, [None]):
        while spans:
            (begun_s, ended_s), number = spans[0]
            if chunk is not None:
                if not len(chunk) or not set(FIELDS) <= set(chunk.dtype.names or ()):
                    break
                time_s = chunk["monotonic_s"]
                parts.append(chunk[(time_s >= begun_s) & (time_s <= ended_s)])
                if time_s[-1] <= ended_s:
                    break
            spans.pop(0)
            if parts:
                yield trials[number], np.concatenate(parts)
            parts = []


def _record(trial: AnsweredTrial) -> object:
    return trial.playback.get("record") if isinstance(trial.playback, dict) else None


def _span_s(playback: Mapping[str, Any]) -> tuple[float, float] | None:
    """Return begin and end, monotonic; None where records were edited."""
    values = [playback.get(n) for n in ("begun_mono_s", "ended_mono_s", "duration_s")]
    if not all(isinstance(one, int | float) for one in values):
        return None
    begun_s, ended_s, _ = map(float, values)  # type: ignore[arg-type]
    return (begun_s, ended_s) if 0.0 < ended_s - begun_s < _LONGEST_TRIAL_S else None


def _limits(playback: Mapping[str, Any]) -> Limits:
    outputs = playback.get("outputs")
    leading = str(outputs[0]) if isinstance(outputs, list) and outputs else ""
    try:
        return limits_of(find_device(leading).capabilities)
    except DeviceError:  # of a package that this machine lacks
        return Limits()
