from collections.abc import Iterator

import numpy as np
import pytest
from av.video.frame import VideoFrame
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QLabel, QWidget

from app.player.video_surface import VideoSurface, letterbox
from hapticplayer.media.frames import DecodedFrame, FrameConverter

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


def noise(width: int, height: int, seed: int = 1) -> tuple[DecodedFrame, np.ndarray]:
    """A noisy frame, and its RGB."""
    rng = np.random.default_rng(seed)
    rows = rng.integers(0, 256, (height * 3 // 2, width), np.uint8)
    frame = DecodedFrame(0.0, 0.04, VideoFrame.from_ndarray(rows, "yuv420p"))
    return frame, FrameConverter().convert(frame, width, height).as_rgb()


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


def test_a_frame_of_the_target_size_is_painted_pixel_by_pixel(surface):
    box = surface.target
    frame, rgb = noise(box.width, box.height)
    surface.present(frame)
    shown = grabbed(surface)
    inside = shown[box.y : box.y + box.height, box.x : box.x + box.width]
    assert np.array_equal(inside, rgb)


def test_the_bars_are_black(surface):
    box = surface.target
    frame, _ = noise(box.width, box.height)
    surface.present(frame)
    shown = grabbed(surface)
    assert box.x > 0
    assert not shown[:, : box.x].any()
    assert not shown[:, box.x + box.width :].any()


@pytest.mark.parametrize("size", [(80, 46), (640, 360)])
def test_a_frame_of_another_size_is_scaled_to_its_place(surface, size):
    box = surface.target
    frame, _ = noise(*size)
    surface.present(frame)
    shown = grabbed(surface)
    inside = shown[box.y : box.y + box.height, box.x : box.x + box.width]
    expected = FrameConverter().convert(frame, box.width, box.height).as_rgb()
    assert np.array_equal(inside, expected)


def test_after_a_resize_the_frame_has_the_new_size(surface):
    frame, _ = noise(160, 90)
    surface.present(frame)
    surface.resize(320, 180)
    ratio = surface.devicePixelRatioF()
    assert surface.target == (0, 0, 320 * ratio, 180 * ratio)
    assert (surface.image.width(), surface.image.height()) == surface.target[2:]


def test_the_surface_is_black_without_a_frame(surface):
    frame, _ = noise(surface.target.width, surface.target.height)
    surface.present(frame)
    surface.clear()
    assert not grabbed(surface).any()


def test_a_hidden_surface_converts_and_paints_nothing(surface, qtbot, monkeypatch):
    convert, converted = FrameConverter.convert, []
    surface.hide()
    frame, _ = noise(surface.target.width, surface.target.height)
    monkeypatch.setattr(
        FrameConverter, "convert", lambda *a: converted.append(1) or convert(*a)
    )
    surface.present(frame)
    assert surface.frame is frame
    assert not converted
    surface.show()
    qtbot.waitUntil(lambda: bool(converted))


# --- within a window --------------------------------------------------------


@pytest.fixture
def inner(qtbot) -> Iterator[VideoSurface]:
    """A surface of 160 x 90 somewhere in a window."""
    window = QWidget()
    window.resize(300, 200)
    made = VideoSurface(window)
    made.setGeometry(37, 21, 160, 90)
    made.set_clip_size(160, 90)
    window.show()
    qtbot.waitExposed(window)
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


def test_a_note_upon_the_frame_stays_there(inner, qtbot):
    note = QLabel(inner)
    note.setAutoFillBackground(True)
    note.setStyleSheet("background: rgb(1, 2, 3)")
    note.setGeometry(10, 10, 30, 20)
    note.show()
    qtbot.waitUntil(lambda: in_window(inner)[15, 20].tolist() == [1, 2, 3])
    frame, rgb = noise(160, 90)
    inner.present(frame)
    inner.repaint(50, 40, 5, 5)  # a part, while the note is not painted again
    shown = in_window(inner)
    assert (shown[10:30, 10:40] == [1, 2, 3]).all()
    shown[10:30, 10:40] = rgb[10:30, 10:40]
    assert np.array_equal(shown, rgb)


def test_the_frame_sits_right_between_its_bars(inner):
    inner.setGeometry(31, 19, 200, 90)
    inner.repaint()
    assert inner.target == (20, 0, 160, 90)
    frame, rgb = noise(160, 90)
    inner.present(frame)
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
    surface.resize(surface.width() + 100, surface.height() + 100)
    surface.repaint()
    qtbot.wait(50)
    assert not [r.message for r in qtlog.records if "painte" in r.message]
