"""What the shipped demo offers when it has come to its end."""

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QWidget

from app.player.session import Session
from app.player.video_surface import VideoSurface
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import STRETCH, column_of, paragraph, row_of
from hapticplayer.playback.phases import Phase
from hapticplayer.shipped import DEMO

_WIDEST_PX, _AROUND_PX = 560, 16


class DemoEnd(QWidget):
    """Three ways to go on, over the last frame; goes when anything is played or opened."""

    import_clicked = Signal()
    device_clicked = Signal()

    def __init__(self, session: Session, surface: VideoSurface) -> None:
        super().__init__(surface)
        self._session, self._surface = session, surface
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.Window)
        self.setCursor(Qt.CursorShape.ArrowCursor)
        self.setAccessibleName(self.tr("End of the demo"))
        text = paragraph(self.tr("That was the demo. What next?"), is_centred=True)
        text.setFont(theme.scaled(self.font(), 1.3, bold=True))
        self.again = text_button(
            self.tr("Play again"),
            self.tr("Play the demo from its beginning"),
            "primary",
        )
        self.bring_in = text_button(
            self.tr("Import your own\u2026"),
            self.tr("Create a sequence from a video and its motion data"),
        )
        self.device = text_button(
            self.tr("Choose a device\u2026"),
            self.tr("The haptic device to use; the simulated one needs no hardware"),
        )
        buttons = (self.again, self.bring_in, self.device)
        for button in buttons:
            button.setAutoDefault(True)  # Enter, too
        self.again.clicked.connect(self._play)
        self.bring_in.clicked.connect(self.import_clicked)
        self.device.clicked.connect(self.device_clicked)
        row = row_of(STRETCH, *buttons, STRETCH, spacing=10)
        column_of(text, row, spacing=12, margins=(18, 14, 18, 16), of=self)
        surface.installEventFilter(self)
        session.changed.connect(self._follow)
        session.opening.connect(self.hide)
        self.hide()

    def offer(self) -> None:
        """Ask, if it is the demo that has ended."""
        source = self._session.player.snapshot().source
        if source is None or source.path != DEMO:
            return
        self._place()
        self.show()
        self.raise_()
        if self.isActiveWindow():  # a dialog keeps the keyboard
            self.again.setFocus()

    def _play(self) -> None:
        self.hide()
        self._session.player.seek(0.0)
        self._session.player.play()

    def _follow(self) -> None:
        if self._session.player.snapshot().phase is not Phase.ENDED:
            self.hide()

    def hideEvent(self, _event: QEvent) -> None:
        """Give the keyboard back to the video."""
        if self.isAncestorOf(QApplication.focusWidget() or self._surface):
            self._surface.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Follow the size of the video."""
        if event.type() == QEvent.Type.Resize:
            self._place()
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        room = self._surface.rect()
        wide_px = min(_WIDEST_PX, room.width() - 2 * _AROUND_PX)
        wide_px = max(wide_px, self.minimumSizeHint().width())
        self.resize(wide_px, self.sizeHint().height())
        self.move(room.center() - self.rect().center())
