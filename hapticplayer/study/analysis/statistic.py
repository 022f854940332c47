"""What a statistic is to the report: a name, a text, a function, and its columns."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.scores import Sample

ALPHA = 0.05

Found = dict[str, Any]
"""What a statistic found of a measure, or of a part of it, as it stands in JSON."""


def number(value: float | None, digits: int = 2) -> str:
    """Return a number for people; a dash where there is none."""
    return "-" if value is None else f"{value:.{digits}f}"


def p_value(value: float | None) -> str:
    """Return a p value as it is printed."""
    if value is None:
        return "-"
    return "< .001" if value < 0.001 else f"{value:.3f}".lstrip("0")


def interval(value: Sequence[float] | None) -> str:
    """Return an interval."""
    return "-" if value is None else f"[{value[0]:.2f}, {value[1]:.2f}]"


class ReportColumn(NamedTuple):
    """A column of a statistic's table.

    Attributes:
        head: of the column.
        key: of the value in what was found.
        text: gives the value as text.
    """

    head: str
    key: str
    text: Callable[[Any], str] = number


class Holm(NamedTuple):
    """A correction for the number of tests; `p_holm` is added to each of them.

    Attributes:
        p: key of the p value that is corrected.
        over: which tests are one family.
    """

    p: str
    over: Literal["each measure", "all measures"]


@dataclass(frozen=True, slots=True)
class Statistic:
    """An entry of `analysis.STATISTICS`.

    Attributes:
        name: in tests.csv and `--help`.
        title: of its table in the report; one line in `--help`.
        compute: returns what is found of a measure, by part (pair, feedback): `rows`
            tells where it is otherwise. Two values of `columns` and `of` head its table.
        of: what its parts are.
        columns: of its table; without them each value of the first part has one.
        assumes: a paragraph of the report.
        warn: returns where care is needed, from what was found by measure.
        rows: gives the parts by name, "" for the whole.
        holm: correction for the number of tests.
        key: in JSON, where it is not the name.
    """

    name: str
    title: str
    compute: Callable[[Sample, Resampling], Any]
    of: str = "part"
    columns: tuple[ReportColumn, ...] = ()
    assumes: str = ""
    warn: Callable[[dict[str, Any]], Iterable[str]] = lambda _found: ()
    rows: Callable[[Any], Mapping[str, Found]] = lambda found: found
    holm: Holm | None = None
    key: str = ""

    def correct(self, found: Mapping[str, Any]) -> None:
        """Add `p_holm` to what was found, by measure."""
        if self.holm is None:
            return
        families = [list(self.rows(one).values()) for one in found.values()]
        if self.holm.over == "all measures":
            families = [[row for family in families for row in family]]
        for family in families:
            corrected = holm([row[self.holm.p] for row in family])
            for row, p in zip(family, corrected, strict=True):
                row["p_holm"] = p


def holm(p_values: Sequence[float | None]) -> list[float | None]:
    """Return p values corrected step by step (Holm 1979); None stay out of the family.

    statsmodels has the same and collects garbage at every call, 2 s in an analysis.
    """
    known = [i for i, p in enumerate(p_values) if p is not None]
    raw = np.array([p_values[i] for i in known], dtype=np.float64)
    order = np.argsort(raw, kind="stable")
    scaled = np.maximum.accumulate(raw[order] * np.arange(len(raw), 0, -1))
    corrected: list[float | None] = [None] * len(p_values)
    for place, p in zip(order, np.minimum(scaled, 1.0), strict=True):
        corrected[known[place]] = float(p)
    return corrected


def plain(value: Any) -> Any:
    """Return what was found as JSON has it: lists, and None for NaN and infinity."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def listed(names: Iterable[str]) -> str:
    """Return names as a sentence has them."""
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
