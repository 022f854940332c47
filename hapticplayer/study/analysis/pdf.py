"""The report as a PDF of A4 pages."""

import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hapticplayer.study.analysis.contents import Block, Heading, Picture, Table, Words
from hapticplayer.study.analysis.figures import settings

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH_IN, _HEIGHT_IN = 8.27, 11.69
_MARGIN_IN = 0.8
_TEXT_PT, _TABLE_PT, _HEADING_PT = 9.5, 7.2, 13.0
_LINE = 1.45  # of the size
_CHARACTERS = 90  # of a line of text
_PT_PER_IN = 72.0
_PICTURE_IN = 3.5
_ROWS_KEPT = 4
_CHARACTER = 0.58  # of the size: the mean width, with some room


def write_pdf(
    path: Path, title: str, blocks: Iterable[Block], pictures: dict[str, bytes]
) -> None:
    """Write the report.

    Args:
        path: of the new file.
        title: for people.
        blocks: of the report.
        pictures: the figures by name, PNG.
    """
    from matplotlib.backends.backend_pdf import PdfPages

    about = {"Title": title, "CreationDate": None, "ModDate": None}
    with settings(), PdfPages(path, metadata=about) as out:
        writer = _Writer(out, pictures)
        writer.text(title, 1.4 * _HEADING_PT, bold=True)
        for block in blocks:
            writer.add(block)
        writer.close()


class _Writer:
    """Fills pages from the top; owns the place where the next line goes."""

    def __init__(self, out: Any, pictures: dict[str, bytes]) -> None:
        self._out, self._pictures = out, pictures
        self._number = 0
        self._page = self._new_page()
        self._top_in = _MARGIN_IN

    def add(self, block: Block) -> None:
        """Write one part."""
        match block:
            case Heading(text):
                self._keep(6 * _TEXT_PT * _LINE / _PT_PER_IN)
                self._top_in += 0.12
                self.text(text, _HEADING_PT, bold=True)
            case Words(text, lead):
                if lead:
                    self.text(lead, _TEXT_PT, bold=True)
                self.text(text, _TEXT_PT)
                self._top_in += 0.06
            case Picture(name, caption):
                self._picture(self._pictures[name], caption)
            case Table():
                self._table(block)

    def text(self, text: str, size_pt: float, *, bold: bool = False) -> None:
        """Write a paragraph."""
        width = int(_CHARACTERS * _TEXT_PT / size_pt)
        for line in textwrap.wrap(text, width):
            self._line([(0.0, line, "left")], size_pt, bold=bold)

    def close(self) -> None:
        """Write the last page."""
        self._out.savefig(self._page)

    def _table(self, table: Table) -> None:
        self._keep((_ROWS_KEPT + 2) * _TABLE_PT * _LINE / _PT_PER_IN)
        self.text(table.title, _TEXT_PT, bold=True)
        columns = list(zip(table.head, *table.rows, strict=True))
        wide_in = [
            (max(map(len, cells)) + 2) * _CHARACTER * _TABLE_PT / _PT_PER_IN
            for cells in columns
        ]
        size_pt = _TABLE_PT * min(1.0, (_WIDTH_IN - 2 * _MARGIN_IN) / sum(wide_in))
        scale = size_pt / _TABLE_PT
        ends_in = [scale * sum(wide_in[: i + 1]) for i in range(len(wide_in))]
        for number, cells in enumerate((table.head, *table.rows)):
            placed = [(0.0, cells[0], "left")]
            rest = zip(ends_in[1:], cells[1:], strict=True)
            placed += [(end_in, cell, "right") for end_in, cell in rest]
            self._line(placed, size_pt, bold=number == 0)
        self._top_in += 0.14

    def _picture(self, png: bytes, caption: str) -> None:
        import io

        from matplotlib.image import imread

        self._keep(_PICTURE_IN + 0.3)
        bottom = 1.0 - (self._top_in + _PICTURE_IN) / _HEIGHT_IN
        width = 1.0 - 2.0 * _MARGIN_IN / _WIDTH_IN
        box = (_MARGIN_IN / _WIDTH_IN, bottom, width, _PICTURE_IN / _HEIGHT_IN)
        panel = self._page.add_axes(box)
        panel.imshow(imread(io.BytesIO(png)))
        panel.set_axis_off()
        self._top_in += _PICTURE_IN
        self.text(caption, _TEXT_PT)
        self._top_in += 0.1

    def _line(
        self, cells: list[tuple[float, str, str]], size_pt: float, *, bold: bool
    ) -> None:
        self._keep(size_pt * _LINE / _PT_PER_IN)
        self._top_in += size_pt * _LINE / _PT_PER_IN
        for at_in, cell, side in cells:
            self._page.text(
                (_MARGIN_IN + at_in) / _WIDTH_IN,
                1.0 - self._top_in / _HEIGHT_IN,
                cell,
                fontsize=size_pt,
                fontweight="bold" if bold else "normal",
                horizontalalignment=side,
            )

    def _keep(self, height_in: float) -> None:
        """Begin a new page where there is less room than this."""
        if self._top_in + height_in > _HEIGHT_IN - _MARGIN_IN:
            self._out.savefig(self._page)
            self._page = self._new_page()
            self._top_in = _MARGIN_IN

    def _new_page(self) -> "Figure":
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        page = Figure(figsize=(_WIDTH_IN, _HEIGHT_IN))
        FigureCanvasAgg(page)
        self._number += 1
        page.text(0.5, 0.4 / _HEIGHT_IN, str(self._number), fontsize=_TABLE_PT)
        return page
