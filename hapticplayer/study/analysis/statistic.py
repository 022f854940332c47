"""The entries of the registry of statistics, and formats of numbers."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.scores import Sample

ALPHA = 0.05

Found = dict[str, Any]
"""Results of a statistic for a measure, or for a part of it, as in JSON."""


def number(value: float | None, digits: int = 2) -> str:
    """Return a number as text; None is a dash, and zero has no sign."""
    return "-" if value is None else f"{round(value, digits) + 0.0:.{digits}f}"


def p_value(value: float | None) -> str:
    if value is None:
        return "-"
    return "< .001" if value < 0.001 else f"{value:.3f}".lstrip("0")


def degrees(value: Sequence[float] | None) -> str:
    """Return two degrees of freedom as text; None is a dash."""
    if value is None:
        return "-"
    return ", ".join(f"{one:.2f}".rstrip("0").rstrip(".") for one in value)


def interval(value: Sequence[float] | None) -> str:
    """Return an interval as text; None is a dash."""
    return "-" if value is None else f"[{number(value[0])}, {number(value[1])}]"


class ReportColumn(NamedTuple):
    """A column of a statistic's table.

    Attributes:
        head: of the column.
        key: of the value in the results.
        text: formats the value.
    """

    head: str
    key: str
    text: Callable[[Any], str] = number


class Holm(NamedTuple):
    """Holm's correction for the number of tests; adds `p_holm` to the results.

    Attributes:
        p: key of the uncorrected p value.
        over: tests in one family.
    """

    p: str
    over: Literal["each measure", "all measures"]


@dataclass(frozen=True, slots=True)
class Statistic:
    """A statistic: an entry of `analysis.STATISTICS`.

    Attributes:
        name: in tests.csv and `--help`.
        title: of its table in the report, and in `--help`.
        compute: returns the results for a measure, by part (pair, feedback) unless
            `rows` is given.
        of: head of the first column: what the parts are.
        columns: of its table; by default one for each value.
        note: below its table: what the columns are.
        assumes: its assumptions, a paragraph of the report.
        warn: returns warnings from the results by measure.
        rows: returns the parts by name, "" for the whole.
        holm: correction for the number of tests.
        methods: returns from the results by measure the sentences for a paper: what was
            done, and which way p was found.
        references: works that the method is from.
        key: in JSON, if it differs from the name.
        of_factors: whether it is of factors in which sequences differ, which few studies
            have.
    """

    name: str
    title: str
    compute: Callable[[Sample, Resampling], Any]
    of: str = "part"
    columns: tuple[ReportColumn, ...] = ()
    note: str = ""
    assumes: str = ""
    warn: Callable[[dict[str, Any]], Iterable[str]] = lambda _found: ()
    rows: Callable[[Any], Mapping[str, Found]] = lambda found: found
    holm: Holm | None = None
    key: str = ""
    methods: Callable[[dict[str, Any]], str] = lambda _found: ""
    references: tuple[str, ...] = ()
    of_factors: bool = False

    def correct(self, found: Mapping[str, Any]) -> None:
        """Add `p_holm` to the results by measure."""
        if self.holm is None:
            return
        for family in self._families(found):
            corrected = holm([row[self.holm.p] for row in family])
            for row, p in zip(family, corrected, strict=True):
                row["p_holm"] = p

    def holm_family(self, found: Mapping[str, Any]) -> str:
        """Return which tests Holm's correction is over, and how many; empty without."""
        if self.holm is None:
            return ""
        sizes = {
            sum(row[self.holm.p] is not None for row in family)
            for family in self._families(found)
        }
        tests = " or ".join(str(size) for size in sorted(sizes - {0}))
        if tests in ("", "1"):  # nothing to correct
            return ""
        return f"the {tests} tests of {self.holm.over}"

    def _families(self, found: Mapping[str, Any]) -> list[list[Found]]:
        families = [list(self.rows(one).values()) for one in found.values()]
        if self.holm is not None and self.holm.over == "all measures":
            families = [[row for family in families for row in family]]
        return families


def holm(p_values: Sequence[float | None]) -> list[float | None]:
    """Return p values corrected by Holm (1979); None are not in the family."""
    known = [i for i, p in enumerate(p_values) if p is not None]
    raw = np.array([p_values[i] for i in known], dtype=np.float64)
    corrected: list[float | None] = [None] * len(p_values)
    for place, p in zip(known, holm_of_columns(raw), strict=True):
        corrected[place] = float(p)
    return corrected


def holm_of_columns(p_values: Floats) -> Floats:
    """Return p values (K, ...) corrected by Holm, each column as a family.

    statsmodels gives the same of one family, but runs the garbage collector: 2 s in
    an analysis.
    """
    order = np.argsort(p_values, axis=0, kind="stable")
    ranked = np.take_along_axis(p_values, order, axis=0)
    tests = np.arange(len(ranked), 0, -1).reshape(-1, *[1] * (ranked.ndim - 1))
    scaled = np.minimum(np.maximum.accumulate(ranked * tests, axis=0), 1.0)
    corrected = np.empty_like(p_values)
    np.put_along_axis(corrected, order, scaled, axis=0)
    return corrected


def plain(value: Any) -> Any:
    """Return results as JSON: lists for tuples, None for NaN and infinity."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def ways(found: Iterable[Mapping[str, Any]], key: str, texts: dict[str, str]) -> str:
    """Return how p was found, for all results or as alternatives.

    Args:
        found: results.
        key: of the method in the results.
        texts: by the first word of the method.
    """
    used = {str(one[key]).partition(",")[0] for one in found if one.get(key)}
    return ", or ".join(text for name, text in texts.items() if name in used)


def rounded(value: Any) -> Any:
    """Return results with 12 significant digits.

    The last digits of sums depend on the number of threads and on the processor.
    """
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(one) for one in value]
    if isinstance(value, float):
        return float(f"{value:.12g}") + 0.0  # no minus zero
    return value


def listed(names: Iterable[str]) -> str:
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
