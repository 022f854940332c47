"""Finds how a log lies to a clip, shows why, and lets a person correct it."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDoubleSpinBox,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.bridge.jobs import Jobs, Progress
from app.experimenter.sync_strip import STEP_S, Curve, SyncStrip
from app.widgets import theme
from app.widgets.buttons import text_button
from hapticplayer.capture import Recording, Synchronisation, read_recording, read_sound
from hapticplayer.capture.sync.events import loudness
from hapticplayer.capture.sync.synchronize import synchronize
from hapticplayer.model import ImuLog

_POLL_MS = 50
_LONGEST_OFFSET_S = 86_400.0


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """A clip's sound and a log, and how they lie to each other."""

    recording: Recording
    sound: Curve
    motion: Curve
    found: Synchronisation


def compare(video: Path, log: Path, progress: Progress) -> Compared:
    """Read both and synchronise them by the pats.

    Raises:
        InputError: when one cannot be read, or there is nothing to hear.
        UsageError: when the log needs a decision.
    """
    progress(0.1, log.name)
    recording = read_recording(log)
    progress(0.3, video.name)
    sound = read_sound(video)
    progress(0.8, "")
    found = synchronize(recording.imu, sound.samples, sound.rate_hz)
    level = loudness(sound.samples, sound.rate_hz)
    times_s = np.arange(len(level)) / 1000.0
    return Compared(recording, (times_s, level), _motion(recording.imu), found)


def _motion(imu: ImuLog) -> Curve:
    """Return how far each sample is from rest."""
    size = np.linalg.norm(imu.specific_force_mps2, axis=1)
    return imu.time_s, np.abs(size - np.median(size))


class SyncDialog(QDialog):
    """Shows the proposed shift on the time line; a person drags it or takes it.

    Signals:
        chosen: the offset, s.
    """

    chosen = Signal(float)

    def __init__(self, video: Path, log: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Synchronise sound and motion"))
        self.resize(860, 460)
        self.strip = SyncStrip()
        self.verdict = QLabel(self.tr("Looking for the pats\u2026"))
        self.verdict.setWordWrap(True)
        self.recognised = QLabel()
        self.recognised.setWordWrap(True)
        self.recognised.setStyleSheet(f"color: {theme.DIM};")
        self.offset = QDoubleSpinBox()
        self.offset.setRange(-_LONGEST_OFFSET_S, _LONGEST_OFFSET_S)
        self.offset.setDecimals(3)
        self.offset.setSingleStep(STEP_S)
        self.offset.setSuffix(self.tr(" s"))
        self.offset.setAccessibleName(self.tr("Offset"))
        self._lay_out()
        self.strip.shifted.connect(self.offset.setValue)
        self.offset.valueChanged.connect(self.strip.set_shift)
        self._jobs = Jobs(self._tell_failure)
        self._jobs.run("", lambda told: compare(video, log, told), self._show)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._jobs.poll)
        self._timer.start(_POLL_MS)

    def _lay_out(self) -> None:
        whole = text_button(self.tr("&Whole clip"), self.tr("Show the whole clip"))
        whole.clicked.connect(self.strip.show_whole)
        self.near = text_button(self.tr("The &pats"), self.tr("Show the pats closely"))
        self.near.clicked.connect(self.strip.show_pats)
        self.take = text_button(
            self.tr("Use this offset"), self.tr("Import with this offset"), "primary"
        )
        self.take.clicked.connect(self.accept)
        cancel = text_button(self.tr("Cancel"), self.tr("Leave the offset as it was"))
        cancel.clicked.connect(self.reject)
        self._set_enabled(False)
        row = QHBoxLayout()
        row.setSpacing(8)
        caption = QLabel(self.tr("&Offset"))
        caption.setBuddy(self.offset)
        for widget in (whole, self.near, caption, self.offset):
            row.addWidget(widget)
        row.addStretch(1)
        row.addWidget(cancel)
        row.addWidget(self.take)
        hint = QLabel(
            self.tr(
                "Drag the acceleration until it lies under the sound; the arrow keys "
                "move it by 1 ms, with Shift by 10 ms, with Ctrl by 100 ms. The wheel "
                "zooms."
            )
        )
        hint.setWordWrap(True)
        hint.setStyleSheet(f"color: {theme.DIM};")
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 14, 16, 14)
        column.setSpacing(10)
        column.addWidget(self.verdict)
        column.addWidget(self.recognised)
        column.addWidget(self.strip, 1)
        column.addWidget(hint)
        column.addLayout(row)

    def _set_enabled(self, is_ready: bool) -> None:
        for widget in (self.strip, self.near, self.offset, self.take):
            widget.setEnabled(is_ready)

    def _show(self, compared: Compared) -> None:
        found, imu = compared.found, compared.recording.imu
        offset_s = found.clock_map.offset_s
        pats_s = tuple(pat.heard_s for pat in found.pats)
        self.strip.show_streams(compared.sound, compared.motion, pats_s, offset_s)
        self.strip.show_pats()
        self._set_enabled(True)
        self.offset.setValue(offset_s)
        self.strip.setFocus()
        self.verdict.setText(self._verdict(found))
        colour = theme.GOOD if found.is_confident else theme.WARN
        self.verdict.setStyleSheet(f"color: {colour};")
        self.recognised.setText(
            self.tr("{camera}: {rate} Hz, {duration} s").format(
                camera=compared.recording.camera,
                rate=f"{imu.rate_hz:.1f}",
                duration=f"{imu.time_s[-1] - imu.time_s[0]:.1f}",
            )
        )

    def _verdict(self, found: Synchronisation) -> str:
        confidence = f"{found.clock_map.confidence:.2f}"
        if found.is_confident:
            return self.tr(
                "The pats were found (confidence {confidence}, residual {ms} ms)."
            ).format(
                confidence=confidence, ms=f"{1e3 * found.clock_map.residual_s:.1f}"
            )
        if found.pats:
            return self.tr(
                "The pats are not certain (confidence {confidence}). Look whether the "
                "same events lie under each other, and drag them if not."
            ).format(confidence=confidence)
        return self.tr("No three pats are both heard and felt; drag by hand.")

    def _tell_failure(self, problem: BaseException) -> None:
        self.verdict.setText(str(problem))
        self.verdict.setStyleSheet(f"color: {theme.BAD};")

    def accept(self) -> None:
        """Hand the offset over."""
        super().accept()
        self.chosen.emit(self.offset.value())

    def done(self, result: int) -> None:
        """Stop what still runs."""
        self._timer.stop()
        self._jobs.close()
        super().done(result)
