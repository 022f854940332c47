"""The parts of a report, independent of its format, and their numbers."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

_WORD = re.compile(r"[^\W\d_]{4,}")


@dataclass(frozen=True, slots=True)
class Heading:
    """The title of a part."""

    text: str


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A paragraph."""

    text: str


@dataclass(frozen=True, slots=True)
class ReportTable:
    """A table of texts; the first column names the rows.

    Attributes:
        title: caption, without a number.
        head: of the columns.
        rows: of cells.
        note: below the table.
    """

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str = ""

    @property
    def words(self) -> tuple[bool, ...]:
        """Which columns hold words, which begin at the left, rather than numbers."""
        columns = list(zip(*self.rows, strict=True)) or [()] * len(self.head)
        return (True, *(any(map(_WORD.search, cells)) for cells in columns[1:]))


@dataclass(frozen=True, slots=True)
class ReportFigure:
    """A figure by its name.

    Attributes:
        name: of its file.
        caption: without a number.
        text: what it shows, for those who cannot see it.
    """

    name: str
    caption: str
    text: str = ""


ReportBlock = Heading | Paragraph | ReportTable | ReportFigure


def numbered(blocks: Iterable[ReportBlock]) -> Iterator[ReportBlock]:
    """Yield the parts with "Table N." and "Figure N." before captions; no empty table."""
    tables = figures = 0
    for block in blocks:
        if isinstance(block, ReportTable):
            if not block.rows:
                continue
            tables += 1
            yield replace(block, title=f"Table {tables}. {block.title}")
        elif isinstance(block, ReportFigure):
            figures += 1
            yield replace(block, caption=f"Figure {figures}. {block.caption}")
        else:
            yield block
