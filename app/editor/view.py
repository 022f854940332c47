"""Which part of a clip the lanes of the editor show."""

from PySide6.QtCore import QObject, Signal

SHORTEST_S = 0.02
_EDGE = 0.1  # of the view, that stays free beside what is brought into it


class TimeView(QObject):
    """A span of media time within a clip, shared by lanes, scroll bar and buttons."""

    changed = Signal()

    def __init__(self, duration_s: float = 1.0) -> None:
        super().__init__()
        self.duration_s = max(SHORTEST_S, duration_s)
        self.begin_s, self.end_s = 0.0, self.duration_s

    @property
    def span_s(self) -> float:
        """Length of what is shown."""
        return self.end_s - self.begin_s

    def set_duration(self, duration_s: float) -> None:
        self.duration_s = max(SHORTEST_S, duration_s)
        self.show_whole()

    def show_whole(self) -> None:
        self.show_span(0.0, self.duration_s)

    def show_span(self, begin_s: float, end_s: float) -> None:
        """Show a span; what lies outside of the clip is moved into it."""
        span_s = min(max(end_s - begin_s, SHORTEST_S), self.duration_s)
        begin_s = min(max(begin_s, 0.0), self.duration_s - span_s)
        shown = begin_s, min(begin_s + span_s, self.duration_s)
        if shown != (self.begin_s, self.end_s):
            self.begin_s, self.end_s = shown
            self.changed.emit()

    def zoom(self, factor: float, at_s: float) -> None:
        """Show `factor` times as many seconds; a time stays where it is."""
        before = (at_s - self.begin_s) / self.span_s
        span_s = min(max(self.span_s * factor, SHORTEST_S), self.duration_s)
        begin_s = at_s - before * span_s
        self.show_span(begin_s, begin_s + span_s)

    def pan(self, by_s: float) -> None:
        """Show later (+) or earlier (-) seconds."""
        self.show_span(self.begin_s + by_s, self.end_s + by_s)

    def reveal(self, media_s: float) -> None:
        if not self.begin_s <= media_s <= self.end_s:
            begin_s = media_s - _EDGE * self.span_s
            self.show_span(begin_s, begin_s + self.span_s)

    def x_of(self, media_s: float, width_px: float) -> float:
        return (media_s - self.begin_s) / self.span_s * width_px

    def time_at(self, x_px: float, width_px: float) -> float:
        """Return the media time at a place of a lane, within the clip."""
        media_s = self.begin_s + x_px / max(1.0, width_px) * self.span_s
        return min(max(media_s, 0.0), self.duration_s)
