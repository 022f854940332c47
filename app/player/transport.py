"""The controls under the video."""

from collections.abc import Iterable

from PySide6.QtCore import QCoreApplication, QSize, Qt, Signal
from PySide6.QtGui import QStandardItemModel
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QLabel,
    QLayout,
    QPushButton,
    QSizePolicy,
    QSlider,
)

from app.bridge.languages import translated
from app.player.choices import Choice
from app.widgets import theme
from app.widgets.buttons import ICON_PX, set_role, text_button, tool_button
from app.widgets.layout import STRETCH, ElidedLabel, captioned, column_of, row_of
from app.widgets.seek_slider import SeekSlider
from app.widgets.texts import local, position_text
from app.widgets.theme import control_icon
from hapticplayer.clock import Clock
from hapticplayer.errors import UsageError, message_of
from hapticplayer.playback.latch import StopLatch

translate = QCoreApplication.translate

_COMBO_PX, _LEAST_CHARACTERS = 170, 6
_VOLUME_PX, _LEAST_VOLUME_PX, _VOLUME_PAGE = 72, 30, 10
_BESIDE_STOP_PX = 52
_BEFORE_THE_GAP = 100  # stretch: the lists grow to their full width first


class Transport(QFrame):
    """Position, play and pause, stop, feedback, device, fullscreen.

    Signals:
        play_clicked, stop_clicked, fullscreen_clicked: the buttons.
        sought: a person wants to be at this time, s.
        volume_chosen, mute_clicked: per cent, and the button beside it.
        feedback_chosen, device_chosen: the engine's name of the choice.
        device_opening: the list of devices is about to be looked at.
    """

    play_clicked = Signal()
    stop_clicked = Signal()
    fullscreen_clicked = Signal()
    sought = Signal(float)
    volume_chosen = Signal(int)
    mute_clicked = Signal()
    feedback_chosen = Signal(str)
    device_chosen = Signal(str)
    device_opening = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setStyleSheet(
            f"Transport {{ background: {theme.PANEL}; "
            f"border: 0; border-top: 1px solid {theme.BORDER}; }}"
        )
        self._duration_s = 0.0
        self.slider = SeekSlider()
        self.slider.setAccessibleName(self.tr("Position"))
        self.slider.setToolTip(
            self.tr(
                "Position in the clip: click or drag. The strip below shows how strong the "
                "force is: the brighter, the stronger"
            )
        )
        self.slider.sought.connect(self.sought)
        self.play = tool_button("play", "", "")
        self.play.clicked.connect(self.play_clicked)
        self.stop = text_button("", "", "stop")
        self.stop.clicked.connect(self.stop_clicked)
        self.time = ElidedLabel()
        self.time.setAccessibleName(self.tr("Time"))
        self.speed = QLabel()
        self.speed.setToolTip(self.tr("Playback speed (Backspace: normal speed)"))
        self.speed.hide()
        self.mute = tool_button("volume", "", "")
        self.mute.clicked.connect(self.mute_clicked)
        self.volume = self._volume_slider()
        self.feedback = self._combo(self.tr("Feedback"), self.tr("Force track to play"))
        self.feedback.activated.connect(
            lambda _: self.feedback_chosen.emit(self.feedback.currentData())
        )
        self.device = self._combo(self.tr("Device"), self.tr("Haptic device"))
        self.device.opening.connect(self.device_opening)
        self.device.activated.connect(
            lambda _: self.device_chosen.emit(self.device.currentData())
        )
        self.fullscreen = tool_button(
            "fullscreen",
            self.tr("Fullscreen"),
            self.tr("Fullscreen (F)"),
        )
        self.fullscreen.clicked.connect(self.fullscreen_clicked)
        self._lay_out()
        self.show_playing(is_playing=False)
        self.show_stopped(is_stopped=False)
        self.show_volume(100, is_muted=False)
        self.set_duration(0.0)

    def _lay_out(self) -> None:
        fix_stop_width(self.stop)
        controls = row_of(
            *(self.play, self.stop, self.time, self.speed, STRETCH),
            *(self.mute, self.volume, 6),
            *((_captioned(self.feedback), _BEFORE_THE_GAP), 6),
            *((_captioned(self.device), _BEFORE_THE_GAP), 6),
            self.fullscreen,
            spacing=10,
            margins=(4, 0, 0, 0),
        )
        beside = (self.play, self.stop, self.time, self.speed, self.mute, self.volume)
        for part in (*beside, self.fullscreen):  # captions are only above lists
            controls.setAlignment(part, Qt.AlignmentFlag.AlignBottom)
        for one in (self.time, self.speed, self.volume, self.feedback, self.device):
            one.setMinimumHeight(self.stop.sizeHint().height())
        column_of(self.slider, controls, spacing=4, margins=(8, 4, 12, 8), of=self)

    def _combo(self, name: str, tip: str) -> "Combo":
        combo = Combo()
        combo.setAccessibleName(name)
        combo.setToolTip(tip)
        combo.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        # long names of tracks must not widen the window
        combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        combo.setMinimumContentsLength(_LEAST_CHARACTERS)
        combo.setMaximumWidth(_COMBO_PX)
        combo.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        return combo

    def _volume_slider(self) -> QSlider:
        slider = QSlider(Qt.Orientation.Horizontal)
        slider.setRange(0, 100)
        slider.setPageStep(_VOLUME_PAGE)
        slider.setMinimumWidth(_LEAST_VOLUME_PX)
        slider.setMaximumWidth(_VOLUME_PX)
        slider.setAccessibleName(self.tr("Volume"))
        slider.setToolTip(self.tr("Volume (9 and 0)"))
        slider.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        slider.valueChanged.connect(self.volume_chosen)
        return slider

    def show_volume(self, percent: int, *, is_muted: bool) -> None:
        """Show how loud it is."""
        self.volume.blockSignals(True)
        self.volume.setValue(percent)
        self.volume.blockSignals(False)
        is_silent = is_muted or percent == 0
        self.mute.setIcon(
            control_icon("muted" if is_silent else "volume", ICON_PX, theme.TEXT)
        )
        name = self.tr("Sound on") if is_muted else self.tr("Mute")
        self.mute.setAccessibleName(name)
        self.mute.setToolTip(self.tr("{name} (M)").format(name=name))

    def show_speed(self, speed: float) -> None:
        self.speed.setText(local(f"{speed:.2f}\u00d7"))
        self.speed.setVisible(abs(speed - 1.0) > 1e-3)

    def set_duration(self, duration_s: float) -> None:
        """Say how long the clip is; without one there is nothing to control."""
        self._duration_s = duration_s
        self.slider.set_duration(duration_s)
        for widget in (self.play, self.feedback, self.fullscreen):
            widget.setEnabled(duration_s > 0.0)
        self._show_time(0.0)

    def follow(self, media_s: float) -> None:
        self.slider.follow(media_s)
        self._show_time(media_s)

    def _show_time(self, media_s: float) -> None:
        text = position_text(media_s, self._duration_s)
        is_longer = len(text) != len(self.time.text())
        self.time.set_text(text)
        if is_longer:
            widest = "".join("8" if c.isdigit() else c for c in text)
            self.time.fix_width(self.time.fontMetrics().horizontalAdvance(widest) + 4)

    def show_playing(self, *, is_playing: bool) -> None:
        offer_play(self.play, is_playing=is_playing)

    def show_stopped(self, *, is_stopped: bool) -> None:
        """Offer to stop the force, or to bring it back after a stop."""
        offer_stop(self.stop, is_stopped=is_stopped)

    def set_feedbacks(self, offered: Iterable[Choice]) -> None:
        """Offer these force tracks."""
        _fill(self.feedback, offered)

    def select_feedback(self, name: str) -> None:
        """Show which force track plays."""
        self.feedback.setCurrentIndex(self.feedback.findData(name))

    def set_devices(self, offered: Iterable[Choice]) -> None:
        _fill(self.device, offered)

    def offers_device(self, name: str) -> bool:
        return self.device.findData(name) >= 0

    def select_device(self, name: str) -> None:
        """Show which device is moved."""
        self.device.setCurrentIndex(self.device.findData(name))


class Combo(QComboBox):
    """A choice that says when its list is about to be looked at."""

    opening = Signal()

    def showPopup(self) -> None:  # noqa: N802 - Qt's name
        self.opening.emit()
        super().showPopup()


def _fill(combo: QComboBox, offered: Iterable[Choice]) -> None:
    combo.clear()
    for row, choice in enumerate(offered):
        combo.addItem(choice.text, choice.name)
        tip = choice.refusal or choice.text
        combo.setItemData(row, tip, Qt.ItemDataRole.ToolTipRole)
        model = combo.model()
        if choice.refusal and isinstance(model, QStandardItemModel):
            model.item(row).setEnabled(False)


def _captioned(combo: QComboBox) -> QLayout:
    """A list below its caption, which needs no room beside it on a narrow screen."""
    label, _ = captioned(combo.accessibleName(), combo)
    label.setStyleSheet(f"color: {theme.DIM};")
    label.setFont(theme.scaled(combo.font(), 0.85))
    return column_of(label, combo, spacing=0)


def offer_play(button: QPushButton, *, is_playing: bool) -> None:
    """Let a button offer to pause or to play."""
    name = (
        translate("Transport", "Pause")
        if is_playing
        else translate("Transport", "Play")
    )
    button.setIcon(control_icon("pause" if is_playing else "play", ICON_PX, theme.TEXT))
    button.setAccessibleName(name)
    button.setToolTip(translate("Transport", "{name} (Space)").format(name=name))


def offer_stop(button: QPushButton, *, is_stopped: bool) -> None:
    """Let a button offer to stop the force, or to bring it back after a stop."""
    button.setText(_stop_text(is_stopped=is_stopped))
    button.setIcon(control_icon("rearm" if is_stopped else "stop", ICON_PX, "#ffffff"))
    button.setIconSize(QSize(ICON_PX, ICON_PX))
    set_role(button, "rearm" if is_stopped else "stop")
    button.setToolTip(
        translate("Transport", "The force was stopped: re-arm it (Ctrl+R)")
        if is_stopped
        else translate("Transport", "Stop the force immediately and pause (Esc)")
    )
    button.setAccessibleName(
        translate("Transport", "Re-arm the force")
        if is_stopped
        else translate("Transport", "Stop the force")
    )


def rearm_problem(latch: StopLatch, clock: Clock) -> str:
    """Re-arm a stop as a person asks; return why that is not possible, "" if it is."""
    try:
        latch.rearm(clock.now_s())
    except UsageError as problem:
        return translated(message_of(problem))
    return ""


def fix_stop_width(button: QPushButton) -> None:
    """Give such a button room for both of its texts."""
    texts = (_stop_text(is_stopped=False), _stop_text(is_stopped=True))
    font = button.font()
    font.setBold(True)
    button.setFont(font)
    metrics = button.fontMetrics()
    widest_px = max(metrics.horizontalAdvance(text) for text in texts)
    button.setFixedWidth(widest_px + _BESIDE_STOP_PX)


def _stop_text(*, is_stopped: bool) -> str:
    if is_stopped:
        return translate("Transport", "Re-arm")
    return translate("Transport", "STOP")
