"""Which seconds the plots show: a window around the playhead that can be moved."""

from PySide6.QtCore import QObject, Signal

from app.plots.series import HALF_WINDOW_S, LONGEST_HALF_S, SHORTEST_HALF_S


class ViewSpan(QObject):
    """Zoom and pan, shared by plots that go together.

    Signals:
        changed: other seconds are to be drawn.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.half_s = HALF_WINDOW_S
        self.offset_s = 0.0

    def around(self, media_s: float) -> tuple[float, float]:
        """Return the first and the last second for a playhead."""
        middle_s = media_s + self.offset_s
        return middle_s - self.half_s, middle_s + self.half_s

    def zoom(self, factor: float) -> None:
        """Show more (above 1) or fewer seconds, around the middle of the view."""
        half_s = min(LONGEST_HALF_S, max(SHORTEST_HALF_S, self.half_s * factor))
        if half_s != self.half_s:
            self.half_s = half_s
            self.changed.emit()

    def pan(self, by_s: float) -> None:
        """Show later (+) or earlier (-) seconds than those around the playhead."""
        self.offset_s += by_s
        self.changed.emit()

    def reset(self) -> None:
        """Show the seconds around the playhead again."""
        self.half_s, self.offset_s = HALF_WINDOW_S, 0.0
        self.changed.emit()
