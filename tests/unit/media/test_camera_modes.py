"""What a driver answers to the requests of <linux/videodev2.h>, packed by hand."""

import errno
import fcntl
import struct
from fractions import Fraction

import pytest

from hapticplayer.media.camera_modes import camera_modes

HD, VGA = (1280, 720), (640, 480)
# of a webcam: formats, their sizes, and intervals of each as numerator, denominator
WEBCAM = {
    b"YUYV": {VGA: [(1, 30), (1, 15)], HD: [(1, 10)]},
    b"PWC1": {VGA: [(1, 60)]},
    b"MJPG": {HD: [(1001, 30000), (1, 10)], VGA: [(1, 30)]},
}


def answers(offered):
    """The driver of a camera that offers these; 0xC0..: as `strace` shows the requests."""

    def ask(_camera, request, asked):
        (index,) = struct.unpack_from("=I", asked)
        if request == 0xC0405602:
            assert len(asked) == 64
            assert struct.unpack_from("=I", asked, 4) == (1,)
            fourcc = entry(list(offered), index)
            return asked[:12] + b"name".ljust(32, b"\0") + fourcc + bytes(16)
        fourcc = asked[4:8]
        if request == 0xC02C564A:
            assert len(asked) == 44
            size = entry(list(offered[fourcc]), index)
            kind, values = (1, (*size, 0, 0, 0, 0)) if len(size) == 2 else (3, size)
            return asked[:8] + struct.pack("=7I", kind, *values) + bytes(8)
        assert (request, len(asked)) == (0xC034564B, 52)
        sizes = offered[fourcc]
        found = sizes.get(struct.unpack_from("=2I", asked, 8)) or next(
            iter(sizes.values())
        )
        step = entry(found, index)
        kind, values = (1, (*step, 0, 0, 0, 0)) if len(step) == 2 else (2, step)
        return asked[:16] + struct.pack("=7I", kind, *values) + bytes(8)

    return ask


def entry(listed, index):
    if index >= len(listed):
        raise OSError(errno.EINVAL, "Invalid argument")
    return listed[index]


def test_a_webcam_tells_each_size_with_its_rates(monkeypatch):
    monkeypatch.setattr(fcntl, "ioctl", answers(WEBCAM))
    found = [(f"{a}x{b}", rate, name) for a, b, rate, name in camera_modes("/dev/null")]
    assert found == [
        ("1280x720", Fraction(30000, 1001), "mjpeg"),
        ("1280x720", 10, "mjpeg"),  # rather than raw
        ("640x480", 30, "mjpeg"),
        ("640x480", 15, "yuyv422"),
    ]
    assert camera_modes("/dev/null")[0].options == (
        ",input_format=mjpeg,video_size=1280x720,framerate=30000/1001"
    )


def test_ranges_give_the_usual_sizes_and_rates(monkeypatch):
    ranges = {b"NV12": {(320, 1280, 16, 240, 1024, 16): [(1, 50, 1, 5, 0, 0)]}}
    monkeypatch.setattr(fcntl, "ioctl", answers(ranges))
    found = [(*HD, 30), (*HD, 15), (*VGA, 30), (*VGA, 15)]
    assert [one[:3] for one in camera_modes("/dev/null")] == found


@pytest.mark.parametrize("ends", [(0, 30), (1, 0)])
def test_an_interval_of_nothing_is_left_out(monkeypatch, ends):
    monkeypatch.setattr(fcntl, "ioctl", answers({b"MJPG": {VGA: [ends]}}))
    assert camera_modes("/dev/null") == ()


def test_another_file_and_a_camera_that_is_gone_offer_nothing(monkeypatch, tmp_path):
    assert camera_modes("/dev/null") == ()
    assert camera_modes(str(tmp_path / "video9")) == ()

    def gone(*_asked):
        raise OSError(errno.ENODEV, "No such device")

    monkeypatch.setattr(fcntl, "ioctl", gone)
    assert camera_modes("/dev/null") == ()
