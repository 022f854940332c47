"""Tables that are printed, and put where a page of the documentation shows them.

A page marks the place with `<!-- NAME: begin -->` and `<!-- NAME: end -->`; whatever
stands between is replaced, so that its figures are always those of a run.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from common import table


class Document:
    """The tables of one run, by name."""

    def __init__(self) -> None:
        self._tables: dict[str, str] = {}

    def table(
        self,
        name: str,
        title: str,
        header: Sequence[str],
        rows: Sequence[Sequence[Any]],
    ) -> None:
        """Print a table and remember it for the pages."""
        texts = [[str(cell) for cell in row] for row in rows]
        print(f"\n{title}\n{table(list(header), texts)}", flush=True)
        lines = ["| " + " | ".join(row) + " |" for row in [list(header), *texts]]
        lines.insert(1, "|" + "---|" * len(header))
        self._tables[name] = "\n".join(lines)

    def refresh(self, page: Path) -> list[str]:
        """Write the tables into a page that marks places for them; return which."""
        text = page.read_text(encoding="utf-8")
        found = []
        for name, lines in self._tables.items():
            begin, end = (f"<!-- {name}: {word} -->" for word in ("begin", "end"))
            if begin not in text:
                continue
            before, _, rest = text.partition(begin)
            _, _, after = rest.partition(end)
            text = f"{before}{begin}\n{lines}\n{end}{after}"
            found.append(name)
        page.write_text(text, encoding="utf-8")
        return found
