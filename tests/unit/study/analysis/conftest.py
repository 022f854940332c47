"""Seeded answers with ties and holes, as people give them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import pytest

from hapticplayer.study.analysis import Resampling
from hapticplayer.study.analysis.analysis import STATISTICS
from hapticplayer.study.answers import Answers, Participant, Rating

QUICK = Resampling(seed=7, count=99)
FACTORS = ("realism", "sensory", "comfort", "satisfaction")


def random_answers(
    seed: int,
    people: int = 12,
    *,
    sequences: int = 4,
    feedbacks: tuple[str, ...] = ("realistic", "none", "random"),
    holes: float = 0.0,
) -> Answers:
    """Return ratings that grow with the feedback's place, some of them missing."""
    rng = np.random.default_rng(seed)
    persons = tuple(
        Participant(
            f"P{i:02}",
            30,
            None,
            "right",
            [True, False, None][rng.choice(3, p=[0.4, 0.5, 0.1])],
        )
        for i in range(people)
    )
    names = tuple(f"clip-{i}" for i in range(sequences))
    step = rng.uniform(0.0, 0.8)
    ratings = tuple(
        Rating(
            person.code,
            sequence,
            feedback,
            factor,
            None
            if rng.random() < holes
            else int(np.clip(rng.normal(2.0 + step * place, 1.2), 1, 5)),
            True,
        )
        for person in persons
        for sequence in names
        for place, feedback in enumerate(feedbacks)
        for factor in FACTORS
    )
    return Answers(persons, ratings, names, feedbacks, FACTORS)


@pytest.fixture(scope="session")
def make_answers() -> Callable[..., Answers]:
    return random_answers


@pytest.fixture(scope="session")
def quick() -> Resampling:
    return QUICK


@contextmanager
def models_left_out() -> Iterator[None]:
    """The mixed models take seconds, draw nothing, and are asked for elsewhere."""
    known = dict(STATISTICS)
    for name in ("ordinal_logit", "ordinal_probit"):
        del STATISTICS[name]
    try:
        yield
    finally:
        STATISTICS.clear()  # their order is that of a report
        STATISTICS.update(known)


@pytest.fixture
def without_models() -> Iterator[None]:
    with models_left_out():
        yield
