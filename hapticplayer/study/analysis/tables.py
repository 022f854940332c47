"""The numbers of an analysis of ratings as rows."""

from collections.abc import Iterator
from typing import Any

from hapticplayer.study.analysis.analysis import Analysis

_TESTS = ("friedman", "shapiro", "wilcoxon", "nemenyi", "conover", "mann_whitney")


def tables(
    analysis: Analysis, numbers: dict[str, Any]
) -> dict[str, Iterator[list[Any]]]:
    """Return the rows of the CSV files by name.

    Args:
        analysis: that was made.
        numbers: its summary.
    """
    return {
        "conditions.csv": _condition_rows(numbers),
        "tests.csv": _test_rows(numbers),
        "scores.csv": _score_rows(analysis),
    }


def _condition_rows(numbers: dict[str, Any]) -> Iterator[list[Any]]:
    names = list(next(iter(numbers["qoe"].values())))
    yield ["measure", "sequence", "feedback", *names]
    for measure, by_feedback in {"qoe": numbers["qoe"], **numbers["factors"]}.items():
        for feedback, one in by_feedback.items():
            yield [measure, "all", feedback, *one.values()]
        for sequence, conditions in numbers["conditions"][measure].items():
            for feedback, one in conditions.items():
                yield [measure, sequence, feedback, *one.values()]


def _test_rows(numbers: dict[str, Any]) -> Iterator[list[Any]]:
    yield ["test", "measure", "of", "statistic", "value"]
    for test in _TESTS:
        for measure, found in numbers[test].items():
            parts = {"": found} if test == "friedman" else found
            for name, one in parts.items():
                for statistic, value in _flat(one):
                    yield [test, measure, name, statistic, value]
    for measure, found in numbers["structure"].items():
        for name, one in (found or {"effects": {}})["effects"].items():
            for statistic, value in _flat(one):
                yield ["aligned_ranks", measure, name, statistic, value]


def _flat(one: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in one.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{name}", part) for name, part in value.items())
        elif isinstance(value, list):
            yield from ((f"{key}.{place}", part) for place, part in enumerate(value))
        else:
            yield key, value


def _score_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["participant", "measure", "feedback", "mean_over_sequences"]
    for measure, one in analysis.measures.items():
        for code, row in zip(one.scores.participants, one.scores.values, strict=True):
            for feedback, value in zip(one.scores.feedbacks, row.tolist(), strict=True):
                yield [code, measure, feedback, value]
