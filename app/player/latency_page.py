"""Measuring how late video, sound and force are: by tapping, then by eye and ear."""

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QDialog,
    QDoubleSpinBox,
    QGridLayout,
    QLabel,
    QRadioButton,
    QWidget,
)

from app.bridge.jobs import Jobs
from app.bridge.languages import translated
from app.bridge.pump import Pump
from app.bridge.settings import (
    DEVICE,
    DISPLAY,
    SOUND,
    Settings,
    is_known,
    keep_latency,
    latencies_of,
    screen_name,
)
from app.player.health import device_name, stop_reason
from app.player.transport import offer_stop, rearm_problem
from app.player.video_surface import SurfaceSink, VideoSurface
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import (
    STRETCH,
    ElidedLabel,
    fill_page,
    framed,
    indent,
    paragraph,
    row_of,
)
from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE
from hapticplayer.errors import HapticPlayerError, Progress, message_of
from hapticplayer.model import Feedback
from hapticplayer.playback.beats import (
    COUNT,
    FELT,
    PERIOD_S,
    TapMeter,
    beat_source,
    relative_latencies_s,
)
from hapticplayer.playback.latch import STOPPED, StopLatch
from hapticplayer.playback.latency import MOST_S, Latencies
from hapticplayer.playback.player import Player
from hapticplayer.playback.snapshot import Snapshot
from hapticplayer.playback.source import Source
from hapticplayer.playback.video_output import NullSink

TOGETHER = "together"
PARTS = (DISPLAY, SOUND, DEVICE)
POLL_MS = 100
SETTLED_MS = 400  # after the last step of a number
_WIDTH_PX, _FLASH_PX, _STEP_MS = 620, 150, 5.0

MakePlayer = Callable[[Clock, SurfaceSink, str], Player]


class Row(NamedTuple):
    """What belongs to one of the three outputs."""

    choice: QRadioButton
    number: QDoubleSpinBox
    status: QLabel


class LatencyPage(QDialog):
    """Plays beats on a player of its own; Escape and STOP take the force away at once.

    The window has to let go of the device before. What is found is put into the
    settings only by "Use". The device "none" is left out. While the latch is set nothing
    begins, and the button re-arms.
    """

    measured = Signal()

    def __init__(
        self,
        clock: Clock,
        device: str,
        settings: Settings,
        make_player: MakePlayer,
        latch: StopLatch,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._clock, self._device, self._settings = clock, device, settings
        self._make_player, self._latch = make_player, latch
        self.player: Player | None = None
        self.mode = TOGETHER
        self.rows: dict[str, Row] = {}
        self._sound_name, self._entered_display_ms = "", 0.0
        self._assumed_ms: dict[str, float] = {}
        self.meters = {part: TapMeter() for part in PARTS}
        self.surface = VideoSurface()
        self._jobs = Jobs(self._on_problem)
        self.pump: Pump | None = None
        self._make_parts()
        self._lay_out()
        self._poll_timer = QTimer(self)
        self._poll_timer.setInterval(POLL_MS)
        self._poll_timer.timeout.connect(self.look)
        self._settled = QTimer(self)
        self._settled.setSingleShot(True)
        self._settled.setInterval(SETTLED_MS)
        self._settled.timeout.connect(self._apply)
        self._show_known()
        self._show_instructions()

    # --- what a person does --------------------------------------------------

    def begin(self) -> None:
        """Make the beats, take the device, and play."""
        if self._latch.is_set:
            self._show_stopped()
        elif self.player is None and not self._jobs.is_busy:
            self.start_button.setEnabled(False)
            self.status.setText(self.tr("Preparing"))
            self._poll_timer.start()
            self._jobs.run("", self._make_beats, self._play)

    def stop_or_rearm(self) -> None:
        """Press the button."""
        if self.player is not None:
            self.stop()
        else:
            if problem := rearm_problem(self._latch, self._clock):
                self.status.setText(problem)
            else:
                self._show_instructions()
            self._offer_stop()

    def stop(self) -> None:
        """Take the force away until a person re-arms; let go of device and sound."""
        if self.player is not None:
            self.player.stop_force()
            self._let_go()

    def _let_go(self) -> None:
        player, self.player = self.player, None
        if player is None:
            return
        self._poll_timer.stop()
        if self.pump is not None:
            self.pump.stop()
            self.pump = None
        player.close()
        self.surface.clear()
        self.start_button.setEnabled(True)
        self._offer_stop()

    def _offer_stop(self) -> None:
        is_held = self._latch.is_set and self.player is None
        offer_stop(self.stop_button, is_stopped=is_held)
        self.stop_button.setEnabled(is_held or self.player is not None)

    def _show_stopped(self) -> None:
        self.status.setText(translated(STOPPED))
        self._offer_stop()

    def choose(self, mode: str) -> None:
        """Play all together, or one of the three alone to be tapped to."""
        self.mode = mode
        button = self.together if mode == TOGETHER else self.rows[mode].choice
        button.setChecked(True)
        self._apply()
        self._show_instructions()

    def tap(self) -> None:
        """A person taps to what is played alone."""
        player = self.player
        now = player.snapshot() if player else Snapshot()
        if not now.is_playing or self.mode not in self.meters:
            return
        self.meters[self.mode].tap(now.media_s)
        self._show_taps()
        self._propose()

    def accept(self) -> None:
        """Remember the numbers, each for its output."""
        names = self._names()
        for part, row in self.rows.items():
            value_ms = row.number.value()
            is_new = value_ms != self._assumed_ms.get(part, 0.0)
            if names[part] and (is_new or is_known(self._settings, part, names[part])):
                keep_latency(self._settings, part, names[part], value_ms)
        self._settings.save()
        self._end()
        self.measured.emit()
        super().accept()

    def reject(self) -> None:
        """Stop before anything else; Escape comes here too."""
        self.stop()
        self._end()
        super().reject()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not self._is_tap(event):
            super().keyPressEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        is_key = event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent)
        if is_key and self.mode != TOGETHER and self._is_tap(event):
            return True
        return super().eventFilter(watched, event)

    def _is_tap(self, event: QEvent) -> bool:
        """Tap if it is the space bar, once for each press."""
        if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Space:
            return False
        if not event.isAutoRepeat():
            self.tap()
        return True

    # --- what happens --------------------------------------------------------

    def look(self) -> None:
        """Show how it goes."""
        self._jobs.poll()
        player = self.player
        if player is None:
            return
        self._name_rows()
        now = player.snapshot()
        if now.is_stopped:
            self._let_go()
            self.status.setText(stop_reason(now.leading.cause))
        elif problem := now.problem or now.leading.problem:
            self._let_go()
            self.status.setText(translated(problem))

    @staticmethod
    def _make_beats(progress: Progress) -> Source:
        return beat_source(progress)

    def _play(self, source: Source) -> None:
        sink = SurfaceSink(self.surface)
        try:
            self.player = player = self._make_player(self._clock, sink, self._device)
        except HapticPlayerError as problem:
            self._on_problem(problem)
            return
        self.surface.set_clip_size(source.clip.width, source.clip.height)
        player.open(source)
        player.set_loop((0.0, COUNT * PERIOD_S))
        self.pump = Pump(player.poll, self._clock, lambda: None, self)
        self._apply()
        player.play()
        self.pump.start()
        self._offer_stop()
        self._show_instructions()

    def _apply(self) -> None:
        """Let the player do what is chosen; alone, nothing is compensated."""
        player = self.player
        if player is None or player.snapshot().source is None:
            return
        shown = {DISPLAY: True, SOUND: True, DEVICE: True}
        latencies = self._latencies()
        if self.mode != TOGETHER:
            shown = {part: part == self.mode for part in PARTS}
            latencies = Latencies(device_s={self._device: 0.0})
        player.set_latencies(latencies)
        player.set_volume(1.0 if shown[SOUND] else 0.0)
        player.set_feedback(FELT if shown[DEVICE] else Feedback.NONE.value)
        self.surface.clear()
        sink = SurfaceSink(self.surface) if shown[DISPLAY] else NullSink()
        player.set_sink(sink)

    def _latencies(self) -> Latencies:
        values_s = {part: 1e-3 * row.number.value() for part, row in self.rows.items()}
        names = self._names()
        return Latencies(
            values_s[DISPLAY],
            {names[SOUND]: values_s[SOUND]},
            {names[DEVICE]: values_s[DEVICE]},
        )

    def _propose(self) -> None:
        """Put what the taps say into the numbers, once the flash is among them."""
        medians = {part: meter.median_s for part, meter in self.meters.items()}
        known = {part: value for part, value in medians.items() if value is not None}
        if DISPLAY not in known or len(known) < 2:
            return
        found_s = relative_latencies_s(1e-3 * self._entered_display_ms, known)
        for part, value_s in found_s.items():
            self._fill(part, min(value_s, MOST_S))
        self._settled.start()

    def _on_entered(self) -> None:
        """A person changed a number: taps to the flash count from there."""
        self._entered_display_ms = self.rows[DISPLAY].number.value()
        self._settled.start()

    def _names(self) -> dict[str, str]:
        sound = self.player.snapshot().sound_output if self.player else ""
        self._sound_name = sound or self._sound_name
        device = "" if self._device == NO_DEVICE else self._device
        return {DISPLAY: screen_name(self), SOUND: self._sound_name, DEVICE: device}

    def _on_problem(self, problem: BaseException) -> None:
        self.start_button.setEnabled(True)
        self.status.setText(translated(message_of(problem)))

    def _end(self) -> None:
        self._let_go()
        self._jobs.close()

    # --- what is shown -------------------------------------------------------

    def _make_parts(self) -> None:
        self.together = QRadioButton(self.tr("All together, compensated"))
        self.together.setChecked(True)
        self.together.clicked.connect(lambda: self.choose(TOGETHER))
        texts = {
            DISPLAY: self.tr("Tap to the flash"),
            SOUND: self.tr("Tap to the beep"),
            DEVICE: self.tr("Tap to the force"),
        }
        self.rows = {part: self._row(part, text) for part, text in texts.items()}
        self._group = QButtonGroup(self)
        for button in (self.together, *(row.choice for row in self.rows.values())):
            self._group.addButton(button)
            button.installEventFilter(self)
        for row in self.rows.values():
            row.number.installEventFilter(self)
        self.status = paragraph(lines=4)
        self.start_button = text_button(
            self.tr("Start"), self.tr("Play a beat every second"), "primary"
        )
        self.stop_button = text_button(
            self.tr("STOP"), self.tr("Stop the force immediately (Esc)"), "stop"
        )
        self.tap_button = text_button(
            self.tr("Tap"), self.tr("Tap on each beat (space bar)")
        )
        self.use_button = text_button(
            self.tr("Apply"), self.tr("Save these latencies for these outputs")
        )
        self.start_button.clicked.connect(self.begin)
        self.stop_button.clicked.connect(self.stop_or_rearm)
        self._offer_stop()
        self.tap_button.pressed.connect(self.tap)
        self.use_button.clicked.connect(self.accept)

    def _row(self, part: str, text: str) -> Row:
        choice, number, status = QRadioButton(text), QDoubleSpinBox(), QLabel()
        choice.clicked.connect(lambda: self.choose(part))
        number.setRange(0.0, 1e3 * MOST_S)
        number.setDecimals(0)
        number.setSingleStep(_STEP_MS)
        number.setSuffix(self.tr(" ms"))
        number.setAccelerated(True)
        indent(number)
        number.valueChanged.connect(lambda _value: self._on_entered())
        status.setTextFormat(Qt.TextFormat.PlainText)
        status.setMinimumWidth(
            status.fontMetrics().horizontalAdvance("888 taps: 888 ± 88 ms")
        )
        return Row(choice, number, status)

    def _lay_out(self) -> None:
        self.setWindowTitle(self.tr("Measure latencies"))
        self.setMinimumWidth(_WIDTH_PX)
        self.surface.setFixedHeight(_FLASH_PX)
        table = QGridLayout()
        table.setColumnStretch(2, 1)
        table.addWidget(self.together, 0, 0, 1, 3)
        self.names = {part: ElidedLabel("", theme.DIM) for part in PARTS}
        for line, (part, row) in enumerate(self.rows.items(), 1):
            name = self.names[part]
            for column, widget in enumerate((row.choice, row.number, name, row.status)):
                table.addWidget(widget, line, column)
        close = text_button(self.tr("Cancel"), self.tr("Discard changes"))
        close.clicked.connect(self.reject)
        buttons = row_of(
            *(self.start_button, self.stop_button, self.tap_button),
            *(STRETCH, self.use_button, close),
        )
        fill_page(self, framed(self.surface), self.status, table, STRETCH, buttons)

    def _show_known(self) -> None:
        """Begin with what was measured before."""
        names = self._names()
        known = latencies_of(self._settings, names[DISPLAY])
        self._fill(DISPLAY, known.display_s)
        self._entered_display_ms = self.rows[DISPLAY].number.value()
        self._fill(DEVICE, known.of_device(names[DEVICE]).latency_s)
        self._assumed_ms = {DEVICE: self.rows[DEVICE].number.value()}
        self._name_rows()

    def _fill(self, part: str, latency_s: float) -> None:
        number = self.rows[part].number
        number.blockSignals(True)
        number.setValue(1e3 * latency_s)
        number.blockSignals(False)

    def _name_rows(self) -> None:
        """Say which outputs these are; the sound's is known once it plays."""
        before, names = self._sound_name, self._names()
        if names[SOUND] != before:
            known_s = latencies_of(self._settings, "").sound_s
            self._fill(SOUND, known_s.get(names[SOUND], 0.0))
            self._settled.start()
        shown = {**names, DEVICE: device_name(self._device)}
        for part, label in self.names.items():
            label.set_text(shown[part])
            row = self.rows[part]
            row.number.setAccessibleName(
                f"{row.choice.text()}: {shown[part]}".rstrip(": ")
            )
        for widget in (self.rows[DEVICE].choice, self.rows[DEVICE].number):
            widget.setEnabled(bool(names[DEVICE]))

    def _show_taps(self) -> None:
        meter, label = self.meters[self.mode], self.rows[self.mode].status
        text = self.tr("{n} of {least} taps").format(n=meter.count, least=meter.LEAST)
        if meter.median_s is not None:
            text = self.tr("{n} taps: {ms:.0f} \u00b1 {spread:.0f} ms").format(
                n=meter.count, ms=1e3 * meter.median_s, spread=1e3 * meter.spread_s
            )
        label.setText(text)

    def _show_instructions(self) -> None:
        if self.player is None:
            text = self.tr(
                "Every second there is a flash, a beep and a gentle force "
                "pulse. Hold the grip loosely and press Start. Esc, STOP or a "
                "button on the grip stops it."
            )
        elif self.mode == TOGETHER:
            text = self.tr(
                "Adjust the latencies until flash, beep and force come "
                "together. Increase the one that comes late."
            )
        else:
            text = self.tr(
                "Press the space bar on each beat, at least eight times: first "
                "to the flash, then to the beep and the force. The differences "
                'are filled in; fine-tune them with "All together".'
            )
        self.status.setText(text)
