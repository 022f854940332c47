"""The report as one HTML page (no scripts, no external content) and as PDF (A4)."""

import base64
import datetime as dt
import html
import io
import logging
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
)

if TYPE_CHECKING:
    from fpdf import FPDF

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #1b1f25; max-width: 62em; margin: 2em auto;
  padding: 0 1em; }
h2 { border-bottom: 1px solid #c8ced6; margin-top: 1.8em; }
table { border-collapse: collapse; margin: 0.6em 0 1.4em; font-size: 13px; }
.note { font-size: 13px; color: #4a5260; margin: -1em 0 1.4em; }
.mark { position: fixed; top: 0; right: 0; padding: 0.3em 0.9em; background: #a32020;
  color: #fff; font-weight: bold; }
caption { text-align: left; font-weight: bold; padding: 0.3em 0; }
th, td { padding: 0.2em 0.7em; text-align: right; white-space: nowrap;
  border-bottom: 1px solid #e1e5ea; }
thead { display: table-header-group; }
th:first-child, td:first-child { text-align: left; }
img { max-width: 100%; }
@media print { h2, table, img { break-inside: avoid; } }
"""
_FONT = "DejaVu"
_TEXT_PT, _TABLE_PT, _HEADING_PT = 9.5, 7.2, 13.0
_LINE = 1.45 / 72.0 * 25.4  # mm for each point of the size
_MARGIN_MM, _PADDING_MM, _LEAST_ROOM_MM = 20.0, 1.2, 30.0
_HEADING_MM = 12.0
_SMALL = 0.8  # size of the font at which names are wrapped
_LEAST_NAME = 0.25  # of the page, for the names of rows
_MARK = (163, 32, 32)
_LEAST_FILLED = 0.3
"""Share of the last page above which the text has to end."""
_SMALLER = (0.92, 0.84, 0.76)
"""Sizes of the figures that are tried until the last page is filled so far."""
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page(
    title: str, mark: str, blocks: Iterable[ReportBlock], svgs: dict[str, bytes]
) -> str:
    """Return the whole page.

    Args:
        title: for people.
        mark: always visible, and on each printed page; empty for none.
        blocks: of the report.
        svgs: the figures by name.
    """

    def source(name: str) -> str:
        return "data:image/svg+xml;base64," + base64.b64encode(svgs[name]).decode()

    name = html.escape(title)
    banner = f'<div class="mark">{html.escape(mark)}</div>\n' if mark else ""
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f"<title>{name}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"{banner}<h1>{name}</h1>\n{body(blocks, source)}\n</body>\n</html>\n"
    )


def body(blocks: Iterable[ReportBlock], source: Callable[[str], str]) -> str:
    """Return the parts as HTML.

    Args:
        blocks: of the report.
        source: returns the address of a figure by its name.
    """
    return "\n".join(_block(block, source) for block in blocks)


def _block(block: ReportBlock, source: Callable[[str], str]) -> str:
    match block:
        case Heading(text):
            return f"<h2>{html.escape(text)}</h2>"
        case Paragraph(text):
            return f"<p>{html.escape(text)}</p>"
        case ReportFigure(name, caption, text):
            return (  # QTextBrowser has no <figure>
                f'<p><img src="{html.escape(source(name))}" '
                f'alt="{html.escape(text or caption)}"></p>'
                f"<p><i>{html.escape(caption)}</i></p>"
            )
        case ReportTable():
            return _table(block)


def _table(table: ReportTable) -> str:
    def row(cells: tuple[str, ...], tag: str) -> str:
        inner = "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells)
        return f"<tr>{inner}</tr>"

    rows = "\n".join(row(cells, "td") for cells in table.rows)
    caption = f"<caption>{html.escape(table.title)}</caption>"
    head = f"<thead>{row(table.head, 'th')}</thead>"
    note = f'\n<p class="note">{html.escape(table.note)}</p>' if table.note else ""
    return f"<table>{caption}\n{head}\n<tbody>{rows}</tbody>\n</table>{note}"


def write_pdf(
    path: Path,
    title: str,
    mark: str,
    blocks: Iterable[ReportBlock],
    pngs: dict[str, bytes],
) -> None:
    """Write the report, with smaller figures if the last page would be nearly empty.

    Args:
        path: of the new file.
        title: for people.
        mark: on each page; empty for none.
        blocks: of the report.
        pngs: the figures by name.
    """
    blocks = tuple(blocks)
    pdf = _typeset(title, mark, blocks, pngs, 1.0)
    for scale in _SMALLER:
        if pdf.pages_count == 1 or pdf.y > _LEAST_FILLED * pdf.h:
            break
        _close_fonts(pdf)
        pdf = _typeset(title, mark, blocks, pngs, scale)
    pdf.output(str(path))


def _close_fonts(pdf: "FPDF") -> None:
    """Close the files of fonts, as its `output` does."""
    for font in pdf.fonts.values():
        if close := getattr(font, "close", None):
            close()


def _typeset(
    title: str,
    mark: str,
    blocks: tuple[ReportBlock, ...],
    pngs: dict[str, bytes],
    scale: float,
) -> "FPDF":
    pdf = _new_pdf(title, mark)
    _paragraph(pdf, title, 1.4 * _HEADING_PT, bold=True)
    for block in blocks:
        match block:
            case Heading(text):
                if pdf.will_page_break(_LEAST_ROOM_MM + _HEADING_MM):
                    pdf.add_page()
                pdf.ln(3.0)
                _paragraph(pdf, text, _HEADING_PT, bold=True)
            case Paragraph(text):
                _paragraph(pdf, text, _TEXT_PT)
            case ReportFigure(name, caption, text):
                width = scale * pdf.epw
                pdf.image(io.BytesIO(pngs[name]), w=width, alt_text=text or caption)
                _paragraph(pdf, caption, _TEXT_PT)
            case ReportTable():
                _add_table(pdf, block)
    return pdf


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
    """Write a table; if it is too wide, in a smaller font and with names wrapped."""
    from fpdf.enums import TableBordersLayout

    if pdf.will_page_break(_LEAST_ROOM_MM):
        pdf.add_page()
    _paragraph(pdf, table.title, _TEXT_PT, bold=True)
    pdf.set_font(_FONT, "B", _TABLE_PT)
    rows = (table.head, *table.rows)
    widths = [
        max(map(pdf.get_string_width, cells)) + 2.0 * _PADDING_MM
        for cells in zip(*rows, strict=True)
    ]
    room = max(pdf.epw / _SMALL - sum(widths[1:]), _LEAST_NAME * pdf.epw)
    widths[0] = min(widths[0], room)
    scale = min(1.0, pdf.epw / sum(widths))
    size_pt = scale * _TABLE_PT
    pdf.set_font(_FONT, "", size_pt)
    with pdf.table(
        rows,
        width=scale * sum(widths),
        col_widths=[scale * width for width in widths],
        align="LEFT",
        text_align=("LEFT", *["RIGHT"] * (len(widths) - 1)),
        line_height=size_pt * _LINE,
        padding=(0.0, scale * _PADDING_MM),
        borders_layout=TableBordersLayout.SINGLE_TOP_LINE,
        markdown=False,
    ):
        pass
    if table.note:
        pdf.ln(0.8)
        _paragraph(pdf, table.note, _TABLE_PT)
    pdf.ln(3.5)
