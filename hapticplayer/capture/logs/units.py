"""Units that logs are written in, as factors to SI."""

import math
from collections.abc import Mapping

from hapticplayer.errors import UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2

FORCE: Mapping[str, float] = {
    "m/s2": 1.0,
    "g": STANDARD_GRAVITY_MPS2,
    "mg": STANDARD_GRAVITY_MPS2 / 1000.0,
}
RATE: Mapping[str, float] = {
    "rad/s": 1.0,
    "deg/s": math.pi / 180.0,
    "mdeg/s": math.pi / 180_000.0,
}
FIELD: Mapping[str, float] = {
    "uT": 1.0,
    "nT": 1e-3,
    "mT": 1e3,
    "T": 1e6,
    "gauss": 100.0,
    "mG": 0.1,
}
TIME: Mapping[str, float] = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}


def factor(unit: str, table: Mapping[str, float], key: str) -> float:
    """Return what a number in a unit is multiplied by.

    Args:
        unit: a name in the table, or the factor itself as a number.
        table: one of this module.
        key: of the choice, for the message.

    Raises:
        UsageError: for a unit that does not exist.
    """
    if unit in table:
        return table[unit]
    try:
        value = float(unit)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or value <= 0.0:
        raise UsageError(
            f"{key}={unit} is no unit; choose {', '.join(table)}, or give the "
            "factor to SI as a number above zero"
        )
    return value
