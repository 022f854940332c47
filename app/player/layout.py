"""How the parts of the player's window lie."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMainWindow, QSplitter, QVBoxLayout, QWidget

PLOTS_PX = 190
_REST_PX = 600  # only the proportion counts: the picture takes what is left
_HANDLE_PX = 3


def arrange(
    window: QMainWindow,
    above: list[QWidget],
    stage: QWidget,
    plots: QWidget,
    below: list[QWidget],
) -> QVBoxLayout:
    """Put notices above, the controls below, and the plots under the picture.

    Args:
        window: gets them as its middle.
        above: one under the other, as high as they need to be.
        stage: takes the room that is left.
        plots: a person may make them higher or lower.
        below: like `above`.

    Returns:
        the layout of them all.
    """
    splitter = QSplitter(Qt.Orientation.Vertical)
    splitter.addWidget(stage)
    splitter.addWidget(plots)
    splitter.setStretchFactor(0, 1)
    splitter.setChildrenCollapsible(False)
    splitter.setHandleWidth(_HANDLE_PX)
    splitter.setSizes([_REST_PX, PLOTS_PX])
    middle = QWidget()
    column = QVBoxLayout(middle)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(0)
    for widget in above:
        column.addWidget(widget)
    column.addWidget(splitter, 1)
    for widget in below:
        column.addWidget(widget)
    window.setCentralWidget(middle)
    return column
