"""What the seek bar shows of the clip: its force as a strip, and thumbnails."""

from bisect import bisect_right
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QLabel, QWidget

from app.bridge.jobs import Job, in_child
from app.widgets.layout import column_of
from app.widgets.seek_slider import SeekSlider
from app.widgets.texts import time_text
from hapticplayer.devices import NO_DEVICE
from hapticplayer.media.thumbnails import Thumbnail, thumbnails
from hapticplayer.model import ForceTrack
from hapticplayer.playback.player import Player

BINS = 600
LEAST_PEAK_N = 1.0  # a clip with little force is not drawn as a strong one
# From nearly nothing to strong along one line of growing lightness (after viridis and
# inferno): distinguishable with every kind of colour vision, and in grey.
_STOPS = np.array(
    [[38, 44, 52, 255], [94, 60, 110, 255], [196, 84, 72, 255], [252, 208, 96, 255]],
    dtype=float,
)


def heat_of(
    track: ForceTrack, duration_s: float, bins: int = BINS
) -> NDArray[np.float64]:
    """Return the largest amount of the force in each part of the clip (bins,), N."""
    edges_s = np.linspace(0.0, duration_s, bins + 1)
    at_edges = np.linalg.norm(track.at(edges_s), axis=1)
    # within a part a linear or held track is largest at one of its own times
    peaks: NDArray[np.float64] = np.maximum(at_edges[:-1], at_edges[1:])
    rows = np.floor(track.time_s / duration_s * bins).astype(np.intp)
    is_inside = (rows >= 0) & (rows < bins)
    amounts = np.linalg.norm(track.force_n, axis=1)
    np.maximum.at(peaks, rows[is_inside], amounts[is_inside])
    return peaks


def heat_image(heat_n: NDArray[np.float64]) -> QImage:
    """Return an image of one row; the strongest force of the clip is the brightest."""
    share = heat_n / max(LEAST_PEAK_N, float(heat_n.max(initial=0.0)))
    grid = np.linspace(0.0, 1.0, len(_STOPS))
    rgba = np.stack([np.interp(share, grid, _STOPS[:, k]) for k in range(4)], axis=1)
    pixels = np.ascontiguousarray(np.round(rgba).astype(np.uint8))
    width = len(pixels)
    image = QImage(pixels.data, width, 1, 4 * width, QImage.Format.Format_RGBA8888)
    return image.copy()  # which owns its memory


HEIGHT_PX = 90
COUNT, LEAST_STEP_S = 60, 1.0
_GAP_PX = 6
_STYLE = """
QWidget#thumbnail { background: #0c0e11; border: 1px solid #59636f; border-radius: 4px; }
QLabel { color: #ffffff; }
"""


class ThumbnailTip(QWidget):
    """A thumbnail and its time, above the seek bar."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setObjectName("thumbnail")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setStyleSheet(_STYLE)
        self.image, self.time = QLabel(), QLabel()
        self.time.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column_of(self.image, self.time, spacing=2, margins=(4, 4, 4, 2), of=self)
        self._over = over
        self.hide()

    def show_at(self, middle: QPoint, text: str, image: QPixmap | None) -> None:
        """Show it with the middle of its lower edge at a point of its parent."""
        self.time.setText(text)
        self.image.setVisible(image is not None)
        if image is not None:
            self.image.setPixmap(image)
        self.adjustSize()
        room_px = self._over.width() - self.width()
        left = min(max(0, middle.x() - self.width() // 2), max(0, room_px))
        self.move(left, middle.y() - self.height() - _GAP_PX)
        self.show()
        self.raise_()


class Thumbnails(QObject):
    """Decodes them when the pointer first reaches the seek bar, in another process.

    While a real device is moved nothing is decoded: only the time is shown.
    """

    def __init__(self, slider: SeekSlider, over: QWidget, player: Player) -> None:
        super().__init__(over)
        self._slider, self._player = slider, player
        self.tip, self._over = ThumbnailTip(over), over
        self._path: Path | None = None
        self._at_s = 0.0  # where the pointer is
        self._job: Job[list[Thumbnail]] | None = None
        self._made: list[tuple[float, QPixmap]] = []
        slider.hovered.connect(self._on_hovered)

    @property
    def is_busy(self) -> bool:
        """Whether thumbnails are being decoded."""
        return self._job is not None

    def forget(self) -> None:
        """Another clip is open."""
        self._cancel()
        self._path, self._made = None, []
        self.tip.hide()

    def poll(self) -> None:
        """Take over what has been decoded; what failed is simply not shown."""
        job = self._job
        if job is not None and job.is_done:
            self._job = None
            self._made = [(t.media_s, _pixmap(t)) for t in job.result or []]
            if self.tip.isVisible():  # the pointer waits for it
                self._on_hovered(self._at_s)

    def close(self) -> None:
        """End what runs."""
        job = self._job
        self._cancel()
        if job is not None:
            job.join()

    def _cancel(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None

    def _on_hovered(self, media_s: float) -> None:
        if media_s < 0.0:
            self.tip.hide()
            return
        self._begin()
        self._at_s = media_s
        at = QPoint(round(self._slider.x_of(media_s)), 0)
        middle = self._slider.mapTo(self._over, at)
        self.tip.show_at(middle, time_text(media_s), self._image_at(media_s))

    def _image_at(self, media_s: float) -> QPixmap | None:
        row = bisect_right([time_s for time_s, _ in self._made], media_s) - 1
        return self._made[max(0, row)][1] if self._made else None

    def _begin(self) -> None:
        source = self._player.snapshot().source
        if source is None or source.clip.remote or self._is_felt():
            return
        if self._path == source.clip.path:
            return
        self._path = path = source.clip.path
        duration_s = source.clip.duration_s
        count = max(1, min(COUNT, int(duration_s / LEAST_STEP_S)))
        times_s = [duration_s * k / count for k in range(count)]
        self._job = Job(
            "thumbnails",
            lambda progress: in_child(
                thumbnails, path, times_s, HEIGHT_PX, progress=progress
            ),
        )
        self._job.start()

    def _is_felt(self) -> bool:
        now = self._player.snapshot()
        return now.is_playing and now.leading.name not in (NO_DEVICE, "simulated")


def _pixmap(made: Thumbnail) -> QPixmap:
    image = QImage(
        made.rgb, made.width, made.height, 3 * made.width, QImage.Format.Format_RGB888
    )
    return QPixmap.fromImage(image)
