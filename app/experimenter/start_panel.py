"""Checks before a session, and the operator's words for its records."""

from collections.abc import Iterable
from html import escape

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFormLayout,
    QLineEdit,
    QSpinBox,
    QWidget,
)

from app.bridge.languages import NAMES, spoken, translated
from app.experimenter.session_outputs import SessionOutputs
from app.widgets import theme
from app.widgets.buttons import set_role, text_button
from app.widgets.layout import STRETCH, fill_page, indent, paragraph, row_of
from app.widgets.texts import local, titled
from hapticplayer.playback.faults import CAUSE_TEXTS
from hapticplayer.study.orders import Balance
from hapticplayer.study.preflight import SessionCheck

translate = QCoreApplication.translate


def reason_text(reason: str) -> str:
    """Return why a trial was not valid; what is not known keeps the record's word."""
    kind, _, more = reason.partition(":")
    if kind == "fault":
        texts = {cause.name.lower(): what for cause, what in CAUSE_TEXTS.items()}
        text = translate("SessionWords", "safety stop ({0})")
        return text.format(translated(texts.get(more, more)))
    if kind == "output_fault":
        text = translate("SessionWords", "an output did not play ({0})")
        return text.format(more)
    if kind == "limit":
        text = translate("SessionWords", "{0} reached its limit")
        return text.format(more)
    if kind == "sync":
        return {
            "video": translate("SessionWords", "force and video out of sync"),
            "sound": translate("SessionWords", "force and sound out of sync"),
        }.get(more, reason)
    return {
        "ratings_incomplete": translate("SessionWords", "ratings could not be saved"),
        "paused": translate("SessionWords", "paused"),
        "repeated": translate("SessionWords", "to be repeated"),
        "skipped": translate("SessionWords", "skipped"),
        "stopped": translate("SessionWords", "session ended"),
        "force_stopped": translate("SessionWords", "the force was stopped"),
        "operator": translate("SessionWords", "stopped by the operator"),
        "escape": translate("SessionWords", "the participant pressed Esc"),
        "space": translate("SessionWords", "the participant pressed the space bar"),
        "focus_lost": translate("SessionWords", "another window took the focus"),
        "window_closed": translate("SessionWords", "the window was closed"),
        "clip_damaged": translate("SessionWords", "the clip is damaged"),
        "frames_dropped": translate("SessionWords", "frames dropped"),
        "no_sound": translate("SessionWords", "no sound"),
        "sound_missing": translate("SessionWords", "gaps in the sound"),
        "no_device": translate("SessionWords", "no device"),
        "device_lost": translate("SessionWords", "device lost"),
        "periods_missed": translate(
            "SessionWords", "missed periods in the haptic loop"
        ),
        "no_ticks": translate("SessionWords", "no data from the device"),
        "record_incomplete": translate("SessionWords", "gaps in the record"),
    }.get(reason, reason)


_WIDEST_PX = 420
_GOOD, _BAD = "\u25cf", "\u25a0"


class StartPanel(QWidget):
    """Chooses the participant, or a session to be resumed, and shows the checks."""

    started = Signal()
    clip_wanted = Signal()
    volume_chosen = Signal(int)

    def __init__(self, languages: Iterable[str], unfinished: Iterable[str]) -> None:
        super().__init__()
        self.who = QComboBox()
        self.who.setAccessibleName(self.tr("Participant"))
        self.who.addItem(self.tr("New participant"), "")
        for code in unfinished:
            self.who.addItem(self.tr("Resume {code}").format(code=code), code)
        self.language = QComboBox()
        self.language.setAccessibleName(self.tr("Language"))
        for language in languages:
            self.language.addItem(NAMES.get(language, language), language)
        self.language.setCurrentIndex(max(0, self.language.findData(spoken())))
        self.hear = text_button(
            self.tr("Play a clip"), self.tr("Check that the sound is audible")
        )
        self.hear.clicked.connect(self.clip_wanted)
        self.volume = QSpinBox()
        self.volume.setRange(0, 100)
        self.volume.setValue(100)
        self.volume.setSuffix(" %")
        indent(self.volume)
        self.volume.setAccessibleName(self.tr("Volume"))
        self.volume.setToolTip(
            self.tr("Fixed for the whole session and stored with it")
        )
        self.volume.valueChanged.connect(self.volume_chosen)
        self.sound = QCheckBox(self.tr("The sound is audible"))
        self.override = QCheckBox(self.tr("Start despite failed checks"))
        self.start = text_button(
            self.tr("Start session"), self.tr("Show the first page to the participant")
        )
        set_role(self.start, "primary")
        self.start.clicked.connect(self.started)
        self.outputs = SessionOutputs()
        self.sensor = QLineEdit()
        self.sensor.setAccessibleName(self.tr("Motion sensor of the demonstration"))
        self.sensor.setPlaceholderText(
            self.tr("none; or what you move is felt, such as wt901:/dev/ttyUSB0")
        )
        self.checks, self.balance = paragraph(), paragraph()
        self.one_screen = paragraph("", theme.DIM)
        self.one_screen.hide()
        self._lay_out()

    def _lay_out(self) -> None:
        for box in (self.who, self.language):
            box.setMaximumWidth(_WIDEST_PX)
        form = QFormLayout()
        form.addRow(self.tr("Participant"), self.who)
        form.addRow(self.tr("Language of the pages"), self.language)
        sound = (self.volume, self.hear, self.sound)
        form.addRow(self.tr("Sound"), row_of(*sound, STRETCH, spacing=10))
        form.addRow(self.tr("Devices"), self.outputs)
        form.addRow(self.tr("Demonstration"), self.sensor)
        form.addRow(self.tr("Checks"), self.checks)
        form.addRow(self.tr("Balance so far"), self.balance)
        form.setHorizontalSpacing(14)
        form.setVerticalSpacing(12)
        buttons = row_of(self.override, STRETCH, self.start)
        fill_page(self, form, self.one_screen, STRETCH, buttons)

    def choose(self, code: str, language: str) -> None:
        """Preselect what the command line said."""
        for box, value in ((self.who, code), (self.language, language)):
            row = box.findData(value)
            if value and row >= 0:
                box.setCurrentIndex(row)

    def say_one_screen(self, keys: str) -> None:
        """Say that the participant's page will cover this panel, and the way back."""
        text = self.tr(
            "There is one screen: from the start, the participant's page covers this "
            "panel. {keys} brings the panel back and pauses; participants are not told."
        )
        self.one_screen.setText(text.format(keys=keys))
        self.one_screen.show()

    def show_balance(self, balance: Balance) -> None:
        """Show how evenly conditions have been met by those who did not drop out."""
        if not balance.at_position.any():
            self.balance.setText(self.tr("this is the first participant"))
            return
        text = self.tr(
            "each condition {a} to {b} times at each position, {c} to {d} "
            "times after each other condition"
        )
        (a, b), (c, d) = (
            balance.times_at_each_position(),
            balance.times_after_each_other(),
        )
        self.balance.setText(text.format(a=a, b=b, c=c, d=d))

    def show_checks(self, checks: tuple[SessionCheck, ...]) -> None:
        """Show what was found; start only when all checks pass, or with the override."""
        names = self._names()
        lines = []
        for check in checks:
            sign = _GOOD if check.is_good else _BAD
            colour = theme.GOOD if check.is_good else theme.BAD
            found = local(translated(check.found))
            if check.remedy and not check.is_good:
                found += f" \u2013 {translated(check.remedy)}"
            lines.append(
                f"<span style='color:{colour}'>{sign}</span> "
                f"{titled(names[check.name], escape(found))}"
            )
        text = "<br>".join(lines)
        if text != self.checks.text():
            self.checks.setText(text)
        is_good = all(check.is_good for check in checks)
        self.override.setVisible(not is_good)
        self.start.setEnabled(is_good or self.override.isChecked())

    def _names(self) -> dict[str, str]:
        return {
            "device": self.tr("Device"),
            "homed": self.tr("Grip homed"),
            "scheduling": self.tr("Scheduling"),
            "sound": self.tr("Sound"),
            "volume": self.tr("Volume"),
            "screen": self.tr("Participant's screen"),
            "disk": self.tr("Disk"),
        }
