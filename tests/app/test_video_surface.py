from collections.abc import Iterator

import numpy as np
import pytest
from av.video.frame import VideoFrame
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QImage, QPaintEvent
from PySide6.QtWidgets import QLabel, QWidget

from app.player.letterbox import letterbox
from app.player.video_surface import VideoSurface
from hapticplayer.media import Picture
from hapticplayer.media.pictures import PictureConverter

SIDES = st.integers(2, 8000)


@given(st.tuples(SIDES, SIDES), st.tuples(SIDES, SIDES))
def test_the_picture_lies_in_the_middle_of_the_area(picture, area):
    x, y, width, height = letterbox(picture, area)
    assert x >= 0
    assert y >= 0
    assert x + width <= area[0]
    assert y + height <= area[1]
    assert abs((area[0] - width) - 2 * x) <= 1
    assert abs((area[1] - height) - 2 * y) <= 1
    assert width % 2 == 0


@given(st.tuples(SIDES, SIDES), st.tuples(SIDES, SIDES))
def test_the_picture_touches_two_sides_and_keeps_its_shape(picture, area):
    _, _, width, height = letterbox(picture, area)
    assert width >= area[0] - 1 or height >= area[1]
    # rounding to whole, even pixels and filling bars of one pixel: 3 px at most
    wide, high = picture
    exact = min(area[0] / wide, area[1] / high)
    assert abs(width - exact * wide) <= 3
    assert abs(height - exact * high) <= 3


@pytest.mark.parametrize(
    ("picture", "area", "box"),
    [
        ((1280, 720), (1280, 720), (0, 0, 1280, 720)),
        ((1280, 720), (1366, 768), (0, 0, 1366, 768)),
        ((640, 480), (1920, 1080), (240, 0, 1440, 1080)),
        ((720, 1280), (1920, 1080), (656, 0, 608, 1080)),
    ],
)
def test_letterboxes_of_common_screens(picture, area, box):
    assert letterbox(picture, area) == box


def noise(width: int, height: int, seed: int = 1) -> tuple[Picture, np.ndarray]:
    """A picture with padded rows, and its RGB."""
    stride = 4 * width + 32
    rows = np.zeros((height, stride), np.uint8)
    rgb = np.random.default_rng(seed).integers(0, 256, (height, width, 3), np.uint8)
    pixels = np.dstack([rgb[:, :, ::-1], np.full((height, width), 255, np.uint8)])
    rows[:, : 4 * width] = pixels.reshape(height, -1)
    flat = rows.reshape(-1)
    return Picture(0.0, width, height, stride, flat.data, flat), rgb


def grabbed(surface: VideoSurface) -> np.ndarray:
    image = surface.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    rows = np.frombuffer(image.constBits(), np.uint8)
    rows = rows.reshape(image.height(), image.bytesPerLine())[:, : 4 * image.width()]
    return rows.reshape(image.height(), image.width(), 4)[:, :, 2::-1].copy()


@pytest.fixture
def surface(qtbot) -> VideoSurface:
    made = VideoSurface()
    qtbot.addWidget(made)
    made.resize(400, 200)
    made.set_clip_size(160, 90)
    made.show()
    qtbot.waitExposed(made)
    return made


def test_a_picture_of_the_target_size_is_painted_pixel_by_pixel(surface):
    box = surface.target
    picture, rgb = noise(box.width, box.height)
    surface.present(picture)
    shown = grabbed(surface)
    inside = shown[box.y : box.y + box.height, box.x : box.x + box.width]
    assert np.array_equal(inside, rgb)


def test_the_bars_are_black(surface):
    box = surface.target
    picture, _ = noise(box.width, box.height)
    surface.present(picture)
    shown = grabbed(surface)
    assert box.x > 0
    assert not shown[:, : box.x].any()
    assert not shown[:, box.x + box.width :].any()


def test_a_picture_of_another_size_fills_the_same_target(surface):
    box = surface.target
    flat = np.full((45, 80, 4), 255, np.uint8).reshape(-1)
    surface.present(Picture(0.0, 80, 45, 320, flat.data, flat))
    shown = grabbed(surface)
    inside = shown[box.y : box.y + box.height, box.x : box.x + box.width]
    assert (inside == 255).all()


def test_the_target_follows_the_size(surface, qtbot):
    with qtbot.waitSignal(surface.target_changed) as told:
        surface.resize(320, 180)
    ratio = surface.devicePixelRatioF()
    assert told.args == [320 * ratio, 180 * ratio, True]
    assert surface.target == (0, 0, 320 * ratio, 180 * ratio)


def test_the_surface_is_black_without_a_picture(surface):
    picture, _ = noise(surface.target.width, surface.target.height)
    surface.present(picture)
    surface.clear()
    assert not grabbed(surface).any()


def test_a_hidden_surface_keeps_the_picture_and_paints_nothing(surface, monkeypatch):
    painted = []
    surface.hide()
    monkeypatch.setattr(surface, "repaint", lambda *_: painted.append(1))
    picture, _ = noise(surface.target.width, surface.target.height)
    surface.present(picture)
    assert not painted
    assert surface.has_picture_of_target_size


# --- pictures that come as they were decoded --------------------------------


def decoded(width: int, height: int, seed: int = 2) -> tuple[Picture, np.ndarray]:
    """A picture that is yet to be converted, and its RGB."""
    rng = np.random.default_rng(seed)
    rows = rng.integers(0, 256, (height * 3 // 2, width), np.uint8)
    frame = VideoFrame.from_ndarray(rows, "yuv420p")
    rgb = PictureConverter().convert(frame, 0.0, width, height).as_rgb()
    return PictureConverter().convert(frame, 0.0, width, height, is_direct=True), rgb


class Copied(VideoSurface):
    """Counts what had to be copied."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.copies = self.paints = 0

    def paintEvent(self, event: QPaintEvent) -> None:
        self.paints += 1
        super().paintEvent(event)

    def _draw(self, *arguments) -> None:
        self.copies += 1
        super()._draw(*arguments)


@pytest.fixture
def inner(qtbot) -> Iterator[Copied]:
    """A surface of 160 x 90 somewhere in a window."""
    window = QWidget()
    window.resize(300, 200)
    made = Copied(window)
    made.setGeometry(37, 21, 160, 90)
    made.set_clip_size(160, 90)
    window.show()
    qtbot.waitExposed(window)
    qtbot.waitUntil(lambda: made.paints > 0)
    made.copies = made.paints = 0
    yield made
    window.close()


def in_window(surface: VideoSurface) -> np.ndarray:
    """What the window's own memory holds where the surface is."""
    shown = surface.window().backingStore().paintDevice()
    assert isinstance(shown, QImage)
    rows = np.frombuffer(shown.constBits(), np.uint8)
    rows = rows.reshape(shown.height(), shown.bytesPerLine())
    pixels = rows[:, : 4 * shown.width()].reshape(shown.height(), shown.width(), 4)
    x, y, width, height = surface.geometry().getRect()
    return pixels[y : y + height, x : x + width, 2::-1].copy()


def test_a_decoded_picture_is_converted_in_its_place(inner):
    picture, rgb = decoded(160, 90)
    inner.present(picture)
    assert (inner.paints, inner.copies) == (1, 0)
    assert np.array_equal(in_window(inner), rgb)


def test_a_decoded_picture_is_there_for_who_looks_at_its_image(inner):
    picture, rgb = decoded(160, 90)
    inner.present(picture)
    image = inner.image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(90, -1)[:, : 3 * 160]
    assert np.array_equal(rows.reshape(90, 160, 3), rgb)


def test_a_decoded_picture_of_another_size_is_scaled(inner):
    picture, _ = decoded(80, 46)
    inner.present(picture)
    assert inner.copies == 1
    assert in_window(inner).any()


def test_what_lies_upon_the_picture_stays_there(inner, qtbot):
    note = QLabel(inner)
    note.setAutoFillBackground(True)
    note.setStyleSheet("background: rgb(1, 2, 3)")
    note.setGeometry(10, 10, 30, 20)
    note.show()
    qtbot.waitUntil(lambda: in_window(inner)[15, 20].tolist() == [1, 2, 3])
    picture, rgb = decoded(160, 90)
    inner.present(picture)
    inner.repaint(50, 40, 5, 5)  # a part, while the note is not painted anew
    shown = in_window(inner)
    assert (shown[10:30, 10:40] == [1, 2, 3]).all()
    shown[10:30, 10:40] = rgb[10:30, 10:40]
    assert np.array_equal(shown, rgb)


def test_who_always_has_to_copy_asks_for_pixels(inner, qtbot):
    told = []
    inner.target_changed.connect(lambda *what: told.append(what))
    for k in range(12):
        inner._picture = decoded(160, 90, seed=k)[0]
        inner.repaint(0, 0, 20, 20)
    assert told == [(160, 90, False)]
    inner.setGeometry(0, 0, 240, 135)
    qtbot.waitUntil(lambda: len(told) == 2)
    assert told[1] == (240, 134, True) or told[1] == (240, 135, True)


def test_a_decoded_picture_sits_right_between_its_bars(inner):
    inner.setGeometry(31, 19, 200, 90)
    inner.repaint()
    inner.copies = 0
    assert inner.target == (20, 0, 160, 90)
    picture, rgb = decoded(160, 90)
    inner.present(picture)
    assert inner.copies == 0
    shown = in_window(inner)
    assert np.array_equal(shown[:, 20:180], rgb)
    assert not shown[:, :20].any()
    assert not shown[:, 180:].any()


def test_a_fault_while_painting_leaves_no_painter_behind(qtbot, qtlog, monkeypatch):
    """Qt dies of one; what was raised keeps its frames, and with them the painter."""
    surface = VideoSurface()
    qtbot.addWidget(surface)
    surface.show()
    qtbot.waitExposed(surface)

    def fail(_self, _painter, _region):
        raise ValueError("a fault of ours")

    with qtbot.captureExceptions() as raised, monkeypatch.context() as patch:
        patch.setattr(VideoSurface, "_paint", fail)
        surface.update()
        qtbot.waitUntil(lambda: bool(raised))
    assert "a fault of ours" in str(raised[0][1])
    with qtbot.waitSignal(surface.target_changed):
        surface.resize(surface.width() + 100, surface.height() + 100)
    surface.repaint()
    qtbot.wait(50)
    assert not [r.message for r in qtlog.records if "painte" in r.message]
