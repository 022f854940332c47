"""Feel it now: what the sensor of a recorder measures moves the grip at once."""

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QIcon

from app.bridge.languages import translated
from app.bridge.pump import Pump
from app.player.health import stop_reason
from app.player.transport import offer_stop, rearm_problem
from app.player.video_surface import SurfaceSink, VideoSurface
from app.widgets.buttons import set_role, text_button
from app.widgets.texts import capitalised
from hapticplayer.capture.live.source import OpenedSource
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.model import Mapping
from hapticplayer.playback.feel import Feel
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.player import Player

MakePlayer = Callable[[Clock, SurfaceSink, str], Player]


class FeelSetup(NamedTuple):
    """What the page plays and feels with.

    Attributes:
        clock: the machine's.
        device: by name, which nobody else has meanwhile.
        mapping: from motion to force.
        make_player: makes the player of a device.
        latch: the stop of the window.
    """

    clock: Clock
    device: str
    mapping: Mapping
    make_player: MakePlayer
    latch: StopLatch


class FeelNow(QObject):
    """One button that feels, stops and re-arms, and the force behind it."""

    said = Signal(str)
    """What a person does next, or why it has stopped."""

    def __init__(self, setup: FeelSetup, parent: QObject) -> None:
        super().__init__(parent)
        self._setup, self._clock, self._latch = setup, setup.clock, setup.latch
        self.source: OpenedSource | None = None
        self.feel: Feel | None = None
        self.player: Player | None = None
        self._pump: Pump | None = None
        self._text = ""
        self.button = text_button("", "")
        self.button.clicked.connect(self._on_button)
        self.offer(None)

    def offer(self, source: OpenedSource | None) -> None:
        """Let this source be felt from now on; None for none."""
        if source is not self.source:
            self.end()
        self.source = source
        self._show_button()

    def stop(self) -> None:
        """Set the force to zero until a person re-arms."""
        if self.feel is not None:
            self.feel.stop_force()
            self.end()

    def end(self) -> None:
        """Ramp the force, and let go of the device."""
        feel, self.feel = self.feel, None
        player, self.player = self.player, None
        if feel is not None:
            feel.stop()
        if self._pump is not None:
            self._pump.stop()
            self._pump = None
        if player is not None:
            player.close()
            self._say("")
        self._show_button()

    def _on_button(self) -> None:
        if self.feel is not None:
            self.stop()
        elif self._latch.is_set:
            self._say(rearm_problem(self._latch, self._clock))
            self._show_button()
        elif self.source is not None:
            self._begin(self.source)

    def _begin(self, source: OpenedSource) -> None:
        try:
            self.player = self._setup.make_player(
                self._clock, SurfaceSink(VideoSurface()), self._setup.device
            )
            self.feel = Feel(self.player, source, self._setup.mapping, self._clock)
            self.feel.start(is_read=True)
        except HapticPlayerError as problem:
            self.feel = None
            self.end()
            self._say(translated(message_of(problem)))
            return
        self._pump = Pump(self.player.poll, self._clock, self._look, self)
        self._pump.start()
        self._show_button()

    def _look(self) -> None:
        """Say how it goes; end with a stop and with a device that fails."""
        player, feel = self.player, self.feel
        if player is None or feel is None:
            return
        now = player.snapshot()
        if now.is_stopped:
            self.end()
            self._say(stop_reason(now.leading.cause))
        elif problem := now.leading.problem:
            self.end()
            self._say(translated(problem))
        else:
            self._say(capitalised(translated(feel.snapshot().text)))

    def _say(self, text: str) -> None:
        if text != self._text:
            self._text = text
            self.said.emit(text)

    def _show_button(self) -> None:
        is_stopped = self._latch.is_set and self.feel is None
        self.button.setVisible(self.source is not None)
        if self.feel is not None or is_stopped:
            offer_stop(self.button, is_stopped=is_stopped)
            return
        self.button.setIcon(QIcon())
        set_role(self.button, "")
        self.button.setText(self.tr("&Feel it now"))
        self.button.setAccessibleName("")
        self.button.setToolTip(
            self.tr(
                "Feel what the sensor measures at this moment, on the haptic device"
            )
        )
