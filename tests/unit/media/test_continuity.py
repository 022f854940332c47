"""Dropped frames are distinguished from frames that were never meant to be there."""

from fractions import Fraction

import av
import numpy as np
import pytest

from hapticplayer.media.video import VideoDecoder

RATE_HZ = 25
EVEN = list(range(40))
UNEVEN = [n for n in EVEN if n % 7 not in (2, 3) and n % 5 != 4]


def clip(path, numbers, gop=250, codec="libx264", is_noisy=False):
    """Write pictures that stay until the next; x264 puts B frames between them."""
    rng = np.random.default_rng(3)
    with av.open(str(path), "w") as file:
        stream = file.add_stream(codec, rate=RATE_HZ)
        stream.width, stream.height, stream.pix_fmt = 64, 48, "yuv420p"
        stream.codec_context.gop_size = gop
        stream.time_base = stream.codec_context.time_base = Fraction(1, 1000)
        for number in numbers:
            level = rng.integers(0, 256, (48, 64, 3)) if is_noisy else number % 50 * 5
            content = np.full((48, 64, 3), level, np.uint8)
            picture = av.VideoFrame.from_ndarray(content, format="rgb24")
            picture.time_base = Fraction(1, 1000)
            picture.pts = number * 1000 // RATE_HZ
            file.mux(stream.encode(picture))
        file.mux(stream.encode(None))
    return path


def damage_of(path):
    with VideoDecoder(path) as decoder:
        count = sum(1 for _ in decoder.frames())
        return count, decoder.damaged


@pytest.mark.parametrize("container", ["mp4", "mov", "mkv"])
@pytest.mark.parametrize("numbers", [EVEN, UNEVEN], ids=["even", "uneven"])
def test_a_whole_clip_has_no_holes(tmp_path, container, numbers):
    path = clip(tmp_path / f"clip.{container}", numbers)
    assert damage_of(path) == (len(numbers), 0)


def test_after_seeks_a_whole_clip_has_no_holes_either(tmp_path):
    with VideoDecoder(clip(tmp_path / "clip.mp4", EVEN)) as decoder:
        for media_s in (1.2, 0.1, 1.5, 0.7):
            decoder.seek(media_s)
            list(decoder.frames())
        assert decoder.damaged == 0


@pytest.mark.parametrize("number", [1, 7, 20])
def test_a_packet_that_is_spoilt_in_matroska_leaves_a_hole(tmp_path, number):
    path = clip(tmp_path / "clip.mkv", EVEN, codec="libvpx", is_noisy=True)
    with av.open(str(path)) as file:
        packets = [p for p in file.demux(video=0) if p.size]
        begin, end = packets[number - 1], packets[number]
        spoilt = slice(begin.pos + begin.size, end.pos)
    content = bytearray(path.read_bytes())
    content[spoilt] = bytes(len(content[spoilt]))
    path.write_bytes(content)
    count, damaged = damage_of(path)
    assert count < len(EVEN)
    assert damaged >= 1


SLOWER = [*range(30), *range(30, 120, 3)]
FASTER = [*range(0, 90, 3), *range(90, 120)]
DROPPING = [n for n in range(120) if n not in (40, 55, 56, 57, 101)]
STILL_AT_THE_END = [*range(33), 50]


@pytest.mark.parametrize("container", ["mp4", "mov", "mkv"])
@pytest.mark.parametrize("numbers", [SLOWER, FASTER, DROPPING, STILL_AT_THE_END])
def test_a_changing_frame_rate_is_no_damage(tmp_path, container, numbers):
    path = clip(tmp_path / f"clip.{container}", numbers, gop=15)
    assert damage_of(path) == (len(numbers), 0)


def test_a_phone_in_low_light_makes_no_damaged_clip(case):
    path = case("vfr-called-damaged/lowlight_30_to_20.mp4")
    assert damage_of(path) == (240, 0)
