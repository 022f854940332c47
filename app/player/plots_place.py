"""Where the plots are in the window."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QVBoxLayout

from app.player.grip_feed import grip_of
from app.widgets import theme
from hapticplayer.playback.snapshot import Snapshot, TicksSince
from hapticplayer.playback.source import Source

if TYPE_CHECKING:
    from app.plots.panel import PlotPanel

LEAST_HEIGHT_PX = 124  # a title of two lines, a plot, and its times


class PlotsPlace(QFrame):
    """Holds the plots; pyqtgraph is imported when they are first wanted.

    Signals:
        sought: a person wants to be at this time, s.
    """

    sought = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Live plots"))
        self.setStyleSheet(
            f"PlotsPlace {{ border: 0; border-top: 1px solid {theme.BORDER}; }}"
        )
        self.setMinimumHeight(LEAST_HEIGHT_PX)
        self._source: Source | None = None
        self._has_grip = True
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 1, 0, 0)
        self.panel: PlotPanel | None = None

    def set_source(self, source: Source | None) -> None:
        """Show another clip."""
        self._source = source
        if self.panel:
            self.panel.set_source(source)

    def prepare(self) -> None:
        """Make the plots, in 0.2 s."""
        for _ in self.in_steps():
            pass

    def in_steps(self) -> Iterator[None]:
        """Make the plots, a part at each turn."""
        if self.panel is None:
            from app.plots.panel import panel_in_steps

            panel = yield from panel_in_steps()
            yield
            panel.set_source(self._source)
            panel.offer_grip(is_wanted=self._has_grip)
            panel.sought.connect(self.sought)
            self._column.addWidget(panel)
            self.panel = panel

    def follow(self, now: Snapshot, ticks_since: TicksSince) -> None:
        """Draw what lies around a media time."""
        if self.panel is not None:
            self.panel.follow(now, ticks_since)

    def follow_grip(self, now: Snapshot, ticks_since: TicksSince) -> None:
        """Show the grip and what acts on it; nothing is read where it is hidden."""
        if self.panel is not None and self.panel.grip.isVisible():
            self.panel.show_grip(grip_of(now, ticks_since))

    def show_grip(self, *, is_wanted: bool) -> None:
        """Show or hide the grip beside the plots."""
        self._has_grip = is_wanted
        if self.panel is not None:
            self.panel.offer_grip(is_wanted=is_wanted)
