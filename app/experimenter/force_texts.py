"""The formats of force in file dialogs, and what an exported file keeps and has cost."""

from typing import Any

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.widgets.texts import local
from hapticplayer.sequence.force_files import ForceFormat
from hapticplayer.sequence.force_formats import read_formats, written_formats


def read_filter() -> str:
    """Return the kinds of files that hold a force track."""
    patterns = {
        one.name: " ".join(f"*{end}" for end in (one.suffix, *one.other_suffixes))
        for one in read_formats().values()
    }
    kinds = [
        QCoreApplication.translate("ForceTexts", "Force tracks ({patterns})").format(
            patterns=" ".join(patterns.values())
        ),
        *(
            f"{translated(one.text)} ({patterns[one.name]})"
            for one in read_formats().values()
        ),
        QCoreApplication.translate("ForceTexts", "All files (*)"),
    ]
    return ";;".join(kinds)


def write_filters() -> dict[str, ForceFormat]:
    """Return the formats that are written, by their line in a file dialog."""
    return {
        f"{translated(one.text).replace('(', '').replace(')', '')} (*{one.suffix})": one
        for one in written_formats().values()
    }


def cost_text(form: ForceFormat, cost: dict[str, Any]) -> str:
    """The losses of a file against its track, and its size."""
    lines = QCoreApplication.translate("ForceTexts", "{kept}; {rate} kbit/s").format(
        kept=translated(form.keeps), rate=local(f"{cost['kbit_s']:.3g}")
    )
    if cost["error_max_n"] is None:
        return lines
    return lines + QCoreApplication.translate(
        "ForceTexts", "; largest error {error} N"
    ).format(error=local(f"{cost['error_max_n']:.3f}"))
