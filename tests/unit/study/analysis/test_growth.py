"""The work of an analysis grows with the participants, not with their square."""

import tracemalloc
from dataclasses import dataclass

import numpy as np
import pytest

from hapticplayer.study.analysis import AnalysisOptions, Resampling, analyse
from hapticplayer.study.analysis.aligned_ranks import structure


class CountingGenerator:
    """Counts the random values that a generator returns."""

    def __init__(self, generator, counts):
        self._generator, self._counts = generator, counts

    def __getattr__(self, name):
        draw = getattr(self._generator, name)

        def counted(*values, **options):
            drawn = draw(*values, **options)
            self._counts.append(np.size(drawn))
            return drawn

        return counted


@dataclass(frozen=True)
class Counted(Resampling):
    counts: tuple[list, ...] = ([],)

    def generator(self, label):
        return CountingGenerator(super().generator(label), self.counts[0])


def resampled(answers) -> list[int]:
    counted = Counted(count=99, counts=([],))
    analyse(answers, AnalysisOptions(resampling=counted))
    return counted.counts[0]


@pytest.mark.usefixtures("without_models")
def test_random_values_grow_with_participants(make_answers):
    # 120 participants are too many to count all orders: both sizes draw them
    fewer, more = (resampled(make_answers(5, people)) for people in (120, 480))
    assert sum(fewer) > 99 * 120
    assert sum(more) < 4.4 * sum(fewer)


def test_resamples_are_drawn_in_blocks():
    values = np.arange(100_000.0)
    counted = Counted(count=99, counts=([],))
    low, high = counted.mean_interval(values, "label")
    assert low < values.mean() < high
    assert sum(counted.counts[0]) == 99 * len(values)
    assert max(counted.counts[0]) <= 1 << 18


def test_memory_of_the_variance_grows_with_participants():
    def peak(people: int) -> int:
        values = np.random.default_rng(people).integers(1, 6, (people, 4, 3))
        codes = tuple(map(str, range(people)))
        structure(values[:5].astype(float), codes[:5])  # imports
        tracemalloc.start()
        structure(values.astype(float), codes)
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return found

    assert peak(800) < 5.0 * peak(200)


@pytest.mark.usefixtures("without_models")
@pytest.mark.parametrize(("people", "methods"), [(12, "exact"), (260, "normal")])
def test_large_studies_say_how_p_was_found(make_answers, quick, people, methods):
    found = analyse(make_answers(5, people), AnalysisOptions(resampling=quick)).found
    orders = {"exact": "exact", "normal": "permutation, 99"}[methods]
    assert found["friedman"]["qoe"]["p_exact_method"] == orders
    for test in ("wilcoxon", "mann_whitney"):
        assert {one["p_method"] for one in found[test]["qoe"].values()} == {methods}
