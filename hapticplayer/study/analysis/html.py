"""The report as one HTML page: no scripts, nothing from elsewhere."""

import base64
import html
from collections.abc import Callable, Iterable

from hapticplayer.study.analysis.contents import Block, Heading, Picture, Table, Words

_STYLE = """
body { font: 15px/1.5 sans-serif; color: #1b1f25; max-width: 62em; margin: 2em auto;
  padding: 0 1em; }
h2 { border-bottom: 1px solid #c8ced6; margin-top: 1.8em; }
table { border-collapse: collapse; margin: 0.6em 0 1.4em; font-size: 13px; }
caption { text-align: left; font-weight: bold; padding: 0.3em 0; }
th, td { padding: 0.2em 0.7em; text-align: right; white-space: nowrap;
  border-bottom: 1px solid #e1e5ea; }
th:first-child, td:first-child { text-align: left; }
img { max-width: 100%; }
@media print { h2, table, img { break-inside: avoid; } }
"""
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page(title: str, blocks: Iterable[Block], svgs: dict[str, bytes]) -> str:
    """Return the whole page.

    Args:
        title: for people.
        blocks: of the report.
        svgs: the figures by name.
    """

    def source(name: str) -> str:
        return "data:image/svg+xml;base64," + base64.b64encode(svgs[name]).decode()

    name = html.escape(title)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f"<title>{name}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"<h1>{name}</h1>\n{body(blocks, source)}\n</body>\n</html>\n"
    )


def body(blocks: Iterable[Block], source: Callable[[str], str]) -> str:
    """Return the parts as HTML.

    Args:
        blocks: of the report.
        source: gives the address of a figure by its name.
    """
    return "\n".join(_block(block, source) for block in blocks)


def _block(block: Block, source: Callable[[str], str]) -> str:
    match block:
        case Heading(text):
            return f"<h2>{html.escape(text)}</h2>"
        case Words(text, lead):
            bold = f"<b>{html.escape(lead)}</b> " if lead else ""
            return f"<p>{bold}{html.escape(text)}</p>"
        case Picture(name, caption):
            told = html.escape(caption)
            return (  # paragraphs, for the window does not know <figure>
                f'<p><img src="{html.escape(source(name))}" alt="{told}"></p>'
                f"<p><i>{told}</i></p>"
            )
        case Table():
            return _table(block)


def _table(table: Table) -> str:
    def row(cells: tuple[str, ...], tag: str) -> str:
        inner = "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells)
        return f"<tr>{inner}</tr>"

    rows = "\n".join(row(cells, "td") for cells in table.rows)
    caption = f"<caption>{html.escape(table.title)}</caption>"
    return f"<table>{caption}\n{row(table.head, 'th')}\n{rows}\n</table>"
