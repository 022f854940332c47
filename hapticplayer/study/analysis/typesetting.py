"""The report as one HTML page (no scripts, no external content)."""

import base64
import html
from collections.abc import Callable, Iterable

from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportFigure,
    ReportTable,
)

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #1b1f25; max-width: 62em; margin: 2em auto;
  padding: 0 1em; }
h2 { border-bottom: 1px solid #c8ced6; margin-top: 1.8em; }
table { border-collapse: collapse; margin: 0.6em 0 1.4em; font-size: 13px; }
.note { font-size: 13px; color: #4a5260; margin: -1em 0 1.4em; }
.mark { position: fixed; top: 0; right: 0; padding: 0.3em 0.9em; background: #a32020;
  color: #fff; font-weight: bold; }
caption { text-align: left; font-weight: bold; padding: 0.3em 0; }
th, td { padding: 0.2em 0.7em; white-space: nowrap;
  border-bottom: 1px solid #e1e5ea; }
thead { display: table-header-group; }
th:not([align]), td:not([align]) { text-align: right; }
img { max-width: 100%; }
@media print { h2, table, img { break-inside: avoid; } }
"""
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
    left = tuple(' align="left"' if one else "" for one in table.words)

    def row(cells: tuple[str, ...], tag: str) -> str:
        inner = "".join(
            f"<{tag}{side}>{html.escape(cell)}</{tag}>"
            for cell, side in zip(cells, left, strict=True)
        )
        return f"<tr>{inner}</tr>"

    rows = "\n".join(row(cells, "td") for cells in table.rows)
    caption = f"<caption>{html.escape(table.title)}</caption>"
    head = f"<thead>{row(table.head, 'th')}</thead>"
    note = f'\n<p class="note">{html.escape(table.note)}</p>' if table.note else ""
    return f"<table>{caption}\n{head}\n<tbody>{rows}</tbody>\n</table>{note}"
