"""The report as PDF (A4)."""

import datetime as dt
import io
import logging
from collections.abc import Iterable, Sequence
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, cast

from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
)
from hapticplayer.study.analysis.figures import SIZE_IN

if TYPE_CHECKING:
    from fpdf import FPDF

_FONT = "DejaVu"
_TEXT_PT, _TABLE_PT, _HEADING_PT = 9.5, 7.2, 13.0
_LINE = 1.45 / 72.0 * 25.4  # mm for each point of the size
_MARGIN_MM, _PADDING_MM, _LEAST_ROOM_MM = 20.0, 1.2, 30.0
_HEADING_MM = 12.0
_SMALL = 0.8  # size of the font at which names are wrapped
_LEAST_NAME = 0.25  # of the page, for the names of rows
_MARK = (163, 32, 32)
_SAME_MM = 1e-6
_Column = tuple[float, str]
"""Width in mm and alignment."""


def write_pdf(
    path: Path,
    title: str,
    mark: str,
    blocks: Iterable[ReportBlock],
    pngs: dict[str, bytes],
) -> None:
    """Write the report.

    Args:
        path: of the new file.
        title: for people.
        mark: on each page; empty for none.
        blocks: of the report.
        pngs: the figures by name.
    """
    pdf = _new_pdf(title, mark)
    blocks = tuple(blocks)
    figure_mm = pdf.epw * SIZE_IN[1] / SIZE_IN[0] + _HEADING_MM
    _paragraph(pdf, title, 1.4 * _HEADING_PT, bold=True)
    for block, after in zip_longest(blocks, blocks[1:]):
        match block:
            case Heading(text):
                room = figure_mm if isinstance(after, ReportFigure) else _LEAST_ROOM_MM
                _keep_together(pdf, room + _HEADING_MM)
                pdf.ln(3.0)
                _paragraph(pdf, text, _HEADING_PT, bold=True)
            case Paragraph(text):
                _paragraph(pdf, text, _TEXT_PT)
            case ReportFigure(name, caption, text):
                _keep_together(pdf, figure_mm)
                pdf.image(io.BytesIO(pngs[name]), w=pdf.epw, alt_text=text or caption)
                _paragraph(pdf, caption, _TEXT_PT)
            case ReportTable():
                _add_table(pdf, block)
    pdf.output(str(path))


def _keep_together(pdf: "FPDF", height_mm: float) -> None:
    """Begin a page where so much does not fit on this one."""
    if pdf.will_page_break(height_mm):
        pdf.add_page()


def _new_pdf(title: str, mark: str) -> "FPDF":
    from fpdf import FPDF
    from matplotlib import get_data_path

    class Pdf(FPDF):
        def header(self) -> None:
            if mark:
                self.set_y(_MARGIN_MM / 2.0)
                self.set_font(_FONT, "B", _TEXT_PT)
                self.set_text_color(*_MARK)
                self.cell(w=0, text=mark, align="R")
                self.set_text_color(0)
                self.set_y(_MARGIN_MM)

        def footer(self) -> None:
            self.set_y(-15.0)
            self.set_font(_FONT, size=_TABLE_PT)
            self.cell(w=0, text=str(self.page_no()), align="C")

    # it warns of each character that is not in the font
    logging.getLogger("fpdf").setLevel(logging.ERROR)
    pdf = Pdf(format="A4")
    pdf.set_creation_date(dt.datetime.fromtimestamp(0, dt.UTC))  # reproducible
    pdf.set_title(title)
    pdf.set_margin(_MARGIN_MM)
    fonts = Path(get_data_path()) / "fonts" / "ttf"
    pdf.add_font(_FONT, "", fonts / "DejaVuSans.ttf")
    pdf.add_font(_FONT, "B", fonts / "DejaVuSans-Bold.ttf")
    pdf.add_page()
    return pdf


def _paragraph(pdf: "FPDF", text: str, size_pt: float, *, bold: bool = False) -> None:
    pdf.set_font(_FONT, "B" if bold else "", size_pt)
    pdf.multi_cell(
        0, size_pt * _LINE, text, align="L", new_x="LMARGIN", new_y="NEXT", padding=0
    )
    pdf.ln(0.0 if bold else 1.5)


def _add_table(pdf: "FPDF", table: ReportTable) -> None:
    """Write a table; if it is too wide, in a smaller font and with names wrapped.

    Only names are wrapped: the tables of fpdf wrap each cell, twice, which takes a tenth
    of the whole analysis.
    """
    _keep_together(pdf, _LEAST_ROOM_MM)
    _paragraph(pdf, table.title, _TEXT_PT, bold=True)
    pdf.set_font(_FONT, "B", _TABLE_PT)
    rows = (table.head, *table.rows)
    widths = [
        max(map(pdf.get_string_width, cells)) + 2.0 * _PADDING_MM
        for cells in zip(*rows, strict=True)
    ]
    room = max(pdf.epw / _SMALL - sum(widths[1:]), _LEAST_NAME * pdf.epw)
    widths[0] = min(widths[0], room)
    fitted = min(1.0, pdf.epw / sum(widths))
    size_pt = fitted * _TABLE_PT
    aligned = ["L" if one else "R" for one in table.words]
    columns = list(zip([fitted * width for width in widths], aligned, strict=True))
    margin, pdf.c_margin = pdf.c_margin, fitted * _PADDING_MM
    _head(pdf, table.head, columns, size_pt)
    for cells in table.rows:
        lines = _lines(pdf, cells[0], columns[0][0])
        if pdf.will_page_break(len(lines) * size_pt * _LINE):
            pdf.add_page()
            _head(pdf, table.head, columns, size_pt)
        _row(pdf, lines, cells[1:], columns, size_pt)
    pdf.c_margin = margin
    if table.note:
        pdf.ln(0.8)
        _paragraph(pdf, table.note, _TABLE_PT)
    pdf.ln(3.5)


def _head(
    pdf: "FPDF", names: Sequence[str], columns: Sequence[_Column], size_pt: float
) -> None:
    pdf.set_font(_FONT, "B", size_pt)
    lines = _lines(pdf, names[0], columns[0][0])
    _row(pdf, lines, names[1:], columns, size_pt)
    width = sum(width for width, _ in columns)
    pdf.line(pdf.l_margin, pdf.y, pdf.l_margin + width, pdf.y)
    pdf.set_font(_FONT, "", size_pt)


def _lines(pdf: "FPDF", name: str, width: float) -> list[str]:
    """The lines of a name; a rounding error does not wrap it."""
    if (
        "\n" not in name
        and pdf.get_string_width(name) <= width - 2.0 * pdf.c_margin + _SAME_MM
    ):
        return [name]
    found = pdf.multi_cell(width, text=name, align="L", dry_run=True, output="LINES")
    return [str(one) for one in cast(list[str], found)]


def _row(
    pdf: "FPDF",
    names: Sequence[str],
    cells: Sequence[str],
    columns: Sequence[_Column],
    size_pt: float,
) -> None:
    """Write a row whose first cell may have several lines; the others in the middle."""
    top, left, line = pdf.y, pdf.l_margin, size_pt * _LINE
    (first, aligned), *others = columns
    for number, name in enumerate(names):
        pdf.set_xy(left, top + number * line)
        pdf.cell(first, line, name, align=aligned)
    height = max(1, len(names)) * line
    pdf.set_xy(left + first, top + (height - line) / 2.0)
    for text, (width, aligned) in zip(cells, others, strict=True):
        pdf.cell(width, line, text.replace("\n", " "), align=aligned)
    pdf.set_xy(left, top + height)
