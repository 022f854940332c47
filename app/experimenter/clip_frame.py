"""The picture of a clip at a time that somebody points at."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

from app.bridge.jobs import Job
from app.player.times import time_text
from app.widgets import theme
from hapticplayer.media.thumbnails import Thumbnail, thumbnails

HEIGHT_PX = 150


class ClipFrame(QWidget):
    """Decodes one picture at a time in a thread; of several wishes the last counts."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.picture, self.time = QLabel(), QLabel()
        self.picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.picture.setFixedHeight(HEIGHT_PX)
        self.picture.setMinimumWidth(HEIGHT_PX * 16 // 9)
        self.picture.setStyleSheet(f"background: {theme.BACKGROUND};")
        self.picture.setAccessibleName(self.tr("Picture at the cursor"))
        self.time.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.time.setStyleSheet(f"color: {theme.DIM};")
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self.picture)
        column.addWidget(self.time)
        self.shown_s: float | None = None
        self._path: Path | None = None
        self._wanted_s: float | None = None
        self._job: Job[list[Thumbnail]] | None = None

    def use(self, path: Path | None) -> None:
        """Show pictures of another clip from now on."""
        self._path, self._wanted_s, self.shown_s = path, None, None
        self.picture.clear()
        self.time.clear()

    def want(self, media_s: float) -> None:
        """Show the picture at a time as soon as it is decoded."""
        self._wanted_s = max(0.0, media_s)

    def poll(self) -> None:
        """Take over what is decoded, and begin with what is wanted."""
        job = self._job
        if job is not None and job.is_done:
            self._job = None
            self._show(job.result or [])
        if self._job is None and self._wanted_s is not None and self._path is not None:
            path, at_s, self._wanted_s = self._path, self._wanted_s, None
            height_px = round(HEIGHT_PX * self.devicePixelRatioF())
            self._job = Job(
                "", lambda told: thumbnails(path, [at_s], height_px, progress=told)
            )
            self._job.start()

    def close_jobs(self) -> None:
        """Wait for the picture that is being decoded."""
        if self._job is not None:
            self._job.cancel()
            self._job.join()
            self._job = None

    def _show(self, made: list[Thumbnail]) -> None:
        for one in made:
            kind = QImage.Format.Format_RGB888
            image = QImage(one.rgb, one.width, one.height, 3 * one.width, kind)
            shown = QPixmap.fromImage(image)
            shown.setDevicePixelRatio(self.devicePixelRatioF())
            self.picture.setPixmap(shown)
            self.time.setText(time_text(one.media_s, digits=3))
            self.shown_s = one.media_s
