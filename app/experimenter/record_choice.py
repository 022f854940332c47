"""What is recorded with: camera, microphone, motion sensor, and where to."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QStandardPaths, Qt, Signal
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from app.bridge.languages import translated
from app.bridge.settings import RECORD, Settings
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.files import folder_dialog
from app.widgets.layout import ElidedLabel, captioned, column_of, paragraph, row_of
from app.widgets.texts import local, titled
from hapticplayer.capture.live.source import SourceRow, live_sources
from hapticplayer.errors import Progress
from hapticplayer.media.camera_modes import CameraMode, camera_modes
from hapticplayer.media.live_input import CAMERAS, MICROPHONES, device_names

_KEPT = ("camera", "mode", "microphone", "sensor", "place", "folder")


class Found(NamedTuple):
    """Cameras and microphones that are plugged in.

    Attributes:
        cameras: (name, description).
        microphones: likewise.
        modes: sizes and rates, by the name of the camera.
    """

    cameras: tuple[tuple[str, str], ...]
    microphones: tuple[tuple[str, str], ...]
    modes: Mapping[str, tuple[CameraMode, ...]] = {}


def plugged_in(_progress: Progress) -> Found:
    """What is there now; takes a moment."""
    cameras, microphones = device_names(CAMERAS), device_names(MICROPHONES)
    modes = {name: camera_modes(name) for name, _ in cameras}
    return Found(cameras, microphones, modes)


class Chosen(NamedTuple):
    """Names as the recorder takes them, of a camera with its mode; "" for what is not wanted."""

    camera: str
    microphone: str
    sensor: str
    folder: Path


class ChoiceForm(QWidget):
    """Lists what is there, remembers what was chosen, and says what is missing."""

    look_wanted = Signal()
    changed = Signal()

    def __init__(self, settings: Settings) -> None:
        super().__init__()
        self._settings, self._kept = settings, settings.table(RECORD)
        self._folder = self._text("folder") or _usual_folder()
        self.camera = self._combo(self.tr("Camera"))
        self.mode = self._combo(self.tr("Size and rate of the camera"))
        self.microphone = self._combo(self.tr("Microphone"))
        self.sensor = QComboBox()
        self.sensor.setAccessibleName(self.tr("Motion sensor"))
        self.place = QLineEdit(self._text("place"))
        self.place.setAccessibleName(self.tr("Place of the motion sensor"))
        self.missing = paragraph("", theme.DIM)
        self.missing.setTextFormat(Qt.TextFormat.PlainText)
        self.shown_folder = ElidedLabel(
            self._folder, theme.DIM, elide=Qt.TextElideMode.ElideMiddle
        )
        self._found, self._example = Found((), ()), ""
        self._fill_sensors()
        self._lay_out()
        self.show_found(self._found, is_looking=True)
        self._on_sensor()
        self.sensor.currentIndexChanged.connect(lambda _row: self._on_sensor())
        for combo in (self.camera, self.microphone):
            combo.activated.connect(lambda _row: self._show_missing())
        self.camera.activated.connect(lambda _row: self._show_modes())
        self.place.textChanged.connect(lambda _text: self.changed.emit())

    # --- building ------------------------------------------------------------

    @staticmethod
    def _combo(name: str) -> QComboBox:
        combo = QComboBox()
        combo.setAccessibleName(name)
        combo.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        combo.setMinimumContentsLength(12)
        return combo

    def _lay_out(self) -> None:
        look = text_button(
            self.tr("&Look again"), self.tr("Look for cameras and microphones again")
        )
        look.clicked.connect(self.look_wanted)
        choose = text_button(
            self.tr("Save i&n\u2026"), self.tr("The folder that takes are saved in")
        )
        choose.clicked.connect(self._choose_folder)
        camera = captioned(self.tr("&Camera"), self.camera)
        mode = captioned(self.tr("Si&ze and rate"), self.mode)
        heard = captioned(self.tr("M&icrophone"), self.microphone)
        sensor = captioned(self.tr("Motion &sensor"), self.sensor)
        place = captioned(self.tr("at &place"), self.place)
        filmed = (camera[0], (self.camera, 3), mode[0], (self.mode, 2))
        heard_by = (heard[0], (self.microphone, 1), look)
        saved = ((self.missing, 3), (self.shown_folder, 1), choose)
        column_of(
            row_of(*filmed, spacing=8),
            row_of(*heard_by, spacing=8),
            row_of(*sensor, place[0], (self.place, 1), spacing=8),
            row_of(*saved, spacing=8),
            spacing=6,
            of=self,
        )

    def _fill_sensors(self) -> None:
        self.sensor.addItem(self.tr("None"), "")
        for row in live_sources():
            self.sensor.addItem(translated(row.text).replace("`", ""), row.name)
        at = self.sensor.findData(self._text("sensor"))
        self.sensor.setCurrentIndex(max(0, at))

    # --- what is there -------------------------------------------------------

    def show_found(self, found: Found, *, is_looking: bool = False) -> None:
        """List cameras and microphones; one that was kept and is away stays listed."""
        self._found = found
        pairs = (
            (self.camera, found.cameras, "camera"),
            (self.microphone, found.microphones, "microphone"),
        )
        for combo, names, key in pairs:
            chosen = combo.currentData() if combo.count() else self._text(key, names)
            combo.clear()
            combo.addItem(self.tr("None"), "")
            for name, text in names:
                combo.addItem(titled(text, name) if text else name, name)
            if chosen and combo.findData(chosen) < 0:
                combo.addItem(chosen, chosen)
            combo.setCurrentIndex(max(0, combo.findData(chosen)))
        self._show_modes()
        self._show_missing(is_looking=is_looking)

    def _show_modes(self) -> None:
        """List what the camera offers; what is chosen stays where it offers that, too."""
        is_known = self.mode.count() > 1
        chosen = self.mode.currentData() if is_known else self._text("mode")
        self.mode.clear()
        self.mode.addItem(self.tr("As the camera offers"), "")
        for one in self._found.modes.get(self.camera.currentData(), ()):
            text = self.tr("{width} \u00d7 {height}, {rate} fps").format(
                width=one.width,
                height=one.height,
                rate=local(f"{float(one.rate_hz):.3g}"),
            )
            self.mode.addItem(text, one.options)
        self.mode.setCurrentIndex(max(0, self.mode.findData(chosen)))
        self.mode.setEnabled(self.mode.count() > 1)

    def _text(self, key: str, found: Iterable[tuple[str, str]] = ()) -> str:
        """What was kept; the first that is there where nothing was."""
        first = next((name for name, _ in found), "")
        value = self._kept.get(key, first)
        return value if isinstance(value, str) else first

    def _show_missing(self, *, is_looking: bool = False) -> None:
        lines = []
        if not self._found.cameras and not self.camera.currentData():
            lines.append(
                self.tr("No camera was found: plug one in, and press Look again.")
            )
        if not self._found.microphones and not self.microphone.currentData():
            lines.append(self.tr("No microphone was found."))
        if self._row is None:
            lines.append(
                self.tr(
                    "Without a motion sensor, motion can be suggested from the frames."
                )
            )
        self.missing.setText(
            self.tr("Looking for cameras\u2026") if is_looking else " ".join(lines)
        )
        self.changed.emit()

    # --- what is chosen ------------------------------------------------------

    @property
    def _row(self) -> SourceRow | None:
        name = self.sensor.currentData()
        return next((row for row in live_sources() if row.name == name), None)

    def _on_sensor(self) -> None:
        row = self._row
        self.place.setEnabled(row is not None)
        if self.place.text().strip() in {"", self._example}:
            self.place.setText(row.example if row else "")
        self._example = row.example if row else ""
        options = row.options.replace("`", "") if row else ""
        self.place.setToolTip(
            self.tr("Options may follow a comma: {options}").format(options=options)
            if options
            else ""
        )
        self._show_missing()

    def chosen(self) -> Chosen:
        """What there is to record with."""
        row = self._row
        place = self.place.text().strip()
        sensor = f"{row.name}:{place}" if row else ""
        return Chosen(
            (self.camera.currentData() or "") + (self.mode.currentData() or ""),
            self.microphone.currentData() or "",
            sensor,
            Path(self._folder),
        )

    def keep(self) -> None:
        """Remember it for the next time."""
        values = (
            *(self.camera.currentData(), self.mode.currentData()),
            *(self.microphone.currentData(), self.sensor.currentData()),
            *(self.place.text().strip(), self._folder),
        )
        self._settings.keep(RECORD, dict(zip(_KEPT, values, strict=True)))
        self._settings.save()

    def _choose_folder(self) -> None:
        title = self.tr("Choose where takes are saved")
        dialog = folder_dialog(self.window(), title, self._folder)
        dialog.fileSelected.connect(self._take_folder)
        dialog.open()

    def _take_folder(self, folder: str) -> None:
        self._folder = folder
        self.shown_folder.set_text(folder)
        self.changed.emit()


def _usual_folder() -> str:
    """A folder of recordings beside the person's other videos."""
    movies = QStandardPaths.StandardLocation.MoviesLocation
    return str(Path(QStandardPaths.writableLocation(movies)) / "hapticplayer")
