"""The analysis as one JSON object, in the shape that other programs rely on."""

import dataclasses
import importlib.metadata
import math
import platform
from collections.abc import Callable
from typing import Any

from hapticplayer import __version__
from hapticplayer.study.analysis.analysis import (
    Analysis,
    Choices,
    MeasureAnalysis,
    Pair,
)
from hapticplayer.study.analysis.scores import QOE
from hapticplayer.study.analysis.words import warnings_of

_LIBRARIES = ("numpy", "scipy", "statsmodels", "matplotlib")


def summary(analysis: Analysis) -> dict[str, Any]:
    """Return everything that was found; what is not defined is None.

    `qoe` has the feedbacks, `factors` the same for each factor; `friedman`, `shapiro`,
    `wilcoxon`, `nemenyi`, `conover`, `mann_whitney`, `structure` and `conditions` have
    the measures ("qoe" and the factors) first. A pair is called "first-second".
    """
    measures = analysis.measures

    def each(part: Callable[[MeasureAnalysis], Any]) -> dict[str, Any]:
        return {name: _plain(part(one)) for name, one in measures.items()}

    described = each(lambda one: one.feedbacks)
    return {
        "qoe": described.pop(QOE),
        "factors": described,
        "friedman": each(_friedman),
        "shapiro": each(lambda one: one.shapiro),
        "wilcoxon": each(lambda one: _by_pair(one, "wilcoxon")),
        "nemenyi": each(lambda one: _by_pair(one, "nemenyi")),
        "conover": each(lambda one: _by_pair(one, "conover")),
        "mann_whitney": each(lambda one: one.mann_whitney),
        "structure": each(lambda one: one.structure),
        "conditions": each(lambda one: one.conditions),
        "missing": missing(analysis),
        "warnings": warnings_of(analysis),
        "provenance": provenance(analysis.choices),
    }


def missing(analysis: Analysis) -> dict[str, Any]:
    """Return how many answers there are not, and who is left out of what."""
    scores = analysis.scores
    return {
        "participants": len(scores.participants),
        "answers_planned": int(scores.ratings.size),
        "answers_missing": scores.missing,
        "of_these_not_sound": scores.unsound,
        "replaced_by_repetition": scores.repeated,
        "used_before_unknown": [
            code for code in scores.participants if code not in scores.used_before
        ],
        "measures": {
            name: {
                "used": len(one.scores.participants),
                "dropped": list(one.scores.dropped),
                "reduced": {k: list(v) for k, v in one.scores.reduced.items()},
            }
            for name, one in analysis.measures.items()
        },
    }


def provenance(choices: Choices) -> dict[str, Any]:
    """Return what the numbers were made with; the same again gives the same numbers."""
    versions = {name: importlib.metadata.version(name) for name in _LIBRARIES}
    return {
        "program": f"hapticplayer {__version__}",
        "versions": {"python": platform.python_version(), **versions},
        "seed": choices.resampling.seed,
        "resamples": choices.resampling.count,
        "missing_answers": choices.missing.value,
        "with_unsound_trials": choices.with_unsound,
    }


def pair_name(pair: Pair) -> str:
    """Return what a pair of feedbacks is called."""
    return f"{pair.first}-{pair.second}"


def _by_pair(one: MeasureAnalysis, test: str) -> dict[str, Any]:
    return {pair_name(pair): getattr(pair, test) for pair in one.pairs}


def _friedman(one: MeasureAnalysis) -> dict[str, Any]:
    found = dataclasses.asdict(one.friedman)
    ranks = dict(zip(one.scores.feedbacks, one.friedman.mean_ranks, strict=False))
    return {**found, "mean_ranks": ranks}


def _plain(value: Any) -> Any:
    """Return JSON without NaN or infinity."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        value = dataclasses.asdict(value)
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
