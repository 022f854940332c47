"""Converting into other people's memory gives PyAV's pixels, and touches nothing else."""

from collections import deque
from unittest import mock

import numpy as np
import pytest
from av.video.frame import VideoFrame

from hapticplayer.media import DirectPainter, direct, picture_memory, pictures, swscale
from hapticplayer.media.pictures import Picture, PictureConverter

MATRICES = {
    "untagged": 2,
    "709": 1,
    "fcc": 4,
    "601": 5,
    "170m": 6,
    "240m": 7,
    "2020": 9,
}
RANGES = {"unsaid": 0, "limited": 1, "full": 2}
UNTOUCHED = 77


def frame_of(width: int, height: int, pixel_format: str = "yuv420p") -> VideoFrame:
    rng = np.random.default_rng(width * height)
    rows = rng.integers(0, 256, (height * 3 // 2, width), np.uint8)
    return VideoFrame.from_ndarray(rows, pixel_format)


def as_decoded(frame: VideoFrame) -> Picture:
    size_px = (frame.width, frame.height)
    return PictureConverter().convert(frame, 0.0, *size_px, is_direct=True)


def as_before(frame: VideoFrame, size_px: tuple[int, int] | None = None) -> np.ndarray:
    """Return what PyAV makes of it."""
    size_px = size_px or (frame.width, frame.height)
    with mock.patch.object(pictures, "library", return_value=None):
        converter = PictureConverter()
    return converter.convert(frame, 0.0, *size_px).as_rgb()


@pytest.fixture
def painter() -> DirectPainter:
    made = DirectPainter()
    assert made.is_possible, "PyAV's wheel for Linux has swscale beside it"
    return made


def painted(painter: DirectPainter, picture: Picture) -> np.ndarray:
    memory = np.zeros((picture.height, picture.width, 4), np.uint8)
    assert painter.paint(picture, memory.data, 4 * picture.width, 0, 0)
    assert (memory[:, :, 3] == 255).all()
    return memory[:, :, 2::-1]


@pytest.mark.parametrize("pixel_format", ["yuv420p", "yuvj420p"])
@pytest.mark.parametrize("color_range", RANGES.values(), ids=RANGES)
@pytest.mark.parametrize("matrix", MATRICES.values(), ids=MATRICES)
@pytest.mark.parametrize("size_px", [(64, 48), (1280, 720)])
def test_the_pixels_are_those_of_pyav(
    painter, size_px, matrix, color_range, pixel_format
):
    frame = frame_of(*size_px, pixel_format)
    frame.colorspace, frame.color_range = matrix, color_range
    picture = as_decoded(frame)
    assert picture.decoded is not None
    assert picture.decoded[0] is frame
    assert np.array_equal(painted(painter, picture), as_before(frame))


def test_one_painter_follows_from_kind_to_kind(painter):
    for size_px, matrix in [
        ((64, 48), 1),
        ((64, 48), 5),
        ((128, 64), 5),
        ((64, 48), 1),
    ]:
        frame = frame_of(*size_px)
        frame.colorspace = matrix
        assert np.array_equal(painted(painter, as_decoded(frame)), as_before(frame))


@pytest.mark.parametrize("x", [0, 1, 2, 3, 5, 7, 13])
@pytest.mark.parametrize("y", [0, 1, 6])
@pytest.mark.parametrize("width_px", [16, 48, 112, 1360])
def test_nothing_beside_the_picture_is_written(painter, x, y, width_px):
    frame = frame_of(width_px, 18)
    memory = np.full((18 + y + 3, x + width_px + 2, 4), UNTOUCHED, np.uint8)
    stride_bytes = memory.shape[1] * 4
    assert painter.paint(as_decoded(frame), memory.data, stride_bytes, x, y)
    place = np.s_[y : y + 18, x : x + width_px]
    assert np.array_equal(memory[place][:, :, 2::-1], as_before(frame))
    memory[place] = UNTOUCHED
    assert (memory == UNTOUCHED).all()


@pytest.mark.parametrize(
    ("shape", "x", "y"),
    [
        ((47, 64), 0, 0),  # a row short
        ((48, 63), 0, 0),  # a column short
        ((48, 64), 1, 0),
        ((48, 64), 0, 1),
        ((90, 90), -1, 0),
        ((90, 90), 0, -1),
        ((90, 90), 27, 0),
    ],
)
def test_where_there_is_no_room_nothing_is_written(painter, shape, x, y):
    memory = np.full((*shape, 4), UNTOUCHED, np.uint8)
    picture = as_decoded(frame_of(64, 48))
    assert not painter.paint(picture, memory.data, 4 * shape[1], x, y)
    assert (memory == UNTOUCHED).all()


@pytest.mark.parametrize(
    ("frame", "size_px"),
    [
        (frame_of(64, 48), (32, 24)),  # scaled
        (frame_of(68, 48), (68, 48)),  # swscale would leave columns out
        (frame_of(72, 48), (72, 48)),  # and here write beside it
        (VideoFrame(64, 48, "yuv420p10le"), (64, 48)),
        (VideoFrame(64, 48, "yuv444p"), (64, 48)),
        (VideoFrame(64, 47, "yuv420p"), (64, 47)),
    ],
    ids=["scaled", "width", "other width", "10 bit", "4:4:4", "height"],
)
def test_other_pictures_come_converted(frame, size_px):
    picture = PictureConverter().convert(frame, 0.0, *size_px, is_direct=True)
    assert picture.decoded is None
    assert picture.as_rgb().shape == (size_px[1], size_px[0], 3)


def test_a_picture_as_it_was_decoded_can_be_had_whole(painter):
    frame = frame_of(64, 48)
    whole = painter.whole(as_decoded(frame))
    assert np.array_equal(whole.as_rgb(), as_before(frame))
    assert painter.whole(whole) is whole


def test_without_the_library_all_pictures_come_converted(monkeypatch):
    monkeypatch.setattr(direct, "library", lambda: None)
    painter = DirectPainter()
    assert not painter.is_possible
    memory = np.zeros((48, 64, 4), np.uint8)
    assert not painter.paint(as_decoded(frame_of(64, 48)), memory.data, 256, 0, 0)


def test_what_stands_still_is_one_picture():
    frame, again = frame_of(64, 48), frame_of(64, 48)
    converter = PictureConverter()
    first = converter.convert(frame, 0.0, 64, 48, is_direct=True)
    second = converter.convert(again, 0.1, 64, 48, is_direct=True)
    assert second.owner is first.owner
    assert second.pts_s == 0.1


class Wide:
    """A library that writes four columns too many."""

    def __init__(self, library):
        self._library = library

    def __getattr__(self, name):
        return getattr(self._library, name)

    def sws_scale(self, *arguments):
        *before, to, strides = arguments
        self._library.sws_scale(*before, type(to)(to[0] + 16), strides)
        self._library.sws_scale(*arguments)


def test_a_library_that_writes_beside_the_picture_is_not_used():
    found = swscale.library()
    assert swscale._agrees(found)
    assert not swscale._agrees(Wide(found))


@pytest.mark.parametrize("content", [None, b"", b"no library at all"])
def test_what_cannot_be_loaded_is_not_used(monkeypatch, tmp_path, content):
    if content is not None:
        (tmp_path / "av.libs").mkdir()
        (tmp_path / "av.libs" / "libswscale-1.so.9").write_bytes(content)
    monkeypatch.setattr(swscale.av, "__file__", str(tmp_path / "av" / "__init__.py"))
    assert swscale.library.__wrapped__() is None


def test_a_library_of_another_version_is_not_used(monkeypatch):
    versions = {"libswscale": (9, 0, 0)}
    monkeypatch.setattr(swscale.av, "library_versions", versions)
    assert swscale.library.__wrapped__() is None


@pytest.mark.parametrize("color_range", RANGES.values(), ids=RANGES)
@pytest.mark.parametrize("matrix", [2, 1, 9])
@pytest.mark.parametrize(
    "size_px", [(16, 9), (30, 17), (66, 50), (126, 71), (330, 187), (676, 380)]
)
def test_scaled_pixels_are_those_of_pyav(size_px, matrix, color_range):
    frame = frame_of(336, 190)
    frame.colorspace, frame.color_range = matrix, color_range
    converter = PictureConverter()
    for _ in range(2):  # the second time in memory that was used before
        picture = converter.convert(frame, 0.0, *size_px)
        assert np.array_equal(picture.as_rgb(), as_before(frame, size_px))
        del picture


def test_a_picture_that_somebody_has_keeps_its_memory():
    converter = PictureConverter()
    frames = [frame_of(336, 190 + 2 * k) for k in range(6)]
    kept = [converter.convert(frame, 0.0, 100, 56) for frame in frames]
    expected = [as_before(frame, (100, 56)) for frame in frames]
    for picture, rgb in zip(kept, expected, strict=True):
        assert np.array_equal(picture.as_rgb(), rgb)
    known = {address_of(picture) for picture in kept}
    assert len(known) == len(kept)
    kept.clear()
    converter.convert(frames[0], 0.0, 102, 56)
    converter.convert(frames[1], 0.0, 102, 58)  # other sizes between are no harm
    again = [converter.convert(frame, 0.0, 100, 56) for frame in frames]
    for picture, rgb in zip(again, expected, strict=True):
        assert np.array_equal(picture.as_rgb(), rgb)


def test_pictures_take_the_memory_of_those_that_are_gone():
    converter = PictureConverter()
    frames = [frame_of(336, 190), frame_of(336, 192)]
    queue: deque[Picture] = deque(maxlen=5)
    known = set()
    for number in range(200):
        queue.append(converter.convert(frames[number % 2], number / 30, 250, 140))
        known.add(address_of(queue[-1]))
    # the queue, the one in the making, and the one that the next is compared with
    assert len(known) <= 7


def test_nothing_is_written_behind_the_memory_of_a_picture(monkeypatch):
    guard_bytes = 64

    def watched(size_bytes: int) -> picture_memory.Memory:
        room = np.full(size_bytes + 4 * guard_bytes, UNTOUCHED, np.uint8)
        rooms.append((room, size_bytes))
        return picture_memory.Memory(room[:size_bytes], room.ctypes.data)

    rooms: list[tuple[np.ndarray, int]] = []
    monkeypatch.setattr(picture_memory, "_aligned", watched)
    for width in range(2, 200, 2):
        PictureConverter().convert(frame_of(336, 190), 0.0, width, 20)
    assert len(rooms) == 99
    for room, size_bytes in rooms:
        assert (room[size_bytes + guard_bytes :] == UNTOUCHED).all()


def address_of(picture: Picture) -> int:
    return np.frombuffer(picture.pixels, np.uint8).ctypes.data
