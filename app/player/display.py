"""What is shown of a running clip beside the video, and how often."""

import importlib
import threading
from collections.abc import Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QFrame, QVBoxLayout

from app.bridge.languages import translated
from app.player.health import device_name, mode_text, stop_reason
from app.plots.grip_scene import (
    ACTIVITIES,
    TRAIL_S,
    Activity,
    Grip,
    force_of,
    position_of,
    trail_of,
)
from app.widgets import theme
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import Feedback
from hapticplayer.playback.snapshot import Snapshot, TicksSince
from hapticplayer.playback.source import Source

if TYPE_CHECKING:
    from app.plots.panel import PlotPanel
from PySide6.QtWidgets import QMainWindow

from app.bridge.pump import Cadence
from app.player.health_line import HealthLine
from app.player.session import Session
from app.player.transport import Transport
from app.widgets.layout import is_seen
from hapticplayer.clock import Clock

translate = QCoreApplication.translate

SIMULATED = "simulated"


def grip_of(now: Snapshot, ticks_since: TicksSince) -> Grip:
    """The grip view of a device, with a title and perhaps a notice."""
    title = _title(now.leading.name)
    if now.leading.name == NO_DEVICE:
        text = translate(
            "GripView", "No device: choose {name} to see the simulated grip"
        )
        return Grip(title, text.format(name=device_name(SIMULATED)))
    ends = {
        Health.FAILED: translate("GripView", "The device has failed"),
        Health.GONE: translate("GripView", "The haptics process has ended"),
    }
    if now.leading.health in ends:
        return Grip(title, ends[now.leading.health], Activity.STOPPED)
    entry = find_device(now.leading.name)
    if not entry.capabilities.axes or entry.takes_motion:
        text = translate("GripView", "This device has no grip")
        return Grip(title, text)
    if now.leading.note:
        return Grip(title, translated(now.leading.note))
    if now.leading.tick is None:
        return Grip(title, translate("GripView", "Starting"), Activity.CHANGING)
    return _moving(title, now, ticks_since)


def _moving(title: str, now: Snapshot, ticks_since: TicksSince) -> Grip:
    capabilities = find_device(now.leading.name).capabilities
    latest, mode, feedback = now.leading.tick, now.leading.mode, now.feedback
    position_m = position_of(latest)
    ticks = ticks_since(float(latest["monotonic_s"]) - TRAIL_S)
    return Grip(
        title,
        _state(mode, now.leading.cause, feedback)
        if position_m
        else translate("GripView", "Position unknown"),
        _activity(mode, feedback),
        position_m,
        force_of(latest, "force_n"),
        force_of(latest, "planned_n"),
        force_of(latest, "centring_n"),
        trail_of(ticks),
        capabilities.workspace_radius_m,
        capabilities.continuous_force_n,
    )


def _title(device: str) -> str:
    if device in (SIMULATED, NO_DEVICE):
        return translate("GripView", "Simulated grip")
    return translate("GripView", "Grip")


def _is_off(mode: Mode, feedback: str) -> bool:
    return mode is Mode.IDLE or (
        mode is not Mode.TRIPPED and feedback == Feedback.NONE.value
    )


def _activity(mode: Mode, feedback: str) -> Activity:
    if _is_off(mode, feedback):
        return Activity.OFF
    return ACTIVITIES.get(mode, Activity.CHANGING)


def _state(mode: Mode, cause: Cause, feedback: str) -> str:
    if mode is Mode.TRIPPED:
        return stop_reason(cause)
    if _is_off(mode, feedback):
        return translate("GripView", "Force is off")
    return translate("GripView", "Force is {what}").format(what=mode_text(mode))


LEAST_HEIGHT_PX = 124  # a title of two lines, a plot, and its times


class PlotArea(QFrame):
    """Holds the plots, which are made when they are first seen: see `make_soon`."""

    sought = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Live plots"))
        self.setStyleSheet(
            f"PlotArea {{ border: 0; border-top: 1px solid {theme.BORDER}; }}"
        )
        self.setMinimumHeight(LEAST_HEIGHT_PX)
        self._source: Source | None = None
        self._has_grip = True
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 1, 0, 0)
        self.panel: PlotPanel | None = None
        self._steps = self._make()
        self._importing: threading.Thread | None = None

    def set_source(self, source: Source | None) -> None:
        """Show another clip."""
        self._source = source
        if self.panel:
            self.panel.set_source(source)

    def prepare(self) -> None:
        """Make the plots, in 0.2 s."""
        for _ in self._steps:
            pass

    def make_soon(self) -> None:
        """Make the plots, a part at each call, once pyqtgraph has come in a thread."""
        if self._importing is None:
            what = ("app.plots.panel",)
            self._importing = threading.Thread(
                target=importlib.import_module, args=what, name="plots"
            )
            self._importing.start()
        elif not self._importing.is_alive():
            next(self._steps, None)

    def in_steps(self) -> Iterator[None]:
        """The parts of making them."""
        return self._steps

    def _make(self) -> Iterator[None]:
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
        self._has_grip = is_wanted
        if self.panel is not None:
            self.panel.offer_grip(is_wanted=is_wanted)


PLOTS_HZ, STILL_PLOTS_HZ, TRANSPORT_HZ, HEALTH_HZ = 30.0, 4.0, 10.0, 2.0
GRIP_HZ = 15.0  # a hand is slower than what scrolls


class Display:
    """Refreshes position, plots and health; what is hidden costs nothing.

    Nothing is drawn while the window is minimised or covered.
    """

    def __init__(
        self,
        window: QMainWindow,
        session: Session,
        clock: Clock,
        parts: tuple[Transport, PlotArea, HealthLine],
    ) -> None:
        self._window = window
        self._session = session
        self._clock = clock
        self._transport, self._plots, self._health = parts
        self._transport_cadence = Cadence(TRANSPORT_HZ)
        self._plots_cadence = Cadence(PLOTS_HZ)
        self._still_plots_cadence = Cadence(STILL_PLOTS_HZ)
        self._grip_cadence = Cadence(GRIP_HZ)  # a hand moves while the clip is paused
        self._health_cadence = Cadence(HEALTH_HZ)

    def refresh(self) -> None:
        """Draw what is due; called when the video leaves time for it."""
        has_transport, has_plots = self._transport.isVisible(), self._plots.isVisible()
        has_health = self._health.isVisible()
        is_any = has_transport or has_plots or has_health
        if not is_any or not is_seen(self._window):
            return
        now_s = self._clock.now_s()
        player, now = self._session.player, self._session.player.snapshot()
        if has_plots and self._plots.panel is None and self._has_begun(now):
            self._plots.make_soon()
        if has_transport and self._transport_cadence.is_due(now_s):
            self._transport.follow(now.media_s)
        if has_plots and self._is_plots_turn(now_s, is_playing=now.is_playing):
            self._plots.follow(now, player.ticks_since)
        if has_plots and self._grip_cadence.is_due(now_s):
            self._plots.follow_grip(now, player.ticks_since)
        if has_health and self._health_cadence.is_due(now_s):
            self._health.show_readings(now, player.measurements())

    def _has_begun(self, now: Snapshot) -> bool:
        """Whether the first frames are on the screen, which nothing shall delay."""
        if now.source is None:
            return not self._session.jobs.is_busy
        return now.frames_shown > now.is_playing

    def refresh_soon(self) -> None:
        """Draw everything at the next opportunity: something has changed."""
        for turn in (
            self._transport_cadence,
            self._still_plots_cadence,
            self._health_cadence,
        ):
            turn.reset()

    def _is_plots_turn(self, now_s: float, *, is_playing: bool) -> bool:
        if is_playing:
            return self._plots_cadence.is_due(now_s)
        return self._still_plots_cadence.is_due(now_s)
