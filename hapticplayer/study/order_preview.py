"""Who gets which order of conditions, before and while a study runs."""

from typing import NamedTuple

from hapticplayer.errors import Progress, no_progress
from hapticplayer.study.definition import Condition, Definition, OrderMethod
from hapticplayer.study.orders import assign, random_order, rows_of
from hapticplayer.study.plan import new_code
from hapticplayer.study.session_folder import SessionState, sha256
from hapticplayer.study.study_folder import Study

EXAMPLES = 3  # of orders that are drawn for each participant
NEXT, EXAMPLE = "next", "example"


class Given(NamedTuple):
    """The order of a participant.

    Attributes:
        code: of the participant.
        row: of the square or list; None for random orders.
        order: as it is played.
        counts: whether its place is taken: it was not dropped, and the definition is
            still the same.
    """

    code: str
    row: int | None
    order: tuple[Condition, ...]
    counts: bool


class OrderLine(NamedTuple):
    """An order, and who gets it: codes, NEXT for the next participant, or EXAMPLE."""

    number: int | None
    who: tuple[str, ...]
    order: tuple[Condition, ...]


def given_orders(study: Study, *, progress: Progress = no_progress) -> list[Given]:
    """The orders of all participants so far, by time."""
    progress(0.0, "")
    sessions, _ = study.sessions()
    now = sha256(study.content)
    return [
        Given(
            one.code,
            one.plan.row,
            one.plan.order,
            one.state is not SessionState.STOPPED and one.plan.definition_sha256 == now,
        )
        for one in sessions
    ]


def order_lines(
    definition: Definition,
    given: list[Given],
    listed: list[tuple[Condition, ...]],
) -> list[OrderLine]:
    """Return the orders with those who have and will get them.

    Args:
        definition: of the study.
        given: orders so far.
        listed: the orders of `orders.csv`.
    """
    old = [OrderLine(None, (one.code,), one.order) for one in given if not one.counts]
    current = [one for one in given if one.counts]
    if definition.order.method is OrderMethod.RANDOM:
        taken = [one.code for one in given]
        examples = [new_code(taken) for _ in range(EXAMPLES)]
        return [
            *old,
            *(OrderLine(None, (one.code,), one.order) for one in current),
            *(
                OrderLine(None, (EXAMPLE,), random_order(definition, code))
                for code in examples
            ),
        ]
    is_list = definition.order.method is OrderMethod.LIST
    rows = listed if is_list else rows_of(definition)
    if not rows:
        return old
    used = [one.row for one in current]
    following = assign(definition, new_code([]), used, listed).row
    lines = [
        OrderLine(
            number + 1,
            (
                *(one.code for one in current if one.row == number),
                *((NEXT,) if number == following else ()),
            ),
            order,
        )
        for number, order in enumerate(rows)
    ]
    return [*old, *lines]
