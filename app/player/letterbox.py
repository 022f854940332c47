"""Where a picture lies on a surface of another shape, in device pixels."""

from typing import NamedTuple


class Box(NamedTuple):
    """A rectangle in device pixels, from the surface's top left corner."""

    x: int
    y: int
    width: int
    height: int


def letterbox(picture: tuple[int, int], area: tuple[int, int]) -> Box:
    """Return the largest box of the picture's shape in the middle of the area.

    The width is even, as the converter wants it, and rounding never makes a bar
    of a single column or row: a box within a pixel of the area fills it.

    Args:
        picture: width and height of the clip as shown, px.
        area: width and height of the surface in device pixels.
    """
    wide, high = max(1, picture[0]), max(1, picture[1])
    room_x, room_y = max(2, area[0]), max(2, area[1])
    if wide * room_y >= high * room_x:
        width, height = room_x, round(room_x * high / wide)
    else:
        width, height = round(room_y * wide / high), room_y
    if abs(room_x - width) <= 1:
        width = room_x
    if abs(room_y - height) <= 1:
        height = room_y
    width, height = max(2, width & ~1), max(2, height)
    return Box((room_x - width) // 2, (room_y - height) // 2, width, height)
