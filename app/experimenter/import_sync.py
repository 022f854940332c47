"""Second page of an import: clip and log on one timeline."""

import contextlib
import dataclasses

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QWidget

from app.bridge.jobs import Job
from app.bridge.languages import translated
from app.experimenter.numbers import NumberBox, spin_box
from app.experimenter.sync_strip import (
    OF_CLIP,
    OF_LOG,
    STEP_S,
    ClipFrame,
    Lane,
    Sides,
    SyncStrip,
)
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, captioned, column_of, paragraph, row_of
from app.widgets.texts import local
from hapticplayer.capture.clock_lag import ClockLag
from hapticplayer.capture.sync import methods
from hapticplayer.capture.sync.result import COARSE_NOTE, Synchronisation
from hapticplayer.errors import HapticPlayerError, message_of
from hapticplayer.model import ClockMap
from hapticplayer.model.ranges import DRIFT_PPM
from hapticplayer.playback import snippet
from hapticplayer.playback.snippet import LONGEST_S, Samples, pats_sound
from hapticplayer.sequence.import_preview import BY_HAND, ImportPreview
from hapticplayer.sequence.synchronizing import moved_to, store_skew, stored_skews

_LONGEST_OFFSET_S = 86_400.0
_LARGEST_SKEW_MS = 2000.0
_SLOWEST = 1000.0
_AROUND_S = 2.0


class SyncPage(QWidget):
    """Shows the proposed shift; a person hears, sees, drags, and takes it.

    Signals:
        decided: whether the next step is allowed has changed.
        method_chosen: the clocks have to be synchronised by another method.
    """

    decided = Signal()
    method_chosen = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.strip, self.frame = SyncStrip(), ClipFrame()
        self._sound: Job[Samples] | None = None
        self._recognised: ImportPreview | None = None
        self.verdict, self.problem = paragraph(), paragraph("", theme.BAD)
        self.sides = Sides()
        self.sides.chosen.connect(self._choose_method)
        self.offset = spin_box(_LONGEST_OFFSET_S, 3, STEP_S, self.tr(" s"))
        self.offset.setAccessibleName(self.tr("Offset"))
        self.offset.setToolTip(
            self.tr("Media time at which the log's clock reads zero")
        )
        self.skew = spin_box(_LARGEST_SKEW_MS, 0, 1.0, self.tr(" ms"))
        self.skew.setAccessibleName(self.tr("Sound delay"))
        self.skew.setToolTip(
            self.tr("How much later than the video the camera records its sound")
        )
        self._make_drift_and_camera()
        self.slow = spin_box(_SLOWEST, 3, 1.0, self.tr(" \u00d7"))
        self.slow.setMinimum(1.0 / _SLOWEST)
        self.slow.setAccessibleName(self.tr("Slow motion"))
        self.slow.setToolTip(
            self.tr(
                "How many times slower than it was recorded the video plays: 8 if 240 "
                "frames per second play at 30; below 1 for a time lapse"
            )
        )
        self.slow.valueChanged.connect(lambda _value: self.method_chosen.emit())
        self.method = QComboBox()
        self.method.setAccessibleName(self.tr("Method"))
        for one in methods.sync_methods():
            self.method.addItem(translated(methods.title_of(one.name)), one.name)
        self.method_text = paragraph(colour=theme.DIM)
        self.method.currentIndexChanged.connect(self._show_method)
        self._show_method(self.method.currentIndex())
        self.method.activated.connect(lambda _row: self.method_chosen.emit())
        self.keep_skew = QCheckBox(self.tr("use for this camera"))
        self.looked = QCheckBox(self.tr("I have checked the offset by eye and ear"))
        self.looked.toggled.connect(lambda _on: self.decided.emit())
        self._lay_out()
        self.strip.shifted.connect(self.offset.setValue)
        self.strip.pointed.connect(self.frame.request)
        self.offset.valueChanged.connect(self._on_offset)
        self.skew.valueChanged.connect(self._on_skew)
        self.drift.valueChanged.connect(lambda _value: self._on_drift())
        self._late_s = 0.0

    # --- building ------------------------------------------------------------

    def _make_drift_and_camera(self) -> None:
        name, unit = self.tr("Clock drift"), self.tr(" ppm")
        self.drift = NumberBox(name, DRIFT_PPM, 3, 1.0, unit)
        self.drift.setToolTip(
            self.tr("By how much faster the video runs than the log's clock")
        )
        self.drift.setKeyboardTracking(False)
        self.camera = QComboBox()
        self.camera.setAccessibleName(self.tr("Sound delay of a camera"))
        self.camera.setToolTip(self.tr("The sound delay that is kept for a camera"))
        self.camera.activated.connect(lambda _row: self._on_camera())
        self.camera.hide()

    def _lay_out(self) -> None:
        whole = text_button(self.tr("&Whole clip"), self.tr("Show the whole clip"))
        whole.clicked.connect(self.strip.show_whole)
        self.near = text_button(
            self.tr("&Close-up"),
            self.tr("Zoom to the tap marks, or to where the camera turned most"),
        )
        self.near.clicked.connect(self.strip.show_close_up)
        self.hear = text_button(
            self.tr("&Listen"),
            self.tr(
                "Play the visible part: the clip on the left, a tick at each "
                "tap of the log on the right"
            ),
        )
        self.hear.clicked.connect(self._hear)
        offset = captioned(self.tr("&Offset"), self.offset)
        late = captioned(self.tr("S&ound delay"), self.skew)
        self._sound_delay = QWidget()
        row_of(*late, self.keep_skew, self.camera, STRETCH, of=self._sound_delay)
        drift = captioned(self.tr("Clock &drift"), self.drift)
        how = captioned(self.tr("&Method"), self.method)
        slow = captioned(self.tr("Slow mo&tion"), self.slow)
        buttons = (whole, self.near, self.hear)
        self.hint = paragraph(
            self.tr(
                "Drag the log's curves until they line up with the clip's; the "
                "arrow keys move them by 1 ms, with Shift 10 ms, with Ctrl 100 "
                "ms. The wheel zooms. The frame shown is the one at the cursor; "
                "comma and period move it."
            ),
            theme.DIM,
        )
        texts = column_of(
            self.hint,
            row_of(*buttons, *offset, STRETCH, spacing=4),
            self._sound_delay,
            row_of(*how, *drift, STRETCH),
            self.method_text,
            *(self.looked, self.problem, STRETCH),
        )
        self._body = QWidget()
        aside = column_of(self.frame, row_of(*slow), STRETCH)
        column_of((self.strip, 1), row_of((texts, 1), aside), of=self._body)
        said = row_of((self.verdict, 1), self.sides)
        column_of(said, (self._body, 1), of=self).addStretch(0)

    def _show_method(self, row: int) -> None:
        name = self.method.itemData(row)
        text = next(one.text for one in methods.sync_methods() if one.name == name)
        self.method_text.setText(translated(text))

    def _choose_method(self, name: str) -> None:
        self.method.setCurrentIndex(self.method.findData(name))
        self.method_chosen.emit()

    # --- what there is -------------------------------------------------------

    def show_found(self, found: ImportPreview) -> None:
        """Show another recording; what was chosen for the one before is forgotten."""
        self._recognised = found
        self.looked.setChecked(False)
        self.problem.clear()
        sync = found.found
        slowed = found.slowed or (found.pace and found.pace.slowed) or 1.0
        offset_s = sync.clock_map.offset_s if sync else -slowed * found.begin_s
        self._late_s = sync.sound_late_s if sync else 0.0
        # clocks may count from 1970
        most_s = max(_LONGEST_OFFSET_S, 2.0 * abs(offset_s))
        self.offset.setRange(-most_s, most_s)
        values = {
            self.skew: 1e3 * self._late_s,
            self.offset: offset_s,
            self.slow: slowed,
        }
        self.drift.blockSignals(True)
        self.drift.set_number(sync.drift_ppm if sync else 0.0)
        self.drift.blockSignals(False)
        for spin, value in values.items():
            spin.blockSignals(True)
            spin.setValue(value)
            spin.blockSignals(False)
        self._show_cameras()
        self.keep_skew.setVisible(bool(found.clip.camera))
        self.keep_skew.setToolTip(found.clip.camera)
        pats_s = tuple(pat.heard_s for pat in sync.pats) if sync else ()
        clock = ClockMap(offset_s, sync.clock_map.rate if sync else slowed)
        is_by_turns = sync is not None and sync.method == "frames"
        lanes = self._lanes(found)
        self.strip.show_lanes(lanes, pats_s, clock, is_by_turns=is_by_turns)
        is_near = bool(pats_s or len(found.turned[0]))
        if is_near:
            self.strip.show_close_up()
        elif not len(found.sound[0]):  # as long as the clip, though there is nothing
            self.strip.show_span(0.0, found.clip.duration_s)
        self.near.setEnabled(is_near)
        self.hear.setEnabled(found.clip.has_audio)
        self.frame.use(found.clip.path)
        begin_s, end_s = self.strip.view_s
        middle_s = is_near * 0.5 * (begin_s + end_s)
        self.strip.point_at(middle_s if is_by_turns or not pats_s else pats_s[0])
        self._show_needed(found)
        self._show_verdict()

    def _show_needed(self, found: ImportPreview) -> None:
        """Hide what there is nothing to do with."""
        is_own = found.knows_clip_clock
        self._sound_delay.setVisible(not is_own)
        self._body.setVisible(bool(len(found.turned[0])) or not is_own)
        is_torn = bool(found.found and found.found.is_torn)
        self.hint.setHidden(is_torn or (is_own and self._is_sure()))
        self.sides.setVisible(is_torn)

    def _lanes(self, found: ImportPreview) -> list[Lane]:
        return [
            Lane(self.tr("sound"), found.sound, OF_CLIP),
            Lane(self.tr("acceleration"), found.motion, OF_LOG),
            Lane(self.tr("rotation in the frames"), found.turned, OF_CLIP),
            Lane(self.tr("gyro"), found.gyro, OF_LOG),
        ]

    def choice(self) -> Synchronisation:
        """The result that a person has taken."""
        offset_s = self.offset.value()
        sync = self._shifted()
        if sync is None:
            found = self._recognised
            middle_s = 0.5 * found.clip.duration_s if found else 0.0
            clock = ClockMap(offset_s, self._rate())
            return Synchronisation(clock, BY_HAND, middle_s=middle_s)
        return moved_to(sync, offset_s, self._rate())

    def _rate(self) -> float:
        """Seconds of media per second of the log's clock."""
        found = self._recognised.found if self._recognised else None
        if found is not None and self.drift.number() == found.drift_ppm:
            return found.clock_map.rate
        return self.slow.value() * (1.0 + 1e-6 * self.drift.number())

    @property
    def slowed(self) -> float | None:
        """How slow the clip plays, where that was asked or said."""
        found = self._recognised
        is_asked = found is not None and (found.pace or found.slowed)
        value = self.slow.value()
        return value if is_asked or value != 1.0 else None

    def forget(self) -> None:
        """Begin with other files, of which nothing has been said."""
        self._recognised = None
        self.slow.blockSignals(True)
        self.slow.setValue(1.0)
        self.slow.blockSignals(False)

    def may_go_on(self) -> bool:
        """Whether everything has been confirmed."""
        if self._recognised is None:
            return False
        return self._is_sure() or self.looked.isChecked()

    def _is_sure(self) -> bool:
        choice = self.choice()
        return choice.is_confident and (
            choice.is_measured or choice.method == "embedded"
        )

    def keep(self) -> None:
        """Keep the camera's skew for its next clips, where that was wanted."""
        found = self._recognised
        is_wanted = found is not None and not found.knows_clip_clock
        if is_wanted and self.keep_skew.isChecked() and found and found.clip.camera:
            store_skew(found.clip.camera, self._late_s)

    def _shifted(self) -> Synchronisation | None:
        """The result with the skew that is wanted now."""
        sync = self._recognised.found if self._recognised else None
        if sync is None:
            return None
        clock = sync.clock_map
        by_s = sync.sound_late_s - self._late_s
        clock = dataclasses.replace(clock, offset_s=clock.offset_s + by_s)
        return dataclasses.replace(sync, clock_map=clock, sound_late_s=self._late_s)

    # --- what a person does --------------------------------------------------

    def _on_offset(self, offset_s: float) -> None:
        self.strip.set_shift(offset_s)
        self._show_verdict()

    def _on_drift(self) -> None:
        """Turn the log's curves about the middle of the clip."""
        found, before = self._recognised, self.strip.rate
        middle_s = 0.5 * found.clip.duration_s if found else 0.0
        log_s = (middle_s - self.offset.value()) / before
        self.strip.rate = self._rate()
        self.offset.setValue(middle_s - self.strip.rate * log_s)
        self._on_offset(self.offset.value())

    def _on_camera(self) -> None:
        late_s = self.camera.currentData()
        if late_s is not None:
            self.skew.setValue(1e3 * late_s)

    def _show_cameras(self) -> None:
        """Offer the sound delays that are kept, where there are some."""
        self.camera.clear()
        try:
            skews = stored_skews()
        except HapticPlayerError as problem:
            skews = {}
            self.problem.setText(translated(message_of(problem)))
        self.camera.addItem(self.tr("as kept for\u2026"), None)
        for name, late_s in skews.items():
            self.camera.addItem(name, late_s)
        self.camera.setVisible(bool(skews))

    def _on_skew(self, late_ms: float) -> None:
        by_s = self._late_s - 1e-3 * late_ms
        self._late_s = 1e-3 * late_ms
        self.offset.setValue(self.offset.value() + by_s)
        self._show_verdict()

    def _hear(self) -> None:
        """Play what is shown; where that is too long, what is around the cursor."""
        found = self._recognised
        if found is None or self._sound is not None:
            return
        begin_s, end_s = self.strip.view_s
        if end_s - begin_s > LONGEST_S:
            at_s = self.strip.cursor_s or 0.0
            begin_s, end_s = at_s - _AROUND_S, at_s + _AROUND_S
        path, ticks_s = found.clip.path, self.strip.felt_s()
        self._sound = Job(
            "", lambda _progress: pats_sound(path, begin_s, end_s, ticks_s)
        )
        self._sound.start()

    # --- what happens by itself ----------------------------------------------

    def poll(self) -> None:
        """Show the frame and play the sound that are ready."""
        self.frame.poll()
        job = self._sound
        if job is None or not job.is_done:
            return
        self._sound = None
        try:
            if job.problem is not None:
                raise job.problem
            assert job.result is not None
            snippet.play(job.result)
            self.problem.clear()
        except (HapticPlayerError, OSError) as problem:
            self.problem.setText(translated(message_of(problem)))

    def close_jobs(self) -> None:
        """Be silent, and wait for what still decodes."""
        self.frame.close_jobs()
        with contextlib.suppress(OSError):
            snippet.stop()
        if self._sound is not None:
            self._sound.join()
            self._sound = None

    def _show_verdict(self) -> None:
        found = self._recognised
        if found is None:
            return
        text, colour = self._verdict(found)
        self.verdict.setText(text)
        self.verdict.setStyleSheet(f"color: {colour};")
        self.looked.setVisible(not self._is_sure())
        self.decided.emit()

    def _verdict_by_hand(self, found: ImportPreview) -> tuple[str, str]:
        if found.pace is not None:
            text = self.tr(
                "{why}. Check below how much slower it plays than it was recorded (1: it "
                "does not), then enter the offset, or drag the log's curves."
            )
            why = translated(found.pace.why)
            return text.format(why=why[:1].upper() + why[1:]), theme.WARN
        if not found.problem:
            text = self.tr("Enter the offset, or drag the log's curves.")
            return text, theme.WARN
        text = self.tr("Could not synchronise: {why}. Enter the offset manually.")
        return text.format(why=translated(found.problem)), theme.WARN

    def _verdict(self, found: ImportPreview) -> tuple[str, str]:
        sync = found.found
        if sync is None:
            return self._verdict_by_hand(found)
        if self.choice().method == BY_HAND:
            return self.tr("The offset was set manually."), theme.WARN
        if sync.contradiction and not sync.is_confident:
            text = self.tr("Check the offset: {why}.")
            return text.format(why=translated(sync.contradiction)), theme.WARN
        if found.knows_clip_clock:
            return self._verdict_of_own_clock(found.recorder, sync.lag)
        return self._verdict_of(sync)

    def _verdict_of_own_clock(
        self, recorder: str, lag: ClockLag | None
    ) -> tuple[str, str]:
        if lag is None:
            text = self.tr(
                "{recorder} records its motion on the clip's clock; no "
                "synchronisation is needed."
            )
            return text.format(recorder=translated(recorder)), theme.GOOD
        text = self.tr("{recorder} records its motion with the clip.")
        text = text.format(recorder=translated(recorder))
        colour = theme.GOOD if lag.is_measured else theme.WARN
        return f"{text} {translated(lag.text)}", colour

    def _verdict_of(self, sync: Synchronisation) -> tuple[str, str]:
        confidence = local(f"{sync.clock_map.confidence:.2f}")
        method = translated(methods.title_of(sync.method))
        if sync.second is not None and sync.is_torn:
            text = self.tr(
                "The tap marks and the frames disagree ({method}: {offset} s, {other}: "
                "{other_offset} s). Check which is right."
            )
            offsets = [f"{one.clock_map.offset_s:.3f}" for one in (sync, sync.second)]
            return text.format(
                offset=local(offsets[0]),
                method=method,
                other_offset=local(offsets[1]),
                other=translated(methods.title_of(sync.second.method)),
            ), theme.WARN
        if sync.method == "frames":
            return self._verdict_of_frames(sync)
        if sync.method != "pats":
            text = self.tr("Synchronised: {method} (confidence {confidence}).")
            is_good = sync.is_measured and sync.is_confident
            colour = theme.GOOD if is_good else theme.WARN
            return text.format(method=method, confidence=confidence), colour
        if sync.is_confident:
            text = self.tr(
                "Tap marks found (confidence {confidence}, residual {ms} ms)."
            )
            ms = local(f"{1e3 * sync.clock_map.residual_s:.1f}")
            return text.format(confidence=confidence, ms=ms), theme.GOOD
        if sync.pats:
            text = self.tr(
                "The tap marks are uncertain (confidence {confidence}). Check "
                "that the same events line up, and drag them if not."
            )
            return text.format(confidence=confidence), theme.WARN
        return self.tr(
            "No three taps found in both sound and motion; drag manually."
        ), theme.WARN

    def _verdict_of_frames(self, sync: Synchronisation) -> tuple[str, str]:
        if sync.frames is None:
            text = self.tr(
                "The rotation in the frames fits the log nowhere. Is it the log of this "
                "clip, and the video not stabilised? Drag manually."
            )
            return text, theme.WARN
        if not sync.is_confident:
            text = self.tr(
                "The frames are uncertain (confidence {confidence}): the gyro explains "
                "{share} % of the rotation ({doubt}). Check that both line up, and drag "
                "if not."
            )
        elif sync.pats:
            text = self.tr(
                "Frames and tap marks agree, to \u00b1{ms} ms (confidence {confidence}); "
                "the gyro explains {share} % of the rotation in the frames."
            )
        else:
            text = self.tr(
                "Frames and gyro fit, to \u00b1{ms} ms (confidence {confidence}); the "
                "gyro explains {share} % of the rotation in the frames."
            )
        shown = text.format(
            confidence=local(f"{sync.clock_map.confidence:.2f}"),
            ms=local(f"{1e3 * sync.offset_sigma_s:.1f}"),
            share=local(f"{100.0 * sync.frames.explained:.0f}"),
            doubt=translated(sync.frames.doubt),
        )
        if sync.is_coarse:
            shown = f"{shown} {translated(COARSE_NOTE)}"
        return shown, theme.GOOD if sync.is_confident else theme.WARN
