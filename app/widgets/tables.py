"""Tables that are read and chosen from, never typed into."""

from collections.abc import Sequence

from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget

from app.widgets.layout import BESIDE


def plain_table(
    name: str,
    headings: Sequence[str],
    stretched: int,
    *,
    is_chosen_from: bool = False,
    has_grid: bool = True,
) -> QTableWidget:
    """Return a table without rows.

    Args:
        name: for screen readers.
        headings: of the columns.
        stretched: the column that takes the room which others leave.
        is_chosen_from: whether a row can be selected.
        has_grid: whether lines divide the cells.
    """
    table = QTableWidget(0, len(headings))
    table.setAccessibleName(name)
    table.setHorizontalHeaderLabels(list(headings))
    table.verticalHeader().hide()
    table.setTabKeyNavigation(False)  # Tab moves on to the buttons
    table.setShowGrid(has_grid)
    table.setWordWrap(False)  # rows have one line: the rest of a text would be lost
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    mode = QAbstractItemView.SelectionMode
    table.setSelectionMode(mode.SingleSelection if is_chosen_from else mode.NoSelection)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    header = table.horizontalHeader()
    header.setDefaultAlignment(BESIDE)
    header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(stretched, QHeaderView.ResizeMode.Stretch)
    return table
