"""Acceleration and force around the playhead, and the grip in space, side by side."""

from collections.abc import Generator

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import QLabel, QSizePolicy, QSplitter, QWidget

from app.plots.grip_painter import headline
from app.plots.grip_scene import Grip
from app.plots.grip_view import GripView
from app.plots.playhead_plot import PlayheadPlot
from app.plots.save_view import SaveButton
from app.plots.series import (
    EMPTY,
    Page,
    Trail,
    ViewSpan,
    cut,
    half_range,
    sampled,
    thin,
)
from app.widgets import theme
from app.widgets.layout import column_of, row_of
from hapticplayer.playback.snapshot import Snapshot, TicksSince
from hapticplayer.playback.source import Source

translate = QCoreApplication.translate

LEAST_ACCELERATION_MPS2 = 2.0
LEAST_FORCE_N = 1.0
_PLANNED, _SENT = 0, 1
_HANDLE_PX = 3
_SHARES = (400, 400, 300)  # of the width: acceleration, force, grip


class AccelerationPlot(PlayheadPlot):
    """The camera's motion without gravity, in the frame of who carried it."""

    def __init__(self, span: ViewSpan | None = None) -> None:
        super().__init__(
            translate("PlotPanel", "Acceleration around the playhead"), (1.0,), span
        )
        self._source: Source | None = None

    def set_source(self, source: Source | None) -> None:
        """Show another clip's motion."""
        self._source = source
        self.forget_page()
        motion = source.motion if source else None
        peak = float(abs(motion.acceleration_mps2).max()) if motion else 0.0
        self.set_half_range(half_range(peak, LEAST_ACCELERATION_MPS2))
        self.set_notice(
            translate("PlotPanel", "This clip has no motion data")
            if source and not motion
            else ""
        )

    def follow(self, media_s: float) -> None:
        """Draw what lies around a media time."""
        span_s = self.new_page(media_s)
        motion = self._source.motion if self._source else None
        if span_s and motion:
            page = cut(motion.time_s, motion.acceleration_mps2, *span_s)
            self.set_lines(0, thin(page))
        elif span_s:
            self.set_lines(0, EMPTY)
        if not self.notice:  # else there is nothing that could move
            self.set_playhead(media_s)


class ForcePlot(PlayheadPlot):
    """The planned force, thin, and over it what was sent to the device, thick."""

    def __init__(self, span: ViewSpan | None = None) -> None:
        super().__init__(
            translate("PlotPanel", "Force around the playhead"), (1.0, 2.0), span
        )
        self._source: Source | None = None
        self._feedback = ""
        self._trail = Trail()
        self._loop_pid: int | None = None

    def set_source(self, source: Source | None) -> None:
        """Show another clip's force."""
        self._source, self._feedback = source, ""
        self._trail = Trail()
        self.set_half_range(half_range(_peak_n(source), LEAST_FORCE_N))

    def follow(self, now: Snapshot, ticks_since: TicksSince) -> None:
        """Draw what lies around a media time."""
        if now.feedback != self._feedback:
            self._feedback = now.feedback
            self.forget_page()
        span_s = self.new_page(now.media_s)
        if span_s:
            self.set_lines(_PLANNED, self._planned(*span_s))
        is_other = now.leading.loop_pid != self._loop_pid
        if is_other:
            self._loop_pid, self._trail = now.leading.loop_pid, Trail()
        has_more = self._trail.add(ticks_since(self._trail.last_tick_s))
        if has_more or is_other or span_s:  # ticks are read less often than drawn
            self.set_lines(_SENT, thin(cut(*self._trail.page(), *self.page_s)))
        self.set_playhead(now.media_s)

    def _planned(self, first_s: float, last_s: float) -> Page:
        source = self._source
        track = source.tracks.get(self._feedback) if source else None
        if source is None or track is None:
            return EMPTY
        return sampled(track, first_s, min(last_s, source.clip.duration_s))


def _peak_n(source: Source | None) -> float:
    """Return the largest force of a source."""
    if source is None:
        return 0.0
    return max((track.peak_n() for track in source.tracks.values()), default=0.0)


class PlotPanel(QWidget):
    """Both plots with their titles and legends, and the grip; each can be made wider.

    The plots were made before, over the same seconds; `sought` is a time, s.
    """

    sought = Signal(float)

    def __init__(
        self,
        acceleration: AccelerationPlot | None = None,
        force: ForcePlot | None = None,
    ) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.acceleration = acceleration or AccelerationPlot()
        self.span = self.acceleration.span
        self.force = force or ForcePlot(self.span)
        self.acceleration.sought.connect(self.sought)
        self.force.sought.connect(self.sought)
        self._last: tuple[Snapshot, TicksSince] | None = None
        self.span.changed.connect(self._on_span)
        self.grip = GripView()
        self._grip_title = _headline(headline(self.grip.grip))
        self._grip_box = _boxed(self._grip_title, self.grip)
        self._row = QSplitter(Qt.Orientation.Horizontal)
        self._row.setChildrenCollapsible(False)
        self._row.setHandleWidth(_HANDLE_PX)
        row_of(self._row, of=self)
        self._fill_row()

    def _fill_row(self) -> None:
        self._row.addWidget(
            titled_plot(
                translate("PlotPanel", "Acceleration, m/s\u00b2"),
                (
                    translate("PlotPanel", "x right"),
                    translate("PlotPanel", "y front"),
                    translate("PlotPanel", "z up"),
                ),
                "",
                self.acceleration,
                SaveButton(self.acceleration),
            )
        )
        self._row.addWidget(
            titled_plot(
                translate("PlotPanel", "Force, N"),
                (
                    translate("PlotPanel", "x right"),
                    translate("PlotPanel", "y up"),
                    translate("PlotPanel", "z towards you"),
                ),
                translate("PlotPanel", "thin: planned"),
                self.force,
                SaveButton(self.force),
            )
        )
        self._row.addWidget(self._grip_box)
        self._row.setSizes(list(_SHARES))
        for place, share in enumerate(_SHARES):
            self._row.setStretchFactor(place, share)

    def set_source(self, source: Source | None) -> None:
        """Show another clip."""
        self.acceleration.set_source(source)
        self.force.set_source(source)

    def follow(self, now: Snapshot, ticks_since: TicksSince) -> None:
        """Draw what lies around a media time."""
        self._last = (now, ticks_since)
        self.acceleration.follow(now.media_s)
        self.force.follow(now, ticks_since)

    def _on_span(self) -> None:
        """Draw again: other seconds are wanted."""
        if self._last is not None:
            self.acceleration.forget_page()
            self.force.forget_page()
            self.follow(*self._last)

    def show_grip(self, grip: Grip) -> None:
        self._grip_title.setText(headline(grip))
        self.grip.show_grip(grip)

    def offer_grip(self, *, is_wanted: bool) -> None:
        """Show or hide the grip beside the plots."""
        self._grip_box.setVisible(is_wanted)


def panel_in_steps() -> Generator[None, None, PlotPanel]:
    """Make a panel in steps of up to 25 ms; it is the generator's value."""
    acceleration = AccelerationPlot()
    yield
    force = ForcePlot(acceleration.span)
    yield
    return PlotPanel(acceleration, force)


def titled_plot(
    title: str,
    axes: tuple[str, str, str],
    note: str,
    plot: PlayheadPlot,
    tool: QWidget | None = None,
) -> QWidget:
    """Return a plot under a line with its title and legend, and perhaps a button."""
    entries = "".join(
        f"&nbsp;&nbsp; <span style='color:{colour}'>\u25ac</span>&nbsp;{_unbroken(name)}"
        for name, colour in zip(axes, theme.AXIS_COLOURS, strict=True)
    )
    tail = (
        f"&nbsp;&nbsp; <span style='color:{theme.DIM}'>{_unbroken(note)}</span>"
        if note
        else ""
    )
    return _boxed(_headline(f"<b>{title}</b>{entries}{tail}"), plot, tool)


def _headline(text: str) -> QLabel:
    """Return a line of rich text, or two: it never widens the window nor is cut."""
    made = QLabel(text)
    made.setWordWrap(True)
    made.setFont(theme.scaled(made.font(), 0.92))
    made.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    return made


def _boxed(title: QWidget, content: QWidget, tool: QWidget | None = None) -> QWidget:
    """Return something to look at under its title."""
    box = QWidget()
    box.setStyleSheet(f"background: {theme.PANEL};")
    line = row_of((title, 1), *([tool] if tool else []), margins=(10, 6, 6, 0))
    column_of(line, (content, 1), spacing=0, of=box)
    return box


def _unbroken(text: str) -> str:
    """Return a text that stays in one line with its colour."""
    return text.replace(" ", "&nbsp;")
