"""What the window shows while nothing is open."""

from PySide6.QtCore import QSize, Signal
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, column_of, paragraph, row_of
from app.widgets.theme import icon

_ICON_PX, _LEAST_ICON_PX = 72, 32  # a smaller one is left out


class EmptyPage(QWidget):
    """Six ways to begin."""

    demo_clicked = Signal()
    open_clicked = Signal()
    library_clicked = Signal()
    import_clicked = Signal()
    record_clicked = Signal()
    device_clicked = Signal()

    def __init__(self) -> None:
        super().__init__()
        title = paragraph(self.tr("Feel the motion of what you watch"), is_centred=True)
        title.setFont(theme.scaled(self.font(), 1.6, bold=True))
        text = paragraph(
            self.tr(
                "Open a sequence or a video, or drop one here. A video on its "
                "own plays without force; import it with its motion data to "
                "feel it."
            ),
            theme.DIM,
            is_centred=True,
        )
        parts = (STRETCH, _Icon(), title, text, 6, self._buttons())
        column_of(*parts, spacing=12, margins=(16, 8, 16, 8), of=self).addStretch(2)

    def _buttons(self) -> QVBoxLayout:
        self.demo = text_button(
            self.tr("Play the demo"),
            self.tr("A simulated ride by bicycle"),
            "primary",
        )
        self.open = text_button(
            self.tr("Open a sequence\u2026"), self.tr("Open a sequence folder")
        )
        self.library = text_button(
            self.tr("Library\u2026"), self.tr("Your imported sequences")
        )
        self.import_recording = text_button(
            self.tr("Import a recording\u2026"),
            self.tr("Create a sequence from a video and its motion data"),
        )
        self.record = text_button(
            self.tr("Record\u2026"),
            self.tr("Record with a camera and a motion sensor"),
        )
        self.device = text_button(
            self.tr("Choose a device\u2026"),
            self.tr("The haptic device to use; the simulated one needs no hardware"),
        )
        self.device.clicked.connect(self.device_clicked)
        self.demo.clicked.connect(self.demo_clicked)
        self.open.clicked.connect(self.open_clicked)
        self.library.clicked.connect(self.library_clicked)
        self.import_recording.clicked.connect(self.import_clicked)
        self.record.clicked.connect(self.record_clicked)
        rows = (
            (self.demo, self.open, self.library),
            (self.import_recording, self.record, self.device),
        )
        lines = [row_of(STRETCH, *row, STRETCH, spacing=10) for row in rows]
        return column_of(*lines, spacing=10)

    def minimumSizeHint(self) -> QSize:
        """Return the room for all lines at this width, without the icon."""
        least, layout = super().minimumSizeHint(), self.layout()
        if layout is None:
            return least
        high_px = layout.totalHeightForWidth(max(least.width(), self.width()))
        return QSize(least.width(), max(least.height(), high_px - _ICON_PX))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.updateGeometry()

    def give_way(self) -> None:
        """Ask for no room any more: the clip is in its place."""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)

    def set_busy(self, *, is_busy: bool) -> None:
        """Offer nothing while a piece of work runs."""
        working = (self.demo, self.open, self.library, self.import_recording)
        for button in (*working, self.record):
            button.setEnabled(not is_busy)


class _Icon(QWidget):
    """The program's icon; smaller where the window is low, or none at all."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._icon = icon("hapticplayer")

    def sizeHint(self) -> QSize:
        return QSize(_ICON_PX, _ICON_PX)

    def minimumSizeHint(self) -> QSize:
        return QSize(_LEAST_ICON_PX, 0)

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self.height() < _LEAST_ICON_PX:
            return
        with QPainter(self) as painter:
            self._icon.paint(painter, self.rect())
