"""Sizes and frame rates that a camera offers, asked of its driver (Video4Linux 2)."""

import errno
import fcntl
import os
import struct
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

_FORMATS = {
    b"MJPG": "mjpeg",
    b"JPEG": "mjpeg",
    b"H264": "h264",
    b"YUYV": "yuyv422",
    b"UYVY": "uyvy422",
    b"NV12": "nv12",
    b"YU12": "yuv420p",
    b"RGB3": "rgb24",
    b"BGR3": "bgr24",
}
"""FFmpeg's names, the preferred first: each JPEG is a frame by itself, raw ones are encoded."""

_NAMES = tuple(dict.fromkeys(_FORMATS.values()))
_CAPTURE, _DISCRETE = 1, 1
_MOST = 100  # of a list: a driver that never ends it is not believed
_USUAL_SIZES = ((640, 480), (1280, 720), (1920, 1080))
_USUAL_RATES_HZ = tuple(map(Fraction, (15, 30, 60)))

# <linux/videodev2.h>: numbers of the requests, and what stands first in their structures
_ENUM_FMT, _ENUM_SIZES, _ENUM_INTERVALS = 0xC0405602, 0xC02C564A, 0xC034564B
_FMT, _SIZE, _INTERVAL = "=3I32s4s4I", "=I4sI6I2I", "=I4s3I6I2I"


class CameraMode(NamedTuple):
    """A size and a rate, with the name of the best format that has them."""

    width: int
    height: int
    rate_hz: Fraction
    format: str

    @property
    def options(self) -> str:
        """What follows the camera's name for `LiveInput`."""
        size = f"{self.width}x{self.height}"
        return f",input_format={self.format},video_size={size},framerate={self.rate_hz}"


def camera_modes(device: str) -> tuple[CameraMode, ...]:
    """The largest first; () where it cannot be asked."""
    try:
        camera = os.open(device, os.O_RDWR | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return ()
    try:
        found = list(_modes(camera))
    except OSError:  # it was unplugged meanwhile
        return ()
    finally:
        os.close(camera)
    found.sort(key=lambda one: _NAMES.index(one.format), reverse=True)
    best = {one[:3]: one for one in found}  # the last one stays
    return tuple(
        sorted(best.values(), key=lambda one: (one[0] * one[1], *one), reverse=True)
    )


def _modes(camera: int) -> Iterator[CameraMode]:
    wanted = struct.pack("=I", _CAPTURE)
    for _, _, _, _, fourcc, *_ in _listed(camera, _ENUM_FMT, _FMT, wanted):
        if (name := _FORMATS.get(fourcc)) is None:
            continue
        for wide, high in _sizes(camera, fourcc):
            for rate_hz in _rates_hz(camera, fourcc + struct.pack("=2I", wide, high)):
                yield CameraMode(wide, high, rate_hz, name)


def _sizes(camera: int, fourcc: bytes) -> Iterator[tuple[int, int]]:
    for _, _, kind, *of, _, _ in _listed(camera, _ENUM_SIZES, _SIZE, fourcc):
        if kind == _DISCRETE:
            yield of[0], of[1]
            continue
        least_w, most_w, _, least_h, most_h, _ = of
        for wide, high in _USUAL_SIZES:
            if least_w <= wide <= most_w and least_h <= high <= most_h:
                yield wide, high


def _rates_hz(camera: int, wanted: bytes) -> Iterator[Fraction]:
    rows = _listed(camera, _ENUM_INTERVALS, _INTERVAL, wanted)
    for _, _, _, _, kind, *of, _, _ in rows:
        is_one = kind == _DISCRETE
        ends = (of[1], of[0]), (of[1], of[0]) if is_one else (of[3], of[2])
        if not all(map(all, ends)):
            continue
        most_hz, least_hz = (Fraction(*end) for end in ends)
        if is_one:
            yield most_hz
        else:
            yield from (hz for hz in _USUAL_RATES_HZ if least_hz <= hz <= most_hz)


def _listed(
    camera: int, request: int, layout: str, wanted: bytes
) -> Iterator[tuple[Any, ...]]:
    """The entries of a list, each asked for by its number and what is wanted."""
    room = struct.calcsize(layout)
    for index in range(_MOST):
        asked = (struct.pack("=I", index) + wanted).ljust(room, b"\0")
        try:
            answer = fcntl.ioctl(camera, request, asked)
        except OSError as problem:
            if problem.errno in {errno.EINVAL, errno.ENOTTY}:  # the end, or no camera
                return
            raise
        yield struct.unpack(layout, answer)
