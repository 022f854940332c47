"""What a motion rig would do: listens on this machine, and shows the platform."""

from functools import partial

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QDialog, QLabel, QWidget

from app.bridge.languages import translated
from app.plots.rig_platform import Follower, reached
from app.plots.rig_view import RigView
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    fill_page,
    paragraph,
    resize_within_screen,
    row_of,
)
from hapticplayer.clock import Clock
from hapticplayer.errors import InputError, message_of
from hapticplayer.extras.rigs.packets import FORMATS
from hapticplayer.extras.rigs.receiver import PacketReceiver
from hapticplayer.model.rig import RigMotion

POLL_MS = 33
_WIDTH_PX, _HEIGHT_PX = 520, 480


class RigPanel(QDialog):
    """Stays beside the window; ports are open while it is."""

    play_wanted = Signal()

    def __init__(
        self, clock: Clock, parent: QWidget, ports: tuple[int, ...] | None = None
    ) -> None:
        super().__init__(parent)
        self._clock = clock
        self._followers: dict[int, Follower] = {}
        self.view, self.state = RigView(), QLabel()
        self.hint = paragraph("", theme.DIM)
        self.receiver: PacketReceiver | None = None
        wanted = ports or tuple(kind.port for kind in FORMATS.values())
        try:
            self.receiver = PacketReceiver(clock, wanted)
        except InputError as problem:
            self.hint.setText(translated(message_of(problem)))
        else:
            # also with its window; a partial holds the receiver, a bound method would not
            self.destroyed.connect(partial(PacketReceiver.close, self.receiver))
            self.hint.setText(
                self.tr(
                    "Listening on this computer at the ports {ports}. Play on this rig, or let "
                    "a game send its telemetry here."
                ).format(ports=", ".join(map(str, self.receiver.rigs)))
            )
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self.poll)
        self._timer.start()
        self.poll()

    def poll(self) -> None:
        """Take the packets that have come, and show where the platform is."""
        if self.receiver is None:
            self.state.setText(self.tr("Not listening"))
            return
        newest = None
        for port, at_s, heard in self.receiver.listen(0.0):
            follower = self._followers.setdefault(port, Follower())
            angles = heard.pitch_rad, heard.roll_rad, heard.heading_rad
            motion = RigMotion(*heard.acceleration_mps2, *angles)
            newest = heard.format, follower.pose(motion, at_s)
        if newest is not None:
            name, asked = newest
            pose, share = reached(asked)
            self.view.show_pose(pose, is_clamped=share < 1.0)
            self.state.setText(self._words(name, share))
        elif not self._followers:
            self.state.setText(self.tr("No data received yet"))

    def done(self, result: int) -> None:
        """Close the ports."""
        self._timer.stop()
        if self.receiver is not None:
            self.receiver.close()
        super().done(result)

    def _words(self, name: str, share: float) -> str:
        if share < 1.0:
            return self.tr("{format}: out of reach, {share:.0%} of it is done").format(
                format=name, share=share
            )
        return self.tr("{format}: followed").format(format=name)

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Simulated motion rig"))
        resize_within_screen(self, _WIDTH_PX, _HEIGHT_PX)
        self.state.setFont(theme.scaled(self.font(), 1.2, bold=True))
        close = text_button(self.tr("Close"), self.tr("Stop listening"))
        close.clicked.connect(self.reject)
        self.play = text_button(
            self.tr("&Play on this rig"), self.tr("Add it to the outputs"), "primary"
        )
        self.play.clicked.connect(self.play_wanted)
        row = row_of(STRETCH, close, self.play)
        fill_page(self, self.state, (self.view, 1), self.hint, row)
