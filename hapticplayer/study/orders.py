"""Orders of conditions: random, Latin squares, Williams designs, lists (no I/O).

Sources: Williams, E. J. (1949), Experimental designs balanced for the estimation of
residual effects of treatments, Aust. J. Sci. Res. A 2, 149-168; Danieau et al. 2012
for a random order per participant.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import StudyError
from hapticplayer.study.definition import Condition, Definition, OrderMethod
from hapticplayer.study.plan import number_of

Row = tuple[int, ...]
MAX_TRIES = 20_000
ORDERS = "orders.csv"
"""The file of orders by `OrderMethod.LIST`."""
_SQUARE, _PARTICIPANT, _LABELS = 1, 2, 3  # independent streams of one seed


@dataclass(frozen=True, slots=True)
class Assignment:
    """One participant's order.

    Attributes:
        conditions: in order of playback.
        labels: feedbacks in the order of their names "Feedback 1", "Feedback 2", ...
        method: of the order.
        row: of the square or the list; None for random orders.
        seed: of the study; seed and code reproduce the order.
    """

    conditions: tuple[Condition, ...]
    labels: tuple[str, ...]
    method: OrderMethod
    row: int | None
    seed: int


@dataclass(frozen=True, slots=True)
class Balance:
    """Balance of the orders so far.

    Attributes:
        at_position: (conditions, positions), count at each position.
        followed: (conditions, conditions), how often the second followed the first.
    """

    at_position: NDArray[np.int64]
    followed: NDArray[np.int64]

    def times_at_each_position(self) -> tuple[int, int]:
        """Return the smallest and largest count of a condition at a position."""
        return int(self.at_position.min()), int(self.at_position.max())

    def times_after_each_other(self) -> tuple[int, int]:
        """Return the smallest and largest count of a condition after another one."""
        pairs = self.followed[~np.eye(len(self.followed), dtype=bool)]
        if not len(pairs):
            return 0, 0
        return int(pairs.min()), int(pairs.max())


def cyclic_square(count: int) -> tuple[Row, ...]:
    """Return a Latin square: row r is 0, 1, 2, ... shifted by r."""
    return tuple(tuple((r + c) % count for c in range(count)) for r in range(count))


def williams_design(count: int) -> tuple[Row, ...]:
    """Return orders in which each condition follows each other equally often.

    An even number of conditions needs as many orders (each pair once), an odd number
    twice as many (each pair twice).
    """
    first = [
        (step + 1) // 2 if step % 2 else (count - step // 2) % count
        for step in range(count)
    ]
    rows = [tuple((r + c) % count for c in first) for r in range(count)]
    return tuple(rows if count % 2 == 0 else [*rows, *(row[::-1] for row in rows)])


def rows_of(definition: Definition) -> tuple[tuple[Condition, ...], ...]:
    """Return the orders of a square whose symbols are assigned at random."""
    conditions, order = definition.conditions, definition.order
    rng = np.random.default_rng([order.seed, _SQUARE])
    if order.method is OrderMethod.WILLIAMS:
        design = williams_design(len(conditions))
        shuffled = _shuffled(conditions, rng)
    else:
        design = cyclic_square(len(conditions))
        is_apart = order.no_sequence_twice_in_a_row
        shuffled = _shuffled_apart(conditions, rng, apart=is_apart, in_circle=True)
    return tuple(tuple(shuffled[symbol] for symbol in row) for row in design)


def random_order(definition: Definition, code: str) -> tuple[Condition, ...]:
    """Return a random order from seed and code; all allowed orders are equally likely."""
    order = definition.order
    rng = np.random.default_rng([order.seed, _PARTICIPANT, number_of(code)])
    is_apart = order.no_sequence_twice_in_a_row
    return _shuffled_apart(definition.conditions, rng, apart=is_apart, in_circle=False)


def labels_of(definition: Definition, code: str) -> tuple[str, ...]:
    """Return the feedbacks in the order of their numbers for this participant."""
    rng = np.random.default_rng([definition.order.seed, _LABELS, number_of(code)])
    return tuple(
        definition.feedback_keys[i] for i in rng.permutation(len(definition.feedbacks))
    )


def assign(
    definition: Definition,
    code: str,
    used_rows: Sequence[int | None],
    listed: Sequence[tuple[Condition, ...]] = (),
) -> Assignment:
    """Return the order of a new participant.

    Args:
        definition: of the study.
        code: of the participant.
        used_rows: of all sessions except those that were dropped, whose rows are
            assigned again.
        listed: the orders of `orders.csv`, for OrderMethod.LIST.
    """
    order = definition.order
    labels = labels_of(definition, code)
    if order.method is OrderMethod.RANDOM:
        conditions = random_order(definition, code)
        return Assignment(conditions, labels, order.method, None, order.seed)
    rows = listed if order.method is OrderMethod.LIST else rows_of(definition)
    if not rows:
        raise StudyError("the list of orders is empty", remedy="add orders.csv")
    uses = [sum(used == row for used in used_rows) for row in range(len(rows))]
    row = uses.index(min(uses))
    return Assignment(tuple(rows[row]), labels, order.method, row, order.seed)


def balance_of(
    definition: Definition, orders: Sequence[Sequence[Condition]]
) -> Balance:
    index = {condition: i for i, condition in enumerate(definition.conditions)}
    count = len(index)
    at_position = np.zeros((count, count), dtype=np.int64)
    followed = np.zeros((count, count), dtype=np.int64)
    for order in orders:
        places = [index[c] for c in order if c in index]
        np.add.at(at_position, (places, range(len(places))), 1)
        np.add.at(followed, (places[:-1], places[1:]), 1)
    return Balance(at_position, followed)


def _shuffled(
    conditions: Sequence[Condition], rng: np.random.Generator
) -> tuple[Condition, ...]:
    return tuple(conditions[i] for i in rng.permutation(len(conditions)))


def _shuffled_apart(
    conditions: Sequence[Condition],
    rng: np.random.Generator,
    *,
    apart: bool,
    in_circle: bool,
) -> tuple[Condition, ...]:
    """Shuffle until no sequence follows itself; allowed orders are equally likely."""
    for _ in range(MAX_TRIES):
        shuffled = _shuffled(conditions, rng)
        if not apart or first_repeat(shuffled, in_circle=in_circle) is None:
            return shuffled
    raise StudyError(
        "found no order in which no sequence is played twice in a row",
        remedy="remove the constraint or add sequences",
    )


def first_repeat(order: Sequence[Condition], *, in_circle: bool = False) -> int | None:
    """Return the first position with the same sequence as the one before, or None.

    Args:
        order: of conditions.
        in_circle: whether the first follows the last.
    """
    for place in range(0 if in_circle else 1, len(order)):
        if order[place].sequence == order[place - 1].sequence:
            return place
    return None
